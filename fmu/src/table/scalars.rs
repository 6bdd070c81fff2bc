//! The table of scalar variables, which FMI 2.0 has as they are.

use serde::Serialize;
use sphere_dda::observe::quantities::{Kind, quantities};
use sphere_dda::scene::Scene;
use sphere_dda_model_description::fmi2::Causality;

use super::rows::{Row, Rows};
use super::variable::{Binding, Variable};

/// The variables of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Table {
    variables: Vec<Variable>,
}

impl Table {
    /// Builds the table: time, parameters, inputs of driven boundaries, then everything that is measured.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut rows = Rows::default();
        rows.push(
            Row::real("time", Some("s"), "Simulated time"),
            Causality::Independent,
            Binding::Time,
        );
        rows.parameters(scene);
        for (b, boundary) in scene.boundaries.iter().enumerate() {
            let prefix = format!("boundary.{}", boundary.name);
            if let Some(kind) = boundary.motion.input() {
                rows.inputs(&prefix, b, kind);
            }
            if let Some(belt) = boundary.belt.filter(|belt| belt.input) {
                rows.belt(&prefix, b, belt.velocity);
            }
            if let Some(pressure) = boundary.motion.pressure_input() {
                rows.servo(&prefix, b, pressure);
            }
        }
        for (rank, quantity) in quantities(scene).into_iter().enumerate() {
            let row = match quantity.kind {
                Kind::Real => Row::real(quantity.name, quantity.unit, quantity.description),
                Kind::Count => Row::count(quantity.name, quantity.description),
            };
            rows.push(row, Causality::Output, Binding::Output(rank));
        }
        Self {
            variables: rows.variables,
        }
    }

    /// All variables, by reference.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The variable with a value reference.
    #[must_use]
    pub fn get(&self, reference: u32) -> Option<&Variable> {
        self.variables.get(usize::try_from(reference).ok()?)
    }
}
