//! Derivatives of inputs and outputs by time, and of outputs by inputs.

use sphere_dda_fmi_interface::abi2::*;

use super::super::guard::{KNOWN, STEPPED, lend};
use super::SETTABLE;
use crate::version::Version;

use fmi2Status::fmi2OK;

/// Sets derivatives of inputs, of order 1 and 2, for the next step.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetRealInputDerivatives(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    order: *const fmi2Integer,
    value: *const fmi2Real,
) -> fmi2Status {
    lend(
        c,
        "fmi2SetRealInputDerivatives",
        SETTABLE,
        |component, lent| {
            let references = lent.array(vr, nvr, "vr")?.iter().copied();
            let orders = lent.array(order, nvr, "order")?.iter().copied();
            let values = lent.array(value, nvr, "value")?.iter().copied();
            let given = references.zip(orders).zip(values);
            let given = given.map(|((reference, order), value)| (reference, order, value));
            component
                .instance
                .set_derivatives(&given.collect::<Vec<_>>())?;
            Ok(fmi2OK)
        },
    )
}

/// Derivatives of outputs, of order 1, at the communication point.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetRealOutputDerivatives(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    order: *const fmi2Integer,
    value: *mut fmi2Real,
) -> fmi2Status {
    lend(
        c,
        "fmi2GetRealOutputDerivatives",
        STEPPED,
        |component, lent| {
            let references = lent.array(vr, nvr, "vr")?;
            let orders = lent.array(order, nvr, "order")?;
            let rates =
                component
                    .instance
                    .output_derivatives(Version::Two, references, orders, nvr)?;
            lent.places(value, nvr, "value")?
                .write_copy_of_slice(&rates);
            Ok(fmi2OK)
        },
    )
}

/// Change of outputs for a change of inputs held over the last step.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetDirectionalDerivative(
    c: fmi2Component,
    vUnknown_ref: *const fmi2ValueReference,
    nUnknown: usize,
    vKnown_ref: *const fmi2ValueReference,
    nKnown: usize,
    dvKnown: *const fmi2Real,
    dvUnknown: *mut fmi2Real,
) -> fmi2Status {
    lend(
        c,
        "fmi2GetDirectionalDerivative",
        KNOWN,
        |component, lent| {
            let unknowns = lent.array(vUnknown_ref, nUnknown, "vUnknown_ref")?;
            let knowns = lent.array(vKnown_ref, nKnown, "vKnown_ref")?;
            let seed = lent.array(dvKnown, nKnown, "dvKnown")?;
            let instance = &mut component.instance;
            let pair = (unknowns, knowns);
            let changes = instance.directional_derivative(Version::Two, pair, seed, nUnknown)?;
            lent.places(dvUnknown, nUnknown, "dvUnknown")?
                .write_copy_of_slice(&changes);
            Ok(fmi2OK)
        },
    )
}
