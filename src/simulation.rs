//! The simulation: owns the state, advances it, takes and restores snapshots.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::contacts::{Contact, Key, Partner};
use crate::drive::{Drive, displacement, target};
use crate::error::{SnapshotError, StepError};
use crate::motion::{Command, Motion, Pose, Twist};
use crate::observe::sensors::{Plane, crossings};
use crate::particles::Kinematics;
use crate::problem::Dof6;
use crate::scene::{Integrator, Measure, Scene};
use crate::state::{State, Work, from_blob, to_blob};
use crate::step::{Scratch, StepFailure, StepOutcome, initial_forces, step};

/// Force and torque on a boundary.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Wrench {
    /// Force \[N\].
    pub force: Vec3,
    /// Torque about the boundary's point of action \[N m\].
    pub torque: Vec3,
}

impl Wrench {
    /// Adds `scale * other`.
    pub fn add(&mut self, other: &Self, scale: f64) {
        self.force += other.force * scale;
        self.torque += other.torque * scale;
    }
}

/// What one communication step cost and reached.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct StepReport {
    /// Internal steps taken, cut ones included.
    pub internal_steps: u64,
    /// How often a step was halved.
    pub cuts: u64,
    /// Gauss-Seidel sweeps.
    pub sweeps: u64,
    /// Multiplier updates of the augmented-Lagrangian loop.
    pub augmentations: u64,
    /// Factorizations (open-close iterations).
    pub factorizations: u64,
    /// Largest true overlap over radius at the end of any internal step \[-\].
    pub max_overlap: f64,
    /// Largest gap residual of any solve \[-\].
    pub gap_residual: f64,
    /// Largest slip residual \[-\].
    pub slip_residual: f64,
    /// Largest force residual \[-\].
    pub force_residual: f64,
}

impl StepReport {
    fn include(&mut self, outcome: &StepOutcome) {
        let solver = &outcome.solver;
        self.internal_steps += 1;
        self.sweeps += solver.sweeps as u64;
        self.augmentations += solver.augmentations as u64;
        self.factorizations += solver.factorizations as u64;
        self.max_overlap = self.max_overlap.max(outcome.max_overlap);
        self.gap_residual = self.gap_residual.max(solver.residual.gap);
        self.slip_residual = self.slip_residual.max(solver.residual.slip);
        self.force_residual = self.force_residual.max(solver.residual.force);
    }
}

/// A running scene. `Send`, without global state and without threads of its own.
#[derive(Debug)]
pub struct Simulation {
    scene: Arc<Scene>,
    state: State,
    scratch: Scratch,
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
        let (poses, next) = (pose_at(0.0), pose_at(settings.step));
        let state = State {
            time: 0.0,
            last_step: 0.0,
            gravity: settings.gravity,
            kinematics: scene.initial.clone(),
            persisting: vec![Dof6::ZERO; n],
            contacts: Vec::new(),
            springs: vec![Vec3::zeros(); scene.springs.len()],
            twists: poses
                .iter()
                .zip(&next)
                .map(|(a, b)| a.twist_to(b, settings.step))
                .collect(),
            poses,
            commands: vec![Command::default(); boundaries],
            wrenches: vec![Wrench::default(); boundaries],
            persisting_wrenches: vec![Wrench::default(); boundaries],
            mean_wrenches: vec![Wrench::default(); boundaries],
            work: Work::default(),
            passed: vec![0.0; scene.sensors.len()],
            flow: vec![0.0; scene.sensors.len()],
            initial_overlap: 0.0,
            // One mass over dt^2: the penalty at which one augmentation halves a free contact's gap.
            penalty: settings
                .penalty
                .unwrap_or(lightest / (settings.step * settings.step)),
            report: StepReport::default(),
        };
        let mut simulation = Self {
            scene,
            state,
            scratch: Scratch::default(),
        };
        simulation.settle_start()?;
        Ok(simulation)
    }

    /// Overlaps out by displacement, then contact forces at rest.
    fn settle_start(&mut self) -> Result<(), StepError> {
        let scene = Arc::clone(&self.scene);
        crate::step::remove_overlaps(&scene, &mut self.state, &mut self.scratch)
            .and_then(|()| initial_forces(&scene, &mut self.state, &mut self.scratch))
            .map_err(|failure| self.explain(failure, scene.settings.step, 0))?;
        self.state.mean_wrenches.clone_from(&self.state.wrenches);
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

    /// Gravity \[m/s^2\].
    #[must_use]
    pub fn gravity(&self) -> Vec3 {
        self.state.gravity
    }

    /// Sets gravity \[m/s^2\] from now on.
    ///
    /// # Errors
    /// [`StepError::Argument`] if it is not finite.
    pub fn set_gravity(&mut self, gravity: Vec3) -> Result<(), StepError> {
        finite("gravity", gravity.iter())?;
        self.state.gravity = gravity;
        Ok(())
    }

    /// Command for boundary `b`, whose motion is [`Motion::Input`]; held until the next one.
    ///
    /// # Errors
    /// [`StepError::Argument`] if the boundary is no input or a component is not finite.
    pub fn command(&mut self, b: usize, command: Command) -> Result<(), StepError> {
        let motion = self
            .scene
            .boundaries
            .get(b)
            .map(|boundary| &boundary.motion);
        if !matches!(motion, Some(Motion::Input(_))) {
            return Err(StepError::Argument {
                what: "boundary",
                found: b.to_string(),
                expected: "the index of a boundary with `input`",
            });
        }
        let vectors = [
            command.translation,
            command.rotation,
            command.velocity,
            command.angular_velocity,
        ];
        finite(
            "command",
            vectors
                .iter()
                .flat_map(|v| v.iter())
                .chain([&command.scalar]),
        )?;
        self.state.commands[b] = command;
        Ok(())
    }

    /// Places every input boundary at its commanded pose, without velocity, and solves the contact forces
    /// anew. Meant for before the first step.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn place(&mut self) -> Result<(), StepError> {
        for (b, boundary) in self.scene.boundaries.iter().enumerate() {
            if let Motion::Input(kind) = boundary.motion {
                if let Some(pose) = target(kind, &self.state.commands[b]) {
                    self.state.poses[b] = pose;
                }
                self.state.twists[b] = Twist::default();
            }
        }
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
    /// not meet the tolerances is halved, at most `max_cuts` times. On error the state is as before the call.
    ///
    /// # Errors
    /// [`StepError`] with time, contact and residual.
    pub fn advance_to(&mut self, end: f64) -> Result<StepReport, StepError> {
        let start = self.state.time;
        let h = end - start;
        if !(h > 0.0 && h.is_finite()) {
            return Err(StepError::Argument {
                what: "communication step",
                found: format!("{h} s"),
                expected: "a finite time after the current one",
            });
        }
        let before = self.state.clone();
        let result = self.march(start, end);
        if result.is_err() {
            self.state = before;
        }
        result
    }

    fn march(&mut self, start: f64, end: f64) -> Result<StepReport, StepError> {
        let scene = Arc::clone(&self.scene);
        let h = end - start;
        // The margin keeps a communication step that is n internal steps but for rounding at n.
        let steps = (h / scene.settings.step * (1.0 - 1e-9)).ceil().max(1.0) as u64;
        let drive = Drive::new(
            &scene.boundaries,
            &self.state.commands,
            &self.state.poses,
            start,
            end,
        );
        self.check_jump(&drive, start, end, steps)?;
        self.state.report = StepReport::default();
        let passed = self.state.passed.clone();
        let mut impulse = vec![Wrench::default(); scene.boundaries.len()];
        for k in 1..=steps {
            let target = if k == steps {
                end
            } else {
                start + h * (k as f64 / steps as f64)
            };
            self.step_to(&scene, &drive, target, 0, &mut impulse)?;
        }
        for (mean, impulse) in self.state.mean_wrenches.iter_mut().zip(&impulse) {
            mean.force = impulse.force / h;
            mean.torque = impulse.torque / h;
        }
        let totals = self.state.passed.iter().zip(&passed);
        self.state.flow = totals.map(|(now, then)| (now - then) / h).collect();
        Ok(self.state.report)
    }

    /// One internal step to `target`, or two half steps if it fails.
    fn step_to(
        &mut self,
        scene: &Scene,
        drive: &Drive,
        target: f64,
        cuts: u32,
        impulse: &mut [Wrench],
    ) -> Result<(), StepError> {
        let start = self.state.time;
        let dt = target - start;
        let before = self.state.kinematics.position.clone();
        let persisting = self.state.persisting_wrenches.clone();
        match step(
            scene,
            &mut self.state,
            &mut self.scratch,
            dt,
            drive.poses(target),
        ) {
            Ok(outcome) => {
                self.state.time = target;
                self.state.report.include(&outcome);
                self.check_finite()?;
                let shift = self.shift(dt);
                for (b, sum) in impulse.iter_mut().enumerate() {
                    sum.add(&self.state.wrenches[b], dt);
                    // A step of another length moves the half step by persisting forces: their share.
                    sum.add(&self.state.persisting_wrenches[b], shift);
                    sum.add(&persisting[b], -shift);
                }
                self.count_crossings(&before);
                Ok(())
            }
            Err(failure) if cuts >= scene.settings.max_cuts => Err(self.explain(failure, dt, cuts)),
            Err(_) => {
                self.state.report.cuts += 1;
                let half = start + 0.5 * dt;
                self.step_to(scene, drive, half, cuts + 1, impulse)?;
                self.step_to(scene, drive, target, cuts + 1, impulse)
            }
        }
    }

    /// Time \[s\] by which the half step after a step of `dt` lies earlier than half a `simulation.step` before its end.
    fn shift(&self, dt: f64) -> f64 {
        match self.scene.settings.integrator {
            Integrator::Moreau => 0.5 * (dt - self.scene.settings.step),
            Integrator::Shi => 0.0,
        }
    }

    fn count_crossings(&mut self, before: &[Vec3]) {
        for (sensor, passed) in self.scene.sensors.iter().zip(&mut self.state.passed) {
            if let Measure::MassFlow { point, normal } = sensor.measure {
                let after = &self.state.kinematics.position;
                *passed += crossings(
                    before,
                    after,
                    &self.scene.particles.mass,
                    Plane { point, normal },
                );
            }
        }
    }

    fn check_finite(&self) -> Result<(), StepError> {
        let kinematics = &self.state.kinematics;
        for sphere in 0..kinematics.len() {
            let kinds = [
                ("position", kinematics.position[sphere]),
                ("velocity", kinematics.velocity[sphere]),
                ("angular velocity", kinematics.spin[sphere]),
            ];
            for (what, value) in kinds {
                if !value.iter().all(|x| x.is_finite()) {
                    return Err(StepError::NotFinite {
                        time: self.state.time,
                        sphere,
                        what,
                    });
                }
            }
        }
        Ok(())
    }

    /// An input boundary must not move farther than the smallest radius in one internal step.
    fn check_jump(&self, drive: &Drive, start: f64, end: f64, steps: u64) -> Result<(), StepError> {
        let limit = self
            .scene
            .particles
            .radius
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        let poses = drive.poses(start + (end - start) / steps as f64);
        for ((boundary, from), to) in self
            .scene
            .boundaries
            .iter()
            .zip(&self.state.poses)
            .zip(&poses)
        {
            if !matches!(boundary.motion, Motion::Input(_)) || from == to {
                continue;
            }
            let jump = displacement(boundary, from, to);
            if jump > limit {
                return Err(StepError::Jump {
                    boundary: boundary.name.clone(),
                    jump,
                    limit,
                });
            }
        }
        Ok(())
    }

    /// A failure in the scene's words.
    fn explain(&self, failure: StepFailure, step: f64, cuts: u32) -> StepError {
        let time = self.state.time;
        if let Some(key) = failure.contact
            && let Some(boundaries) = self.pinch(key)
        {
            return StepError::Pinched {
                time,
                sphere: key.sphere as usize,
                boundaries,
            };
        }
        let contact = failure.contact.map_or_else(
            || "the re-linearised gaps".to_owned(),
            |key| match key.partner {
                Partner::Sphere(j) => format!("spheres {} and {j}", key.sphere),
                Partner::Boundary { boundary, .. } => format!(
                    "sphere {} on boundary `{}`",
                    key.sphere,
                    self.scene.boundaries[usize::from(boundary)].name
                ),
            },
        );
        StepError::NotConverged {
            time,
            step,
            what: failure.what,
            residual: failure.residual,
            tolerance: failure.tolerance,
            contact,
            cuts,
        }
    }

    /// Whether the sphere of `key` sits between rigid boundaries that close on it; their names.
    fn pinch(&self, key: Key) -> Option<String> {
        let normals: Vec<(u16, Vec3)> = self
            .state
            .contacts
            .iter()
            .filter(|c| c.key.sphere == key.sphere)
            .filter_map(|c| match c.key.partner {
                Partner::Boundary { boundary, .. } => Some((boundary, c.normal)),
                Partner::Sphere(_) => None,
            })
            .filter(|(b, _)| self.scene.boundaries[usize::from(*b)].stiffness.is_none())
            .collect();
        let (first, second) = normals.iter().enumerate().find_map(|(k, (a, n))| {
            normals[k + 1..]
                .iter()
                .find(|(_, m)| n.dot(m) < -0.5)
                .map(|(b, _)| (*a, *b))
        })?;
        let name = |b: u16| &self.scene.boundaries[usize::from(b)].name;
        Some(format!("`{}` and `{}`", name(first), name(second)))
    }

    /// Complete state as a blob: magic, version, scene hash, length, checksum; works in a new process.
    #[must_use]
    pub fn snapshot(&self) -> Vec<u8> {
        to_blob(&self.state, &self.scene.hash)
    }

    /// Restores a [`Self::snapshot`] of the same scene.
    ///
    /// # Errors
    /// [`SnapshotError`] if the blob is damaged or belongs to another scene or version; the state is unchanged.
    pub fn restore(&mut self, blob: &[u8]) -> Result<(), SnapshotError> {
        self.state = from_blob(blob, &self.scene.hash)?;
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
        let velocity = Dof6 {
            linear: self.state.kinematics.velocity[i],
            angular: self.state.kinematics.spin[i],
        };
        let integrator = self.scene.settings.integrator;
        let reported =
            integrator.reported(&velocity, &self.state.persisting[i], self.state.last_step);
        Twist {
            linear: reported.linear,
            angular: reported.angular,
        }
    }

    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` half a `simulation.step` before [`Self::time`]
    /// (integrator `shi`: at that time): between two communication points the momentum of these velocities changes by
    /// weight and loads x time less the [`Self::mean_wrench`]es x time, also where steps were cut.
    #[must_use]
    pub fn half_step_velocity(&self, i: usize) -> Twist {
        let shift = self.shift(self.state.last_step);
        let persisting = &self.state.persisting[i];
        Twist {
            linear: self.state.kinematics.velocity[i] + persisting.linear * shift,
            angular: self.state.kinematics.spin[i] + persisting.angular * shift,
        }
    }

    /// Loaded contacts in canonical order: gap and point at [`Self::time`], mean force of the last internal step.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.state.contacts
    }

    /// Pose of boundary `b`.
    #[must_use]
    pub fn boundary_pose(&self, b: usize) -> Pose {
        self.state.poses[b]
    }

    /// Twist of boundary `b` over the last internal step.
    #[must_use]
    pub fn boundary_twist(&self, b: usize) -> Twist {
        self.state.twists[b]
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
