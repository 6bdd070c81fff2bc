//! Driven bodies: boundaries that forces and torques move, solved together with the spheres.
//!
//! ```text
//! M v' = F + sum of contact impulses          M: mass on the joint's free directions
//! free    v = velocity of the centre of mass, all six components
//! slide   v along one axis, no rotation
//! hinge   rotation about one axis through the point of action
//! ```
//!
//! Each joint leaves a linear and an angular block of *modes*: orthonormal directions `d` with an inertia `J` \[kg\] or
//! \[kg m^2\] each. With the reference point at the centre of mass (free), anywhere (slide) or on the axis (hinge)
//! the two blocks do not couple, so `W = sum d d^T / J` is two 3x3 matrices.
//!
//! What a body carries from step to step is its momentum `(P, L)`, `L` about the reference point in world axes: a free body's
//! angular momentum is then kept to rounding, without a gyroscopic term. The angular velocity follows from it by the
//! inertia at the middle of the step, `w = J(Q_h)^-1 L` with `Q_h` turned by half a step of the free motion: of second
//! order, and frozen while the step is solved (the leapfrog of Fincham 1992 for rigid molecules).
//!
//! A damper `c` acts on each mode by its exact solution under the force of the step, `l = c dt / J`:
//!
//! ```text
//! moreau  v_free = e^-l P/J + dt F phi/J,  W = phi/J,  phi = (1 - e^-l)/l      stable for every c
//! shi     v_free = (2 P + dt F)/(2 J + c dt),  W = 1/(2 J + c dt)
//! ```
//!
//! Stops and a spring on a slide or hinge are rows of the step's problem, as contacts are: [`JointLimit`](crate::step).

use std::f64::consts::TAU;

use nalgebra::{Matrix3, UnitQuaternion};
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::scene::InputKind;
use crate::spatial::{Pose, SpatialOperator, SpatialVector, Twist};

/// What a driven body can do.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Joint {
    /// Anything.
    Free,
    /// Move along an axis without turning.
    Slide {
        /// Unit axis, world.
        axis: Vec3,
    },
    /// Turn about an axis through the point of action.
    Hinge {
        /// Unit axis, world.
        axis: Vec3,
    },
}

/// The area on which a servo boundary's pressure acts \[m^2\].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Area {
    /// Constant \[m^2\].
    Constant(f64),
    /// Product of the distances \[m\] between the points of action of two pairs of boundaries.
    Between([[usize; 2]; 2]),
}

/// A pressure that a body on a slide exerts along its axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Servo {
    /// Pressure \[Pa\]; positive pushes along the axis.
    pub pressure: f64,
    /// Area it acts on.
    pub area: Area,
    /// Whether the pressure comes from outside, [`Command::pressure`](crate::scene::Command::pressure), that above being its start.
    pub input: bool,
}

/// A linear spring along a slide or about a hinge.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spring {
    /// Stiffness \[N/m\], \[N m/rad\].
    pub stiffness: f64,
    /// Travel without force \[m\], \[rad\].
    pub rest: f64,
}

/// Mass, joint and loads of a boundary that is moved by force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Mass \[kg\].
    pub mass: f64,
    /// Centre of mass \[m\], scene coordinates.
    pub centre: Vec3,
    /// Principal moments of inertia about the centre of mass \[kg m^2\].
    pub moments: Vec3,
    /// Principal axes: from them to scene axes.
    pub axes: UnitQuaternion<f64>,
    /// Joint.
    pub joint: Joint,
    /// Constant force \[N\] at the point of action, world axes.
    pub force: Vec3,
    /// Constant torque \[N m\], world axes.
    pub torque: Vec3,
    /// Force on a slide by pressure.
    pub servo: Option<Servo>,
    /// Least and greatest position of its slide \[m\] or hinge \[rad\] from the scene's placement.
    pub limits: [Option<f64>; 2],
    /// Spring along its slide or about its hinge.
    pub spring: Option<Spring>,
    /// Damping of the linear \[N s/m\] and of the angular velocity \[N m s/rad\].
    pub damping: [f64; 2],
    /// Whether gravity acts on it.
    pub gravity: bool,
    /// Whether it stays in its place while the spheres settle before t = 0.
    pub hold_while_settling: bool,
    /// Pose at t = 0.
    pub pose: Pose,
    /// Displacement along its slide \[m\] or angle about its hinge \[rad\] at t = 0, of which the pose has no whole turns.
    pub start_position: f64,
    /// Velocity of the point of action at t = 0.
    pub twist: Twist,
    /// Whether forces and torques come from outside too, by [`crate::simulation::Simulation::command`].
    pub input: bool,
}

/// Directions in which a body can move, with their inertia: \[kg\] or \[kg m^2\].
pub(crate) type Modes = Vec<(Vec3, f64)>;

/// `sum d d^T f(J)`.
pub(crate) fn along(modes: &Modes, f: impl Fn(f64) -> f64) -> Matrix3<f64> {
    modes
        .iter()
        .map(|(d, inertia)| d * d.transpose() * f(*inertia))
        .sum()
}

impl Body {
    /// Pressure \[Pa\] that its servo has in the scene; `None` unless that is from outside.
    pub(crate) fn pressure_input(&self) -> Option<f64> {
        let servo = self.servo.as_ref().filter(|servo| servo.input);
        servo.map(|servo| servo.pressure)
    }

    /// The reference point of its equations \[m\], scene coordinates.
    pub(crate) fn reference(&self, pivot: Vec3) -> Vec3 {
        match self.joint {
            Joint::Hinge { .. } => pivot,
            Joint::Free | Joint::Slide { .. } => self.centre,
        }
    }

    /// Inertia about the centre of mass in scene axes \[kg m^2\].
    fn inertia(&self) -> Matrix3<f64> {
        let axes = self.axes.to_rotation_matrix();
        axes * Matrix3::from_diagonal(&self.moments) * axes.inverse()
    }

    /// Moment of inertia about an axis \[kg m^2\], unit vector of the scene, through the point `at` \[m\].
    #[must_use]
    pub fn moment_about(&self, axis: Vec3, at: Vec3) -> f64 {
        let own = axis.dot(&(self.inertia() * axis));
        own + self.mass * (self.centre - at).cross(&axis).norm_squared()
    }

    /// Linear and angular modes when turned by `rotation`.
    pub(crate) fn modes(&self, pivot: Vec3, rotation: UnitQuaternion<f64>) -> [Modes; 2] {
        match self.joint {
            Joint::Free => {
                let axes = (rotation * self.axes).to_rotation_matrix();
                let column = |k: usize| axes.matrix().column(k).into_owned();
                [
                    (0..3).map(|k| (Vec3::ith(k, 1.0), self.mass)).collect(),
                    (0..3).map(|k| (column(k), self.moments[k])).collect(),
                ]
            }
            Joint::Slide { axis } => [vec![(axis, self.mass)], Modes::new()],
            Joint::Hinge { axis } => {
                let inertia = self.moment_about(axis, pivot);
                [Modes::new(), vec![(axis, inertia)]]
            }
        }
    }

    /// Mass (`f(J) = J`), mobility (`f(J) = 1/J`) or another function of the inertias when turned by `rotation`.
    pub(crate) fn operator(
        &self,
        pivot: Vec3,
        rotation: UnitQuaternion<f64>,
        f: impl Fn(f64) -> f64,
    ) -> SpatialOperator {
        let [linear, angular] = self.modes(pivot, rotation);
        SpatialOperator {
            linear: along(&linear, &f),
            angular: along(&angular, &f),
        }
    }

    /// Point of action from the reference point \[m\], world.
    pub(crate) fn action(&self, pivot: Vec3, pose: &Pose) -> Vec3 {
        pose.rotation * (pivot - self.reference(pivot))
    }

    /// Velocity of the point of action when the body has `momentum`, about the reference point.
    pub(crate) fn twist_of(&self, pivot: Vec3, pose: &Pose, momentum: &SpatialVector) -> Twist {
        let mobility = self.operator(pivot, pose.rotation, f64::recip);
        let velocity = mobility.times(momentum);
        Twist {
            linear: velocity.at(self.action(pivot, pose)),
            angular: velocity.angular,
        }
    }

    /// Momentum \[N s\] and angular momentum about the reference point \[N m s\] when the point of action has `twist`.
    pub(crate) fn momentum_of(&self, pivot: Vec3, pose: &Pose, twist: &Twist) -> SpatialVector {
        let arm = self.action(pivot, pose);
        let velocity = SpatialVector {
            linear: twist.linear - twist.angular.cross(&arm),
            angular: twist.angular,
        };
        self.operator(pivot, pose.rotation, |inertia| inertia)
            .times(&velocity)
    }

    /// Linear and angular kinetic energy \[J\] when the point of action has `twist`; of a hinge all is angular.
    pub(crate) fn kinetic_energy(&self, pivot: Vec3, pose: &Pose, twist: &Twist) -> [f64; 2] {
        let momentum = self.momentum_of(pivot, pose, twist);
        let mobility = self.operator(pivot, pose.rotation, f64::recip);
        let velocity = mobility.times(&momentum);
        [
            0.5 * momentum.linear.dot(&velocity.linear),
            0.5 * momentum.angular.dot(&velocity.angular),
        ]
    }

    /// What the outside may command.
    pub(crate) fn input_kind(&self) -> Option<InputKind> {
        self.input.then_some(match self.joint {
            Joint::Free => InputKind::Load,
            Joint::Slide { axis } => InputKind::SlideForce { axis },
            Joint::Hinge { axis } => InputKind::HingeTorque { axis },
        })
    }

    /// Whether stops or a spring act on its joint.
    pub(crate) fn is_held(&self) -> bool {
        self.spring.is_some() || self.limits != [None; 2]
    }

    /// Displacement along the slide \[m\] or angle about the hinge \[rad\] at `pose`, of whole turns that nearest to `last`; zero for
    /// a free body.
    pub(crate) fn joint_position(&self, pose: &Pose, last: f64) -> f64 {
        match self.joint {
            Joint::Free => 0.0,
            Joint::Slide { axis } => axis.dot(&pose.translation),
            Joint::Hinge { axis } => {
                let turn = &pose.rotation;
                let angle = 2.0 * turn.imag().dot(&axis).atan2(turn.w);
                angle + TAU * ((last - angle) / TAU).round()
            }
        }
    }
}
