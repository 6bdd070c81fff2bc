//! Fault 5. Symptom: on boundaries that turn, results are of first order: a ball on a turntable loses speed, one that rolls
//! round a vertical cylinder is off by its amplitude, a smooth drum does work. Cause: a step used the normal, the contact point
//! and the chord of the boundary's motion at its start, not at its middle.

use std::f64::consts::TAU;

use sphere_dda::Vec3;

use crate::support::{Case, order};

/// A ball that rolls on a turntable of rate W moves in circles at `2 W/7`: its speed stays. Relative loss after one period.
fn turntable(step: f64) -> f64 {
    let case = Case::new(step).contact(1.0, 0.0);
    let face = "plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }";
    let motion = format!("motion = {{ constant = {{ angular_velocity = [0.0, 0.0, {TAU:?}] }} }}");
    let spin = Vec3::new(11.41592653589793, 12.566370614359172, 0.0);
    let mut run = case
        .boundary(face, &motion)
        .sphere(0.01, Vec3::new(0.05, 0.02, 0.01), Vec3::y() * 0.2, spin)
        .start();
    run.until(3.5);
    (run.velocity(0).norm() / 0.2 - 1.0).abs()
}

#[test]
fn a_ball_keeps_its_speed_on_a_turntable() {
    let errors = [2e-3, 1e-3].map(turntable);
    assert!(errors[1] < 1e-3, "{errors:?}");
    assert!(errors[1] < 1e-7 || order(errors) > 1.8, "{errors:?}");
}

/// Rolling round inside a vertical cylinder at F: `z - z_0 = -5 g/(2 F^2) (1 - cos(sqrt(2/7) F t))`. Largest error over the
/// amplitude, and friction's loss over the kinetic energy.
fn golf(step: f64) -> [f64; 2] {
    let (rate, g) = (20.0, 9.81);
    let case = Case::new(step).contact(2.0, 0.0);
    let face = "cylinder = { base = [0.0, 0.0, 0.0], radius = 0.11, height = 1.0 }";
    let mut run = case
        .boundary(face, "")
        .sphere(
            0.01,
            Vec3::new(0.1, 0.0, 0.5),
            Vec3::y() * 2.0,
            -Vec3::z() * 200.0,
        )
        .start();
    let amplitude = 5.0 * g / (2.0 * rate * rate);
    let (kinetic, mut worst) = (run.energy().kinetic(), 0.0_f64);
    while run.simulation.time() < 1.0 {
        run.step();
        let phase = (2.0_f64 / 7.0).sqrt() * rate * run.simulation.time();
        let expected = 0.5 - amplitude * (1.0 - phase.cos());
        worst = worst.max((run.position(0).z - expected).abs() / amplitude);
    }
    [worst, run.simulation.work().friction.abs() / kinetic]
}

#[test]
fn a_ball_that_rolls_inside_a_vertical_cylinder_comes_back_up() {
    let [coarse, fine] = [1e-3, 5e-4].map(golf);
    assert!(fine[0] < 1e-2, "{coarse:?} {fine:?}");
    assert!(order([coarse[0], fine[0]]) > 1.8, "{coarse:?} {fine:?}");
    assert!(fine[1] < 1e-3, "friction takes {} of the energy", fine[1]);
}

/// A smooth drum that turns: the ball at its bottom rests, the drum does no work, and what carries load touches.
#[test]
fn a_smooth_drum_does_no_work_and_leaves_no_gap() {
    for dt in [2e-3, 1e-3] {
        let face = "cylinder = { base = [0.0, -0.05, 0.0], axis = [0.0, 1.0, 0.0], radius = 0.1, height = 0.1 }";
        let motion = "motion = { constant = { angular_velocity = [0.0, 5.0, 0.0] } }";
        let mut run = Case::new(dt)
            .boundary(face, motion)
            .sphere(0.01, -Vec3::z() * 0.09, Vec3::zeros(), Vec3::zeros())
            .start();
        let mut open = 0.0_f64;
        while run.simulation.time() < 0.5 {
            run.step();
            open = open.max(run.opening() / 0.01);
        }
        let weight = run.mass(0) * 9.81;
        // The work of friction 0.5 over the same way.
        let scale = 0.5 * weight * 0.5 * 0.5;
        let work = run.simulation.work().boundaries / scale;
        assert!(
            work.abs() < 1e-6,
            "dt = {dt}: work {work} of that of friction"
        );
        assert!(
            open < 1e-6,
            "dt = {dt}: a loaded contact is open by {open} R"
        );
    }
}

/// Work of a boundary is torque times angle: `- sum T . W h` over the communication steps, T the mean torque on it. Relative
/// difference after half a second of a ball that slips in a rough drum.
fn torque_work(step: f64) -> f64 {
    let rate = 5.0;
    let face = "cylinder = { base = [0.0, -0.05, 0.0], axis = [0.0, 1.0, 0.0], radius = 0.1, height = 0.1 }";
    let motion = format!("motion = {{ constant = {{ angular_velocity = [0.0, {rate:?}, 0.0] }} }}");
    let mut run = Case::new(step)
        .contact(0.3, 0.0)
        .boundary(face, &motion)
        .sphere(0.01, -Vec3::z() * 0.09, Vec3::zeros(), Vec3::zeros())
        .start();
    let mut through_torque = 0.0;
    while run.simulation.time() < 0.05 {
        run.step();
        through_torque -= run.simulation.mean_wrench(0).torque.y * rate * step;
    }
    let work = run.simulation.work().boundaries;
    (work / through_torque - 1.0).abs()
}

#[test]
fn work_of_a_drum_is_torque_times_angle() {
    let errors = [1e-3, 5e-4].map(torque_work);
    assert!(errors[1] < 1e-9 || order(errors) > 1.8, "{errors:?}");
    assert!(errors[1] < 1e-3, "{errors:?}");
}
