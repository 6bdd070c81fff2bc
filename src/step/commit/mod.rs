//! Last stage of a step: from its solution to the next state.

mod energy;
mod forces;
mod impacts;
mod walls;

pub(super) use impacts::{Balance, spread_impacts};

use std::mem::swap;

use nalgebra::UnitQuaternion;

use super::external;
use super::sleep::Sleepers;
use super::solution::Solved;
use crate::Vec3;
use crate::spatial::{SpatialVector, turned};
use crate::state::State;

/// A step below this share of the one before it has no forces and accelerations of its own.
pub(crate) const REMAINDER: f64 = 0.05;

/// Of pieces of the spheres: centres and orientations.
type Places<'a> = (&'a mut [Vec3], &'a mut [UnitQuaternion<f64>]);
/// Likewise velocities and spins.
type Velocities<'a> = (&'a mut [Vec3], &'a mut [Vec3]);

/// Writes a solved step into `state`: motion, contact forces, wrenches, work. The time stays. `sleepers` is that of `solved`, `spare` is memory.
pub(super) fn commit(
    solved: &Solved,
    state: &mut State,
    sleepers: &Sleepers,
    spare: &mut Vec<SpatialVector>,
) {
    let prediction = solved.prediction();
    let dt = prediction.step;
    let ends = prediction.end_poses(&solved.solution.velocity);
    solved.smooth_acceleration(spare, true);
    solved.still(spare);
    let mut finished = solved.finished(&ends);
    let remainder = solved.is_remainder(state);
    if remainder {
        spare.clone_from(&state.smooth);
        for ((after, _), before) in finished.iter_mut().zip(&state.bodies) {
            after.smooth = before.smooth;
        }
    }
    let smooth_wrenches = remainder.then(|| state.smooth_wrenches.clone());
    let smooth_loads = walls::smooth_loads(state, remainder);
    let remains = solved.remains();
    let end = solved.end(&ends, &remains);
    solved.work(state, end.as_ref());
    solved.body_work(state, &finished, &ends);
    solved.wear(state, end.as_ref());
    solved.store(state, &remains);
    solved.hand_on(state, sleepers);
    if let Some(smooth) = smooth_wrenches {
        state.smooth_wrenches = smooth;
    }
    walls::keep_smooth(state, smooth_loads);
    state.broken_bonds += solved.assembly.broken_bonds;
    state.springs = solved.spring_forces();
    solved.advance(state, spare);
    solved.advance_clumps(state, spare);
    swap(&mut state.smooth, spare);
    for (carried, (after, _)) in state.bodies.iter_mut().zip(finished) {
        *carried = after;
    }
    let paths = state.poses.iter().zip(&ends);
    state.twists = paths.map(|(from, to)| from.twist_to(to, dt)).collect();
    state.poses = ends;
    let (external, clumps) = (&prediction.external, &prediction.clumps);
    external::keep(prediction.scene, state, external, clumps);
    state.body_force += prediction.outside.body_force;
    solved.gravity_work(state);
    solved.rest(state, sleepers);
    state.last_step = dt;
}

impl Solved<'_> {
    /// Whether the step is so much shorter than the one before it that what it leaves of velocities says nothing of forces: smooth
    /// accelerations, by which the half step of the next one is shifted, stay those before it.
    fn is_remainder(&self, state: &State) -> bool {
        let prediction = self.prediction();
        prediction.step < REMAINDER * state.last_step && prediction.scene.settings.is_steady()
    }

    /// Moves the spheres. What of the change of their kinetic energy external forces and [`Self::work`] do not account for is
    /// numerical work.
    fn advance(&self, state: &mut State, smooth: &[SpatialVector]) {
        let (scene, step) = (self.prediction().scene, self.prediction().step);
        let (particles, integrator) = (&scene.particles, scene.settings.integrator);
        let kinetic =
            |i: usize, v: &SpatialVector| particles.kinetic_energy(i, &v.linear, &v.angular);
        let (start, end) = (&self.prediction().kinematics, &mut state.kinematics);
        let places = (&mut end.position[..], &mut end.orientation[..]);
        let velocities = (&mut end.velocity[..], &mut end.spin[..]);
        let carried = &state.smooth[..];
        let advance = |first: usize, (places, velocities): (Places, Velocities)| {
            let places = places.0.iter_mut().zip(places.1);
            let velocities = velocities.0.iter_mut().zip(velocities.1);
            let mut numerical_work = 0.0;
            for (i, (place, motion)) in (first..).zip(places.zip(velocities)) {
                if particles.clump(i).is_some() {
                    continue;
                }
                let ((position, orientation), (velocity, spin)) = (place, motion);
                let (v1, external) = (&self.solution.velocity[i], &self.prediction().external[i]);
                let before = start.spatial_velocity(i);
                let after = integrator.finish(&before, v1, scene.settings.dynamic_coefficient);
                let old = integrator.reported(&before, &carried[i], step);
                let new = integrator.reported(&after, &smooth[i], step);
                let power = particles.mass[i] * external.linear.dot(&v1.linear)
                    + particles.inertia(i) * external.angular.dot(&v1.angular);
                numerical_work += kinetic(i, &new) - kinetic(i, &old) - step * power;
                *position = start.position[i] + v1.linear * step;
                *orientation = turned(&start.orientation[i], &v1.angular, step);
                (*velocity, *spin) = (after.linear, after.angular);
            }
            numerical_work
        };
        let spheres = (places, velocities);
        let numerical_work = self
            .prediction()
            .pool
            .pieces(spheres, advance, |a, b| a + b);
        state.work.numerical_work += numerical_work;
    }
}
