//! `sphere-dda run SCENE -o DIR`: the solver without an FMU.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use miette::miette;
use sphere_dda::communication_points::{CommunicationPoints, due};
use sphere_dda::contact::elasticity::LARGEST_COMPRESSION;
use sphere_dda::formats::error::OutputError;
use sphere_dda::observe::Observation;
use sphere_dda::results::Options;
use sphere_dda::results::checkpoint::{Checkpoint, KEPT};
use sphere_dda::results::writer::{Results, Status};
use sphere_dda::scene::{Method, Scene};
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::SolverKind;
use sphere_dda::state::StepReport;

use crate::arguments::{Values, interval, positive};
use crate::check;
use crate::dump::Dump;
use crate::failure::Failure;
use crate::page;
use crate::progress::{Interrupt, Progress, count, note, print, wall_time};
use crate::settle::Settling;

/// Wall time after which a checkpoint is written whatever the simulated time: what a killed run loses at most.
const LONGEST_WORK: Duration = Duration::from_mins(5);

/// Arguments of `run`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda run examples/funnel/funnel.toml -o funnel-results
  sphere-dda run scene.toml -o results --stop 0.5 --overwrite
  sphere-dda run scene.toml -o results --set friction=0.4     with another value of the scene's parameter
  sphere-dda run scene.toml -o results --view                 ends with results/view.html, for the browser
  sphere-dda run scene.toml -o results --resume               begins, goes on, or has nothing left to do
  sphere-dda run scene.toml -o results --resume --stop 2      makes a run longer
  sphere-dda run hopper.toml -o results --until-rest --start hopper.start     settles once, later runs read the start

Written to DIR: spheres.pvd, contacts.pvd and boundaries.pvd with their frames (ParaView, meshio), history.csv, run.json,
view.py for ParaView, and checkpoints to go on from: every five minutes, every --checkpoint-interval, at the end. Ctrl-C
ends the run after the current step; all files are then complete. A run that was killed at any moment and resumed leaves
the same files, bit for bit, as one that was not.")]
pub(crate) struct Run {
    /// The scene file (TOML).
    scene: PathBuf,
    /// Folder for the results.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Replace the results of an earlier run in DIR.
    #[arg(long)]
    overwrite: bool,
    /// Go on with the run in DIR from its last checkpoint; without one, start.
    #[arg(long, conflicts_with = "overwrite")]
    resume: bool,
    /// Simulated time between checkpoints [s], 0: none; that of the scene if absent.
    #[arg(long, value_name = "SECONDS", value_parser = interval, allow_negative_numbers = true)]
    checkpoint_interval: Option<f64>,
    /// Stop time [s]; that of the scene if absent.
    #[arg(long, value_name = "SECONDS", value_parser = positive, allow_negative_numbers = true)]
    stop: Option<f64>,
    /// Contact enforcement, instead of the scene's.
    #[arg(long, value_parser = method())]
    method: Option<Method>,
    /// Solver, instead of the scene's.
    #[arg(long, value_parser = solver())]
    solver: Option<SolverKind>,
    /// Number of threads, instead of the scene's; results are the same for any.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=256))]
    threads: Option<u32>,
    /// Write the contact problem of each internal step that fails or ends unconverged to DIR, for `sphere-dda corpus`: the first
    /// 100 of the run.
    #[arg(long, value_name = "DIR")]
    dump_failed: Option<PathBuf>,
    /// Write DIR/view.html at the end: the run in one HTML file, see `sphere-dda view`.
    #[arg(long)]
    view: bool,
    #[command(flatten)]
    values: Values,
    #[command(flatten)]
    settling: Settling,
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
        settings.threads = self.threads.map_or(settings.threads, |n| n as usize);
        let output = &mut scene.output;
        output.checkpoint_interval = self
            .checkpoint_interval
            .unwrap_or(output.checkpoint_interval);
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
    let loaded = Scene::from_file_with(&arguments.scene, &arguments.values.set)?;
    check::warn(&loaded);
    let mut scene = arguments.adjust(loaded.scene)?;
    if !arguments.overwrite && !arguments.resume {
        // What would stop the run shows before the spheres settle.
        free(&arguments.output)?;
    }
    if let Some(start) = arguments.settling.start(&scene, interrupt)? {
        scene.start_from(&start).map_err(Failure::input)?;
    }
    let scene = Arc::new(scene);
    let mut options = Options::new(&arguments.output, &scene);
    options.overwrite = arguments.overwrite;

    let mut simulation = Simulation::new(Arc::clone(&scene))?;
    let mut dump = match &arguments.dump_failed {
        Some(folder) => Some(Dump::begin(folder, &arguments.scene, &mut simulation)?),
        None => None,
    };
    let settings = &scene.settings;
    let clock = CommunicationPoints::new(settings.communication_step, settings.duration);
    let (mut results, start) = if arguments.resume {
        resume(&mut simulation, &clock, options)?
    } else {
        (Results::create(&scene, options)?, None)
    };
    let watch = (interrupt, dump.as_mut());
    let (total, end) = run_to_end(&mut simulation, &mut results, &clock, start, watch);
    let status = results.finish();
    if let Some(dump) = &dump {
        dump.tell();
    }
    let printed = print(|out| {
        if total.report.internal_steps > 0 {
            write!(out, "{total}")?;
        }
        let place = arguments.output.display();
        writeln!(
            out,
            "results         {place}: {}, {}",
            count(status.frames, "frame"),
            count(status.rows, "row")
        )?;
        if arguments.view {
            return Ok(());
        }
        writeln!(out, "To view:        sphere-dda view {place} --open")?;
        writeln!(out, "                or paraview --script={place}/view.py")
    });
    if arguments.view && status.frames > 0 {
        let page = arguments.output.join(page::NAME);
        // A run that failed is looked at all the more; why it failed is told last.
        let shown = page::end_with(&arguments.output, &[], &page);
        end?;
        complete(&status)?;
        let shown = shown?;
        return printed.and_then(|()| print(|out| writeln!(out, "{shown}")));
    }
    end?;
    complete(&status)?;
    printed
}

/// Whether no run lies in `directory`.
fn free(directory: &Path) -> Result<(), Failure> {
    let found = "run.json";
    match directory.join(found).exists() {
        false => Ok(()),
        true => Err(Failure::input(OutputError::Exists {
            path: directory.to_path_buf(),
            found: found.to_owned(),
        })),
    }
}

/// Restores the last checkpoint before the stop time, and returns where that is.
fn resume(
    simulation: &mut Simulation,
    clock: &CommunicationPoints,
    options: Options,
) -> Result<(Results, Option<u64>), Failure> {
    let scene = Arc::clone(simulation.scene());
    let place = options.directory.display().to_string();
    let mut start = None;
    let restore = |blob: &[u8]| {
        simulation.restore(blob)?;
        start = clock.number(simulation.time());
        Ok(start.map(|_| simulation.time()))
    };
    let (results, resumed) = Results::resume(&scene, options, restore)?;
    for damaged in &resumed.damaged {
        note(format_args!("ignored {damaged}"));
    }
    match (resumed.time, start) {
        (None, _) => note(format_args!(
            "no checkpoint in `{place}`: the run starts at 0 s"
        )),
        (Some(time), Some(k)) if k == clock.count() => {
            note(format_args!("the run in `{place}` is finished at {time} s"));
        }
        (Some(time), _) => note(format_args!("resumes at {time} s")),
    }
    Ok((results, resumed.time.and(start)))
}

/// When a checkpoint is written, and how many stay.
struct Checkpoints<'a> {
    clock: &'a CommunicationPoints,
    /// Simulated time between two \[s\]; 0: no matter.
    interval: f64,
    /// Simulated time of the last one \[s\].
    last: f64,
    written: Instant,
}

impl<'a> Checkpoints<'a> {
    /// None written yet.
    fn new(clock: &'a CommunicationPoints, simulation: &Simulation) -> Self {
        Self {
            clock,
            interval: simulation.scene().output.checkpoint_interval,
            last: simulation.time(),
            written: Instant::now(),
        }
    }

    /// After communication step `k`, the run going on.
    fn pass(&mut self, k: u64, simulation: &Simulation, results: &mut Results) {
        let time = simulation.time();
        let simulated = self.interval > 0.0 && due(time, self.interval, Some(self.last));
        // From here the run can be made longer.
        let last_shared = k == self.clock.extensible();
        if simulated || last_shared || self.written.elapsed() >= LONGEST_WORK {
            self.write(k, simulation, results, KEPT);
        }
    }

    /// After the last step. A finished run can only be made longer: older checkpoints than that takes are removed.
    fn finish(&mut self, simulation: &Simulation, results: &mut Results) {
        let count = self.clock.count();
        let keep = if self.clock.extensible() == count {
            1
        } else {
            2
        };
        self.write(count, simulation, results, keep);
    }

    fn write(&mut self, number: u64, simulation: &Simulation, results: &mut Results, keep: usize) {
        self.last = simulation.time();
        self.written = Instant::now();
        results.checkpoint(Checkpoint {
            number,
            snapshot: simulation.snapshot(),
            keep,
        });
    }
}

/// From communication point `start`, if the run was resumed, to the end of the scene's duration, or as far as it gets.
fn run_to_end(
    simulation: &mut Simulation,
    results: &mut Results,
    clock: &CommunicationPoints,
    start: Option<u64>,
    (interrupt, mut dump): (&Interrupt, Option<&mut Dump>),
) -> (Total, Result<(), Failure>) {
    let begin = simulation.time();
    let mut progress = Progress::new(begin, clock.point(clock.count()));
    let mut checkpoints = Checkpoints::new(clock, simulation);
    if start.is_none() {
        results.record(&Observation::of(simulation));
    }
    let mut report = StepReport::default();
    let mut warned = false;
    let mut end = Ok(());
    let mut reached = start.unwrap_or(0);
    while reached < clock.count() {
        let point = clock.point(reached + 1);
        let taken = simulation.advance_to(point);
        let dumped = match &mut dump {
            Some(dump) => dump.write(simulation),
            None => Ok(()),
        };
        match taken {
            Ok(own) => report.add(&own),
            Err(error) => {
                end = dumped.and(Err(error.into()));
                break;
            }
        }
        reached += 1;
        let state = Observation::of(simulation);
        results.record(&state);
        // The step itself was taken: the checkpoint after the loop is of its end.
        if dumped.is_err() {
            end = dumped;
            break;
        }
        warned = warned || warn_of_failures(results, &progress);
        progress.show(point, || detail(&state));
        if reached < clock.count() {
            if interrupt.requested() {
                progress.note(format_args!(
                    "interrupted at {point} s; --resume continues from here"
                ));
                end = Err(Failure::Interrupted);
                break;
            }
            checkpoints.pass(reached, simulation, results);
        }
    }
    match end {
        Ok(()) => checkpoints.finish(simulation, results),
        Err(_) => checkpoints.write(reached, simulation, results, KEPT),
    }
    let total = Total {
        begin,
        time: simulation.time(),
        wall: progress.wall_time(),
        advice: report.squeezed.map(|one| one.advice(simulation.scene())),
        report,
    };
    (total, end)
}

/// Notes the first result that was not written, if there is one.
fn warn_of_failures(results: &Results, progress: &Progress) -> bool {
    let Some(why) = results.status().first_failure else {
        return false;
    };
    progress.note(format_args!(
        "a result was not written, the run continues: {why}"
    ));
    true
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
        Some(why) => Err(Failure::Run(miette!(
            "{} results were not written; the first: {why}",
            status.failures
        ))),
    }
}

/// What a run cost and reached, over all steps.
#[derive(Debug, Default)]
struct Total {
    begin: f64,
    time: f64,
    wall: f64,
    report: StepReport,
    /// What to do about a sphere that was squeezed.
    advice: Option<String>,
}

impl std::fmt::Display for Total {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            begin,
            time,
            wall,
            report,
            advice,
        } = self;
        write!(f, "simulated to    {time} s ")?;
        if *begin > 0.0 {
            write!(f, "(resumed at {begin} s) ")?;
        }
        let (steps, cuts) = (report.internal_steps, report.cuts);
        let (steps, cuts) = (count(steps, "step"), count(cuts, "cut"));
        writeln!(f, "in {steps}, {cuts}")?;
        writeln!(
            f,
            "solver          {} sweeps, {} augmentations, {} factorizations",
            report.sweeps, report.augmentations, report.factorizations
        )?;
        if report.unconverged_steps > 0 {
            writeln!(
                f,
                "unconverged     {} steps did not meet the tolerances: gap {:.1e}, slip {:.1e}, force {:.1e} reached",
                report.unconverged_steps,
                report.gap_residual,
                report.slip_residual,
                report.force_residual
            )?;
        }
        if let Some(advice) = advice {
            writeln!(f, "squeezed        {advice}")?;
        }
        writeln!(
            f,
            "worst overlap   {:.2e} of the radius",
            report.max_overlap
        )?;
        if report.max_compression > 0.0 {
            writeln!(
                f,
                "compressed      {:.2e} of the radius at most, where contacts give way; overlaps are beyond that",
                report.max_compression
            )?;
            if report.max_compression > LARGEST_COMPRESSION {
                writeln!(
                    f,
                    "                warning: laws of contacts that give way hold up to about {LARGEST_COMPRESSION}: beyond, they repel and \
                     no more; raise `young` [Pa] or `stiffness` [N/m]"
                )?;
            }
        }
        writeln!(
            f,
            "worst opening   {:.2e} of the radius, of a contact that carries load",
            report.max_opening
        )?;
        writeln!(f, "wall time       {}", wall_time(*wall, time - begin))
    }
}
