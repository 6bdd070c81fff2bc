//! Light spheres that heavy ones press.

use sphere_dda::Vec3;
use sphere_dda::solver::Registers;

use crate::support::{Case, G, close};

/// A sphere of a thousand times the mass hits one that lies on the floor. Contact by contact the light sphere would hand on its own
/// momentum in each sweep; solved with both of its contacts it hands on all, and all rest after one step, whose middle is half a step
/// after the start:
///
/// ```text
/// F dt = M v + (M + m) g dt/2                                on the floor
/// ```
#[test]
fn a_light_sphere_hands_on_what_a_heavy_one_brings() {
    let (step, speed) = (1e-3, 1.0);
    let mut case = Case::new(step, 0.5, 0.0)
        .tolerance(1e-6, 1e-6, 1e-4)
        .floor();
    for (radius, height, speed) in [(0.01, 0.01, 0.0), (0.1, 0.12, speed)] {
        let velocity = Vec3::new(0.0, 0.0, -speed);
        case = case.sphere(radius, Vec3::new(0.0, 0.0, height), velocity);
    }
    let mut run = case.start();
    run.step();
    let [light, heavy] = [0, 1].map(|i| run.mass(i));
    let impulse = -step * run.simulation.mean_wrench(0).force.z;
    let weight = (light + heavy) * G;
    close(impulse, heavy * speed + weight * 0.5 * step, 1e-4, 0.0);
    let report = run.simulation.report();
    assert!(report.sweeps <= 100, "{} sweeps", report.sweeps);
    assert_eq!(report.factorizations, 0);
}

/// Positions of 1400 spheres, large ones that fell onto small ones, which several threads share; and the sweeps.
fn dropped(threads: usize, registers: Registers) -> (Vec<Vec3>, u64) {
    let mut case = Case::new(1e-3, 0.4, 0.0)
        .settings(|s| (s.threads, s.registers) = (threads, registers))
        .tolerance(1e-4, 7e-4, 1e-1)
        .floor();
    for k in 0..1400_u32 {
        let [i, j, layer] = [k % 14, k / 14 % 10, k / 140].map(f64::from);
        let radius = if k % 3 == 0 { 0.1 } else { 0.03 };
        let off = 0.02 * (1.7 * f64::from(k)).sin();
        let place = Vec3::new(0.21 * i + off, 0.21 * j - off, 0.11 + 0.21 * layer);
        case = case.sphere(radius, place, Vec3::new(0.0, 0.0, -2.0));
    }
    let mut run = case.start();
    let mut sweeps = 0;
    for _ in 0..150 {
        run.step();
        sweeps += run.simulation.report().sweeps;
    }
    ((0..1400).map(|i| run.position(i)).collect(), sweeps)
}

#[test]
fn light_spheres_have_the_same_bits_on_any_threads_and_registers() {
    let one = dropped(1, Registers::Widest);
    assert!(one.1 <= 2400, "{} sweeps", one.1);
    assert_eq!(dropped(2, Registers::Widest), one);
    if Registers::Avx2.exist() {
        assert_eq!(dropped(1, Registers::Avx2), one);
    }
}
