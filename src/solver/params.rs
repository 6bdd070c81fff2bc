//! What a solver is asked for.

use crate::solver::Tolerance;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which solver takes the step's problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SolverKind {
    /// Gauss-Seidel first, Newton on the neighbourhoods of what it leaves.
    #[default]
    Auto,
    /// Sparse Cholesky of `K D = F`, open-close iterations, augmented-Lagrangian outer loop.
    Direct,
    /// Block Gauss-Seidel on the multipliers.
    GaussSeidel,
}

/// Vector registers of the sweeps. Those of AVX-512 and AVX2 give the same bits; plain ones, without fused operations, their
/// own, which are the same on all x86-64 processors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Registers {
    /// The widest that the processor has.
    #[default]
    Widest,
    /// AVX2 with FMA, also where the processor has AVX-512.
    Avx2,
    /// Those that every processor has.
    Plain,
}

impl Registers {
    /// Whether this processor has them.
    #[must_use]
    pub fn exist(self) -> bool {
        match self {
            Self::Widest | Self::Plain => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => pulp::x86::V3::try_new().is_some(),
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx2 => false,
        }
    }
}

/// What a solver is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Params {
    /// Which solver.
    pub kind: SolverKind,
    /// Residuals to reach \[-\].
    pub tolerance: Tolerance,
    /// Whether the best iterate is taken where the tolerances are not reached: then less is tried.
    pub accept: bool,
    /// Fewest Gauss-Seidel sweeps, unless [`Self::max_sweeps`] are fewer.
    pub min_sweeps: usize,
    /// Most Gauss-Seidel sweeps.
    pub max_sweeps: usize,
    /// Most factorizations of a solver, and again of Newton where it finishes.
    pub max_factorizations: usize,
    /// Penalty number `P_n` \[N/m\] at the start of the augmented-Lagrangian loop.
    pub penalty: f64,
    /// Whether that loop may change it.
    pub adapt_penalty: bool,
    /// Gauss-Seidel sweeps after each of its multiplier updates; 0: none, and no finish by Newton, as in the paper.
    pub smoothing: usize,
}
