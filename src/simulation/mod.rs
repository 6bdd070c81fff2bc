//! The simulation: owns the state, advances it (`communication`), takes and restores snapshots.

mod applied_forces;
mod command_motion;
mod communication_step;
mod derivatives;
mod exchange;
mod explain;
pub mod flow;
mod impulse_totals;
mod replay_record;
mod running_scene;
mod saved;
mod settle;
mod start;
mod step_control;
mod step_plan;
pub mod trajectory;
mod tune;

use std::borrow::Cow;
use std::sync::Arc;

use crate::Vec3;
use crate::error::{SnapshotError, StepError};
use crate::formats::snapshot;
use crate::problem::{Impulses, Problem};
use crate::scene::gravity::GravityMotion;
use crate::scene::{Boundary, Command, CommandDerivatives, InputKind, Scene};
use crate::simulation::trajectory::BoundaryPaths;
use crate::spatial::{Pose, SpatialVector, Wrench};
use crate::state::{
    BodyState, EnergyLedger, Reserve, SharedState, State, StepControl, StepReport, Walls,
};
use crate::step::{FailedStep, StepInput, Workspace, initial_forces, remove_overlaps};
pub use communication_step::CommunicationStep;
pub use derivatives::Direction;
pub use replay_record::ReplayRecord;
pub use running_scene::Simulation;
pub use saved::Saved;
pub use settle::{Fastest, Pass, PassKind, Settle, SettleError, SettleProgress, Settled};

impl Simulation {
    /// Removes small initial overlaps and solves the contact forces at t = 0.
    ///
    /// # Errors
    /// [`StepError`] if the initial overlaps cannot be removed or the initial contact problem cannot be solved.
    pub fn new(scene: Arc<Scene>) -> Result<Self, StepError> {
        let settings = &scene.settings;
        let n = scene.particles.len();
        let lightest = scene
            .particles
            .mass
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        let boundaries = scene.boundaries.len();
        let pose_at = |t: f64| -> Vec<Pose> {
            scene
                .boundaries
                .iter()
                .map(|b| b.motion.pose_at(t))
                .collect()
        };
        // The step before the first: a boundary that starts from rest does not hit the spheres with the speed of its first step.
        let (poses, previous) = (pose_at(0.0), pose_at(-settings.step));
        let state = State {
            time: 0.0,
            last_step: 0.0,
            gravity: settings.gravity,
            kinematics: scene.initial.clone(),
            smooth: vec![SpatialVector::ZERO; n],
            external: Vec::new(),
            applied_forces: Vec::new(),
            body_force: Vec3::zeros(),
            mean_body_force: Vec3::zeros(),
            contacts: scene.initial_contacts.clone(),
            springs: vec![Vec3::zeros(); scene.springs.len()],
            twists: poses
                .iter()
                .zip(&previous)
                .map(|(now, before)| before.twist_to(now, settings.step))
                .collect(),
            poses,
            bodies: BodyState::initial(&scene),
            commands: scene.boundaries.iter().map(Boundary::rest).collect(),
            rates: Vec::new(),
            wrenches: vec![Wrench::default(); boundaries],
            smooth_wrenches: vec![Wrench::default(); boundaries],
            mean_wrenches: vec![Wrench::default(); boundaries],
            owed: vec![Wrench::default(); boundaries],
            walls: Walls::of(&scene),
            broken_bonds: 0,
            work: EnergyLedger::default(),
            reserves: reserves(&scene),
            emitted: vec![0.0; scene.sources.len()],
            removed: vec![0.0; scene.sinks.len()],
            passed: vec![0.0; scene.sensors.len()],
            flow: vec![0.0; scene.sensors.len()],
            initial_overlap: 0.0,
            // One mass over dt^2: the penalty at which one augmentation halves a free contact's gap.
            penalty: settings
                .penalty
                .unwrap_or(lightest / (settings.step * settings.step)),
            report: StepReport::default(),
            control: StepControl::of(settings),
            momentum_step: settings.step.min(settings.communication_step),
            calm: Vec::new(),
            ground: Vec::new(),
        };
        let mut simulation = Self {
            scene,
            state: SharedState::new(state),
            workspace: Workspace::default(),
            replay: None,
        };
        simulation.settle_start()?;
        Ok(simulation)
    }

    /// Overlaps out by displacement, then contact forces at rest.
    fn settle_start(&mut self) -> Result<(), StepError> {
        let scene = Arc::clone(&self.scene);
        let unsettled = self.state.clone();
        let (state, workspace) = (&mut self.state, &mut self.workspace);
        remove_overlaps(&scene, state, workspace)
            .and_then(|()| initial_forces(&scene, state, workspace))
            .map_err(|failure| self.explain(failure, scene.settings.step, 0))?;
        let state = &mut *self.state;
        state.mean_wrenches.clone_from(&state.wrenches);
        self.replay = Some(Arc::new(ReplayRecord::Start(unsettled)));
        Ok(())
    }

    /// Sets gravity \[m/s^2\] from now on; one that rotates goes on to do so from this vector at t = 0. A step that begins
    /// now feels it from half a step ago (integrator `moreau`).
    ///
    /// # Errors
    /// [`StepError::Argument`] if it is NaN or beyond [`LARGEST`], or given by a table.
    pub fn set_gravity(&mut self, gravity: Vec3) -> Result<(), StepError> {
        bounded("gravity", gravity.iter())?;
        let table = matches!(
            self.scene.settings.gravity_motion,
            GravityMotion::Table { .. }
        );
        if table && gravity != self.state.gravity {
            return Err(StepError::Argument {
                what: "gravity",
                found: format!("{:?}", gravity.as_slice()),
                expected: "none: simulation.gravity_motion.table of the scene gives it",
            });
        }
        let before = self.gravity();
        if gravity != self.state.gravity {
            self.state.wake();
        }
        self.state.gravity = gravity;
        // Before the first step the start is chosen, no work is done.
        if self.state.last_step > 0.0 {
            let change = self.gravity() - before;
            let at = self.state.kinematics.position.clone();
            self.state.lift(&self.scene, &at, change);
            let heavy = self.scene.driven().filter(|(_, body)| body.gravity);
            let moments = heavy.map(|(b, body)| {
                let pose = &self.state.poses[b];
                self.scene.boundaries[b].from_frame(pose, body.centre) * body.mass
            });
            self.state.work.gravity -= moments.sum::<Vec3>().dot(&change);
        }
        Ok(())
    }

    /// Command for boundary `b`, which has a [`crate::scene::Motion::input`] or a belt driven from outside; held until the
    /// next one.
    ///
    /// # Errors
    /// [`StepError::Argument`] if the boundary is no input or a component is NaN or beyond [`LARGEST`];
    /// [`StepError::Orientation`] if that of a world pose is no unit quaternion.
    pub fn command(&mut self, b: usize, command: Command) -> Result<(), StepError> {
        self.command_along(b, command, CommandDerivatives::default())
    }

    /// As [`Self::command`], for a command that changes within the next communication step: `s` after the beginning of that
    /// step it is `u + u' s + u'' s^2/2`, and after it `u` again. A pose follows this without lag; what it misses at the
    /// beginning is closed linearly over the step.
    ///
    /// # Errors
    /// As [`Self::command`].
    pub fn command_along(
        &mut self,
        b: usize,
        command: Command,
        rates: CommandDerivatives,
    ) -> Result<(), StepError> {
        let boundary = self.scene.boundaries.get(b);
        let Some(boundary) = boundary.filter(|boundary| boundary.is_commanded()) else {
            return Err(StepError::Argument {
                what: "boundary",
                found: b.to_string(),
                expected: "the index of a boundary with `input`, `surface_input` or `servo.input`",
            });
        };
        for part in [&command, &rates[0], &rates[1]] {
            let vectors = [
                part.translation,
                part.rotation,
                part.position,
                part.velocity,
                part.angular_velocity,
                part.surface_velocity,
                part.force,
                part.torque,
            ];
            let components = vectors.iter().flat_map(|v| v.iter());
            let orientation = part.orientation.coords.iter();
            let others = orientation.chain([&part.scalar, &part.pressure]);
            bounded("command", components.chain(others))?;
        }
        let q = command.orientation;
        let is_unit = (q.norm() - 1.0).abs() <= LENGTH_TOLERANCE;
        if matches!(boundary.motion.input(), Some(InputKind::WorldPose { .. })) && !is_unit {
            return Err(StepError::Orientation {
                boundary: boundary.name.clone(),
                found: [q.w, q.i, q.j, q.k],
                length: q.norm(),
            });
        }
        let state = &mut self.state;
        state.commands[b] = command;
        if rates != CommandDerivatives::default() && state.rates.is_empty() {
            state.rates = vec![CommandDerivatives::default(); state.commands.len()];
        }
        if let Some(place) = state.rates.get_mut(b) {
            *place = rates;
        }
        Ok(())
    }

    /// Places every input boundary at its commanded pose, without velocity, and solves the contact forces
    /// anew. Meant for before the first step.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn place(&mut self) -> Result<(), StepError> {
        self.state.place(&self.scene);
        self.settle_start()
    }

    /// Advances by `h` \[s\]; see [`Self::advance_to`].
    ///
    /// # Errors
    /// As [`Self::advance_to`].
    pub fn advance(&mut self, h: f64) -> Result<StepReport, StepError> {
        self.advance_to(self.state.time + h)
    }

    /// Advances to exactly `end` \[s\] in equal internal steps of at most `simulation.step`. A step that does
    /// not meet the tolerances is halved, at most `max_cuts` times. On error the state is as before the call, but for
    /// its [`Self::replay_record`], whose memory a step takes that has begun: [`Self::begin`] keeps it.
    ///
    /// # Errors
    /// [`StepError`] with time, contact and residual.
    pub fn advance_to(&mut self, end: f64) -> Result<StepReport, StepError> {
        let communication = self.set_out(end, false)?;
        self.finish(communication)?;
        Ok(self.state.report)
    }

    /// The problem that an internal step of `dt` \[s\] from here begins with, and the impulses \[N s\] that the solver
    /// would start from: for the study of solvers. Commands count as reached at the end of `dt`.
    ///
    /// # Errors
    /// [`StepError::Argument`] if `dt` is not a finite time > 0.
    pub fn problem(&self, dt: f64) -> Result<(Problem, Impulses), StepError> {
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(StepError::Argument {
                what: "step",
                found: format!("{dt} s"),
                expected: "a finite time > 0",
            });
        }
        let (state, end) = (&self.state, self.state.time + dt);
        let boundaries = &self.scene.boundaries;
        let commands = (&state.commands[..], &state.rates[..]);
        let paths = BoundaryPaths::new(boundaries, commands, &state.poses, state.time, end);
        let input = StepInput {
            dt,
            poses: paths.poses(end),
            commands: Cow::Borrowed(&state.commands),
        };
        Ok(crate::step::problem(&self.scene, state, &input))
    }

    /// Keeps the problems of internal steps that fail or end unconverged from now on, `most` of them: for the study of solvers.
    /// Steps that are cut afterwards count as well. Nothing else changes.
    pub fn keep_failed_steps(&mut self, most: usize) {
        self.workspace.failed.keep(most);
    }

    /// The steps kept since the last call ([`Self::keep_failed_steps`]), and how many more there were in all.
    pub fn take_failed_steps(&mut self) -> (Vec<FailedStep>, u64) {
        self.workspace.failed.take()
    }

    /// Restores a [`Self::snapshot`] of the same scene.
    ///
    /// # Errors
    /// [`SnapshotError`] if the bytes are damaged or belong to another scene or version; the state is unchanged.
    pub fn restore(&mut self, blob: &[u8]) -> Result<(), SnapshotError> {
        let state: State = snapshot::restore(blob, &self.scene.hash)?;
        self.check_counts(&state)?;
        self.state = SharedState::new(state);
        self.replay = None;
        Ok(())
    }
}

/// Largest size of what is commanded, as of every number of a scene file: squares and products of it are still numbers.
pub const LARGEST: f64 = 1e30;

/// How far the length of a commanded quaternion may be from 1: far above the rounding of single precision and the drift of
/// integrators, far below what is no quaternion. Chords between quaternions up to 32 degrees apart stay within it.
const LENGTH_TOLERANCE: f64 = 0.01;

/// Whether all of what is commanded can be computed with.
fn bounded<'a>(what: &'static str, values: impl Iterator<Item = &'a f64>) -> Result<(), StepError> {
    for value in values {
        // NaN is not within any bounds.
        if !(-LARGEST..=LARGEST).contains(value) {
            return Err(StepError::Argument {
                what,
                found: format!("{value:e}"),
                expected: "numbers from -1e30 to 1e30",
            });
        }
    }
    Ok(())
}

/// All sources before the start.
fn reserves(scene: &Scene) -> Vec<Reserve> {
    let sources = scene.sources.iter();
    sources
        .map(|source| Reserve {
            waiting: source
                .spheres
                .clone()
                .filter(|&i| !scene.initial.present[i] && scene.grain(i).start == i)
                .map(|i| i as u32)
                .collect(),
            ..Reserve::default()
        })
        .collect()
}
