//! What the triangles of boundaries with `wall_fields` feel: magnitudes by triangle, told as fields of spheres are.
//!
//! ```text
//! wall k    a stream of the triangles of all such boundaries, one boundary after the other
//! ```

use sphere_dda::formats::vtu::Field;

use super::coding::{coding, compressed, deflated, put_stream};
use super::error::ViewError;
use super::ranges::{SAMPLES, top};
use super::recording::{Moment, Surface};

/// One quantity of all triangles.
#[derive(Debug, Clone)]
pub(super) struct WallRange {
    pub(super) name: String,
    pub(super) unit: String,
    /// Largest magnitude.
    largest: f64,
    /// Those above zero of some triangles in all frames.
    samples: Vec<f64>,
}

impl WallRange {
    /// Where colours end.
    pub(super) fn top(&self) -> f64 {
        top(&self.samples)
    }

    /// Steps `K` and `s` of its coding.
    pub(super) fn coding(&self) -> (f64, f64) {
        coding(self.largest)
    }
}

/// The quantities of a recording, and the triangles that have them.
#[derive(Debug, Default)]
pub(super) struct Walls {
    pub(super) fields: Vec<WallRange>,
    /// Numbers of the triangles, sorted by boundary.
    triangles: Vec<usize>,
    /// Their boundaries, ascending.
    pub(super) boundaries: Vec<usize>,
}

impl Walls {
    /// Takes what a frame has of them.
    pub(super) fn add(&mut self, surface: &Surface) {
        let Some(area) = surface.felt.iter().find(|field| field.name == "area") else {
            return;
        };
        if self.triangles.is_empty() {
            let all = 0..surface.owner.len();
            self.triangles = all.filter(|&t| area.values[t] > 0.0).collect();
            self.triangles.sort_by_key(|&t| surface.owner[t]);
            self.boundaries = self.triangles.iter().map(|&t| surface.owner[t]).collect();
            self.boundaries.dedup();
        }
        for field in told(surface) {
            let at = self.fields.iter().position(|own| own.name == field.name);
            let at = at.unwrap_or_else(|| {
                self.fields.push(WallRange {
                    name: field.name.clone(),
                    unit: field.unit.clone(),
                    largest: 0.0,
                    samples: Vec::new(),
                });
                self.fields.len() - 1
            });
            let values = self.triangles.iter().filter_map(|&t| magnitude(field, t));
            let values: Vec<f64> = values.filter(|value| *value > 0.0).collect();
            let own = &mut self.fields[at];
            own.largest = values.iter().copied().fold(own.largest, f64::max);
            let stride = values.len().div_ceil(SAMPLES).max(1);
            own.samples.extend(values.iter().step_by(stride));
        }
    }
}

/// The quantities that a page tells.
fn told(surface: &Surface) -> impl Iterator<Item = &Field> {
    surface.felt.iter().filter(|field| field.name != "area")
}

fn magnitude(field: &Field, triangle: usize) -> Option<f64> {
    let row = field.values.chunks_exact(field.components).nth(triangle)?;
    Some(row.iter().map(|v| v * v).sum::<f64>().sqrt())
}

/// A block of frames.
pub(super) struct WallBlock<'a> {
    walls: &'a Walls,
    /// By field, frame, triangle.
    values: Vec<Vec<Vec<i64>>>,
}

impl<'a> WallBlock<'a> {
    pub(super) fn new(walls: &'a Walls) -> Self {
        Self {
            walls,
            values: vec![Vec::new(); walls.fields.len()],
        }
    }

    pub(super) fn push(&mut self, moment: &Moment) -> Result<(), ViewError> {
        for (range, frames) in self.walls.fields.iter().zip(&mut self.values) {
            let field = told(&moment.surface).find(|field| field.name == range.name);
            let (steps, scale) = range.coding();
            let code = |&t: &usize| {
                let value = magnitude(field?, t)?;
                Some(compressed(value, scale, steps))
            };
            let codes: Option<Vec<i64>> = self.walls.triangles.iter().map(code).collect();
            frames.push(codes.ok_or_else(|| ViewError::Frame {
                time: moment.time,
                what: format!("array `{}`", range.name),
                found: "missing".to_owned(),
                expected: "an array over all triangles, as in the first frame".to_owned(),
            })?);
        }
        Ok(())
    }

    /// The parts of a page.
    pub(super) fn pack(&self) -> Vec<Vec<u8>> {
        let part = |frames: &Vec<Vec<i64>>| {
            let mut bytes = Vec::new();
            let present = vec![vec![true; self.walls.triangles.len()]; frames.len()];
            put_stream(&mut bytes, frames, &present);
            deflated(&bytes)
        };
        self.values.iter().map(part).collect()
    }
}
