//! Accelerations by external forces: gravity, point loads, and the inertial forces of a rotating frame.

use super::{Start, dof};
use crate::Vec3;
use crate::integrator::Integrator;
use crate::scene::Scene;
use crate::scene::particles::Kinematics;
use crate::scene::rotating_frame::gyroscopic;
use crate::spatial::Dof6;
use crate::state::State;
use crate::step::assemble::external_acceleration;

/// Into `external` the acceleration in a step of `dt` \[s\] that begins with `kinematics`, `[N]`.
pub(super) fn acceleration(
    scene: &Scene,
    state: &State,
    kinematics: &Kinematics,
    (gravity, dt): (Vec3, f64),
    external: &mut Vec<Dof6>,
) {
    external_acceleration(scene, kinematics, gravity, external);
    let Some(frame) = scene.settings.rotating_frame else {
        return;
    };
    let rate = frame.angular_velocity;
    // Where the velocity is that of the start, the middle of the step lies half a step on.
    let ahead = match scene.settings.integrator {
        Integrator::Moreau => 0.0,
        Integrator::Shi => 0.5 * dt,
    };
    for (i, external) in external.iter_mut().enumerate() {
        if !kinematics.present[i] {
            continue;
        }
        let [shifts, turns] = scene.particles.free(i);
        let before = dof(kinematics, i);
        let middle = kinematics.position[i] + before.linear * ahead;
        external.linear += frame.centrifugal(middle).component_mul(&shifts);
        let contacts = state.persisting[i].plus(&state.external[i], -1.0);
        let others = external.plus(&contacts, 1.0);
        external.linear += gyroscopic(rate * 2.0, before.linear, others.linear, shifts, dt);
        external.angular += gyroscopic(rate, before.angular, others.angular, turns, dt);
    }
}

/// External acceleration at the moment of `kinematics`, `[N]`.
pub(super) fn at_start(scene: &Scene, kinematics: &Kinematics, gravity: Vec3) -> Vec<Dof6> {
    let mut external = Vec::new();
    external_acceleration(scene, kinematics, gravity, &mut external);
    for (i, external) in external.iter_mut().enumerate() {
        if kinematics.present[i] {
            *external = external.plus(&inertial(scene, kinematics, i), 1.0);
        }
    }
    external
}

/// Acceleration of sphere `i` by the inertial forces of the frame; zero where locked, or without such a frame.
fn inertial(scene: &Scene, kinematics: &Kinematics, i: usize) -> Dof6 {
    let Some(frame) = scene.settings.rotating_frame else {
        return Dof6::ZERO;
    };
    let (rate, velocity) = (frame.angular_velocity, dof(kinematics, i));
    let [shifts, turns] = scene.particles.free(i);
    let centre = frame.centrifugal(kinematics.position[i]) - 2.0 * rate.cross(&velocity.linear);
    Dof6 {
        linear: centre.component_mul(&shifts),
        angular: -rate.cross(&velocity.angular).component_mul(&turns),
    }
}

/// Lets `state` know which part of its persisting accelerations is external.
pub(super) fn keep(scene: &Scene, state: &mut State, external: &[Dof6]) {
    if scene.settings.rotating_frame.is_some() {
        state.external.clear();
        state.external.extend_from_slice(external);
    }
    let forces = external.iter().zip(&scene.particles.mass);
    state.body_force = forces.map(|(a, mass)| a.linear * *mass).sum();
}

/// Puts sphere `i`, which touches nothing, into motion with the velocity that it has at `state.time`.
pub(crate) fn release(scene: &Scene, state: &mut State, i: usize) {
    let gravity = state.gravity_at(scene, state.time);
    let [shifts, _] = scene.particles.free(i);
    let mut external = inertial(scene, &state.kinematics, i);
    external.linear += gravity.component_mul(&shifts);
    state.persisting[i] = external;
    if let Some(own) = state.external.get_mut(i) {
        *own = external;
    }
    // The integrator carries the velocity half a step before.
    if scene.settings.integrator == Integrator::Moreau {
        let before = dof(&state.kinematics, i).plus(&external, -0.5 * state.last_step);
        state.kinematics.velocity[i] = before.linear;
        state.kinematics.spin[i] = before.angular;
    }
}

impl Start<'_> {
    /// External forces, and the work of a gravity that changes, into the `state` after a step of `dt` \[s\].
    pub(super) fn book(&self, scene: &Scene, state: &mut State, dt: f64) {
        keep(scene, state, &self.external);
        let [from, to] = [0.0, dt].map(|after| state.gravity_at(scene, state.time + after));
        if from != to {
            let ends = self
                .kinematics
                .position
                .iter()
                .zip(&state.kinematics.position);
            let middle: Vec<Vec3> = ends.map(|(a, b)| (a + b) * 0.5).collect();
            state.lift(scene, &middle, to - from);
            let heavy = self.bodies.iter().filter_map(|body| {
                let poses = [&self.standing[body.boundary], &state.poses[body.boundary]];
                body.weight_moment(poses)
            });
            let moment: Vec3 = heavy.sum();
            state.work.gravity -= moment.dot(&(to - from));
        }
    }
}
