//! One co-simulation instance, whatever version of FMI talks to it: life cycle, values, steps, saved states.
//!
//! ```text
//! Instantiated -> Initialization -> StepComplete <-> StepFailed -> Terminated
//!                                        any -> Error (a panic, or a step that failed again) -> reset or load
//! ```
//!
//! The time of the scene counts from the start time of the experiment. A step ends exactly at `tc + h`; nothing is
//! accumulated, the simulation is asked for what is left to that point. A refused call changes nothing.

mod derivatives;
mod scene;
mod states;
mod step;
mod step_in_progress;
mod values;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::contact::Contact;
use sphere_dda::error::StepError;
use sphere_dda::scene::{Boundary, CommandDerivatives, Scene};
use sphere_dda::simulation::Simulation;

use crate::model::Model;
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::recorder::Recorder;
use crate::runtime::refusal::{InstantiationError, Refusal};
use crate::runtime::state::InstanceState;
use crate::runtime::walls::Wall;
use crate::table::Parameters;
use sphere_dda_fmi_interface::log::{Level, Log};
use sphere_dda_fmi_interface::pointers::BadArgument;
use step_in_progress::StepInProgress;

pub use states::Kept;
pub use step::Progress;
pub use values::Call;

/// Share of the step by which a communication point may miss the end of the last one: masters add up or round their
/// times, and a mistake of the master is far larger.
const POINT_TOLERANCE: f64 = 1e-4;

/// What became of a step.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// The instance stands at `tc + h`.
    Complete,
    /// The solver gave up; the instance stands at `tc` as before.
    Discarded(StepError),
}

/// What was read off the simulation at the last communication point; computed when first asked for.
#[derive(Default)]
struct Measured {
    /// Values, in the order of the table.
    outputs: Option<Vec<f64>>,
    /// Loaded contacts.
    contacts: Option<Vec<Contact>>,
    /// Triangles of boundaries, by boundary.
    walls: BTreeMap<usize, Wall>,
    /// Derivatives by time of all that [`derivatives`] measures.
    rates: Option<Vec<f64>>,
    /// Its derivatives by inputs, by row of the table and element.
    columns: BTreeMap<(usize, usize), Vec<f64>>,
}

/// A running FMU.
pub struct Instance {
    name: String,
    model: Model,
    log: Log,
    run: InstanceState,
    /// The scene with the values it was built with.
    base: Arc<Scene>,
    /// The scene with the values that are set, as far as it is known.
    latest: Arc<Scene>,
    simulation: Option<Simulation>,
    /// The step under way, if it is taken in pieces.
    step: Option<StepInProgress>,
    measured: Measured,
    recorder: Recorder,
    read_ahead: bool,
    /// Whether the log has said that there are more contacts than rows.
    left_out: bool,
}

impl Instance {
    /// Reads the scene in `resources` and checks that the importer's `guid` is its own.
    ///
    /// # Errors
    /// [`InstantiationError`]; every one is also written to `log`.
    pub fn new(
        name: &str,
        guid: &str,
        resources: &Path,
        log: Log,
    ) -> Result<Self, InstantiationError> {
        Self::try_new(name, guid, resources).map(|(model, run)| Self {
            name: name.to_owned(),
            base: Arc::clone(&model.scene),
            latest: Arc::clone(&model.scene),
            model,
            log,
            run,
            simulation: None,
            step: None,
            measured: Measured::default(),
            recorder: Recorder::default(),
            read_ahead: false,
            left_out: false,
        })
    }

    fn try_new(
        name: &str,
        guid: &str,
        resources: &Path,
    ) -> Result<(Model, InstanceState), InstantiationError> {
        if name.is_empty() {
            return Err(InstantiationError::Name);
        }
        let model = Model::of_resources(resources)?;
        if model.guid != guid {
            return Err(InstantiationError::Guid {
                found: guid.to_owned(),
                expected: model.guid,
            });
        }
        let run = initial(&model);
        Ok((model, run))
    }

    /// Place in the life cycle.
    #[must_use]
    pub fn stage(&self) -> LifeCycle {
        self.run.stage
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The log.
    pub fn log(&mut self) -> &mut Log {
        &mut self.log
    }

    /// Time of the last communication point \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.run.time
    }

    /// Sets start and stop time \[s\] of the experiment.
    ///
    /// # Errors
    /// [`Refusal::Argument`] if they are not finite or in the wrong order.
    pub fn set_up(&mut self, start: f64, stop: Option<f64>) -> Result<(), Refusal> {
        if !start.is_finite() {
            return Err(argument("startTime", start, "a finite time [s]"));
        }
        if let Some(stop) = stop.filter(|stop| !(stop.is_finite() && *stop >= start)) {
            return Err(argument(
                "stopTime",
                stop,
                "a finite time, startTime or later [s]",
            ));
        }
        (self.run.start, self.run.time, self.run.stop) = (start, start, stop);
        Ok(())
    }

    /// Enters initialization mode: outputs are known from here on.
    pub fn enter_initialization(&mut self) {
        self.run.stage = LifeCycle::Initialization;
        self.run.pending = true;
    }

    /// Leaves initialization mode: reads the configuration, places the boundaries, opens the result files.
    ///
    /// # Errors
    /// [`Refusal::Step`] if the start is impossible, [`Refusal::Output`] if results cannot be written.
    pub fn exit_initialization(&mut self) -> Result<(), Refusal> {
        self.prepare()?;
        if let Some(simulation) = &self.simulation {
            self.recorder
                .open(&self.name, &self.run.parameters, simulation, &self.log)?;
        }
        self.run.stage = LifeCycle::StepComplete;
        let spheres = self.model.scene.particles.len();
        self.log.write(
            Level::Ok,
            format_args!("initialized: {spheres} spheres, t = {} s", self.run.time),
        );
        Ok(())
    }

    /// Takes the step from `point` to exactly `point + h` \[s\]. With `final_past` the importer promises not to go
    /// back before `point`.
    ///
    /// # Errors
    /// [`Refusal::Argument`], [`Refusal::Point`], [`Refusal::PastStop`], [`Refusal::Step`] if an input is impossible,
    /// [`Refusal::Repeated`] if a step that was discarded is tried again and fails again.
    pub fn do_step(&mut self, point: f64, h: f64, final_past: bool) -> Result<Step, Refusal> {
        let end = self.check_step(point, h)?;
        let advanced = self.advance(end);
        let outcome = self.concluded(advanced, h, end);
        if final_past {
            self.recorder.commit(point - self.run.start);
        }
        outcome
    }

    /// Whether the last communication step holds internal steps that did not meet the tolerances and were taken as they are,
    /// which is logged for `function`. In real-time mode all are so by choice.
    pub fn unconverged(&self, function: &str) -> bool {
        let Some(simulation) = &self.simulation else {
            return false;
        };
        let report = &simulation.state().report;
        let steps = report.unconverged_steps;
        if steps == 0 || simulation.scene().settings.sweeps.is_some() {
            return false;
        }
        let advice = report.squeezed.map_or_else(String::new, |one| {
            format!(": {}", one.advice(simulation.scene()))
        });
        self.log.write(
            Level::Warning,
            format_args!(
                "{function}: {steps} of {} internal steps up to t = {} s did not meet solver.tolerance: their best iterate was \
                 taken, maxOverlap is {:.1e}, solver.forceResidual {:.1e}{advice}",
                report.internal_steps, self.run.time, report.max_overlap, report.force_residual
            ),
        );
        true
    }

    /// Where an attempt at a step of length `h` to `end` \[s\] leaves the instance.
    fn concluded(
        &mut self,
        advanced: Result<(), StepError>,
        h: f64,
        end: f64,
    ) -> Result<Step, Refusal> {
        match advanced {
            Ok(()) => {
                self.run.time = end;
                self.run.failed = None;
                self.run.pending = false;
                self.run.stage = LifeCycle::StepComplete;
                self.run.rates.fill(CommandDerivatives::default());
                self.measured = Measured::default();
                if let Some(simulation) = &self.simulation {
                    self.recorder.record(simulation, &self.log);
                }
                Ok(Step::Complete)
            }
            Err(
                error @ (StepError::Jump { .. }
                | StepError::Orientation { .. }
                | StepError::Argument { .. }),
            ) => Err(Refusal::Step(error)),
            Err(error) if self.run.failed.is_some_and(|failed| h >= failed) => {
                self.run.stage = LifeCycle::Error;
                Err(Refusal::Repeated(error))
            }
            Err(error) => {
                self.run.failed = Some(h);
                self.run.stage = LifeCycle::StepFailed;
                Ok(Step::Discarded(error))
            }
        }
    }

    /// Checks the arguments of a step and gives its end.
    fn check_step(&self, point: f64, h: f64) -> Result<f64, Refusal> {
        let end = point + h;
        if !point.is_finite() {
            return Err(argument(
                "currentCommunicationPoint",
                point,
                "a finite time [s]",
            ));
        }
        if !(end.is_finite() && h > 0.0 && end > point) {
            return Err(argument(
                "communicationStepSize",
                h,
                "a positive length [s] that moves the point",
            ));
        }
        let tolerance =
            |a: f64, b: f64| POINT_TOLERANCE * h + 8.0 * f64::EPSILON * a.abs().max(b.abs());
        let expected = self.run.time;
        if (point - expected).abs() > tolerance(point, expected) {
            let tolerance = tolerance(point, expected);
            return Err(Refusal::Point {
                found: point,
                expected,
                tolerance,
            });
        }
        match self.run.stop {
            Some(stop) if end > stop + tolerance(end, stop) => Err(Refusal::PastStop { end, stop }),
            _ => Ok(end),
        }
    }

    /// Advances the simulation to the time `end` \[s\]; on error it is as before.
    fn advance(&mut self, end: f64) -> Result<(), StepError> {
        let end = end - self.run.start;
        // Derivatives can be asked for after a step that fails.
        let simulation = self.commanded()?;
        let communication = simulation.begin(end)?;
        simulation.finish(communication)
    }

    /// The simulation with gravity and commands of now.
    fn commanded(&mut self) -> Result<&mut Simulation, StepError> {
        let Some(simulation) = &mut self.simulation else {
            let found = format!("none in state {}", self.run.stage);
            return Err(StepError::Argument {
                what: "simulation",
                found,
                expected: "one",
            });
        };
        if self.run.stepped != self.run.values {
            simulation.tune(simulation.scene().tuned(&self.latest).into());
            self.run.stepped.clone_from(&self.run.values);
        }
        simulation.set_gravity(self.run.parameters.settings.gravity)?;
        command(simulation, &self.run)?;
        Ok(simulation)
    }

    /// Ends the run; values stay readable. Whether the result files are complete: if not, the log says what is missing.
    pub fn terminate(&mut self) -> bool {
        self.run.stage = LifeCycle::Terminated;
        self.recorder.close(&self.log)
    }

    /// Completes the result files, as [`Self::terminate`] does.
    pub fn close(&mut self) -> bool {
        self.recorder.close(&self.log)
    }

    /// Back to the state after instantiation. Whether the result files are complete.
    pub fn reset(&mut self) -> bool {
        let whole = self.recorder.close(&self.log);
        self.run = initial(&self.model);
        self.base = Arc::clone(&self.model.scene);
        self.latest = Arc::clone(&self.model.scene);
        self.simulation = None;
        self.step = None;
        self.measured = Measured::default();
        (self.read_ahead, self.left_out) = (false, false);
        whole
    }

    /// After a panic: nothing of the simulation can be trusted any more.
    pub fn fail(&mut self, what: &str) {
        self.run.stage = LifeCycle::Error;
        self.simulation = None;
        self.step = None;
        self.measured = Measured::default();
        let text =
            "this is a defect of the library; reset the instance or restore an earlier state";
        self.log
            .write(Level::Error, format_args!("internal error: {what}; {text}"));
    }

    /// Whether the instance wants the simulation to end. After a discarded step it does not: a shorter one may do.
    #[must_use]
    pub fn wants_to_terminate(&self) -> bool {
        self.run.stage == LifeCycle::Error
    }

    /// Brings the simulation to the start that parameters and inputs ask for.
    fn prepare(&mut self) -> Result<(), Refusal> {
        self.measured = Measured::default();
        self.build()?;
        let mut simulation = Simulation::new(self.run.parameters.apply(&self.base).into())?;
        let gravity = self.run.parameters.settings.gravity;
        // A start that is the scene's own is left alone: the FMU then gives the bytes that the library gives.
        let boundaries = &self.base.boundaries;
        let rest = boundaries.iter().map(Boundary::rest);
        let forced = self.run.forces.iter().any(|f| *f != Vec3::zeros());
        let moved = !rest.eq(self.run.commands.iter().copied());
        if gravity != simulation.state().gravity || moved || forced {
            simulation.set_gravity(gravity)?;
            command(&mut simulation, &self.run)?;
            simulation.place()?;
        }
        self.simulation = Some(simulation);
        self.run.pending = false;
        Ok(())
    }
}

/// The state after instantiation: everything as in the scene.
fn initial(model: &Model) -> InstanceState {
    let values: Vec<f64> = model.scene.parameters.iter().map(|p| p.value).collect();
    InstanceState {
        stage: LifeCycle::Instantiated,
        start: 0.0,
        stop: None,
        time: 0.0,
        parameters: Parameters::of(&model.scene),
        values: values.clone(),
        built: values.clone(),
        stepped: values,
        commands: model.scene.boundaries.iter().map(Boundary::rest).collect(),
        rates: vec![CommandDerivatives::default(); model.scene.boundaries.len()],
        forces: match model.scene.exposed.applied_forces {
            true => vec![Vec3::zeros(); model.scene.particles.len()],
            false => Vec::new(),
        },
        pending: false,
        failed: None,
    }
}

/// Hands the commands of all driven boundaries and the forces on the spheres to the simulation.
fn command(simulation: &mut Simulation, run: &InstanceState) -> Result<(), StepError> {
    for (b, (&command, &rates)) in run.commands.iter().zip(&run.rates).enumerate() {
        if simulation.scene().boundaries[b].is_commanded() {
            simulation.command_along(b, command, rates)?;
        }
    }
    if !run.forces.is_empty() {
        simulation.apply_forces(&run.forces)?;
    }
    Ok(())
}

fn argument(argument: &'static str, found: f64, expected: &'static str) -> Refusal {
    Refusal::Argument(BadArgument {
        argument,
        found: found.to_string(),
        expected,
    })
}
