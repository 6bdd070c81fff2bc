//! `sphere-dda run SCENE -o DIR`: the solver without an FMU.

use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use miette::miette;
use sphere_dda::observe::Observation;
use sphere_dda::observe::writer::{Options, Results, Status};
use sphere_dda::scene::{Method, Scene, SolverKind};
use sphere_dda::simulation::{Simulation, StepReport};

use crate::check;
use crate::failure::Failure;
use crate::progress::{Interrupt, Progress, print};

/// Arguments of `run`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda run examples/funnel/funnel.toml -o funnel-results
  sphere-dda run scene.toml -o results --stop 0.5 --overwrite

Written to DIR: spheres.pvd, contacts.pvd and boundaries.pvd with their frames (ParaView, meshio), history.csv, run.json,
and view.py for ParaView. Ctrl-C ends the run after the current step; all files are then complete.")]
pub(crate) struct Run {
    /// The scene file (TOML).
    scene: PathBuf,
    /// Folder for the results.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Replace the results of an earlier run in DIR.
    #[arg(long)]
    overwrite: bool,
    /// Stop time [s]; that of the scene if absent.
    #[arg(long, value_name = "SECONDS", value_parser = positive, allow_negative_numbers = true)]
    stop: Option<f64>,
    /// Contact enforcement, instead of the scene's.
    #[arg(long, value_parser = method())]
    method: Option<Method>,
    /// Solver, instead of the scene's.
    #[arg(long, value_parser = solver())]
    solver: Option<SolverKind>,
}

/// A time in seconds that a run can end at.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if value > 0.0 && f64::is_finite(value) => Ok(value),
        _ => Err("expected a finite number of seconds greater than 0".to_owned()),
    }
}

fn method() -> impl TypedValueParser<Value = Method> {
    PossibleValuesParser::new(["alm", "penalty"]).map(|name| match name.as_str() {
        "penalty" => Method::Penalty,
        _ => Method::Alm,
    })
}

fn solver() -> impl TypedValueParser<Value = SolverKind> {
    PossibleValuesParser::new(["auto", "direct", "gauss-seidel"]).map(|name| match name.as_str() {
        "direct" => SolverKind::Direct,
        "gauss-seidel" => SolverKind::GaussSeidel,
        _ => SolverKind::Auto,
    })
}

impl Run {
    /// The scene with what the command line changes.
    fn adjust(&self, mut scene: Scene) -> Result<Scene, Failure> {
        let settings = &mut scene.settings;
        settings.duration = self.stop.unwrap_or(settings.duration);
        settings.method = self.method.unwrap_or(settings.method);
        settings.solver = self.solver.unwrap_or(settings.solver);
        if settings.method == Method::Penalty && settings.penalty.is_none() {
            return Err(Failure::Input(miette!(
                "--method penalty: found no `penalty` in the scene, expected one in N/m: add it to [simulation]; \
                 `sphere-dda check` suggests a value"
            )));
        }
        Ok(scene)
    }
}

/// Runs a scene and writes its results; what was reached before a failure or Ctrl-C is written too.
///
/// # Errors
/// All problems of the scene, a folder that cannot be used, or the step that could not be taken.
pub(crate) fn run(arguments: &Run, interrupt: &Interrupt) -> Result<(), Failure> {
    let loaded = Scene::from_file(&arguments.scene)?;
    check::warn(&loaded);
    let scene = Arc::new(arguments.adjust(loaded.scene)?);
    let mut options = Options::new(&arguments.output, &scene);
    options.overwrite = arguments.overwrite;

    let mut simulation = Simulation::new(Arc::clone(&scene))?;
    let mut results = Results::create(&scene, options)?;
    let (total, end) = march(&mut simulation, &mut results, interrupt);
    let status = results.finish();
    let printed = print(|out| {
        write!(out, "{total}")?;
        let place = arguments.output.display();
        writeln!(out, "results         {place}: {} frames, {} rows", status.frames, status.rows)?;
        writeln!(out, "look at them    paraview --script={place}/view.py")
    });
    end?;
    complete(&status)?;
    printed
}

/// To the end of the scene's duration, or as far as it gets.
fn march(
    simulation: &mut Simulation,
    results: &mut Results,
    interrupt: &Interrupt,
) -> (Total, Result<(), Failure>) {
    let settings = simulation.scene().settings.clone();
    let (stop, step) = (settings.duration, settings.communication_step);
    let mut progress = Progress::new(0.0, stop);
    let mut total = Total::default();
    results.record(&Observation::of(simulation));
    let mut end = Ok(());
    // A duration that is n steps but for rounding takes n.
    let count = (stop / step * (1.0 - 1e-9)).ceil().max(1.0) as u64;
    for k in 1..=count {
        let point = if k == count { stop } else { k as f64 * step };
        match simulation.advance_to(point) {
            Ok(report) => total.add(&report),
            Err(error) => {
                end = Err(error.into());
                break;
            }
        }
        let state = Observation::of(simulation);
        results.record(&state);
        progress.show(point, || detail(&state));
        if interrupt.requested() && k < count {
            progress.note(format_args!("interrupted at {point} s"));
            end = Err(Failure::Interrupted);
            break;
        }
    }
    total.time = simulation.time();
    total.wall = progress.wall_time();
    (total, end)
}

fn detail(state: &Observation) -> String {
    let report = &state.report;
    format!(
        "{} contacts, overlap {:.1e} R, {} iterations",
        state.active_contacts().count(),
        report.max_overlap,
        report.sweeps + report.factorizations
    )
}

/// Results that did not reach the disk make a failed run.
fn complete(status: &Status) -> Result<(), Failure> {
    match &status.first_failure {
        None => Ok(()),
        Some(why) => Err(Failure::Run(miette!("{} results were not written; the first: {why}", status.failures))),
    }
}

/// What a run cost and reached, over all steps.
#[derive(Debug, Default)]
struct Total {
    time: f64,
    wall: f64,
    report: StepReport,
}

impl Total {
    fn add(&mut self, step: &StepReport) {
        let sum = &mut self.report;
        sum.internal_steps += step.internal_steps;
        sum.cuts += step.cuts;
        sum.sweeps += step.sweeps;
        sum.augmentations += step.augmentations;
        sum.factorizations += step.factorizations;
        sum.max_overlap = sum.max_overlap.max(step.max_overlap);
    }
}

impl std::fmt::Display for Total {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { time, wall, report } = self;
        writeln!(f, "simulated       {time} s in {} steps, {} cuts", report.internal_steps, report.cuts)?;
        writeln!(
            f,
            "solver          {} sweeps, {} augmentations, {} factorizations",
            report.sweeps, report.augmentations, report.factorizations
        )?;
        writeln!(f, "worst overlap   {:.2e} of the radius", report.max_overlap)?;
        writeln!(f, "wall time       {wall:.2} s, {:.2} x real time", time / wall)
    }
}
