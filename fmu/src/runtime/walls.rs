//! What the triangles of a boundary feel, as values.

use sphere_dda::Vec3;
use sphere_dda::observe::Observation;
use sphere_dda::observe::walls::{FIELDS, Interval, Reading, corners, readings};
use sphere_dda_model_description::value::Value;

/// The triangles of a boundary, `[T]` each.
pub struct Wall {
    corners: Vec<[Vec3; 3]>,
    readings: Vec<Reading>,
}

impl Wall {
    /// Those of boundary `b`, with means over the communication step.
    #[must_use]
    pub fn of(state: &Observation, b: usize) -> Self {
        Self {
            corners: corners(state, b),
            readings: readings(state, b, Interval::Step),
        }
    }

    /// Gives a field of [`FIELDS`], triangle by triangle.
    pub fn give(&self, field: usize, give: &mut dyn FnMut(Value)) {
        let mut numbers = Vec::new();
        for reading in &self.readings {
            FIELDS[field].read(reading, &mut numbers);
        }
        numbers.into_iter().for_each(|x| give(Value::Real(x)));
    }

    /// Gives the coordinates of the corners \[m\].
    pub fn give_corners(&self, give: &mut dyn FnMut(Value)) {
        let numbers = self.corners.iter().flatten().flat_map(|x| x.iter());
        numbers.for_each(|&x| give(Value::Real(x)));
    }
}
