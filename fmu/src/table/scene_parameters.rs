//! The parameters of the scene's own `[[parameter]]`.

use sphere_dda::scene::{Parameter, Scene};
use sphere_dda_model_description::fmi2::{Causality, Variability};
use sphere_dda_model_description::value::{ScalarType, Value};

use super::binding::Binding;
use super::variable::Variable;

/// Units as scene files write them, and their names in a model description.
const UNITS: [(&str, &str); 22] = [
    ("1/Pa", "1/Pa"),
    ("1/s", "1/s"),
    ("Hz", "Hz"),
    ("J/m^2", "J/m2"),
    ("N", "N"),
    ("N m", "N.m"),
    ("N m s/rad", "N.m.s/rad"),
    ("N s/m", "N.s/m"),
    ("N/m", "N/m"),
    ("Pa", "Pa"),
    ("deg", "deg"),
    ("kg", "kg"),
    ("kg m^2", "kg.m2"),
    ("kg/m^3", "kg/m3"),
    ("kg/s", "kg/s"),
    ("m", "m"),
    ("m/s", "m/s"),
    ("m/s^2", "m/s2"),
    ("m^2", "m2"),
    ("rad", "rad"),
    ("rad/s", "rad/s"),
    ("s", "s"),
];

/// The parameters that the scene names; they start with its values.
pub(super) fn scene_parameters(scene: &Scene) -> Vec<Variable> {
    let parameters = scene.parameters.iter().enumerate();
    let variable = |(rank, own): (usize, &Parameter)| {
        let scalar = match own.is_integer {
            true => ScalarType::Int32,
            false => ScalarType::Float64,
        };
        let unit = UNITS.iter().find(|(typed, _)| *typed == own.unit);
        let (role, binding) = (Causality::Parameter, Binding::SceneParameter(rank));
        let mut variable = Variable::new(&own.name, scalar, role, binding, &*own.description);
        variable.start = vec![value(own.is_integer, own.value)];
        variable.unit = unit.map(|(_, name)| *name);
        (variable.min, variable.max) = (own.min, own.max);
        if own.is_tunable {
            variable.variability = Variability::Tunable;
        }
        variable
    };
    parameters.map(variable).collect()
}

/// A value of a parameter.
pub(crate) fn value(is_integer: bool, value: f64) -> Value {
    match is_integer {
        // Whole and of 32 bits: the scene's reader has seen to it.
        true => Value::Integer(value as i64),
        false => Value::Real(value),
    }
}
