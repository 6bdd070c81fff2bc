//! Semismooth Newton on the true Coulomb cone, inside a proximal loop: what finishes steps on which block Gauss-Seidel
//! and the lagged friction discs of the paper's loop go round in circles.
//!
//! For multipliers `p` held, each row responds to a velocity with
//!
//! ```text
//! p^_n = max(0, (p_n - s (u_n + b_n)) / (1 + s c_n))
//! p^_t = Proj_{mu p^_n}((p_t - s_t (u_t + b_t)) / (1 + s_t c_t))         the disc of p^_n itself, not of p_n
//! ```
//!
//! (a resistance: disc and interval of its contact's `p^_n`)
//! with `s = kappa / w_n`, and `A (v - v_free) = J^T p^(v)` is solved by Newton's method, whose matrix
//! `K = A + J^T (-dp^/du) J` is not symmetric (sparse LU). The update `p <- p^` is a proximal step: the larger
//! `kappa`, the fewer are needed and the harder is each. `kappa` starts low and follows what succeeds (Alart & Curnier
//! 1991 for the tangent; the safeguard is that of a trust region).

use nalgebra::Matrix3;

use super::bodies::{Masses, moved};
use super::report::Best;
use super::residual::{Scale, evaluate};
use super::{Params, Report};
use crate::Vec3;
use crate::linalg::{GeneralMatrix, LinearError};
use crate::problem::law::{SHEAR_RATIO, split};
use crate::problem::{GROUND, Law, Problem, Row, Rows};
use crate::spatial::SpatialVector;

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

/// A row's response to a velocity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Response {
    /// Its impulse `p^` \[N s\].
    pub(super) impulse: Vec3,
    /// `-d p^ / d u` \[kg\].
    pub(super) tangent: Matrix3<f64>,
    /// Of a resistance: `-d p^ / d u_n` \[kg\], `u_n` being the normal velocity of its contact.
    pub(super) bound_derivative: Vec3,
}

/// The response of a row with impulse `p` at velocity `u`, for the proximal stiffness `s` \[kg\]; `contact` is that of a
/// resistance's contact, with its normal.
pub(super) fn row_response(
    row: &Row,
    u: Vec3,
    p: Vec3,
    s: f64,
    contact: Option<(&Response, Vec3)>,
) -> Response {
    let n = row.normal;
    let (d_n, d_t) = split(u + row.bias, n);
    let (p_n, p_t) = split(p, n);
    let s_t = s * shear_share(row);
    let k_n = s / (1.0 + s * row.compliance_n);
    let k_t = s_t / (1.0 + s_t * row.compliance_t);
    let q_n = (p_n / s - d_n) * k_n;
    let y_t = (p_t / s_t - d_t) * k_t;
    let nn = n * n.transpose();
    let across = Matrix3::identity() - nn;
    let nothing = Response {
        impulse: Vec3::zeros(),
        tangent: Matrix3::zeros(),
        bound_derivative: Vec3::zeros(),
    };
    let load = match (row.law, contact) {
        (Law::Contact { .. }, _) if q_n <= 0.0 => return nothing,
        (Law::Resistance { .. }, None) => return nothing,
        (Law::Resistance { .. }, Some((contact, normal))) => contact.impulse.dot(&normal),
        _ => q_n,
    };
    let (bounds, growth) = (row.law.bounds(load), row.law.growth());
    let (along, tangential) = (bounds.along(q_n), bounds.across(y_t, &across));
    let mut response = Response {
        impulse: n * along.value + tangential.value,
        tangent: tangential.tangent * k_t,
        ..nothing
    };
    if along.inside {
        response.tangent = nn * k_n + response.tangent;
    }
    let wider = tangential.outward * growth[1];
    match (row.law, contact) {
        // Its own normal impulse bounds it.
        (Law::Contact { .. }, _) => {
            response.tangent += tangential.outward * n.transpose() * (growth[1] * k_n);
        }
        (Law::Resistance { .. }, Some((contact, normal))) => {
            let stiffness = normal.dot(&(contact.tangent * normal));
            let turns = match along.inside {
                true => Vec3::zeros(),
                false => n * (along.side * growth[0]),
            };
            response.bound_derivative = (wider + turns) * stiffness;
        }
        _ => {}
    }
    response
}

/// Stiffness across the normal over that along it \[-\].
pub(super) fn shear_share(row: &Row) -> f64 {
    match row.law {
        Law::Resistance { .. } => 1.0,
        _ => SHEAR_RATIO,
    }
}

/// The contact that bounds row `row`, as it has answered.
pub(super) fn bound<'a>(
    row: &Row,
    rows: &Rows,
    responses: &'a [Response],
) -> Option<(&'a Response, Vec3)> {
    match row.law {
        Law::Resistance { contact, .. } => {
            let contact = contact as usize;
            Some((responses.get(contact)?, rows.normal(contact)))
        }
        _ => None,
    }
}

/// Where a Newton iteration stands.
struct Iterate {
    velocity: Vec<SpatialVector>,
    rows: Vec<Response>,
    /// `A (v - v_free) - J^T p^`, `[6 N]`.
    balance: Vec<f64>,
    /// Its norm in the inverse masses.
    merit: f64,
}

/// The proximal problem: what does not change while Newton iterates.
pub(super) struct Proximal<'a> {
    pub(super) problem: &'a Problem,
    pub(super) impulses: &'a [Vec3],
    /// `kappa / w_n` of each row \[kg\].
    pub(super) stiffness: Vec<f64>,
    pub(super) masses: &'a Masses<'a>,
}

impl Proximal<'_> {
    fn at(&self, velocity: Vec<SpatialVector>) -> Iterate {
        let rows = &self.problem.rows;
        let mut responses: Vec<Response> = Vec::with_capacity(rows.len());
        for ((row, &p), &s) in rows.iter().zip(self.impulses).zip(&self.stiffness) {
            let contact = bound(&row, rows, &responses);
            let u = row.relative_velocity(&velocity);
            responses.push(row_response(&row, u, p, s, contact));
        }
        let mut balance = Vec::with_capacity(6 * velocity.len());
        for (i, (v, free)) in velocity.iter().zip(&self.problem.free).enumerate() {
            balance.extend(self.masses.times(i, &v.plus(free, -1.0)));
        }
        for (row, response) in rows.iter().zip(&responses) {
            self.masses.scatter(&row, -response.impulse, &mut balance);
        }
        let merit = self.masses.inverse_norm_squared(&balance);
        Iterate {
            velocity,
            rows: responses,
            balance,
            merit: merit.sqrt(),
        }
    }

    pub(super) fn assemble(&self, matrix: &mut GeneralMatrix, responses: &[Response]) {
        matrix.clear();
        for i in 0..self.masses.len() {
            matrix.add(i, i, &self.masses.block(i));
        }
        let rows = &self.problem.rows;
        for (row, response) in rows.iter().zip(responses) {
            let tangent = &response.tangent;
            let [grip_a, grip_b] = row.jacobian();
            let a = row.a as usize;
            let h = self.masses.jacobian(row.a, grip_a);
            matrix.add(a, a, &(h.transpose() * tangent * h));
            if row.b != GROUND {
                let b = row.b as usize;
                let q = self.masses.jacobian(row.b, grip_b);
                matrix.add(b, b, &(q.transpose() * tangent * q));
                matrix.add(a, b, &(-h.transpose() * tangent * q));
                matrix.add(b, a, &(-q.transpose() * tangent * h));
            }
            if let Law::Resistance { contact, .. } = row.law {
                self.widen(
                    matrix,
                    &row,
                    &rows.get(contact as usize),
                    response.bound_derivative,
                );
            }
        }
    }

    /// A resistance widens with its contact's normal impulse: couples the two rows of the same bodies.
    fn widen(&self, matrix: &mut GeneralMatrix, row: &Row, contact: &Row, bound_derivative: Vec3) {
        if bound_derivative == Vec3::zeros() {
            return;
        }
        let coupling = bound_derivative * contact.normal.transpose();
        let bodies = |row: &Row| {
            let [grip_a, grip_b] = row.jacobian();
            let first = (row.a as usize, self.masses.jacobian(row.a, grip_a));
            let second =
                (row.b != GROUND).then(|| (row.b as usize, -self.masses.jacobian(row.b, grip_b)));
            [Some(first), second].into_iter().flatten()
        };
        for (i, couple) in bodies(row) {
            for (j, normal) in bodies(contact) {
                matrix.add(i, j, &(couple.transpose() * coupling * normal));
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

/// The matrix of a problem, all zero.
pub(super) fn empty(problem: &Problem) -> Result<GeneralMatrix, LinearError> {
    let pairs = problem.rows.iter().filter(|row| row.b != GROUND);
    GeneralMatrix::new(problem.free.len(), pairs.map(|row| (row.a, row.b)))
}

/// `1/w` of each row \[kg\].
pub(super) fn stiffness(problem: &Problem, scales: &[Scale]) -> Vec<f64> {
    // Where the rotation about the normal is locked, a resistance still has that across it.
    let operator = |(scale, row): (&Scale, Row)| match row.law {
        Law::Resistance { .. } => scale.normal.max(scale.tangential),
        _ => scale.normal,
    };
    let rows = scales.iter().zip(problem.rows.iter()).map(operator);
    rows.map(|w| if w > 0.0 { 1.0 / w } else { 1.0 }).collect()
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
    let mut matrix = empty(problem)?;
    let stiffness = stiffness(problem, &scales);
    let (mut kappa, mut growth) = (FIRST, GROWTH[0]);
    let mut report = Report {
        residual: evaluate(problem, &scales, impulses),
        ..Report::default()
    };
    let mut best = Best::new(&report.residual, &params.tolerance, impulses);
    while !report.residual.within(&params.tolerance)
        && report.factorizations < params.max_factorizations
    {
        let velocity = problem.velocities(impulses);
        let momentum = masses.norm(&velocity);
        let proximal = Proximal {
            problem,
            impulses,
            stiffness: stiffness.iter().map(|s| kappa * s).collect(),
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
        for (p, response) in impulses.iter_mut().zip(&end.rows) {
            *p = response.impulse;
        }
        report.augmentations += 1;
        report.residual = evaluate(problem, &scales, impulses);
        best.offer(&report.residual, &params.tolerance, impulses);
        kappa *= growth;
    }
    impulses.copy_from_slice(&best.impulses);
    report.residual = evaluate(problem, &scales, impulses);
    report.converged = report.residual.within(&params.tolerance);
    Ok(report)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::bodies::probe_row;

    /// The tangent against central differences in all states of all laws, error of second order.
    #[test]
    fn the_tangent_is_the_derivative() {
        let (p, q) = (Vec3::new(1.0, 0.3, 1.5), Vec3::new(0.1, 0.05, -0.1));
        let contact = probe_row(Law::Contact { mu: 0.5 });
        let resistance = probe_row(Law::Resistance {
            contact: 0,
            rolling: 0.3,
            twisting: 0.4,
        });
        let cases = [
            (contact, Vec3::new(0.02, 0.01, -0.1)),
            (contact, Vec3::new(0.2, 0.4, -0.1)),
            (contact, Vec3::new(0.6, 0.0, 0.9)),
            (probe_row(Law::Bilateral), Vec3::new(0.1, -0.3, 0.2)),
            (resistance, Vec3::new(0.001, 0.002, 0.001)),
            (resistance, Vec3::new(0.2, 0.4, -0.1)),
        ];
        // The first three directions are those of the row, the others those of a resistance's contact.
        for (row, u) in cases {
            let at = |u: Vec3, beside: Vec3| {
                let below = row_response(&contact, beside, p, 20.0, None);
                let bound = matches!(row.law, Law::Resistance { .. });
                let own = if bound { q } else { p };
                row_response(
                    &row,
                    u,
                    own,
                    20.0,
                    bound.then_some((&below, contact.normal)),
                )
            };
            let beside = Vec3::new(0.02, 0.01, -0.1);
            let here = at(u, beside);
            let bound_derivative = here.bound_derivative * contact.normal.transpose();
            let error = |h: f64| {
                (0..6)
                    .map(|axis| {
                        let step = Vec3::ith(axis % 3, h);
                        let [plus, minus] = [step, -step].map(|step| match axis / 3 {
                            0 => at(u + step, beside),
                            _ => at(u, beside + step),
                        });
                        let slope = (plus.impulse - minus.impulse) / (2.0 * h);
                        let tangent = [here.tangent, bound_derivative][axis / 3];
                        (slope + tangent.column(axis % 3)).norm()
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
