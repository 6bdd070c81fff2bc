//! An instance in a process of its own, as the simulation sees it.

use std::borrow::Cow;
use std::io::{self, BufReader};
use std::net::Shutdown;
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crate::calls::{
    CallEvent, InputValues, Log, Message, Participant, SavedState, Step, TAIL, Watch,
};
use crate::error::ImportError;
use crate::fmu::Fmu;
use crate::value::Value;
use crate::variable::Place;

use super::Isolation;
use super::protocol::{Answer, Report, Request, receive, send};

/// Time between two looks whether the process is still there: one that it started itself may hold the socket.
const LOOK: Duration = Duration::from_millis(500);

/// Makes an instance of `fmu` in a process of its own.
///
/// # Errors
///
/// Those of [`Fmu::instantiate`] as [`ImportError::Isolated`]; [`ImportError::Ended`], [`TimedOut`](ImportError::TimedOut)
/// and [`Process`](ImportError::Process).
pub(crate) fn participant(
    isolation: &Isolation,
    fmu: &Fmu,
    name: &str,
    logging: bool,
) -> Result<Box<dyn Participant>, ImportError> {
    let path = fmu.path().to_owned();
    let start = || -> io::Result<_> {
        let (ours, theirs) = UnixStream::pair()?;
        let child = Command::new(&isolation.program)
            .args(&isolation.arguments)
            .stdin(OwnedFd::from(theirs))
            .stdout(Stdio::from(io::stderr()))
            .spawn()?;
        Ok((ours.try_clone()?, ours, child))
    };
    let (reports, socket, child) = match start() {
        Ok(started) => started,
        Err(source) => return Err(ImportError::Process { path, source }),
    };
    let log = Arc::new(Log::new(name, Watch::default()));
    let current = Arc::new(Mutex::new(Current::default()));
    let (answer, answers) = mpsc::channel();
    let (heard, now) = (Arc::clone(&log), Arc::clone(&current));
    thread::spawn(move || listen(reports, &heard, &now, &answer));
    let mut instance = Isolated {
        path,
        child,
        socket,
        answers,
        current,
        log,
        limit: isolation.call_timeout,
        over: false,
    };
    instance.done(&Request::Start {
        path: fmu.path().to_owned(),
        folder: fmu.folder().to_owned(),
        name: Cow::Borrowed(name),
        logging,
    })?;
    Ok(Box::new(instance))
}

/// Hears reports until the socket ends, then drops `answers`.
fn listen(
    socket: UnixStream,
    log: &Log,
    current: &Mutex<Current>,
    answers: &Sender<Result<Answer, String>>,
) {
    let mut input = BufReader::new(socket);
    while let Ok(report) = receive(&mut input) {
        match report {
            Report::Event(CallEvent::Calling(function)) => {
                *lock(current) = Current {
                    function,
                    since: Instant::now(),
                };
            }
            Report::Event(CallEvent::Logged(message)) => log.push(message),
            Report::Answers(answer) => {
                let _instance_is_gone = answers.send(answer);
            }
        }
    }
}

/// The call that was begun last.
struct Current {
    function: String,
    since: Instant,
}

impl Default for Current {
    fn default() -> Self {
        Self {
            function: "start of its process".to_owned(),
            since: Instant::now(),
        }
    }
}

fn lock(current: &Mutex<Current>) -> MutexGuard<'_, Current> {
    current.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether a socket says that nobody is at its other end.
fn is_end(error: &io::Error) -> bool {
    use io::ErrorKind::{BrokenPipe, ConnectionReset};
    matches!(error.kind(), BrokenPipe | ConnectionReset)
}

/// The instance. Dropping it frees it in its process, and ends that.
struct Isolated {
    path: PathBuf,
    child: Child,
    socket: UnixStream,
    /// Answers to requests; ends with the process.
    answers: Receiver<Result<Answer, String>>,
    current: Arc<Mutex<Current>>,
    log: Arc<Log>,
    limit: Option<Duration>,
    /// The process has ended, and that is told or was asked for.
    over: bool,
}

impl Isolated {
    fn ask(&mut self, request: &Request<'_>) -> Result<Answer, ImportError> {
        lock(&self.current).since = Instant::now();
        match send(&mut self.socket, request) {
            Ok(()) => {}
            Err(error) if is_end(&error) => return Err(self.ended()),
            Err(source) => return Err(self.misunderstood(source)),
        }
        match self.wait()? {
            Some(answer) => answer.map_err(ImportError::Isolated),
            None => Err(self.ended()),
        }
    }

    fn done(&mut self, request: &Request<'_>) -> Result<(), ImportError> {
        match self.ask(request)? {
            Answer::Done => Ok(()),
            _ => Err(self.unexpected()),
        }
    }

    /// The next answer; `None` if the process has ended without one.
    fn wait(&mut self) -> Result<Option<Result<Answer, String>>, ImportError> {
        loop {
            let pause = match self.limit {
                None => LOOK,
                Some(limit) => {
                    // Each call has its own time: another may have begun meanwhile.
                    let left = limit.saturating_sub(lock(&self.current).since.elapsed());
                    if left.is_zero() {
                        return Err(self.timed_out(limit));
                    }
                    left.min(LOOK)
                }
            };
            match self.answers.recv_timeout(pause) {
                Ok(answer) => return Ok(Some(answer)),
                Err(RecvTimeoutError::Disconnected) => return Ok(None),
                Err(RecvTimeoutError::Timeout) => {
                    if self.child.try_wait().is_ok_and(|end| end.is_some()) {
                        return Ok(None);
                    }
                }
            }
        }
    }

    /// Waits for the end of the process, which is forced if it is still alive: one that ends by itself is past that.
    fn end(&mut self) -> io::Result<ExitStatus> {
        self.over = true;
        let _gone = self.child.kill();
        self.child.wait()
    }

    fn ended(&mut self) -> ImportError {
        let path = self.path.clone();
        match self.end() {
            Ok(how) => ImportError::Ended {
                path,
                function: lock(&self.current).function.clone(),
                how,
                log: self.log.tail(TAIL),
            },
            Err(source) => ImportError::Process { path, source },
        }
    }

    fn timed_out(&mut self, limit: Duration) -> ImportError {
        let _killed = self.end();
        ImportError::TimedOut {
            path: self.path.clone(),
            function: lock(&self.current).function.clone(),
            limit,
            log: self.log.tail(TAIL),
        }
    }

    fn misunderstood(&mut self, source: io::Error) -> ImportError {
        let _killed = self.end();
        ImportError::Process {
            path: self.path.clone(),
            source,
        }
    }

    fn unexpected(&mut self) -> ImportError {
        self.misunderstood(io::Error::other("found an answer to another request"))
    }

    /// The number of a state of this instance.
    fn number(&self, state: &SavedState) -> Result<u64, ImportError> {
        let number = state.number(&self.log);
        number.ok_or(ImportError::ForeignState {
            function: "saved state",
        })
    }
}

impl Participant for Isolated {
    fn set_up(
        &mut self,
        tolerance: Option<f64>,
        start: f64,
        stop: f64,
        values: &InputValues,
    ) -> Result<(), ImportError> {
        self.done(&Request::SetUp {
            tolerance,
            start,
            stop,
            values: Cow::Borrowed(values),
        })
    }

    fn enter_initialization(&mut self) -> Result<(), ImportError> {
        self.done(&Request::EnterInitialization)
    }

    fn exit_initialization(&mut self) -> Result<(), ImportError> {
        self.done(&Request::ExitInitialization)
    }

    fn get(&mut self, places: &[Place]) -> Result<Vec<Value>, ImportError> {
        match self.ask(&Request::Get(Cow::Borrowed(places)))? {
            Answer::Values(values) => Ok(values),
            _ => Err(self.unexpected()),
        }
    }

    fn set(&mut self, values: &InputValues) -> Result<(), ImportError> {
        self.done(&Request::Set(Cow::Borrowed(values)))
    }

    fn step(&mut self, time: f64, step: f64, no_rollback: bool) -> Result<Step, ImportError> {
        let request = Request::Step {
            time,
            step,
            no_rollback,
        };
        match self.ask(&request)? {
            Answer::Step(step) => Ok(step),
            _ => Err(self.unexpected()),
        }
    }

    fn save(&mut self) -> Result<SavedState, ImportError> {
        match self.ask(&Request::Save)? {
            Answer::State(number) => Ok(SavedState::there(number, &self.log)),
            _ => Err(self.unexpected()),
        }
    }

    fn restore(&mut self, state: &SavedState) -> Result<(), ImportError> {
        let number = self.number(state)?;
        self.done(&Request::Restore(number))
    }

    fn free(&mut self, state: SavedState) -> Result<(), ImportError> {
        let number = self.number(&state)?;
        self.done(&Request::Free(number))
    }

    fn finish(&mut self) -> Result<(), ImportError> {
        self.done(&Request::Finish)
    }

    fn close(&mut self) -> Result<(), ImportError> {
        if self.over {
            return Ok(());
        }
        self.done(&Request::Close)?;
        // What the library does at the end of its process is the last that can fail.
        while self.wait()?.is_some() {}
        self.over = true;
        match self.child.wait() {
            Ok(status) if status.success() => Ok(()),
            _ => Err(self.ended()),
        }
    }

    fn messages(&self) -> (Vec<Message>, usize) {
        self.log.take()
    }
}

impl Drop for Isolated {
    fn drop(&mut self) {
        // A failure before this one is what is told.
        let _closed = self.close();
        let _gone = self.end();
        // Whoever else holds the socket, the thread that reads it ends.
        let _shut = self.socket.shutdown(Shutdown::Both);
    }
}
