//! Bits by vector registers: those of AVX2 are those of the widest, plain ones are their own and within the tolerance.

use sphere_dda::Vec3;
use sphere_dda::solver::Registers;

use crate::support::Case;

/// Positions of spheres that fell on a floor and each other, each step within the tolerance.
fn heap(registers: Registers) -> Vec<Vec3> {
    let mut case = Case::new(1e-3, 0.4, 0.1)
        .settings(|s| s.registers = registers)
        .tolerance(1e-6, 1e-6, 1e-4)
        .floor();
    for k in 0..24_u32 {
        let (i, layer) = (f64::from(k % 4), f64::from(k / 4));
        let odd = Vec3::new(0.013 * layer, 0.017 * i, 0.0);
        case = case.sphere(
            0.1,
            Vec3::new(0.21 * i, 0.0, 0.11 + 0.22 * layer) + odd,
            Vec3::zeros(),
        );
    }
    let mut run = case.start();
    run.steps(300);
    (0..24).map(|i| run.position(i)).collect()
}

#[test]
fn registers_decide_the_bits() {
    let widest = heap(Registers::Widest);
    let plain = heap(Registers::Plain);
    if Registers::Avx2.exist() {
        assert_eq!(heap(Registers::Avx2), widest);
        assert_ne!(plain, widest, "the key chooses nothing");
    }
    assert_eq!(heap(Registers::Plain), plain);
}
