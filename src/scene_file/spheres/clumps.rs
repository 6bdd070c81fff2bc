//! Groups of clumps: each place is a centre of mass.

use nalgebra::{Quaternion, UnitQuaternion};
use rand_chacha::ChaCha8Rng;

use super::{Generator, InitialMotion, MOST_SPHERES, Present, packing};
use crate::Vec3;
use crate::random::symmetric;
use crate::scene::clump::{Clump, ClumpShape};
use crate::scene_file::document::Document;
use crate::scene_file::file;
use crate::spatial::SpatialVector;

/// Adds the clumps of a group.
pub(super) fn add(
    document: &mut Document<'_>,
    (path, group): (&str, &file::Spheres),
    shape: &ClumpShape,
    material: u16,
    generator: &Generator<'_>,
    (present, random): (Present<'_>, &mut ChaCha8Rng),
) -> Option<()> {
    let mut good = true;
    for (key, given) in [
        ("radius", group.radius.is_some()),
        ("size", group.size.is_some()),
        ("radius_jitter", group.radius_jitter != 0.0),
        ("lock", group.lock.is_some()),
        ("vtu", group.vtu.is_some()),
        ("checkpoint", group.checkpoint.is_some()),
    ] {
        if given {
            let message = format!("found `{key}` in a group of clumps, which has none");
            let help =
                "the clump gives its members; place it by lattice, packing, positions or csv";
            document.error(format!("{path}.{key}"), message, help);
            good = false;
        }
    }
    let starts = match generator {
        Generator::Packing(given) => {
            if given.solid_fraction.is_some() {
                let message =
                    "found `solid_fraction` in a packing of clumps, expected count or mass";
                let key = format!("{path}.packing.solid_fraction");
                return document.reject(
                    key,
                    message,
                    "a packing keeps the balls around clumps apart",
                );
            }
            let task = packing::Task::new(document, &format!("{path}.packing"), given)?;
            let reach = shape.reach();
            let ball = 4.0 / 3.0 * std::f64::consts::PI * reach.powi(3);
            let radii = task.radii(document, |_| reach, shape.mass / ball, random)?;
            let places = task.places(document, &radii, &present, random)?;
            places.into_iter().map(InitialMotion::at).collect()
        }
        given => given.read(document, path, random)?.0,
    };
    let Present {
        particles,
        initial,
        clumps,
        ..
    } = present;
    let found = particles.len() + starts.len() * shape.arms.len();
    let expected = format!("at most {MOST_SPHERES}");
    good &= document.demand(
        found <= MOST_SPHERES,
        path,
        format!("{found} spheres"),
        &expected,
    );
    let rotations = group.rotations.as_deref();
    if let Some(list) = rotations {
        let expected = format!("one rotation vector for all, or {} of them", starts.len());
        let fits = [1, starts.len()].contains(&list.len());
        good &= document.demand(fits, (path, "rotations"), list.len(), &expected);
    }
    good.then_some(())?;
    for (k, start) in starts.iter().enumerate() {
        let rotation = match rotations {
            Some(list) => UnitQuaternion::from_scaled_axis(Vec3::from(list[k % list.len()])),
            None => any(random),
        };
        let velocity = SpatialVector {
            linear: group.velocity.map_or(start.velocity, Vec3::from),
            angular: group.spin.map_or(start.spin, Vec3::from),
        };
        let store = (&mut *particles, &mut *initial, &mut *clumps);
        Clump::push(
            shape,
            material,
            (start.position, rotation),
            &velocity,
            store,
        );
    }
    Some(())
}

/// A rotation, all being alike.
fn any(random: &mut ChaCha8Rng) -> UnitQuaternion<f64> {
    loop {
        let [w, i, j, k] = std::array::from_fn(|_| symmetric(random));
        let q = Quaternion::new(w, i, j, k);
        let square = q.norm_squared();
        if square > 1e-4 && square <= 1.0 {
            return UnitQuaternion::new_normalize(q);
        }
    }
}
