//! Boundaries that keep what they feel on triangles too large for a map.

use std::f64::consts::PI;

use crate::scene::Scene;
use crate::scene_file::diagnostic::Advice;

/// Mean area of the triangles from which on it is no map, in sections of the largest sphere.
const COARSE: f64 = 20.0;

pub(super) fn advise(scene: &Scene) -> Vec<Advice> {
    let largest = scene.particles.largest_radius();
    let section = PI * largest * largest;
    let walls = scene.boundaries.iter().enumerate();
    let coarse = walls.filter(|(_, boundary)| boundary.wall_fields && section > 0.0);
    let advice = coarse.filter_map(|(k, boundary)| {
        let count = boundary.geometry.triangles();
        let mean = boundary.geometry.areas().sum::<f64>() / count as f64;
        (mean > COARSE * section).then(|| {
            Advice::warning(
                format!("boundary[{k}].wall_fields"),
                format!(
                    "`{}` has {count} triangles of {mean:.2e} m2 on average, {:.0} sections of the largest sphere: each \
                     keeps one mean of all that touches it",
                    boundary.name,
                    mean / section
                ),
                format!(
                    "for a map, give the shape as an `stl` of triangles with sides of {:.1e} m or so; sums over the \
                     boundary are right as it is",
                    2.0 * largest
                ),
            )
            .harmless()
        })
    });
    advice.collect()
}
