//! What a command asks for: a pose, speeds, and where they carry a boundary.

use nalgebra::UnitQuaternion;

use crate::Vec3;
use crate::scene::{Command, CommandDerivatives, InputKind};
use crate::spatial::{Pose, Twist};

/// The speeds of a command.
pub(super) fn speeds(kind: InputKind, command: &Command) -> Twist {
    match kind {
        InputKind::SlideSpeed { axis } => Twist {
            linear: axis * command.scalar,
            ..Twist::default()
        },
        InputKind::HingeSpeed { axis } => Twist {
            angular: axis * command.scalar,
            ..Twist::default()
        },
        _ => Twist {
            linear: command.velocity,
            angular: command.angular_velocity,
        },
    }
}

/// Where speeds that change carry a boundary from `from` within `s` \[s\].
pub(super) fn carried(
    kind: InputKind,
    command: &Command,
    rates: &CommandDerivatives,
    from: &Pose,
    s: f64,
) -> Pose {
    let [v, first, second] = [command, &rates[0], &rates[1]].map(|c| speeds(kind, c));
    let moved = |v: Vec3, first: Vec3, second: Vec3| {
        v * s + first * (s * s / 2.0) + second * (s * s * s / 6.0)
    };
    let turned = moved(v.angular, first.angular, second.angular)
        - v.angular.cross(&first.angular) * (s * s * s / 12.0);
    let motion = Twist {
        linear: moved(v.linear, first.linear, second.linear),
        angular: turned,
    };
    from.advanced(&motion, 1.0)
}

/// A world pose with derivatives as pose and twist: a constant angular velocity stays one, whatever the polynomial of its
/// quaternion leaves out.
pub(super) fn as_motion(
    kind: InputKind,
    command: &Command,
    [first, second]: &CommandDerivatives,
) -> (InputKind, Command, CommandDerivatives) {
    let q = command.orientation;
    let inverse = q.conjugate() / q.norm_squared();
    let turn = first.orientation * inverse;
    let pose = target(kind, command).unwrap_or_default();
    let motion = Command {
        translation: pose.translation,
        rotation: pose.rotation_vector(),
        velocity: first.position,
        angular_velocity: turn.imag() * 2.0,
        ..Command::default()
    };
    let bend = Command {
        velocity: second.position,
        angular_velocity: (second.orientation * inverse - turn * turn).imag() * 2.0,
        ..Command::default()
    };
    (InputKind::Motion, motion, [bend, Command::default()])
}

/// The pose a command asks for; `None` for kinds that command speeds only.
pub(super) fn target(kind: InputKind, command: &Command) -> Option<Pose> {
    let (translation, rotation) = match kind {
        InputKind::Pose | InputKind::Motion => (command.translation, command.rotation),
        InputKind::WorldPose { reference } => {
            return Some(Pose {
                translation: command.position - reference,
                rotation: UnitQuaternion::new_normalize(command.orientation),
            });
        }
        InputKind::Slide { axis } => (axis * command.scalar, Vec3::zeros()),
        InputKind::Hinge { axis } => (Vec3::zeros(), axis * command.scalar),
        InputKind::Twist
        | InputKind::SlideSpeed { .. }
        | InputKind::HingeSpeed { .. }
        | InputKind::Load
        | InputKind::SlideForce { .. }
        | InputKind::HingeTorque { .. } => return None,
    };
    Some(Pose::from_rotation_vector(translation, rotation))
}
