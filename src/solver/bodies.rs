//! Six scalars a body: what solvers that assemble a matrix share.

use nalgebra::{Matrix3, Matrix3x6, Matrix6};

use crate::Vec3;
use crate::problem::{GROUND, JacobianBlock, Problem, Row};
use crate::spatial::{SpatialOperator, SpatialVector};

/// Eigenvalue of an operator's block over its largest below which the joint holds that direction.
const HELD: f64 = 1e-12;

/// `A = W^-1` of every body, with mass one where a degree of freedom is held, so that `K` stays regular.
pub(super) struct Masses<'a> {
    problem: &'a Problem,
    /// Of the spheres, `[N]`: \[kg\], \[kg m^2\] of each degree of freedom.
    spheres: Vec<[f64; 6]>,
    /// Of the driven bodies and clumps, `[M]`.
    others: Vec<OperatorMass>,
}

/// One driven body or clump.
struct OperatorMass {
    mass: SpatialOperator,
    /// Projector onto what its joint leaves free.
    free: SpatialOperator,
}

impl OperatorMass {
    fn of(operator: &SpatialOperator) -> Self {
        let [linear, angular] = [&operator.linear, &operator.angular].map(|block| {
            let largest = block.norm();
            let eigen = block.symmetric_eigen();
            let mut mass = Matrix3::zeros();
            let mut free = Matrix3::zeros();
            for (k, &w) in eigen.eigenvalues.iter().enumerate() {
                let direction = eigen.eigenvectors.column(k);
                let along = direction * direction.transpose();
                if w > HELD * largest {
                    mass += along / w;
                    free += along;
                } else {
                    mass += along;
                }
            }
            (mass, free)
        });
        Self {
            mass: SpatialOperator {
                linear: linear.0,
                angular: angular.0,
            },
            free: SpatialOperator {
                linear: linear.1,
                angular: angular.1,
            },
        }
    }
}

impl<'a> Masses<'a> {
    /// The masses of a problem's bodies.
    pub(super) fn of(problem: &'a Problem) -> Self {
        let mass = |w: &SpatialVector| {
            let w = [w.linear, w.angular];
            std::array::from_fn(|k| {
                let w = w[k / 3][k % 3];
                if w > 0.0 { 1.0 / w } else { 1.0 }
            })
        };
        Self {
            problem,
            spheres: problem.inverse_mass.iter().map(mass).collect(),
            others: problem.operators.iter().map(OperatorMass::of).collect(),
        }
    }

    /// Number of bodies, `N + M`.
    pub(super) fn len(&self) -> usize {
        self.spheres.len() + self.others.len()
    }

    /// Largest linear mass \[kg\].
    pub(super) fn heaviest(&self) -> f64 {
        let spheres = self.spheres.iter().map(|m| m[0]);
        let others = self
            .others
            .iter()
            .map(|other| other.mass.linear.diagonal().max());
        spheres.chain(others).fold(0.0, f64::max)
    }

    /// `A` of one body.
    pub(super) fn block(&self, body: usize) -> Matrix6<f64> {
        match self.spheres.get(body) {
            Some(mass) => Matrix6::from_diagonal(&(*mass).into()),
            None => {
                let mass = &self.others[body - self.spheres.len()].mass;
                let mut block = Matrix6::zeros();
                block.fixed_view_mut::<3, 3>(0, 0).copy_from(&mass.linear);
                block.fixed_view_mut::<3, 3>(3, 3).copy_from(&mass.angular);
                block
            }
        }
    }

    /// `A v` of one body.
    pub(super) fn times(&self, body: usize, v: &SpatialVector) -> [f64; 6] {
        match self.spheres.get(body) {
            Some(mass) => std::array::from_fn(|k| mass[k] * component(v, k)),
            None => {
                let momentum = self.others[body - self.spheres.len()].mass.times(v);
                std::array::from_fn(|k| component(&momentum, k))
            }
        }
    }

    /// `sqrt(sum over bodies of v^T A v)`.
    pub(super) fn norm(&self, velocity: &[SpatialVector]) -> f64 {
        let bodies = velocity.iter().enumerate();
        let squares = bodies.flat_map(|(i, v)| {
            let momentum = self.times(i, v);
            (0..6).map(move |k| momentum[k] * component(v, k))
        });
        squares.sum::<f64>().sqrt()
    }

    /// `sum over bodies of r^T W r` of `r`, `[6 (N + M)]`, with inverse mass one where a degree of freedom is held.
    pub(super) fn inverse_norm_squared(&self, r: &[f64]) -> f64 {
        let (spheres, others) = r.split_at(6 * self.spheres.len());
        let masses = self.spheres.iter().flatten();
        let of_spheres: f64 = spheres.iter().zip(masses).map(|(r, m)| r * r / m).sum();
        let others = others.chunks_exact(6).zip(&self.problem.operators);
        others.fold(of_spheres, |sum, (r, w)| {
            let r = SpatialVector {
                linear: Vec3::new(r[0], r[1], r[2]),
                angular: Vec3::new(r[3], r[4], r[5]),
            };
            sum + r.dot(&w.times(&r))
        })
    }

    /// `d(u)/d(v)` of one body: `[1, -[arm]x]` at a point, `[0, R]` of a couple, with held degrees of freedom taken out.
    pub(super) fn jacobian(&self, body: u32, grip: JacobianBlock) -> Matrix3x6<f64> {
        let body = body as usize;
        let mut j = Matrix3x6::zeros();
        let (linear, angular) = match grip {
            JacobianBlock::Point(arm) => (Matrix3::identity(), -arm.cross_matrix()),
            JacobianBlock::Couple(lever) => (Matrix3::zeros(), Matrix3::identity() * lever),
        };
        let Some(w) = self.problem.inverse_mass.get(body) else {
            let free = &self.others[body - self.spheres.len()].free;
            j.fixed_view_mut::<3, 3>(0, 0)
                .copy_from(&(linear * free.linear));
            j.fixed_view_mut::<3, 3>(0, 3)
                .copy_from(&(angular * free.angular));
            return j;
        };
        j.fixed_view_mut::<3, 3>(0, 0).copy_from(&linear);
        j.fixed_view_mut::<3, 3>(0, 3).copy_from(&angular);
        for k in 0..3 {
            if w.linear[k] == 0.0 {
                j.column_mut(k).fill(0.0);
            }
            if w.angular[k] == 0.0 {
                j.column_mut(k + 3).fill(0.0);
            }
        }
        j
    }

    /// Adds `J^T impulse` of a row to `momentum`, `[6 (N + M)]`; held degrees of freedom do not feel it.
    pub(super) fn scatter(&self, row: &Row, impulse: Vec3, momentum: &mut [f64]) {
        let [of_a, of_b] = row.momenta(impulse);
        self.give(row.a, &of_a, momentum);
        if row.b != GROUND {
            self.give(row.b, &of_b, momentum);
        }
    }

    fn give(&self, body: u32, given: &SpatialVector, momentum: &mut [f64]) {
        let body = body as usize;
        let Some(w) = self.problem.inverse_mass.get(body) else {
            let given = self.others[body - self.spheres.len()].free.times(given);
            for k in 0..6 {
                momentum[6 * body + k] += component(&given, k);
            }
            return;
        };
        for k in 0..3 {
            if w.linear[k] > 0.0 {
                momentum[6 * body + k] += given.linear[k];
            }
            if w.angular[k] > 0.0 {
                momentum[6 * body + 3 + k] += given.angular[k];
            }
        }
    }
}

/// Component `k` of six.
pub(super) fn component(v: &SpatialVector, k: usize) -> f64 {
    [v.linear, v.angular][k / 3][k % 3]
}

/// `velocity + scale * step`; `step` has six entries a body.
pub(super) fn moved(velocity: &[SpatialVector], step: &[f64], scale: f64) -> Vec<SpatialVector> {
    let part = |i: usize| Vec3::new(step[i], step[i + 1], step[i + 2]) * scale;
    velocity
        .iter()
        .enumerate()
        .map(|(i, v)| SpatialVector {
            linear: v.linear + part(6 * i),
            angular: v.angular + part(6 * i + 3),
        })
        .collect()
}

/// A row of the derivative tests: skew, biased and compliant, on a sphere of radius 1 m against the ground.
#[cfg(test)]
pub(super) fn probe_row(law: crate::problem::Law) -> Row {
    let zero = crate::Vec3::zeros();
    Row {
        a: 0,
        b: GROUND,
        normal: crate::Vec3::new(0.6, 0.0, 0.8),
        arm_a: zero,
        arm_b: zero,
        prescribed_velocity: zero,
        bias: crate::Vec3::new(0.01, -0.02, 0.005),
        compliance_n: 0.03,
        compliance_t: 0.02,
        law,
        radius: 1.0,
        impulse_scale: 1.0,
    }
}
