//! Gravity as a function of time, and the frame of reference, checked.

use super::checks::{direction, increasing};
use super::columns::Columns;
use super::decode::Entry;
use super::document::Document;
use super::file;
use crate::Vec3;
use crate::scene::gravity::GravityMotion;
use crate::scene::rotating_frame::RotatingFrame;
use crate::scene::{Motion, Scene, Settings};

/// Gravity at t = 0 \[m/s^2\], and how it moves.
pub(super) fn gravity(
    document: &mut Document<'_>,
    s: &file::Simulation,
) -> Option<(Vec3, GravityMotion)> {
    let set = s.gravity.map_or(Settings::default().gravity, Vec3::from);
    let path = "simulation.gravity_motion";
    match &s.gravity_motion {
        None => Some((set, GravityMotion::Fixed)),
        Some(file::GravityMotion::Rotation(turning)) => {
            let axis = direction(document, &format!("{path}.rotation.axis"), turning.axis)?;
            let angular_velocity = axis * turning.speed;
            Some((set, GravityMotion::Rotation { angular_velocity }))
        }
        Some(file::GravityMotion::Table(given)) => {
            let path = format!("{path}.table");
            if s.gravity.is_some() {
                let help = "the table gives gravity at all times: remove `gravity`";
                let message = "found both `gravity` and a table of it, expected one of them";
                document.error("simulation.gravity", message, help);
            }
            let (time, gravity) = table(document, &path, given)?;
            let motion = GravityMotion::Table { time, gravity };
            Some((motion.at(set, 0.0), motion))
        }
    }
}

fn table(
    document: &mut Document<'_>,
    path: &str,
    given: &file::GravityTable,
) -> Option<(Vec<f64>, Vec<Vec3>)> {
    let (key, time, gravity) = match (&given.csv, &given.time, &given.gravity) {
        (Some(csv), None, None) => {
            let key = format!("{path}.csv");
            let content = document.read(&key, csv)?.to_owned();
            let names = ["time", "x", "y", "z"];
            let columns = Columns::read(document, &key, csv, &content, &names, 4)?;
            let rows = columns
                .rows
                .iter()
                .map(|row| row.map(|cell| cell.unwrap_or(0.0)));
            let (time, gravity) = rows.map(|[t, x, y, z]| (t, Vec3::new(x, y, z))).unzip();
            (key, time, gravity)
        }
        (None, Some(time), Some(gravity)) => {
            let key = format!("{path}.gravity");
            let expected = format!("{} of them, one for each time", time.len());
            let found = format!("{} vectors", gravity.len());
            document
                .demand(gravity.len() == time.len(), key, found, &expected)
                .then_some(())?;
            let gravity = gravity.iter().map(|&v| v.into()).collect();
            (format!("{path}.time"), time.clone(), gravity)
        }
        _ => {
            let message =
                "found an incomplete or doubled table, expected `csv`, or `time` and `gravity`";
            let help = "give `csv = \"file\"` alone, or `time` with as many vectors `gravity`";
            return document.reject(path, message, help);
        }
    };
    increasing(document, &key, &time).then_some((time, gravity))
}

/// The turning frame.
pub(super) fn rotating_frame(
    document: &mut Document<'_>,
    given: file::RotatingFrame,
) -> Option<RotatingFrame> {
    let axis = direction(document, "simulation.rotating_frame.axis", given.axis)?;
    Some(RotatingFrame {
        angular_velocity: axis * given.speed,
        point: given.point.into(),
    })
}

/// Refuses driven bodies in a turning frame: the inertial forces on them are not there.
pub(super) fn judge(
    document: &mut Document<'_>,
    scene: &Scene,
    elements: &[Entry<file::Boundary>],
) {
    for (boundary, element) in scene.boundaries.iter().zip(elements) {
        if scene.settings.rotating_frame.is_some() && matches!(boundary.motion, Motion::Driven(_)) {
            let message = format!(
                "boundary `{}` is moved by force in a rotating frame, whose inertial forces act on grains only",
                boundary.name
            );
            let help = "give the scene as seen from the world, or prescribe the motion";
            document.error(&element.path, message, help);
        }
    }
}
