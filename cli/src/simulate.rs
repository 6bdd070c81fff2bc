//! `sphere-dda simulate X.fmu ...`.

use std::env;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::{Args, ValueEnum};
use miette::miette;
use sphere_dda_master::{
    Coupling, CsvWriter, End, Event, Fmu, InputTable, Isolation, Iteration, Options, Ssp, System,
    Table, Value, simulate,
};

use crate::arguments::{assignment, positive, vacant};
use crate::failure::Failure;
use crate::progress::{Interrupt, Progress, count, note};
use crate::recorded::Recorded;
use crate::serve_fmu;

/// Arguments of `simulate`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda simulate funnel.fmu -o outputs.csv
  sphere-dda simulate feeder.fmu --input drive.csv --step 0.002 --stop 2 -o outputs.csv
  sphere-dda simulate funnel.fmu --set output.directory=results --record maxOverlap
  sphere-dda simulate feeder.fmu --input drive.csv -o outputs.csv --view feeder.html
  sphere-dda simulate coupled.ssp --coupling iterated --step 0.001 -o outputs.csv
  sphere-dda simulate shaker.fmu bed.fmu --connect shaker.position=bed.boundary.tray.displacement \\
      --connect 'bed.boundary.tray.averageForce[3]=shaker.force' --set shaker.amplitude=0.001 -o outputs.csv

With several FMUs, or an SSP, every name of a variable, also in files, is `<file name without .fmu>.<variable>`.
What was recorded before a failure or Ctrl-C is written too. An FMU that ends before the stop time makes exit code 1.")]
pub(crate) struct Simulate {
    /// The FMUs: any of FMI 2.0 or 3.0 for co-simulation with a library for this system. They step in this order. Or one
    /// SSP archive, 1.0 or 2.0, with its FMUs, connections, parameters and times.
    #[arg(required = true, value_name = "FMU|SSP")]
    fmus: Vec<PathBuf>,
    /// Let an output feed an input; can be repeated.
    #[arg(long = "connect", value_name = "OUTPUT=INPUT", value_parser = connection)]
    connect: Vec<(String, String)>,
    /// When connected FMUs exchange values.
    #[arg(long, value_enum, default_value_t)]
    coupling: Scheme,
    /// Jacobi coupling: the FMUs step one after another on one thread, instead of at the same time on threads of their own.
    /// The results are the same.
    #[arg(long)]
    sequential: bool,
    /// Iterated coupling: relative change of the exchanged values between two iterations of a step at which they count as
    /// converged; 1e-6 if absent.
    #[arg(long, alias = "tolerance", value_name = "NUMBER")]
    coupling_tolerance: Option<f64>,
    /// Iterated coupling: most iterations of a step; 30 if absent.
    #[arg(long, alias = "iterations", value_name = "COUNT")]
    max_iterations: Option<u32>,
    /// Iterated coupling: part of the difference by which the very first correction goes; 0.5 if absent.
    #[arg(long, value_name = "NUMBER")]
    relaxation: Option<f64>,
    /// Iterated coupling: after the most iterations keep the best one and continue, instead of ending. The number of such
    /// steps and the greatest change that was left are reported at the end.
    #[arg(long, alias = "go-on")]
    accept_unconverged: bool,
    /// Inputs over time: CSV with the header `time,name,...`. Continuous reals are interpolated, other types hold their last value.
    #[arg(long, value_name = "CSV")]
    input: Option<PathBuf>,
    /// Where to write the outputs over time as CSV; standard output if absent.
    #[arg(long, short, value_name = "CSV")]
    output: Option<PathBuf>,
    /// Write a page that shows the spheres of the FMU and plots what is recorded, see `sphere-dda view`. One of the FMUs must
    /// be of sphere-dda.
    #[arg(long, value_name = "HTML")]
    view: Option<PathBuf>,
    /// Replace the file of outputs, and the page, if there are any.
    #[arg(long)]
    overwrite: bool,
    /// Name of a variable to record, instead of all outputs, `*` for any text; can be repeated.
    #[arg(long = "record", value_name = "NAME")]
    record: Vec<String>,
    /// Start time [s]; that of the FMU's default experiment if absent.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    start: Option<f64>,
    /// Stop time [s]; that of the default experiment if absent.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    stop: Option<f64>,
    /// Communication step [s]; that of the default experiment, or 1/500 of the duration if absent.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    step: Option<f64>,
    /// Start value of a parameter or input; can be repeated.
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    set: Vec<(String, String)>,
    /// Run each FMU in a process of its own: if it crashes, ends the process or hangs, the run ends with a message that names
    /// the call.
    #[arg(long)]
    isolate: bool,
    /// Longest time that one call of an FMU may take, with --isolate; none if absent.
    #[arg(long, value_name = "SECONDS", requires = "isolate", value_parser = positive)]
    call_timeout: Option<f64>,
    /// Have the FMU log more than warnings and errors.
    #[arg(long)]
    verbose: bool,
    /// Record NaN like any value instead of ending with an error.
    #[arg(long)]
    allow_nan: bool,
}

/// When connected FMUs exchange values.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum Scheme {
    /// All at the start of a step.
    #[default]
    Jacobi,
    /// Each before its own step, so that it gets what the FMUs before it have just reached.
    GaussSeidel,
    /// Steps are repeated from saved states until all that is exchanged at their end agrees.
    Iterated,
}

impl From<Scheme> for Coupling {
    fn from(scheme: Scheme) -> Self {
        match scheme {
            Scheme::Jacobi => Self::Jacobi,
            Scheme::GaussSeidel => Self::GaussSeidel,
            Scheme::Iterated => Self::Iterated,
        }
    }
}

/// `output=input`.
pub(crate) fn connection(text: &str) -> Result<(String, String), String> {
    let (output, input) =
        assignment(text).map_err(|_| format!("found `{text}`, expected OUTPUT=INPUT"))?;
    Ok((output, input.trim().to_owned()))
}

/// Simulates FMUs and writes their outputs; what was recorded before a failure or Ctrl-C is written too.
///
/// # Errors
/// What the importer says, and files that cannot be read or written.
pub(crate) fn run(arguments: &Simulate, interrupt: &Interrupt) -> Result<(), Failure> {
    let (ssp, fmus) = open(&arguments.fmus)?;
    let mut system = match (&ssp, &*fmus) {
        (Some(ssp), _) => ssp.system()?,
        (None, [fmu]) => System::of(fmu),
        (None, _) => System::coupled(fmus.iter().map(|fmu| (stem(fmu.path()), fmu)))?,
    };
    let pairs = arguments.connect.iter();
    system.connect(pairs.map(|(output, input)| (&**output, &**input)))?;
    let mut options = options(arguments, ssp.as_ref(), &system)?;
    if arguments.overwrite && arguments.output.is_none() && arguments.view.is_none() {
        return Err(Failure::Input(miette!(
            "--overwrite: found nothing to replace, expected --output or --view with it"
        )));
    }
    let prepare = |page| Recorded::prepare(page, arguments.overwrite, &fmus, &arguments.set);
    let recorded = arguments.view.as_deref().map(prepare).transpose()?;
    options.set.extend(recorded.as_ref().map(Recorded::setting));
    let table = recorded.as_ref().map(Recorded::table);
    let table = table.as_ref().map(|path| CsvFile::open(path, false));
    let mut plotted = table.transpose()?;
    let mut output = match &arguments.output {
        Some(path) => Output::File(CsvFile::open(path, arguments.overwrite)?),
        None => Output::Terminal(CsvWriter::new(io::stdout())),
    };
    let mut write = |table: &Table| {
        if let Some(plotted) = &mut plotted {
            plotted.write(table)?;
        }
        output.write(table)
    };
    let driven = drive(&system, &options, interrupt, &mut write);
    if let Some(table) = &driven.table {
        // A row that ends a run by itself has not been shown yet.
        write(table)?;
        let reached = match table.time.last() {
            Some(last) => format!(" up to {last} s"),
            None => String::new(),
        };
        note(format_args!(
            "{}{reached}{}, wall time {:.2} s",
            count(table.recorded, "row"),
            iterations(table),
            driven.wall
        ));
        if let Some(recorded) = &recorded {
            let shown = recorded.show();
            return driven.end.and(shown);
        }
    }
    driven.end
}

/// One SSP, or FMUs.
fn open(files: &[PathBuf]) -> Result<(Option<Ssp>, Vec<Fmu>), Failure> {
    if let Some(scene) = files
        .iter()
        .find(|file| file.extension().is_some_and(|e| e == "toml"))
    {
        let scene = scene.display();
        return Err(Failure::Input(miette!(
            "found the scene `{scene}`, expected an FMU or an SSP; run a scene with `sphere-dda run {scene} -o DIR`, or make \
             its FMU with `sphere-dda export {scene}`"
        )));
    }
    if let [path] = files
        && is_ssp(path)
    {
        return Ok((Some(Ssp::open(path)?), Vec::new()));
    }
    if files.iter().any(|path| is_ssp(path)) {
        return Err(Failure::Input(miette!(
            "found an SSP among several files, expected one SSP alone, or FMUs"
        )));
    }
    let fmus: Result<_, _> = files.iter().map(Fmu::open).collect();
    Ok((None, fmus?))
}

/// What the arguments say; what they leave open, as the SSP says.
fn options(
    arguments: &Simulate,
    ssp: Option<&Ssp>,
    system: &System<'_>,
) -> Result<Options, Failure> {
    let (mut set, (start, stop)) = match ssp {
        Some(ssp) => (ssp.set(system)?, ssp.experiment()),
        None => (Vec::new(), (None, None)),
    };
    set.retain(|(name, _)| arguments.set.iter().all(|(given, _)| given != name));
    set.extend(arguments.set.iter().cloned());
    let input = arguments.input.as_ref();
    Ok(Options {
        start: arguments.start.or(start),
        stop: arguments.stop.or(stop),
        step: arguments.step,
        coupling: arguments.coupling.into(),
        sequential: arguments.sequential,
        inputs: input
            .map(|path| InputTable::from_csv(path, system))
            .transpose()?,
        iteration: iteration(arguments)?,
        outputs: (!arguments.record.is_empty()).then(|| arguments.record.clone()),
        set,
        logging: arguments.verbose,
        allow_nan: arguments.allow_nan,
        isolation: isolation(arguments)?,
        // Rows go to the file as they come.
        keep_last: true,
        ..Options::default()
    })
}

/// How to iterate; numbers for it are refused where nothing is iterated.
fn iteration(arguments: &Simulate) -> Result<Iteration, Failure> {
    let given = [
        (
            "--coupling-tolerance",
            arguments.coupling_tolerance.is_some(),
        ),
        ("--max-iterations", arguments.max_iterations.is_some()),
        ("--relaxation", arguments.relaxation.is_some()),
        ("--accept-unconverged", arguments.accept_unconverged),
    ];
    if let Some((name, _)) = given.iter().find(|(_, given)| *given)
        && !matches!(arguments.coupling, Scheme::Iterated)
    {
        return Err(Failure::Input(miette!(
            "{name}: found another coupling, expected `--coupling iterated`, for which it is"
        )));
    }
    let default = Iteration::default();
    Ok(Iteration {
        tolerance: arguments.coupling_tolerance.unwrap_or(default.tolerance),
        max_iterations: arguments.max_iterations.unwrap_or(default.max_iterations),
        relaxation: arguments.relaxation.unwrap_or(default.relaxation),
        accept_unconverged: arguments.accept_unconverged,
    })
}

/// This program, once for each FMU.
fn isolation(arguments: &Simulate) -> Result<Option<Isolation>, Failure> {
    if !arguments.isolate {
        return Ok(None);
    }
    let call_timeout = arguments.call_timeout.map(Duration::try_from_secs_f64);
    Ok(Some(Isolation {
        program: env::current_exe().map_err(Failure::input)?,
        arguments: vec![serve_fmu::NAME.into()],
        call_timeout: call_timeout.transpose().map_err(Failure::input)?,
    }))
}

/// Whether a file is named as an SSP is.
fn is_ssp(path: &Path) -> bool {
    path.extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("ssp"))
}

/// Iterations per step, on average and at most, if the coupling iterates.
fn iterations(table: &Table) -> String {
    let counts = &table.iterations;
    let Some(most) = counts.iter().max() else {
        return String::new();
    };
    let mean = counts.iter().map(|&count| f64::from(count)).sum::<f64>() / counts.len() as f64;
    let left = table.not_converged.iter().map(|step| step.change);
    let unconverged = match left.reduce(f64::max) {
        None => String::new(),
        Some(worst) => format!(
            "; {} steps were accepted although values still changed, by at most {worst:.1e} of their greatest",
            table.not_converged.len()
        ),
    };
    format!(", {mean:.2} iterations per step on average, at most {most}{unconverged}")
}

/// Name of a file without its ending.
pub(crate) fn stem(path: &Path) -> String {
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// A simulation that was begun.
pub(crate) struct Driven {
    /// What was recorded; `None` if it did not start.
    pub(crate) table: Option<Table>,
    /// Wall time \[s\].
    pub(crate) wall: f64,
    /// Whether it reached the stop time.
    pub(crate) end: Result<(), Failure>,
}

/// Drives FMUs from start to stop and shows how they get on; `observe` gets the table after each row, and ends the simulation if it
/// fails.
pub(crate) fn drive(
    system: &System<'_>,
    options: &Options,
    interrupt: &Interrupt,
    mut observe: impl FnMut(&Table) -> Result<(), Failure>,
) -> Driven {
    let default = system.experiment();
    let start = options.start.or(default.start_time).unwrap_or(0.0);
    let stop = options.stop.or(default.stop_time).unwrap_or(f64::NAN);
    let mut progress = Progress::new(start, stop);
    let mut failed = None;
    let result = simulate(system, options, |event| {
        match event {
            Event::Time { time, table, .. } => {
                progress.show(time, || detail(table));
                failed = observe(table).err();
            }
            Event::Message(message) => progress.note(message),
            Event::MessagesLost(count) => {
                progress.note(format_args!("{count} more messages were lost"))
            }
            _ => {}
        }
        if failed.is_some() || interrupt.requested() {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    });
    let wall = progress.wall_time();
    drop(progress);
    let (table, end) = match result {
        _ if failed.is_some() => (None, failed.map_or(Ok(()), Err)),
        Err(error) => (error.table().cloned(), Err(error.into())),
        Ok(table) => {
            let last = table.time.last().copied().unwrap_or(start);
            let end = match table.end {
                End::Stop => Ok(()),
                End::Terminated => Err(Failure::Run(miette!(
                    "an FMU ended the simulation at {last} s, expected {stop} s: see what it logged"
                ))),
                End::Interrupted => {
                    note(format_args!("interrupted at {last} s"));
                    Err(Failure::Interrupted)
                }
            };
            (Some(table), end)
        }
    };
    Driven { table, wall, end }
}

/// The last values of outputs that report the state of a sphere-dda FMU; other FMUs have none of these names.
fn detail(table: &Table) -> String {
    let last = |name: &str| {
        let of_a_component = |full: &str| full.strip_suffix(name).is_some_and(|r| r.ends_with('.'));
        let column = table
            .columns
            .iter()
            .find(|column| column.name == name || of_a_component(&column.name))?;
        column.values.get(table.time.len().checked_sub(1)?)
    };
    let contacts = last("contactCount").map(|count| format!("{count} contacts"));
    let overlap = match last("maxOverlap") {
        Some(Value::Real(overlap)) => Some(format!("overlap {overlap:.1e} R")),
        _ => None,
    };
    let iterations = last("solver.sweeps").map(|sweeps| format!("{sweeps} iterations"));
    contacts
        .into_iter()
        .chain(overlap)
        .chain(iterations)
        .collect::<Vec<_>>()
        .join(", ")
}

/// Where the outputs go, row by row: what ends the process leaves the rows before it.
enum Output<'a> {
    File(CsvFile<'a>),
    Terminal(CsvWriter<io::Stdout>),
}

impl Output<'_> {
    fn write(&mut self, table: &Table) -> Result<(), Failure> {
        match self {
            Self::File(file) => file.write(table),
            // A reader that has seen enough is no failure.
            Self::Terminal(out) => match out.write(table).map_err(io::Error::from) {
                Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
                written => written.map_err(Failure::run),
            },
        }
    }
}

/// A file of outputs, opened before the simulation: after it would be late to find that it cannot be written.
struct CsvFile<'a> {
    path: &'a Path,
    file: File,
    existed: bool,
    rows: Option<CsvWriter<File>>,
}

impl<'a> CsvFile<'a> {
    fn open(path: &'a Path, overwrite: bool) -> Result<Self, Failure> {
        let existed = path.exists();
        vacant(path, overwrite)?;
        // An old file keeps its contents until there are new ones.
        let file = OpenOptions::new()
            .write(true)
            .create(true)
            .truncate(false)
            .open(path);
        let file = file.map_err(|error| {
            Failure::Input(miette!("cannot write `{}`: {error}", path.display()))
        })?;
        Ok(Self {
            path,
            file,
            existed,
            rows: None,
        })
    }

    fn write(&mut self, table: &Table) -> Result<(), Failure> {
        self.rows(table).map_err(|error| {
            Failure::Run(miette!("cannot write `{}`: {error}", self.path.display()))
        })
    }

    fn rows(&mut self, table: &Table) -> io::Result<()> {
        let rows = match &mut self.rows {
            Some(rows) => rows,
            None => {
                self.file.set_len(0)?;
                self.rows.insert(CsvWriter::new(self.file.try_clone()?))
            }
        };
        Ok(rows.write(table)?)
    }
}

impl Drop for CsvFile<'_> {
    /// Without a row things are left as they were.
    fn drop(&mut self) {
        if self.rows.is_none() && !self.existed && fs::remove_file(self.path).is_err() {
            note(format_args!("`{}` is empty", self.path.display()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::assignment;

    #[test]
    fn assignments_split_at_the_first_sign_outside_of_quotes() {
        let pair = |name: &str, value: &str| Ok((name.to_owned(), value.to_owned()));
        assert_eq!(assignment("a.b[1]=2"), pair("a.b[1]", "2"));
        assert_eq!(assignment("label=a=b"), pair("label", "a=b"));
        assert_eq!(assignment("label="), pair("label", ""));
        assert_eq!(assignment("'x=y'.z=1"), pair("'x=y'.z", "1"));
        assert_eq!(assignment(r"'it\'s=1'=1"), pair(r"'it\'s=1'", "1"));
        assert!(assignment("nothing").is_err());
    }
}
