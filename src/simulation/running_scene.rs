//! A running scene: its state, and what can be read of it.

use crate::Vec3;
use crate::contact::Contact;
use crate::detection::configuration::Configuration;
use crate::error::SnapshotError;
use crate::formats::snapshot;
use crate::scene::Scene;
use crate::scene::particles::Kinematics;
use crate::simulation::ReplayRecord;
use crate::spatial::{Pose, Twist, Wrench};
use crate::state::{EnergyLedger, JointState, SharedState, State, StepReport, Velocities};
use crate::step::Workspace;
use std::sync::Arc;

/// A running scene. `Send`, without global state; threads of its own only if the scene asks for them, joined when it goes.
#[derive(Debug)]
pub struct Simulation {
    pub(super) scene: Arc<Scene>,
    pub(super) state: SharedState,
    pub(super) workspace: Workspace,
    /// Where the last communication step came from.
    pub(super) replay: Option<Arc<ReplayRecord>>,
}

impl Simulation {
    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Time \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.state.time
    }

    /// Gravity \[m/s^2\] at [`Self::time`].
    #[must_use]
    pub fn gravity(&self) -> Vec3 {
        self.state.gravity_at(&self.scene, self.state.time)
    }

    /// Complete state as bytes that work in a new process: [`crate::formats::snapshot`].
    #[must_use]
    pub fn snapshot(&self) -> Vec<u8> {
        let velocities = (0..self.state.kinematics.len()).map(|i| self.velocity(i));
        let (velocity, spin) = velocities.map(|v| (v.linear, v.angular)).unzip();
        let reported = Kinematics {
            velocity,
            spin,
            ..self.state.kinematics.clone()
        };
        let radius = &self.scene.particles.radius;
        snapshot::take(&self.scene.hash, radius, &reported, &self.state)
    }

    /// The whole state, read-only.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Positions, orientations and the integrator's own (half-step) velocities.
    #[must_use]
    pub fn kinematics(&self) -> &Kinematics {
        &self.state.kinematics
    }

    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` at [`Self::time`].
    #[must_use]
    pub fn velocity(&self, i: usize) -> Twist {
        self.velocities().reported(i)
    }

    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` half a `simulation.step` before [`Self::time`], or half the first
    /// communication step if that is shorter (integrator `shi`: at that time): between two communication points the momentum of these velocities changes by
    /// weight and loads x time less the [`Self::mean_wrench`]es x time, also where steps were cut.
    #[must_use]
    pub fn half_step_velocity(&self, i: usize) -> Twist {
        self.velocities().half_step(i)
    }

    /// Both, for whichever sphere.
    #[must_use]
    pub fn velocities(&self) -> Velocities<'_> {
        let settings = &self.scene.settings;
        Velocities {
            kinematics: &self.state.kinematics,
            smooth: &self.state.smooth,
            integrator: settings.integrator,
            last: self.state.last_step,
            step: self.state.momentum_step,
        }
    }

    /// Loaded contacts in canonical order: gap and point at [`Self::time`], mean force of the last internal step.
    #[must_use]
    pub fn contacts(&self) -> Vec<Contact> {
        let state = &self.state;
        let placement = Configuration::of(&self.scene, &state.kinematics, &state.poses);
        let loads = state.contacts.iter().enumerate();
        loads
            .map(|(k, load)| {
                placement.contact(load, state.contacts.torque(k), state.contacts.hold(k))
            })
            .collect()
    }

    /// Pose of boundary `b`.
    #[must_use]
    pub fn boundary_pose(&self, b: usize) -> Pose {
        self.state.poses[b]
    }

    /// Twist of boundary `b`: over the last internal step, that of a driven body at [`Self::time`].
    #[must_use]
    pub fn boundary_twist(&self, b: usize) -> Twist {
        let mut bodies = self.scene.driven().zip(&self.state.bodies);
        let driven = bodies.find(|((boundary, _), _)| *boundary == b);
        driven.map_or(self.state.twists[b], |((_, body), carried)| {
            let integrator = self.scene.settings.integrator;
            let (last, smooth) = (self.state.last_step, &carried.smooth);
            let momentum = integrator.reported(&carried.momentum, smooth, last);
            body.twist_of(
                self.scene.boundaries[b].point_of_action,
                &self.state.poses[b],
                &momentum,
            )
        })
    }

    /// Travel of boundary `b`'s joint and the force of its stops and spring; zero unless it is a driven body.
    #[must_use]
    pub fn joint(&self, b: usize) -> JointState {
        let mut bodies = self.scene.driven().zip(&self.state.bodies);
        let driven = bodies.find(|((boundary, _), _)| *boundary == b);
        driven.map_or_else(JointState::default, |(_, carried)| JointState {
            joint_position: carried.joint_position,
            force: carried.joint_forces.iter().sum(),
        })
    }

    /// Velocity \[m/s\] of boundary `b`'s surface against its shape, world axes.
    #[must_use]
    pub fn surface_velocity(&self, b: usize) -> Vec3 {
        let state = &self.state;
        self.scene.boundaries[b].surface_velocity(&state.poses[b], &state.commands[b])
    }

    /// Wrench on boundary `b` over the last internal step.
    #[must_use]
    pub fn wrench(&self, b: usize) -> Wrench {
        self.state.wrenches[b]
    }

    /// Wrench on boundary `b` averaged over the last communication step: impulse / h.
    #[must_use]
    pub fn mean_wrench(&self, b: usize) -> Wrench {
        self.state.mean_wrenches[b]
    }

    /// Weight, inertial forces, point loads and applied forces on all spheres \[N\], averaged over the last communication step:
    /// impulse / h.
    #[must_use]
    pub fn mean_body_force(&self) -> Vec3 {
        self.state.mean_body_force
    }

    /// Report of the last communication step.
    #[must_use]
    pub fn report(&self) -> &StepReport {
        &self.state.report
    }

    /// Work done since t = 0.
    #[must_use]
    pub fn work(&self) -> &EnergyLedger {
        &self.state.work
    }

    pub(super) fn check_counts(&self, state: &State) -> Result<(), SnapshotError> {
        if !state.fits(&self.scene) {
            return Err(SnapshotError::Format(
                "it has other numbers of spheres or boundaries, or another step, than the scene of its hash",
            ));
        }
        if !state.contacts.fits() {
            return Err(SnapshotError::Format(
                "its contacts and their couples differ in number",
            ));
        }
        Ok(())
    }
}
