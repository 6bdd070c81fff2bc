//! The loaded contacts as a whole, of which there are more or fewer after every step: arrays and a binary that FMI 3.0 has.

use sphere_dda::scene::Scene;
use sphere_dda_model_description::fmi2::Causality;
use sphere_dda_model_description::value::ScalarType;

use super::binding::{Binding, ContactField};
use super::variable::Variable;

/// Field, name, type, unit and meaning.
type Row = (
    ContactField,
    &'static str,
    ScalarType,
    Option<&'static str>,
    &'static str,
);

#[rustfmt::skip]
const ROWS: [Row; 6] = [
    (ContactField::Bodies, "bodies", ScalarType::Int64, None, "Row of the sphere; row of the other sphere, or -1 - index of the boundary; -1, -1: no contact"),
    (ContactField::Position, "position", ScalarType::Float64, Some("m"), "Closest point on the other body"),
    (ContactField::Normal, "normal", ScalarType::Float64, None, "Unit normal from the other body to the sphere"),
    (ContactField::Force, "force", ScalarType::Float64, Some("N"), "Force on the sphere, last internal step"),
    (ContactField::Torque, "torque", ScalarType::Float64, Some("N.m"), "Couple of rolling and twisting resistance on the sphere, last internal step"),
    (ContactField::Gap, "gap", ScalarType::Float64, Some("m"), "Gap, negative: overlap"),
];

/// What a scene with spheres has: the binary, and the arrays that it asks for.
pub(super) fn contacts(scene: &Scene) -> Vec<Variable> {
    if scene.particles.is_empty() {
        return Vec::new();
    }
    let rows = scene.exposed.contacts as usize;
    let variable = |(field, name, scalar, unit, text): Row| {
        let (name, binding) = (format!("contacts.{name}"), Binding::Contacts(field));
        let width = field.columns().map_or(2, |columns| columns.len());
        Variable {
            unit,
            dims: [rows]
                .into_iter()
                .chain((width > 1).then_some(width))
                .collect(),
            ..Variable::new(name, scalar, Causality::Output, binding, text)
        }
    };
    let document = Variable::new(
        "contacts.document",
        ScalarType::Binary,
        Causality::Local,
        Binding::ContactsDocument,
        "All loaded contacts in one binary",
    );
    let asked = ROWS.into_iter().filter(|_| rows > 0);
    asked.map(variable).chain([document]).collect()
}
