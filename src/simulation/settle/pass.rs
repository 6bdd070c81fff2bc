//! A pass of settling, and how far it has come.

use crate::simulation::Simulation;
use std::fmt;

/// A pass of settling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pass {
    /// Its number, from 1.
    pub number: u32,
    /// What it is for.
    pub kind: PassKind,
}

/// What a pass of settling is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PassKind {
    /// First pass, to coarse tolerances.
    Coarse,
    /// To the scene's gaps.
    Fine,
    /// To balanced forces.
    Balance,
}

impl fmt::Display for Pass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self.kind {
            PassKind::Coarse => "coarse",
            PassKind::Fine => "fine",
            PassKind::Balance => "balance",
        };
        write!(f, "pass {} ({kind})", self.number)
    }
}

/// How far settling has come.
#[derive(Debug, Clone, Copy)]
pub struct SettleProgress<'a> {
    /// The pass under way.
    pub pass: Pass,
    /// Time simulated in all passes so far \[s\]; it never decreases.
    pub time: f64,
    /// Largest speed \[m/s\] of a centre or a surface.
    pub speed: f64,
    /// The speed below which a sphere is at rest \[m/s\].
    pub rest_speed: f64,
    /// The simulation of this pass; its time begins anew with each.
    pub simulation: &'a Simulation,
}
