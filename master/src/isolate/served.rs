//! The process of an FMU: loads the library, makes one instance, and calls it as it is asked to.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader};
use std::os::fd::AsFd;
use std::os::unix::net::UnixStream;
use std::path::PathBuf;
use std::sync::mpsc::{self, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use rustix::process::{Signal, getpid, kill_process};

use crate::calls::{Participant, SavedState, Watch};
use crate::error::ImportError;
use crate::fmu::Fmu;

use super::protocol::{Answer, Report, Request, receive, send};

/// Serves one FMU to the process that started this one as [`Isolation`](crate::Isolation) says, and returns when the
/// instance is freed. If the other process ends before, this one ends at once.
///
/// # Errors
///
/// Standard input is not the socket that the other process gives.
pub fn serve() -> io::Result<()> {
    let socket = UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?);
    // Says whether it is a socket with another process at its end.
    socket.peer_addr()?;
    // The FMU shall not read what is not for it.
    rustix::stdio::dup2_stdin(File::open("/dev/null")?)?;
    let out = Arc::new(Mutex::new(socket.try_clone()?));
    let report = move |report: &Report| {
        let mut out = out.lock().unwrap_or_else(PoisonError::into_inner);
        send(&mut *out, report)
    };
    let (requests, asked) = mpsc::channel();
    thread::spawn(move || listen(socket, &requests));

    let to_parent = report.clone();
    let watch = Watch::new(move |event| {
        // If nobody reads it, `listen` ends the process.
        let _unheard = to_parent(&Report::Event(event));
    });
    let mut served = None;
    for request in asked {
        let close = matches!(request, Request::Close);
        let answer = answer(&mut served, request, &watch);
        report(&Report::Answers(answer.map_err(|error| error.to_string())))?;
        if close {
            break;
        }
    }
    Ok(())
}

/// Passes requests on. Without anyone to answer to the process ends, also from within an endless loop of the FMU, and
/// without the handlers that the FMU may have for it.
fn listen(socket: UnixStream, requests: &Sender<Request<'static>>) {
    let mut input = BufReader::new(socket);
    while let Ok(request) = receive(&mut input) {
        if requests.send(request).is_err() {
            return;
        }
    }
    let _ended = kill_process(getpid(), Signal::KILL);
}

/// Does what is asked; `served` is the instance while there is one.
fn answer(
    served: &mut Option<Served>,
    request: Request<'_>,
    watch: &Watch,
) -> Result<Answer, ImportError> {
    match (request, served) {
        (
            Request::Start {
                path,
                folder,
                name,
                logging,
            },
            served,
        ) => *served = Some(Served::new(path, folder, &name, logging, watch)?),
        (Request::Close, served) => *served = None,
        (request, Some(served)) => return served.answer(request),
        (_, None) => return Err(ImportError::Isolated("found no instance".to_owned())),
    }
    Ok(Answer::Done)
}

/// The instance, dropped before its FMU.
struct Served {
    instance: Box<dyn Participant>,
    states: BTreeMap<u64, SavedState>,
    /// Number of the next state.
    next: u64,
    _fmu: Fmu,
}

impl Served {
    fn new(
        path: PathBuf,
        folder: PathBuf,
        name: &str,
        logging: bool,
        watch: &Watch,
    ) -> Result<Self, ImportError> {
        let fmu = Fmu::unpacked(path, folder, watch.clone())?;
        Ok(Self {
            instance: fmu.participant(name, logging)?,
            states: BTreeMap::new(),
            next: 0,
            _fmu: fmu,
        })
    }

    fn answer(&mut self, request: Request<'_>) -> Result<Answer, ImportError> {
        let answer = self.call(request);
        // They are told already, each when it came.
        let _told = self.instance.messages();
        answer
    }

    fn call(&mut self, request: Request<'_>) -> Result<Answer, ImportError> {
        let instance = &mut *self.instance;
        match request {
            Request::SetUp {
                tolerance,
                start,
                stop,
                values,
            } => instance.set_up(tolerance, start, stop, &values.into_owned())?,
            Request::EnterInitialization => instance.enter_initialization()?,
            Request::ExitInitialization => instance.exit_initialization()?,
            Request::Get(places) => return Ok(Answer::Values(instance.get(&places)?)),
            Request::Set(values) => instance.set(&values.into_owned())?,
            Request::Step {
                time,
                step,
                no_rollback,
            } => return Ok(Answer::Step(instance.step(time, step, no_rollback)?)),
            Request::Save => {
                let number = self.next;
                self.next += 1;
                self.states.insert(number, instance.save()?);
                return Ok(Answer::State(number));
            }
            Request::Restore(number) => match self.states.get(&number) {
                Some(state) => instance.restore(state)?,
                None => return Err(no_state(number)),
            },
            Request::Free(number) => match self.states.remove(&number) {
                Some(state) => instance.free(state)?,
                None => return Err(no_state(number)),
            },
            Request::Finish => instance.finish()?,
            Request::Start { .. } | Request::Close => {}
        }
        Ok(Answer::Done)
    }
}

fn no_state(number: u64) -> ImportError {
    ImportError::Isolated(format!("found no state of number {number}"))
}
