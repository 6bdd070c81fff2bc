//! Overlaps at t = 0: spheres that start inside each other or inside a boundary.
//!
//! The overlap of a pair is `-g / min(R_i, R_j)`, of a sphere and a boundary `-g / R`, with the true gap `g` \[m\].

use std::ops::Range;

use super::decode::Entry;
use super::document::Document;
use super::file;
use crate::detection::periodic::periodic_pairs_up_to;
use crate::parallel::Pool;
use crate::scene::{Boundary, Scene};
use crate::spatial::Pose;

/// Most pairs of spheres that are looked at, and most for each sphere in a larger scene.
const MOST: [usize; 2] = [1_000_000, 20];

/// A sphere that starts inside something.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlap {
    /// Index of the sphere.
    pub sphere: usize,
    /// Index of the other sphere or of the boundary.
    pub other: usize,
    /// `-g` over the smaller radius \[-\], > 0.
    pub ratio: f64,
}

/// All overlaps at t = 0.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Overlaps {
    /// Pairs of spheres.
    pub pairs: Vec<Overlap>,
    /// Spheres and boundaries.
    pub boundaries: Vec<Overlap>,
    /// Whether there are more pairs than were looked at.
    pub more: bool,
}

impl Overlaps {
    /// Finds those above the gap tolerance of the scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let tolerance = scene.settings.tolerance.gap;
        let radius = &scene.particles.radius;
        let position = &scene.initial.position;
        let present = |i: &usize| scene.initial.present[*i];
        let mut found = Self::default();
        let most = MOST[0].max(MOST[1] * radius.len());
        let is_present = &scene.initial.present;
        let pairs = periodic_pairs_up_to(
            most,
            &scene.cell,
            position,
            is_present,
            radius,
            &Pool::default(),
        );
        found.more = pairs.len() > most;
        for (i, j, image) in pairs {
            if scene.particles.are_one(i, j) {
                continue;
            }
            let [sphere, other] = [i, j].map(|i| i as usize);
            let distance = position[sphere] - position[other] - scene.cell.shift(image);
            let gap = distance.norm() - radius[sphere] - radius[other];
            let ratio = -gap / radius[sphere].min(radius[other]);
            if ratio > tolerance {
                found.pairs.push(Overlap {
                    sphere,
                    other,
                    ratio,
                });
            }
        }
        let start = |b: &Boundary| b.motion.pose_at(0.0);
        let poses: Vec<Pose> = scene.boundaries.iter().map(start).collect();
        let mut closest_points = Vec::new();
        for i in (0..radius.len()).filter(present) {
            for (b, boundary) in scene.boundaries.iter().enumerate() {
                closest_points.clear();
                let (sphere, place) = ((position[i], radius[i]), (&scene.cell, &poses[b]));
                boundary.closest_points(place, sphere, 0.0, &mut closest_points);
                let deepest = closest_points
                    .iter()
                    .map(|t| -t.gap / radius[i])
                    .fold(0.0, f64::max);
                if deepest > tolerance {
                    found.boundaries.push(Overlap {
                        sphere: i,
                        other: b,
                        ratio: deepest,
                    });
                }
            }
        }
        found
    }

    /// The largest overlap between spheres.
    pub(crate) fn worst_pair(&self) -> Option<&Overlap> {
        self.pairs.iter().max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }

    /// The largest overlap with a boundary.
    pub(crate) fn worst_boundary(&self) -> Option<&Overlap> {
        self.boundaries
            .iter()
            .max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }

    /// Refuses overlaps above `max_initial_overlap`, warns of smaller ones.
    pub(super) fn judge(
        &self,
        document: &mut Document<'_>,
        scene: &Scene,
        ranges: &[Option<Range<usize>>],
        groups: &[Entry<file::Spheres>],
    ) {
        let allowed = scene.settings.max_initial_overlap;
        let group_of = |i: usize| {
            ranges
                .iter()
                .position(|r| r.as_ref().is_some_and(|r| r.contains(&i)))
        };
        let call = |i: usize| {
            let place = scene.initial.position[i];
            let name = group_of(i)
                .and_then(|g| Some((groups[g].name.as_ref()?, ranges[g].as_ref()?.start)));
            let name = name.map_or(format!("sphere {i}"), |(name, start)| {
                format!("`{name}[{}]`", i - start)
            });
            format!("{name} at ({}, {}, {}) m", place.x, place.y, place.z)
        };
        let path = |i: usize| group_of(i).map_or("spheres".to_owned(), |g| groups[g].path.clone());
        let most = |n: usize| {
            if n == 1 {
                "1 overlap".to_owned()
            } else {
                format!("{n} overlaps")
            }
        };
        let judge = |document: &mut Document<'_>,
                     list: &[Overlap],
                     worst: &Overlap,
                     what: String,
                     help: &str| {
            let refused = match self.more {
                true => list.len(),
                false => list.iter().filter(|o| o.ratio > allowed).count(),
            };
            let measure = format!(
                "overlaps {what} by {} of the smaller radius",
                told_apart(worst.ratio, allowed)
            );
            let subject = call(worst.sphere);
            if refused > 0 {
                let message = format!(
                    "{subject} {measure}, expected at most max_initial_overlap = {allowed}; {}{} above it in all",
                    if self.more { "more than " } else { "" },
                    most(refused)
                );
                document.error(path(worst.sphere), message, help);
            } else {
                let message = format!(
                    "{subject} {measure}; {} in all are removed by displacement before t = 0",
                    most(list.len())
                );
                document.warn(path(worst.sphere), message, help);
            }
        };
        if let Some(worst) = self.worst_pair() {
            let help = "increase the spacing, or reduce the radius or the jitter";
            judge(document, &self.pairs, worst, call(worst.other), help);
        }
        if let Some(worst) = self.worst_boundary() {
            let what = format!("boundary `{}`", scene.boundaries[worst.other].name);
            let help =
                "move the spheres or the boundary; a plane is solid on the side its normal leaves";
            judge(document, &self.boundaries, worst, what, help);
        }
    }
}

/// A number with three digits, or as many as it takes to differ from `bound`.
fn told_apart(x: f64, bound: f64) -> String {
    let rounded = |digits: usize| format!("{x:.digits$e}").parse().unwrap_or(x);
    let shown = (2..16).map(rounded).find(|shown| *shown != bound);
    let shown = shown.unwrap_or(x);
    match shown < 1e-3 {
        true => format!("{shown:e}"),
        false => format!("{shown}"),
    }
}

#[cfg(test)]
mod tests {
    use super::told_apart;

    #[test]
    fn a_ratio_is_shown_apart_from_its_bound() {
        assert_eq!(told_apart(0.050_000_1, 0.05), "0.0500001");
        assert_eq!(told_apart(0.123_456, 0.05), "0.123");
        assert_eq!(told_apart(1.234_5e-5, 0.05), "1.23e-5");
    }
}
