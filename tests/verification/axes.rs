//! Scalars of boundaries that move along a slide or about a hinge.

use sphere_dda::Vec3;
use sphere_dda::geometry::Facets;
use sphere_dda::geometry::Shape;
use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::{quantities, values};
use sphere_dda::scene::body::{Joint, Spring};
use sphere_dda::scene::{InputKind, Motion};

use crate::support::{Case, G, Run, body, close};

const RADIUS: f64 = 0.1;
const STEP: f64 = 1e-3;

/// A tray of one square metre about the origin.
fn tray() -> Vec<Shape> {
    let corner = Vec3::new(-0.5, -0.5, 0.0);
    vec![
        Facets::rectangle(corner, Vec3::x(), Vec3::y())
            .expect("a tray")
            .into(),
    ]
}

/// The quantity of the only boundary.
fn read(run: &Run, field: &str) -> Option<f64> {
    let observation = Observation::of(&run.simulation);
    let mut first = 0;
    for quantity in quantities(observation.scene) {
        if quantity.boundary == Some(0) && quantity.field == field {
            return Some(values(&observation)[first]);
        }
        first += quantity.count();
    }
    None
}

/// A ball at rest `a` from the axis: its weight along a slide that points down, `m g a` about a hinge along y.
#[test]
fn a_ball_at_rest_loads_the_axis_with_its_weight() {
    let at = Vec3::new(0.3, 0.0, RADIUS);
    let loaded = |motion| {
        let case = Case::new(STEP, 0.5, 0.0).moving(tray(), motion);
        let mut run = case.sphere(RADIUS, at, Vec3::zeros()).start();
        run.steps(5);
        run
    };
    let (down, across) = (-Vec3::z(), Vec3::y());
    for kind in [
        InputKind::Slide { axis: down },
        InputKind::SlideSpeed { axis: down },
    ] {
        let run = loaded(Motion::Input(kind));
        let force = read(&run, "slideForce").expect("a force");
        close(force, run.mass(0) * G, 1e-6, 0.0);
        assert_eq!(read(&run, "hingeTorque"), None);
    }
    for kind in [
        InputKind::Hinge { axis: across },
        InputKind::HingeSpeed { axis: across },
    ] {
        let run = loaded(Motion::Input(kind));
        let torque = read(&run, "hingeTorque").expect("a torque");
        close(torque, run.mass(0) * G * at.x, 1e-6, 0.0);
        assert_eq!(read(&run, "slideForce"), None);
    }
    let run = loaded(Motion::Input(InputKind::Pose));
    assert_eq!(read(&run, "slideForce"), None);
    assert_eq!(read(&run, "hingeTorque"), None);
}

/// A tray that falls along its slide with a ball on it: `g t`, `g t^2/2`, and nothing on the tray.
#[test]
fn a_falling_tray_has_the_speed_of_its_slide() {
    let joint = Joint::Slide { axis: -Vec3::z() };
    let case = Case::new(STEP, 0.5, 0.0)
        .driven(tray(), body(2.0, Vec3::zeros(), Vec3::repeat(1.0), joint));
    let above = Vec3::z() * RADIUS;
    let mut run = case.sphere(RADIUS, above, Vec3::zeros()).start();
    for _ in 0..50 {
        run.step();
        let t = run.simulation.time();
        close(read(&run, "jointSpeed").expect("a speed"), G * t, 1e-9, 0.0);
        let travel = read(&run, "jointTravel").expect("a travel");
        close(travel, 0.5 * G * t * t, 1e-9, 0.0);
        let force = read(&run, "slideForce").expect("a force");
        assert!(force.abs() < 1e-6 * run.mass(0) * G, "{force:e} N");
        assert_eq!(read(&run, "jointForce"), None);
    }
}

/// A wheel that a torsion spring turns: angle `A (1 - cos w t)`, speed `A w sin w t`, torque `k A cos w t`.
#[test]
fn a_wheel_on_a_spring_has_the_speed_of_its_hinge() {
    let (stiffness, moment, rest) = (40.0, 0.2, 0.8);
    let joint = Joint::Hinge { axis: -Vec3::y() };
    let mut wheel = body(2.0, Vec3::zeros(), Vec3::repeat(moment), joint);
    wheel.spring = Some(Spring { stiffness, rest });
    let mut run = Case::new(STEP, 0.5, 0.0)
        .without_gravity()
        .driven(tray(), wheel)
        .sphere(RADIUS, Vec3::z() * 9.0, Vec3::zeros())
        .start();
    let rate = f64::sqrt(stiffness / moment);
    for _ in 0..200 {
        run.step();
        let phase = rate * run.simulation.time();
        let error = 3.0 * STEP * rate;
        let angle = read(&run, "jointAngle").expect("an angle");
        close(angle, rest * (1.0 - phase.cos()), error, rest);
        let speed = read(&run, "jointSpeed").expect("a speed");
        close(speed, rest * rate * phase.sin(), error, rest * rate);
        let torque = read(&run, "jointTorque").expect("a torque");
        let most = stiffness * rest;
        close(torque, most * phase.cos(), error, most);
    }
}
