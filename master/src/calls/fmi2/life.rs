//! Life and steps of an instance of FMI 2.0.

use std::ffi::{c_int, c_void};
use std::sync::Arc;

use sphere_dda_fmi_interface::platform::Platform;

use super::abi::{self, Callbacks, Functions};
use crate::calls::instance::{ALIVE, Instance, STATUS, STEP, c_text};
use crate::calls::library::{Interface, Library, StateCalls, expect};
use crate::calls::logger;
use crate::calls::participant::Step;
use crate::error::ImportError;
use crate::open::Opened;
use crate::status::{Phase, Status};

use Phase::{Discarded, Initialization, Instantiated, Stepping, Terminated};

impl Interface for Functions {
    const FREE: &'static str = "fmi2FreeInstance";

    type Callbacks = Callbacks;

    unsafe fn resolve(library: &libloading::Library) -> Result<Self, &'static str> {
        // SAFETY: passed on to the caller.
        unsafe { Self::look_up(library) }
    }

    fn check(&self) -> Result<(), ImportError> {
        expect("fmi2GetVersion", self.get_version, "2.0")?;
        expect("fmi2GetTypesPlatform", self.get_types_platform, "default")
    }

    fn platforms() -> Vec<&'static str> {
        Platform::HERE.folders_2()
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
        const FUNCTION: &str = "fmi2Instantiate";
        let instance_name = c_text(FUNCTION, name)?;
        let guid = c_text(FUNCTION, fmu.description.token())?;
        let resources = fmu.resources();
        // The folder is absolute; only a path that is not can have no address.
        let resources = url::Url::from_file_path(&resources)
            .map_err(|()| ImportError::Null {
                function: FUNCTION,
                what: format!("the address of {}", resources.display()),
            })?
            .to_string();
        let resources = c_text(FUNCTION, &resources)?;
        Self::make(
            library,
            FUNCTION,
            name,
            fmu.description.only_one_instance(),
            |log| Callbacks {
                logger: logger::collect,
                allocate_memory: libc::calloc,
                free_memory: libc::free,
                step_finished: None,
                component_environment: Arc::as_ptr(log).cast_mut().cast(),
            },
            |functions, _, callbacks| {
                // SAFETY: texts and callbacks live through the call, the callbacks until the instance is freed.
                unsafe {
                    (functions.instantiate)(
                        instance_name.as_ptr(),
                        abi::CO_SIMULATION,
                        guid.as_ptr(),
                        resources.as_ptr(),
                        Arc::as_ptr(callbacks),
                        0,
                        c_int::from(logging),
                    )
                }
            },
        )
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
        let call = self.library.functions.do_step;
        // SAFETY: plain numbers, in a phase that allows the call.
        let raw = unsafe { call(self.component(), time, step, c_int::from(no_rollback)) };
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
