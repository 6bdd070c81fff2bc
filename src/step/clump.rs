//! A clump in a step: what the step's problem needs of it, and what the solution leaves.
//!
//! As driven bodies that are free it carries its momentum and angular momentum from step to step, and its spin follows from
//! these by the inertia in the middle of the step, `w = J(Q_h)^-1 L`: of second order, without a gyroscopic term, and frozen while
//! the step is solved. The rotation goes on by `exp(dt w)`.

use nalgebra::{Matrix3, UnitQuaternion};

use super::prediction::Prediction;
use super::solution::Solved;
use crate::Vec3;
use crate::integrator::Integrator;
use crate::scene::Scene;
use crate::scene::clump::Clump;
use crate::scene::particles::Kinematics;
use crate::spatial::{SpatialOperator, SpatialVector, turned};
use crate::state::State;

/// A clump at the start of a step.
#[derive(Debug)]
pub(super) struct ClumpPrediction<'a> {
    pub(super) clump: &'a Clump,
    /// Its centre of mass \[m\].
    centre: Vec3,
    /// From its own axes to the world.
    rotation: UnitQuaternion<f64>,
    /// Velocity before the step, matching its length.
    pub(super) velocity: SpatialVector,
    /// Velocity without contacts.
    pub(super) free: SpatialVector,
    /// `W`.
    pub(super) mobility: SpatialOperator,
    /// Force \[N\] and torque about the centre \[N m\] of gravity and loads.
    pub(super) external: SpatialVector,
    /// Acceleration by `external`, and of its spin also by its rotation.
    pub(super) acceleration: SpatialVector,
    momentum: SpatialVector,
    mass: SpatialOperator,
}

impl<'a> ClumpPrediction<'a> {
    /// All clumps of a step of `dt` \[s\] from `kinematics`, whose velocities match it, `[C]`; where there are `loads`, under gravity
    /// \[m/s^2\], the scene's loads and the forces applied to spheres \[N\].
    pub(super) fn all(
        scene: &'a Scene,
        kinematics: &Kinematics,
        loads: Option<(Vec3, &[Vec3])>,
        dt: f64,
    ) -> Vec<Self> {
        let of = |clump| Self::of(scene, clump, kinematics, loads, dt);
        scene.clumps.iter().map(of).collect()
    }

    fn of(
        scene: &Scene,
        clump: &'a Clump,
        kinematics: &Kinematics,
        loads: Option<(Vec3, &[Vec3])>,
        dt: f64,
    ) -> Self {
        let (integrator, shape) = (scene.settings.integrator, &clump.shape);
        let (centre, rotation) = clump.place(kinematics);
        let first = clump.members.start;
        let velocity = clump.of_member(rotation, &kinematics.spatial_velocity(first));
        let mut external = SpatialVector::ZERO;
        if let Some((gravity, applied)) = loads.filter(|_| kinematics.present[first]) {
            external.linear = gravity * shape.mass;
            let point_loads = scene
                .loads
                .iter()
                .map(|load| (load.sphere, load.arm, load.force));
            let applied = clump
                .members
                .clone()
                .zip(applied.get(clump.members.clone()).unwrap_or_default());
            let applied = applied.map(|(i, force)| (i, Vec3::zeros(), *force));
            let own = |(i, _, _): &(usize, Vec3, Vec3)| clump.members.contains(i);
            for (i, own, force) in point_loads.filter(own).chain(applied) {
                let arm = kinematics.position[i] - centre + rotation * own;
                external.linear += force;
                external.angular += arm.cross(&force);
            }
        }
        let operator = |rotation, f: fn(f64) -> f64| SpatialOperator {
            linear: Matrix3::identity() * f(shape.mass),
            angular: shape.inertia(rotation, f),
        };
        let momentum = operator(rotation, |inertia| inertia).times(&velocity);
        let here = operator(rotation, f64::recip);
        let ahead = integrator.free(&momentum, &external, dt);
        let middle = turned(&rotation, &here.times(&ahead).angular, 0.5 * dt);
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
            acceleration: here.times(&external.plus(&gyroscopic, 1.0)),
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
    fn acceleration_at(&self, arm: Vec3) -> SpatialVector {
        let spin = self.velocity.angular;
        SpatialVector {
            linear: self.acceleration.at(arm) + spin.cross(&spin.cross(&arm)),
            angular: self.acceleration.angular,
        }
    }

    /// Mass \[kg\] with which it meets an impulse along the unit vector `n` at `arm` \[m\].
    pub(super) fn mass_at(&self, arm: Vec3, n: Vec3) -> f64 {
        let lever = arm.cross(&n);
        let turning = self.clump.shape.inertia(self.rotation, f64::recip);
        1.0 / (1.0 / self.clump.shape.mass + lever.dot(&(turning * lever)))
    }

    /// Where `velocity` leads its centre \[m\] and its axes within `dt` \[s\].
    fn moved(&self, velocity: &SpatialVector, dt: f64) -> (Vec3, UnitQuaternion<f64>) {
        let rotation = turned(&self.rotation, &velocity.angular, dt);
        (self.centre + velocity.linear * dt, rotation)
    }
}

/// Puts clump `c`, which touches nothing, into motion with the velocity that it has at `state.time`, as
/// [`release`](super::external::release) does a sphere.
pub(crate) fn release_clump(scene: &Scene, state: &mut State, c: usize) {
    let clump = &scene.clumps[c];
    let loads = Some((
        state.gravity_at(scene, state.time),
        &state.applied_forces[..],
    ));
    let alone = ClumpPrediction::of(scene, clump, &state.kinematics, loads, scene.settings.step);
    let own = SpatialVector {
        linear: alone.external.linear / clump.shape.mass,
        angular: clump.shape.inertia(alone.rotation, f64::recip) * alone.external.angular,
    };
    for (i, arm) in alone.arms() {
        state.smooth[i] = SpatialVector {
            linear: own.at(arm),
            angular: own.angular,
        };
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

impl Prediction<'_> {
    /// The number of clump `c` among all bodies, `[N + D + C]`.
    pub(super) fn clump_body(&self, c: usize) -> usize {
        self.kinematics.len() + self.bodies.len() + c
    }

    /// The body that moves sphere `i`, of all bodies, and if that is a clump the sphere's centre from its own \[m\].
    #[inline]
    pub(super) fn mover(&self, i: usize) -> (u32, Option<Vec3>) {
        match self.scene.particles.clump(i) {
            None => (i as u32, None),
            Some(c) => {
                let clump = &self.clumps[c];
                let arm = clump.clump.shape.arms[i - clump.clump.members.start];
                (self.clump_body(c) as u32, Some(clump.rotation * arm))
            }
        }
    }

    /// Lets the members in `external`, `[N]`, accelerate with their clumps.
    pub(super) fn accelerate_members(&mut self) {
        for clump in &self.clumps {
            for (i, arm) in clump.arms() {
                self.external[i] = clump.acceleration_at(arm);
            }
        }
    }

    /// Lets the members in `velocity`, `[N + D + C]`, move to where their clumps take them: `(x_k(t + dt) - x_k(t))/dt`.
    pub(super) fn carry_members(&self, velocity: &mut [SpatialVector]) {
        for (c, clump) in self.clumps.iter().enumerate() {
            let own = velocity[self.clump_body(c)];
            let (centre, rotation) = clump.moved(&own, self.step);
            for (i, arm) in clump.clump.members.clone().zip(&clump.clump.shape.arms) {
                let way = centre + rotation * arm - self.kinematics.position[i];
                velocity[i].linear = way / self.step;
                velocity[i].angular = own.angular;
            }
        }
    }

    /// Lets the clumps in `kinematics` turn as `velocity` has them, `[N + D + C]`.
    pub(super) fn turn_members(&self, velocity: &[SpatialVector], kinematics: &mut Kinematics) {
        for (c, clump) in self.clumps.iter().enumerate() {
            let (_, rotation) = clump.moved(&velocity[self.clump_body(c)], self.step);
            kinematics.orientation[clump.clump.members.clone()].fill(rotation);
        }
    }
}

impl Solved<'_> {
    /// Force \[N\] and torque \[N m\] on a clump by gravity, loads and the contacts that are no impacts, which `acceleration`, `[N + D + C]`,
    /// has in its problem.
    fn smooth_force(&self, c: usize, acceleration: &[SpatialVector]) -> SpatialVector {
        let clump = &self.prediction().clumps[c];
        let contacts = clump
            .mass
            .times(&acceleration[self.prediction().clump_body(c)]);
        clump.external.plus(&contacts, 1.0)
    }

    /// Writes what the clumps feel into the smooth `acceleration` of their members at the end of the step, `[N + D + C]`; at its start if
    /// the step does not `move` them.
    pub(super) fn accelerate_clumps(&self, acceleration: &mut [SpatialVector], moves: bool) {
        let prediction = self.prediction();
        for (c, clump) in prediction.clumps.iter().enumerate() {
            let shape = &clump.clump.shape;
            let force = self.smooth_force(c, acceleration);
            let velocity = &self.solution.velocity[prediction.clump_body(c)];
            let rotation = match moves {
                true => clump.moved(velocity, prediction.step).1,
                false => clump.rotation,
            };
            let angular = shape.inertia(rotation, f64::recip) * force.angular;
            let own = SpatialVector {
                linear: force.linear / shape.mass,
                angular,
            };
            for (i, arm) in clump.clump.members.clone().zip(&shape.arms) {
                acceleration[i] = SpatialVector {
                    linear: own.at(rotation * arm),
                    angular,
                };
            }
        }
    }

    /// Moves the clumps: the motion of their members in `state`, whose smooth accelerations are those before, and the numerical work as
    /// for spheres. `smooth` are the accelerations after, `[N]`.
    pub(super) fn advance_clumps(&self, state: &mut State, smooth: &[SpatialVector]) {
        let prediction = self.prediction();
        let (settings, step) = (&prediction.scene.settings, prediction.step);
        let integrator = settings.integrator;
        for (c, clump) in prediction.clumps.iter().enumerate() {
            let (members, shape) = (&clump.clump.members, &clump.clump.shape);
            let first = members.start;
            let v1 = &self.solution.velocity[prediction.clump_body(c)];
            let (centre, rotation) = clump.moved(v1, step);
            let momentum = integrator.finish(
                &clump.momentum,
                &clump.mass.times(v1),
                settings.dynamic_coefficient,
            );
            let after = SpatialVector {
                linear: momentum.linear / shape.mass,
                angular: shape.inertia(rotation, f64::recip) * momentum.angular,
            };
            let kinetic = |rotation, velocity: &SpatialVector, smooth: &SpatialVector| {
                let smooth = clump.clump.of_member(rotation, smooth);
                let reported = integrator.reported(velocity, &smooth, step);
                shape
                    .kinetic_energy(rotation, &reported)
                    .iter()
                    .sum::<f64>()
            };
            let new = kinetic(rotation, &after, &smooth[first]);
            let old = kinetic(clump.rotation, &clump.velocity, &state.smooth[first]);
            state.work.numerical_work += new - old - step * clump.external.dot(v1);
            for (i, arm) in members.clone().zip(&shape.arms) {
                let arm = rotation * arm;
                let kinematics = &mut state.kinematics;
                kinematics.position[i] = centre + arm;
                kinematics.orientation[i] = rotation;
                kinematics.velocity[i] = after.at(arm);
                kinematics.spin[i] = after.angular;
            }
        }
    }
}
