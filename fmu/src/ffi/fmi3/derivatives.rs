//! Derivatives of outputs by time and by inputs.

use sphere_dda_fmi_interface::abi3::*;
use sphere_dda_fmi_interface::pointers::{array, array_mut};

use super::super::guard::{Stages, call};
use crate::instance::{Stage, counted};

use fmi3Status::fmi3OK;

const STEPPED: Stages = &[
    Stage::StepComplete,
    Stage::StepFailed,
    Stage::Error,
    Stage::Terminated,
];

/// Derivatives of outputs, of order 1, at the communication point.
#[unsafe(no_mangle)]
extern "C" fn fmi3GetOutputDerivatives(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    orders: *const i32,
    values: *mut fmi3Float64,
    nValues: usize,
) -> fmi3Status {
    call(instance, "fmi3GetOutputDerivatives", STEPPED, |component| {
        let references = array(valueReferences, nValueReferences, "valueReferences")?;
        let orders = array(orders, nValueReferences, "orders")?;
        let rates = component.instance.array_derivatives(references, orders)?;
        if rates.len() != nValues {
            return Err(counted(nValues, rates.len()));
        }
        array_mut(values, nValues, "values")?.copy_from_slice(&rates);
        Ok(fmi3OK)
    })
}
