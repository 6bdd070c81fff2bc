//! The simulation: owns the state, advances it, takes and restores snapshots.

use std::sync::Arc;

use crate::Vec3;
use crate::contacts::Contact;
use crate::error::{SnapshotError, StepError};
use crate::motion::{Command, Pose, Twist};
use crate::particles::Kinematics;
use crate::scene::Scene;

/// Force and torque on a boundary.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct Wrench {
    /// Force \[N\].
    pub force: Vec3,
    /// Torque about the boundary's point of action \[N m\].
    pub torque: Vec3,
}

/// What one communication step cost and reached.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct StepReport {
    /// Internal steps taken, cut ones included.
    pub internal_steps: u64,
    /// Of those, how many came from halving.
    pub cuts: u64,
    /// Gauss-Seidel sweeps.
    pub sweeps: u64,
    /// Augmented-Lagrangian outer iterations.
    pub augmentations: u64,
    /// Factorizations (open-close iterations).
    pub factorizations: u64,
    /// Largest true overlap over radius at the end of any internal step \[-\].
    pub max_overlap: f64,
    /// Largest slip residual \[-\].
    pub slip_residual: f64,
    /// Largest force residual \[-\].
    pub force_residual: f64,
}

/// A running scene. Send, no global state, no threads of its own.
pub struct Simulation {
    scene: Arc<Scene>,
}

impl Simulation {
    /// Removes small initial overlaps, solves the contact forces at t = 0.
    ///
    /// # Errors
    /// If the initial contact problem has no solution.
    pub fn new(scene: Arc<Scene>) -> Result<Self, StepError> {
        todo!()
    }
    /// The scene.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }
    /// Time \[s\].
    pub fn time(&self) -> f64 {
        todo!()
    }
    /// Sets gravity \[m/s^2\] from now on.
    pub fn set_gravity(&mut self, gravity: Vec3) {
        todo!()
    }
    /// Gravity \[m/s^2\].
    pub fn gravity(&self) -> Vec3 {
        todo!()
    }
    /// Command for a boundary with `Motion::Input`, held until the next one.
    pub fn command(&mut self, boundary: usize, command: Command) -> Result<(), StepError> {
        todo!()
    }
    /// Places every input boundary at its commanded pose, without velocity, and solves the initial
    /// contact forces anew. Only before the first step.
    pub fn place(&mut self) -> Result<(), StepError> {
        todo!()
    }
    /// Advances to exactly `time() + h` in equal internal steps. On error the state is as before the call.
    pub fn advance(&mut self, h: f64) -> Result<StepReport, StepError> {
        todo!()
    }
    /// Complete state: magic, version, scene hash, length, checksum. Works in a new process.
    pub fn snapshot(&self) -> Vec<u8> {
        todo!()
    }
    /// Restores a [`Self::snapshot`] of the same scene.
    pub fn restore(&mut self, blob: &[u8]) -> Result<(), SnapshotError> {
        todo!()
    }
    /// Positions, orientations and the integrator's own (half-step) velocities.
    pub fn kinematics(&self) -> &Kinematics {
        todo!()
    }
    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` at `time()`: the reported ones.
    pub fn velocity(&self, i: usize) -> Twist {
        todo!()
    }
    /// Candidate contacts at `time()` in canonical order; `force` is the mean of the last internal step.
    pub fn contacts(&self) -> &[Contact] {
        todo!()
    }
    /// Pose of a boundary.
    pub fn boundary_pose(&self, b: usize) -> Pose {
        todo!()
    }
    /// Twist of a boundary over the last internal step.
    pub fn boundary_twist(&self, b: usize) -> Twist {
        todo!()
    }
    /// Wrench on a boundary over the last internal step.
    pub fn wrench(&self, b: usize) -> Wrench {
        todo!()
    }
    /// Wrench on a boundary averaged over the last communication step: impulse / h.
    pub fn mean_wrench(&self, b: usize) -> Wrench {
        todo!()
    }
    /// Report of the last communication step.
    pub fn report(&self) -> &StepReport {
        todo!()
    }
}
