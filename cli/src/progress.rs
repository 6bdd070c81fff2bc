//! Progress of a run, Ctrl-C, and text for people: a bar on a terminal, a line now and then elsewhere.
//!
//! Progress and messages go to standard error, results to standard output, so that a pipe gets results only.

use std::fmt;
use std::io::{self, IsTerminal, Write};
use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use crate::failure::Failure;

/// Time between two lines of progress where there is no terminal.
const LINE_INTERVAL: Duration = Duration::from_secs(5);
/// Time between two updates of the bar.
const BAR_INTERVAL: Duration = Duration::from_millis(100);
/// Length of the bar in its own units.
const BAR_LENGTH: u64 = 1000;

/// Ctrl-C: the first asks the run to end at the next communication point, the second ends the program.
#[derive(Debug, Clone)]
pub(crate) struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens from now on; once per process.
    pub(crate) fn listen() -> Result<Self, Failure> {
        let asked = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&asked);
        let heard = move || {
            if flag.swap(true, Ordering::Relaxed) {
                sphere_dda_master::remove_unpacked();
                process::exit(130);
            }
        };
        ctrlc::set_handler(heard).map_err(Failure::run)?;
        Ok(Self(asked))
    }

    /// Whether the run shall end.
    pub(crate) fn requested(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// How a run gets on, up to its stop time.
pub(crate) struct Progress {
    bar: Option<ProgressBar>,
    /// Start and stop of the simulated time \[s\]; of a search for rest none is known.
    span: Option<(f64, f64)>,
    began: Instant,
    shown: Instant,
}

impl Progress {
    /// A run from `start` to `stop` \[s\] that begins now.
    pub(crate) fn new(start: f64, stop: f64) -> Self {
        Self::begin("{bar:30} {msg}", Some((start, stop)))
    }

    /// Work whose end is not known.
    pub(crate) fn open() -> Self {
        Self::begin("{spinner} {msg}", None)
    }

    /// Work of a number of parts.
    pub(crate) fn counted() -> Self {
        Self::begin("{bar:30} {msg}", None)
    }

    /// Of the work `done` parts of `of` are done, called by `noun`.
    pub(crate) fn part(&mut self, done: usize, of: usize, noun: &str) {
        self.reached(done as f64 / of.max(1) as f64, || {
            format!("{noun} {done} of {of}")
        });
    }

    /// Of the work so much is done, 0 to 1.
    pub(crate) fn share(&mut self, share: f64) {
        self.reached(share, || format!("{:.0} %", (100.0 * share).floor()));
    }

    fn reached(&mut self, share: f64, text: impl FnOnce() -> String) {
        if let Some(bar) = &self.bar {
            bar.set_position((share * BAR_LENGTH as f64) as u64);
        }
        let remaining = self.began.elapsed().as_secs_f64() * (1.0 - share) / share;
        self.say(|| match remaining.is_finite() {
            true => format!("{}, ETA {:.0} s", text(), remaining.max(0.0)),
            false => text(),
        });
    }

    fn begin(template: &str, span: Option<(f64, f64)>) -> Self {
        let now = Instant::now();
        let bar = io::stderr().is_terminal().then(|| {
            let style = ProgressStyle::with_template(template);
            let bar = ProgressBar::new(BAR_LENGTH);
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar
        });
        Self {
            bar,
            span,
            began: now,
            shown: now,
        }
    }

    /// The run has come to `time` \[s\]; `detail` is asked for only if it is shown.
    pub(crate) fn show(&mut self, time: f64, detail: impl FnOnce() -> String) {
        let (start, stop) = self.span.unwrap_or((0.0, f64::INFINITY));
        let done = (time - start) / (stop - start);
        let wall = self.began.elapsed().as_secs_f64();
        let factor = (time - start) / wall;
        let remaining = wall * (1.0 - done) / done;
        if let Some(bar) = &self.bar {
            bar.set_position((done * BAR_LENGTH as f64) as u64);
        }
        self.say(|| {
            // First what a narrow terminal must not cut off.
            let mut text = format!("{time:.3} of {stop} s");
            if remaining.is_finite() {
                text += &format!(", ETA {remaining:.0} s");
            }
            let detail = detail();
            if !detail.is_empty() {
                text += &format!(", {detail}");
            }
            text + &format!(", {}", speed(factor))
        });
    }

    /// Shows `text` if it is time to; only then is it asked for.
    pub(crate) fn say(&mut self, text: impl FnOnce() -> String) {
        let interval = match &self.bar {
            Some(_) => BAR_INTERVAL,
            None => LINE_INTERVAL,
        };
        if self.shown.elapsed() < interval {
            return;
        }
        self.shown = Instant::now();
        match &self.bar {
            Some(bar) => bar.set_message(text()),
            None => note(text()),
        }
    }

    /// Shows a message above the bar.
    pub(crate) fn note(&self, text: impl fmt::Display) {
        match &self.bar {
            Some(bar) => bar.suspend(|| note(text)),
            None => note(text),
        }
    }

    /// Wall time \[s\] since the beginning.
    pub(crate) fn wall_time(&self) -> f64 {
        self.began.elapsed().as_secs_f64()
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

/// How long a run took and how that compares with the time it simulated, both in seconds:
/// `2.26 s, 3.8 times faster than real time`.
pub(crate) fn wall_time(wall: f64, simulated: f64) -> String {
    format!("{wall:.2} s, {}", speed(simulated / wall))
}

/// Simulated over wall time, in words.
fn speed(factor: f64) -> String {
    let times = |x: f64| match x {
        x if x < 9.95 => format!("{x:.1}"),
        x => format!("{x:.0}"),
    };
    if !factor.is_finite() || factor <= 0.0 {
        "no time simulated".to_owned()
    } else if factor >= 1.0 {
        format!("{} times faster than real time", times(factor))
    } else {
        format!("{} times slower than real time", times(1.0 / factor))
    }
}

/// `1 row`, `2 rows`: a number with its noun.
pub(crate) fn count(n: u64, noun: &str) -> String {
    match n {
        1 => format!("1 {noun}"),
        n => format!("{n} {noun}s"),
    }
}

/// Writes a line to standard error; a closed one is ignored.
pub(crate) fn note(text: impl fmt::Display) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Writes to standard output what `write` has to say. A reader that has seen enough is no failure.
pub(crate) fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::run(error)),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::{count, speed, wall_time};

    #[test]
    fn speed_is_told_in_words() {
        assert_eq!(
            wall_time(2.0, 7.6),
            "2.00 s, 3.8 times faster than real time"
        );
        assert_eq!(speed(1.0 / 12.0), "12 times slower than real time");
        assert_eq!(speed(0.25), "4.0 times slower than real time");
        assert_eq!(speed(f64::NAN), "no time simulated");
    }

    #[test]
    fn one_has_no_plural() {
        assert_eq!(
            (count(1, "row"), count(0, "row")),
            ("1 row".into(), "0 rows".into())
        );
    }
}
