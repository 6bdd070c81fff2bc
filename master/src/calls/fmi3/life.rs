//! Life and steps of an instance of FMI 3.0, without intermediate updates.
//!
//! Events of an FMU that has an event mode are handled in it (`eventModeUsed`); then its steps may return early if
//! they need not all have one length.

use std::ffi::c_void;
use std::path::MAIN_SEPARATOR;
use std::sync::Arc;

use sphere_dda_fmi_interface::platform::Platform;

use super::abi::Functions;
use crate::calls::instance::{Instance, STEP, c_text};
use crate::calls::library::{Interface, Library, StateCalls, expect};
use crate::calls::logger;
use crate::error::ImportError;
use crate::open::Opened;
use crate::status::{Phase, Status};

impl Interface for Functions {
    const FREE: &'static str = "fmi3FreeInstance";

    type Callbacks = ();

    unsafe fn resolve(library: &libloading::Library) -> Result<Self, &'static str> {
        // SAFETY: passed on to the caller.
        unsafe { Self::look_up(library) }
    }

    fn check(&self) -> Result<(), ImportError> {
        expect("fmi3GetVersion", self.get_version, "3.0")
    }

    fn platforms() -> Vec<&'static str> {
        vec![Platform::HERE.tuple]
    }

    fn states(&self) -> StateCalls {
        self.state_calls()
    }

    unsafe fn free(&self, instance: *mut c_void) {
        // SAFETY: passed on to the caller.
        unsafe { (self.free_instance)(instance) }
    }
}

impl Instance<Functions> {
    pub(crate) fn new(
        library: Arc<Library<Functions>>,
        fmu: &Opened,
        name: &str,
        logging: bool,
    ) -> Result<Self, ImportError> {
        const FUNCTION: &str = "fmi3InstantiateCoSimulation";
        let instance_name = c_text(FUNCTION, name)?;
        let token = c_text(FUNCTION, fmu.description.token())?;
        let resources = fmu.resources();
        // The standard wants a separator at the end.
        let resources = format!("{}{MAIN_SEPARATOR}", resources.display());
        let resources = c_text(FUNCTION, &resources)?;
        let only_one = fmu.description.only_one_instance();
        let events = fmu.description.has_event_mode();
        let early_return = events && fmu.description.takes_any_step();
        Self::make(
            library,
            FUNCTION,
            name,
            only_one,
            |_| (),
            |functions, log, _| {
                // SAFETY: texts live through the call, the log until the instance is freed.
                unsafe {
                    (functions.instantiate)(
                        instance_name.as_ptr(),
                        token.as_ptr(),
                        resources.as_ptr(),
                        0,
                        u8::from(logging),
                        u8::from(events),
                        u8::from(early_return),
                        std::ptr::null(),
                        0,
                        Arc::as_ptr(log).cast_mut().cast(),
                        logger::collect_finished,
                        None,
                    )
                }
            },
        )
    }

    /// `fmi3EnterInitializationMode`: relative tolerance, start and stop time \[s\].
    pub(crate) fn enter_initialization_mode(
        &mut self,
        tolerance: Option<f64>,
        start: f64,
        stop: f64,
    ) -> Result<(), ImportError> {
        let call = self.library.functions.enter_initialization_mode;
        let allowed = &[Phase::Instantiated];
        self.call("fmi3EnterInitializationMode", allowed, |instance| {
            // SAFETY: plain numbers.
            unsafe {
                call(
                    instance,
                    u8::from(tolerance.is_some()),
                    tolerance.unwrap_or(0.0),
                    start,
                    1,
                    stop,
                )
            }
        })?;
        self.phase = Phase::Initialization;
        Ok(())
    }

    /// `fmi3ExitInitializationMode`: the instance is then at a communication point, or with `events` in event mode.
    pub(crate) fn exit_initialization_mode(&mut self, events: bool) -> Result<(), ImportError> {
        let call = self.library.functions.exit_initialization_mode;
        let allowed = &[Phase::Initialization];
        let next = if events {
            Phase::Event
        } else {
            Phase::Stepping
        };
        self.plain("fmi3ExitInitializationMode", call, allowed, next)
    }

    /// `fmi3EnterEventMode`.
    pub(crate) fn enter_event_mode(&mut self) -> Result<(), ImportError> {
        const FUNCTION: &str = "fmi3EnterEventMode";
        let call = self.optional(FUNCTION, |f| f.enter_event_mode)?;
        self.plain(FUNCTION, call, &[Phase::Stepping], Phase::Event)
    }

    /// `fmi3EnterStepMode`.
    pub(crate) fn enter_step_mode(&mut self) -> Result<(), ImportError> {
        const FUNCTION: &str = "fmi3EnterStepMode";
        let call = self.optional(FUNCTION, |f| f.enter_step_mode)?;
        self.plain(FUNCTION, call, &[Phase::Event], Phase::Stepping)
    }

    /// `fmi3UpdateDiscreteStates`, once.
    pub(crate) fn update_discrete_states(&mut self) -> Result<Updated, ImportError> {
        const FUNCTION: &str = "fmi3UpdateDiscreteStates";
        let call = self.optional(FUNCTION, |f| f.update_discrete_states)?;
        let (mut again, mut terminated, mut nominals, mut values) = (0, 0, 0, 0);
        let (mut defined, mut time) = (0, f64::NAN);
        self.call(FUNCTION, &[Phase::Event], |instance| {
            // SAFETY: the six results are there for the call, in a phase that allows it.
            unsafe {
                call(
                    instance,
                    &raw mut again,
                    &raw mut terminated,
                    &raw mut nominals,
                    &raw mut values,
                    &raw mut defined,
                    &raw mut time,
                )
            }
        })?;
        Ok(Updated {
            again: again != 0,
            terminated: terminated != 0,
            next_event: Some(time).filter(|time| defined != 0 && time.is_finite()),
        })
    }

    /// `fmi3Terminate`.
    pub(crate) fn terminate(&mut self) -> Result<(), ImportError> {
        let call = self.library.functions.terminate;
        let allowed = &[Phase::Stepping, Phase::Discarded];
        self.plain("fmi3Terminate", call, allowed, Phase::Terminated)
    }

    /// `fmi3DoStep` from `time` by `step` \[s\].
    pub(crate) fn do_step(
        &mut self,
        time: f64,
        step: f64,
        no_rollback: bool,
    ) -> Result<Returned, ImportError> {
        const FUNCTION: &str = "fmi3DoStep";
        self.allow(FUNCTION, STEP)?;
        let call = self.library.functions.do_step;
        let (mut event, mut terminated, mut early) = (0, 0, 0);
        let mut last = f64::NAN;
        // SAFETY: the four results are there for the call, in a phase that allows it.
        let raw = unsafe {
            call(
                self.component(),
                time,
                step,
                u8::from(no_rollback),
                &raw mut event,
                &raw mut terminated,
                &raw mut early,
                &raw mut last,
            )
        };
        let discarded = Status::from_raw(raw) == Some(Status::Discard);
        if discarded {
            self.phase = Phase::Discarded;
        } else {
            self.judge(FUNCTION, raw)?;
            self.phase = Phase::Stepping;
        }
        Ok(Returned {
            discarded,
            event: event != 0,
            terminated: terminated != 0,
            early: early != 0,
            last_successful_time: Some(last).filter(|time| time.is_finite()),
        })
    }
}

/// How `fmi3DoStep` returned.
pub(crate) struct Returned {
    pub(crate) discarded: bool,
    /// There is an event to handle.
    pub(crate) event: bool,
    /// The FMU wants to end the simulation.
    pub(crate) terminated: bool,
    /// Before the end of the step.
    pub(crate) early: bool,
    /// Time up to which it is done \[s\], if the FMU tells.
    pub(crate) last_successful_time: Option<f64>,
}

/// What `fmi3UpdateDiscreteStates` says.
pub(crate) struct Updated {
    /// It is to be called once more.
    pub(crate) again: bool,
    /// The FMU wants to end the simulation.
    pub(crate) terminated: bool,
    /// Time of the next event that is known \[s\].
    pub(crate) next_event: Option<f64>,
}
