//! Groups of spheres: where they lie, how large they are, how they move at t = 0.

use std::ops::Range;

use nalgebra::Vector3;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::columns::Columns;
use super::document::Document;
use super::file::{self, Lock, OneOrMany};
use super::resources::Resources;
use super::sizes::Sizes;
use crate::Vec3;
use crate::materials::Material;
use crate::particles::{Kinematics, Locks, Particles};
use crate::random::symmetric;

/// Most spheres of a scene: a bound that catches a mistyped count before it eats the memory.
pub(super) const MOST_SPHERES: usize = 10_000_000;

/// One sphere before its material is known.
struct Placed {
    position: Vec3,
    radius: Option<f64>,
    velocity: Vec3,
    spin: Vec3,
}

impl Placed {
    fn at(position: Vec3) -> Self {
        Self {
            position,
            radius: None,
            velocity: Vec3::zeros(),
            spin: Vec3::zeros(),
        }
    }
}

/// Adds the spheres of one group; returns their indices.
pub(super) fn add(
    document: &mut Document<'_>,
    resources: &mut Resources<'_>,
    path: &str,
    group: &file::Spheres,
    material: (u16, &Material),
    (particles, initial): (&mut Particles, &mut Kinematics),
) -> Option<Range<usize>> {
    let mut random = ChaCha8Rng::seed_from_u64(group.seed);
    let placed = place(document, resources, path, group, &mut random);
    let locks = locks(group.lock.as_ref());
    let jitter = format!("{path}.radius_jitter");
    let jitter_in_range = (0.0..1.0).contains(&group.radius_jitter);
    document.demand(
        jitter_in_range,
        jitter,
        group.radius_jitter,
        "0 <= radius_jitter < 1 [-]",
    );
    let placed = placed?;
    let radii = Radii::new(document, path, group, &placed)?;
    if particles.len() + placed.len() > MOST_SPHERES {
        let found = particles.len() + placed.len();
        document.error(
            path,
            format!("found {found} spheres, expected at most {MOST_SPHERES}"),
            "",
        );
        return None;
    }
    if !jitter_in_range {
        return None;
    }
    let first = particles.len();
    for (k, sphere) in placed.iter().enumerate() {
        let radius =
            radii.of(k, &mut random) * (1.0 + group.radius_jitter * symmetric(&mut random));
        particles.push(radius, material.1.density, material.0, locks);
        let velocity = group.velocity.map_or(sphere.velocity, Vec3::from);
        let spin = group.spin.map_or(sphere.spin, Vec3::from);
        initial.push(sphere.position, velocity, spin);
        let i = particles.len() - 1;
        if !(particles.mass[i].is_normal() && particles.inertia(i).is_normal()) {
            let message = format!(
                "radius {radius} m and density {} kg/m^3 give no usable mass",
                material.1.density
            );
            document.error(path, message, "lengths are in metres, densities in kg/m^3");
            return None;
        }
    }
    Some(first..particles.len())
}

fn place(
    document: &mut Document<'_>,
    resources: &mut Resources<'_>,
    path: &str,
    group: &file::Spheres,
    random: &mut ChaCha8Rng,
) -> Option<Vec<Placed>> {
    match (&group.lattice, &group.positions, &group.csv) {
        (Some(lattice), None, None) => fill(document, &format!("{path}.lattice"), lattice, random),
        (None, Some(positions), None) => {
            let placed: Vec<Placed> = positions.iter().map(|&p| Placed::at(p.into())).collect();
            let filled = !placed.is_empty();
            document
                .demand(
                    filled,
                    format!("{path}.positions"),
                    "an empty list",
                    "at least one [x, y, z]",
                )
                .then_some(placed)
        }
        (None, None, Some(csv)) => {
            let path = format!("{path}.csv");
            let content = resources.read(document, &path, csv)?.to_owned();
            read_csv(document, &path, csv, &content)
        }
        (lattice, positions, csv) => {
            let n = usize::from(lattice.is_some())
                + usize::from(positions.is_some())
                + usize::from(csv.is_some());
            let help = "give the group exactly one of lattice = { ... }, positions = [[x, y, z], ...], csv = \"file\"";
            document.error(
                path,
                format!("found {n} of lattice, positions, csv, expected one"),
                help,
            );
            None
        }
    }
}

fn fill(
    document: &mut Document<'_>,
    path: &str,
    lattice: &file::Lattice,
    random: &mut ChaCha8Rng,
) -> Option<Vec<Placed>> {
    let counts = lattice.count.0;
    let number = counts
        .iter()
        .try_fold(1_usize, |n, &c| n.checked_mul(c as usize));
    let number = number.filter(|n| (1..=MOST_SPHERES).contains(n));
    let expected = format!("each >= 1 and at most {MOST_SPHERES} spheres");
    document.demand(
        number.is_some(),
        format!("{path}.count"),
        format!("{counts:?}"),
        &expected,
    );
    let jitter_in_range = (0.0..=0.5).contains(&lattice.jitter);
    document.demand(
        jitter_in_range,
        format!("{path}.jitter"),
        lattice.jitter,
        "0 <= jitter <= 0.5 [-]",
    );
    let spacing = match &lattice.spacing {
        OneOrMany::One(s) => Some(Vec3::repeat(*s)),
        OneOrMany::Many(s) => <[f64; 3]>::try_from(s.as_slice()).ok().map(Vec3::from),
    };
    let spacing = spacing.filter(|s| s.iter().all(|&s| s > 0.0));
    let found = match &lattice.spacing {
        OneOrMany::One(s) => s.to_string(),
        OneOrMany::Many(s) => format!("{s:?}"),
    };
    document.demand(
        spacing.is_some(),
        format!("{path}.spacing"),
        found,
        "one or three lengths > 0 [m]",
    );
    let axes = axes(document, &format!("{path}.axes"), lattice.axes.as_deref());
    let (number, spacing, axes) = (number?, spacing?, axes?);
    if !jitter_in_range {
        return None;
    }
    let mut placed = Vec::with_capacity(number);
    for k in 0..counts[2] {
        for j in 0..counts[1] {
            for i in 0..counts[0] {
                let node = Vector3::new(i, j, k).map(f64::from);
                let shift = Vec3::from_fn(|_, _| symmetric(random)) * lattice.jitter;
                let local = (node + shift).component_mul(&spacing);
                let position = Vec3::from(lattice.origin)
                    + axes[0] * local.x
                    + axes[1] * local.y
                    + axes[2] * local.z;
                placed.push(Placed::at(position));
            }
        }
    }
    Some(placed)
}

/// Gram-Schmidt on the two given directions, the third by their cross product.
fn axes(
    document: &mut Document<'_>,
    path: &str,
    given: Option<&[file::Vector]>,
) -> Option<[Vec3; 3]> {
    let Some(given) = given else {
        return Some([Vec3::x(), Vec3::y(), Vec3::z()]);
    };
    let expected = "two directions that are not parallel, as [[1, 0, 0], [0, 1, 0]]";
    let pair = match *given {
        [x, y] => {
            let x = Vec3::from(x).try_normalize(0.0);
            let y = Vec3::from(y).try_normalize(0.0);
            x.zip(y)
                .and_then(|(x, y)| Some((x, (y - x * x.dot(&y)).try_normalize(1e-9)?)))
        }
        _ => None,
    };
    document.demand(
        pair.is_some(),
        path,
        format!("{} directions", given.len()),
        expected,
    );
    pair.map(|(x, y)| [x, y, x.cross(&y)])
}

/// Radii of a group whose places are known.
enum Radii {
    /// One each \[m\].
    Listed(Vec<f64>),
    /// Drawn in the order of the spheres.
    Drawn(Sizes),
}

impl Radii {
    fn new(
        document: &mut Document<'_>,
        path: &str,
        group: &file::Spheres,
        placed: &[Placed],
    ) -> Option<Self> {
        let key = format!("{path}.radius");
        let from_file: Option<Vec<f64>> = placed.iter().map(|p| p.radius).collect();
        match (&group.radius, from_file) {
            (None, Some(list)) if group.size.is_none() => Some(Self::Listed(list)),
            (given, Some(_)) => {
                let key = given.as_ref().map_or(format!("{path}.size"), |_| key);
                let message = "found both this key and radii in the file, expected one of them";
                document.error(key, message, "remove one of the two");
                None
            }
            (Some(OneOrMany::Many(_)), None) if group.size.is_some() => {
                // The radius stands for the whole list: only that both are there matters.
                Sizes::new(document, path, Some(1.0), group.size.as_ref()).map(Self::Drawn)
            }
            (Some(OneOrMany::Many(list)), None) => {
                let expected = format!("one radius, or {} of them", placed.len());
                let found = format!("{} radii", list.len());
                let mut good =
                    document.demand(list.len() == placed.len(), key.as_str(), found, &expected);
                for (k, r) in list.iter().enumerate() {
                    good &= document.demand(*r > 0.0, format!("{key}[{k}]"), r, "a radius > 0 [m]");
                }
                good.then(|| Self::Listed(list.clone()))
            }
            (Some(OneOrMany::One(radius)), None) => {
                Sizes::new(document, path, Some(*radius), group.size.as_ref()).map(Self::Drawn)
            }
            (None, None) => Sizes::new(document, path, None, group.size.as_ref()).map(Self::Drawn),
        }
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

const COLUMNS: [&str; 10] = ["x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz"];

fn read_csv(
    document: &mut Document<'_>,
    path: &str,
    name: &str,
    content: &[u8],
) -> Option<Vec<Placed>> {
    let rows = Columns::read(document, path, name, content, &COLUMNS, 3)?;
    let placed = rows.rows.iter().map(|row| {
        let value = |k: usize| row[k].unwrap_or(0.0);
        let vector = |k: usize| Vec3::new(value(k), value(k + 1), value(k + 2));
        Placed {
            position: vector(0),
            radius: row[3],
            velocity: vector(4),
            spin: vector(7),
        }
    });
    let placed: Vec<Placed> = placed.collect();
    let mut good = true;
    for (sphere, line) in placed.iter().zip(&rows.lines) {
        if let Some(radius) = sphere.radius.filter(|r| *r <= 0.0) {
            good = document.demand(
                false,
                path,
                format!("{radius} in `{name}` line {line}, column `radius`"),
                "a radius > 0 [m]",
            );
        }
    }
    good.then_some(placed)
}
