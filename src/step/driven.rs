//! A driven body in a step: what the step's problem needs of it, and what the solution leaves.

use nalgebra::UnitQuaternion;

use crate::Vec3;
use crate::integrator::Integrator;
use crate::scene::body::{Area, Body, Joint, Modes, along};
use crate::scene::{Boundary, Command, InputKind, Scene, Settings};
use crate::spatial::{Pose, SpatialOperator, SpatialVector, Twist};
use crate::state::{BodyState, State};

/// A driven body at the start of a step: everything that the step's problem needs of it.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyPrediction<'a> {
    /// Index of its boundary.
    pub boundary: usize,
    /// Its reference point \[m\], world.
    pub reference: Vec3,
    /// Its point of action from the reference point \[m\].
    pub action: Vec3,
    /// Velocity before the step, matching its length.
    pub velocity: SpatialVector,
    /// Velocity without contacts.
    pub free: SpatialVector,
    /// `W`.
    pub mobility: SpatialOperator,
    /// Force \[N\] and torque about the reference point \[N m\] of loads and gravity.
    pub external: SpatialVector,
    /// Those of the loads alone, force at the point of action.
    pub load: SpatialVector,
    /// Acceleration by `external`.
    pub acceleration: SpatialVector,
    /// What its boundary's joint carried in the last step: [`BodyState::joint_position`], [`BodyState::joint_forces`].
    pub(super) joint_position: f64,
    pub(super) joint_forces: [f64; 3],
    pub(super) body: &'a Body,
    pub(super) surface: &'a Boundary,
    momentum: SpatialVector,
    mass: SpatialOperator,
}

impl<'a> BodyPrediction<'a> {
    /// All driven bodies of a step of `dt` \[s\] from `state`, `[D]`.
    #[must_use]
    pub fn all(scene: &'a Scene, state: &State, commands: &[Command], dt: f64) -> Vec<Self> {
        let bodies = scene.driven().zip(&state.bodies);
        bodies
            .map(|((b, body), carried)| Self::of((scene, state, commands), b, body, carried, dt))
            .collect()
    }

    fn of(
        (scene, state, commands): (&'a Scene, &State, &[Command]),
        b: usize,
        body: &'a Body,
        carried: &BodyState,
        dt: f64,
    ) -> Self {
        let boundary = &scene.boundaries[b];
        let pivot = boundary.point_of_action;
        let integrator = scene.settings.integrator;
        let pose = &state.poses[b];
        let reference = boundary.from_frame(pose, body.reference(pivot));
        let action = body.action(pivot, pose);
        // Shi's acceleration is constant over the step: that of the middle keeps its second order where torques turn along.
        let ahead = match integrator {
            Integrator::Moreau => Vec3::zeros(),
            Integrator::Shi => carried.velocity.angular * (0.5 * dt),
        };
        let ahead = UnitQuaternion::from_scaled_axis(ahead);
        let lever = ahead * action;
        let centre = ahead * (boundary.from_frame(pose, body.centre) - reference);
        let load = body.load(scene, &state.poses, &commands[b]);
        let weight = match body.gravity {
            true => state.gravity_at(scene, integrator.middle(state.time, dt)) * body.mass,
            false => Vec3::zeros(),
        };
        let external = SpatialVector {
            linear: load.linear + weight,
            angular: load.angular + lever.cross(&load.linear) + centre.cross(&weight),
        };
        let here = body.operator(pivot, pose.rotation, f64::recip);
        let (last, smooth) = (state.last_step, &carried.smooth);
        let momentum = integrator.shift_half_step(&carried.momentum, smooth, last, dt);
        let velocity = integrator.shift_half_step(&carried.velocity, &here.times(smooth), last, dt);
        let ahead = integrator.free(&momentum, &external, dt);
        let turn = here.times(&ahead).angular * (0.5 * dt);
        let middle = UnitQuaternion::from_scaled_axis(turn) * pose.rotation;
        let [linear, angular] = body.modes(pivot, middle);
        let damped = |modes: &Modes, c: f64, momentum: Vec3, force: Vec3| {
            let kept = along(modes, |inertia| damping(integrator, c, inertia, dt)[0]);
            let moved = along(modes, |inertia| damping(integrator, c, inertia, dt)[1]);
            (kept * momentum + moved * (force * dt), moved)
        };
        let (v, linear_w) = damped(&linear, body.damping[0], momentum.linear, external.linear);
        let (w, angular_w) = damped(
            &angular,
            body.damping[1],
            momentum.angular,
            external.angular,
        );
        Self {
            boundary: b,
            reference,
            action,
            velocity,
            free: SpatialVector {
                linear: v,
                angular: w,
            },
            mobility: SpatialOperator {
                linear: linear_w,
                angular: angular_w,
            },
            acceleration: here.times(&external),
            external,
            load,
            joint_position: carried.joint_position,
            joint_forces: carried.joint_forces,
            body,
            surface: boundary,
            momentum,
            mass: body.operator(pivot, middle, |inertia| inertia),
        }
    }

    /// Acceleration of the material point at `arm` by loads and gravity and by its rotation \[m/s^2\].
    #[must_use]
    pub fn acceleration_at(&self, arm: Vec3) -> Vec3 {
        let w = self.velocity.angular;
        self.acceleration.at(arm) + w.cross(&w.cross(&arm))
    }

    /// Its mass \[kg\].
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.body.mass
    }

    /// The pose to which `velocity` leads from `pose` within `dt` \[s\].
    #[must_use]
    pub fn moved(&self, pose: &Pose, velocity: &SpatialVector, dt: f64) -> Pose {
        let turn = UnitQuaternion::from_scaled_axis(velocity.angular * dt);
        Pose {
            translation: pose.translation + velocity.linear * dt + turn * self.action - self.action,
            rotation: UnitQuaternion::new_normalize((turn * pose.rotation).into_inner()),
        }
    }

    /// Kinetic energy \[J\] at `pose` with `momentum` about the reference point.
    #[must_use]
    pub fn kinetic_energy(&self, pose: &Pose, momentum: &SpatialVector) -> f64 {
        let mobility = self
            .body
            .operator(self.surface.point_of_action, pose.rotation, f64::recip);
        0.5 * momentum.dot(&mobility.times(momentum))
    }

    /// Mass times the centre of mass halfway between two poses \[kg m\]; `None` without weight.
    #[must_use]
    pub fn weight_moment(&self, poses: [&Pose; 2]) -> Option<Vec3> {
        let [from, to] = poses.map(|pose| self.surface.from_frame(pose, self.body.centre));
        self.body
            .gravity
            .then(|| (from + to) * (0.5 * self.body.mass))
    }

    /// Work \[J\] of its weight under `gravity` \[m/s^2\] along the path between two poses.
    #[must_use]
    pub fn weight_work(&self, gravity: Vec3, poses: [&Pose; 2]) -> f64 {
        let [from, to] = poses.map(|pose| self.surface.from_frame(pose, self.body.centre));
        match self.body.gravity {
            true => self.body.mass * gravity.dot(&(to - from)),
            false => 0.0,
        }
    }

    /// Velocity of the point of action at `velocity` of the reference point.
    #[must_use]
    pub fn action_velocity(&self, velocity: &SpatialVector) -> Twist {
        Twist {
            linear: velocity.at(self.action),
            angular: velocity.angular,
        }
    }

    /// What the body carries on after `v1` solved the step's problem, and the work of its damper \[J\]. `contacts` are the
    /// impulses of all contacts, stops and the spring and `smooth` those that are no impacts, about the reference point;
    /// `joint_forces` what the joint's stops and spring exert; `end` the pose.
    #[must_use]
    pub fn finish(
        &self,
        settings: &Settings,
        v1: &SpatialVector,
        [contacts, smooth]: [&SpatialVector; 2],
        joint_forces: [f64; 3],
        end: &Pose,
        dt: f64,
    ) -> (BodyState, f64) {
        let mobility = settings.integrator.mobility();
        let solved = self.mass.times(v1);
        let momentum =
            settings
                .integrator
                .finish(&self.momentum, &solved, settings.dynamic_coefficient);
        // What is missing in the balance of momentum over the whole step is the damper's impulse.
        let damper = solved
            .plus(&self.momentum, -1.0)
            .plus(&self.external, -dt * mobility)
            .plus(contacts, -mobility);
        let damper = SpatialVector::ZERO.plus(&damper, 1.0 / mobility);
        let velocity = match settings.integrator {
            Integrator::Moreau => *v1,
            Integrator::Shi => {
                let mobility =
                    self.body
                        .operator(self.surface.point_of_action, end.rotation, f64::recip);
                mobility.times(&momentum)
            }
        };
        let mean = match settings.integrator {
            Integrator::Moreau => SpatialVector::ZERO.plus(&self.velocity, 0.5).plus(v1, 0.5),
            Integrator::Shi => *v1,
        };
        let carried = BodyState {
            momentum,
            velocity,
            smooth: self.external.plus(smooth, 1.0 / dt).plus(&damper, 1.0 / dt),
            joint_position: self.body.joint_position(end, self.joint_position),
            joint_forces,
        };
        (carried, damper.dot(&mean))
    }
}

/// `[a, b]` of one mode: `v_free = a P + b dt F`, `W = b`.
fn damping(integrator: Integrator, c: f64, inertia: f64, dt: f64) -> [f64; 2] {
    match integrator {
        Integrator::Moreau => {
            let l = c * dt / inertia;
            let phi = if l > 0.0 { -(-l).exp_m1() / l } else { 1.0 };
            [(-l).exp() / inertia, phi / inertia]
        }
        Integrator::Shi => {
            let stiff = 2.0 * inertia + c * dt;
            [2.0 / stiff, 1.0 / stiff]
        }
    }
}

impl Body {
    /// Force \[N\] at the point of action and torque \[N m\] of all loads but gravity.
    fn load(&self, scene: &Scene, poses: &[Pose], command: &Command) -> SpatialVector {
        let mut load = SpatialVector {
            linear: self.force,
            angular: self.torque,
        };
        match self.input_kind() {
            Some(InputKind::Load) => {
                load.linear += command.force;
                load.angular += command.torque;
            }
            Some(InputKind::SlideForce { axis }) => load.linear += axis * command.scalar,
            Some(InputKind::HingeTorque { axis }) => load.angular += axis * command.scalar,
            _ => {}
        }
        if let (Joint::Slide { axis }, Some(servo)) = (self.joint, &self.servo) {
            let pressure = if servo.input {
                command.pressure
            } else {
                servo.pressure
            };
            load.linear += axis * (pressure * servo.area.of(scene, poses));
        }
        load
    }
}

impl Area {
    /// The area \[m^2\] when the boundaries stand at `poses`.
    pub(crate) fn of(&self, scene: &Scene, poses: &[Pose]) -> f64 {
        match self {
            Self::Constant(area) => *area,
            Self::Between(pairs) => {
                let at = |b: usize| scene.boundaries[b].point_of_action + poses[b].translation;
                pairs
                    .iter()
                    .map(|[a, b]| (at(*a) - at(*b)).norm())
                    .product()
            }
        }
    }
}
