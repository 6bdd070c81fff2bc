//! Row 17: constrained points and point loads, at rest and swinging.

use sphere_dda::Vec3;
use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Motion;
use sphere_dda::scene::{PointLoad, Spring};
use sphere_dda::solver::SolverKind;

use crate::support::{Case, G, close, order};

/// A sphere hung on a constrained spring of stiffness `P_c` and pulled by `f` comes to rest `(m g + f)/P_c` below
/// the target: the spring is implicit (backward Euler), so it damps the oscillation itself.
#[test]
fn a_spring_stretches_by_the_load() {
    let (stiffness, pull) = (5e3, 7.0);
    for solver in [SolverKind::Auto, SolverKind::Direct] {
        let mut case = Case::new(2e-2, 0.0, 0.0)
            .settings(|s| s.solver = solver)
            .tolerance(1e-9, 1e-9, 1e-9)
            .sphere(0.05, Vec3::new(0.0, 0.0, 1.0), Vec3::zeros());
        case.scene.springs.push(Spring {
            sphere: 0,
            arm: Vec3::zeros(),
            stiffness,
            target: Vec3::new(0.0, 0.0, 1.0),
            motion: Motion::Fixed,
        });
        case.scene.loads.push(PointLoad {
            sphere: 0,
            arm: Vec3::zeros(),
            force: Vec3::new(0.0, 0.0, -pull),
        });
        let mut run = case.start();
        run.steps(1500);
        let stretch = (run.mass(0) * G + pull) / stiffness;
        close(1.0 - run.position(0).z, stretch, 1e-6, 0.0);
        close(
            run.simulation.state().springs[0].z,
            run.mass(0) * G + pull,
            1e-6,
            0.0,
        );
    }
}

/// A load at an arm turns the sphere: `dw/dt = (arm x f)/I`.
#[test]
fn a_load_beside_the_centre_turns_the_sphere() {
    let mut case =
        Case::new(1e-4, 0.0, 0.0)
            .without_gravity()
            .sphere(0.1, Vec3::zeros(), Vec3::zeros());
    let (arm, force) = (Vec3::new(0.1, 0.0, 0.0), Vec3::new(0.0, 1e-3, 0.0));
    case.scene.loads.push(PointLoad {
        sphere: 0,
        arm,
        force,
    });
    let mut run = case.start();
    run.steps(100);
    let inertia = run.simulation.scene().particles.inertia(0);
    let t = run.simulation.time();
    // The arm turns with the sphere by less than 1e-5 rad here.
    close(run.spin(0).z, arm.x * force.y / inertia * t, 1e-6, 0.0);
    close(run.velocity(0).y, force.y / run.mass(0) * t, 1e-6, 0.0);
}

/// Row 17, free oscillation. The spring acts at the end of the step; with `a = w dt`, `w^2 = P_c/m` a step is linear in
/// (x, dt v) and its determinant is the square of the factor r on the amplitude:
///
/// ```text
/// moreau  (1 + a^2) v1 = v - a^2 x/dt,       x' = x + dt v1                       det = 1/(1 + a^2)
/// shi     (2 + a^2) D  = 2 dt v - a^2 x,     x' = x + D,  v' = 2 D/dt - v         det = 1/(1 + a^2/2)
/// ```
/// so `x' = tr x - det x_before`, and over a period the amplitude falls by `1 - r^(T/dt)`, about `pi a` (`moreau`) or
/// `pi a/2` (`shi`): of first order in dt.
#[test]
fn a_free_oscillation_decays_in_first_order() {
    let stiffness = 5e3;
    for (integrator, share) in [(Integrator::Moreau, 1.0), (Integrator::Shi, 0.5)] {
        let decay = |dt: f64| {
            let mut case = Case::new(dt, 0.0, 0.0)
                .without_gravity()
                .settings(|s| s.integrator = integrator)
                .tolerance(1e-12, 1e-12, 1e-12)
                .sphere(0.05, Vec3::new(0.03, 0.0, 0.0), Vec3::zeros());
            case.scene.springs.push(Spring {
                sphere: 0,
                arm: Vec3::zeros(),
                stiffness,
                target: Vec3::zeros(),
                motion: Motion::Fixed,
            });
            let mut run = case.start();
            let a = (stiffness / run.mass(0)).sqrt() * dt;
            let det = 1.0 / (1.0 + share * a * a);
            // x_k^2 - x_(k-1) x_(k+1) = (amplitude r^k sin)^2 for any x = amplitude r^k cos(k phi + phase).
            let mut x = vec![run.position(0).x];
            for _ in 0..40 {
                run.step();
                x.push(run.position(0).x);
            }
            let square = |k: usize| x[k] * x[k] - x[k - 1] * x[k + 1];
            let factor = (square(38) / square(2)).powf(1.0 / 72.0);
            close(factor, det.sqrt(), 1e-9, 0.0);
            let period = std::f64::consts::TAU / a;
            1.0 - factor.powf(period)
        };
        let (coarse, fine) = (decay(2e-4), decay(1e-4));
        let slope = order(coarse, fine, 2.0);
        assert!(
            (slope - 1.0).abs() < 0.05,
            "{integrator:?}: order {slope}, {coarse} {fine}"
        );
    }
}
