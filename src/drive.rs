//! Where each boundary goes during one communication step.
//!
//! A commanded pose is approached linearly (its rotation by the logarithm) and reached at the end of the
//! communication step: continuous, one step late. Commanded speeds are held over the step, without lag.
//! `Motion` (pose and twist together) reaches `pose + twist h`, without lag.

use crate::Vec3;
use crate::boundaries::Boundary;
use crate::motion::{Command, InputKind, Motion, Pose, Twist};

/// Path of one boundary: a constant twist from where it stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path {
    start: f64,
    from: Pose,
    twist: Twist,
}

impl Path {
    /// The path of an input boundary that stands at `from`, over a step from `start` to `end` \[s\].
    #[must_use]
    pub fn commanded(kind: InputKind, command: &Command, from: Pose, start: f64, end: f64) -> Self {
        let h = end - start;
        let commanded = Twist {
            linear: command.velocity,
            angular: command.angular_velocity,
        };
        let twist = match (kind, target(kind, command)) {
            (InputKind::Motion, Some(pose)) => from.twist_to(&pose.advanced(&commanded, h), h),
            (_, Some(pose)) => from.twist_to(&pose, h),
            (InputKind::SlideSpeed { axis }, None) => Twist {
                linear: axis * command.scalar,
                ..Twist::default()
            },
            (InputKind::HingeSpeed { axis }, None) => Twist {
                angular: axis * command.scalar,
                ..Twist::default()
            },
            (_, None) => commanded,
        };
        Self { start, from, twist }
    }

    /// Pose at time `t` \[s\] of the path.
    #[must_use]
    pub fn at(&self, t: f64) -> Pose {
        self.from.advanced(&self.twist, t - self.start)
    }
}

/// The pose a command asks for; `None` for kinds that command speeds only.
#[must_use]
pub fn target(kind: InputKind, command: &Command) -> Option<Pose> {
    let (translation, rotation) = match kind {
        InputKind::Pose | InputKind::Motion => (command.translation, command.rotation),
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
        let path =
            |(boundary, (command, pose)): (&Boundary, (&Command, &Pose))| match boundary.motion {
                Motion::Input(kind) => Some(Path::commanded(kind, command, *pose, start, end)),
                _ => None,
            };
        let paths = boundaries
            .iter()
            .zip(commands.iter().zip(poses))
            .map(path)
            .collect();
        Self { boundaries, paths }
    }

    /// Poses of all boundaries at time `t` \[s\], `[B]`; those of driven bodies mean nothing, the step finds them.
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

/// Largest displacement \[m\] of a boundary between two poses: at a corner of its bounds, or of its point of
/// action if it is unbounded.
#[must_use]
pub fn displacement(boundary: &Boundary, from: &Pose, to: &Pose) -> f64 {
    let moved = |x: Vec3| (boundary.from_frame(to, x) - boundary.from_frame(from, x)).norm();
    let Some((low, high)) = boundary.geometry.bounds() else {
        return moved(boundary.point_of_action);
    };
    (0..8)
        .map(|k| {
            moved(Vec3::from_fn(|axis, _| {
                if k >> axis & 1 == 0 {
                    low[axis]
                } else {
                    high[axis]
                }
            }))
        })
        .fold(0.0, f64::max)
}
