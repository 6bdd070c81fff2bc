//! Damages what sphere-dda reads and looks what becomes of it: an error in words, or a result; never a panic, an abort, an
//! endless loop or all of the memory.
//!
//! Inputs are tried in processes of their own with 4 GiB of memory. Each is a function of target, seed and number, so that the
//! one that ended a process can be made again: it is written to a file, with the command that repeats it.

mod mutate;
mod targets;

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, Command, ExitCode, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use clap::Parser;
use targets::{Target, all};

/// Inputs that one process tries.
const BATCH: u64 = 500;
/// Memory of a process \[byte\].
#[cfg(unix)]
const MEMORY: u64 = 4 << 30;

/// Damages what sphere-dda reads; exits with 1 if anything panics, aborts, hangs or takes more than 4 GiB.
#[derive(Debug, Parser)]
struct Arguments {
    /// One target, instead of all: scene, files, state, xml, archive or calls.
    #[arg(long)]
    target: Option<String>,
    /// Inputs of each target; ignored with --minutes.
    #[arg(long, default_value_t = 500)]
    inputs: u64,
    /// Go on for this long, over the targets in turn.
    #[arg(long)]
    minutes: Option<f64>,
    /// Other inputs.
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Longest time for one input in seconds.
    #[arg(long, default_value_t = 60)]
    limit: u64,
    /// Folder for inputs that fail.
    #[arg(long, default_value = "fuzz-failures")]
    failures: PathBuf,
    /// Try the input in this file alone, in this process; needs --target.
    #[arg(long, requires = "target")]
    input: Option<PathBuf>,
    /// Number of the first input.
    #[arg(long, default_value_t = 0, hide = true)]
    from: u64,
    /// Try the inputs in this process.
    #[arg(long, hide = true)]
    here: bool,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let mut targets = all();
    if let Some(name) = &arguments.target {
        targets.retain(|target| target.name() == name);
    }
    if targets.is_empty() {
        let names: Vec<_> = all().iter().map(|target| target.name()).collect();
        eprintln!("no such target; expected one of {}", names.join(", "));
        return ExitCode::from(2);
    }
    if let Some(path) = &arguments.input {
        return repeat(&*targets[0], path);
    }
    if arguments.here {
        here(&*targets[0], &arguments);
        return ExitCode::SUCCESS;
    }
    match supervise(&targets, &arguments) {
        0 => ExitCode::SUCCESS,
        failures => {
            eprintln!("{failures} inputs failed");
            ExitCode::FAILURE
        }
    }
}

/// A panic that the code under test catches is one all the same.
fn end_at_panics() {
    let told = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |what| {
        told(what);
        std::process::exit(101);
    }));
}

fn repeat(target: &dyn Target, path: &PathBuf) -> ExitCode {
    end_at_panics();
    match fs::read(path) {
        Ok(input) => {
            println!("{:?}", target.attempt(&input));
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("cannot read `{}`: {error}", path.display());
            ExitCode::from(2)
        }
    }
}

/// Tries a batch and says of each input that it begins.
fn here(target: &dyn Target, arguments: &Arguments) {
    end_at_panics();
    #[cfg(unix)]
    {
        use rustix::process::{Resource, Rlimit, setrlimit};
        let limit = Rlimit {
            current: Some(MEMORY),
            maximum: Some(MEMORY),
        };
        if let Err(error) = setrlimit(Resource::As, limit) {
            eprintln!("memory is not limited: {error}");
        }
    }
    let corpus = target.corpus();
    let mut out = std::io::stdout().lock();
    let mut say = |line: String| writeln!(out, "{line}").and_then(|()| out.flush());
    for number in arguments.from..arguments.from + arguments.inputs {
        if say(number.to_string()).is_err() {
            return;
        }
        let input = mutate::input(target.name(), arguments.seed, number, &corpus);
        if target.attempt(&input) && say("taken".to_owned()).is_err() {
            return;
        }
    }
}

/// Tries inputs in other processes; returns how many failed.
fn supervise(targets: &[Box<dyn Target>], arguments: &Arguments) -> usize {
    let end = arguments
        .minutes
        .map(|minutes| Instant::now() + Duration::from_secs_f64(60.0 * minutes));
    let mut failures = 0;
    let mut next = vec![Count::default(); targets.len()];
    loop {
        for (target, count) in targets.iter().zip(&mut next) {
            if end.is_some_and(|end| Instant::now() >= end) {
                break;
            }
            let left = arguments.inputs.saturating_sub(count.tried);
            let batch = if end.is_some() {
                BATCH
            } else {
                left.min(BATCH)
            };
            failures += usize::from(!try_batch(&**target, arguments, count, batch));
        }
        let done = match end {
            Some(end) => Instant::now() >= end,
            None => next.iter().all(|count| count.tried >= arguments.inputs),
        };
        if done {
            break;
        }
    }
    for (target, count) in targets.iter().zip(&next) {
        println!(
            "{:8} {:9} inputs, {:9} taken",
            target.name(),
            count.tried,
            count.taken
        );
    }
    failures
}

#[derive(Debug, Clone, Default)]
struct Count {
    tried: u64,
    taken: u64,
}

/// One batch in a process of its own; one that ends early is told, and the next begins after its last input.
fn try_batch(target: &dyn Target, arguments: &Arguments, count: &mut Count, batch: u64) -> bool {
    if batch == 0 {
        return true;
    }
    let (from, to) = (count.tried, count.tried + batch);
    let mut child = match start(target, arguments, from, batch) {
        Ok(child) => child,
        Err(error) => {
            eprintln!("cannot start a process: {error}");
            count.tried = to;
            return false;
        }
    };
    let (line, lines) = mpsc::channel();
    let out = child.stdout.take();
    let reader = thread::spawn(move || {
        for text in out
            .into_iter()
            .flat_map(|out| BufReader::new(out).lines().map_while(Result::ok))
        {
            if line.send(text).is_err() {
                return;
            }
        }
    });
    let errors = child.stderr.take().map(|mut errors| {
        thread::spawn(move || {
            let mut text = Vec::new();
            let _rest_is_lost = errors.read_to_end(&mut text);
            String::from_utf8_lossy(&text).into_owned()
        })
    });
    let mut last = from;
    let hung = loop {
        match lines.recv_timeout(Duration::from_secs(arguments.limit)) {
            Ok(text) if text == "taken" => count.taken += 1,
            Ok(text) => last = text.parse().unwrap_or(last),
            Err(RecvTimeoutError::Disconnected) => break false,
            Err(RecvTimeoutError::Timeout) => break true,
        }
    };
    if hung {
        let _gone = child.kill();
    }
    let ended = child.wait();
    let _panicked = reader.join();
    let said = errors
        .and_then(|errors| errors.join().ok())
        .unwrap_or_default();
    let sound = !hung && ended.as_ref().is_ok_and(std::process::ExitStatus::success);
    count.tried = if sound { to } else { last + 1 };
    if !sound {
        let how = match (hung, ended) {
            (true, _) => format!("no end within {} s", arguments.limit),
            (false, Ok(status)) => status.to_string(),
            (false, Err(error)) => error.to_string(),
        };
        report(target, arguments, last, &format!("{how}\n{said}"));
    }
    sound
}

fn start(
    target: &dyn Target,
    arguments: &Arguments,
    from: u64,
    batch: u64,
) -> std::io::Result<Child> {
    Command::new(std::env::current_exe()?)
        .args(["--here", "--target", target.name()])
        .args([
            "--seed",
            &arguments.seed.to_string(),
            "--from",
            &from.to_string(),
        ])
        .args(["--inputs", &batch.to_string()])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
}

/// Keeps an input that failed and says how to try it again.
fn report(target: &dyn Target, arguments: &Arguments, number: u64, how: &str) {
    let name = target.name();
    let input = mutate::input(name, arguments.seed, number, &target.corpus());
    let path = arguments
        .failures
        .join(format!("{name}-{}-{number}", arguments.seed));
    let kept = fs::create_dir_all(&arguments.failures).and_then(|()| fs::write(&path, input));
    let path = path.display();
    match kept {
        Ok(()) => eprintln!("{name}: {how}\nagain: sphere-dda-fuzz --target {name} --input {path}"),
        Err(error) => {
            eprintln!("{name}: {how}\ninput {number} is lost: cannot write `{path}`: {error}")
        }
    }
}
