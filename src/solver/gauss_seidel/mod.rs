//! Block Gauss-Seidel on the multipliers.
//!
//! Contact by contact: the contact's own law is solved in closed form with all other multipliers held, and the velocities of
//! its two bodies follow at once (for a sphere contact the local operator is diagonal, so normal and tangent do not couple).
//! Contacts of spheres go sixteen at a time (`local`), each with its resistance to rolling (`resistance`), those of clumps
//! likewise (`levers`, from rows by `lever_rows`), those with driven bodies that are heavy too (`heavy`, by `heavy_rows`), in single precision first where the tolerances allow; what it finds is judged in
//! double. Every other row goes by the operations of
//! [`Row`](crate::problem::Row) (`general_rows`). Light spheres between heavy ones are solved with all their contacts at once
//! between sweeps (`light`). The order is fixed by the rows and, in large scenes, by where the bodies are
//! (`partition`): parts of the scene can be swept side by side. From the
//! fourth sweep on Nesterov's momentum moves impulses and velocities together; it starts anew where the corrections point back
//! or grow: with friction the latter is what counts (a tenth of the sweeps). Robust with friction.

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
mod batch;
mod batches;
mod dispatch;
mod equip;
mod exact;
mod general_rows;
mod heavy;
mod heavy_rows;
mod kernel;
mod kinds;
mod lanes;
mod lever_rows;
mod levers;
mod light;
mod local;
mod partition;
#[cfg(target_arch = "x86_64")]
mod registers;
mod resistance;
mod seats;
mod share_out;
mod sharing;
mod update;

use super::{Params, Report};
use crate::Vec3;
use crate::problem::Problem;
use crate::solver::Tolerance;
use batch::SweepParams;
pub use kernel::Kernel;
pub(crate) use partition::SMALL;

/// Exact Coulomb friction can cycle: from [`CYCLES_FROM`] on, after every [`FREE`] sweeps with momentum come [`DAMPED`] without,
/// of which each corrects by the share [`DAMPING`] only. Sweeps that stay damped crawl (five times as many at 1e-4).
const CYCLES_FROM: usize = 300;
const FREE: usize = 200;
const DAMPED: usize = 10;
const DAMPING: f64 = 0.6;
/// Sweeps after which, and promises broken after which single precision is left.
const SINGLE_SWEEPS: usize = 400;
const BROKEN: usize = 2;
/// The first sweep with momentum: the first ones remove what is local.
const MOMENTUM_FROM: usize = 4;
/// The first sweep after which light spheres are no longer solved as a whole: what is left by then is not theirs, or they cycle.
const LIGHT_BEFORE: usize = 200;
/// Growth of the squared corrections from sweep to sweep at which momentum starts anew: a little is no sign of going astray.
const GROWTH: f64 = 1.1;

/// Solves `problem` from the impulses given; see [`super::solve`].
pub fn solve(
    problem: &Problem,
    params: &Params,
    kernel: &mut Kernel,
    impulses: &mut [Vec3],
) -> Report {
    let mut report = Report::default();
    let mut momentum = Momentum::default();
    let mut last = f64::INFINITY;
    let mut pace = SweepParams {
        momentum: 0.0,
        damping: 1.0,
        strictness: 1.0,
        tolerance: params.tolerance,
    };
    kernel.compile(problem, &params.tolerance, impulses);
    let (mut found, mut broken) = (None, 0);
    while report.sweeps < params.max_sweeps {
        report.sweeps += 1;
        let damped = is_damped(report.sweeps);
        pace.damping = if damped { DAMPING } else { 1.0 };
        if damped {
            momentum = Momentum::default();
        }
        pace.momentum = if report.sweeps < MOMENTUM_FROM || damped {
            0.0
        } else {
            momentum.next()
        };
        let progress = kernel.sweep(problem, pace);
        if progress.along < 0.0 || progress.change > GROWTH * last {
            momentum = Momentum::default();
        }
        last = progress.change;
        if (MOMENTUM_FROM..LIGHT_BEFORE).contains(&report.sweeps) && !progress.settled {
            kernel.solve_light_spheres();
        }
        let exhausted = kernel.is_single() && report.sweeps >= SINGLE_SWEEPS;
        if (progress.settled && report.sweeps >= params.min_sweeps) || exhausted {
            let residual = kernel.judge(problem);
            if residual.within(&params.tolerance) {
                found = Some(residual);
                break;
            }
            // The bodies' last change is gone with the velocities taken anew.
            momentum = Momentum::default();
            last = f64::INFINITY;
            if exhausted || (kernel.is_single() && broken == BROKEN) {
                kernel.refine(problem, impulses);
                pace.strictness = 1.0;
            } else {
                // The sweep promised too much: ask later.
                pace.strictness *= 0.5;
                broken += 1;
            }
        }
    }
    report.residual = found.unwrap_or_else(|| kernel.judge(problem));
    report.converged = report.residual.within(&params.tolerance);
    kernel.store(problem, impulses);
    report
}

/// Whether sweep number `sweep`, counted from one, is damped.
fn is_damped(sweep: usize) -> bool {
    sweep > CYCLES_FROM && (sweep - CYCLES_FROM - 1) % (FREE + DAMPED) < DAMPED
}

/// `sweeps` undamped sweeps: what the augmented-Lagrangian loop uses to bring friction onto the true cone.
pub(super) fn smooth(problem: &Problem, sweeps: usize, kernel: &mut Kernel, impulses: &mut [Vec3]) {
    let pace = SweepParams {
        momentum: 0.0,
        damping: 1.0,
        strictness: 1.0,
        tolerance: Tolerance::default(),
    };
    kernel.compile(problem, &Tolerance::default(), impulses);
    for _ in 0..sweeps {
        kernel.sweep(problem, pace);
    }
    kernel.store(problem, impulses);
}

/// Nesterov's sequence of momenta.
#[derive(Debug, Clone, Copy)]
struct Momentum(f64);

impl Default for Momentum {
    fn default() -> Self {
        Self(1.0)
    }
}

impl Momentum {
    fn next(&mut self) -> f64 {
        let last = self.0;
        self.0 = 0.5 * (1.0 + (1.0 + 4.0 * last * last).sqrt());
        (last - 1.0) / self.0
    }
}
