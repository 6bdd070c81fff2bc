//! Derivatives of outputs by time and by inputs.

use sphere_dda_fmi_interface::abi3::*;

use super::super::guard::{KNOWN, STEPPED, lend};
use crate::runtime::instance::Instance;
use crate::runtime::refusal::Refusal;
use crate::version::Version;

use fmi3Status::fmi3OK;

/// References to variables, and how many.
type References = (*const fmi3ValueReference, usize);
/// Numbers, and how many.
type Seed = (*const fmi3Float64, usize);
type Places = (*mut fmi3Float64, usize);

/// A product of derivatives with a seed.
fn product(
    (instance, function): (fmi3Instance, &str),
    (unknowns, knowns): (References, References),
    (seed, sensitivity): (Seed, Places),
    of: impl FnOnce(&mut Instance, (&[u32], &[u32]), &[f64], usize) -> Result<Vec<f64>, Refusal>,
) -> fmi3Status {
    lend(instance, function, KNOWN, |component, lent| {
        let unknowns = lent.array(unknowns.0, unknowns.1, "unknowns")?;
        let knowns = lent.array(knowns.0, knowns.1, "knowns")?;
        let seed = lent.array(seed.0, seed.1, "seed")?;
        let count = sensitivity.1;
        let changes = of(&mut component.instance, (unknowns, knowns), seed, count)?;
        lent.places(sensitivity.0, count, "sensitivity")?
            .write_copy_of_slice(&changes);
        Ok(fmi3OK)
    })
}

/// Change of outputs for a change of inputs held over the last step.
#[unsafe(no_mangle)]
extern "C" fn fmi3GetDirectionalDerivative(
    instance: fmi3Instance,
    unknowns: *const fmi3ValueReference,
    nUnknowns: usize,
    knowns: *const fmi3ValueReference,
    nKnowns: usize,
    seed: *const fmi3Float64,
    nSeed: usize,
    sensitivity: *mut fmi3Float64,
    nSensitivity: usize,
) -> fmi3Status {
    product(
        (instance, "fmi3GetDirectionalDerivative"),
        ((unknowns, nUnknowns), (knowns, nKnowns)),
        ((seed, nSeed), (sensitivity, nSensitivity)),
        |instance, pair, seed, count| {
            instance.directional_derivative(Version::Three, pair, seed, count)
        },
    )
}

/// Sum of the derivatives of outputs by inputs held over the last step, weighted by the seed.
#[unsafe(no_mangle)]
extern "C" fn fmi3GetAdjointDerivative(
    instance: fmi3Instance,
    unknowns: *const fmi3ValueReference,
    nUnknowns: usize,
    knowns: *const fmi3ValueReference,
    nKnowns: usize,
    seed: *const fmi3Float64,
    nSeed: usize,
    sensitivity: *mut fmi3Float64,
    nSensitivity: usize,
) -> fmi3Status {
    product(
        (instance, "fmi3GetAdjointDerivative"),
        ((unknowns, nUnknowns), (knowns, nKnowns)),
        ((seed, nSeed), (sensitivity, nSensitivity)),
        Instance::adjoint_derivative,
    )
}

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
    lend(
        instance,
        "fmi3GetOutputDerivatives",
        STEPPED,
        |component, lent| {
            let references = lent.array(valueReferences, nValueReferences, "valueReferences")?;
            let orders = lent.array(orders, nValueReferences, "orders")?;
            let instance = &mut component.instance;
            let rates = instance.output_derivatives(Version::Three, references, orders, nValues)?;
            lent.places(values, nValues, "values")?
                .write_copy_of_slice(&rates);
            Ok(fmi3OK)
        },
    )
}
