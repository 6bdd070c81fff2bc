//! Nothing passes a wall or another sphere within a step, however far it moves in one.

use sphere_dda::Vec3;
use sphere_dda::error::StepError;
use sphere_dda::geometry::Facets;
use sphere_dda::scene::Motion;
use sphere_dda::spatial::Twist;

use crate::support::{Case, close};

const RADIUS: f64 = 0.1;
const DT: f64 = 1e-2;
/// Five radii in a step.
const FAST: f64 = 5.0 * RADIUS / DT;

/// A level square of side 4 without thickness, at height `z`.
fn sheet(z: f64) -> Facets {
    Facets::rectangle(Vec3::new(-2.0, -2.0, z), Vec3::x() * 4.0, Vec3::y() * 4.0).expect("a sheet")
}

fn at(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A bullet hits a sphere that lies on a thin sheet: the sphere, at rest before, would be three radii behind the sheet at the
/// end of the step. Straight down and obliquely, for all phases of the step.
#[test]
fn a_struck_sphere_stays_on_a_thin_sheet() {
    for degrees in [0.0f64, 30.0, 60.0] {
        for phase in 0..8 {
            for e in [0.0, 0.8] {
                let turn = degrees.to_radians();
                let from = at(turn.sin(), 0.0, turn.cos());
                let gap = f64::from(phase) / 8.0 * 5.0 * RADIUS;
                let mut run = Case::new(DT, 0.3, e)
                    .without_gravity()
                    .wall(vec![sheet(0.0).into()])
                    .sphere(RADIUS, at(0.0, 0.0, RADIUS), Vec3::zeros())
                    .sphere(
                        RADIUS,
                        at(0.0, 0.0, RADIUS) + from * (2.0 * RADIUS + gap),
                        from * -FAST,
                    )
                    .start();
                for _ in 0..20 {
                    run.step();
                    for k in 0..2 {
                        let x = run.position(k);
                        let over = x.x.abs() > 2.0 || x.z > 0.0;
                        assert!(
                            over,
                            "{degrees} degrees, phase {phase}, e {e}: sphere {k} at {x:?}"
                        );
                    }
                }
            }
        }
    }
}

/// A bullet against a sheet that comes to meet it, fifteen radii of relative motion in a step.
#[test]
fn a_moving_sheet_is_not_passed() {
    for phase in 0..16 {
        let start = 1.0 + f64::from(phase) / 16.0 * 1.5;
        let up = Motion::Constant(Twist {
            linear: Vec3::z() * (2.0 * FAST),
            angular: Vec3::zeros(),
        });
        let mut run = Case::new(DT, 0.0, 0.5)
            .without_gravity()
            .moving(vec![sheet(0.0).into()], up)
            .sphere(RADIUS, at(0.0, 0.0, start), Vec3::z() * -FAST)
            .start();
        for _ in 0..6 {
            run.step();
            let above = run.position(0).z - run.simulation.boundary_pose(0).translation.z;
            assert!(
                above >= RADIUS * (1.0 - 1e-6),
                "phase {phase}: {above} m above the sheet"
            );
        }
        // v' = wall + e (wall + speed).
        close(run.velocity(0).z, FAST * (2.0 + 0.5 * 3.0), 1e-9, 0.0);
    }
}

/// A cradle of five, struck at five radii a step, e = 1: none is skipped, and no momentum is lost. With gaps of more than a
/// step one after the other takes the whole speed; with less, impacts of one step share it (see `simultaneous`).
#[test]
fn a_fast_cradle_keeps_its_order() {
    for gap in [0.3, 1.7, 3.0, 4.9, 7.3] {
        let mut case = Case::new(DT, 0.2, 1.0)
            .without_gravity()
            .tolerance(1e-9, 1e-9, 1e-9);
        for k in 0..5 {
            let x = f64::from(k) * (2.0 + gap) * RADIUS;
            let speed = if k == 0 { FAST } else { 0.0 };
            case = case.sphere(RADIUS, at(x, 0.0, 0.0), Vec3::x() * speed);
        }
        let mut run = case.start();
        for _ in 0..40 {
            run.step();
            for k in 1..5 {
                let apart = run.position(k).x - run.position(k - 1).x;
                assert!(
                    apart > 1.9 * RADIUS,
                    "gap {gap} R: {k} is {apart} m behind its neighbour"
                );
            }
        }
        let speeds: f64 = (0..5).map(|k| run.velocity(k).x).sum();
        close(speeds, FAST, 1e-9, 0.0);
        if gap > 5.0 {
            close(run.velocity(4).x, FAST, 1e-9, 0.0);
        } else {
            assert!(
                run.velocity(4).x > 0.5 * FAST,
                "gap {gap} R: {}",
                run.velocity(4).x
            );
        }
    }
}

/// Two bullets that cross: those whose paths miss each other do not feel each other, those whose paths meet collide.
#[test]
fn crossing_bullets_meet_or_miss() {
    for (miss, meets) in [(0.0, true), (0.5, true), (2.5, false), (4.0, false)] {
        for phase in 0..8 {
            let back = 0.6 + 0.5 * f64::from(phase) / 8.0;
            let mut run = Case::new(DT, 0.2, 1.0)
                .without_gravity()
                .sphere(RADIUS, at(-back, 0.0, 0.0), Vec3::x() * FAST)
                .sphere(RADIUS, at(0.0, -back, miss * RADIUS), Vec3::y() * FAST)
                .start();
            for _ in 0..5 {
                run.step();
            }
            let changed = (run.velocity(0) - Vec3::x() * FAST).norm() / FAST;
            assert_eq!(
                changed > 1e-9,
                meets,
                "miss {miss} R, phase {phase}: {:?}",
                run.velocity(0)
            );
            let before = Vec3::x() + Vec3::y();
            let after = (run.velocity(0) + run.velocity(1)) / FAST;
            assert!((after - before).norm() < 1e-9);
        }
    }
}

/// Between two sheets 2.5 R apart a sphere is struck: it stays between them, and the bullet outside.
#[test]
fn a_sphere_between_two_sheets_stays() {
    for phase in 0..8 {
        let mut run = Case::new(DT, 0.0, 0.9)
            .without_gravity()
            .wall(vec![sheet(0.0).into()])
            .wall(vec![sheet(2.5 * RADIUS).into()])
            .sphere(RADIUS, at(0.0, 0.0, 1.2 * RADIUS), Vec3::z() * FAST)
            .sphere(
                RADIUS,
                at(0.0, 0.0, 4.0 * RADIUS + 0.5 * f64::from(phase) * RADIUS),
                Vec3::z() * -FAST,
            )
            .start();
        for _ in 0..30 {
            run.step();
            let z = run.position(0).z;
            assert!(z > 0.99 * RADIUS && z < 1.51 * RADIUS, "phase {phase}: {z}");
            assert!(run.position(1).z > 3.49 * RADIUS);
        }
    }
}

/// Past the edge of a sheet: what flies beside it is not touched by the plane it lies in; what flies over the border is.
#[test]
fn a_bullet_beside_a_sheet_flies_on() {
    for (x, meets) in [
        (2.0 + 1.5 * RADIUS, false),
        (2.0 + 0.5 * RADIUS, true),
        (1.0, true),
    ] {
        for phase in 0..8 {
            let z = RADIUS * (2.0 + 5.0 * f64::from(phase) / 8.0);
            let mut run = Case::new(DT, 0.0, 1.0)
                .without_gravity()
                .wall(vec![sheet(0.0).into()])
                .sphere(RADIUS, at(x, 0.0, z), Vec3::z() * -FAST)
                .start();
            run.steps(5);
            let changed = (run.velocity(0) + Vec3::z() * FAST).norm() / FAST > 1e-9;
            assert_eq!(
                changed,
                meets,
                "at {x}, phase {phase}: {:?}",
                run.velocity(0)
            );
        }
    }
}

/// Likewise where the sheet flies and the sphere rests.
#[test]
fn a_sheet_that_flies_past_a_sphere_leaves_it() {
    for (x, meets) in [(2.0 + 1.5 * RADIUS, false), (2.0 + 0.5 * RADIUS, true)] {
        for phase in 0..8 {
            let z = RADIUS * (2.0 + 5.0 * f64::from(phase) / 8.0);
            let up = Motion::Constant(Twist {
                linear: Vec3::z() * FAST,
                angular: Vec3::zeros(),
            });
            let mut run = Case::new(DT, 0.0, 1.0)
                .without_gravity()
                .moving(vec![sheet(0.0).into()], up)
                .sphere(RADIUS, at(x, 0.0, z), Vec3::zeros())
                .start();
            run.steps(5);
            let changed = run.velocity(0).norm() / FAST > 1e-9;
            assert_eq!(
                changed,
                meets,
                "at {x}, phase {phase}: {:?}",
                run.velocity(0)
            );
        }
    }
}

/// Where a step may not be cut, the error names the pair and the step that would do.
#[test]
fn what_would_pass_is_named() {
    let mut run = Case::new(DT, 0.0, 1.0)
        .without_gravity()
        .settings(|s| s.max_cuts = 0)
        .sphere(RADIUS, at(-0.55, 0.0, 0.0), Vec3::x() * FAST)
        .sphere(RADIUS, at(0.0, -0.55, 0.25), Vec3::y() * FAST)
        .start();
    let before = run.simulation.snapshot();
    let error = run
        .simulation
        .advance(DT)
        .expect_err("their linear gaps meet, their ways do not");
    let message = error.to_string();
    assert!(message.contains("spheres 0 and 1"), "{message}");
    let StepError::TooFast {
        motion, advised, ..
    } = error
    else {
        panic!("{message}");
    };
    // Five radii along x against five along y; half a radius takes a fourteenth of the step.
    close(motion, 50f64.sqrt(), 1e-6, 0.0);
    close(advised, DT * 0.5 / 50f64.sqrt(), 1e-6, 0.0);
    assert!(
        run.simulation.snapshot() == before,
        "the state is that before the step"
    );
}
