//! The history: one CSV row per output time, `history.csv`.
//!
//! The header names each column and its unit, `name [unit]`, `-` where there is none: first `time [s]`, the end of the
//! communication step, then all of [`crate::observe::quantities`]. Numbers carry as many digits as it takes to read the same f64
//! back.

use crate::observe::Observation;
use crate::observe::quantities::{quantities, values};
use crate::scene::Scene;

/// Header of the history of `scene`.
#[must_use]
pub fn columns(scene: &Scene) -> Vec<String> {
    let columns = quantities(scene).into_iter().flat_map(|quantity| {
        let unit = quantity.unit.unwrap_or("-");
        let names = quantity.names().into_iter();
        names.map(move |name| format!("{name} [{unit}]"))
    });
    std::iter::once("time [s]".to_owned())
        .chain(columns)
        .collect()
}

/// The row of a state, in the order of [`columns`].
#[must_use]
pub fn row(state: &Observation) -> Vec<f64> {
    std::iter::once(state.time).chain(values(state)).collect()
}
