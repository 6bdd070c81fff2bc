//! Semismooth Newton on the true Coulomb cone, inside a proximal loop: what finishes steps on which block Gauss-Seidel
//! and the lagged friction discs of the paper's loop go round in circles.
//!
//! For multipliers `p` held, each row answers a velocity with
//!
//! ```text
//! p^_n = max(0, (p_n - s (u_n + b_n)) / (1 + s c_n))
//! p^_t = Proj_{mu p^_n}((p_t - s_t (u_t + b_t)) / (1 + s_t c_t))         the disc of p^_n itself, not of p_n
//! ```
//!
//! with `s = kappa / w_n`, and `A (v - v_free) = J^T p^(v)` is solved by Newton's method, whose matrix
//! `K = A + J^T (-dp^/du) J` is not symmetric (sparse LU). The update `p <- p^` is a proximal step: the larger
//! `kappa`, the fewer are needed and the harder is each. `kappa` starts low and follows what succeeds (Alart & Curnier
//! 1991 for the tangent; the safeguard is that of a trust region).

use nalgebra::Matrix3;

use super::augmented_lagrangian::SHEAR_RATIO;
use super::bodies::{Masses, moved};
use super::residual::{Scale, evaluate};
use super::{Params, Report};
use crate::Vec3;
use crate::contacts::law::{project_disc, split};
use crate::linalg::{GeneralMatrix, LinearError};
use crate::problem::{Dof6, GROUND, Law, Problem, Row};

/// First proximal parameter `kappa` \[-\].
const FIRST: f64 = 30.0;
/// Its growth after a success, and the least growth after failures.
const GROWTH: [f64; 2] = [4.0, 1.3];
/// Newton iterations for one proximal step.
const ITERATIONS: usize = 30;
/// Smallest step of the line search.
const SHORTEST: f64 = 1e-4;
/// Out-of-balance momentum over the momentum at which Newton stops, and up to which a proximal step counts.
const BALANCE: [f64; 2] = [1e-13, 1e-9];

/// A row's answer to a velocity: its impulse \[N s\] and `-d p^ / d u` \[kg\].
fn answer(row: &Row, u: Vec3, p: Vec3, s: f64) -> (Vec3, Matrix3<f64>) {
    let n = row.normal;
    let (d_n, d_t) = split(u + row.bias, n);
    let (p_n, p_t) = split(p, n);
    let s_t = s * SHEAR_RATIO;
    let k_n = s / (1.0 + s * row.compliance_n);
    let k_t = s_t / (1.0 + s_t * row.compliance_t);
    let q_n = (p_n / s - d_n) * k_n;
    let y_t = (p_t / s_t - d_t) * k_t;
    let nn = n * n.transpose();
    let across = Matrix3::identity() - nn;
    let stuck = (n * q_n + y_t, nn * k_n + across * k_t);
    let Law::Contact { mu } = row.law else {
        return stuck;
    };
    if q_n <= 0.0 {
        return (Vec3::zeros(), Matrix3::zeros());
    }
    let (radius, length) = (mu * q_n, y_t.norm());
    if length <= radius {
        return stuck;
    }
    let along = y_t / length;
    let turn = (across - along * along.transpose()) * (k_t * radius / length);
    let widen = along * n.transpose() * (mu * k_n);
    (n * q_n + project_disc(y_t, radius), nn * k_n + turn + widen)
}

/// Where a Newton iteration stands.
struct Iterate {
    velocity: Vec<Dof6>,
    /// Impulse and tangent of each row.
    rows: Vec<(Vec3, Matrix3<f64>)>,
    /// `A (v - v_free) - J^T p^`, `[6 N]`.
    balance: Vec<f64>,
    /// Its norm in the inverse masses.
    merit: f64,
}

/// The proximal problem: what does not change while Newton iterates.
struct Proximal<'a> {
    problem: &'a Problem,
    impulses: &'a [Vec3],
    /// `kappa / w_n` of each row \[kg\].
    stiffness: Vec<f64>,
    masses: &'a Masses<'a>,
}

impl Proximal<'_> {
    fn at(&self, velocity: Vec<Dof6>) -> Iterate {
        let rows: Vec<_> = self
            .problem
            .rows
            .iter()
            .zip(self.impulses)
            .zip(&self.stiffness)
            .map(|((row, &p), &s)| answer(row, row.relative_velocity(&velocity), p, s))
            .collect();
        let mut balance = Vec::with_capacity(6 * velocity.len());
        for (i, (v, free)) in velocity.iter().zip(&self.problem.free).enumerate() {
            balance.extend(self.masses.times(i, &v.plus(free, -1.0)));
        }
        for (row, &(p, _)) in self.problem.rows.iter().zip(&rows) {
            self.masses.scatter(row, -p, &mut balance);
        }
        let merit = self.masses.inverse_norm_squared(&balance);
        Iterate {
            velocity,
            rows,
            balance,
            merit: merit.sqrt(),
        }
    }

    fn assemble(&self, matrix: &mut GeneralMatrix, rows: &[(Vec3, Matrix3<f64>)]) {
        matrix.clear();
        for i in 0..self.masses.len() {
            matrix.add(i, i, &self.masses.block(i));
        }
        for (row, (_, tangent)) in self.problem.rows.iter().zip(rows) {
            let a = row.a as usize;
            let h = self.masses.jacobian(row.a, row.arm_a);
            matrix.add(a, a, &(h.transpose() * tangent * h));
            if row.b != GROUND {
                let b = row.b as usize;
                let q = self.masses.jacobian(row.b, row.arm_b);
                matrix.add(b, b, &(q.transpose() * tangent * q));
                matrix.add(a, b, &(-h.transpose() * tangent * q));
                matrix.add(b, a, &(-q.transpose() * tangent * h));
            }
        }
    }

    /// Newton from `start`, until balanced to `target` or nothing is gained; counts its factorizations.
    fn solve(
        &self,
        matrix: &mut GeneralMatrix,
        start: Iterate,
        target: f64,
        factorizations: &mut usize,
    ) -> Result<Iterate, LinearError> {
        let mut now = start;
        for _ in 0..ITERATIONS {
            if now.merit <= target {
                break;
            }
            self.assemble(matrix, &now.rows);
            let mut step: Vec<f64> = now.balance.iter().map(|r| -r).collect();
            matrix.solve(&mut step)?;
            *factorizations += 1;
            let mut scale = 1.0;
            let better = loop {
                let trial = self.at(moved(&now.velocity, &step, scale));
                if trial.merit < now.merit * (1.0 - 1e-4 * scale) {
                    break Some(trial);
                }
                scale *= 0.5;
                if scale < SHORTEST {
                    break None;
                }
            };
            match better {
                Some(trial) => now = trial,
                None => break,
            }
        }
        Ok(now)
    }
}

/// Solves `problem` from the impulses given; see [`super::solve`].
///
/// # Errors
/// [`LinearError`] if a factorization fails.
pub fn solve(
    problem: &Problem,
    params: &Params,
    impulses: &mut [Vec3],
) -> Result<Report, LinearError> {
    let scales = Scale::of(problem);
    let masses = Masses::of(problem);
    let pairs = problem.rows.iter().filter(|row| row.b != GROUND);
    let mut matrix = GeneralMatrix::new(problem.free.len(), pairs.map(|row| (row.a, row.b)))?;
    let (mut kappa, mut growth) = (FIRST, GROWTH[0]);
    let mut report = Report {
        residual: evaluate(problem, &scales, impulses),
        ..Report::default()
    };
    while !report.residual.within(&params.tolerance)
        && report.factorizations < params.max_factorizations
    {
        let velocity = problem.velocities(impulses);
        let momentum = masses.norm(&velocity);
        let proximal = Proximal {
            problem,
            impulses,
            stiffness: scales.iter().map(|scale| kappa / scale.normal).collect(),
            masses: &masses,
        };
        let start = proximal.at(velocity);
        let worst = start.merit;
        let end = proximal.solve(
            &mut matrix,
            start,
            BALANCE[0] * momentum,
            &mut report.factorizations,
        )?;
        if end.merit > BALANCE[1] * momentum.max(worst) {
            kappa /= growth * growth;
            growth = growth.sqrt().max(GROWTH[1]);
            continue;
        }
        for (p, (answer, _)) in impulses.iter_mut().zip(&end.rows) {
            *p = *answer;
        }
        report.augmentations += 1;
        report.residual = evaluate(problem, &scales, impulses);
        kappa *= growth;
    }
    report.converged = report.residual.within(&params.tolerance);
    Ok(report)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tangent against central differences in stick, slip, open and for springs, error of second order.
    #[test]
    fn the_tangent_is_the_derivative() {
        let row = |law| Row {
            a: 0,
            b: GROUND,
            normal: Vec3::new(0.6, 0.0, 0.8),
            arm_a: Vec3::zeros(),
            arm_b: Vec3::zeros(),
            drift: Vec3::zeros(),
            bias: Vec3::new(0.01, -0.02, 0.005),
            compliance_n: 0.03,
            compliance_t: 0.02,
            law,
            radius: 1.0,
            impulse_scale: 1.0,
        };
        let p = Vec3::new(1.0, 0.3, 1.5);
        let contact = row(Law::Contact { mu: 0.5 });
        let cases = [
            (contact, Vec3::new(0.02, 0.01, -0.1)),
            (contact, Vec3::new(0.2, 0.4, -0.1)),
            (contact, Vec3::new(0.6, 0.0, 0.9)),
            (row(Law::Bilateral), Vec3::new(0.1, -0.3, 0.2)),
        ];
        for (row, u) in cases {
            let (_, tangent) = answer(&row, u, p, 20.0);
            let error = |h: f64| {
                (0..3)
                    .map(|axis| {
                        let step = Vec3::ith(axis, h);
                        let [plus, minus] =
                            [u + step, u - step].map(|u| answer(&row, u, p, 20.0).0);
                        let slope = (plus - minus) / (2.0 * h);
                        (slope + tangent.column(axis)).norm()
                    })
                    .fold(0.0, f64::max)
            };
            let (coarse, fine) = (error(1e-3), error(1e-4));
            assert!(fine < 1e-5, "{fine:e}");
            assert!(
                fine <= coarse / 50.0 || coarse < 1e-9,
                "second order: {coarse:e} {fine:e}"
            );
        }
    }
}
