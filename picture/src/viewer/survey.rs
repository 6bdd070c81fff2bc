//! The first look at a recording: which spheres there are, how far they get, how large their fields are.

use std::collections::BTreeMap;

use sphere_dda::Vec3;
use sphere_dda::formats::vtu::Field;

use super::error::ViewError;
use super::ranges::{SAMPLES, quantile, top};
use super::recording::{Moment, Recording};
use super::walls::Walls;

/// Share of the frames whose forces all lie below the top of their colours.
const MOST: f64 = 0.75;
/// Rim around the boundaries, or the first frame's spheres, over their diagonal: beyond it spheres are lost in space.
const RIM: f64 = 0.1;

/// A sphere of the recording; the page calls it by its rank.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slot {
    pub(super) id: i64,
    pub(super) radius: f64,
    pub(super) material: i64,
}

/// An array over the spheres.
#[derive(Debug, Clone, Default)]
pub(super) struct FieldRange {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) components: usize,
    /// Largest magnitude of a component.
    pub(super) largest: f64,
    /// Magnitudes of some spheres in all frames.
    samples: Vec<f64>,
}

impl FieldRange {
    /// Where the colours end: nearly all values lie below.
    pub(super) fn top(&self) -> f64 {
        top(&self.samples)
    }
}

/// What all frames have in common.
#[derive(Debug, Default)]
pub(super) struct Survey {
    /// Spheres by ascending id.
    pub(super) slots: Vec<Slot>,
    /// Lowest and highest corner that centres reach \[m\]; `None` without spheres.
    pub(super) reach: Option<(Vec3, Vec3)>,
    /// The same in the first frame, whole spheres.
    pub(super) start: Option<(Vec3, Vec3)>,
    /// Where most of the run is: what is far from here has no say in the ranges of colours.
    near: Option<(Vec3, Vec3)>,
    pub(super) fields: Vec<FieldRange>,
    /// Largest normal force \[N\] of a contact.
    pub(super) largest_force: f64,
    /// Likewise, of each frame.
    strongest: Vec<f64>,
    pub(super) walls: Walls,
}

impl Survey {
    /// Reads the frames with these indices; `seen` hears how many are done.
    pub(super) fn of(
        recording: &Recording,
        wanted: &[usize],
        mut seen: impl FnMut(usize) + Send,
    ) -> Result<Self, ViewError> {
        let mut survey = Self::default();
        let mut slots = BTreeMap::new();
        let mut done = 0;
        recording.each(wanted, |moment| {
            survey.add(&moment, &mut slots)?;
            done += 1;
            seen(done);
            Ok(true)
        })?;
        survey.slots = slots.into_values().collect();
        Ok(survey)
    }

    fn add(&mut self, moment: &Moment, slots: &mut BTreeMap<i64, Slot>) -> Result<(), ViewError> {
        let spheres = &moment.spheres;
        for (k, &id) in spheres.id.iter().enumerate() {
            let (radius, material) = (spheres.radius[k], spheres.material[k]);
            let slot = Slot {
                id,
                radius,
                material,
            };
            let known = slots.entry(id).or_insert(slot);
            if known.radius != radius {
                return Err(ViewError::Frame {
                    time: moment.time,
                    what: format!("the radius of sphere {id}"),
                    found: format!("{radius} m"),
                    expected: format!("{} m as in the frames before", known.radius),
                });
            }
        }
        let joined = |reach: Option<(Vec3, Vec3)>, (low, high): (Vec3, Vec3)| match reach {
            None => Some((low, high)),
            Some((l, h)) => Some((l.inf(&low), h.sup(&high))),
        };
        let centres = spheres.position.iter().map(|&x| (x, x));
        self.reach = centres.fold(self.reach, joined);
        if self.start.is_none() {
            let whole = spheres.position.iter().zip(&spheres.radius);
            let whole = whole.map(|(x, &r)| (x.add_scalar(-r), x.add_scalar(r)));
            self.start = whole.fold(None, joined);
        }
        if self.near.is_none() {
            let corners = moment.surface.points.iter().map(|&x| (x, x));
            let around = corners.chain(self.start).fold(None, joined);
            self.near = around.map(|(low, high)| {
                let rim = RIM * (high - low).norm();
                (low.add_scalar(-rim), high.add_scalar(rim))
            });
        }
        let near = |x: &Vec3| self.near.is_none_or(|(low, high)| *x >= low && *x <= high);
        let near: Vec<bool> = spheres.position.iter().map(near).collect();
        for field in &spheres.fields {
            self.add_field(field, &near);
        }
        self.walls.add(&moment.surface);
        let forces = moment.contacts.iter().map(|contact| contact.force);
        self.largest_force = forces.clone().fold(self.largest_force, f64::max);
        // Frames in which nothing touches have no say.
        self.strongest
            .extend(forces.reduce(f64::max).filter(|&force| force > 0.0));
        Ok(())
    }

    fn add_field(&mut self, field: &Field, near: &[bool]) {
        let at = self.fields.iter().position(|own| own.name == field.name);
        let at = at.unwrap_or_else(|| {
            self.fields.push(FieldRange {
                name: field.name.clone(),
                unit: field.unit.clone(),
                components: field.components,
                ..FieldRange::default()
            });
            self.fields.len() - 1
        });
        let own = &mut self.fields[at];
        let magnitudes = field.values.iter().map(|v| v.abs());
        own.largest = magnitudes.fold(own.largest, f64::max);
        let rows = field.values.chunks_exact(field.components.max(1));
        let stride = rows.len().div_ceil(SAMPLES).max(1);
        let norm = |row: &[f64]| row.iter().map(|v| v * v).sum::<f64>().sqrt();
        let rows = rows.zip(near).step_by(stride).filter(|(_, near)| **near);
        own.samples.extend(rows.map(|(row, _)| norm(row)));
    }

    /// Rank of a sphere.
    pub(super) fn rank(&self, id: i64) -> Option<usize> {
        self.slots.binary_search_by_key(&id, |slot| slot.id).ok()
    }

    /// Normal force \[N\] where lines have their last colour: in most frames none is larger, and an impact once in the run
    /// does not make the others invisible.
    pub(super) fn top_force(&self) -> f64 {
        quantile(&self.strongest, MOST)
    }

    /// Smallest radius \[m\]; `None` without spheres.
    pub(super) fn smallest_radius(&self) -> Option<f64> {
        self.slots.iter().map(|slot| slot.radius).reduce(f64::min)
    }
}
