//! Row 17, statics: constrained points and point loads.

use sphere_dda::Vec3;
use sphere_dda::motion::Motion;
use sphere_dda::scene::{PointLoad, SolverKind, Spring};

use crate::support::{Case, G, close};

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
