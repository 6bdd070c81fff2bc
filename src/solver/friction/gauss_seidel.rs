//! Block Gauss-Seidel on contact impulses: one contact after the other solves its own law exactly, all others held.
//!
//! Within a contact the 3x3 block couples normal and tangent, so the closed form of a sphere contact does not do: open and stick
//! are looked at first, slip by Newton's method on the contact's response ([`row_response`]). From the fourth sweep on Nesterov's
//! momentum moves the impulses; it starts anew where the changes point back or grow, and pauses now and then, as exact friction
//! can cycle.

use nalgebra::Matrix3;

use super::report::{FrictionReport, Goal};
use crate::Vec3;
use crate::problem::friction::FrictionProblem;
use crate::problem::{Row, bounding_scale};
use crate::solver::newton::{row_response, shear_share};
use crate::solver::residual::Scale;

/// The first sweep with momentum.
const MOMENTUM_FROM: usize = 4;
/// Growth of the squared changes at which momentum starts anew.
const GROWTH: f64 = 1.1;
/// Sweeps with momentum between [`DAMPED`] without, once [`CYCLES_FROM`] are done.
const FREE: usize = 200;
const DAMPED: usize = 10;
const CYCLES_FROM: usize = 300;
const DAMPING: f64 = 0.6;
/// Newton iterations within a contact, how often what is left may grow, and the share of the impulse at which they end.
const LOCAL: usize = 20;
const RISES: usize = 3;
const SETTLED: f64 = 1e-13;
/// Projections within a contact where Newton does not settle.
const PROJECTIONS: usize = 10;
/// Sweeps between two looks at the error, at most.
const RAREST_LOOK: usize = 20;

/// A contact as sweeps need it.
struct Contact {
    row: Row,
    mu: f64,
    scale: Scale,
    own: Matrix3<f64>,
    inverse: Option<Matrix3<f64>>,
}

impl Contact {
    fn of(problem: &FrictionProblem, k: usize) -> Self {
        let (row, own) = (problem.law_row(k), *problem.own(k));
        let (normal, tangential) = bounding_scale(&own, row.normal);
        Self {
            mu: problem.friction()[k],
            scale: Scale { normal, tangential },
            inverse: own.try_inverse(),
            row,
            own,
        }
    }

    /// The impulse that satisfies the law where the contact moves with `free` \[m/s\] without it; `start` is the last one.
    fn solve(&self, free: Vec3, start: Vec3) -> Vec3 {
        if free.x >= 0.0 || self.scale.normal <= 0.0 {
            return Vec3::zeros();
        }
        if let Some(inverse) = &self.inverse {
            let stick = -(inverse * free);
            if stick.x >= 0.0 && stick.yz().norm() <= self.mu * stick.x {
                return stick;
            }
        }
        self.slip(free, start)
            .unwrap_or_else(|| self.project(free, start, PROJECTIONS))
    }

    /// Newton on `p = p^(W p + u_free)`; nothing where it does not settle.
    fn slip(&self, free: Vec3, start: Vec3) -> Option<Vec3> {
        let s = 1.0 / self.scale.normal;
        let mut p = self.project(free, start, 1);
        let (mut last, mut rises) = (f64::INFINITY, 0);
        for _ in 0..LOCAL {
            let response = row_response(&self.row, self.own * p + free, p, s, None);
            let off = p - response.impulse;
            let size = off.norm();
            if size <= SETTLED * p.norm() {
                return Some(p);
            }
            rises += usize::from(size >= last);
            if rises > RISES {
                return None;
            }
            last = size;
            let t = response.tangent;
            // Answers are to the trial `p/s - u`, which is softer across the normal.
            let across = 1.0 / (s * shear_share(&self.row));
            let soft = Vec3::new(1.0 / s, across, across);
            let jacobian = Matrix3::identity() - t * Matrix3::from_diagonal(&soft) + t * self.own;
            let change = jacobian.lu().solve(&off)?;
            p -= change;
            if !p.norm().is_finite() {
                return None;
            }
        }
        None
    }

    fn project(&self, free: Vec3, start: Vec3, times: usize) -> Vec3 {
        let mut p = start;
        for _ in 0..times {
            let map = self
                .scale
                .natural_map(&self.row, self.own * p + free, p, 0.0);
            p += Vec3::x() * map.normal + map.tangential;
        }
        p
    }
}

/// At most `sweeps` sweeps from the impulses given, until the goal is reached.
pub(super) fn solve(
    problem: &FrictionProblem,
    goal: Goal,
    sweeps: usize,
    impulses: &mut [Vec3],
) -> FrictionReport {
    let contacts: Vec<Contact> = (0..problem.contacts())
        .map(|k| Contact::of(problem, k))
        .collect();
    let mut report = FrictionReport::default();
    let mut previous = impulses.to_vec();
    let mut momentum = 1.0f64;
    let mut last = f64::INFINITY;
    let mut best = (f64::INFINITY, Vec::new());
    while report.sweeps < sweeps {
        report.sweeps += 1;
        let damped = report.sweeps > CYCLES_FROM
            && (report.sweeps - CYCLES_FROM - 1) % (FREE + DAMPED) < DAMPED;
        let damping = if damped { DAMPING } else { 1.0 };
        let beta = match report.sweeps < MOMENTUM_FROM || damped {
            true => {
                momentum = 1.0;
                0.0
            }
            false => {
                let before = momentum;
                momentum = 0.5 * (1.0 + (1.0 + 4.0 * before * before).sqrt());
                (before - 1.0) / momentum
            }
        };
        for (p, previous) in impulses.iter_mut().zip(&mut previous) {
            let old = *p;
            *p += (old - *previous) * beta;
            *previous = old;
        }
        let (mut along, mut change) = (0.0, 0.0);
        for (k, contact) in contacts.iter().enumerate() {
            let old = impulses[k];
            let free = problem.velocity(k, impulses) - contact.own * old;
            let full = contact.solve(free, old) - old;
            impulses[k] = old + full * damping;
            along += (full * damping).dot(&(impulses[k] - previous[k]));
            change += full.norm_squared();
        }
        if along < 0.0 || change > GROWTH * last {
            momentum = 1.0;
        }
        last = change;
        let look = (report.sweeps / 8).clamp(1, RAREST_LOOK);
        if report.sweeps.is_multiple_of(look) || report.sweeps == sweeps || change == 0.0 {
            let error = problem.error(impulses);
            if error < best.0 {
                best = (error, impulses.to_vec());
            }
            if error <= goal.tolerance || change == 0.0 {
                break;
            }
        }
    }
    if best.0 < f64::INFINITY {
        impulses.copy_from_slice(&best.1);
    }
    report.close(problem, goal, impulses)
}
