//! The spheres as a whole: arrays that FMI 3.0 has.

use sphere_dda::scene::Scene;
use sphere_dda_model_description::fmi2::Causality;
use sphere_dda_model_description::value::{ScalarType, Value};

use super::binding::{Binding, Field};
use super::variable::Variable;

/// Field, name, type, unit and meaning.
type Row = (
    Field,
    &'static str,
    ScalarType,
    Option<&'static str>,
    &'static str,
);

#[rustfmt::skip]
const ROWS: [Row; 7] = [
    (Field::Id, "id", ScalarType::Int64, None, "Row of the sphere, from 0"),
    (Field::Radius, "radius", ScalarType::Float64, Some("m"), "Radius"),
    (Field::Present, "present", ScalarType::Boolean, None, "Whether the sphere is in the scene; the row of one that is not rests where it was"),
    (Field::Position, "position", ScalarType::Float64, Some("m"), "Centre"),
    (Field::Orientation, "orientation", ScalarType::Float64, None, "Orientation, unit quaternion w, x, y, z"),
    (Field::Velocity, "velocity", ScalarType::Float64, Some("m/s"), "Velocity of the centre"),
    (Field::AngularVelocity, "angularVelocity", ScalarType::Float64, Some("rad/s"), "Angular velocity, world axes"),
];

/// The arrays over all spheres, with the input of forces if the scene asks for it.
pub(super) fn spheres(scene: &Scene) -> Vec<Variable> {
    let spheres = scene.particles.len();
    if spheres == 0 {
        return Vec::new();
    }
    let variable = |(field, name, scalar, unit, text): Row| {
        let causality = match field {
            Field::Id | Field::Radius => Causality::CalculatedParameter,
            _ => Causality::Local,
        };
        let (name, binding) = (format!("spheres.{name}"), Binding::Spheres(field));
        Variable {
            unit,
            dims: [spheres]
                .into_iter()
                .chain(field.columns().map(|columns| columns.len()))
                .collect(),
            ..Variable::new(name, scalar, causality, binding, text)
        }
    };
    let document = Variable::new(
        "spheres.document",
        ScalarType::Binary,
        Causality::Local,
        Binding::Document,
        "All spheres in one binary",
    );
    let forces = scene.exposed.applied_forces.then(|| Variable {
        unit: Some("N"),
        dims: vec![spheres, 3],
        start: vec![Value::Real(0.0); 3 * spheres],
        ..Variable::new(
            "spheres.appliedForce",
            ScalarType::Float64,
            Causality::Input,
            Binding::AppliedForces,
            "Force at the centre, world axes, held over the communication step",
        )
    });
    let rows = ROWS.into_iter().map(variable);
    rows.chain([document]).chain(forces).collect()
}
