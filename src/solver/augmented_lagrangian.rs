//! The paper's solver: augmented-Lagrangian outer loop, open-close iterations on `K D = F` inside.
//!
//! For multipliers `p` held, the velocities `v` of the step minimise (paper eqs 6, 13, in velocities and
//! impulses: `sigma = P dt^2`, `A = W^-1`)
//!
//! ```text
//! 1/2 (v - v_free)^T A (v - v_free) + sum over rows of e(u),   -de/du = p^(u)
//! p^_n = max(0, (p_n - sigma (u_n + b_n)) / (1 + sigma c_n))              open / closed
//! p^_t = Proj_{mu p_n}((p_t - sigma_t (u_t + b_t)) / (1 + sigma_t c_t))   stick / slip
//! ```
//!
//! Each open-close iteration solves `K dv = F` with `K = A + J^T diag(dp^/du) J` (paper eqs 19-24 with the
//! signs put right) by sparse Cholesky. The friction disc's radius is that of the last multiplier update (Tresca), so `K`
//! stays symmetric and the inner problem convex; a line search on its energy makes the open-close iteration
//! safe. The multiplier update is `p <- p^` (paper eq 8 with the projection). The penalty is raised when an
//! update gains too little, and only after the inner problem has converged.

use std::sync::Arc;

use nalgebra::Matrix3;

use super::bodies::{Masses, component, moved};
use super::gauss_seidel::{Kernel, smooth};
use super::report::Best;
use super::residual::{Scale, evaluate};
use super::{Params, Report};
use crate::Vec3;
use crate::linalg::{BlockMatrix, BlockPattern, Factor, LinearError, Symbolic};
use crate::problem::law::{SHEAR_RATIO, split};
use crate::problem::{GROUND, Law, Problem, Row};
use crate::spatial::SpatialVector;

/// Most open-close iterations for one multiplier update.
const OPEN_CLOSE: usize = 40;
/// An update that leaves more than this share of the residual asks for a larger penalty.
const GAIN: f64 = 0.25;
/// Factor of a penalty increase.
const RAISE: f64 = 8.0;
/// Largest penalty over the mass scale `m/dt^2`: beyond it the factor loses the digits the tolerance needs.
const CEILING: f64 = 1e3;

/// What is kept between solves: the symbolic analysis, while the contact pattern stays, and memory.
#[derive(Debug, Default)]
pub struct SolverWorkspace {
    symbolic: Option<Symbolic>,
    pub(crate) kernel: Kernel,
    /// Velocities of the last solution \[m/s\], \[rad/s\], `[N + M]`.
    pub(crate) velocity: Vec<SpatialVector>,
}

/// The analysis of `pattern`: `kept`, if it is that one's.
fn analyse(kept: &mut Option<Symbolic>, pattern: BlockPattern) -> Result<&Symbolic, LinearError> {
    if kept.as_ref().is_some_and(|s| **s.pattern() != pattern) {
        *kept = None;
    }
    match kept {
        Some(symbolic) => Ok(symbolic),
        empty => Ok(empty.insert(Symbolic::new(&Arc::new(pattern))?)),
    }
}

/// One row's augmented multiplier at a velocity: value, tangent and energy.
pub(super) struct Augmented {
    /// `p^` \[N s\].
    pub(super) impulse: Vec3,
    /// `-d p^ / d u`, symmetric \[kg\].
    pub(super) tangent: Matrix3<f64>,
    /// Its share of the inner energy \[J\].
    energy: f64,
}

/// Evaluates a row for multipliers `p`, penalty `sigma` \[kg\] and the normal impulse `load` that bounds friction or
/// resistance, at velocity `u`.
pub(super) fn augmented(row: &Row, u: Vec3, p: Vec3, sigma: f64, load: f64) -> Augmented {
    let n = row.normal;
    let (d_n, d_t) = split(u + row.bias, n);
    let (p_n, p_t) = split(p, n);
    // 1/sigma is the multiplier's own compliance; infinite sigma leaves the contact spring alone.
    let soft_n = 1.0 / sigma;
    let soft_t = soft_n / SHEAR_RATIO;
    let stiff_n = 1.0 / (soft_n + row.compliance_n);
    let stiff_t = 1.0 / (soft_t + row.compliance_t);
    let y_n = (p_n * soft_n - d_n) * stiff_n;
    let y_t = (p_t * soft_t - d_t) * stiff_t;
    let nn = n * n.transpose();
    let across = Matrix3::identity() - nn;
    let bounds = row.law.bounds(load);
    let (along, tangential) = (bounds.along(y_n), bounds.across(y_t, &across));
    let t_n = if along.inside { stiff_n } else { 0.0 };
    // What does not move starts as sticking, before anything has loaded it.
    let t_t = match y_t == Vec3::zeros() {
        true => across,
        false => tangential.tangent,
    };
    Augmented {
        impulse: n * along.value + tangential.value,
        tangent: nn * t_n + t_t * stiff_t,
        energy: along.energy / stiff_n + tangential.energy / stiff_t,
    }
}

/// The inner problem: everything that does not change during one solve.
struct Inner<'a> {
    problem: &'a Problem,
    masses: Masses<'a>,
}

impl<'a> Inner<'a> {
    fn of(problem: &'a Problem) -> Self {
        Self {
            problem,
            masses: Masses::of(problem),
        }
    }

    /// Energy \[J\] and out-of-balance impulse `A (v - v_free) - J^T p^` \[N s\], six a body, at `velocity`.
    fn balance(&self, velocity: &[SpatialVector], rows: &[Augmented]) -> (f64, Vec<f64>) {
        let mut energy = 0.0;
        let mut gradient = vec![0.0; 6 * velocity.len()];
        for (i, (v, free)) in velocity.iter().zip(&self.problem.free).enumerate() {
            let difference = v.plus(free, -1.0);
            for (k, momentum) in self.masses.times(i, &difference).into_iter().enumerate() {
                energy += 0.5 * momentum * component(&difference, k);
                gradient[6 * i + k] = momentum;
            }
        }
        for (row, augmented) in self.problem.rows.iter().zip(rows) {
            energy += augmented.energy;
            let p = augmented.impulse;
            self.masses.scatter(&row, -p, &mut gradient);
        }
        (energy, gradient)
    }

    /// Assembles `K = A + J^T T J` from 6x6 blocks.
    fn assemble(&self, matrix: &mut BlockMatrix, rows: &[Augmented]) {
        matrix.clear();
        for i in 0..self.masses.len() {
            matrix.add(i, i, &self.masses.block(i));
        }
        for (row, augmented) in self.problem.rows.iter().zip(rows) {
            let [grip_a, grip_b] = row.jacobian();
            let a = row.a as usize;
            let h = self.masses.jacobian(row.a, grip_a);
            let th = augmented.tangent * h;
            matrix.add(a, a, &(h.transpose() * th));
            if row.b != GROUND {
                let b = row.b as usize;
                let q = self.masses.jacobian(row.b, grip_b);
                matrix.add(b, b, &(q.transpose() * augmented.tangent * q));
                matrix.add(b, a, &(-q.transpose() * th));
            }
        }
    }
}

/// Solves `problem` from the impulses given; see [`super::solve`].
pub(crate) fn solve(
    problem: &Problem,
    params: &Params,
    workspace: &mut SolverWorkspace,
    impulses: &mut [Vec3],
) -> Report {
    let scales = Scale::of(problem);
    let mut report = Report {
        residual: evaluate(problem, &scales, impulses),
        penalty: params.penalty,
        ..Report::default()
    };
    let mut best = Best::new(&report.residual, &params.tolerance, impulses);
    let ended = outer_loop(
        problem,
        params,
        workspace,
        impulses,
        &scales,
        (&mut report, &mut best),
    );
    report.broken = ended.err();
    // Away from the solution a large penalty may lead astray: the best iterate is returned.
    impulses.copy_from_slice(&best.impulses);
    report.residual = evaluate(problem, &scales, impulses);
    report.converged = report.residual.within(&params.tolerance);
    report
}

/// `K = A + J^T diag(dp^/du) J` \[kg\], \[kg m\], \[kg m^2\], `[6 N, 6 N]`, of the open-close iteration at the
/// velocities that `impulses` give: `dt^2` times the paper's `K` (its eqs 5, 19-22), so of the same condition number.
#[must_use]
pub fn stiffness(problem: &Problem, penalty: f64, impulses: &[Vec3]) -> BlockMatrix {
    let sigma = penalty * problem.step * problem.step;
    let velocity = problem.velocities(impulses);
    let rows: Vec<Augmented> = problem
        .rows
        .iter()
        .zip(impulses)
        .map(|(row, &p)| {
            let u = row.relative_velocity(&velocity);
            augmented(&row, u, p, sigma, bounding(problem, &row, p, impulses))
        })
        .collect();
    let mut matrix = BlockMatrix::zeros(Arc::new(pattern(problem)));
    Inner::of(problem).assemble(&mut matrix, &rows);
    matrix
}

/// The blocks that the rows couple.
fn pattern(problem: &Problem) -> BlockPattern {
    let pairs = problem.rows.iter().filter(|row| row.b != GROUND);
    BlockPattern::new(problem.free.len(), pairs.map(|row| (row.a, row.b)))
}

/// The augmented-Lagrangian loop; returns at convergence or when the work allowed is spent.
fn outer_loop(
    problem: &Problem,
    params: &Params,
    workspace: &mut SolverWorkspace,
    impulses: &mut [Vec3],
    scales: &[Scale],
    (report, best): (&mut Report, &mut Best),
) -> Result<(), LinearError> {
    let SolverWorkspace {
        symbolic, kernel, ..
    } = workspace;
    let symbolic = analyse(symbolic, pattern(problem))?;
    let mut matrix = BlockMatrix::zeros(Arc::clone(symbolic.pattern()));
    let inner = Inner::of(problem);
    let heaviest = inner.masses.heaviest();
    let dt2 = problem.step * problem.step;
    let mut ceiling = CEILING * heaviest / dt2;
    if params.adapt_penalty {
        report.penalty = report.penalty.min(ceiling);
    }
    let mut held: Option<(BlockMatrix, Factor)> = None;
    let small = 0.1 * params.tolerance.gap.min(params.tolerance.slip);
    let mut velocity = problem.velocities(impulses);

    while !report.residual.within(&params.tolerance)
        && report.factorizations < params.max_factorizations
    {
        let sigma = report.penalty * dt2;
        let loads: Vec<f64> = problem
            .rows
            .iter()
            .zip(&*impulses)
            .map(|(row, p)| bounding(problem, &row, *p, impulses))
            .collect();
        let evaluate_rows = |velocity: &[SpatialVector], impulses: &[Vec3]| -> Vec<Augmented> {
            let rows = problem.rows.iter().zip(impulses).zip(&loads);
            rows.map(|((row, &p), &r)| {
                let u = row.relative_velocity(velocity);
                augmented(&row, u, p, sigma, r)
            })
            .collect()
        };
        let mut settled = false;
        let mut rows = evaluate_rows(&velocity, impulses);
        let (mut energy, mut gradient) = inner.balance(&velocity, &rows);
        for _ in 0..OPEN_CLOSE {
            if report.factorizations >= params.max_factorizations {
                break;
            }
            inner.assemble(&mut matrix, &rows);
            // Contacts that keep their states keep `K`: with the penalty held that is most of the loop.
            let factor = match held.take().filter(|(of, _)| *of == matrix) {
                Some((_, factor)) => factor,
                None => symbolic.factorize(&matrix)?,
            };
            report.factorizations += 1;
            let mut step: Vec<f64> = gradient.iter().map(|g| -g).collect();
            factor.solve(&mut step);
            held = Some((matrix.clone(), factor));
            let slope: f64 = gradient.iter().zip(&step).map(|(g, s)| g * s).sum();
            let mut scale = 1.0;
            settled = loop {
                let trial = moved(&velocity, &step, scale);
                let trial_rows = evaluate_rows(&trial, impulses);
                let (trial_energy, trial_gradient) = inner.balance(&trial, &trial_rows);
                // Near the minimum the energy's rounding hides the descent; the residual judges there.
                let rounding = 1e-14 * energy.abs();
                if trial_energy <= energy + 1e-4 * scale * slope + rounding {
                    velocity = trial;
                    rows = trial_rows;
                    energy = trial_energy;
                    gradient = trial_gradient;
                    break motion(problem, &step) * scale <= small;
                }
                scale *= 0.5;
                if scale < 1e-6 {
                    break true;
                }
            };
            if settled {
                break;
            }
        }
        if !settled && report.factorizations >= params.max_factorizations {
            break;
        }
        if !settled && params.adapt_penalty {
            // An update from an unsettled inner problem diverges: make that problem easier instead.
            report.penalty /= RAISE * RAISE;
            ceiling = report.penalty;
            continue;
        }
        for ((p, augmented), row) in impulses.iter_mut().zip(&rows).zip(problem.rows.iter()) {
            // The lagged friction disc may outlive its contact by one update.
            let contact = matches!(row.law, Law::Contact { .. });
            let open = contact && augmented.impulse.dot(&row.normal) <= 0.0;
            *p = if open {
                Vec3::zeros()
            } else {
                augmented.impulse
            };
        }
        report.augmentations += 1;
        smooth(problem, params.smoothing, kernel, impulses);
        velocity = problem.velocities(impulses);
        let before = report.residual;
        report.residual = evaluate(problem, scales, impulses);
        best.offer(&report.residual, &params.tolerance, impulses);
        let gained = report.residual.gap <= GAIN * before.gap
            && report.residual.slip <= GAIN * before.slip
            && report.residual.force <= GAIN * before.force;
        if params.adapt_penalty && settled && !gained {
            report.penalty = (report.penalty * RAISE).min(ceiling);
        }
    }
    Ok(())
}

/// The normal impulse that bounds a row with impulse `p`: its own, or that of the contact whose resistance it is.
fn bounding(problem: &Problem, row: &Row, p: Vec3, impulses: &[Vec3]) -> f64 {
    match row.law {
        Law::Contact { .. } => p.dot(&row.normal).max(0.0),
        Law::Bilateral | Law::Resistance { .. } => row.load(&problem.rows, impulses),
    }
}

/// Largest change of a row's relative displacement over its radius for a velocity change \[-\].
fn motion(problem: &Problem, step: &[f64]) -> f64 {
    let zero = vec![SpatialVector::ZERO; problem.free.len()];
    let change = moved(&zero, step, 1.0);
    problem
        .rows
        .iter()
        .map(|row| {
            (row.relative_velocity(&change) - row.prescribed_velocity).norm() * problem.step
                / row.radius
        })
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::bodies::probe_row;

    /// Tangent and energy against central differences in all states of all laws, error of second order.
    #[test]
    fn tangent_and_energy_are_derivatives() {
        let p = Vec3::new(1.0, 0.3, 1.5);
        let contact = probe_row(Law::Contact { mu: 0.5 });
        let resistance = probe_row(Law::Resistance {
            contact: 0,
            rolling: 0.3,
            twisting: 0.4,
        });
        let cases = [
            (contact, Vec3::new(0.02, 0.01, -0.1), 1.6),
            (contact, Vec3::new(0.2, 0.4, -0.1), 0.6),
            (contact, Vec3::new(0.6, 0.0, 0.9), 0.0),
            (probe_row(Law::Bilateral), Vec3::new(0.1, -0.3, 0.2), 0.0),
            (resistance, Vec3::new(0.02, 0.01, 0.02), 9.0),
            (resistance, Vec3::new(0.2, 0.4, -0.1), 1.0),
            (resistance, Vec3::new(0.2, 0.4, -0.1), 0.0),
        ];
        for (row, u, load) in cases {
            let at = |u: Vec3| augmented(&row, u, p, 20.0, load);
            let here = at(u);
            let error = |h: f64| {
                let mut worst = 0.0f64;
                for axis in 0..3 {
                    let step = Vec3::ith(axis, h);
                    let (plus, minus) = (at(u + step), at(u - step));
                    let slope = (plus.impulse - minus.impulse) / (2.0 * h);
                    worst = worst.max((slope + here.tangent.column(axis)).norm());
                    let slope = (plus.energy - minus.energy) / (2.0 * h);
                    worst = worst.max((slope + here.impulse[axis]).abs());
                }
                worst
            };
            let (coarse, fine) = (error(1e-3), error(1e-4));
            assert!(fine < 1e-6, "{fine:e}");
            assert!(
                fine <= coarse / 50.0 || coarse < 1e-9,
                "second order: {coarse:e} {fine:e}"
            );
        }
    }
}
