//! Second stage of a step: the pairs that may touch within it.

use std::mem::take;

use super::prediction::Prediction;
use super::workspace::Workspace;
use crate::detection::configuration::{Candidate, Configuration};
use crate::detection::detection_distance::DetectionDistance;
use crate::scene::clump::Clump;
use crate::spatial::SpatialVector;

/// Contacts with a gap below this share of the radius are candidates even at rest.
const NEAR: f64 = 1e-3;

/// Into `candidates` the pairs within reach of the step, in canonical order. `free` are velocities without contacts, `[N + D + C]`.
///
/// What a sphere can move is known before contacts change its velocity: [`super::verify`] finds what this misses.
pub(super) fn detect(
    prediction: &Prediction,
    free: &[SpatialVector],
    workspace: &mut Workspace,
    candidates: &mut Vec<Candidate>,
) {
    let (scene, step) = (prediction.scene, prediction.step);
    let [start, end] = &prediction.poses;
    let configuration = Configuration::of(scene, &prediction.kinematics, start);
    let both = |i: usize| [prediction.kinematics.velocity[i], free[i].linear];
    let radii = &scene.particles.radius;
    let mut reach = take(&mut workspace.reach);
    reach.resize(radii.len(), DetectionDistance::default());
    let largest = scene.particles.largest_radius();
    let held = scene.holding_distance(largest);
    let (more, pool) = (|i| NEAR * radii[i] + held, &workspace.neighbors.pool);
    DetectionDistance::of(both, step, more, (&mut reach, pool));
    if let Some(edge) = scene.cell.smallest_edge() {
        // Copies beyond the next ones are met by no step that is not cut anyway.
        for own in &mut reach {
            own.pairs = own.pairs.min(edge);
        }
    }
    let diameter = 2.0 * (largest + DetectionDistance::largest(&reach).pairs);
    // A clump is swept where its first member is.
    let first = |clump: &Clump| Some(clump.members.start);
    let members = prediction.bodies.iter().map(|_| None);
    let members = members.chain(scene.clumps.iter().map(first));
    workspace
        .solver
        .kernel
        .prepare(configuration.position, diameter, members);
    // Of every sphere and boundary: what the list holds already must not decide what it lacks.
    let carried = (0..scene.boundaries.len()).map(|b| configuration.carried(b, &end[b]));
    let carried = carried.fold(0.0, f64::max);
    workspace.neighbors.ensure(&configuration, &reach, carried);
    // Against other spheres a displacement that all have in common does not count.
    let of_pair = |i: u32, j: u32| {
        let [a, b] = [i, j].map(|k| &reach[k as usize]);
        (a.pairs + b.pairs).min(a.boundaries + b.boundaries)
    };
    let displacements = (0..scene.boundaries.len()).map(|b| configuration.displacement(b, &end[b]));
    let displacements: Vec<_> = displacements.collect();
    let of_boundary = |i: u32, b: u16| {
        let (i, b) = (i as usize, usize::from(b));
        let x = prediction.kinematics.position[i];
        let way = |displacement| configuration.displacement_at(b, displacement, x);
        reach[i].boundaries + displacements[b].as_ref().map_or(0.0, way)
    };
    configuration.candidates(&workspace.neighbors, of_pair, of_boundary, candidates);
    workspace.reach = reach;
}
