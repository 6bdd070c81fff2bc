//! Sources and sinks, from the file. A source's spheres are spheres of the scene that wait outside.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::checks::{clump_has_mass, sphere_has_mass};
use super::decode::Entry;
use super::document::Document;
use super::file;
use super::names::Names;
use super::regions::{emptied, filled};
use super::sizes::Sizes;
use super::spheres::MOST_SPHERES;
use crate::scene::clump::{Clump, ClumpShape};
use crate::scene::materials::Material;
use crate::scene::particles::{Kinematics, Locks, Particles};
use crate::scene::{Sink, Source, Supply};
use crate::spatial::Twist;

/// Adds a source and its spheres.
pub(super) fn source(
    document: &mut Document<'_>,
    path: &str,
    given: &file::Source,
    material: (u16, &Material),
    shape: Option<ClumpShape>,
    (particles, initial, clumps): (&mut Particles, &mut Kinematics, &mut Vec<Clump>),
) -> Option<Source> {
    let sizes = match (&shape, given.radius, &given.size) {
        (Some(shape), None, None) => Some(Sizes::One(shape.equal_radius())),
        (_, radius, size) => Sizes::new(document, path, radius, size.as_ref()),
    };
    let region = filled(document, &format!("{path}.region"), &given.region);
    let supply = supply(document, path, given);
    let each = shape.as_ref().map_or(1, |shape| shape.arms.len());
    let most = (MOST_SPHERES - particles.len()) / each;
    let expected = format!("1..={most}");
    let capacity = given.capacity as usize;
    let mut good = document.within((path, "capacity"), capacity, 1..=most, &expected);
    let start = given.start;
    good &= document.within((path, "start"), start, 0.0.., "a time >= 0 [s]");
    if let Some(stop) = given.stop {
        let expected = format!("a time after the start, {start} [s]");
        good &= document.demand(stop > start, (path, "stop"), stop, &expected);
    }
    let (sizes, region, supply) = (sizes?, region?, supply?);
    if !good {
        return None;
    }
    let first = particles.len();
    let mut random = ChaCha8Rng::seed_from_u64(given.seed);
    let (low, high) = region.bounds()?;
    for _ in 0..capacity {
        let radius = sizes.draw(&mut random);
        let scaled = shape
            .as_ref()
            .map(|shape| shape.scaled(radius / shape.equal_radius()));
        let radius = scaled.as_ref().map_or(radius, ClumpShape::reach);
        if region.random_centre(radius, &mut random).is_none() {
            let message = format!("found no room for a sphere of radius {radius} m");
            return document.reject(
                (path, "region"),
                message,
                "make the region wider than the largest sphere, twice its radius and more",
            );
        }
        let middle = (low + high) / 2.0;
        match scaled {
            Some(shape) => {
                clump_has_mass(document, path, &shape).then_some(())?;
                let store = (&mut *particles, &mut *initial, &mut *clumps);
                Clump::push_absent(&shape, material.0, middle, store);
            }
            None => {
                particles.push(radius, material.1.density, material.0, Locks::default());
                sphere_has_mass(document, path, particles, material.1).then_some(())?;
                initial.push_absent(middle);
            }
        }
    }
    Some(Source {
        name: given.name.clone(),
        spheres: first..particles.len(),
        region,
        supply,
        start,
        stop: given.stop.unwrap_or(f64::INFINITY),
        twist: Twist {
            linear: given.velocity.into(),
            angular: given.spin.into(),
        },
        seed: given.seed,
    })
}

fn supply(document: &mut Document<'_>, path: &str, given: &file::Source) -> Option<Supply> {
    match (given.rate, given.mass_rate) {
        (Some(rate), None) => {
            let key = format!("{path}.rate");
            let good = document.positive(key, rate, "a rate > 0 [1/s]");
            good.then_some(Supply::Spheres(rate))
        }
        (None, Some(rate)) => {
            let key = format!("{path}.mass_rate");
            let good = document.positive(key, rate, "a rate > 0 [kg/s]");
            good.then_some(Supply::Mass(rate))
        }
        (count, _) => {
            let found = if count.is_some() { "both" } else { "none" };
            let message = format!("found {found} of rate, mass_rate, expected one");
            let help = "`rate` counts spheres per second, `mass_rate` kilograms per second";
            document.reject(path, message, help)
        }
    }
}

/// The sinks; `sources` are the names of the sources.
pub(super) fn sinks(
    document: &mut Document<'_>,
    sources: &Names,
    elements: &[Entry<file::Sink>],
) -> Vec<Sink> {
    Names::declare(document, "sink", elements);
    let sinks = elements.iter().filter_map(|element| {
        let (path, value) = (&element.path, element.value.as_ref()?);
        let region = emptied(document, &format!("{path}.region"), &value.region);
        let recycle = match &value.recycle {
            Some(name) => Some(sources.resolve(document, &format!("{path}.recycle"), name)?),
            None => None,
        };
        Some(Sink {
            name: value.name.clone(),
            region: region?,
            recycle,
        })
    });
    sinks.collect()
}
