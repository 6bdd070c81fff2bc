//! Energies and momenta against closed forms.

use sphere_dda::Vec3;
use sphere_dda::geometry::region::Primitive;
use sphere_dda::observe::energy::{Energy, Momentum};
use sphere_dda::results::history::{columns, row};
use sphere_dda::scene::Motion;
use sphere_dda::scene::{PointLoad, Sink, Source, Spring, Supply};
use sphere_dda::spatial::Twist;

use crate::made::{Made, scene};

/// Twist of every sphere in the made states.
const V: Vec3 = Vec3::new(0.1, 0.2, 0.3);

#[test]
fn kinetic_energy_uses_the_reported_velocity() {
    let scene = scene(1);
    let mut made = Made::new(&scene, 0.0);
    made.kinematics.velocity[0] = Vec3::repeat(0.5);
    made.persisting[0].linear -= Vec3::repeat(0.5);
    let energy = Energy::of(&made.observe(&scene, 0.0));
    // A ball of density 2500 kg/m^3 and radius 0.1 m at |v|^2 = 0.14 m^2/s^2, w = 1 rad/s.
    let mass = 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-3;
    assert!((energy.translational - 0.5 * mass * 0.14).abs() < 1e-14);
    assert!((energy.rotational - 0.5 * (0.4 * mass * 0.01)).abs() < 1e-14);
    assert_eq!(energy.kinetic(), energy.translational + energy.rotational);
}

#[test]
fn potential_energy_of_gravity_springs_and_loads() {
    let mut scene = scene(1);
    let mass = scene.particles.mass[0];
    scene.springs.push(Spring {
        sphere: 0,
        arm: Vec3::new(0.1, 0.0, 0.0),
        stiffness: 200.0,
        target: Vec3::new(0.1, 0.0, 1.6),
        motion: Motion::Fixed,
    });
    scene.loads.push(PointLoad {
        sphere: 0,
        arm: Vec3::zeros(),
        force: Vec3::new(0.0, 0.0, 5.0),
    });
    let mut made = Made::new(&scene, 0.0);
    made.kinematics.position[0] = Vec3::new(0.0, 0.0, 2.0);
    let energy = Energy::of(&made.observe(&scene, 0.0));
    assert!((energy.gravity - mass * 9.81 * 2.0).abs() < 1e-12);
    assert!((energy.springs - 0.5 * 200.0 * 0.4 * 0.4).abs() < 1e-12);
    assert!((energy.loads + 10.0).abs() < 1e-12);
    // A quarter turn about z carries the point of the spring from x to y.
    made.kinematics.orientation[0] =
        nalgebra::UnitQuaternion::from_scaled_axis(Vec3::z() * std::f64::consts::FRAC_PI_2);
    let turned = Energy::of(&made.observe(&scene, 0.0));
    assert!((turned.springs - 100.0 * (0.16 + 0.02)).abs() < 1e-12);
}

#[test]
fn momentum_uses_the_half_step_velocity() {
    let scene = scene(2);
    let mut made = Made::new(&scene, 0.0);
    let (m, r) = (&scene.particles.mass, &scene.particles.radius);
    made.kinematics.position = vec![Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 2.0, 0.0)];
    made.kinematics.velocity = vec![Vec3::new(0.0, 3.0, 0.0), Vec3::new(0.0, 0.0, 4.0)];
    made.kinematics.spin = vec![Vec3::new(0.0, 0.0, 5.0), Vec3::zeros()];
    let momentum = Momentum::of(&made.observe(&scene, 0.0));
    assert_eq!(momentum.linear, Vec3::new(0.0, 3.0 * m[0], 4.0 * m[1]));
    let inertia = 0.4 * m[0] * r[0] * r[0];
    let angular = Vec3::new(8.0 * m[1], 0.0, 3.0 * m[0] + 5.0 * inertia);
    assert!((momentum.angular - angular).norm() < 1e-13);
}

fn anywhere() -> Primitive {
    Primitive::Box {
        min: Vec3::zeros(),
        max: Vec3::repeat(1.0),
    }
}

#[test]
fn the_history_has_one_value_per_column() {
    let mut scene = scene(4);
    scene.sources.push(Source {
        name: "chute".to_owned(),
        spheres: 3..4,
        region: anywhere().into(),
        supply: Supply::Spheres(1.0),
        start: 0.0,
        stop: 1.0,
        twist: Twist::default(),
        seed: 1,
    });
    scene.sinks.push(Sink {
        name: "drain".to_owned(),
        region: anywhere().into(),
        recycle: None,
    });
    let mut made = Made::new(&scene, 0.5);
    made.passed[1] = 7.0;
    (made.emitted[0], made.removed[0]) = (3.0, 1.5);
    // It waits in the source, and counts nowhere.
    made.kinematics.present[3] = false;
    let names = columns(&scene);
    let values = row(&made.observe(&scene, 0.5));
    assert_eq!(names.len(), values.len());
    let value = |name: &str| values[names.iter().position(|n| n == name).unwrap()];
    assert_eq!(value("time [s]"), 0.5);
    assert_eq!(
        value("sensor.hold.mass [kg]"),
        0.0,
        "no centre in the box: y is beyond it"
    );
    assert_eq!(value("sensor.outflow.mass [kg]"), 7.0);
    assert_eq!(value("contactCount [-]"), 3.0);
    // The overlaps are 1e-7 m; the smallest radius is 0.1 m.
    assert!((value("maxOverlap [-]") - 1e-6).abs() < 1e-18);
    assert_eq!(value("source.chute.mass [kg]"), 3.0);
    assert_eq!(value("sink.drain.mass [kg]"), 1.5);
    let present: f64 = scene.particles.mass[..3].iter().sum();
    assert_eq!(value("mass [kg]"), present);
    assert_eq!(value("sphereCount [-]"), 3.0);
    // Speed |V|, 1 rad/s, I = 2/5 m R^2.
    let spin: f64 = (0..3).map(|i| 0.5 * scene.particles.inertia(i)).sum();
    let kinetic = 0.5 * present * V.norm_squared() + spin;
    assert!((value("kineticEnergy [J]") - kinetic).abs() < 1e-12);
    assert_eq!(value("boundary.floor.force[3] [N]"), -7.0);
    // Power: force (0, -0.5, -7) N at (0.1, 0.2, 0.3) m/s.
    assert!((value("boundary.floor.power [W]") + 2.2).abs() < 1e-12);
    assert_eq!(value("boundary.floor.position[1] [m]"), 0.5);
}
