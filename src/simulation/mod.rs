//! The simulation: owns the state, advances it (`march`), takes and restores snapshots.

mod derivatives;
pub mod drive;
mod exchange;
mod explain;
pub mod flow;
mod march;
mod pace;
mod settle;
mod start;

use std::sync::Arc;

use crate::Vec3;
use crate::contact::Contact;
use crate::detection::narrow_phase::Placement;
use crate::error::{SnapshotError, StepError};
use crate::formats::snapshot;
use crate::problem::{Impulses, Problem};
use crate::scene::gravity::GravityMotion;
use crate::scene::particles::Kinematics;
use crate::scene::{Boundary, Command, Rates, Scene};
use crate::simulation::drive::Drive;
use crate::spatial::{Dof6, Pose, Twist, Wrench};
use crate::state::{BodyState, JointState, Pace, State, StepReport, Velocities, Work};
use crate::step::{Scratch, initial_forces, remove_overlaps};
pub use derivatives::{Direction, Origin};
pub use march::March;
pub use settle::{Pass, PassKind, Settle, SettleError, SettleProgress, Settled};

/// A running scene. `Send`, without global state; threads of its own only if the scene asks for them, joined when it goes.
#[derive(Debug)]
pub struct Simulation {
    scene: Arc<Scene>,
    state: State,
    scratch: Scratch,
    /// Where the last communication step came from.
    origin: Option<Box<Origin>>,
}

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
        // The step before the first: a wall that starts from rest does not meet the spheres with its first step's speed.
        let (poses, previous) = (pose_at(0.0), pose_at(-settings.step));
        let state = State {
            time: 0.0,
            last_step: 0.0,
            gravity: settings.gravity,
            kinematics: scene.initial.clone(),
            persisting: vec![Dof6::ZERO; n],
            external: Vec::new(),
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
            persisting_wrenches: vec![Wrench::default(); boundaries],
            mean_wrenches: vec![Wrench::default(); boundaries],
            owed: vec![Wrench::default(); boundaries],
            work: Work::default(),
            reserves: exchange::reserves(&scene),
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
            pace: Pace::of(settings),
        };
        let mut simulation = Self {
            scene,
            state,
            scratch: Scratch::default(),
            origin: None,
        };
        simulation.settle_start()?;
        Ok(simulation)
    }

    fn settle_start(&mut self) -> Result<(), StepError> {
        let unsettled = self.state.clone();
        self.settle_beside(&mut [])?;
        self.origin = Some(Box::new(Origin::Start(unsettled)));
        Ok(())
    }

    /// Overlaps out by displacement, then contact forces at rest; so also in `pairs` of states to either side.
    fn settle_beside(&mut self, pairs: &mut [[&mut State; 2]]) -> Result<(), StepError> {
        let scene = Arc::clone(&self.scene);
        let Self { state, scratch, .. } = self;
        remove_overlaps(&scene, state, scratch, pairs)
            .and_then(|()| initial_forces(&scene, state, scratch, pairs))
            .map_err(|failure| self.explain(failure, scene.settings.step, 0))?;
        let both = pairs.iter_mut().flatten().map(|state| &mut **state);
        for state in both.chain([&mut self.state]) {
            state.mean_wrenches.clone_from(&state.wrenches);
        }
        Ok(())
    }

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

    /// Sets gravity \[m/s^2\] from now on; one that rotates goes on to do so from this vector at t = 0. A step that begins
    /// now feels it from half a step ago (integrator `moreau`).
    ///
    /// # Errors
    /// [`StepError::Argument`] if it is not finite, or given by a table.
    pub fn set_gravity(&mut self, gravity: Vec3) -> Result<(), StepError> {
        finite("gravity", gravity.iter())?;
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
        self.state.gravity = gravity;
        self.state.pace.calm = 0;
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
    /// [`StepError::Argument`] if the boundary is no input or a component is not finite.
    pub fn command(&mut self, b: usize, command: Command) -> Result<(), StepError> {
        self.command_along(b, command, Rates::default())
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
        rates: Rates,
    ) -> Result<(), StepError> {
        let boundary = self.scene.boundaries.get(b);
        if !boundary.is_some_and(Boundary::is_commanded) {
            return Err(StepError::Argument {
                what: "boundary",
                found: b.to_string(),
                expected: "the index of a boundary with `input`, `surface_input` or `servo.input`",
            });
        }
        for part in [&command, &rates[0], &rates[1]] {
            let vectors = [
                part.translation,
                part.rotation,
                part.velocity,
                part.angular_velocity,
                part.surface_velocity,
                part.force,
                part.torque,
            ];
            let components = vectors.iter().flat_map(|v| v.iter());
            finite("command", components.chain([&part.scalar, &part.pressure]))?;
        }
        let state = &mut self.state;
        state.commands[b] = command;
        if rates != Rates::default() && state.rates.is_empty() {
            state.rates = vec![Rates::default(); state.commands.len()];
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
    /// its [`Self::origin`], whose memory a step takes that has begun: [`Self::begin`] keeps it.
    ///
    /// # Errors
    /// [`StepError`] with time, contact and residual.
    pub fn advance_to(&mut self, end: f64) -> Result<StepReport, StepError> {
        let march = self.set_out(end, false)?;
        self.finish(march)?;
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
        let drive = Drive::new(boundaries, commands, &state.poses, state.time, end);
        let poses = drive.poses(end);
        Ok(crate::step::problem(&self.scene, state, dt, &poses))
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

    /// Restores a [`Self::snapshot`] of the same scene.
    ///
    /// # Errors
    /// [`SnapshotError`] if the bytes are damaged or belong to another scene or version; the state is unchanged.
    pub fn restore(&mut self, blob: &[u8]) -> Result<(), SnapshotError> {
        let state: State = snapshot::restore(blob, &self.scene.hash)?;
        self.check_counts(&state)?;
        self.state = state;
        self.origin = None;
        Ok(())
    }

    fn check_counts(&self, state: &State) -> Result<(), SnapshotError> {
        let counts = [
            state.kinematics.len(),
            state.poses.len(),
            state.bodies.len(),
        ];
        let scene = &self.scene;
        let driven = scene.driven().count();
        if counts != [scene.particles.len(), scene.boundaries.len(), driven] {
            return Err(SnapshotError::Format(
                "it has other numbers of spheres or boundaries than the scene of its hash",
            ));
        }
        if !state.contacts.fits() {
            return Err(SnapshotError::Format(
                "its contacts and their couples differ in number",
            ));
        }
        Ok(())
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

    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` half a `simulation.step` before [`Self::time`]
    /// (integrator `shi`: at that time): between two communication points the momentum of these velocities changes by
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
            persisting: &self.state.persisting,
            integrator: settings.integrator,
            last: self.state.last_step,
            step: settings.step,
        }
    }

    /// Loaded contacts in canonical order: gap and point at [`Self::time`], mean force of the last internal step.
    #[must_use]
    pub fn contacts(&self) -> Vec<Contact> {
        let state = &self.state;
        let placement = Placement::of(&self.scene, &state.kinematics, &state.poses);
        let loads = state.contacts.iter().enumerate();
        loads
            .map(|(k, load)| placement.contact(load, state.contacts.torque(k)))
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
            let (last, persisting) = (self.state.last_step, &carried.persisting);
            let momentum = integrator.reported(&carried.momentum, persisting, last);
            body.twist_of(&self.scene.boundaries[b], &self.state.poses[b], &momentum)
        })
    }

    /// Travel of boundary `b`'s joint and the force of its stops and spring; zero unless it is a driven body.
    #[must_use]
    pub fn joint(&self, b: usize) -> JointState {
        let mut bodies = self.scene.driven().zip(&self.state.bodies);
        let driven = bodies.find(|((boundary, _), _)| *boundary == b);
        driven.map_or_else(JointState::default, |(_, carried)| JointState {
            travel: carried.travel,
            force: carried.holds.iter().sum(),
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

    /// Weight, inertial forces and point loads on all spheres \[N\], averaged over the last communication step: impulse / h.
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
    pub fn work(&self) -> &Work {
        &self.state.work
    }
}

fn finite<'a>(what: &'static str, values: impl Iterator<Item = &'a f64>) -> Result<(), StepError> {
    for value in values {
        if !value.is_finite() {
            return Err(StepError::Argument {
                what,
                found: value.to_string(),
                expected: "finite numbers",
            });
        }
    }
    Ok(())
}
