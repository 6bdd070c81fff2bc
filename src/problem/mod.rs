//! The step as algebra. One time step of either integrator and either method is the same problem:
//!
//! ```text
//! v1 = v_free + W J^T p                                             momentum, p: impulses [N s]
//! u  = J v1 + u_0                                                   relative velocity at a contact
//! unilateral  0 <= p_n  perp  u_n + b_n + c_n p_n >= 0
//!             p_t = Proj_{|.| <= mu p_n}(p_t - s (u_t + b_t + c_t p_t))     any s > 0
//! bilateral   u + b + c p = 0                                       constrained points
//! ```
//!
//! `b_n` carries the gap (`g/dt`) or the rebound (`e u_n^-`), `c = 1/(k dt^2)` a contact stiffness `k`
//! (`c = 0`: rigid). Moreau has `W = M^-1`, Shi `W = (2M)^-1` and `v1` the mean velocity of the step.
//! The penalty method is the rigid problem with `k = P` on every contact.

use serde::{Deserialize, Serialize};

use crate::Vec3;

/// Body B of a row that touches no second sphere.
pub const GROUND: u32 = u32::MAX;

/// A body's linear and angular parts: velocity \[m/s\], \[rad/s\], or their inverse inertia.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Dof6 {
    /// Linear part.
    pub linear: Vec3,
    /// Angular part.
    pub angular: Vec3,
}

/// The law a row obeys.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Law {
    /// Signorini-Coulomb contact with friction coefficient `mu`.
    Contact {
        /// Friction coefficient \[-\].
        mu: f64,
    },
    /// Three equations `u + b + c p = 0`; `normal` only fixes the axes.
    Bilateral,
}

/// One contact or constrained point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Body A.
    pub a: u32,
    /// Body B, or [`GROUND`].
    pub b: u32,
    /// Unit normal, from B to A.
    pub normal: Vec3,
    /// Contact point from the centre of A \[m\].
    pub arm_a: Vec3,
    /// Contact point from the centre of B \[m\]; zero for the ground.
    pub arm_b: Vec3,
    /// `u_0`, minus the velocity of the ground at the contact point \[m/s\]; zero between spheres.
    pub drift: Vec3,
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

/// The problem of one step: frozen once assembled.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Problem {
    /// Time step \[s\].
    pub step: f64,
    /// Velocity without contacts, `[N]`.
    pub free: Vec<Dof6>,
    /// Diagonal of `W`, `[N]`; zero where a degree of freedom is locked.
    pub inverse_mass: Vec<Dof6>,
    /// The rows, `[C]`, in canonical order.
    pub rows: Vec<Row>,
}

/// Impulses on body A \[N s\], world axes, `[C]`: what every solver returns and starts from.
pub type Impulses = Vec<Vec3>;
