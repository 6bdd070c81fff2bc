//! Spheres squeezed between boundaries whose motion is prescribed, one or a chain of them, have no rigid solution.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::error::StepError;
use sphere_dda::scene::{Motion, Scene};
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::SolverKind;
use sphere_dda::spatial::Twist;

use crate::support::{Case, G, close};

const RADIUS: f64 = 0.1;
const SPEED: f64 = 0.01;

/// A sphere on the floor under a lid that comes down from 1 mm above it.
fn press(stiffness: Option<f64>, solver: SolverKind) -> Case {
    let mut case = Case::new(1e-2, 0.3, 0.0)
        .settings(|s| s.solver = solver)
        .floor()
        .plane(Vec3::new(0.0, 0.0, 2.0 * RADIUS + 1e-3), -Vec3::z())
        .sphere(RADIUS, Vec3::new(0.0, 0.0, RADIUS), Vec3::zeros());
    let lid = &mut case.scene.boundaries[1];
    lid.stiffness = stiffness;
    lid.motion = Motion::Constant(Twist {
        linear: Vec3::new(0.0, 0.0, -SPEED),
        angular: Vec3::zeros(),
    });
    case
}

/// Without a stiffness the run stops, names sphere and boundaries, and keeps the state of the last step.
#[test]
fn a_rigid_press_is_named() {
    for solver in [
        SolverKind::Auto,
        SolverKind::Direct,
        SolverKind::GaussSeidel,
    ] {
        let mut simulation =
            Simulation::new(Arc::new(press(None, solver).scene)).expect("the case starts");
        let error = loop {
            if let Err(error) = simulation.advance(1e-2) {
                break error;
            }
            assert!(simulation.time() < 0.2, "the lid went through the sphere");
        };
        let StepError::Pinched {
            time,
            sphere,
            boundaries,
        } = &error
        else {
            panic!("{solver:?}: {error}");
        };
        assert!((0.08..0.13).contains(time), "{time}");
        assert_eq!(*sphere, 0);
        assert!(
            boundaries.contains("wall0") && boundaries.contains("wall1"),
            "{boundaries}"
        );
        assert!(error.to_string().contains("stiffness"), "{error}");
    }
}

/// With a contact stiffness k on the lid its force is `k` times the compression: `k (v t - 1 mm)`, the floor's that
/// plus the weight.
#[test]
fn a_compliant_lid_presses_with_its_stiffness() {
    let stiffness = 1e5;
    for solver in [
        SolverKind::Auto,
        SolverKind::Direct,
        SolverKind::GaussSeidel,
    ] {
        let mut run = press(Some(stiffness), solver)
            .tolerance(1e-9, 1e-9, 1e-9)
            .start();
        run.steps(50);
        let pressed = stiffness * (SPEED * run.simulation.time() - 1e-3);
        close(run.force_on_boundary(1).z, pressed, 1e-6, 0.0);
        close(
            -run.force_on_boundary(0).z,
            pressed + run.mass(0) * G,
            1e-6,
            0.0,
        );
    }
}

/// Taken as it is, the step says which sphere gives way, and between what.
#[test]
fn a_sphere_that_gives_way_is_named() {
    let case = press(None, SolverKind::Auto).settings(|s| s.strict = false);
    let mut simulation = Simulation::new(Arc::new(case.scene)).expect("the case starts");
    let free = simulation.advance(0.05).expect("free so far");
    assert_eq!((free.squeezed, free.unconverged_steps), (None, 0));
    let pressed = simulation.advance(0.1).expect("it gives way");
    assert!(pressed.unconverged_steps > 0);
    let found = pressed.squeezed.expect("squeezed");
    assert_eq!((found.sphere, found.boundaries), (0, [0, 1]));
    let advice = found.advice(simulation.scene());
    assert!(advice.contains("`wall0` and `wall1`"), "{advice}");
}

/// Steps of a scene's defaults are cut until lid and floor hardly approach each other in one: the squeeze is still what is told, and
/// that there are no others, at any speed.
#[test]
fn a_press_is_named_however_short_the_last_step() {
    for speed in [0.1, 0.03, 0.07, 0.13, 0.17, 0.23, 0.29, 0.37] {
        let text = format!(
            "[simulation]\nduration = 1.0\nstrict = true\n[[material]]\nname = 'glass'\ndensity = 2500.0\n\
             [[spheres]]\nname = 'ball'\nmaterial = 'glass'\nradius = 0.05\npositions = [[0.0, 0.0, 0.05]]\n\
             [[boundary]]\nname = 'floor'\nmaterial = 'glass'\nfaces = [{{ plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }} }}]\n\
             [[boundary]]\nname = 'lid'\nmaterial = 'glass'\nmotion = {{ constant = {{ velocity = [0, 0, -{speed}] }} }}\n\
             faces = [{{ plane = {{ point = [0, 0, 0.12], normal = [0, 0, -1] }} }}]\n"
        );
        let loaded = Scene::from_toml("press", &text, Path::new(".")).expect("a good scene");
        let mut simulation = Simulation::new(Arc::new(loaded.scene)).expect("it starts");
        let ran = (0..100).try_for_each(|_| simulation.advance(1e-2).map(drop));
        let error = ran
            .expect_err("the lid went through the sphere")
            .to_string();
        assert!(
            error.contains("sphere 0 is squeezed between `floor` and `lid`;"),
            "{speed} m/s: {error}"
        );
    }
}

/// Fault: a gate whose edge comes down on a sphere beside its top ended with "reduce simulation.step to 3e-17 s", naming neither
/// what squeezes nor `stiffness`: a part of the step failed otherwise than the whole.
#[test]
fn a_gate_that_squeezes_by_its_edge_is_named() {
    let text = "[simulation]\nduration = 3.5\nstrict = true\n[[material]]\nname = 'rock'\ndensity = 2700.0\nfriction = 0.6\n\
                restitution = 0.2\n[[spheres]]\nname = 's'\nmaterial = 'rock'\nradius = 0.25\npositions = [[0, 0, 0.25]]\n\
                [[boundary]]\nname = 'floor'\nmaterial = 'rock'\nfaces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]\n\
                [[boundary]]\nname = 'gate'\nmaterial = 'rock'\nmotion = { constant = { velocity = [0, 0, -0.3] } }\n\
                faces = [{ rectangle = { corner = [-0.5, 0.02, 0.6], u = [1, 0, 0], v = [0, 0, 1] } }]\n";
    let loaded = Scene::from_toml("gate", text, Path::new(".")).expect("a good scene");
    let mut simulation = Simulation::new(Arc::new(loaded.scene)).expect("it starts");
    let ran = (0..350).try_for_each(|_| simulation.advance(1e-2).map(drop));
    let error = ran.expect_err("the gate went through").to_string();
    for part in [
        "sphere 0 is squeezed between",
        "`floor`",
        "`gate`",
        "`stiffness`",
    ] {
        assert!(error.contains(part), "{error}");
    }
}

/// Two spheres between floor and lid, their centres on a line 15 degrees off the vertical: the lines of force are half of that off all
/// normals, within the cone of friction, so that the chain neither rolls nor slides.
fn jam() -> Case {
    let tilt = 15.0_f64.to_radians();
    let mut case = Case::new(1e-2, 0.6, 0.0)
        .floor()
        .plane(Vec3::z() * (2.0 * RADIUS * (1.0 + tilt.cos())), -Vec3::z())
        .sphere(RADIUS, Vec3::z() * RADIUS, Vec3::zeros())
        .sphere(
            RADIUS,
            Vec3::z() * RADIUS + Vec3::new(tilt.sin(), 0.0, tilt.cos()) * (2.0 * RADIUS),
            Vec3::zeros(),
        );
    case.scene.boundaries[1].motion = Motion::Constant(Twist {
        linear: Vec3::new(0.0, 0.0, -SPEED),
        angular: Vec3::zeros(),
    });
    case
}

/// Both ends of the chain give way: the lid goes down by `v t`, half of it at each, and carries `k v t/2 - m g` with
/// `k = 1e5 m g/R`; the floor two weights more. Known once, the jam costs few sweeps. In steps shorter than the longest the force is that
/// of an overlap that grows for another step at most.
#[test]
fn a_jammed_chain_gives_way_at_its_ends() {
    for (h, exact) in [(1e-2, 0.01), (2.5e-3, 0.02)] {
        let mut run = jam().settings(|s| s.strict = false).start();
        let (count, mut sweeps) = ((0.5_f64 / h).round() as usize, 0);
        for k in 1..=count {
            let report = run.simulation.advance(h).expect("it gives way");
            let found = report.squeezed.expect("squeezed");
            assert!(
                found.by_others && found.boundaries.contains(&0) && found.boundaries.contains(&1)
            );
            assert!(report.unconverged_steps > 0);
            if k > count / 5 {
                sweeps += report.sweeps;
            }
        }
        let advice = run.simulation.report().squeezed.expect("squeezed");
        let advice = advice.advice(run.simulation.scene());
        assert!(advice.contains("(with other spheres)"), "{advice}");
        let most = 4 * count as u64 / 5 * 300;
        assert!(sweeps < most, "{sweeps} of {most} sweeps");
        let weight = run.mass(0) * G;
        let pressed = 1e5 * weight / RADIUS * (0.5 * SPEED * run.simulation.time()) - weight;
        close(run.force_on_boundary(1).z, pressed, exact, 0.0);
        close(
            -run.force_on_boundary(0).z,
            pressed + 2.0 * weight,
            exact,
            0.0,
        );
        let sideways = pressed * 7.5_f64.to_radians().tan();
        close(run.force_on_boundary(1).x.abs(), sideways, 0.02, 0.0);
    }
}

/// With `strict = true` the run ends, and names the boundaries.
#[test]
fn a_jammed_chain_is_named() {
    let mut simulation = Simulation::new(Arc::new(jam().scene)).expect("it starts");
    let ran = (0..10).try_for_each(|_| simulation.advance(1e-2).map(drop));
    let error = ran.expect_err("the lid went through").to_string();
    for part in [
        "is squeezed between",
        "`wall0`",
        "`wall1`",
        "(with other spheres)",
    ] {
        assert!(error.contains(part), "{error}");
    }
}

/// A sphere that falls meets floor and lid in one step, and the lid comes after it faster. Of contacts that give way, impacts which a step
/// does not resolve are rigid: both together have no answer. They are springs then, and each carries its compression.
#[test]
fn two_impacts_that_leave_no_room_are_springs() {
    let (stiffness, dt, fall) = (1e6, 1e-2, 1.0);
    let mut case = Case::new(dt, 0.0, 0.5)
        .without_gravity()
        .floor()
        .plane(Vec3::new(0.0, 0.0, 2.0 * RADIUS + 2e-3), -Vec3::z())
        .sphere(
            RADIUS,
            Vec3::new(0.0, 0.0, RADIUS + 1e-3),
            Vec3::z() * -fall,
        );
    for wall in &mut case.scene.boundaries {
        wall.stiffness = Some(stiffness);
    }
    case.scene.boundaries[1].motion = Motion::Constant(Twist {
        linear: Vec3::z() * -2.0 * fall,
        angular: Vec3::zeros(),
    });
    let mut run = case.start();
    run.steps(1);
    let contacts = run.simulation.contacts();
    assert_eq!(contacts.len(), 2);
    let closed: f64 = contacts.iter().map(|contact| -contact.gap).sum();
    close(closed, 2.0 * fall * dt - 2e-3, 1e-9, 1.0);
    for contact in &contacts {
        close(
            contact.force.norm(),
            stiffness * -contact.gap,
            1e-3,
            stiffness * closed,
        );
    }
}
