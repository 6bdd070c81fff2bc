//! One instance of a foreign FMU: the calls of the standard, each allowed in its phases and judged by its status.
//!
//! Here is its life; values are in [`exchange`], saved states in [`state`].

mod exchange;
mod state;

use std::ffi::{CString, c_int};
use std::fmt;
use std::sync::Arc;

use super::abi::{self, Callbacks, Component, FmuState, Functions, RawStatus};
use super::library::Library;
use super::logger::{self, Log, Message};
use super::{Fmu, ImportError, Phase, Status};

pub use state::SavedState;

use Phase::{Discarded, Failed, Initialization, Instantiated, Stepping, Terminated};

const GET: &[Phase] = &[Initialization, Stepping, Discarded, Failed, Terminated];
const SET: &[Phase] = &[Instantiated, Initialization, Stepping];
/// As importers do it, a step may follow a discarded one without restoring a state.
const STEP: &[Phase] = &[Stepping, Discarded];
const STATUS: &[Phase] = &[Stepping, Discarded, Failed, Terminated];
const ALIVE: &[Phase] = &[
    Instantiated,
    Initialization,
    Stepping,
    Discarded,
    Failed,
    Terminated,
];

/// Messages that an error repeats.
const TAIL: usize = 3;

/// What became of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// The step is done.
    Done,
    /// The step is not done, or in part only.
    Discarded {
        /// Time up to which it is done \[s\]; `None` if the FMU does not tell.
        last_successful_time: Option<f64>,
        /// The FMU wants to end the simulation.
        terminated: bool,
    },
}

/// One instance. Dropping it frees the instance, then the library if it was the last.
///
/// After `Fatal` nothing is freed: the standard forbids every further call.
pub struct Instance {
    component: Component,
    phase: Phase,
    states: Vec<FmuState>,
    log: Arc<Log>,
    /// The library points to it until the instance is freed.
    callbacks: Arc<Callbacks>,
    library: Arc<Library>,
}

// SAFETY: FMI lets any one thread at a time call an instance; the pointers are shared with no other instance.
unsafe impl Send for Instance {}

impl fmt::Debug for Instance {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Instance")
            .field("phase", &self.phase)
            .field("library", &self.library)
            .finish_non_exhaustive()
    }
}

impl Instance {
    pub(super) fn new(
        library: Arc<Library>,
        fmu: &Fmu,
        name: &str,
        logging: bool,
    ) -> Result<Self, ImportError> {
        const FUNCTION: &str = "fmi2Instantiate";
        if library.is_dead() {
            return Err(ImportError::Phase {
                function: FUNCTION,
                found: Phase::Dead,
                expected: "never so".to_owned(),
            });
        }
        let instance_name = c_text(FUNCTION, name)?;
        let guid = c_text(FUNCTION, &fmu.description().guid)?;
        let resources = fmu.folder().join("resources");
        // The folder is absolute; only a path that is not can have no address.
        let resources = url::Url::from_file_path(&resources)
            .map_err(|()| ImportError::Null {
                function: FUNCTION,
                what: format!("the address of {}", resources.display()),
            })?
            .to_string();
        let resources = c_text(FUNCTION, &resources)?;

        let log = Arc::new(Log::default());
        let callbacks = Arc::new(Callbacks {
            logger: logger::collect,
            allocate_memory: libc::calloc,
            free_memory: libc::free,
            step_finished: None,
            component_environment: Arc::as_ptr(&log).cast_mut().cast(),
        });
        let only_one = fmu
            .co_simulation()
            .can_be_instantiated_only_once_per_process;
        if !library.enter(only_one) {
            return Err(ImportError::OnlyOnce);
        }
        // SAFETY: texts and callbacks live through the call, the callbacks until the instance is freed.
        let component = unsafe {
            (library.functions.instantiate)(
                instance_name.as_ptr(),
                abi::CO_SIMULATION,
                guid.as_ptr(),
                resources.as_ptr(),
                Arc::as_ptr(&callbacks),
                0,
                c_int::from(logging),
            )
        };
        if component.is_null() {
            library.leave();
            return Err(ImportError::Instantiate {
                instance: name.to_owned(),
                log: log.tail(TAIL),
            });
        }
        Ok(Self {
            component,
            phase: Instantiated,
            states: Vec::new(),
            log,
            callbacks,
            library,
        })
    }

    /// Where the instance is in its life.
    pub fn phase(&self) -> Phase {
        if self.library.is_dead() {
            return Phase::Dead;
        }
        self.phase
    }

    /// Takes the messages logged since the last call, and how many more there were than could be kept.
    pub fn take_messages(&self) -> (Vec<Message>, usize) {
        self.log.take()
    }

    /// `fmi2SetDebugLogging`: turns categories on or off; no category means all.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls.
    pub fn set_debug_logging(&mut self, on: bool, categories: &[&str]) -> Result<(), ImportError> {
        const FUNCTION: &str = "fmi2SetDebugLogging";
        let call = self.optional(FUNCTION, |f| f.set_debug_logging)?;
        let texts = c_texts(FUNCTION, categories)?;
        let pointers: Vec<_> = texts.iter().map(|text| text.as_ptr()).collect();
        self.call(FUNCTION, ALIVE, |component| {
            // SAFETY: the list has that many texts.
            unsafe {
                call(
                    component,
                    c_int::from(on),
                    pointers.len(),
                    pointers.as_ptr(),
                )
            }
        })
    }

    /// `fmi2SetupExperiment`: relative tolerance, start and stop time \[s\].
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`], [`ImportError::Phase`].
    pub fn setup_experiment(
        &mut self,
        tolerance: Option<f64>,
        start: f64,
        stop: Option<f64>,
    ) -> Result<(), ImportError> {
        let call = self.library.functions.setup_experiment;
        self.call("fmi2SetupExperiment", &[Instantiated], |component| {
            // SAFETY: plain numbers.
            unsafe {
                call(
                    component,
                    c_int::from(tolerance.is_some()),
                    tolerance.unwrap_or(0.0),
                    start,
                    c_int::from(stop.is_some()),
                    stop.unwrap_or(0.0),
                )
            }
        })
    }

    /// `fmi2EnterInitializationMode`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`], [`ImportError::Phase`].
    pub fn enter_initialization_mode(&mut self) -> Result<(), ImportError> {
        let call = self.library.functions.enter_initialization_mode;
        self.plain(
            "fmi2EnterInitializationMode",
            call,
            &[Instantiated],
            Initialization,
        )
    }

    /// `fmi2ExitInitializationMode`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`], [`ImportError::Phase`].
    pub fn exit_initialization_mode(&mut self) -> Result<(), ImportError> {
        let call = self.library.functions.exit_initialization_mode;
        self.plain(
            "fmi2ExitInitializationMode",
            call,
            &[Initialization],
            Stepping,
        )
    }

    /// `fmi2Terminate`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`], [`ImportError::Phase`].
    pub fn terminate(&mut self) -> Result<(), ImportError> {
        let call = self.library.functions.terminate;
        self.plain("fmi2Terminate", call, &[Stepping, Discarded], Terminated)
    }

    /// `fmi2Reset`: back to what it was after instantiation.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls.
    pub fn reset(&mut self) -> Result<(), ImportError> {
        let call = self.optional("fmi2Reset", |f| f.reset)?;
        self.plain("fmi2Reset", call, ALIVE, Instantiated)
    }

    /// `fmi2DoStep` from `time` by `step` \[s\]. `no_rollback` tells that no state saved before `time` will be
    /// restored.
    ///
    /// A discarded step is no error: the FMU is asked how far it came and whether it wants to end.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] for `Error`, `Fatal`, and `Pending` (nothing may be pending, since no
    /// `stepFinished` was given); [`ImportError::Phase`].
    pub fn do_step(
        &mut self,
        time: f64,
        step: f64,
        no_rollback: bool,
    ) -> Result<Step, ImportError> {
        const FUNCTION: &str = "fmi2DoStep";
        self.allow(FUNCTION, STEP)?;
        // SAFETY: plain numbers, in a phase that allows the call.
        let raw = unsafe {
            (self.library.functions.do_step)(self.component, time, step, c_int::from(no_rollback))
        };
        if Status::from_raw(raw) != Some(Status::Discard) {
            self.judge(FUNCTION, raw)?;
            self.phase = Stepping;
            return Ok(Step::Done);
        }
        self.phase = Discarded;
        // The queries may be refused in turn; then there is nothing to tell.
        let last = self.real_status(abi::LAST_SUCCESSFUL_TIME);
        let terminated = self.boolean_status(abi::TERMINATED);
        if self.phase() == Phase::Dead {
            return Err(self.failed(FUNCTION, Status::Fatal));
        }
        Ok(Step::Discarded {
            last_successful_time: last.ok().filter(|time| time.is_finite()),
            terminated: terminated.unwrap_or(false),
        })
    }

    fn real_status(&mut self, kind: c_int) -> Result<f64, ImportError> {
        const FUNCTION: &str = "fmi2GetRealStatus";
        let call = self.optional(FUNCTION, |f| f.get_real_status)?;
        let mut value = f64::NAN;
        self.call(FUNCTION, STATUS, |component| {
            // SAFETY: `value` is there for the call.
            unsafe { call(component, kind, &raw mut value) }
        })?;
        Ok(value)
    }

    fn boolean_status(&mut self, kind: c_int) -> Result<bool, ImportError> {
        const FUNCTION: &str = "fmi2GetBooleanStatus";
        let call = self.optional(FUNCTION, |f| f.get_boolean_status)?;
        let mut value = 0;
        self.call(FUNCTION, STATUS, |component| {
            // SAFETY: `value` is there for the call.
            unsafe { call(component, kind, &raw mut value) }
        })?;
        Ok(value != 0)
    }
}

/// How every call is made.
impl Instance {
    fn optional<F>(
        &self,
        name: &'static str,
        pick: impl FnOnce(&Functions) -> Option<F>,
    ) -> Result<F, ImportError> {
        self.library.optional(name, pick(&self.library.functions))
    }

    fn plain(
        &mut self,
        function: &'static str,
        call: abi::Plain,
        allowed: &[Phase],
        next: Phase,
    ) -> Result<(), ImportError> {
        self.call(function, allowed, |component| {
            // SAFETY: takes the instance only.
            unsafe { call(component) }
        })?;
        self.phase = next;
        Ok(())
    }

    fn call(
        &mut self,
        function: &'static str,
        allowed: &[Phase],
        call: impl FnOnce(Component) -> RawStatus,
    ) -> Result<(), ImportError> {
        self.allow(function, allowed)?;
        let raw = call(self.component);
        self.judge(function, raw)
    }

    fn allow(&self, function: &'static str, allowed: &[Phase]) -> Result<(), ImportError> {
        let found = self.phase();
        if allowed.contains(&found) {
            return Ok(());
        }
        let expected: Vec<String> = allowed.iter().map(Phase::to_string).collect();
        Err(ImportError::Phase {
            function,
            found,
            expected: expected.join(" or "),
        })
    }

    fn judge(&mut self, function: &'static str, raw: RawStatus) -> Result<(), ImportError> {
        let Some(status) = Status::from_raw(raw) else {
            self.phase = Failed;
            return Err(ImportError::UnknownStatus {
                function,
                found: raw,
            });
        };
        match status {
            Status::Ok | Status::Warning => return Ok(()),
            Status::Discard => {}
            Status::Error | Status::Pending => self.phase = Failed,
            Status::Fatal => self.library.kill(),
        }
        Err(self.failed(function, status))
    }

    fn failed(&self, function: &'static str, status: Status) -> ImportError {
        ImportError::Call {
            function,
            status,
            log: self.log.tail(TAIL),
        }
    }
}

impl Instance {
    /// Leaves the instance as it is: some thread of the library may still log, so the callbacks must stay.
    fn abandon(&self) {
        std::mem::forget((Arc::clone(&self.log), Arc::clone(&self.callbacks)));
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        if self.library.is_dead() {
            return self.abandon();
        }
        if let Some(free) = self.library.functions.free_fmu_state {
            for mut state in std::mem::take(&mut self.states) {
                // SAFETY: a state of this instance that is not freed.
                let raw = unsafe { free(self.component, &raw mut state) };
                if Status::from_raw(raw) == Some(Status::Fatal) {
                    self.library.kill();
                    return self.abandon();
                }
            }
        }
        // SAFETY: the instance is not freed, and never used again.
        unsafe { (self.library.functions.free_instance)(self.component) };
        self.library.leave();
    }
}

fn c_text(function: &'static str, text: &str) -> Result<CString, ImportError> {
    CString::new(text).map_err(|_| ImportError::Nul {
        function,
        text: text.to_owned(),
    })
}

fn c_texts(function: &'static str, texts: &[&str]) -> Result<Vec<CString>, ImportError> {
    texts.iter().map(|text| c_text(function, text)).collect()
}
