//! Fault 3. Symptom: of a ball that rolls in a hollow faster than `v^2/L = 4 g` every step counts as an impact: velocities are
//! reported with a radial part of first order, the persisting force of the boundary is zero. Cause: `contact_row` takes the
//! rate at which the normal turns from the slip of the surfaces, which vanishes in rolling, where the velocity of the centre
//! turns it.

use sphere_dda::Vec3;

use crate::support::Case;

/// `v . n = 0` to second order in the step, and the force of the drum is one that persists: `m v^2/L`.
#[test]
fn rolling_round_a_hollow_is_no_string_of_impacts() {
    let (drum, r, v, dt) = (1.0, 0.1, 9.0, 1e-3);
    let length = drum - r;
    let case = Case::new(dt).gravity(Vec3::zeros()).contact(0.5, 0.5);
    let face = format!(
        "cylinder = {{ base = [0.0, -1.0, 0.0], axis = [0.0, 1.0, 0.0], radius = {drum:?}, height = 2.0 }}"
    );
    // The velocity of the material point that touches, v + w x (-R n) with n = z, is zero.
    let spin = Vec3::y() * (v / r);
    // A scale of acceleration in place of gravity's, far beneath v^2/L.
    let case = case
        .boundary(&face, "")
        .sphere(r, -Vec3::z() * length, Vec3::x() * v, spin);
    let mut run = case.start();
    for k in 0..300 {
        run.step();
        if k < 3 {
            continue;
        }
        let n = -run.position(0).normalize();
        let radial = run.velocity(0).dot(&n).abs();
        assert!(radial < 2e-3, "radial velocity {radial} m/s at step {k}");
        let persisting = run.simulation.state().smooth_wrenches[0].force.norm();
        let press = run.mass(0) * v * v / length;
        assert!(
            (persisting / press - 1.0).abs() < 0.02,
            "{persisting} of {press} N persist"
        );
    }
}

/// The same with gravity of 9.81 m/s^2 across the axis and the pure sliding that held before.
#[test]
fn sliding_round_a_hollow_is_no_string_of_impacts() {
    let (r, v) = (0.1, 9.0);
    let case = Case::new(1e-3).contact(0.0, 0.5);
    let face = "cylinder = { base = [0.0, -1.0, 0.0], axis = [0.0, 1.0, 0.0], radius = 1.0, height = 2.0 }";
    let mut run = case
        .boundary(face, "")
        .sphere(r, -Vec3::z() * 0.9, Vec3::x() * v, Vec3::zeros())
        .start();
    for k in 0..300 {
        run.step();
        if k < 3 {
            continue;
        }
        let n = -run.position(0).normalize();
        let radial = run.velocity(0).dot(&n).abs();
        assert!(radial < 2e-3, "radial velocity {radial} m/s");
    }
}

/// A ball that rolls round inside another hollow with gravity: `v^2 = v_0^2 - 10/7 g (z - z_0)`, as without impacts.
#[test]
fn rolling_round_a_loop_with_gravity_persists() {
    let (drum, r, v) = (1.0, 0.1, 9.0);
    let case = Case::new(5e-4).contact(1.0, 0.5);
    let face = format!(
        "cylinder = {{ base = [0.0, -1.0, 0.0], axis = [0.0, 1.0, 0.0], radius = {drum:?}, height = 2.0 }}"
    );
    let spin = Vec3::y() * (v / r);
    let mut run = case
        .boundary(&face, "")
        .sphere(r, -Vec3::z() * (drum - r), Vec3::x() * v, spin)
        .start();
    for k in 0..1200 {
        run.step();
        if k < 3 {
            continue;
        }
        let n = -run.position(0).normalize();
        let radial = run.velocity(0).dot(&n).abs();
        assert!(radial < 2e-3, "radial velocity {radial} m/s at step {k}");
    }
}
