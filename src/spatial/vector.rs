//! Linear and angular parts together: velocities, momenta, forces and torques of a body.

use nalgebra::Matrix3;
use serde::{Deserialize, Serialize};

use crate::Vec3;

/// A body's linear and angular parts: velocity \[m/s\], \[rad/s\], a sphere's inverse inertia, momentum, force and torque.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct SpatialVector {
    /// Linear part.
    pub linear: Vec3,
    /// Angular part.
    pub angular: Vec3,
}

impl SpatialVector {
    /// Zero in all six components.
    pub const ZERO: Self = Self {
        linear: Vec3::new(0.0, 0.0, 0.0),
        angular: Vec3::new(0.0, 0.0, 0.0),
    };

    /// Component by component: what a momentum makes of a diagonal of inverse masses.
    #[inline]
    pub(crate) fn component_mul(&self, other: &Self) -> Self {
        Self {
            linear: self.linear.component_mul(&other.linear),
            angular: self.angular.component_mul(&other.angular),
        }
    }

    /// `linear . linear + angular . angular`: power of a force and torque, energy of a momentum.
    pub(crate) fn dot(&self, other: &Self) -> f64 {
        self.linear.dot(&other.linear) + self.angular.dot(&other.angular)
    }

    /// Velocity of the point at `arm` from the centre.
    pub(crate) fn at(&self, arm: Vec3) -> Vec3 {
        self.linear + self.angular.cross(&arm)
    }

    /// Force and torque that act at `arm` \[m\] from a pivot, about the pivot.
    pub(crate) fn about(&self, arm: Vec3) -> Wrench {
        Wrench {
            force: self.linear,
            torque: arm.cross(&self.linear) + self.angular,
        }
    }

    /// `self + scale * other`.
    pub(crate) fn plus(&self, other: &Self, scale: f64) -> Self {
        Self {
            linear: self.linear + other.linear * scale,
            angular: self.angular + other.angular * scale,
        }
    }
}

/// A symmetric operator on a driven body's six components that does not couple the linear with the angular part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SpatialOperator {
    /// Linear block.
    pub linear: Matrix3<f64>,
    /// Angular block.
    pub angular: Matrix3<f64>,
}

impl SpatialOperator {
    /// Zero: a body that is held.
    pub(crate) fn zero() -> Self {
        Self {
            linear: Matrix3::zeros(),
            angular: Matrix3::zeros(),
        }
    }

    /// The operator applied to both parts.
    pub(crate) fn times(&self, x: &SpatialVector) -> SpatialVector {
        SpatialVector {
            linear: self.linear * x.linear,
            angular: self.angular * x.angular,
        }
    }
}

/// Linear and angular velocity of the point of action, world axes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Twist {
    /// Linear velocity \[m/s\].
    pub linear: Vec3,
    /// Angular velocity \[rad/s\].
    pub angular: Vec3,
}

/// Force and torque on a boundary.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Wrench {
    /// Force \[N\].
    pub force: Vec3,
    /// Torque about the boundary's point of action \[N m\].
    pub torque: Vec3,
}

impl Wrench {
    /// Adds `scale * other`.
    pub(crate) fn add(&mut self, other: &Self, scale: f64) {
        self.force += other.force * scale;
        self.torque += other.torque * scale;
    }
}
