//! What the triangles of boundaries with `wall_fields` feel: arrays that FMI 3.0 has.

use sphere_dda::observe::walls::FIELDS;
use sphere_dda::scene::{Boundary, Scene};
use sphere_dda_model_description::fmi2::Causality;
use sphere_dda_model_description::value::ScalarType;

use super::binding::Binding;
use super::variable::Variable;

/// The arrays of all such boundaries.
pub(super) fn walls(scene: &Scene) -> Vec<Variable> {
    let boundaries = scene.boundaries.iter().enumerate();
    let kept = boundaries.filter(|(_, boundary)| boundary.wall_fields);
    kept.flat_map(|(b, boundary)| wall(b, boundary)).collect()
}

fn wall(b: usize, boundary: &Boundary) -> Vec<Variable> {
    let triangles = boundary.geometry.triangles();
    let array = |name: &str, dims: &[usize], role, binding, text: &str| Variable {
        dims: [&[triangles], dims].concat(),
        ..Variable::new(
            format!("wall.{}.{name}", boundary.name),
            ScalarType::Float64,
            role,
            binding,
            text,
        )
    };
    let fixed = Causality::CalculatedParameter;
    let text = "Corners of the triangles as in the scene";
    let corners = array("corners", &[3, 3], fixed, Binding::WallCorners(b), text);
    let corners = Variable {
        unit: Some("m"),
        ..corners
    };
    let fields = FIELDS.iter().enumerate().map(|(field, own)| {
        let role = match own.name {
            "area" => fixed,
            _ => Causality::Local,
        };
        let dims: &[usize] = if own.is_vector() { &[3] } else { &[] };
        let binding = Binding::Wall { boundary: b, field };
        Variable {
            unit: Some(own.unit),
            ..array(own.name, dims, role, binding, own.text)
        }
    });
    std::iter::once(corners).chain(fields).collect()
}
