//! Spheres from files: tables, frames of results, checkpoints.

use nalgebra::{Quaternion, UnitQuaternion};

use super::initial_motion::InitialMotion;
use crate::Vec3;
use crate::formats::vtu::{Cloud, VtuError};
use crate::formats::{snapshot, vtu};
use crate::scene_file::columns::Columns;
use crate::scene_file::document::{Document, LARGEST};

const COLUMNS: [&str; 10] = ["x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz"];

/// The rows of a table, with their radii if it has such a column.
pub(super) fn csv(
    document: &mut Document<'_>,
    path: &str,
    name: &str,
    content: &[u8],
) -> Option<(Vec<InitialMotion>, Option<Vec<f64>>)> {
    let table = Columns::read(document, path, name, content, &COLUMNS, 3)?;
    let starts = table.rows.iter().map(|row| {
        let value = |k: usize| row[k].unwrap_or(0.0);
        let vector = |k: usize| Vec3::new(value(k), value(k + 1), value(k + 2));
        InitialMotion {
            velocity: vector(4),
            spin: vector(7),
            ..InitialMotion::at(vector(0))
        }
    });
    let radii: Option<Vec<f64>> = table.rows.iter().map(|row| row[3]).collect();
    let mut good = true;
    for (radius, line) in radii.iter().flatten().zip(&table.lines) {
        if *radius <= 0.0 {
            let found = format!("{radius} in `{name}` line {line}, column `radius`");
            good = document.demand(false, path, found, "a radius > 0 [m]");
        }
    }
    good.then(|| (starts.collect(), radii))
}

/// Orientations may be off unit length by this much: they are stored in single precision \[-\].
const OFF_UNIT: f64 = 1e-3;

/// The spheres of a frame of results.
pub(super) fn vtu(
    document: &mut Document<'_>,
    path: &str,
    name: &str,
    content: &[u8],
) -> Option<(Vec<InitialMotion>, Option<Vec<f64>>)> {
    match vtu::decode(content).and_then(|cloud| frame(&cloud)) {
        Ok(spheres) => accept(document, path, name, spheres),
        Err(error) => {
            let help = "give a file `spheres_NNNNNN.vtu` that `sphere-dda run` wrote";
            document.reject(path, format!("cannot read `{name}`: {error}"), help)
        }
    }
}

fn frame(cloud: &Cloud) -> Result<(Vec<InitialMotion>, Vec<f64>), VtuError> {
    let (radius, velocity) = (cloud.array::<1>("radius")?, cloud.array::<3>("velocity")?);
    let spin = cloud.array::<3>("angular_velocity")?;
    let orientation = cloud.array::<4>("orientation")?;
    // A frame without spheres holds a point of radius 0 and id -1.
    let id = cloud.array::<1>("id")?;
    let present = (0..cloud.points.len()).filter(|&k| id[k][0] >= 0.0);
    let spheres = present.map(|k| {
        let [w, i, j, l] = orientation[k];
        let start = InitialMotion {
            position: cloud.points[k],
            orientation: UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, l)),
            velocity: velocity[k].into(),
            spin: spin[k].into(),
        };
        (start, radius[k][0])
    });
    Ok(spheres.unzip())
}

/// The spheres in the scene of a checkpoint.
pub(super) fn checkpoint(
    document: &mut Document<'_>,
    path: &str,
    name: &str,
    content: &[u8],
) -> Option<(Vec<InitialMotion>, Option<Vec<f64>>)> {
    let (radius, spheres) = match snapshot::spheres(content) {
        Ok(spheres) => spheres,
        Err(error) => {
            let help = "give a checkpoint that `sphere-dda run` wrote";
            return document.reject(path, format!("cannot read `{name}`: {error}"), help);
        }
    };
    let present = (0..spheres.len().min(radius.len())).filter(|&i| spheres.present[i]);
    let started = present.map(|i| {
        let start = InitialMotion {
            position: spheres.position[i],
            orientation: spheres.orientation[i],
            velocity: spheres.velocity[i],
            spin: spheres.spin[i],
        };
        (start, radius[i])
    });
    accept(document, path, name, started.unzip())
}

/// Refuses numbers that no run has written.
fn accept(
    document: &mut Document<'_>,
    path: &str,
    name: &str,
    (starts, radii): (Vec<InitialMotion>, Vec<f64>),
) -> Option<(Vec<InitialMotion>, Option<Vec<f64>>)> {
    let usable = |(start, radius): (&InitialMotion, &f64)| {
        let numbers = start.position.iter().chain(&start.velocity);
        let in_range = numbers.chain(&start.spin).all(|x| x.abs() <= LARGEST);
        let turned = (start.orientation.norm() - 1.0).abs() <= OFF_UNIT;
        in_range && turned && *radius > 0.0 && *radius <= LARGEST
    };
    if let Some(k) = starts.iter().zip(&radii).position(|pair| !usable(pair)) {
        let found = format!("sphere {k} of radius {} in `{name}`", radii[k]);
        let expected = "finite numbers, a radius > 0 [m] and a unit quaternion";
        return document.refuse(path, found, expected);
    }
    let starts = starts.into_iter().map(|start| InitialMotion {
        orientation: UnitQuaternion::from_quaternion(start.orientation.into_inner()),
        ..start
    });
    let starts: Vec<InitialMotion> = starts.collect();
    let some = !starts.is_empty();
    document
        .demand(some, path, format!("no sphere in `{name}`"), "at least one")
        .then_some((starts, Some(radii)))
}
