//! The scenes of the settling passes: everything fixed, tolerances of the pass.

use crate::scene::gravity::GravityMotion;
use crate::scene::{Motion, Scene};
use crate::solver::Tolerance;

/// Tolerances of the first pass, and of those that bring the gaps to the scene's: the path to rest need not be
/// exact, and the forces at rest are solved anew.
pub(super) const COARSE: Tolerance = Tolerance {
    gap: 1e-3,
    slip: 1e-3,
    force: 1e-1,
};
pub(super) const FINE: Tolerance = Tolerance {
    gap: 0.0,
    slip: 1e-4,
    force: 1e-1,
};
/// Of the passes that start from the exact forces at rest: whatever a step leaves of slip adds up to creep, and a pile that
/// creeps never balances.
pub(super) const LOOSE: Tolerance = Tolerance {
    gap: 0.0,
    slip: 1e-6,
    force: 1e-2,
};

/// The scene with those driven bodies fixed that are held while spheres settle.
pub(super) fn still(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for boundary in &mut scene.boundaries {
        let held = matches!(&boundary.motion, Motion::Driven(body) if body.hold_while_settling);
        if held {
            hold(&mut boundary.motion);
        }
    }
    scene
}

/// The scene with gravity, boundaries and targets of springs held as at t = 0, without sources and sinks, and with tolerances no
/// finer than `least`.
pub(super) fn held(scene: &Scene, least: Tolerance) -> Scene {
    let mut scene = scene.clone();
    let settings = &mut scene.settings;
    settings.gravity = settings.gravity_motion.at(settings.gravity, 0.0);
    settings.gravity_motion = GravityMotion::Fixed;
    let boundaries = scene.boundaries.iter_mut();
    let motions = boundaries.map(|boundary| &mut boundary.motion);
    let targets = scene.springs.iter_mut().map(|spring| &mut spring.motion);
    for motion in motions.chain(targets) {
        if !matches!(motion, Motion::Driven(_)) {
            hold(motion);
        }
    }
    let tolerance = &mut scene.settings.tolerance;
    tolerance.gap = tolerance.gap.max(least.gap);
    tolerance.slip = tolerance.slip.max(least.slip);
    tolerance.force = tolerance.force.max(least.force);
    scene.sources.clear();
    scene.sinks.clear();
    scene
}

/// Stays as it is at t = 0.
fn hold(motion: &mut Motion) {
    let pose = motion.pose_at(0.0);
    *motion = Motion::Table {
        time: vec![0.0],
        translation: vec![pose.translation],
        rotation: vec![pose.rotation.scaled_axis()],
    };
}
