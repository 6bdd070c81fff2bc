//! What the triangles of a boundary feel, as values.

use sphere_dda::observe::Observation;
use sphere_dda::observe::walls::{FIELDS, Interval, Reading, corners, readings};
use sphere_dda_model_description::value::Value;

/// The triangles of a boundary, `[T]`.
pub struct Wall(Vec<Reading>);

impl Wall {
    /// Those of boundary `b`, with means over the communication step.
    #[must_use]
    pub fn of(state: &Observation, b: usize) -> Self {
        Self(readings(state, b, Interval::Step))
    }

    /// Gives a field of [`FIELDS`], triangle by triangle.
    pub fn give(&self, field: usize, give: &mut dyn FnMut(Value)) {
        let mut numbers = Vec::new();
        for reading in &self.0 {
            FIELDS[field].read(reading, &mut numbers);
        }
        numbers.into_iter().for_each(|x| give(Value::Real(x)));
    }
}

/// Gives the coordinates \[m\] of the corners of boundary `b`, which do not change.
pub fn give_corners(state: &Observation, b: usize, give: &mut dyn FnMut(Value)) {
    let corners = corners(state, b);
    let numbers = corners.iter().flatten().flat_map(|x| x.iter());
    numbers.for_each(|&x| give(Value::Real(x)));
}
