//! Light spheres that heavy ones press.

use sphere_dda::Vec3;
use sphere_dda::solver::Registers;

use crate::support::{Case, G, close};

/// A sphere of a thousand times the mass on one that lies on the floor, forces unknown at the start. All come to rest in one step:
///
/// ```text
/// N = (M + m) g                                  on the floor
/// ```
///
/// Contact by contact the light sphere would hand on its own momentum in each sweep.
#[test]
fn a_light_sphere_carries_a_heavy_one() {
    let mut case = Case::new(1e-3, 0.5, 0.0)
        .tolerance(1e-6, 1e-6, 1e-4)
        .floor();
    for (radius, height) in [(0.01, 0.01), (0.1, 0.12)] {
        case = case.sphere(radius, Vec3::new(0.0, 0.0, height), Vec3::zeros());
    }
    let mut run = case.start();
    run.step();
    let weight = (run.mass(0) + run.mass(1)) * G;
    close(-run.force_on_boundary(0).z, weight, 1e-3, 0.0);
    let report = run.simulation.report();
    assert!(report.sweeps <= 16, "{} sweeps", report.sweeps);
    assert_eq!(report.factorizations, 0);
}

/// Where large spheres fell onto small ones: 1400, so that several threads share them.
fn dropped(threads: usize, registers: Registers) -> Vec<Vec3> {
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
    run.steps(60);
    (0..1400).map(|i| run.position(i)).collect()
}

#[test]
fn light_spheres_have_the_same_bits_on_any_threads_and_registers() {
    let one = dropped(1, Registers::Widest);
    assert_eq!(dropped(2, Registers::Widest), one);
    if Registers::Avx2.exist() {
        assert_eq!(dropped(1, Registers::Avx2), one);
    }
}
