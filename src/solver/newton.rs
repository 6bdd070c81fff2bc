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

use nalgebra::{Matrix3, Matrix3x6, Matrix6};

use super::residual::{Scale, evaluate};
use super::{Params, Report};
use crate::Vec3;
use crate::contacts::law::{project_disc, split};
use crate::linalg::{GeneralMatrix, LinearError};
use crate::problem::{Dof6, GROUND, Law, Problem, Row};
use crate::solver::augmented_lagrangian::SHEAR_RATIO;

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
    masses: &'a [[f64; 6]],
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
        for ((v, free), masses) in velocity.iter().zip(&self.problem.free).zip(self.masses) {
            let parts = [v.linear - free.linear, v.angular - free.angular];
            balance.extend((0..6).map(|k| masses[k] * parts[k / 3][k % 3]));
        }
        let w = &self.problem.inverse_mass;
        let mut give = |body: usize, arm: Vec3, p: Vec3| {
            let parts = [p, arm.cross(&p)];
            let free = [w[body].linear, w[body].angular];
            for k in 0..6 {
                if free[k / 3][k % 3] > 0.0 {
                    balance[6 * body + k] -= parts[k / 3][k % 3];
                }
            }
        };
        for (row, &(p, _)) in self.problem.rows.iter().zip(&rows) {
            give(row.a as usize, row.arm_a, p);
            if row.b != GROUND {
                give(row.b as usize, row.arm_b, -p);
            }
        }
        let masses = self.masses.iter().flatten();
        let merit: f64 = balance.iter().zip(masses).map(|(r, m)| r * r / m).sum();
        Iterate {
            velocity,
            rows,
            balance,
            merit: merit.sqrt(),
        }
    }

    fn assemble(&self, matrix: &mut GeneralMatrix, rows: &[(Vec3, Matrix3<f64>)]) {
        matrix.clear();
        for (i, masses) in self.masses.iter().enumerate() {
            matrix.add(i, i, &Matrix6::from_diagonal(&(*masses).into()));
        }
        let w = &self.problem.inverse_mass;
        for (row, (_, tangent)) in self.problem.rows.iter().zip(rows) {
            let a = row.a as usize;
            let h = jacobian(row.arm_a, &w[a]);
            matrix.add(a, a, &(h.transpose() * tangent * h));
            if row.b != GROUND {
                let b = row.b as usize;
                let q = jacobian(row.arm_b, &w[b]);
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
    let masses: Vec<[f64; 6]> = problem.inverse_mass.iter().map(masses).collect();
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
        let momentum: f64 = velocity
            .iter()
            .zip(&masses)
            .flat_map(|(v, m)| {
                (0..6).map(move |k| m[k] * [v.linear, v.angular][k / 3][k % 3].powi(2))
            })
            .sum::<f64>()
            .sqrt();
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

/// Mass of each degree of freedom; one where it is locked, so that `K` stays regular.
fn masses(inverse_mass: &Dof6) -> [f64; 6] {
    let w = [inverse_mass.linear, inverse_mass.angular];
    std::array::from_fn(|k| {
        let w = w[k / 3][k % 3];
        if w > 0.0 { 1.0 / w } else { 1.0 }
    })
}

/// `d(u)/d(v)` of one body: `[1, -[arm]x]`, with locked degrees of freedom taken out.
fn jacobian(arm: Vec3, inverse_mass: &Dof6) -> Matrix3x6<f64> {
    let mut j = Matrix3x6::zeros();
    j.fixed_view_mut::<3, 3>(0, 0)
        .copy_from(&Matrix3::identity());
    j.fixed_view_mut::<3, 3>(0, 3)
        .copy_from(&-arm.cross_matrix());
    for k in 0..3 {
        if inverse_mass.linear[k] == 0.0 {
            j.column_mut(k).fill(0.0);
        }
        if inverse_mass.angular[k] == 0.0 {
            j.column_mut(k + 3).fill(0.0);
        }
    }
    j
}

/// `velocity + scale * step`.
fn moved(velocity: &[Dof6], step: &[f64], scale: f64) -> Vec<Dof6> {
    let part = |i: usize| Vec3::new(step[i], step[i + 1], step[i + 2]) * scale;
    velocity
        .iter()
        .enumerate()
        .map(|(i, v)| Dof6 {
            linear: v.linear + part(6 * i),
            angular: v.angular + part(6 * i + 3),
        })
        .collect()
}
