//! FMI 3.0 as a component of WebAssembly, by the world `co-simulation-fmu` of the draft FMI-LS-WASM (`fmu/wit`, unchanged):
//! the functions of the C interface with the types of WIT. The importer's messages and intermediate updates are imports.

use std::ffi::c_void;
use std::ptr::null_mut;

use sphere_dda_fmi_interface::abi3::*;
use sphere_dda_fmi_interface::log::{Category, Level, Log, Sink};
use sphere_dda_model_description::value::{ScalarType, Value};

use super::super::embedded;
use super::super::guard::{self, ANY, Component, KNOWN, STEPPED, Updates, call};
use super::super::logging;
use super::super::saved::SAVEABLE;
use super::step::fmi3DoStep;
use super::values::{READABLE, SETTABLE, never};
use crate::runtime::instance::{Call, Instance};
use crate::runtime::refusal::Refusal;
use crate::version::Version;

use fmi3Status::{fmi3Discard, fmi3Error, fmi3OK, fmi3Warning};

wit_bindgen::generate!({ world: "co-simulation-fmu", path: "wit" });

use exports::fmi::fmi3::co_simulation::{
    CoSimulationInstance, DiscreteStatesInfo, DoStepResult, Guest, GuestCoSimulationInstance,
    IntervalFraction, IntervalQualifier, Status, VariableDependency,
};
use fmi::fmi3::callbacks::log_message;
use fmi::fmi3::intermediate_update_callbacks::intermediate_update;

/// What the component exports.
struct Exports;

export!(Exports);

impl exports::fmi::fmi3::common::Guest for Exports {
    fn get_version() -> String {
        "3.0".to_owned()
    }
}

impl Guest for Exports {
    type CoSimulationInstance = Handle;
}

/// An instance, freed when it is dropped.
struct Handle(fmi3Instance);

impl Drop for Handle {
    fn drop(&mut self) {
        super::fmi3FreeInstance(self.0);
    }
}

impl From<fmi3Status> for Status {
    fn from(status: fmi3Status) -> Self {
        match status {
            fmi3OK => Self::Ok,
            fmi3Warning => Self::Warning,
            fmi3Discard => Self::Discard,
            fmi3Error => Self::Error,
        }
    }
}

/// What was found, unless the status says that there is nothing.
fn found<T>(status: fmi3Status, found: T) -> Result<T, Status> {
    match status {
        fmi3OK | fmi3Warning => Ok(found),
        failed => Err(failed.into()),
    }
}

/// The importer's log.
fn sink(name: String) -> Sink {
    Box::new(move |level: Level, category: Category, message: &str| {
        let status = match level {
            Level::Ok => Status::Ok,
            Level::Warning => Status::Warning,
            Level::Discard => Status::Discard,
            Level::Error => Status::Error,
        };
        log_message(&name, status, category.name(), message);
    })
}

/// The importer's wish within a step.
///
/// # Safety
/// The last two pointers are valid places.
unsafe extern "C" fn update(
    _environment: *mut c_void,
    time: fmi3Float64,
    set: fmi3Boolean,
    get: fmi3Boolean,
    finished: fmi3Boolean,
    may_return: fmi3Boolean,
    wanted: *mut fmi3Boolean,
    at: *mut fmi3Float64,
) {
    let [set, get, finished, may_return] = [set, get, finished, may_return].map(|x| x != 0);
    let (early, time) = intermediate_update(time, set, get, finished, may_return);
    // SAFETY: `step` calls this with the places of two variables.
    unsafe {
        wanted.write(fmi3Boolean::from(early));
        at.write(time);
    }
}

impl Handle {
    /// The values of variables of one type.
    fn read<T>(
        &self,
        function: &str,
        scalar: ScalarType,
        references: &[u32],
        of: impl Fn(Value) -> Option<T>,
    ) -> Result<Vec<T>, Status> {
        let mut values = Vec::new();
        let status = call(self.0, function, READABLE, |component| {
            let count = elements(&component.instance, references);
            let version = Version::Three;
            let mut give = |value| values.extend(of(value));
            component
                .instance
                .get(Call { version, scalar }, references, count, &mut give)?;
            Ok(fmi3OK)
        });
        found(status, values)
    }

    /// Sets variables of one type.
    fn write(
        &self,
        function: &str,
        scalar: ScalarType,
        references: &[u32],
        values: impl IntoIterator<Item = Value>,
    ) -> Status {
        let status: fmi3Status = call(self.0, function, SETTABLE, |component| {
            let version = Version::Three;
            let values = values.into_iter().collect();
            component
                .instance
                .set(Call { version, scalar }, references, values)?;
            Ok(fmi3OK)
        });
        status.into()
    }

    /// A product of derivatives with a seed.
    fn product(
        &self,
        function: &str,
        of: impl FnOnce(&mut Instance) -> Result<Vec<f64>, Refusal>,
    ) -> Result<Vec<f64>, Status> {
        let mut changes = Vec::new();
        let status = call(self.0, function, KNOWN, |component| {
            changes = of(&mut component.instance)?;
            Ok(fmi3OK)
        });
        found(status, changes)
    }

    /// A function of what is not offered.
    fn refused(&self, function: &str, capability: &'static str, value: &'static str) -> Status {
        let status: fmi3Status = call(self.0, function, ANY, |_| {
            Err(Refusal::NotOffered { capability, value })
        });
        status.into()
    }
}

/// Elements of all these variables; those that there are not count nothing and are refused by who reads them.
fn elements(instance: &Instance, references: &[u32]) -> usize {
    let table = &instance.model().table;
    let entries = references
        .iter()
        .filter_map(|&reference| table.get(Version::Three, reference));
    entries.map(|entry| entry.elements().len()).sum()
}

/// Functions that are refused: name, arguments, result, the flag and its value.
macro_rules! absent {
    ($($name:ident($($argument:ty),*) $(-> $found:ty)?: $capability:literal = $value:literal;)*) => {$(
        absent!(@ $name($($argument),*) $(-> $found)?: $capability = $value);
    )*};
    (@ $name:ident($($argument:ty),*): $capability:literal = $value:literal) => {
        fn $name(&self, $(_: $argument),*) -> Status {
            self.refused(stringify!($name), $capability, $value)
        }
    };
    (@ $name:ident($($argument:ty),*) -> $found:ty: $capability:literal = $value:literal) => {
        fn $name(&self, $(_: $argument),*) -> Result<$found, Status> {
            Err(self.refused(stringify!($name), $capability, $value))
        }
    };
}

/// Getters and setters of numbers; no variable has the types without a value of their own.
macro_rules! numbers {
    ($($get:ident $set:ident $type:ty, $scalar:ident, $out:expr, $in:expr;)*) => {$(
        fn $get(&self, references: Vec<u32>) -> Result<Vec<$type>, Status> {
            self.read(stringify!($get), ScalarType::$scalar, &references, $out)
        }

        fn $set(&self, references: Vec<u32>, values: Vec<$type>) -> Status {
            let values = values.into_iter().map($in);
            self.write(stringify!($set), ScalarType::$scalar, &references, values)
        }
    )*};
}

/// As [`never`]: the value is not looked at.
fn any<T>(_: T) -> Value {
    Value::Integer(0)
}

impl GuestCoSimulationInstance for Handle {
    fn instantiate_co_simulation(
        name: String,
        token: String,
        _resource_path: String,
        _visible: bool,
        logging_on: bool,
        event_mode_used: bool,
        early_return_allowed: bool,
        required: Vec<u32>,
    ) -> Option<CoSimulationInstance> {
        let log = || Log::new(Some(sink(name.clone())), logging_on);
        let updates = (early_return_allowed || !required.is_empty()).then_some(Updates {
            callback: update,
            environment: null_mut(),
            early_return_allowed,
        });
        let instance = guard::instantiate("instantiate-co-simulation", log, || {
            if event_mode_used {
                log().write(Level::Warning, super::NO_EVENTS);
            }
            let instance = Instance::new(&name, &token, embedded::resources(), log())?;
            super::known(&instance, &required)?;
            Ok(Component {
                updates,
                ..Component::new(instance)
            })
        });
        (!instance.is_null()).then(|| CoSimulationInstance::new(Self(instance)))
    }

    fn set_debug_logging(&self, on: bool, categories: Vec<String>) -> Status {
        let status: fmi3Status = call(self.0, "set-debug-logging", ANY, |component| {
            let names: Vec<&str> = categories.iter().map(String::as_str).collect();
            Ok(logging::choose(component, "set-debug-logging", on, &names))
        });
        status.into()
    }

    fn enter_initialization_mode(
        &self,
        _tolerance: Option<f64>,
        start: f64,
        stop: Option<f64>,
    ) -> Status {
        let (defined, stop) = (fmi3Boolean::from(stop.is_some()), stop.unwrap_or_default());
        super::fmi3EnterInitializationMode(
            self.0,
            fmi3Boolean::from(false),
            0.0,
            start,
            defined,
            stop,
        )
        .into()
    }

    fn exit_initialization_mode(&self) -> Status {
        super::fmi3ExitInitializationMode(self.0).into()
    }

    fn terminate(&self) -> Status {
        super::fmi3Terminate(self.0).into()
    }

    fn reset(&self) -> Status {
        super::fmi3Reset(self.0).into()
    }

    numbers! {
        get_float64 set_float64 f64, Float64,
            |value| match value { Value::Real(value) => Some(value), _ => None }, Value::Real;
        get_int32 set_int32 i32, Int32,
            |value| match value { Value::Integer(value) => i32::try_from(value).ok(), _ => None },
            |value| Value::Integer(value.into());
        get_int64 set_int64 i64, Int64,
            |value| match value { Value::Integer(value) => Some(value), _ => None }, Value::Integer;
        get_boolean set_boolean bool, Boolean,
            |value| match value { Value::Boolean(value) => Some(value), _ => None }, Value::Boolean;
        get_string set_string String, String,
            |value| match value { Value::String(value) => Some(value), _ => None }, Value::String;
        get_binary set_binary Vec<u8>, Binary,
            |value| match value { Value::Binary(value) => Some(value), _ => None }, Value::Binary;
        get_float32 set_float32 f32, Float32, never, any;
        get_int8 set_int8 i8, Int8, never, any;
        get_int16 set_int16 i16, Int16, never, any;
        get_uint8 set_uint8 u8, UInt8, never, any;
        get_uint16 set_uint16 u16, UInt16, never, any;
        get_uint32 set_uint32 u32, UInt32, never, any;
        get_uint64 set_uint64 u64, UInt64, never, any;
    }

    fn get_fmu_state(&self) -> Result<Vec<u8>, Status> {
        let mut bytes = Vec::new();
        let status = call(self.0, "get-fmu-state", SAVEABLE, |component| {
            bytes = component.instance.save()?;
            Ok(fmi3OK)
        });
        found(status, bytes)
    }

    fn set_fmu_state(&self, bytes: Vec<u8>) -> Status {
        let status: fmi3Status = call(self.0, "set-fmu-state", ANY, |component| {
            component.instance.load(&bytes)?;
            Ok(fmi3OK)
        });
        status.into()
    }

    fn get_directional_derivative(
        &self,
        unknowns: Vec<u32>,
        knowns: Vec<u32>,
        seed: Vec<f64>,
    ) -> Result<Vec<f64>, Status> {
        self.product("get-directional-derivative", |instance| {
            let count = elements(instance, &unknowns);
            let pair = (&unknowns[..], &knowns[..]);
            instance.directional_derivative(Version::Three, pair, &seed, count)
        })
    }

    fn get_adjoint_derivative(
        &self,
        unknowns: Vec<u32>,
        knowns: Vec<u32>,
        seed: Vec<f64>,
    ) -> Result<Vec<f64>, Status> {
        self.product("get-adjoint-derivative", |instance| {
            let count = elements(instance, &knowns);
            instance.adjoint_derivative((&unknowns, &knowns), &seed, count)
        })
    }

    fn get_output_derivatives(&self, requests: Vec<(u32, u32)>) -> Result<Vec<f64>, Status> {
        let mut rates = Vec::new();
        let status = call(self.0, "get-output-derivatives", STEPPED, |component| {
            let (references, orders): (Vec<u32>, Vec<i32>) = requests
                .iter()
                .map(|&(reference, order)| (reference, i32::try_from(order).unwrap_or(i32::MAX)))
                .unzip();
            let instance = &mut component.instance;
            let count = elements(instance, &references);
            rates = instance.output_derivatives(Version::Three, &references, &orders, count)?;
            Ok(fmi3OK)
        });
        found(status, rates)
    }

    fn do_step(&self, point: f64, h: f64, final_past: bool) -> Result<DoStepResult, Status> {
        let (mut events, mut ends, mut early, mut last) = (0, 0, 0, 0.0);
        let status = fmi3DoStep(
            self.0,
            point,
            h,
            fmi3Boolean::from(final_past),
            &raw mut events,
            &raw mut ends,
            &raw mut early,
            &raw mut last,
        );
        found(
            status,
            DoStepResult {
                last_successful_time: last,
                event_handling_needed: events != 0,
                terminate_simulation: ends != 0,
                early_return: early != 0,
            },
        )
    }

    absent! {
        get_number_of_variable_dependencies(u32) -> u64: "providesPerElementDependencies" = "false";
        get_variable_dependencies(u32) -> Vec<VariableDependency>: "providesPerElementDependencies" = "false";
        enter_configuration_mode(): "the number of structural parameters" = "0";
        exit_configuration_mode(): "the number of structural parameters" = "0";
        enter_event_mode(): "hasEventMode" = "false";
        enter_step_mode(): "hasEventMode" = "false";
        evaluate_discrete_states(): "hasEventMode" = "false";
        update_discrete_states() -> DiscreteStatesInfo: "hasEventMode" = "false";
        get_clock(Vec<u32>) -> Vec<bool>: "the number of clocks" = "0";
        set_clock(Vec<u32>, Vec<bool>): "the number of clocks" = "0";
        get_interval_decimal(Vec<u32>) -> Vec<(f64, IntervalQualifier)>: "the number of clocks" = "0";
        get_interval_fraction(Vec<u32>) -> Vec<(IntervalFraction, IntervalQualifier)>: "the number of clocks" = "0";
        get_shift_decimal(Vec<u32>) -> Vec<f64>: "the number of clocks" = "0";
        get_shift_fraction(Vec<u32>) -> Vec<IntervalFraction>: "the number of clocks" = "0";
        set_interval_decimal(Vec<u32>, Vec<f64>): "the number of clocks" = "0";
        set_interval_fraction(Vec<u32>, Vec<IntervalFraction>): "the number of clocks" = "0";
        set_shift_decimal(Vec<u32>, Vec<f64>): "the number of clocks" = "0";
        set_shift_fraction(Vec<u32>, Vec<IntervalFraction>): "the number of clocks" = "0";
        set_input_derivatives(Vec<(u32, u32)>, Vec<f64>): "canInterpolateInputs" = "false";
    }
}
