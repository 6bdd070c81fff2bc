//! Groups of clumps: each place is a centre of mass.

use std::ops::Range;

use nalgebra::UnitQuaternion;
use rand_chacha::ChaCha8Rng;

use super::generator::Generator;
use super::initial_motion::{InitialMotion, MOST_SPHERES, Present};
use super::packing;
use super::radii::{self, Radii};
use crate::Vec3;
use crate::random::{rotation, symmetric};
use crate::scene::clump::{Clump, ClumpShape};
use crate::scene_file::checks::clump_has_mass;
use crate::scene_file::document::Document;
use crate::scene_file::file;
use crate::spatial::SpatialVector;

/// Adds the clumps of a group, of a shape and a material, where `generator` places them; returns the indices of their spheres.
pub(super) fn add(
    document: &mut Document<'_>,
    (path, group): (&str, &file::Spheres),
    (shape, material, generator): (&ClumpShape, u16, &Generator<'_>),
    (present, random): (Present<'_>, &mut ChaCha8Rng),
) -> Option<Range<usize>> {
    let sizes = Scales::new(document, (path, group), shape);
    let mut good = true;
    for (key, given) in [
        ("lock", group.lock.is_some()),
        ("vtu", group.vtu.is_some()),
        ("checkpoint", group.checkpoint.is_some()),
    ] {
        if given {
            let message = format!("found `{key}` in a group of clumps, which has none");
            let help = "remove it, and place clumps by lattice, packing, positions or csv";
            document.error(format!("{path}.{key}"), message, help);
            good = false;
        }
    }
    let sizes = sizes?;
    let (starts, factors): (Vec<InitialMotion>, Vec<f64>) = match generator {
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
            let draw = |random: &mut ChaCha8Rng| reach * sizes.factor(0, random);
            let radii = task.radii(document, draw, shape.mass / ball, random)?;
            let places = task.places(document, &radii, &present, random)?;
            let starts = places.into_iter().map(InitialMotion::at).collect();
            (starts, radii.iter().map(|radius| radius / reach).collect())
        }
        given => {
            let (starts, listed) = given.read(document, path, random)?;
            let mut sizes = sizes;
            if listed.is_some() {
                sizes.radii = Some(Radii::new(document, path, group, starts.len(), listed)?);
            }
            let factors = (0..starts.len()).map(|k| sizes.factor(k, random));
            let factors = factors.collect();
            (starts, factors)
        }
    };
    let Present {
        particles,
        initial,
        clumps,
        ..
    } = present;
    let first = particles.len();
    let found = first + starts.len() * shape.arms.len();
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
    for (k, (start, factor)) in starts.iter().zip(factors).enumerate() {
        let rotation = match rotations {
            Some(list) => UnitQuaternion::from_scaled_axis(Vec3::from(list[k % list.len()])),
            None => rotation(random),
        };
        let velocity = SpatialVector {
            linear: group.velocity.map_or(start.velocity, Vec3::from),
            angular: group.spin.map_or(start.spin, Vec3::from),
        };
        let shape = shape.scaled(factor);
        clump_has_mass(document, path, &shape).then_some(())?;
        let store = (&mut *particles, &mut *initial, &mut *clumps);
        Clump::push(
            &shape,
            material,
            (start.position, rotation),
            &velocity,
            store,
        );
    }
    Some(first..particles.len())
}

/// How many times as large as the template clumps are.
struct Scales {
    /// Radii of spheres of the same volume \[m\]; `None`: all are as the template.
    radii: Option<Radii>,
    /// That of the template \[m\].
    own: f64,
    jitter: f64,
}

impl Scales {
    fn new(
        document: &mut Document<'_>,
        (path, group): (&str, &file::Spheres),
        shape: &ClumpShape,
    ) -> Option<Self> {
        let jitter = radii::jitter(document, path, group);
        let radii = match (&group.radius, &group.size) {
            (None, None) => None,
            _ => Some(Radii::Drawn(Radii::drawn(document, path, group)?)),
        };
        Some(Self {
            radii,
            own: shape.equal_radius(),
            jitter: jitter?,
        })
    }

    /// That of clump `k` of the group.
    fn factor(&self, k: usize, random: &mut ChaCha8Rng) -> f64 {
        let radii = self.radii.as_ref();
        let factor = radii.map_or(1.0, |radii| radii.of(k, random) / self.own);
        match self.jitter {
            0.0 => factor,
            jitter => factor * (1.0 + jitter * symmetric(random)),
        }
    }
}
