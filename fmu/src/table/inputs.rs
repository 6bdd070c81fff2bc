//! The inputs of boundaries: parts of a [`Command`](sphere_dda::scene::Command).

use sphere_dda::scene::{Boundary, InputKind};
use sphere_dda_model_description::fmi2::Causality;
use sphere_dda_model_description::value::{ScalarType, Value};

use super::binding::{Binding, Input};
use super::variable::Variable;

/// Part, name, unit and meaning of an input.
type Row = (Input, &'static str, Option<&'static str>, &'static str);

const HELD: &str = "held over the communication step";
const REACHED: &str = "from the scene; reached linearly at the end of the communication step";
const ARRIVED: &str = "reached linearly at the end of the communication step";
const ADVANCED: &str =
    "from the scene; pose + twist x h is reached at the end of the communication step";

#[rustfmt::skip]
const POSE: [Row; 2] = [
    (Input::Translation, "translation", Some("m"), "Total translation"),
    (Input::Rotation, "rotation", Some("rad"), "Total rotation vector about the reference point"),
];
#[rustfmt::skip]
const WORLD_POSE: [Row; 2] = [
    (Input::Position, "targetPosition", Some("m"), "Position of the reference point in the world"),
    (Input::Orientation, "targetOrientation", None, "Orientation in the world, unit quaternion w, x, y, z"),
];
#[rustfmt::skip]
const TWIST: [Row; 2] = [
    (Input::Velocity, "velocity", Some("m/s"), "Velocity of the reference point"),
    (Input::AngularVelocity, "angularVelocity", Some("rad/s"), "Angular velocity"),
];
#[rustfmt::skip]
const LOAD: [Row; 2] = [
    (Input::Force, "appliedForce", Some("N"), "Force at the reference point, world axes"),
    (Input::Torque, "appliedTorque", Some("N.m"), "Torque, world axes"),
];
#[rustfmt::skip]
const SLIDE: [Row; 1] = [(Input::Scalar, "displacement", Some("m"), "Displacement along the slide")];
const SLIDE_SPEED: [Row; 1] = [(Input::Scalar, "speed", Some("m/s"), "Speed along the slide")];
const SLIDE_FORCE: [Row; 1] = [(
    Input::Scalar,
    "appliedForce",
    Some("N"),
    "Force along the slide",
)];
const HINGE: [Row; 1] = [(Input::Scalar, "angle", Some("rad"), "Angle about the hinge")];
#[rustfmt::skip]
const HINGE_SPEED: [Row; 1] = [(Input::Scalar, "angularSpeed", Some("rad/s"), "Angular speed about the hinge")];
#[rustfmt::skip]
const HINGE_TORQUE: [Row; 1] = [(Input::Scalar, "appliedTorque", Some("N.m"), "Torque about the hinge")];
#[rustfmt::skip]
const BELT: [Row; 1] = [(Input::SurfaceVelocity, "surfaceVelocity", Some("m/s"), "Velocity of the surface along the faces, the boundary's own axes")];
const SERVO: [Row; 1] = [(
    Input::Pressure,
    "pressure",
    Some("Pa"),
    "Pressure of the servo wall",
)];

/// Rows with what they do within a step.
type Group = (&'static [Row], &'static str);

fn groups(kind: InputKind) -> Vec<Group> {
    match kind {
        InputKind::Pose => vec![(&POSE, REACHED)],
        InputKind::WorldPose { .. } => vec![(&WORLD_POSE, ARRIVED)],
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
        variable.unit = unit;
        variable.start = (0..variable.count())
            .map(|k| Value::Real(*input.of(&mut rest, k)))
            .collect();
        variable
    };
    rows.map(variable).collect()
}
