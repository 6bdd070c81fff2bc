//! Where each boundary goes during one communication step.
//!
//! A commanded pose is approached linearly (its rotation by the logarithm) and reached at the end of the
//! communication step: continuous, one step late. Commanded speeds are held over the step, without lag.
//! `Motion` (pose and twist together) reaches `pose + twist h`, without lag.

use nalgebra::UnitQuaternion;

use crate::Vec3;
use crate::boundaries::Boundary;
use crate::motion::{Command, InputKind, Motion, Pose, Twist};

/// Path of one boundary from `start` \[s\] to `end` \[s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path {
    start: f64,
    end: f64,
    from: Pose,
    /// Displacement over the whole path; its rotation as a rotation vector \[rad\], so that it may exceed pi.
    by: Twist,
}

impl Path {
    /// The path of an input boundary that stands at `from`.
    #[must_use]
    pub fn commanded(kind: InputKind, command: &Command, from: Pose, start: f64, end: f64) -> Self {
        let h = end - start;
        let to = |pose: Pose| Twist {
            linear: pose.translation - from.translation,
            angular: (pose.rotation * from.rotation.inverse()).scaled_axis(),
        };
        let by = match kind {
            InputKind::Twist => Twist {
                linear: command.velocity * h,
                angular: command.angular_velocity * h,
            },
            InputKind::SlideSpeed { axis } => Twist {
                linear: axis * (command.scalar * h),
                angular: Vec3::zeros(),
            },
            InputKind::HingeSpeed { axis } => Twist {
                linear: Vec3::zeros(),
                angular: axis * (command.scalar * h),
            },
            InputKind::Motion => {
                let mut pose = target(kind, command).unwrap_or(from);
                pose.translation += command.velocity * h;
                pose.rotation =
                    UnitQuaternion::from_scaled_axis(command.angular_velocity * h) * pose.rotation;
                to(pose)
            }
            InputKind::Pose | InputKind::Slide { .. } | InputKind::Hinge { .. } => {
                to(target(kind, command).unwrap_or(from))
            }
        };
        Self { start, end, from, by }
    }

    /// Pose at time `t` \[s\] of the path.
    #[must_use]
    pub fn at(&self, t: f64) -> Pose {
        let share = if t >= self.end { 1.0 } else { (t - self.start) / (self.end - self.start) };
        Pose {
            translation: self.from.translation + self.by.linear * share,
            rotation: UnitQuaternion::from_scaled_axis(self.by.angular * share) * self.from.rotation,
        }
    }
}

/// The pose a command asks for; `None` for kinds that command speeds only.
#[must_use]
pub fn target(kind: InputKind, command: &Command) -> Option<Pose> {
    let (translation, rotation) = match kind {
        InputKind::Pose | InputKind::Motion => (command.translation, command.rotation),
        InputKind::Slide { axis } => (axis * command.scalar, Vec3::zeros()),
        InputKind::Hinge { axis } => (Vec3::zeros(), axis * command.scalar),
        InputKind::Twist | InputKind::SlideSpeed { .. } | InputKind::HingeSpeed { .. } => return None,
    };
    Some(Pose {
        translation,
        rotation: UnitQuaternion::from_scaled_axis(rotation),
    })
}

/// How all boundaries move during one communication step.
#[derive(Debug, Clone)]
pub struct Drive<'a> {
    boundaries: &'a [Boundary],
    paths: Vec<Option<Path>>,
}

impl<'a> Drive<'a> {
    /// The drive from `start` to `end` \[s\] for boundaries that stand at `poses`.
    #[must_use]
    pub fn new(
        boundaries: &'a [Boundary],
        commands: &[Command],
        poses: &[Pose],
        start: f64,
        end: f64,
    ) -> Self {
        let path = |(boundary, (command, pose)): (&Boundary, (&Command, &Pose))| match boundary.motion {
            Motion::Input(kind) => Some(Path::commanded(kind, command, *pose, start, end)),
            _ => None,
        };
        let paths = boundaries.iter().zip(commands.iter().zip(poses)).map(path).collect();
        Self { boundaries, paths }
    }

    /// Poses of all boundaries at time `t` \[s\], `[B]`.
    #[must_use]
    pub fn poses(&self, t: f64) -> Vec<Pose> {
        self.boundaries
            .iter()
            .zip(&self.paths)
            .map(|(boundary, path)| match path {
                Some(path) => path.at(t),
                None => boundary.motion.pose_at(t),
            })
            .collect()
    }
}

/// Mean twist of the point of action between two poses `dt` \[s\] apart.
#[must_use]
pub fn twist_between(from: &Pose, to: &Pose, dt: f64) -> Twist {
    Twist {
        linear: (to.translation - from.translation) / dt,
        angular: (to.rotation * from.rotation.inverse()).scaled_axis() / dt,
    }
}
