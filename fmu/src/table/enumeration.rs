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
const SOLVERS: [SolverKind; 3] = [
    SolverKind::Auto,
    SolverKind::Direct,
    SolverKind::GaussSeidel,
];

impl Enumeration {
    /// The solvers. Names are identifiers, since tools make items of C or Modelica of them.
    pub const SOLVER: Self = Self {
        name: "SolverKind",
        items: &[
            ("Auto", 1, "Gauss-Seidel first and Newton on what it leaves"),
            (
                "Direct",
                2,
                "Sparse Cholesky, open-close iterations, augmented-Lagrangian loop",
            ),
            ("GaussSeidel", 3, "Block Gauss-Seidel on the multipliers"),
        ],
    };

    /// Name of a value.
    #[must_use]
    pub fn item(&self, value: i64) -> Option<&'static str> {
        let found = self.items.iter().find(|item| i64::from(item.1) == value);
        found.map(|item| item.0)
    }
}

/// Value of a solver in [`Enumeration::SOLVER`].
#[must_use]
pub fn solver_value(kind: SolverKind) -> i64 {
    let found = (1..).zip(SOLVERS).find(|(_, solver)| *solver == kind);
    found.map_or(0, |(value, _)| value)
}

/// The solver of a value.
pub(super) fn solver_of(value: i64) -> Option<SolverKind> {
    let found = (1..).zip(SOLVERS).find(|(known, _)| *known == value);
    found.map(|(_, solver)| solver)
}
