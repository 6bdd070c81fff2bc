//! Row 1: free fall, projectile, spin.

use sphere_dda::Vec3;
use sphere_dda::integrator::Integrator;

use crate::support::{Case, G, close};

/// `x = x0 + v0 t + g t^2/2` and constant spin at every node, both integrators, also when the step changes.
///
/// Constant acceleration over the step is exact for `shi`; for `moreau` the half-step velocity is
/// `v(t + dt/2)`, so `x' = x + dt v(t + dt/2)` is exact as well.
#[test]
fn projectile_with_spin() {
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        let (x0, v0) = (Vec3::new(1.0, -2.0, 50.0), Vec3::new(3.0, 1.0, 4.0));
        let spin = Vec3::new(1.0, 2.0, -5.0);
        let mut run = Case::new(1e-2, 0.3, 0.0)
            .settings(|s| s.integrator = integrator)
            .body(0.3, x0, v0, spin, Default::default())
            .start();
        for (k, h) in [0.01, 0.02, 0.005, 0.037, 0.01, 0.1]
            .into_iter()
            .cycle()
            .take(60)
            .enumerate()
        {
            run.advance(h);
            let t = run.simulation.time();
            let x = x0 + v0 * t - Vec3::z() * (0.5 * G * t * t);
            let v = v0 - Vec3::z() * (G * t);
            for axis in 0..3 {
                close(run.position(0)[axis], x[axis], 1e-12, 50.0);
                close(run.velocity(0)[axis], v[axis], 1e-12, 10.0);
                close(run.spin(0)[axis], spin[axis], 1e-12, 1.0);
            }
            assert!(k < 60);
        }
        // Rotation by the exact exponential: angle |w| t about a fixed axis.
        let turned = run.simulation.kinematics().orientation[0];
        let expected = nalgebra::UnitQuaternion::from_scaled_axis(spin * run.simulation.time());
        assert!(turned.angle_to(&expected) < 1e-12);
    }
}
