//! Solvers of the step problem, all judged by the one [`residual`].
//!
//! [`gauss_seidel`] updates one contact's multiplier at a time with its closed-form local solution;
//! [`augmented_lagrangian`] is the paper's loop: `K D = F` by sparse Cholesky, open-close iterations inside,
//! multiplier updates outside; [`newton`] works on the true friction cone and finishes what both leave; `tangent` gives the
//! derivative of a solution. All leave
//! impulses that satisfy the same conditions ([`crate::problem`]).
//!
//! # A solver of one's own
//!
//! A solver takes a [`Problem`](crate::problem::Problem) and improves impulses. Here projected Gauss-Seidel by the rows' law, judged as
//! all others are; in the crate it becomes a [`SolverKind`] and an arm of [`solve`].
//!
//! ```
//! use std::path::Path;
//! use std::sync::Arc;
//!
//! use sphere_dda::problem::{Impulses, Problem};
//! use sphere_dda::solver::residual::{Scale, evaluate};
//! use sphere_dda::{Vec3, scene::Scene, simulation::Simulation};
//!
//! fn sweep(problem: &Problem, impulses: &mut Impulses) {
//!     let mut velocity = problem.velocities(impulses);
//!     for (row, p) in problem.rows.iter().zip(impulses) {
//!         let (w_n, w_t) = problem.delassus(&row);
//!         let u = row.relative_velocity(&velocity) + row.bias;
//!         let (n, u_n) = (row.normal, u.dot(&row.normal));
//!         let (p_n, p_t) = (p.dot(&n), *p - n * p.dot(&n));
//!         let (p_n, p_t) = row.law.project(p_n - u_n / w_n, p_t - (u - n * u_n) / w_t, 0.0);
//!         let change = n * p_n + p_t - *p;
//!         problem.apply(&row, &mut velocity, change);
//!         *p += change;
//!     }
//! }
//!
//! let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/slopes/slopes.toml");
//! let simulation = Simulation::new(Arc::new(Scene::from_file(scene)?.scene))?;
//! let (problem, mut impulses) = simulation.problem(1e-3)?;
//! let scales = Scale::of(&problem);
//! impulses.fill(Vec3::zeros()); // they come with a warm start
//! for _ in 0..100 {
//!     sweep(&problem, &mut impulses);
//! }
//! let residual = evaluate(&problem, &scales, &impulses);
//! assert!(residual.within(&simulation.scene().settings.tolerance), "{residual:?}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod augmented_lagrangian;
mod bodies;
pub mod friction;
pub mod gauss_seidel;
mod local_problem;
pub mod newton;
mod params;
mod report;
pub mod residual;
mod strategy;
pub(crate) mod tangent;

pub use params::{Params, Registers, SolverKind};
pub use report::Report;
pub use residual::Tolerance;
pub use strategy::solve;

/// Sweeps after each multiplier update of the augmented-Lagrangian loop: they bring friction onto the true cone, where
/// the lagged discs alone converge slowly (five times fewer factorizations on the funnel).
pub const SMOOTHING: usize = 60;
