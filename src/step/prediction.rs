//! What a step takes from the state before it moves anything.

use super::StepInput;
use super::external;
use crate::Vec3;
use crate::scene::particles::Kinematics;
use crate::scene::{Command, Scene};
use crate::spatial::{Pose, SpatialVector, Twist};
use crate::state::State;
use crate::step::assemble::{AssemblyInput, SphereMotion};
use crate::step::driven::BodyPrediction;
use crate::step::external::mean_acceleration;
use crate::step::workspace::PredictionArrays;

/// What a step takes from the state before it moves anything.
pub(super) struct Prediction<'a> {
    pub(super) kinematics: Kinematics,
    pub(super) gravity: Vec3,
    pub(super) external: Vec<SpatialVector>,
    pub(super) spheres: Vec<SphereMotion>,
    pub(super) targets: Vec<Vec3>,
    pub(super) standing: Vec<Pose>,
    pub(super) ends: Vec<Pose>,
    pub(super) bodies: Vec<BodyPrediction<'a>>,
    pub(super) twists: Vec<Twist>,
    pub(super) surfaces: Vec<Vec3>,
}

/// Velocities of the boundaries' surfaces against their shapes \[m/s\], world axes, `[B]`.
pub(super) fn surfaces(scene: &Scene, state: &State, commands: &[Command]) -> Vec<Vec3> {
    let boundaries = scene.boundaries.iter();
    let driven = boundaries.zip(state.poses.iter().zip(commands));
    driven
        .map(|(boundary, (pose, command))| boundary.surface_velocity(pose, command))
        .collect()
}

impl<'s> Prediction<'s> {
    /// Places of `state`, and its velocities for a step as long as `input` says, in the memory of `kept`.
    pub(super) fn of(
        scene: &'s Scene,
        state: &State,
        input: &StepInput,
        kept: &mut PredictionArrays,
    ) -> Self {
        let dt = input.dt;
        let bodies = BodyPrediction::all(scene, state, &input.commands, dt);
        let mut ends = input.poses.clone();
        for body in &bodies {
            let b = body.boundary;
            ends[b] = body.moved(&state.poses[b], &body.free, dt);
        }
        let integrator = scene.settings.integrator;
        let mut kinematics = std::mem::take(&mut kept.kinematics);
        let now = &state.kinematics;
        kinematics.present.clone_from(&now.present);
        kinematics.position.clone_from(&now.position);
        kinematics.orientation.clone_from(&now.orientation);
        kinematics.velocity.clear();
        kinematics.spin.clear();
        let count = state.kinematics.len();
        kinematics.velocity.reserve_exact(count);
        kinematics.spin.reserve_exact(count);
        for (i, smooth) in state.smooth.iter().enumerate() {
            let v = state.kinematics.spatial_velocity(i);
            let v = integrator.shift_half_step(&v, smooth, state.last_step, dt);
            kinematics.velocity.push(v.linear);
            kinematics.spin.push(v.angular);
        }
        let end_time = state.time + dt;
        let springs = scene.springs.iter();
        let gravity = state.gravity_at(scene, integrator.middle(state.time, dt));
        let mut external = std::mem::take(&mut kept.external);
        external::acceleration(scene, state, &kinematics, (gravity, dt), &mut external);
        let memory = std::mem::take(&mut kept.spheres);
        let spheres = SphereMotion::all(scene, &kinematics, memory);
        Self {
            gravity,
            external,
            spheres,
            kinematics,
            targets: springs
                .map(|spring| spring.target + spring.motion.pose_at(end_time).translation)
                .collect(),
            standing: state.poses.clone(),
            ends,
            bodies,
            twists: state.twists.clone(),
            surfaces: surfaces(scene, state, &input.commands),
        }
    }

    pub(super) fn inputs<'a>(&'a self, scene: &'a Scene, dt: f64) -> AssemblyInput<'a> {
        AssemblyInput {
            scene,
            kinematics: &self.kinematics,
            external: &self.external,
            spheres: &self.spheres,
            step: dt,
            poses: [&self.standing, &self.ends],
            bodies: &self.bodies,
            twists: &self.twists,
            surfaces: &self.surfaces,
            gravity: self.gravity,
            gravity_size: self.gravity.norm(),
            targets: &self.targets,
            mean_acceleration: mean_acceleration(scene, &self.external, &self.bodies),
        }
    }
}
