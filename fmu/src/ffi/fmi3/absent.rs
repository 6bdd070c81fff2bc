//! Functions of what is not offered: refused with the flag of the model description that says so.

use sphere_dda_fmi_interface::abi3::*;
use std::ffi::c_int;

use super::super::guard::{ANY, call};
use crate::runtime::refusal::Refusal;

/// Functions that are refused: name, arguments, the flag and its value.
macro_rules! absent {
    ($($name:ident($($argument:ty),*): $capability:literal = $value:literal;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(instance: fmi3Instance, $(_: $argument),*) -> fmi3Status {
            call(instance, stringify!($name), ANY, |_| {
                Err(Refusal::NotOffered { capability: $capability, value: $value })
            })
        }
    )*};
}

/// References to variables, and how many.
type References = *const fmi3ValueReference;

absent! {
    fmi3GetNumberOfVariableDependencies(
        fmi3ValueReference, *mut usize
    ): "providesPerElementDependencies" = "false";
    fmi3GetVariableDependencies(
        fmi3ValueReference, *mut usize, *mut fmi3ValueReference, *mut usize, *mut c_int, usize
    ): "providesPerElementDependencies" = "false";
    fmi3EnterConfigurationMode(): "the number of structural parameters" = "0";
    fmi3ExitConfigurationMode(): "the number of structural parameters" = "0";
    fmi3EnterEventMode(): "hasEventMode" = "false";
    fmi3EnterStepMode(): "hasEventMode" = "false";
    fmi3EvaluateDiscreteStates(): "hasEventMode" = "false";
    fmi3UpdateDiscreteStates(
        *mut fmi3Boolean, *mut fmi3Boolean, *mut fmi3Boolean, *mut fmi3Boolean, *mut fmi3Boolean, *mut f64
    ): "hasEventMode" = "false";
    fmi3GetClock(References, usize, *mut fmi3Boolean): "the number of clocks" = "0";
    fmi3SetClock(References, usize, *const fmi3Boolean): "the number of clocks" = "0";
    fmi3GetIntervalDecimal(References, usize, *mut f64, *mut c_int): "the number of clocks" = "0";
    fmi3GetIntervalFraction(References, usize, *mut u64, *mut u64, *mut c_int): "the number of clocks" = "0";
    fmi3GetShiftDecimal(References, usize, *mut f64): "the number of clocks" = "0";
    fmi3GetShiftFraction(References, usize, *mut u64, *mut u64): "the number of clocks" = "0";
    fmi3SetIntervalDecimal(References, usize, *const f64): "the number of clocks" = "0";
    fmi3SetIntervalFraction(References, usize, *const u64, *const u64): "the number of clocks" = "0";
    fmi3SetShiftDecimal(References, usize, *const f64): "the number of clocks" = "0";
    fmi3SetShiftFraction(References, usize, *const u64, *const u64): "the number of clocks" = "0";
    fmi3EnterContinuousTimeMode(): "model exchange" = "not offered";
    fmi3CompletedIntegratorStep(
        fmi3Boolean, *mut fmi3Boolean, *mut fmi3Boolean
    ): "model exchange" = "not offered";
    fmi3SetTime(f64): "model exchange" = "not offered";
    fmi3SetContinuousStates(*const f64, usize): "model exchange" = "not offered";
    fmi3GetContinuousStateDerivatives(*mut f64, usize): "model exchange" = "not offered";
    fmi3GetEventIndicators(*mut f64, usize): "model exchange" = "not offered";
    fmi3GetContinuousStates(*mut f64, usize): "model exchange" = "not offered";
    fmi3GetNominalsOfContinuousStates(*mut f64, usize): "model exchange" = "not offered";
    fmi3GetNumberOfEventIndicators(*mut usize): "model exchange" = "not offered";
    fmi3GetNumberOfContinuousStates(*mut usize): "model exchange" = "not offered";
    fmi3ActivateModelPartition(fmi3ValueReference, f64): "scheduled execution" = "not offered";
}
