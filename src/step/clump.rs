//! A clump in a step: what the step's problem needs of it, and what the solution leaves.
//!
//! As driven bodies that are free it carries its momentum and angular momentum from step to step, and its spin follows from
//! these by the inertia in the middle of the step, `w = J(Q_h)^-1 L`: of second order, without a gyroscopic term, and frozen while
//! the step is solved. The rotation goes on by `exp(dt w)`.

use nalgebra::{Matrix3, UnitQuaternion};

use crate::Vec3;
use crate::integrator::Integrator;
use crate::scene::Scene;
use crate::scene::clump::Clump;
use crate::scene::particles::Kinematics;
use crate::scene::rotating_frame::gyroscopic;
use crate::spatial::{SpatialOperator, SpatialVector, turned};
use crate::state::State;

/// A clump at the start of a step.
#[derive(Debug)]
pub(super) struct ClumpPrediction<'a> {
    pub(super) clump: &'a Clump,
    /// Its centre of mass \[m\].
    centre: Vec3,
    /// From its own axes to the world.
    pub(super) rotation: UnitQuaternion<f64>,
    /// Velocity before the step, matching its length.
    pub(super) velocity: SpatialVector,
    /// Velocity without contacts.
    pub(super) free: SpatialVector,
    /// `W`.
    pub(super) mobility: SpatialOperator,
    /// Force \[N\] and torque about the centre \[N m\] of gravity and of the frame.
    pub(super) field: SpatialVector,
    /// Likewise with those of loads.
    pub(super) external: SpatialVector,
    /// Acceleration by `external`, and of its spin also by its rotation.
    pub(super) acceleration: SpatialVector,
    /// Before the step.
    pub(super) momentum: SpatialVector,
    /// Mass and inertia in the middle of the step.
    pub(super) mass: SpatialOperator,
}

/// What acts on clumps beside the scene's loads.
#[derive(Clone, Copy)]
pub(super) struct Acting<'a> {
    /// Gravity \[m/s^2\].
    pub(super) gravity: Vec3,
    /// Forces applied to spheres \[N\], `[N]` or none.
    pub(super) applied: &'a [Vec3],
    /// The state before a step that is to be made; `None` for the forces of the moment.
    pub(super) before: Option<&'a State>,
}

impl<'a> ClumpPrediction<'a> {
    /// All clumps of a step of `dt` \[s\] from `kinematics`, whose velocities match it, `[C]`; free of any load where nothing is `acting`.
    pub(super) fn all(
        scene: &'a Scene,
        kinematics: &Kinematics,
        acting: Option<Acting>,
        dt: f64,
    ) -> Vec<Self> {
        let of = |clump| Self::of(scene, clump, kinematics, acting, dt);
        scene.clumps.iter().map(of).collect()
    }

    fn of(
        scene: &Scene,
        clump: &'a Clump,
        kinematics: &Kinematics,
        acting: Option<Acting>,
        dt: f64,
    ) -> Self {
        let (integrator, shape) = (scene.settings.integrator, &clump.shape);
        let (centre, rotation) = clump.place(kinematics);
        let first = clump.members.start;
        let velocity = clump.of_member(rotation, &kinematics.spatial_velocity(first));
        let [mut external, mut field] = [SpatialVector::ZERO; 2];
        if let Some(acting) = acting.filter(|_| kinematics.present[first]) {
            let point_loads = scene
                .loads
                .iter()
                .map(|load| (load.sphere, load.arm, load.force));
            let applied = clump.members.clone().zip(
                acting
                    .applied
                    .get(clump.members.clone())
                    .unwrap_or_default(),
            );
            let applied = applied.map(|(i, force)| (i, Vec3::zeros(), *force));
            let own = |(i, _, _): &(usize, Vec3, Vec3)| clump.members.contains(i);
            for (i, own, force) in point_loads.filter(own).chain(applied) {
                let arm = kinematics.position[i] - centre + rotation * own;
                external.linear += force;
                external.angular += arm.cross(&force);
            }
            field.linear = acting.gravity * shape.mass;
            let motion = (centre, rotation, velocity);
            let others = field.plus(&external, 1.0);
            let inertial = clump.inertial(scene, motion, others, (acting.before, dt));
            field = field.plus(&inertial, 1.0);
            external = external.plus(&field, 1.0);
        }
        let operator = |rotation, f: fn(f64) -> f64| SpatialOperator {
            linear: Matrix3::identity() * f(shape.mass),
            angular: shape.inertia(rotation, f),
        };
        let momentum = shape.momentum(rotation, &velocity);
        let ahead = integrator.free(&momentum, &external, dt);
        let middle = turned(
            &rotation,
            &shape.response(rotation, &ahead).angular,
            0.5 * dt,
        );
        let inverse = operator(middle, f64::recip);
        let spin = velocity.angular;
        let gyroscopic = SpatialVector {
            linear: Vec3::zeros(),
            angular: -spin.cross(&momentum.angular),
        };
        Self {
            clump,
            centre,
            rotation,
            velocity,
            free: inverse.times(&ahead),
            mobility: SpatialOperator {
                linear: inverse.linear * integrator.mobility(),
                angular: inverse.angular * integrator.mobility(),
            },
            acceleration: shape.response(rotation, &external.plus(&gyroscopic, 1.0)),
            field,
            external,
            momentum,
            mass: operator(middle, |inertia| inertia),
        }
    }

    /// Its members and their centres from its own \[m\], at the start of the step.
    pub(super) fn arms(&self) -> impl Iterator<Item = (usize, Vec3)> {
        let members = self.clump.members.clone();
        members.zip(self.clump.shape.arms.iter().map(|arm| self.rotation * arm))
    }

    /// Acceleration of its material point at `arm` \[m\] without contacts \[m/s^2\].
    pub(super) fn acceleration_at(&self, arm: Vec3) -> SpatialVector {
        let spin = self.velocity.angular;
        SpatialVector {
            linear: self.acceleration.at(arm) + spin.cross(&spin.cross(&arm)),
            angular: self.acceleration.angular,
        }
    }

    /// Mass \[kg\] with which it meets an impulse along the unit vector `n` at `arm` \[m\].
    pub(super) fn mass_at(&self, arm: Vec3, n: Vec3) -> f64 {
        let push = SpatialVector {
            linear: n,
            angular: arm.cross(&n),
        };
        let own = self.clump.shape.response(self.rotation, &push);
        1.0 / (n.dot(&own.linear) + push.angular.dot(&own.angular))
    }

    /// Where `velocity` leads its centre \[m\] and its axes within `dt` \[s\].
    pub(super) fn moved(&self, velocity: &SpatialVector, dt: f64) -> (Vec3, UnitQuaternion<f64>) {
        let rotation = turned(&self.rotation, &velocity.angular, dt);
        (self.centre + velocity.linear * dt, rotation)
    }
}

impl Clump {
    /// Force \[N\] and torque about the centre \[N m\] of the scene's rotating frame on a clump at this centre \[m\] and rotation, with
    /// this velocity, on which `others` act besides contacts: in the step of `dt` \[s\] after the state `before`, as for
    /// [spheres](super::external), or at the moment.
    fn inertial(
        &self,
        scene: &Scene,
        (centre, rotation, velocity): (Vec3, UnitQuaternion<f64>, SpatialVector),
        others: SpatialVector,
        (before, dt): (Option<&State>, f64),
    ) -> SpatialVector {
        let Some(frame) = scene.settings.rotating_frame else {
            return SpatialVector::ZERO;
        };
        let (shape, first) = (&self.shape, self.members.start);
        let contacts = before.map_or(SpatialVector::ZERO, |state| {
            let contacts = state.smooth[first].plus(&state.external[first], -1.0);
            shape.momentum(rotation, &self.of_member(rotation, &contacts))
        });
        let dt = before.map_or(0.0, |_| dt);
        let ahead = scene.settings.integrator.middle(0.0, dt);
        let inertia = shape.inertia(turned(&rotation, &velocity.angular, ahead), |moment| moment);
        let centrifugal = SpatialVector {
            linear: frame.centrifugal(centre + velocity.linear * ahead) * shape.mass,
            angular: frame.centrifugal_torque(&inertia),
        };
        let others = others.plus(&contacts, 1.0).plus(&centrifugal, 1.0);
        let rate = frame.angular_velocity * 2.0;
        let pull = others.linear / shape.mass;
        let gyroscopic = SpatialVector {
            linear: gyroscopic(rate, velocity.linear, pull, Vec3::repeat(1.0), dt) * shape.mass,
            angular: frame.gyroscopic_torque(
                &inertia,
                shape.momentum(rotation, &velocity).angular,
                others.angular,
                dt,
            ),
        };
        centrifugal.plus(&gyroscopic, 1.0)
    }
}

/// Puts clump `c`, which touches nothing, into motion with the velocity that it has at `state.time`, as
/// [`release`](super::external::release) does a sphere.
pub(crate) fn release_clump(scene: &Scene, state: &mut State, c: usize) {
    let clump = &scene.clumps[c];
    let acting = Some(Acting {
        gravity: state.gravity_at(scene, state.time),
        applied: &state.applied_forces,
        before: None,
    });
    let alone = ClumpPrediction::of(scene, clump, &state.kinematics, acting, scene.settings.step);
    let own = clump.shape.response(alone.rotation, &alone.external);
    clump.share(alone.rotation, &own, &mut state.smooth);
    if !state.external.is_empty() {
        clump.share(alone.rotation, &own, &mut state.external);
    }
    if scene.settings.integrator == Integrator::Moreau {
        let before = alone.velocity.plus(&own, -0.5 * state.last_step);
        clump.put(
            (alone.centre, alone.rotation),
            &before,
            &mut state.kinematics,
        );
    }
}
