//! How the impulses of a solved problem answer to small changes of its data, while every row keeps its state: the implicit
//! function theorem on the converged contacts.
//!
//! ```text
//! open    dp = 0
//! stick   d(u + b + c p) = 0 in the frame that turns with the normal
//! slip    the normal part of this, and dp_t = mu dp_n t + mu p_n dt,  t the direction of slip, which turns with the velocity
//! A (dv - dv_0) = J^T dp,   dv_0: change of the velocities with the impulses held
//! ```
//!
//! (bilateral rows as stick, resistances likewise with the disc and interval of their contact.) The rows' tangents at
//! the solution are those of [`super::newton`], `dp = -T (du + db - S^-1 dp)` with `S = kappa/w`: the same matrix
//! `K = A + J^T T J`, factored once. Each solution with the last `dp` on the right takes a share `1/(1 + kappa)` of the error
//! along; where contacts are more than the motions need, `dv` is unique and `dp` one of many.

use super::bodies::{Masses, moved};
use super::newton::{Proximal, Response, bound, empty, row_response, shear_share, stiffness};
use super::residual::Scale;
use crate::Vec3;
use crate::linalg::{GeneralFactor, LinearError};
use crate::problem::law::split;
use crate::problem::{Law, Problem, Row};
use crate::spatial::SpatialVector;

/// `kappa` \[-\].
const KAPPA: f64 = 1e4;
/// Most solutions for one direction, and the change over the size at which `dp` has settled.
const SOLUTIONS: usize = 100;
const SETTLED: f64 = 1e-13;
/// Share of its bound by which friction may miss it and still slip: solvers put it there exactly.
const AT_BOUND: f64 = 1e-9;

/// A change of a problem's data.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Change {
    /// Of the velocities, with the impulses held; `[N + M]`.
    pub velocity: Vec<SpatialVector>,
    /// Of the rows' unit normals, `[C]`.
    pub normal: Vec<Vec3>,
    /// Of `u + b` with the velocities held \[m/s\], `[C]`.
    pub approach: Vec<Vec3>,
}

/// Changes of the impulses of `problem`, solved by `impulses`, for each of `changes`; `[C]` \[N s\] each.
///
/// # Errors
/// [`LinearError`] if the factorization fails.
pub(crate) fn respond(
    problem: &Problem,
    impulses: &[Vec3],
    changes: &[Change],
) -> Result<Vec<Vec<Vec3>>, LinearError> {
    let own = stiffness(problem, &Scale::of(problem));
    let masses = Masses::of(problem);
    let proximal = Proximal {
        problem,
        impulses,
        stiffness: own.iter().map(|s| KAPPA * s).collect(),
        masses: &masses,
    };
    let velocity = problem.velocities(impulses);
    let (mut responses, mut approach) = (Vec::new(), Vec::new());
    for (k, row) in problem.rows.iter().enumerate() {
        let u = row.relative_velocity(&velocity) + row.bias;
        let contact = bound(&row, &problem.rows, &responses);
        let (p, s) = (impulses[k], proximal.stiffness[k]);
        let load = row.load(&problem.rows, impulses);
        let settled = consistent(&row, u, p, s, load) - row.bias;
        responses.push(row_response(&row, settled, p, s, contact));
        approach.push(u);
    }
    let mut matrix = empty(problem)?;
    proximal.assemble(&mut matrix, &responses);
    let tangent = Tangent {
        factor: matrix.factorize()?,
        proximal,
        responses,
        approach,
    };
    changes
        .iter()
        .map(|change| tangent.impulses(change))
        .collect()
}

/// The derivative of a solved problem.
struct Tangent<'a> {
    proximal: Proximal<'a>,
    responses: Vec<Response>,
    /// `u + b` at the solution, `[C]`.
    approach: Vec<Vec3>,
    factor: GeneralFactor,
}

impl Tangent<'_> {
    fn impulses(&self, change: &Change) -> Result<Vec<Vec3>, LinearError> {
        let (problem, masses) = (self.proximal.problem, self.proximal.masses);
        let rows = &problem.rows;
        // The law looks the same from a frame that turns with the normal.
        let turn: Vec<Vec3> = rows
            .iter()
            .zip(&change.normal)
            .map(|(row, change)| row.normal.cross(change))
            .collect();
        let turned: Vec<Vec3> = turn
            .iter()
            .zip(self.proximal.impulses)
            .map(|(turn, p)| turn.cross(p))
            .collect();
        let mut held = change.velocity.clone();
        for (row, &p) in rows.iter().zip(&turned) {
            problem.apply(&row, &mut held, p);
        }
        let mut momentum = Vec::with_capacity(6 * held.len());
        for (i, v) in held.iter().enumerate() {
            momentum.extend(masses.times(i, v));
        }
        let given: Vec<Vec3> = (0..rows.len())
            .map(|k| change.approach[k] - turn[k].cross(&self.approach[k]))
            .collect();
        let at_rest = vec![SpatialVector::ZERO; held.len()];
        let mut own = vec![Vec3::zeros(); rows.len()];
        for _ in 0..SOLUTIONS {
            let known: Vec<Vec3> = (0..rows.len())
                .map(|k| given[k] - self.soft(k, own[k]))
                .collect();
            let mut right = momentum.clone();
            for (k, row) in rows.iter().enumerate() {
                masses.scatter(&row, self.answer(k, &known), &mut right);
            }
            self.factor.solve(&mut right)?;
            let velocity = moved(&at_rest, &right, 1.0);
            let seen: Vec<Vec3> = rows
                .iter()
                .zip(&known)
                .map(|(row, known)| {
                    known + row.relative_velocity(&velocity) - row.prescribed_velocity
                })
                .collect();
            let next: Vec<Vec3> = (0..rows.len()).map(|k| self.answer(k, &seen)).collect();
            let largest = |of: &dyn Fn(usize) -> f64| (0..rows.len()).map(of).fold(0.0, f64::max);
            let size = largest(&|k| next[k].norm());
            let moved = largest(&|k| (next[k] - own[k]).norm());
            own = next;
            if moved <= SETTLED * size {
                break;
            }
        }
        Ok(own
            .iter()
            .zip(&turned)
            .map(|(p, turned)| p + turned)
            .collect())
    }

    /// How row `k` answers to changes of `u + b - S^-1 p`, `[C]`.
    fn answer(&self, k: usize, seen: &[Vec3]) -> Vec3 {
        let (row, answer) = (self.proximal.problem.rows.get(k), &self.responses[k]);
        let own = -(answer.tangent * seen[k]);
        match row.law {
            Law::Resistance { contact, .. } => {
                let contact = contact as usize;
                let normal = self.proximal.problem.rows.normal(contact);
                own - answer.bound_derivative * normal.dot(&seen[contact])
            }
            _ => own,
        }
    }

    /// `S^-1 p` of row `k`.
    fn soft(&self, k: usize, p: Vec3) -> Vec3 {
        let row = &self.proximal.problem.rows.get(k);
        let s = self.proximal.stiffness[k];
        let (along, across) = split(p, row.normal);
        (row.normal * along + across / shear_share(row)) / s
    }
}

/// The `u + b` that exactly fits impulse `p` \[N s\] in the state that the row is in: what the solver's tolerance has left is
/// taken out. `u` is what it has, `load` bounds a resistance.
fn consistent(row: &Row, u: Vec3, p: Vec3, s: f64, load: f64) -> Vec3 {
    let n = row.normal;
    let (p_n, p_t) = split(p, n);
    let (_, u_t) = split(u, n);
    let fits = -(n * (row.compliance_n * p_n) + p_t * row.compliance_t);
    let disc = |most: f64| {
        let size = p_t.norm();
        if size < most * (1.0 - AT_BOUND) {
            return Vec3::zeros();
        }
        let Some(along) = p_t.try_normalize(0.0) else {
            return u_t;
        };
        let slide = -(u_t + p_t * row.compliance_t).dot(&along);
        let least = AT_BOUND * most / (s * shear_share(row));
        // The bound itself is `most`: what rounding has left is made up for.
        along * ((size - most).min(0.0) / (s * shear_share(row)) - slide.max(least))
    };
    let pressing = match row.law {
        Law::Contact { .. } if p == Vec3::zeros() => return n * u.dot(&n).max(0.0) + u_t,
        Law::Resistance { .. } => load,
        _ => p_n,
    };
    let bounds = row.law.bounds(pressing);
    let most = bounds.along[1];
    if p_n.abs() < most * (1.0 - AT_BOUND) {
        return fits + disc(bounds.across);
    }
    let slide = -(u.dot(&n) + row.compliance_n * p_n) * p_n.signum();
    let short = (p_n.abs() - most).min(0.0) / s;
    let spin = p_n.signum() * (short - slide.max(AT_BOUND * most / s));
    fits + disc(bounds.across) + n * spin
}
