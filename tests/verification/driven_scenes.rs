//! Driven bodies as scenes: what is refused and why, and what settling does to them.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::scene::Scene;
use sphere_dda::scene::body::{Area, Body, Joint};
use sphere_dda::scene::{InputKind, Motion};
use sphere_dda::scene_file::SceneError;
use sphere_dda::simulation::{Settle, Settled, Simulation};

use crate::support::{G, close};

const PISTON: &str = r#"
[simulation]
duration = 1.0
step = 1e-3
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
[[material]]
name = "glass"
density = 2500.0
[[spheres]]
name = "grains"
material = "glass"
radius = [0.1]
positions = [[0.0, 0.0, 0.12]]
[[boundary]]
name = "floor"
material = "glass"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
[[boundary]]
name = "piston"
material = "glass"
faces = [{ plane = { point = [0.0, 0.0, 0.3], normal = [0.0, 0.0, -1.0] } }]
point_of_action = [0.0, 0.0, 0.3]
input = "load"
[boundary.body]
mass = 2.0
joint = { slide = [0.0, 0.0, 2.0] }
inertia = [[2.0, 0.5, 0.0], [0.5, 2.0, 0.0], [0.0, 0.0, 3.0]]
servo = { pressure = -100.0, area = 0.1 }
damping = 5.0
velocity = [0.0, 0.0, 0.1]
"#;

fn load(text: &str) -> Result<Scene, SceneError> {
    Scene::from_toml("piston.toml", text, Path::new(".")).map(|loaded| loaded.scene)
}

fn body(scene: &Scene) -> &Body {
    match &scene.boundaries[1].motion {
        Motion::Driven(body) => body,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_piston_means_what_it_says() {
    let scene = load(PISTON).unwrap_or_else(|e| panic!("{}", e.plain()));
    let body = body(&scene);
    assert_eq!(body.joint, Joint::Slide { axis: Vec3::z() });
    assert_eq!(body.centre.z, 0.3);
    // Eigenvalues 1.5 along (1, -1, 0), 2.5 along (1, 1, 0) and 3 along z.
    for (axis, moment) in [
        (Vec3::new(1.0, -1.0, 0.0), 1.5),
        (Vec3::new(1.0, 1.0, 0.0), 2.5),
        (Vec3::z(), 3.0),
    ] {
        close(
            body.moment_about(axis.normalize(), body.centre),
            moment,
            1e-14,
            0.0,
        );
    }
    assert_eq!(
        body.servo.as_ref().expect("a servo").area,
        Area::Constant(0.1)
    );
    assert!(matches!(
        scene.boundaries[1].motion.input(),
        Some(InputKind::SlideForce { .. })
    ));
    let between = PISTON.replace(
        "area = 0.1",
        "between = [[\"floor\", \"piston\"], [\"piston\", \"floor\"]]",
    );
    let scene = load(&between).unwrap_or_else(|e| panic!("{}", e.plain()));
    let area = &self::body(&scene).servo.as_ref().expect("a servo").area;
    assert_eq!(*area, Area::Between([[0, 1], [1, 0]]));
}

#[test]
fn bad_bodies_are_refused_where_they_are_wrong() {
    let at = |key: &str| format!("boundary[1].body.{key}");
    let free = ("joint = { slide = [0.0, 0.0, 2.0] }", "");
    let hinge = (
        "joint = { slide = [0.0, 0.0, 2.0] }",
        "joint = { hinge = [0, 1, 0] }",
    );
    let servo = ("servo = { pressure = -100.0, area = 0.1 }", "");
    let tensor = "inertia = [[2.0, 0.5, 0.0], [0.5, 2.0, 0.0], [0.0, 0.0, 3.0]]";
    let still = ("velocity = [0.0, 0.0, 0.1]", "");
    for (changes, path, message) in [
        (
            &[("mass = 2.0", "mass = 0")][..],
            at("mass"),
            "a mass > 0 [kg]",
        ),
        (
            &[("damping = 5.0", "damping = -1")],
            at("damping"),
            "damping >= 0",
        ),
        (
            &[("[0.0, 0.0, 2.0]", "[0, 0, 0]")],
            at("joint.slide"),
            "length > 0",
        ),
        (
            &[(tensor, "inertia = [1, 2]")],
            at("inertia"),
            "three rows of three",
        ),
        (
            &[("[2.0, 0.5, 0.0]", "[2.0, 0.4, 0.0]")],
            at("inertia"),
            "symmetric",
        ),
        (
            &[(tensor, "inertia = [1, 1, 3]")],
            at("inertia"),
            "sum of the others",
        ),
        (
            &[free, servo, (tensor, "")],
            at("inertia"),
            "for a free body",
        ),
        (
            &[hinge, servo, still, (tensor, "")],
            at("inertia"),
            "about the hinge",
        ),
        (&[free], at("servo"), "joint = { slide = axis }"),
        (
            &[("area = 0.1", "area = 0")],
            at("servo.area"),
            "an area > 0",
        ),
        (&[(", area = 0.1", "")], at("servo"), "`area` and `between`"),
        (
            &[("area = 0.1", "between = [[\"floor\"]]")],
            at("servo.between"),
            "two pairs",
        ),
        (
            &[(
                "area = 0.1",
                "between = [[\"floor\", \"piston\"], [\"flor\", \"piston\"]]",
            )],
            at("servo.between[1][0]"),
            "did you mean `floor`",
        ),
        (
            &[("[0.0, 0.0, 0.1]", "[0.1, 0.0, 0.1]")],
            at("velocity"),
            "along the slide",
        ),
        (
            &[("damping =", "angular_velocity = [0, 0, 1]\ndamping =")],
            at("angular_velocity"),
            "does not turn",
        ),
        (&[hinge, servo], at("velocity"), "a hinge stays"),
        (
            &[("input = \"load\"", "input = \"pose\"")],
            "boundary[1].body".into(),
            "what prescribes",
        ),
        (
            &[(
                "input = \"load\"",
                "motion = { constant = { velocity = [0, 0, 1] } }",
            )],
            "boundary[1].body".into(),
            "what prescribes",
        ),
        (
            &[("name = \"floor\"\n", "name = \"floor\"\ninput = \"load\"\n")],
            "boundary[0].input".into(),
            "without `body`",
        ),
        (
            &[
                free,
                servo,
                ("mass = 2.0", "mass = 2.0\nlimits = { upper = 1 }"),
            ],
            at("limits"),
            "hinge = axis",
        ),
        (
            &[("mass = 2.0", "mass = 2.0\nlimits = {}")],
            at("limits"),
            "at least one",
        ),
        (
            &[(
                "mass = 2.0",
                "mass = 2.0\nlimits = { lower = 0.1, upper = 0.2 }",
            )],
            at("limits"),
            "lower <= 0 <= upper",
        ),
        (
            &[("mass = 2.0", "mass = 2.0\nspring = { stiffness = 0 }")],
            at("spring.stiffness"),
            "stiffness > 0",
        ),
        (
            &[
                free,
                servo,
                ("mass = 2.0", "mass = 2.0\nspring = { stiffness = 1 }"),
            ],
            at("spring"),
            "hinge = axis",
        ),
        (
            &[("mass = 2.0", "mass = 2.0\nweight = 3")],
            at("weight"),
            "unknown key",
        ),
    ] {
        let mut text = PISTON.to_owned();
        for (from, to) in changes {
            assert!(text.contains(from), "{from}");
            text = text.replacen(from, to, 1);
        }
        let error = load(&text).expect_err(message);
        let found = error.problems.iter().any(|p| {
            let said = format!("{} {}", p.message, p.help.clone().unwrap_or_default());
            p.path == path && said.contains(message)
        });
        assert!(found, "{path}: {message}\n{}", error.plain());
    }
}

#[test]
fn stops_and_springs_mean_what_they_say() {
    let held = PISTON.replace(
        "damping = 5.0",
        "damping = 5.0\nlimits = { lower = -0.2 }\nspring = { stiffness = 40, rest = 0.1 }",
    );
    let scene = load(&held).unwrap_or_else(|e| panic!("{}", e.plain()));
    let body = body(&scene);
    assert_eq!(body.limits, [Some(-0.2), None]);
    let spring = body.spring.expect("a spring");
    assert_eq!([spring.stiffness, spring.rest], [40.0, 0.1]);
}

/// Settling lets the piston down on the sphere, the sphere on the floor, and stops both: at t = 0 the floor carries all.
#[test]
fn a_piston_settles_with_the_spheres() {
    let mut scene = load(PISTON).unwrap_or_else(|e| panic!("{}", e.plain()));
    let settle = Settle {
        time: 3.0,
        until_rest: true,
    };
    let settled = Settled::new(&scene, settle, |_| ControlFlow::Continue(())).expect("it settles");
    assert!(settled.at_rest);
    scene.start_from(&settled.start).expect("its own start");
    let simulation = Simulation::new(Arc::new(scene)).expect("it starts");
    let sunk = simulation.boundary_pose(1).translation.z;
    assert!((sunk + 0.1).abs() < 1e-6, "{sunk}");
    assert_eq!(simulation.boundary_twist(1).linear, Vec3::zeros());
    let pressed = 2.0 * G + 10.0;
    close(simulation.wrench(1).force.z, pressed, 1e-6, 0.0);
    let weight = simulation.scene().particles.mass[0] * G;
    close(-simulation.wrench(0).force.z, pressed + weight, 1e-6, 0.0);
}
