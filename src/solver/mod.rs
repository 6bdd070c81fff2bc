//! Solvers of the step problem, all judged by the one [`residual`].
//!
//! [`gauss_seidel`] updates one contact's multiplier at a time with its closed-form local solution;
//! [`augmented_lagrangian`] is the paper's loop: `K D = F` by sparse Cholesky, open-close iterations inside,
//! multiplier updates outside; [`newton`] works on the true friction cone and finishes what both leave; `tangent` gives the
//! derivative of a solution. All leave
//! impulses that satisfy the same conditions ([`crate::problem`]); a faster solver is one more function of the same shape.

pub mod augmented_lagrangian;
mod bodies;
pub mod gauss_seidel;
mod local_problem;
pub mod newton;
mod params;
mod report;
pub mod residual;
mod strategy;
pub(crate) mod tangent;

pub use params::{Params, SolverKind};
pub use report::Report;
pub use residual::Tolerance;
pub use strategy::solve;

/// Sweeps after each multiplier update of the augmented-Lagrangian loop: they bring friction onto the true cone, where
/// the lagged discs alone converge slowly (five times fewer factorizations on the funnel).
pub const SMOOTHING: usize = 60;
