//! Rigid motion of boundaries: pose, twist, prescribed laws and commanded paths.
//!
//! A boundary's pose is counted from the scene: `x(t) = a + s(t) + Q(t) (x_0 - a)`, with `a` the point of
//! action \[m\], `s` the total translation \[m\] and `Q` the total rotation. Zero translation and identity
//! rotation mean "as in the scene".

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::scene::InputKind;
use crate::scene::body::{Body, Joint};
use crate::spatial::{Pose, Twist};

/// How a boundary moves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Motion {
    /// Stays as in the scene.
    Fixed,
    /// Constant linear \[m/s\] and angular \[rad/s\] velocity.
    Constant(Twist),
    /// `amplitude * sin(2 pi frequency t + phase) - amplitude * sin(phase)`, for translation \[m\] and
    /// rotation vector \[rad\]: zero displacement at t = 0.
    Sinusoid {
        /// Amplitude of the translation \[m\].
        translation: Vec3,
        /// Amplitude of the rotation vector \[rad\].
        rotation: Vec3,
        /// Frequency \[Hz\].
        frequency: f64,
        /// Phase \[rad\].
        phase: f64,
    },
    /// Piecewise linear table, held constant outside; rotation vectors \[rad\].
    Table {
        /// Times \[s\], strictly increasing, `[K]`.
        time: Vec<f64>,
        /// Translations \[m\], `[K]`.
        translation: Vec<Vec3>,
        /// Rotation vectors \[rad\], `[K]`.
        rotation: Vec<Vec3>,
    },
    /// Driven from outside, by [`crate::simulation::Simulation::command`].
    Input(InputKind),
    /// Moved by force and torque: its motion is solved together with that of the spheres.
    Driven(Box<Body>),
}

impl Motion {
    /// What the outside commands, if anything.
    #[must_use]
    pub fn input(&self) -> Option<InputKind> {
        match self {
            Self::Input(kind) => Some(*kind),
            Self::Driven(body) => body.input_kind(),
            _ => None,
        }
    }

    /// The slide or hinge along which it is commanded or free to move; [`Joint::Free`] for all others.
    pub(crate) fn joint(&self) -> Joint {
        match *self {
            Self::Input(InputKind::Slide { axis } | InputKind::SlideSpeed { axis }) => {
                Joint::Slide { axis }
            }
            Self::Input(InputKind::Hinge { axis } | InputKind::HingeSpeed { axis }) => {
                Joint::Hinge { axis }
            }
            Self::Driven(ref body) => body.joint,
            _ => Joint::Free,
        }
    }

    /// The pressure \[Pa\] that the outside may change, as in the scene.
    #[must_use]
    pub fn pressure_input(&self) -> Option<f64> {
        match self {
            Self::Driven(body) => body.pressure_input(),
            _ => None,
        }
    }

    /// The pose that the scene prescribes at time `t` \[s\]; as in the scene for a motion driven from outside, that of
    /// t = 0 for a driven body.
    ///
    /// A table interpolates its rotation vectors linearly, so that several turns about one axis are kept.
    pub(crate) fn pose_at(&self, t: f64) -> Pose {
        match self {
            Self::Fixed | Self::Input(_) => Pose::default(),
            Self::Driven(body) => body.pose,
            Self::Constant(twist) => Pose::default().advanced(twist, t),
            Self::Sinusoid {
                translation,
                rotation,
                frequency,
                phase,
            } => {
                let factor = (TAU * frequency * t + phase).sin() - phase.sin();
                Pose::from_rotation_vector(translation * factor, rotation * factor)
            }
            Self::Table {
                time,
                translation,
                rotation,
            } => Pose::from_rotation_vector(
                interpolate(time, translation, t),
                interpolate(time, rotation, t),
            ),
        }
    }
}

/// Piecewise linear value at `t`, held constant outside; zero from an empty table.
pub(crate) fn interpolate(time: &[f64], value: &[Vec3], t: f64) -> Vec3 {
    let after = time.partition_point(|&knot| knot <= t);
    let knot = |i: usize| Some((*time.get(i)?, *value.get(i)?));
    match (after.checked_sub(1).and_then(knot), knot(after)) {
        (Some((t0, start)), Some((t1, end))) => start + (end - start) * ((t - t0) / (t1 - t0)),
        (Some((_, held)), None) | (None, Some((_, held))) => held,
        (None, None) => Vec3::zeros(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::UnitQuaternion;

    fn near(a: Vec3, b: Vec3, tolerance: f64) -> bool {
        (a - b).norm() <= tolerance
    }

    #[test]
    fn prescribed_motions_start_as_in_the_scene_and_follow_their_law() {
        let axis = Vec3::new(0.0, 0.0, 1.0);
        let constant = Motion::Constant(Twist {
            linear: Vec3::x() * 2.0,
            angular: axis * 0.5,
        });
        let sinusoid = Motion::Sinusoid {
            translation: Vec3::x() * 0.1,
            rotation: axis * 0.2,
            frequency: 2.0,
            phase: 0.4,
        };
        for motion in [
            &constant,
            &sinusoid,
            &Motion::Fixed,
            &Motion::Input(InputKind::Pose),
        ] {
            assert_eq!(motion.pose_at(0.0), Pose::default());
        }
        let pose = constant.pose_at(3.0);
        assert!(near(pose.translation, Vec3::x() * 6.0, 1e-15));
        assert!(near(pose.rotation_vector(), axis * 1.5, 1e-15));
        let factor = (TAU * 2.0 * 0.3 + 0.4).sin() - 0.4f64.sin();
        let pose = sinusoid.pose_at(0.3);
        assert!(near(pose.translation, Vec3::x() * 0.1 * factor, 1e-15));
        assert!(near(pose.rotation_vector(), axis * 0.2 * factor, 1e-15));
    }

    #[test]
    fn a_table_is_linear_between_its_knots_and_constant_outside() {
        let axis = Vec3::new(0.0, 1.0, 0.0);
        let table = Motion::Table {
            time: vec![1.0, 2.0, 4.0],
            translation: vec![Vec3::zeros(), Vec3::x(), Vec3::x() * 5.0],
            rotation: vec![Vec3::zeros(), axis * 10.0, axis * 10.0],
        };
        for (t, x, angle) in [
            (0.0, 0.0, 0.0),
            (1.5, 0.5, 5.0),
            (2.0, 1.0, 10.0),
            (3.0, 3.0, 10.0),
            (9.0, 5.0, 10.0),
        ] {
            let pose = table.pose_at(t);
            assert!(near(pose.translation, Vec3::x() * x, 1e-15), "{t}");
            // More than a turn: compare where a point goes.
            let expected = UnitQuaternion::from_scaled_axis(axis * angle) * Vec3::z();
            assert!(near(pose.rotation * Vec3::z(), expected, 1e-14), "{t}");
        }
    }
}
