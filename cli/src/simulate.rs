//! `sphere-dda simulate X.fmu`.

use std::fs::File;
use std::io::{BufWriter, IsTerminal, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use miette::{Context, IntoDiagnostic, miette};
use sphere_dda_fmu::import::{End, Event, Fmu, Options, Signals, Table, simulate};

use crate::bad_input::BadInput;

/// Time between two lines of progress where there is no terminal.
const LINE_INTERVAL: Duration = Duration::from_secs(5);

/// Arguments of `simulate`.
#[derive(Debug, Args)]
pub(crate) struct Simulate {
    /// The FMU: any of FMI 2.0 for co-simulation with a library for this system.
    fmu: PathBuf,
    /// Inputs over time: CSV with the header `time,name,...`. Continuous reals are interpolated, all else is held.
    #[arg(long, value_name = "CSV")]
    input: Option<PathBuf>,
    /// Where to write the outputs over time as CSV; standard output if absent.
    #[arg(long, short, value_name = "CSV")]
    output: Option<PathBuf>,
    /// Name of a variable to record, instead of all outputs; can be repeated.
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
    /// Have the FMU log more than warnings and errors.
    #[arg(long)]
    verbose: bool,
    /// Record NaN like any value instead of ending with an error.
    #[arg(long)]
    allow_nan: bool,
}

/// `name=value`, split at the first `=` that is not in single quotes, as names may have.
fn assignment(text: &str) -> Result<(String, String), String> {
    let mut quoted = false;
    let mut escaped = false;
    for (at, character) in text.char_indices() {
        match character {
            _ if escaped => escaped = false,
            '\\' if quoted => escaped = true,
            '\'' => quoted = !quoted,
            '=' if !quoted => {
                let (name, value) = text.split_at(at);
                let value = value.strip_prefix('=').unwrap_or(value);
                return Ok((name.trim().to_owned(), value.to_owned()));
            }
            _ => {}
        }
    }
    Err(format!("found `{text}`, expected NAME=VALUE"))
}

/// Simulates an FMU and writes its outputs; what was recorded before a failure or Ctrl-C is written too.
///
/// # Errors
/// What the importer says, and files that cannot be read or written.
pub(crate) fn run(arguments: &Simulate) -> miette::Result<()> {
    let fmu = Fmu::open(&arguments.fmu).map_err(BadInput::report)?;
    let inputs = match &arguments.input {
        Some(path) => Some(Signals::from_csv(path, fmu.description()).map_err(BadInput::report)?),
        None => None,
    };
    let options = Options {
        start: arguments.start,
        stop: arguments.stop,
        step: arguments.step,
        inputs,
        outputs: (!arguments.record.is_empty()).then(|| arguments.record.clone()),
        set: arguments.set.clone(),
        logging: arguments.verbose,
        allow_nan: arguments.allow_nan,
        ..Options::default()
    };
    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed)).into_diagnostic()?;

    let mut progress = Progress::new();
    let result = simulate(&fmu, &options, |event| {
        progress.show(event);
        if interrupted.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    });
    progress.finish();
    match result {
        Ok(table) => {
            write(&table, arguments.output.as_deref())?;
            report(&table);
            Ok(())
        }
        Err(error) => {
            let Some(table) = error.table() else {
                return Err(BadInput::report(error));
            };
            write(table, arguments.output.as_deref())?;
            report(table);
            // Not `into_diagnostic`: the message already has that of its source.
            Err(miette!("{error}"))
        }
    }
}

fn write(table: &Table, path: Option<&Path>) -> miette::Result<()> {
    let Some(path) = path else {
        return table
            .write_csv(std::io::stdout().lock())
            .into_diagnostic()
            .wrap_err("standard output");
    };
    let place = || path.display().to_string();
    let file = File::create(path).into_diagnostic().wrap_err_with(place)?;
    let mut file = BufWriter::new(file);
    table
        .write_csv(&mut file)
        .into_diagnostic()
        .wrap_err_with(place)?;
    file.flush()
        .map_err(|error| miette!("{}: {error}", path.display()))
}

fn report(table: &Table) {
    let last = table.time.last().copied().unwrap_or(f64::NAN);
    let rows = table.time.len();
    let end = match table.end {
        End::Stop => "reached the stop time",
        End::Terminated => "ended by the FMU",
        End::Interrupted => "ended early",
    };
    eprintln!("{rows} rows up to {last} s: {end}");
}

/// A bar on a terminal, a line now and then elsewhere; both on standard error.
struct Progress {
    bar: Option<ProgressBar>,
    /// Simulated time [s] and moment of the first communication point.
    began: Option<(f64, Instant)>,
    last_line: Instant,
}

impl Progress {
    fn new() -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}  ETA {eta}");
            let bar = ProgressBar::new(0);
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar
        });
        Self {
            bar,
            began: None,
            last_line: Instant::now(),
        }
    }

    fn show(&mut self, event: Event<'_>) {
        match event {
            Event::Time { time, step, steps } => self.time(time, step, steps),
            Event::Message(message) => self.line(&message.to_string()),
            Event::MessagesLost(count) => self.line(&format!("{count} more messages were lost")),
            _ => {}
        }
    }

    fn time(&mut self, time: f64, step: u64, steps: u64) {
        let (start, began) = *self.began.get_or_insert_with(|| (time, Instant::now()));
        if let Some(bar) = &self.bar {
            let factor = (time - start) / began.elapsed().as_secs_f64();
            bar.set_length(steps);
            bar.set_position(step);
            bar.set_message(format!("{time:.4} s, {factor:.2} times real time"));
        } else if self.last_line.elapsed() >= LINE_INTERVAL {
            self.last_line = Instant::now();
            eprintln!("{time:.4} s, step {step} of {steps}");
        }
    }

    fn line(&self, text: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| eprintln!("{text}")),
            None => eprintln!("{text}"),
        }
    }

    fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
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
