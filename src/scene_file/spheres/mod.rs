//! Groups of spheres: where they lie, how large they are, how they move at t = 0.

mod clumps;
mod files;
mod initial_motion;
mod lattice;
mod packing;

use std::ops::Range;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::document::Document;
use super::file::{self, Lock, OneOrMany};
use super::sizes::Sizes;
use crate::Vec3;
use crate::random::symmetric;
use crate::scene::clump::ClumpShape;
use crate::scene::materials::Material;
use crate::scene::particles::Locks;
use initial_motion::InitialMotion;
pub(crate) use initial_motion::{MOST_SPHERES, Present};

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
        let generator = origin(document, path, group)?;
        let first = present.particles.len();
        let Present {
            particles,
            initial,
            clumps,
            boundaries,
        } = present;
        let store = Present {
            particles: &mut *particles,
            initial,
            clumps,
            boundaries,
        };
        let given = (path, group);
        clumps::add(
            document,
            given,
            &shape,
            material.0,
            &generator,
            (store, &mut random),
        )?;
        return Some(first..particles.len());
    }
    if group.rotations.is_some() {
        let message = "found `rotations` of single spheres, expected them of clumps only";
        document.error((path, "rotations"), message, "remove it, or give `clump`");
    }
    let jitter = document.within(
        (path, "radius_jitter"),
        group.radius_jitter,
        0.0..1.0,
        "0 <= radius_jitter < 1 [-]",
    );
    let jitter = jitter.then_some(group.radius_jitter);
    let jittered = |radius: f64, random: &mut ChaCha8Rng| {
        radius * (1.0 + group.radius_jitter * symmetric(random))
    };
    let (starts, radii) = match origin(document, path, group)? {
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
        if !(particles.mass[i].is_normal() && particles.inertia(i).is_normal()) {
            let message = format!(
                "radius {radius} m and density {} kg/m^3 give no usable mass",
                material.1.density
            );
            return document.reject(path, message, "lengths are in metres, densities in kg/m^3");
        }
    }
    Some(first..particles.len())
}

/// What places the spheres of a group.
enum Generator<'a> {
    Lattice(&'a file::Lattice),
    Packing(&'a file::Packing),
    Positions(&'a [file::Vector]),
    Csv(&'a str),
    Vtu(&'a str),
    Checkpoint(&'a str),
}

/// The one key that places a group.
fn origin<'a>(
    document: &mut Document<'_>,
    path: &str,
    group: &'a file::Spheres,
) -> Option<Generator<'a>> {
    let given: Vec<Generator<'a>> = [
        group.lattice.as_ref().map(Generator::Lattice),
        group.packing.as_ref().map(Generator::Packing),
        group.positions.as_deref().map(Generator::Positions),
        group.csv.as_deref().map(Generator::Csv),
        group.vtu.as_deref().map(Generator::Vtu),
        group.checkpoint.as_deref().map(Generator::Checkpoint),
    ]
    .into_iter()
    .flatten()
    .collect();
    let number = given.len();
    let only = given.into_iter().next().filter(|_| number == 1);
    if only.is_none() {
        let message = format!(
            "found {number} of lattice, packing, positions, csv, vtu, checkpoint, expected one"
        );
        let help = "give the group exactly one of lattice = { ... }, packing = { ... }, \
                    positions = [[x, y, z], ...], csv = \"file\", vtu = \"file\", checkpoint = \"file\"";
        document.error(path, message, help);
    }
    only
}

impl Generator<'_> {
    /// The places, and the radii where a file has them.
    fn read(
        &self,
        document: &mut Document<'_>,
        path: &str,
        random: &mut ChaCha8Rng,
    ) -> Option<(Vec<InitialMotion>, Option<Vec<f64>>)> {
        let content = |document: &mut Document<'_>, key: &str, name: &str| {
            let content = document.read(&format!("{path}.{key}"), name);
            content.map(<[u8]>::to_owned)
        };
        match *self {
            Self::Lattice(lattice) => {
                let starts = lattice::fill(document, &format!("{path}.lattice"), lattice, random);
                Some((starts?, None))
            }
            Self::Positions(list) => {
                let starts = list.iter().map(|&p| InitialMotion::at(p.into())).collect();
                let key = format!("{path}.positions");
                let some = !list.is_empty();
                document
                    .demand(some, key, "an empty list", "at least one [x, y, z]")
                    .then_some((starts, None))
            }
            Self::Csv(name) => {
                let bytes = content(document, "csv", name)?;
                files::csv(document, &format!("{path}.csv"), name, &bytes)
            }
            Self::Vtu(name) => {
                let bytes = content(document, "vtu", name)?;
                files::vtu(document, &format!("{path}.vtu"), name, &bytes)
            }
            Self::Checkpoint(name) => {
                let bytes = content(document, "checkpoint", name)?;
                files::checkpoint(document, &format!("{path}.checkpoint"), name, &bytes)
            }
            // A packing is made of its radii, not read.
            Self::Packing(_) => None,
        }
    }
}

/// Radii of a group whose places are known.
enum Radii {
    /// One each \[m\].
    Listed(Vec<f64>),
    /// Drawn in the order of the spheres.
    Drawn(Sizes),
}

impl Radii {
    /// For `number` spheres, whose radii \[m\] may come from a file.
    fn new(
        document: &mut Document<'_>,
        path: &str,
        group: &file::Spheres,
        number: usize,
        from_file: Option<Vec<f64>>,
    ) -> Option<Self> {
        let key = format!("{path}.radius");
        match (&group.radius, from_file) {
            (None, Some(list)) if group.size.is_none() => Some(Self::Listed(list)),
            (given, Some(_)) => {
                let key = given.as_ref().map_or(format!("{path}.size"), |_| key);
                let message = "found both this key and radii in the file, expected one of them";
                document.reject(key, message, "remove one of the two")
            }
            (Some(OneOrMany::Many(list)), None) if group.size.is_none() => {
                let expected = format!("one radius, or {number} of them");
                let found = format!("{} radii", list.len());
                let mut good =
                    document.demand(list.len() == number, key.as_str(), found, &expected);
                for (k, r) in list.iter().enumerate() {
                    good &= document.positive(format!("{key}[{k}]"), *r, "a radius > 0 [m]");
                }
                good.then(|| Self::Listed(list.clone()))
            }
            _ => Self::drawn(document, path, group).map(Self::Drawn),
        }
    }

    /// One radius for all, or a distribution.
    fn drawn(document: &mut Document<'_>, path: &str, group: &file::Spheres) -> Option<Sizes> {
        let one = match &group.radius {
            Some(OneOrMany::Many(list)) if group.size.is_none() => {
                let found = format!("a list of {} radii", list.len());
                let expected = "one radius for all, or `size` instead of it";
                return document.refuse((path, "radius"), found, expected);
            }
            // With `size` given too the number does not matter: one of the two is too many.
            Some(OneOrMany::Many(_)) => Some(1.0),
            Some(OneOrMany::One(radius)) => Some(*radius),
            None => None,
        };
        Sizes::new(document, path, one, group.size.as_ref())
    }

    /// Radius of sphere `k` of the group \[m\].
    fn of(&self, k: usize, random: &mut ChaCha8Rng) -> f64 {
        match self {
            Self::Listed(list) => list[k],
            Self::Drawn(sizes) => sizes.draw(random),
        }
    }
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
