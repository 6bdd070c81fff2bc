//! Life and steps of an instance of FMI 3.0.
//!
//! Events are left to the FMU (`eventModeUsed` is false), there are no intermediate updates and no early return.

use std::ffi::c_void;
use std::path::MAIN_SEPARATOR;
use std::sync::Arc;

use sphere_dda_fmi_interface::platform::Platform;

use super::abi::Functions;
use crate::calls::instance::{Instance, STEP, c_text};
use crate::calls::library::{Interface, Library, StateCalls, expect};
use crate::calls::logger;
use crate::calls::participant::Step;
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
                        0,
                        0,
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

    /// `fmi3ExitInitializationMode`: without events the instance is then at a communication point.
    pub(crate) fn exit_initialization_mode(&mut self) -> Result<(), ImportError> {
        let call = self.library.functions.exit_initialization_mode;
        let allowed = &[Phase::Initialization];
        self.plain("fmi3ExitInitializationMode", call, allowed, Phase::Stepping)
    }

    /// `fmi3Terminate`.
    pub(crate) fn terminate(&mut self) -> Result<(), ImportError> {
        let call = self.library.functions.terminate;
        let allowed = &[Phase::Stepping, Phase::Discarded];
        self.plain("fmi3Terminate", call, allowed, Phase::Terminated)
    }

    /// `fmi3DoStep` from `time` by `step` \[s\]. A step that ends early, unasked for, counts as one done in part.
    pub(crate) fn do_step(
        &mut self,
        time: f64,
        step: f64,
        no_rollback: bool,
    ) -> Result<Step, ImportError> {
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
        let last_successful_time = Some(last).filter(|time| time.is_finite());
        if Status::from_raw(raw) == Some(Status::Discard) {
            self.phase = Phase::Discarded;
        } else {
            self.judge(FUNCTION, raw)?;
            self.phase = Phase::Stepping;
            if early == 0 && terminated == 0 {
                return Ok(Step::Done);
            }
        }
        Ok(Step::Discarded {
            last_successful_time,
            terminated: terminated != 0,
        })
    }
}
