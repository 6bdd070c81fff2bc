//! Groups of spheres: where they lie, how large they are, how they move at t = 0.

mod clumps;
mod files;
mod generator;
mod initial_motion;
mod lattice;
mod packing;
mod radii;

use std::ops::Range;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::checks::sphere_has_mass;
use super::document::Document;
use super::file::{self, Lock, OneOrMany};
use crate::Vec3;
use crate::random::symmetric;
use crate::scene::clump::ClumpShape;
use crate::scene::materials::Material;
use crate::scene::particles::Locks;
use generator::Generator;
use initial_motion::InitialMotion;
pub(crate) use initial_motion::{MOST_SPHERES, Present};
use radii::Radii;

/// Adds the spheres of one group; returns their indices.
pub(super) fn add(
    document: &mut Document<'_>,
    (path, group): (&str, &file::Spheres),
    material: (u16, &Material),
    clump: Option<ClumpShape>,
    present: Present<'_>,
) -> Option<Range<usize>> {
    let mut random = ChaCha8Rng::seed_from_u64(group.seed);
    if let Some(shape) = clump {
        let generator = Generator::of(document, path, group)?;
        let made = (&shape, material.0, &generator);
        return clumps::add(document, (path, group), made, (present, &mut random));
    }
    if group.rotations.is_some() {
        let message = "found `rotations` of single spheres, expected them of clumps only";
        document.error((path, "rotations"), message, "remove it, or give `clump`");
    }
    let jitter = radii::jitter(document, path, group);
    let jittered = |radius: f64, random: &mut ChaCha8Rng| {
        radius * (1.0 + group.radius_jitter * symmetric(random))
    };
    let (starts, radii) = match Generator::of(document, path, group)? {
        Generator::Packing(given) => {
            let path_of = format!("{path}.packing");
            let sizes = Radii::drawn(document, path, group);
            let task = packing::Task::new(document, &path_of, given);
            let (sizes, task, _) = (sizes?, task?, jitter?);
            let draw = |random: &mut ChaCha8Rng| jittered(sizes.draw(random), random);
            let radii = task.radii(document, draw, material.1.density, &mut random)?;
            let places = task.places(document, &radii, &present, &mut random)?;
            (places.into_iter().map(InitialMotion::at).collect(), radii)
        }
        given => {
            let (starts, radii) = given.read(document, path, &mut random)?;
            let radii = Radii::new(document, path, group, starts.len(), radii)?;
            jitter?;
            let radii = (0..starts.len()).map(|k| jittered(radii.of(k, &mut random), &mut random));
            let radii: Vec<f64> = radii.collect();
            (starts, radii)
        }
    };
    let Present {
        particles, initial, ..
    } = present;
    let first = particles.len();
    if first + starts.len() > MOST_SPHERES {
        let found = first + starts.len();
        let message = format!("found {found} spheres, expected at most {MOST_SPHERES}");
        return document.reject(path, message, "");
    }
    let locks = locks(group.lock.as_ref());
    for (i, (start, radius)) in (first..).zip(starts.iter().zip(radii)) {
        particles.push(radius, material.1.density, material.0, locks);
        let velocity = group.velocity.map_or(start.velocity, Vec3::from);
        let spin = group.spin.map_or(start.spin, Vec3::from);
        initial.push(start.position, velocity, spin);
        initial.orientation[i] = start.orientation;
        sphere_has_mass(document, path, particles, material.1).then_some(())?;
    }
    Some(first..particles.len())
}

fn locks(held: Option<&OneOrMany<Lock>>) -> Locks {
    let held = match held {
        None => &[][..],
        Some(OneOrMany::One(lock)) => std::slice::from_ref(lock),
        Some(OneOrMany::Many(locks)) => locks,
    };
    let mut locks = Locks::default();
    for lock in held {
        match lock {
            Lock::X => locks.translation[0] = true,
            Lock::Y => locks.translation[1] = true,
            Lock::Z => locks.translation[2] = true,
            Lock::Rx => locks.rotation[0] = true,
            Lock::Ry => locks.rotation[1] = true,
            Lock::Rz => locks.rotation[2] = true,
            Lock::Translations => locks.translation = [true; 3],
            Lock::Rotations => locks.rotation = [true; 3],
        }
    }
    locks
}
