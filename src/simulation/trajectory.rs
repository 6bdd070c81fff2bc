//! Where each boundary goes during one communication step.
//!
//! A commanded pose is approached linearly (its rotation by the logarithm) and reached at the end of the
//! communication step: continuous, one step late. Commanded speeds are held over the step, without lag.
//! `Motion` (pose and twist together) reaches `pose + twist h`, without lag.
//!
//! With derivatives the command is `u(s) = u + u' s + u'' s^2/2`, `s` from the beginning of the step of length `h`:
//!
//! ```text
//! pose, slide, hinge   X(s) = (1 - s/h) E + U(s)        E: from U(0) to where the boundary stands
//! twist and speeds     x(s) = x_0 + v s + v' s^2/2 + v'' s^3/6
//!                      Q(s) = exp(w s + w' s^2/2 + w'' s^3/6 - (w x w') s^3/12) Q_0     (Magnus, to s^3)
//! motion               as a pose; where that has no derivatives, U(s) is the pose moved on by the twist's x(s), Q(s)
//! world pose           a motion: v = p', v' = p'', w = 2 Im(q' q^-1), w' = 2 Im(q'' q^-1 - (q' q^-1)^2)
//! ```

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::integrator::Integrator;
use crate::scene::{Boundary, Command, CommandDerivatives, InputKind, Motion, Scene};
use crate::simulation::command_motion::{as_motion, carried, speeds, target};
use crate::spatial::extent::corners;
use crate::spatial::{Pose, Twist};
use crate::state::State;
use crate::step::StepInput;

/// Path of one boundary from where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryPath {
    start: f64,
    from: Pose,
    way: Form,
}

/// What a path follows.
#[derive(Debug, Clone, PartialEq)]
enum Form {
    /// With a constant twist.
    Straight(Twist),
    /// Along a command that changes.
    Along(Box<CommandPath>),
}

/// A command with derivatives.
#[derive(Debug, Clone, PartialEq)]
struct CommandPath {
    kind: InputKind,
    command: Command,
    rates: CommandDerivatives,
    /// Length of the step \[s\].
    h: f64,
}

impl BoundaryPath {
    /// The path of an input boundary that stands at `from`, over a step from `start` to `end` \[s\].
    #[must_use]
    pub fn commanded(kind: InputKind, command: &Command, from: Pose, start: f64, end: f64) -> Self {
        let h = end - start;
        let twist = match (kind, target(kind, command)) {
            (InputKind::Motion, Some(pose)) => {
                from.twist_to(&pose.advanced(&speeds(kind, command), h), h)
            }
            (_, Some(pose)) => from.twist_to(&pose, h),
            (_, None) => speeds(kind, command),
        };
        let way = Form::Straight(twist);
        Self { start, from, way }
    }

    /// As [`Self::commanded`], for a command with derivatives.
    #[must_use]
    pub fn along(
        kind: InputKind,
        (command, rates): (&Command, &CommandDerivatives),
        from: Pose,
        start: f64,
        end: f64,
    ) -> Self {
        if *rates == CommandDerivatives::default() {
            return Self::commanded(kind, command, from, start, end);
        }
        let (kind, command, rates) = match kind {
            InputKind::WorldPose { .. } => as_motion(kind, command, rates),
            _ => (kind, *command, *rates),
        };
        let way = Form::Along(Box::new(CommandPath {
            kind,
            command,
            rates,
            h: end - start,
        }));
        Self { start, from, way }
    }

    /// Pose at time `t` \[s\] of the path.
    #[must_use]
    pub fn at(&self, t: f64) -> Pose {
        let s = t - self.start;
        match &self.way {
            Form::Straight(twist) => self.from.advanced(twist, s),
            Form::Along(curve) => curve.at(&self.from, s),
        }
    }
}

impl CommandPath {
    /// The pose `s` \[s\] after the beginning of the step, for a boundary that stood at `from`.
    fn at(&self, from: &Pose, s: f64) -> Pose {
        let Self {
            kind,
            command,
            rates,
            h,
        } = self;
        let Some(first) = target(*kind, command) else {
            return carried(*kind, command, rates, from, s);
        };
        let moves = rates
            .iter()
            .any(|rate| target(*kind, rate) != Some(Pose::default()));
        let wanted = match target(*kind, &command.along(rates, s)) {
            Some(pose) if moves || *kind != InputKind::Motion => pose,
            _ => carried(*kind, command, rates, &first, s),
        };
        let missed = first.twist_to(from, 1.0);
        wanted.advanced(&missed, 1.0 - s / h)
    }
}

/// How all boundaries move during one communication step.
#[derive(Debug, Clone)]
pub struct BoundaryPaths<'a> {
    boundaries: &'a [Boundary],
    commands: &'a [Command],
    /// Empty where all commands are held.
    rates: &'a [CommandDerivatives],
    start: f64,
    paths: Vec<Option<BoundaryPath>>,
}

impl<'a> BoundaryPaths<'a> {
    /// The paths from `start` to `end` \[s\] for boundaries that stand at `poses`; `rates` is `[B]`, or empty where all
    /// commands are held.
    #[must_use]
    pub fn new(
        boundaries: &'a [Boundary],
        (commands, rates): (&'a [Command], &'a [CommandDerivatives]),
        poses: &[Pose],
        start: f64,
        end: f64,
    ) -> Self {
        let path = |(b, boundary): (usize, &Boundary)| match boundary.motion {
            Motion::Input(kind) => {
                let rates = rates.get(b).copied().unwrap_or_default();
                let command = (&commands[b], &rates);
                Some(BoundaryPath::along(kind, command, poses[b], start, end))
            }
            _ => None,
        };
        Self {
            boundaries,
            commands,
            rates,
            start,
            paths: boundaries.iter().enumerate().map(path).collect(),
        }
    }

    /// Whether a boundary may move otherwise than with a constant twist.
    #[must_use]
    pub fn bends(&self) -> bool {
        !self.rates.is_empty()
    }

    /// The internal step of `dt` \[s\] from `t` to `target` \[s\]: poses at its end, loads where the integrator takes forces,
    /// surface velocities at its middle.
    #[must_use]
    pub fn step_input(
        &self,
        integrator: Integrator,
        t: f64,
        (target, dt): (f64, f64),
    ) -> StepInput<'a> {
        let s = t - self.start;
        let at = |(command, rates): (&Command, &CommandDerivatives)| {
            let loads = command.along(rates, integrator.middle(s, dt));
            let surface = command.along(rates, s + 0.5 * dt);
            Command {
                surface_velocity: surface.surface_velocity,
                ..loads
            }
        };
        let commands = match self.bends() {
            true => Cow::Owned(self.commands.iter().zip(self.rates).map(at).collect()),
            false => Cow::Borrowed(self.commands),
        };
        StepInput {
            dt,
            poses: self.poses(target),
            commands,
        }
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

/// Largest displacement \[m\] of a boundary between two poses: at a corner of its bounds, or if it is unbounded at its reference
/// point and at the `spheres` \[m\].
pub(crate) fn displacement(
    boundary: &Boundary,
    [from, to]: [&Pose; 2],
    mut spheres: impl Iterator<Item = Vec3>,
) -> f64 {
    let moved = |x: Vec3| (boundary.from_frame(to, x) - boundary.from_frame(from, x)).norm();
    let Some(bounds) = boundary.geometry.bounds() else {
        let reference = moved(boundary.point_of_action);
        let turns = from.rotation != to.rotation;
        let spheres = std::iter::from_fn(|| spheres.next().filter(|_| turns));
        let spheres = spheres.map(|x| moved(boundary.to_frame(from, x)));
        return spheres.fold(reference, larger_or_nan);
    };
    corners(bounds)
        .map(moved)
        .into_iter()
        .fold(0.0, larger_or_nan)
}

/// The larger of two; none if one is no number.
fn larger_or_nan(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

impl State {
    /// Places every input boundary where its command wants it, without velocity.
    pub(crate) fn place(&mut self, scene: &Scene) {
        for (b, boundary) in scene.boundaries.iter().enumerate() {
            if let Motion::Input(kind) = boundary.motion {
                if let Some(pose) = target(kind, &self.commands[b]) {
                    self.poses[b] = pose;
                }
                self.twists[b] = Twist::default();
            }
        }
    }
}

/// Where the boundaries go until the end of a communication step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Trajectory {
    /// Where they stood, and when, as their commands last changed.
    pub(super) from: Vec<Pose>,
    pub(super) since: f64,
    pub(super) end: f64,
    pub(super) commands: Vec<Command>,
    pub(super) rates: Vec<CommandDerivatives>,
}

impl Trajectory {
    pub(super) fn fits(&self, boundaries: usize) -> bool {
        let rates = self.rates.is_empty() || self.rates.len() == boundaries;
        rates && [self.from.len(), self.commands.len()] == [boundaries; 2]
    }

    /// Its length \[s\].
    pub(super) fn length(&self) -> f64 {
        self.end - self.since
    }

    pub(super) fn paths<'a>(&'a self, scene: &'a Scene) -> BoundaryPaths<'a> {
        let commands = (&self.commands[..], &self.rates[..]);
        BoundaryPaths::new(
            &scene.boundaries,
            commands,
            &self.from,
            self.since,
            self.end,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Quaternion, UnitQuaternion};

    /// A pose follows its polynomial from wherever it stands, and misses nothing at the end.
    #[test]
    fn a_pose_closes_what_it_misses() {
        let command = Command {
            translation: Vec3::new(0.1, 0.0, 0.0),
            rotation: Vec3::new(0.0, 0.0, 0.2),
            ..Command::default()
        };
        let rates = [
            Command {
                translation: Vec3::new(0.0, 2.0, 0.0),
                ..Command::default()
            },
            Command {
                rotation: Vec3::new(0.0, 0.0, 6.0),
                ..Command::default()
            },
        ];
        let (from, h) = (Pose::default(), 0.5);
        let path = BoundaryPath::along(InputKind::Pose, (&command, &rates), from, 1.0, 1.0 + h);
        for s in [0.0, 0.2, 0.5] {
            let pose = path.at(1.0 + s);
            let left = 1.0 - s / h;
            let place = Vec3::new(0.1 * (1.0 - left), 2.0 * s, 0.0);
            assert!((pose.translation - place).norm() < 1e-15, "{s}");
            let angle = 0.2 * (1.0 - left) + 3.0 * s * s;
            let turn = pose.rotation_vector() - Vec3::z() * angle;
            assert!(turn.norm() < 1e-14, "{s}");
        }
    }

    fn world(
        reference: Vec3,
        position: Vec3,
        orientation: Quaternion<f64>,
    ) -> (InputKind, Command) {
        let command = Command {
            position,
            orientation,
            ..Command::default()
        };
        (InputKind::WorldPose { reference }, command)
    }

    /// A world pose is reached with constant velocities, the shorter way round, whatever the sign of its quaternion.
    #[test]
    fn a_world_pose_is_reached_at_constant_angular_velocity() {
        let (reference, h) = (Vec3::new(0.3, -0.2, 0.5), 0.04);
        let (linear, angular) = (Vec3::new(1.0, -2.0, 0.5), Vec3::new(20.0, -31.0, 45.0));
        let start = Pose::from_rotation_vector(Vec3::new(0.1, 0.0, 0.2), Vec3::new(2.0, 1.0, -2.0));
        let moved = |s: f64| start.advanced(&Twist { linear, angular }, s);
        let end = moved(h);
        let position = reference + end.translation;
        let path = |scale: f64| {
            let (kind, command) = world(reference, position, end.rotation.into_inner() * scale);
            BoundaryPath::commanded(kind, &command, start, 1.0, 1.0 + h)
        };
        for s in [0.0, 0.3 * h, 0.5 * h, h] {
            let (found, expected) = (path(1.0).at(1.0 + s), moved(s));
            assert!(
                (found.translation - expected.translation).norm() < 1e-14,
                "{s}"
            );
            assert!(
                (found.rotation.inverse() * expected.rotation).angle() < 1e-14,
                "{s}"
            );
            assert_eq!(path(-1.0).at(1.0 + s), found);
            let longer = path(1.005).at(1.0 + s);
            assert!((longer.rotation.inverse() * found.rotation).angle() < 1e-14);
        }
    }

    /// The derivatives of a quaternion are angular velocity and acceleration: a constant one stays, to rounding, with and without
    /// the second derivative, and the length of the quaternion does not matter.
    #[test]
    fn derivatives_of_a_world_pose_turn_it_exactly() {
        let (reference, h) = (Vec3::new(0.3, -0.2, 0.5), 0.04);
        let (v, w) = (Vec3::new(1.0, -2.0, 0.5), Vec3::new(20.0, -31.0, 45.0));
        let start = Pose::from_rotation_vector(Vec3::zeros(), Vec3::new(2.0, 1.0, -2.0));
        let turned = |r: Vec3| UnitQuaternion::from_scaled_axis(r) * start.rotation;
        let q = start.rotation.into_inner() * -0.995;
        let half = Quaternion::from_imag(w * 0.5);
        let (kind, command) = world(reference, reference, q);
        let rate = |position, orientation| world(reference, position, orientation).1;
        let path = |rates: &CommandDerivatives| {
            BoundaryPath::along(kind, (&command, rates), start, 0.0, h)
        };
        let none = Quaternion::default();
        for second in [half * half * q, none] {
            let rates = [rate(v, half * q), rate(Vec3::zeros(), second)];
            for s in [0.25 * h, h] {
                let pose = path(&rates).at(s);
                assert!((pose.translation - v * s).norm() < 1e-15);
                let wrong = (pose.rotation.inverse() * turned(w * s)).angle();
                assert!(
                    wrong < if second == none { 1e-12 } else { 1e-14 },
                    "{wrong:e}"
                );
            }
        }
        // q'' of an angular acceleration about the same axis: r = w s + w' s^2/2.
        let growth = w * 3.0;
        let second = half * half * q + Quaternion::from_imag(growth * 0.5) * q;
        let rates = [rate(v, half * q), rate(Vec3::zeros(), second)];
        let pose = path(&rates).at(h);
        let wrong = pose.rotation.inverse() * turned(w * h + growth * (h * h / 2.0));
        assert!(wrong.angle() < 1e-14, "{:e}", wrong.angle());
    }

    /// A turning axis: against a product of many small turns, of fourth order in the step.
    #[test]
    fn an_angular_velocity_that_turns_is_integrated_to_third_order() {
        let part = |w: Vec3| Command {
            angular_velocity: w,
            ..Command::default()
        };
        let command = part(Vec3::new(1.0, 0.0, 0.5));
        let rates = [part(Vec3::new(0.0, 3.0, -1.0)), Command::default()];
        let missed = |h: f64| {
            let path = BoundaryPath::along(
                InputKind::Twist,
                (&command, &rates),
                Pose::default(),
                0.0,
                h,
            );
            let n = 4000;
            let fine = (0..n).fold(Pose::default(), |pose, k| {
                let middle = (f64::from(k) + 0.5) * h / f64::from(n);
                let angular = command.along(&rates, middle).angular_velocity;
                let linear = Vec3::zeros();
                pose.advanced(&Twist { linear, angular }, h / f64::from(n))
            });
            (path.at(h).rotation * fine.rotation.inverse()).angle()
        };
        let (coarse, fine) = (missed(0.2), missed(0.1));
        assert!(fine < 1e-4 && coarse > 12.0 * fine, "{coarse:e} {fine:e}");
    }
}
