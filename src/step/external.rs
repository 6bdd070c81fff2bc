//! Accelerations by external forces: gravity, point loads, forces applied from outside, and the inertial forces of a rotating frame.

use crate::Vec3;
use crate::integrator::Integrator;
use crate::parallel::Pool;
use crate::problem::JacobianBlock;
use crate::scene::Scene;
use crate::scene::particles::Kinematics;
use crate::scene::rotating_frame::gyroscopic;
use crate::spatial::SpatialVector;
use crate::state::State;
use crate::step::clump::ClumpPrediction;
use crate::step::driven::BodyPrediction;

/// Into `external` the acceleration in a step of `dt` \[s\] that begins with `kinematics`, `[N]`.
pub(super) fn acceleration(
    scene: &Scene,
    state: &State,
    kinematics: &Kinematics,
    (gravity, dt): (Vec3, f64),
    (external, pool): (&mut Vec<SpatialVector>, &Pool),
) {
    external_acceleration(scene, state, kinematics, gravity, (external, pool));
    let Some(frame) = scene.settings.rotating_frame else {
        return;
    };
    let rate = frame.angular_velocity;
    // Where the velocity is that of the start, the middle of the step lies half a step on.
    let ahead = scene.settings.integrator.middle(0.0, dt);
    for (i, external) in external.iter_mut().enumerate() {
        if !kinematics.present[i] {
            continue;
        }
        let [shifts, turns] = scene.particles.free(i);
        let before = kinematics.spatial_velocity(i);
        let middle = kinematics.position[i] + before.linear * ahead;
        external.linear += frame.centrifugal(middle).component_mul(&shifts);
        let contacts = state.smooth[i].plus(&state.external[i], -1.0);
        let others = external.plus(&contacts, 1.0);
        external.linear += gyroscopic(rate * 2.0, before.linear, others.linear, shifts, dt);
        external.angular += gyroscopic(rate, before.angular, others.angular, turns, dt);
    }
}

/// External acceleration at the moment of `state`, `[N]`.
pub(super) fn at_start(scene: &Scene, state: &State, gravity: Vec3) -> Vec<SpatialVector> {
    let (mut external, kinematics) = (Vec::new(), &state.kinematics);
    let memory = (&mut external, &Pool::default());
    external_acceleration(scene, state, kinematics, gravity, memory);
    for (i, external) in external.iter_mut().enumerate() {
        if kinematics.present[i] {
            *external = external.plus(&inertial(scene, kinematics, i), 1.0);
        }
    }
    external
}

/// Acceleration of sphere `i` by the inertial forces of the frame; zero where locked, or without such a frame.
fn inertial(scene: &Scene, kinematics: &Kinematics, i: usize) -> SpatialVector {
    let Some(frame) = scene.settings.rotating_frame else {
        return SpatialVector::ZERO;
    };
    let (rate, velocity) = (frame.angular_velocity, kinematics.spatial_velocity(i));
    let [shifts, turns] = scene.particles.free(i);
    let centre = frame.centrifugal(kinematics.position[i]) - 2.0 * rate.cross(&velocity.linear);
    SpatialVector {
        linear: centre.component_mul(&shifts),
        angular: -rate.cross(&velocity.angular).component_mul(&turns),
    }
}

/// Writes into `state` which part of its smooth accelerations is external.
pub(super) fn keep(
    scene: &Scene,
    state: &mut State,
    external: &[SpatialVector],
    clumps: &[ClumpPrediction],
) {
    if scene.settings.rotating_frame.is_some() {
        state.external.clear();
        state.external.extend_from_slice(external);
        for ClumpPrediction {
            clump, external, ..
        } in clumps
        {
            let (_, rotation) = clump.place(&state.kinematics);
            let own = clump.shape.response(rotation, external);
            clump.share(rotation, &own, &mut state.external);
        }
    }
    let forces = external.iter().zip(&scene.particles.mass).enumerate();
    let single = forces.filter(|(i, _)| scene.particles.clump(*i).is_none());
    state.body_force = single.map(|(_, (a, mass))| a.linear * *mass).sum();
    for clump in clumps {
        state.body_force += clump.external.linear;
    }
}

/// Puts sphere `i`, which touches nothing, into motion with the velocity that it has at `state.time`.
pub(crate) fn release(scene: &Scene, state: &mut State, i: usize) {
    let gravity = state.gravity_at(scene, state.time);
    let [shifts, _] = scene.particles.free(i);
    let mut external = inertial(scene, &state.kinematics, i);
    external.linear += gravity.component_mul(&shifts);
    if let Some(force) = state.applied_forces.get(i) {
        external.linear += scene.particles.inverse_mass(i).component_mul(force);
    }
    state.smooth[i] = external;
    if let Some(own) = state.external.get_mut(i) {
        *own = external;
    }
    // The integrator carries the velocity half a step before.
    if scene.settings.integrator == Integrator::Moreau {
        let before = state
            .kinematics
            .spatial_velocity(i)
            .plus(&external, -0.5 * state.last_step);
        state.kinematics.velocity[i] = before.linear;
        state.kinematics.spin[i] = before.angular;
    }
}

/// Acceleration \[m/s^2\] by which all loads would change the speed of all bodies together: `sum |f| / sum m` over spheres
/// with their `external` accelerations, `[N]`, and driven `bodies`. What a body on which nothing acts itself is pressed with.
#[must_use]
pub fn mean_acceleration(
    scene: &Scene,
    external: &[SpatialVector],
    bodies: &[BodyPrediction],
) -> f64 {
    let masses = &scene.particles.mass;
    let spheres = external.iter().zip(masses);
    let force: f64 = spheres.map(|(a, m)| m * a.linear.norm()).sum::<f64>()
        + bodies
            .iter()
            .map(|body| body.external.linear.norm())
            .sum::<f64>();
    let mass = masses.iter().sum::<f64>() + bodies.iter().map(BodyPrediction::mass).sum::<f64>();
    if mass > 0.0 { force / mass } else { 0.0 }
}

/// Into `external` the acceleration of every sphere by gravity, point loads and applied forces, `[N]`; zero where locked or absent.
pub(crate) fn external_acceleration(
    scene: &Scene,
    state: &State,
    kinematics: &Kinematics,
    gravity: Vec3,
    (external, pool): (&mut Vec<SpatialVector>, &Pool),
) {
    let particles = &scene.particles;
    external.resize(particles.len(), SpatialVector::ZERO);
    pool.fill(&mut external[..], |i| match kinematics.present[i] {
        true => SpatialVector {
            linear: particles.free(i)[0].component_mul(&gravity),
            angular: Vec3::zeros(),
        },
        false => SpatialVector::ZERO,
    });
    for load in &scene.loads {
        let i = load.sphere;
        let w = SpatialVector {
            linear: particles.inverse_mass(i),
            angular: particles.inverse_inertia(i),
        };
        let arm = kinematics.orientation[i] * load.arm;
        let force = JacobianBlock::Point(arm).momentum(load.force);
        external[i] = external[i].plus(&w.component_mul(&force), 1.0);
    }
    for (i, force) in state.applied_forces.iter().enumerate() {
        if kinematics.present[i] {
            external[i].linear += particles.inverse_mass(i).component_mul(force);
        }
    }
}
