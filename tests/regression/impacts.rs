//! Fault 6. Symptom: impacts at once make energy without friction: a ball caught between one that meets it and one it parts
//! from: 4/3 at e = 1. Cause: every contact of a step rebounds by Newton's law against its own approach, also where an impulse
//! that comes from another contact closes a pair that was parting or at rest: the mean velocity that makes the work negative is
//! no longer common.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use sphere_dda::Vec3;
use sphere_dda::random::symmetric;

use crate::support::{Case, Run};

const R: f64 = 0.02;

/// Kinetic energy after over before of balls in a line at `x` with `v`.
fn ratio(e: f64, balls: &[(f64, f64)], steps: usize) -> f64 {
    let mut case = Case::new(1e-3).gravity(Vec3::zeros()).contact(0.0, e);
    for (x, v) in balls {
        case = case.sphere(R, Vec3::x() * *x, Vec3::x() * *v, Vec3::zeros());
    }
    let mut run = case.start();
    let before = run.energy().kinetic();
    run.steps(steps);
    run.energy().kinetic() / before
}

/// B at rest touches A, which leaves it at 1 m/s and meets C at -1 m/s: at most all energy is left.
#[test]
fn a_ball_caught_by_one_it_leaves_makes_no_energy() {
    for e in [1.0, 0.9, 0.5, 0.0] {
        let found = ratio(e, &[(0.0, 0.0), (0.04, 1.0), (0.0805, -1.0)], 100);
        assert!(found < 1.0 + 1e-9, "e = {e}: {found}");
    }
}

/// The same with 0.5 mm between A and B.
#[test]
fn a_gap_within_the_step_makes_no_energy() {
    for e in [1.0, 0.9, 0.5] {
        let found = ratio(e, &[(0.0, 0.0), (0.0405, 1.0), (0.0810, -1.0)], 100);
        assert!(found < 1.0 + 1e-9, "e = {e}: {found}");
    }
}

/// Kinetic energy \[J\] after the impulses of a step. Reported velocities are half a step of the last forces further on.
fn kinetic(run: &Run) -> f64 {
    let (motion, particles) = (
        run.simulation.kinematics(),
        &run.simulation.scene().particles,
    );
    let of = |i| particles.kinetic_energy(i, &motion.velocity[i], &motion.spin[i]);
    (0..particles.len()).map(of).sum()
}

/// Largest ratio of the kinetic energy after a step to that before it, of clusters of balls that fly at random.
fn clusters(friction: f64) -> (f64, f64) {
    let mut worst = (0.0, 0.0);
    for seed in 0..24 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut number = || symmetric(&mut rng);
        for e in [0.0, 0.5, 0.9, 1.0] {
            let mut case = Case::new(1e-3)
                .tolerance(1e-8)
                .gravity(Vec3::zeros())
                .contact(friction, e);
            for k in 0..12_u32 {
                let cell = Vec3::from([k % 2, k / 2 % 2, k / 4].map(f64::from));
                let off = Vec3::new(number(), number(), number()) * (0.02 * R);
                let v = Vec3::new(number(), number(), number()) - (cell - Vec3::repeat(0.7)) * 0.8;
                case = case.sphere(R, cell * (2.05 * R) + off, v, Vec3::zeros());
            }
            let mut run = case.start();
            let (start, mut before) = (run.energy().kinetic(), kinetic(&run));
            for _ in 0..40 {
                run.step();
                let now = kinetic(&run);
                if now / before > worst.0 {
                    worst = (now / before, e);
                }
                before = now;
            }
            let end = run.energy().kinetic() / start;
            worst = if end > worst.0 { (end, e) } else { worst };
        }
    }
    worst
}

#[test]
fn smooth_clusters_make_no_energy() {
    let (ratio, e) = clusters(0.0);
    assert!(ratio < 1.0 + 1e-6, "{ratio} at e = {e}");
}

#[test]
fn rough_clusters_make_no_energy() {
    let (ratio, e) = clusters(0.4);
    assert!(ratio < 1.0 + 1e-6, "{ratio} at e = {e}");
}
