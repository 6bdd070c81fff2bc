//! One instance of a foreign FMU: how calls are allowed in their phases and judged by their status.

use std::ffi::CString;
use std::fmt;
use std::sync::Arc;

use crate::error::ImportError;
use crate::status::{Phase, RawStatus, Status};

use super::library::{Handle, Interface, Library};
use super::logger::Log;
use super::watch::Message;

use Phase::{Discarded, Event, Failed, Initialization, Instantiated, Stepping, Terminated};

pub(super) const GET: &[Phase] = &[
    Initialization,
    Stepping,
    Event,
    Discarded,
    Failed,
    Terminated,
];
pub(super) const SET: &[Phase] = &[Instantiated, Initialization, Stepping, Event];
/// As importers do it, a step may follow a discarded one without restoring a state.
pub(super) const STEP: &[Phase] = &[Stepping, Discarded];
pub(super) const STATUS: &[Phase] = &[Stepping, Discarded, Failed, Terminated];
pub(super) const ALIVE: &[Phase] = &[
    Instantiated,
    Initialization,
    Stepping,
    Event,
    Discarded,
    Failed,
    Terminated,
];

/// Messages that an error repeats.
pub(crate) const TAIL: usize = 3;

/// One instance. Dropping it frees the instance, then the library if it was the last.
///
/// After `Fatal` nothing is freed: the standard forbids every further call.
pub struct Instance<F: Interface> {
    component: Handle,
    pub(super) phase: Phase,
    /// States that are saved and not freed.
    pub(super) states: Vec<Handle>,
    pub(super) log: Arc<Log>,
    /// Callbacks that the library points to until the instance is freed.
    callbacks: Arc<F::Callbacks>,
    pub(super) library: Arc<Library<F>>,
}

// SAFETY: FMI lets any one thread at a time call an instance; the pointers are shared with no other instance.
unsafe impl<F: Interface + Send + Sync> Send for Instance<F> {}

impl<F: Interface> fmt::Debug for Instance<F> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Instance")
            .field("phase", &self.phase)
            .field("library", &self.library)
            .finish_non_exhaustive()
    }
}

impl<F: Interface> Instance<F> {
    /// Makes an instance with `make`, which gets what log messages are to come back with.
    pub(super) fn make(
        library: Arc<Library<F>>,
        function: &'static str,
        name: &str,
        only_one: bool,
        callbacks: impl FnOnce(&Arc<Log>) -> F::Callbacks,
        make: impl FnOnce(&F, &Arc<Log>, &Arc<F::Callbacks>) -> Handle,
    ) -> Result<Self, ImportError> {
        if library.is_dead() {
            return Err(ImportError::Phase {
                function,
                found: Phase::Dead,
                expected: "never so".to_owned(),
            });
        }
        let log = Arc::new(Log::new(name, library.watch.clone()));
        let callbacks = Arc::new(callbacks(&log));
        if !library.enter(only_one) {
            return Err(ImportError::OnlyOnce);
        }
        log.calling(function);
        let component = make(&library.functions, &log, &callbacks);
        if component.is_null() {
            library.leave();
            return Err(ImportError::Instantiate {
                function,
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

    pub(super) fn component(&self) -> Handle {
        self.component
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
}

/// How every call is made.
impl<F: Interface> Instance<F> {
    pub(super) fn optional<C>(
        &self,
        name: &'static str,
        pick: impl FnOnce(&F) -> Option<C>,
    ) -> Result<C, ImportError> {
        self.library.optional(name, pick(&self.library.functions))
    }

    pub(super) fn plain(
        &mut self,
        function: &'static str,
        call: unsafe extern "C" fn(Handle) -> RawStatus,
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

    pub(super) fn call(
        &mut self,
        function: &'static str,
        allowed: &[Phase],
        call: impl FnOnce(Handle) -> RawStatus,
    ) -> Result<(), ImportError> {
        self.allow(function, allowed)?;
        let raw = call(self.component);
        self.judge(function, raw)
    }

    /// Whether the call is allowed now; if so, it follows at once.
    pub(super) fn allow(
        &self,
        function: &'static str,
        allowed: &[Phase],
    ) -> Result<(), ImportError> {
        let found = self.phase();
        if allowed.contains(&found) {
            self.log.calling(function);
            return Ok(());
        }
        let expected: Vec<String> = allowed.iter().map(Phase::to_string).collect();
        Err(ImportError::Phase {
            function,
            found,
            expected: expected.join(" or "),
        })
    }

    pub(super) fn judge(
        &mut self,
        function: &'static str,
        raw: RawStatus,
    ) -> Result<(), ImportError> {
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

    pub(super) fn failed(&self, function: &'static str, status: Status) -> ImportError {
        ImportError::Call {
            function,
            status,
            log: self.log.tail(TAIL),
        }
    }
}

impl<F: Interface> Instance<F> {
    /// Leaves the instance as it is: some thread of the library may still log, so the callbacks must stay.
    fn abandon(&self) {
        std::mem::forget((Arc::clone(&self.log), Arc::clone(&self.callbacks)));
    }
}

impl<F: Interface> Drop for Instance<F> {
    fn drop(&mut self) {
        if self.library.is_dead() {
            return self.abandon();
        }
        let (function, free) = self.library.functions.states().free;
        if let Some(free) = free {
            for mut state in std::mem::take(&mut self.states) {
                self.log.calling(function);
                // SAFETY: a state of this instance that is not freed.
                let raw = unsafe { free(self.component, &raw mut state) };
                if Status::from_raw(raw) == Some(Status::Fatal) {
                    self.library.kill();
                    return self.abandon();
                }
            }
        }
        self.log.calling(F::FREE);
        // SAFETY: the instance is not freed, and never used again.
        unsafe { self.library.functions.free(self.component) };
        self.library.leave();
    }
}

pub(super) fn c_text(function: &'static str, text: &str) -> Result<CString, ImportError> {
    CString::new(text).map_err(|_| ImportError::Nul {
        function,
        text: text.to_owned(),
    })
}

pub(super) fn c_texts(function: &'static str, texts: &[&str]) -> Result<Vec<CString>, ImportError> {
    texts.iter().map(|text| c_text(function, text)).collect()
}
