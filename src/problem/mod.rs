//! The step as algebra. One time step of either integrator and either method is the same problem:
//!
//! ```text
//! v1 = v_free + W J^T p                                             momentum, p: impulses [N s]
//! u  = J v1 + u_0                                                   relative velocity at a contact
//! unilateral  0 <= p_n  perp  u_n + b_n + c_n p_n >= 0
//!             p_t = Proj_{|.| <= mu p_n}(p_t - s (u_t + b_t + c_t p_t))     any s > 0
//! bilateral   u + b + c p = 0                                       constrained points
//! resistance  m_r = Proj_{|.| <= mu_r R* p_n}(m_r - s w_r)          rolling, w_r = (w_A - w_B) across n
//!             m_n = Proj_{|.| <= mu_t R* p_n}(m_n - s w_n)          twisting, w_n = (w_A - w_B) along n
//! ```
//!
//! A resistance is a couple `m` [N m s] on A and `-m` on B, bound by the normal impulse of its contact. Its row holds
//! `p = m/R` and `u = R (w_A - w_B)` with the smaller radius `R` of the pair, so that all rows have the same units.
//!
//! `b_n` carries the gap (`g/dt`) or the rebound (`e u_n^-`), `c = 1/(k dt^2)` a contact stiffness `k`
//! (`c = 0`: rigid). Moreau has `W = M^-1`, Shi `W = (2M)^-1` and `v1` the mean velocity of the step.
//! The penalty method is the rigid problem with `k = P` on every contact.

mod bounds;
pub mod friction;
pub(crate) mod law;
pub mod reduction;
mod row;
mod rows;

pub(crate) use bounds::{CONSTANTS, ELEMENTS, bounding_scale, bounds};
pub use law::Law;
use nalgebra::Matrix3;
pub(crate) use row::JacobianBlock;
pub use row::{GROUND, Row};
pub use rows::Rows;
pub(crate) use rows::{BIAS, FRICTION, RADIUS, RowWriter, SCALE, SphereContact, retain};
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::spatial::{SpatialOperator, SpatialVector};

/// The problem of one step: frozen once assembled.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Problem {
    /// Time step \[s\].
    pub step: f64,
    /// Velocity without contacts, `[N + M]`: spheres, then the `M` other bodies, driven ones first, then clumps.
    pub free: Vec<SpatialVector>,
    /// Diagonal of `W` of the spheres, `[N]`; zero where a degree of freedom is locked.
    pub inverse_mass: Vec<SpatialVector>,
    /// `W` of the driven bodies and clumps, `[M]`; singular where a joint holds them.
    #[serde(default)]
    pub operators: Vec<SpatialOperator>,
    /// The rows, `[C]`, in canonical order.
    pub rows: Rows,
}

/// Impulses on body A \[N s\], world axes, `[C]`: what every solver returns and starts from.
pub type Impulses = Vec<Vec3>;

impl Problem {
    /// Velocities `v_free + W J^T p` \[m/s\], \[rad/s\], `[N + M]`.
    #[must_use]
    pub fn velocities(&self, impulses: &[Vec3]) -> Vec<SpatialVector> {
        let mut velocity = Vec::new();
        self.velocities_into(impulses, &mut velocity);
        velocity
    }

    /// [`Self::velocities`] into `velocity`.
    pub(crate) fn velocities_into(&self, impulses: &[Vec3], velocity: &mut Vec<SpatialVector>) {
        velocity.clone_from(&self.free);
        for (row, &impulse) in self.rows.iter().zip(impulses) {
            if impulse != Vec3::zeros() {
                self.apply(&row, velocity, impulse);
            }
        }
    }

    /// Adds to `velocity`, `[N + M]`, the effect of `impulse` \[N s\] on A and of its opposite on B.
    #[inline]
    pub fn apply(&self, row: &Row, velocity: &mut [SpatialVector], impulse: Vec3) {
        let [of_a, of_b] = row.momenta(impulse);
        self.apply_impulse(velocity, row.a, &of_a);
        if row.b != GROUND {
            self.apply_impulse(velocity, row.b, &of_b);
        }
    }

    #[inline]
    fn apply_impulse(&self, velocity: &mut [SpatialVector], body: u32, momentum: &SpatialVector) {
        let velocity = &mut velocity[body as usize];
        *velocity = velocity.plus(&self.velocity_change(body, momentum), 1.0);
    }

    /// What `momentum` \[N s\], \[N m s\] adds to the velocity of a body.
    #[inline]
    pub(crate) fn velocity_change(&self, body: u32, momentum: &SpatialVector) -> SpatialVector {
        let body = body as usize;
        match self.inverse_mass.get(body) {
            Some(w) => w.component_mul(momentum),
            None => self.operators[body - self.inverse_mass.len()].times(momentum),
        }
    }

    /// The operator of body `body` on momentum.
    pub(crate) fn operator(&self, body: u32) -> SpatialOperator {
        let body = body as usize;
        match self.inverse_mass.get(body) {
            Some(w) => SpatialOperator {
                linear: Matrix3::from_diagonal(&w.linear),
                angular: Matrix3::from_diagonal(&w.angular),
            },
            None => self.operators[body - self.inverse_mass.len()],
        }
    }

    /// What `look` finds at the operator of body `body` on momentum, which is not copied if it is kept whole.
    #[inline]
    pub(crate) fn with_operator<R>(
        &self,
        body: u32,
        look: impl FnOnce(&SpatialOperator) -> R,
    ) -> R {
        match (body as usize).checked_sub(self.inverse_mass.len()) {
            Some(own) => look(&self.operators[own]),
            None => look(&self.operator(body)),
        }
    }

    /// Scale of a row's Delassus operator \[1/kg\]: `(w_n, w_t)` such that the operator is at most
    /// `w_n n n^T + w_t (1 - n n^T)`. Exact for free spheres, where normal and tangent do not couple: `w_t = 3.5 w_n`.
    #[must_use]
    pub fn delassus(&self, row: &Row) -> (f64, f64) {
        match self.sphere_delassus(row) {
            Some(closed) => closed,
            None => {
                let [of_a, of_b] = self.mobilities(row);
                bounding_scale(&(of_a + of_b), row.normal)
            }
        }
    }

    /// [`Self::delassus`] of a contact whose bodies have the same mobility in all directions and arms along the normal:
    /// `w_n = m_A + m_B`, `w_t = w_n + R_A^2/I_A + R_B^2/I_B`.
    fn sphere_delassus(&self, row: &Row) -> Option<(f64, f64)> {
        if matches!(row.law, Law::Resistance { .. }) {
            return None;
        }
        let one = |body: u32, arm: &Vec3| {
            if body == GROUND {
                return Some((0.0, 0.0));
            }
            let SpatialVector { linear, angular } = self.inverse_mass.get(body as usize)?;
            let same = |v: &Vec3| v.x == v.y && v.y == v.z;
            let (length, across) = (arm.norm_squared(), arm.cross(&row.normal).norm_squared());
            let radial = across <= 1e-24 * length;
            (radial && same(linear) && same(angular)).then_some((linear.x, angular.x * length))
        };
        let (a, b) = (one(row.a, &row.arm_a)?, one(row.b, &row.arm_b)?);
        let w_n = a.0 + b.0;
        Some((w_n, w_n + (a.1 + b.1)))
    }

    /// `d(velocity) / d(impulse)` of bodies A and B as a row holds them, 3x3 each \[1/kg\].
    fn mobilities(&self, row: &Row) -> [Matrix3<f64>; 2] {
        let [grip_a, grip_b] = row.jacobian();
        let of_b = match row.b {
            GROUND => Matrix3::zeros(),
            b => self.compliance(b, grip_b),
        };
        [self.compliance(row.a, grip_a), of_b]
    }

    /// The traces of [`Self::mobilities`].
    pub(crate) fn mobility_traces(&self, row: &Row) -> [f64; 2] {
        let one = |body: u32, grip: JacobianBlock| {
            if body == GROUND {
                return 0.0;
            }
            let body = body as usize;
            match self.inverse_mass.get(body) {
                Some(w) => trace_of(grip, w.linear.sum(), w.angular.sum(), |r| {
                    r.dot(&w.angular.component_mul(&r))
                }),
                None => {
                    let w = &self.operators[body - self.inverse_mass.len()];
                    let (linear, angular) = (w.linear.trace(), w.angular.trace());
                    trace_of(grip, linear, angular, |r| r.dot(&(w.angular * r)))
                }
            }
        };
        let [grip_a, grip_b] = row.jacobian();
        [one(row.a, grip_a), one(row.b, grip_b)]
    }

    /// `d(velocity) / d(impulse)` of one body as a row holds it, 3x3 \[1/kg\].
    fn compliance(&self, body: u32, grip: JacobianBlock) -> Matrix3<f64> {
        let w = self.operator(body);
        match grip {
            JacobianBlock::Point(arm) => {
                let cross = arm.cross_matrix();
                w.linear - cross * w.angular * cross
            }
            JacobianBlock::Couple(lever) => w.angular * (lever * lever),
        }
    }
}

/// Trace of what a body of these traces of its operators moves by where it is held, `along` being `r . W r`.
#[inline]
fn trace_of(grip: JacobianBlock, linear: f64, angular: f64, along: impl Fn(Vec3) -> f64) -> f64 {
    match grip {
        // `tr(-[r] W [r]) = r^2 tr(W) - r . W r`.
        JacobianBlock::Point(r) => linear + r.norm_squared() * angular - along(r),
        JacobianBlock::Couple(lever) => angular * (lever * lever),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a contact of a sphere with a body behind the spheres, and of a couple between them.
    #[test]
    fn traces_are_those_of_the_matrices() {
        let turned = |moments: [f64; 3]| {
            let axes = nalgebra::Rotation3::from_scaled_axis(Vec3::new(0.4, -1.1, 0.7));
            axes * Matrix3::from_diagonal(&Vec3::from(moments)) * axes.inverse()
        };
        let problem = Problem {
            step: 1e-3,
            inverse_mass: vec![SpatialVector {
                linear: Vec3::new(1.0, 0.0, 2.0),
                angular: Vec3::new(3.0, 5.0, 0.0),
            }],
            operators: vec![SpatialOperator {
                linear: turned([0.3, 0.5, 0.2]),
                angular: turned([2.0, 7.0, 4.0]),
            }],
            ..Problem::default()
        };
        let contact = Row {
            a: 0,
            b: 1,
            normal: Vec3::z(),
            arm_a: Vec3::new(0.1, -0.2, 0.3),
            arm_b: Vec3::new(-0.5, 0.4, 0.9),
            prescribed_velocity: Vec3::zeros(),
            bias: Vec3::zeros(),
            compliance_n: 0.0,
            compliance_t: 0.0,
            law: Law::Contact { mu: 0.3 },
            radius: 0.1,
            impulse_scale: 1.0,
        };
        let couple = Row {
            law: Law::Resistance {
                contact: 0,
                rolling: 0.1,
                twisting: 0.1,
            },
            ..contact
        };
        let grounded = Row {
            b: GROUND,
            ..contact
        };
        for row in [contact, couple, grounded] {
            let traces = problem.mobility_traces(&row);
            let matrices = problem.mobilities(&row).map(|matrix| matrix.trace());
            for (found, expected) in traces.into_iter().zip(matrices) {
                assert!((found - expected).abs() < 1e-14 * expected.max(1.0));
            }
        }
    }
}
