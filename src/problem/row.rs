//! One row: which bodies it holds, how, and its law.

use crate::Vec3;
use crate::problem::Law;
use crate::spatial::SpatialVector;
use serde::{Deserialize, Serialize};

/// Body B of a row that touches no second sphere.
pub const GROUND: u32 = u32::MAX;

/// How a row holds a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum JacobianBlock {
    /// At the point that lies there from the centre \[m\].
    Point(Vec3),
    /// By its rotation alone, with this lever \[m\].
    Couple(f64),
}

impl JacobianBlock {
    /// What the row sees of a body's velocity \[m/s\].
    pub(crate) fn velocity(self, body: &SpatialVector) -> Vec3 {
        match self {
            Self::Point(arm) => body.at(arm),
            Self::Couple(lever) => body.angular * lever,
        }
    }

    /// Momentum \[N s\], \[N m s\] that the row's impulse \[N s\] gives a body.
    pub(crate) fn momentum(self, impulse: Vec3) -> SpatialVector {
        match self {
            Self::Point(arm) => SpatialVector {
                linear: impulse,
                angular: arm.cross(&impulse),
            },
            Self::Couple(lever) => SpatialVector {
                linear: Vec3::zeros(),
                angular: impulse * lever,
            },
        }
    }
}

/// One contact, constrained point or resistance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Body A.
    pub a: u32,
    /// Body B, or [`GROUND`]: a sphere, or of the driven bodies and clumps the `k`-th as `N + k`.
    pub b: u32,
    /// Unit normal, from B to A.
    pub normal: Vec3,
    /// Contact point from the centre of A \[m\].
    pub arm_a: Vec3,
    /// Contact point from the centre of B, or the reference point of a driven body, the centre of mass of a clump \[m\]; zero for the ground.
    pub arm_b: Vec3,
    /// `u_0`, minus the velocity of the ground or of a belt as the row sees it \[m/s\]; zero between spheres.
    pub prescribed_velocity: Vec3,
    /// `b`: along the normal the gap or rebound term, across it the spring history \[m/s\].
    pub bias: Vec3,
    /// `c_n` \[m/(s N s)\]: normal compliance over dt^2; 0 is rigid.
    pub compliance_n: f64,
    /// `c_t`: tangential compliance over dt^2; 0 is rigid.
    pub compliance_t: f64,
    /// The law.
    pub law: Law,
    /// Smaller radius of the pair \[m\]: scale of gap and slip.
    pub radius: f64,
    /// Scale of the force residual \[N s\]: `m_min |a_f| dt`.
    pub impulse_scale: f64,
}

impl Row {
    /// How it holds A and B.
    pub(crate) fn jacobian(&self) -> [JacobianBlock; 2] {
        match self.law {
            Law::Resistance { .. } => [JacobianBlock::Couple(self.radius); 2],
            _ => [self.arm_a, self.arm_b].map(JacobianBlock::Point),
        }
    }

    /// Momenta \[N s\], \[N m s\] that its impulse \[N s\] gives A and, as its opposite, B.
    #[inline]
    pub(crate) fn momenta(&self, impulse: Vec3) -> [SpatialVector; 2] {
        let [a, b] = self.jacobian();
        [a.momentum(impulse), b.momentum(-impulse)]
    }

    /// The part of its bias across the normal \[m/s\].
    pub(crate) fn across(&self) -> Vec3 {
        self.bias - self.normal * self.bias.dot(&self.normal)
    }

    /// Whether it is a contact.
    pub(crate) fn is_contact(&self) -> bool {
        matches!(self.law, Law::Contact { .. })
    }

    /// Whether it has no spring.
    pub(crate) fn is_rigid(&self) -> bool {
        self.compliance_n == 0.0 && self.compliance_t == 0.0
    }

    /// Whether it is a resistance without spring or bias.
    pub(crate) fn is_rigid_resistance(&self) -> bool {
        let resistance = matches!(self.law, Law::Resistance { .. });
        resistance && self.is_rigid() && self.bias == Vec3::zeros()
    }

    /// Relative velocity `u` \[m/s\] of A against B for the given body velocities.
    #[must_use]
    #[inline]
    pub fn relative_velocity(&self, velocity: &[SpatialVector]) -> Vec3 {
        self.relative(|body| velocity[body])
    }

    /// [`Self::relative_velocity`] where `velocity` gives that of a body.
    #[inline]
    pub(crate) fn relative(&self, velocity: impl Fn(usize) -> SpatialVector) -> Vec3 {
        let [a, b] = self.jacobian();
        let u = a.velocity(&velocity(self.a as usize)) + self.prescribed_velocity;
        if self.b == GROUND {
            u
        } else {
            u - b.velocity(&velocity(self.b as usize))
        }
    }
}
