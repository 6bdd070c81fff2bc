//! Enumerations: integers with names.

use sphere_dda::solver::SolverKind;

/// An enumeration: integers with names.
#[derive(Debug, PartialEq, Eq, serde::Serialize)]
pub struct Enumeration {
    /// Name of the type.
    pub name: &'static str,
    /// Name, value and meaning of each.
    pub items: &'static [(&'static str, i32, &'static str)],
}

/// The solvers in the order of their values, from 1.
pub(super) const SOLVERS: [SolverKind; 3] = [
    SolverKind::Auto,
    SolverKind::Direct,
    SolverKind::GaussSeidel,
];

impl Enumeration {
    /// The solvers, by the names of scene files.
    pub const SOLVER: Self = Self {
        name: "SolverKind",
        items: &[
            ("auto", 1, "Gauss-Seidel first and Newton on what it leaves"),
            (
                "direct",
                2,
                "Sparse Cholesky, open-close iterations, augmented-Lagrangian loop",
            ),
            ("gauss-seidel", 3, "Block Gauss-Seidel on the multipliers"),
        ],
    };

    /// Name of a value.
    #[must_use]
    pub fn item(&self, value: i32) -> Option<&'static str> {
        let found = self.items.iter().find(|item| item.1 == value);
        found.map(|item| item.0)
    }
}
