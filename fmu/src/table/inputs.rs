//! The inputs of boundaries: parts of a [`Command`](sphere_dda::scene::Command).

use sphere_dda::scene::{Boundary, InputKind};
use sphere_dda_model_description::fmi2::Causality;
use sphere_dda_model_description::value::{ScalarType, Value};

use super::binding::{Binding, Input};
use super::variable::Variable;

/// Part, name, unit and meaning of an input.
type Row = (Input, &'static str, &'static str, &'static str);

const HELD: &str = "held over the communication step";
const REACHED: &str = "from the scene; reached linearly at the end of the communication step";
const ADVANCED: &str =
    "from the scene; pose + twist x h is reached at the end of the communication step";

#[rustfmt::skip]
const POSE: [Row; 2] = [
    (Input::Translation, "translation", "m", "Total translation"),
    (Input::Rotation, "rotation", "rad", "Total rotation vector about the reference point"),
];
#[rustfmt::skip]
const TWIST: [Row; 2] = [
    (Input::Velocity, "velocity", "m/s", "Velocity of the reference point"),
    (Input::AngularVelocity, "angularVelocity", "rad/s", "Angular velocity"),
];
#[rustfmt::skip]
const LOAD: [Row; 2] = [
    (Input::Force, "appliedForce", "N", "Force at the reference point, world axes"),
    (Input::Torque, "appliedTorque", "N.m", "Torque, world axes"),
];
#[rustfmt::skip]
const SLIDE: [Row; 1] = [(Input::Scalar, "displacement", "m", "Displacement along the slide")];
const SLIDE_SPEED: [Row; 1] = [(Input::Scalar, "speed", "m/s", "Speed along the slide")];
const SLIDE_FORCE: [Row; 1] = [(Input::Scalar, "appliedForce", "N", "Force along the slide")];
const HINGE: [Row; 1] = [(Input::Scalar, "angle", "rad", "Angle about the hinge")];
#[rustfmt::skip]
const HINGE_SPEED: [Row; 1] = [(Input::Scalar, "angularSpeed", "rad/s", "Angular speed about the hinge")];
#[rustfmt::skip]
const HINGE_TORQUE: [Row; 1] = [(Input::Scalar, "appliedTorque", "N.m", "Torque about the hinge")];
#[rustfmt::skip]
const BELT: [Row; 1] = [(Input::SurfaceVelocity, "surfaceVelocity", "m/s", "Velocity of the surface along the faces, the boundary's own axes")];
const SERVO: [Row; 1] = [(
    Input::Pressure,
    "pressure",
    "Pa",
    "Pressure of the servo wall",
)];

/// Rows with what they do within a step.
type Group = (&'static [Row], &'static str);

fn groups(kind: InputKind) -> Vec<Group> {
    match kind {
        InputKind::Pose => vec![(&POSE, REACHED)],
        InputKind::Motion => vec![(&POSE, ADVANCED), (&TWIST, HELD)],
        InputKind::Twist => vec![(&TWIST, HELD)],
        InputKind::Load => vec![(&LOAD, HELD)],
        InputKind::Slide { .. } => vec![(&SLIDE, REACHED)],
        InputKind::SlideSpeed { .. } => vec![(&SLIDE_SPEED, HELD)],
        InputKind::SlideForce { .. } => vec![(&SLIDE_FORCE, HELD)],
        InputKind::Hinge { .. } => vec![(&HINGE, REACHED)],
        InputKind::HingeSpeed { .. } => vec![(&HINGE_SPEED, HELD)],
        InputKind::HingeTorque { .. } => vec![(&HINGE_TORQUE, HELD)],
    }
}

/// The inputs of the boundary with index `b`; they start with what leaves it as in the scene.
pub(super) fn inputs(b: usize, boundary: &Boundary) -> Vec<Variable> {
    let mut all = boundary.motion.input().map(groups).unwrap_or_default();
    if boundary.belt.is_some_and(|belt| belt.input) {
        all.push((&BELT, HELD));
    }
    if boundary.motion.pressure_input().is_some() {
        all.push((&SERVO, HELD));
    }
    let mut rest = boundary.rest();
    let rows = all
        .into_iter()
        .flat_map(|(rows, when)| rows.iter().map(move |row| (row, when)));
    let variable = |(&(input, name, unit, what), when): (&Row, &str)| {
        let mut variable = Variable::new(
            format!("boundary.{}.{name}", boundary.name),
            ScalarType::Float64,
            Causality::Input,
            Binding::Input { boundary: b, input },
            format!("{what}, {when}"),
        )
        .vector(input.components());
        variable.boundary = Some((b, name));
        variable.unit = Some(unit);
        variable.start = (0..variable.count())
            .map(|k| Value::Real(*input.of(&mut rest, k)))
            .collect();
        variable
    };
    rows.map(variable).collect()
}
