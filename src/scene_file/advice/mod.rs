//! Advice about a scene that can run but probably not as meant: lengths in mm, spheres that start on the wrong side of
//! a boundary, grains that their weight crushes, bonds that join nothing, keys that do nothing, a step far too long.
//!
//! Pure: a [`Scene`] and the file it was built from give a list; [`super::build`] adds it to the warnings.

mod bonds;
mod lengths;
mod placement;
mod softness;
mod unused;
mod walls;

use std::ops::Range;

use super::Summary;
use super::decode::SceneFile;
use super::diagnostic::Advice;
use crate::scene::Scene;

/// Internal steps longer than this many times the suggested one are warned of.
const LONG_STEP: f64 = 20.0;
/// The suggested step is that for a gap tolerance of at least this \[-\]: a tighter one asks for shorter steps to be cheap,
/// not to be right.
const COARSE_GAP: f64 = 1e-4;

/// All advice about a scene. `ranges` are the spheres of each group of the file, then of each source.
pub(super) fn advise(
    scene: &Scene,
    file: &SceneFile,
    ranges: &[Option<Range<usize>>],
) -> Vec<Advice> {
    let mut advice = unused::advise(scene, file);
    let gap = scene.settings.tolerance.gap.max(COARSE_GAP);
    let suggested = Summary::step_for(scene, gap);
    // Steps that are chosen are never long.
    if scene.settings.smallest_step.is_none() {
        advice.extend(long_step(scene.settings.step, suggested));
    }
    advice.extend(bonds::advise(scene, file));
    advice.extend(lengths::advise(scene));
    advice.extend(placement::advise(scene, file, ranges));
    advice.extend(softness::advise(scene, file));
    advice.extend(walls::advise(scene));
    advice
}

/// A step \[s\] far above the suggested one.
fn long_step(step: f64, suggested: f64) -> Option<Advice> {
    (step > LONG_STEP * suggested).then(|| {
        let times = step / suggested;
        Advice::warning(
            "simulation.step",
            format!(
                "step = {step} s is {times:.0} times longer than the suggested {suggested:.1e} s: spheres may move \
                 more than their radius in one step"
            ),
            format!("use step = {suggested:.1e}, or a few times that"),
        )
    })
}

#[cfg(test)]
mod tests {
    use super::{LONG_STEP, long_step};

    #[test]
    fn a_step_is_long_above_its_bound_only() {
        assert!(long_step(LONG_STEP * 1e-4, 1e-4).is_none());
        let advice = long_step(0.2, 7.1e-5).unwrap();
        assert_eq!(advice.path, "simulation.step");
        assert!(
            advice
                .message
                .contains("2817 times longer than the suggested 7.1e-5 s")
        );
    }
}
