//! Derivatives of a communication step by the commands held over it: closed forms, and central differences of the whole
//! simulation, which is put back, given another command and stepped again.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::error::StepError;
use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::{quantities, values};
use sphere_dda::scene::Command;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::{Direction, Simulation};

use crate::support::G;

const HEAD: &str = r#"
[simulation]
duration = 1.0
step = 1e-3
fixed_step = true
strict = true
[simulation.tolerance]
gap = 1e-12
slip = 1e-12
force = 1e-12
opening = 0
[[material]]
name = "glass"
density = 2500.0
friction = 0.3
"#;

const BALL: &str = r#"
[[spheres]]
name = "ball"
material = "glass"
radius = [0.1]
positions = [[0.0, 0.0, 0.1]]
[[probe]]
name = "ball"
sphere = "ball"
"#;

const FLOOR: &str = r#"
[[boundary]]
name = "floor"
material = "glass"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
"#;

fn simulation(parts: &[&str]) -> Simulation {
    let text = parts.concat();
    let loaded = Scene::from_toml("derivatives.toml", &text, Path::new("."));
    let scene = loaded.unwrap_or_else(|e| panic!("{}", e.plain())).scene;
    Simulation::new(Arc::new(scene)).unwrap()
}

/// What is measured, by name.
fn measured(simulation: &Simulation) -> BTreeMap<String, f64> {
    named(simulation, values(&Observation::of(simulation)))
}

fn named(simulation: &Simulation, values: Vec<f64>) -> BTreeMap<String, f64> {
    let all = quantities(simulation.scene());
    let names = all.iter().flat_map(|quantity| quantity.names());
    names.zip(values).collect()
}

fn derivative(simulation: &Simulation, boundary: usize, change: Command) -> BTreeMap<String, f64> {
    let direction = Direction { boundary, change };
    let mut columns = simulation.directional_derivatives(&[direction]).unwrap();
    named(simulation, columns.remove(0))
}

/// A direction of each kind.
fn velocity(axis: usize) -> Command {
    Command {
        velocity: Vec3::ith(axis, 1.0),
        ..Command::default()
    }
}

/// A ball on a floor that has told at a constant speed for a while. `h = 2 dt`, so the last wrench is that of the second step.
fn moving(friction: &str, speed: f64, steps: u32) -> Simulation {
    let head = HEAD.replace("friction = 0.3", friction);
    let mut simulation = simulation(&[&head, BALL, FLOOR, "input = \"twist\""]);
    let command = Command {
        velocity: Vec3::new(speed, 0.0, 0.0),
        ..Command::default()
    };
    simulation.command(0, command).unwrap();
    for _ in 0..steps {
        simulation.advance(2e-3).unwrap();
    }
    simulation
}

/// Slip: friction points along the slip, whose direction lasts, `F = mu m g v/|v|` for the floor's velocity `v`: across it
/// `dF_y/dv_y = mu m g/|v|`, along it 0; on the floor with the other sign. In two internal steps, the first from rest.
#[test]
fn friction_of_a_slipping_ball_turns_with_the_floor() {
    let (speed, h) = (2.0, 2e-3);
    let simulation = moving("friction = 0.3", speed, 1);
    let weight = simulation.scene().particles.mass[0] * G;
    let across = derivative(&simulation, 0, velocity(1));
    let along = derivative(&simulation, 0, velocity(0));
    let turned = -0.3 * weight / speed;
    for name in ["force", "averageForce"] {
        let of = |column: &BTreeMap<String, f64>, k| column[&format!("boundary.floor.{name}[{k}]")];
        assert!((of(&across, 2) - turned).abs() < 1e-9 * weight);
        for (column, k) in [
            (&across, 1),
            (&across, 3),
            (&along, 1),
            (&along, 2),
            (&along, 3),
        ] {
            assert!(of(column, k).abs() < 1e-9 * weight, "{name}[{k}]");
        }
    }
    // The ball goes where the friction pushes it; of the half step before the start the scheme knows no friction.
    let mass = weight / G;
    let y = along["probe.ball.position[1]"].abs();
    assert!(y < 1e-12, "{y}");
    let y = across["probe.ball.velocity[2]"];
    assert!((y + turned / mass * 1.25 * h).abs() < 1e-9, "{y}");
}

/// Stick: the ball rolls as the floor does, `dv = 2/7 dV`, `dw = 5/7 dV/R`, and the floor feels the impulse `2/7 m dV` over h.
#[test]
fn a_sticking_ball_takes_two_sevenths_of_the_floors_speed() {
    let (h, radius) = (2e-3, 0.1);
    let simulation = moving("friction = 0.9", 1e-3, 3);
    let mass = simulation.scene().particles.mass[0];
    let column = derivative(&simulation, 0, velocity(0));
    let share = 2.0 / 7.0;
    for (name, expected) in [
        ("probe.ball.velocity[1]", share),
        ("probe.ball.angularVelocity[2]", -(1.0 - share) / radius),
        ("boundary.floor.averageForce[1]", -share * mass / h),
        // All of it in the first internal step: the second finds the ball rolling.
        ("boundary.floor.force[1]", 0.0),
        ("boundary.floor.averageForce[3]", 0.0),
        ("boundary.floor.position[1]", h),
        ("probe.ball.position[1]", share * h),
    ] {
        let scale = if name.contains("orce") {
            mass / h
        } else {
            1.0 / radius
        };
        assert!(
            (column[name] - expected).abs() < 1e-9 * scale,
            "{name}: {}",
            column[name]
        );
    }
}

/// The keys of a change, as what is done to the command.
fn along(what: &str, axis: usize) -> Command {
    let v = Vec3::ith(axis, 1.0);
    let mut change = Command::default();
    match what {
        "translation" => change.translation = v,
        "rotation" => change.rotation = v,
        "velocity" => change.velocity = v,
        "angular_velocity" => change.angular_velocity = v,
        "force" => change.force = v,
        "torque" => change.torque = v,
        "surface" => change.surface_velocity = v,
        "scalar" => change.scalar = 1.0,
        other => panic!("{other}"),
    }
    change
}

/// A scene, how it is driven, and by how much its command is changed for the differences.
struct Case {
    name: &'static str,
    simulation: Simulation,
    boundary: usize,
    /// Command at communication step `k`.
    command: fn(u32) -> Command,
    steps: u32,
    h: f64,
    directions: &'static [(&'static str, usize)],
    /// Change for the differences, and a coarse one that shows their order.
    change: f64,
}

/// Which contacts are loaded, and whether they slip.
fn contacts(simulation: &Simulation) -> Vec<(sphere_dda::contact::ContactId, bool)> {
    let pair = simulation.scene().pairs.get(0, 0);
    let slips = |c: &sphere_dda::contact::Contact| {
        let normal = c.force.dot(&c.normal);
        (c.force - c.normal * normal).norm() > pair.friction * normal * (1.0 - 1e-6)
    };
    let contacts = simulation.contacts().into_iter();
    contacts.map(|c| (c.key, slips(&c))).collect()
}

fn quotient(
    low: &BTreeMap<String, f64>,
    high: &BTreeMap<String, f64>,
    size: f64,
) -> BTreeMap<String, f64> {
    let pairs = low.iter().zip(high.values());
    pairs
        .map(|((name, low), high)| (name.clone(), (high - low) / (2.0 * size)))
        .collect()
}

/// What a quantity is compared with: the largest component of its vector.
fn scale(column: &BTreeMap<String, f64>, name: &str) -> f64 {
    let stem = name.split('[').next().unwrap_or(name);
    let parts = column
        .iter()
        .filter(|(other, _)| other.split('[').next() == Some(stem));
    parts.map(|(_, value)| value.abs()).fold(0.0, f64::max)
}

impl Case {
    /// Runs to the step in question, and compares its derivatives with central differences: the worst errors for a coarse and a
    /// fine change, and how many quantities have told.
    fn compare(mut self) -> ([f64; 2], usize) {
        let mut before = Vec::new();
        for k in 0..self.steps {
            before = self.simulation.snapshot();
            self.simulation
                .command(self.boundary, (self.command)(k))
                .unwrap();
            self.simulation.advance(self.h).unwrap();
        }
        let reached = contacts(&self.simulation);
        let cut = self.simulation.report().cuts > 0;
        assert_eq!(cut, self.name == "cut", "{}", self.name);
        let mut worst = [0.0_f64; 2];
        let mut told = 0;
        let directions: Vec<Direction> = self
            .directions
            .iter()
            .map(|(what, axis)| Direction {
                boundary: self.boundary,
                change: along(what, *axis),
            })
            .collect();
        let columns = self
            .simulation
            .directional_derivatives(&directions)
            .unwrap();
        for ((direction, column), what) in directions.iter().zip(columns).zip(self.directions) {
            let what = format!("{} {}", what.0, what.1);
            let column = named(&self.simulation, column);
            for (error, share) in worst.iter_mut().zip([8.0, 1.0]) {
                let size = self.change * share;
                let [low, high] = [-size, size].map(|size| {
                    self.simulation.restore(&before).unwrap();
                    let command = (self.command)(self.steps - 1).plus(&direction.change, size);
                    self.simulation.command(self.boundary, command).unwrap();
                    self.simulation.advance(self.h).unwrap();
                    assert_eq!(
                        contacts(&self.simulation),
                        reached,
                        "{}: other contacts",
                        self.name
                    );
                    measured(&self.simulation)
                });
                let difference = quotient(&low, &high, size);
                for (name, derivative) in &column {
                    let judged = [
                        "boundary.",
                        "probe.",
                        "momentum",
                        "angularMomentum",
                        "kinetic",
                    ];
                    if !judged.iter().any(|start| name.starts_with(start)) || name.contains("max") {
                        continue;
                    }
                    let whole = scale(&column, name).max(scale(&difference, name));
                    // What the solver's tolerance and rounding leave of a difference: beneath that it tells nothing.
                    let rounding = 1e-10 * (scale(&low, name) + 1e-6) / size;
                    if rounding > 3e-6 * whole {
                        continue;
                    }
                    told += usize::from(share == 1.0);
                    let off = (difference[name] - derivative).abs() / whole;
                    if off > 1e-5 && share == 1.0 {
                        println!(
                            "  {off:.1e} {name} by {what}: {derivative:e} {:e}",
                            difference[name]
                        );
                    }
                    *error = error.max(off);
                }
            }
        }
        (worst, told)
    }
}

const TROUGH: &str = r#"
[[boundary]]
name = "trough"
material = "glass"
faces = [{ cylinder = { base = [0.0, -2.0, 0.5], axis = [0.0, 1.0, 0.0], radius = 0.5, height = 4.0 } }]
"#;
const LEDGE: &str = r#"
[[boundary]]
name = "ledge"
material = "glass"
faces = [{ box = { min = [-1.0, -1.0, -0.5], max = [-0.03, 1.0, 0.0046061010] } }]
"#;
const PLATE: &str = r#"
[[spheres]]
name = "balls"
material = "glass"
radius = [0.1, 0.1, 0.1]
positions = [[0.3, 0.0, 0.1], [-0.3, 0.25, 0.1], [-0.3, -0.25, 0.1]]
[[probe]]
name = "ball"
sphere = "balls[1]"
[[boundary]]
name = "plate"
material = "glass"
faces = [{ box = { min = [-0.6, -0.6, 0.2], max = [0.6, 0.6, 0.25] } }]
body = { mass = 30.0, centre = [0.05, 0.02, 0.225], inertia = [4.0, 5.0, 8.0] }
point_of_action = [0.0, 0.0, 0.25]
input = "load"
"#;
const HINGED: &str = r#"
[[boundary]]
name = "flap"
material = "glass"
faces = [{ box = { min = [-0.02, -0.3, 0.2], max = [0.6, 0.3, 0.25] } }]
body = { mass = 3.0, centre = [0.3, 0.0, 0.22], inertia = [0.2, 0.2, 0.2], joint = { hinge = [0.0, 1.0, 0.0] }, damping = 0.3 }
point_of_action = [-0.3, 0.0, 0.2]
input = "load"
"#;

/// Two spheres that cross in the seventh internal step: their gaps to first order meet, their ways do not, and the step is cut.
const BULLETS: &str = r#"
[[spheres]]
name = "first"
material = "glass"
radius = 0.01
positions = [[-0.355, 0.0, 1.0]]
velocity = [50.0, 0.0, 0.0]
[[spheres]]
name = "second"
material = "glass"
radius = 0.01
positions = [[0.0, -0.355, 1.025]]
velocity = [0.0, 50.0, 0.0]
"#;
/// From a point of the ball, which turns with it.
const TIE: &str = r#"
[[spring]]
sphere = "ball"
stiffness = 2000.0
point = [0.03, 0.02, 0.05]
target = [0.06, -0.02, 0.16]
"#;
/// Two balls that touch through the face of their cell.
const NEIGHBOURS: &str = r#"
[cell]
x = [0.0, 1.0]
y = [0.0, 0.6]
[[spheres]]
name = "ball"
material = "glass"
radius = 0.1
positions = [[0.03, 0.3, 0.1], [0.83, 0.32, 0.1]]
velocity = [-0.3, 0.0, 0.0]
[[probe]]
name = "ball"
sphere = "ball[1]"
"#;

fn held(_: u32) -> Command {
    Command::default()
}

fn slipping(_: u32) -> Command {
    Command {
        velocity: Vec3::new(0.7, 0.3, 0.0),
        angular_velocity: Vec3::new(0.0, 0.0, 0.9),
        ..Command::default()
    }
}

fn rolling(k: u32) -> Command {
    let t = f64::from(k + 1) * 5e-3;
    Command {
        translation: Vec3::new(2e-2 * t, 1e-2 * t, 3e-3 * t),
        rotation: Vec3::new(0.02 * t, -0.03 * t, 0.3 * t),
        ..Command::default()
    }
}

fn turning(_: u32) -> Command {
    Command {
        scalar: 0.7,
        ..Command::default()
    }
}

fn pushed(_: u32) -> Command {
    Command {
        force: Vec3::new(3.0, 2.0, -40.0),
        torque: Vec3::new(0.5, 0.3, 1.0),
        ..Command::default()
    }
}

fn fast_belt(_: u32) -> Command {
    Command {
        surface_velocity: Vec3::new(0.9, 0.2, 0.0),
        ..Command::default()
    }
}

fn feeding(k: u32) -> Command {
    let t = f64::from(k + 1) * 2e-3;
    Command {
        scalar: 1.5e-3 * (std::f64::consts::TAU * 18.0 * t).sin(),
        ..Command::default()
    }
}

fn cases() -> Vec<Case> {
    let twist = [HEAD, BALL, FLOOR, "input = \"twist\""].concat();
    let pose = [HEAD, BALL, FLOOR, "input = \"pose\""].concat();
    let fall = twist
        .replace("0.1]]", "0.104]]")
        .replace("0.3\n", "0.3\nrestitution = 0.6\n");
    let shi = pose.replace("step = 1e-3", "step = 1e-3\nintegrator = \"shi\"");
    let penalty = pose.replace(
        "step = 1e-3",
        "step = 1e-3\nmethod = \"penalty\"\npenalty = 1e6",
    );
    let resisting = twist.replace(
        "friction = 0.3",
        "friction = 0.3\nrolling_friction = 0.05\ntwisting_friction = 0.02",
    );
    let belt = [
        HEAD,
        BALL,
        FLOOR,
        "surface_input = true\nsurface_velocity = [0.0, 0.0, 0.0]",
    ]
    .concat();
    let turned = twist.replace(
        "step = 1e-3",
        "step = 1e-3\nrotating_frame = { axis = [0.0, 0.0, 1.0], speed = 3.0, point = [0.3, 0.1, 0.0] }",
    );
    let sprung = HINGED.replace(
        "damping = 0.3",
        "damping = 0.3, spring = { stiffness = 40.0, rest = 0.1 }, limits = { lower = -0.5, upper = 0.5 }",
    );
    let all: &[_] = &[
        ("velocity", 0),
        ("velocity", 1),
        ("velocity", 2),
        ("angular_velocity", 2),
    ];
    let places: &[_] = &[
        ("translation", 0),
        ("translation", 2),
        ("rotation", 0),
        ("rotation", 1),
        ("rotation", 2),
    ];
    let loads: &[_] = &[
        ("force", 0),
        ("force", 2),
        ("torque", 0),
        ("torque", 1),
        ("torque", 2),
    ];
    let case = |name, text: &[&str], command, steps, h, directions, change| Case {
        name,
        simulation: simulation(text),
        boundary: 0,
        command,
        steps,
        h,
        directions,
        change,
    };
    let feeder = include_str!("../../examples/feeder/feeder.toml");
    let tight = "[simulation]\nstep = 5e-4\nfixed_step = true\nstrict = true\ntolerance = { gap = 1e-11, slip = 1e-11, force = 1e-10, opening = 0 }";
    let feeder = feeder.replace("[simulation]", tight);
    vec![
        case("slip", &[&twist], slipping, 3, 5e-3, all, 1e-4),
        case("roll", &[&pose], rolling, 3, 5e-3, places, 1e-6),
        case("cut", &[&twist, BULLETS], slipping, 2, 5e-3, all, 1e-4),
        case("spring", &[&twist, TIE], slipping, 3, 5e-3, all, 1e-4),
        case("frame", &[&turned], slipping, 3, 5e-3, all, 1e-4),
        case(
            "cell",
            &[
                HEAD,
                NEIGHBOURS,
                FLOOR,
                "input = { slide_speed = [0.8, 0.3, 0.02] }",
            ],
            turning,
            3,
            5e-3,
            &[("scalar", 0)],
            1e-3,
        ),
        case("impact", &[&fall], held, 5, 6e-3, &all[..3], 1e-4),
        case("shi", &[&shi], rolling, 3, 5e-3, places, 1e-7),
        case("penalty", &[&penalty], rolling, 3, 5e-3, places, 1e-6),
        case("resistance", &[&resisting], slipping, 3, 5e-3, all, 1e-4),
        case(
            "belt",
            &[&belt],
            fast_belt,
            2,
            5e-3,
            &[("surface", 0), ("surface", 1)],
            1e-3,
        ),
        case(
            "trough",
            &[
                HEAD,
                BALL,
                TROUGH,
                "input = { hinge_speed = [0.0, 1.0, 0.0] }",
            ],
            turning,
            4,
            5e-3,
            &[("scalar", 0)],
            1e-3,
        ),
        case(
            "edge",
            &[
                HEAD,
                BALL,
                LEDGE,
                "input = \"pose\"",
                &FLOOR.replace("0.0, 0.0, 0.0]", "0.0, 0.0, -1.0]"),
            ],
            rolling,
            2,
            5e-3,
            places,
            1e-6,
        ),
        case("plate", &[HEAD, PLATE, FLOOR], pushed, 3, 5e-3, loads, 1e-2),
        case(
            "hinge",
            &[
                HEAD,
                &BALL.replace("0.0, 0.0, 0.1]]", "0.4, 0.0, 0.1]]"),
                HINGED,
                FLOOR,
            ],
            turning,
            3,
            5e-3,
            &[("scalar", 0)],
            1e-2,
        ),
        case(
            "sprung",
            &[
                HEAD,
                &BALL.replace("0.0, 0.0, 0.1]]", "0.4, 0.0, 0.1]]"),
                &sprung,
                FLOOR,
            ],
            turning,
            3,
            5e-3,
            &[("scalar", 0)],
            1e-2,
        ),
        case(
            "feeder",
            &[&feeder],
            feeding,
            20,
            2e-3,
            &[("scalar", 0)],
            1e-7,
        ),
        // Many impacts at once, one of them near the speed that makes it one.
        case(
            "landing",
            &[&feeder],
            feeding,
            40,
            2e-3,
            &[("scalar", 0)],
            2e-9,
        ),
    ]
}

/// Derivatives against central differences of the whole step, error of second order in the change.
#[test]
fn derivatives_are_central_differences() {
    let mut curved = 0;
    for case in cases() {
        let name = case.name;
        let ([coarse, fine], told) = case.compare();
        assert!(fine <= 1e-5, "{name}: {fine:e}");
        assert!(told >= 15, "{name}: {told} comparisons");
        // 64 times less for an eighth of the change.
        let second_order = coarse > 2e-6 && fine < coarse / 30.0;
        assert!(coarse < 1e-3, "{name}: {coarse:e} {fine:e}");
        curved += usize::from(second_order);
    }
    assert!(curved >= 4, "{curved} cases show the order");
}

/// At the start: forces at rest by where boundaries are placed and how driven ones are loaded, against another start.
#[test]
fn forces_at_rest_have_derivatives_too() {
    let (plate, tilted) = (
        [HEAD, PLATE, FLOOR].concat(),
        [HEAD, BALL, FLOOR, "input = \"pose\""].concat(),
    );
    let start = |text: &str, command| {
        let mut simulation = simulation(&[text]);
        simulation.command(0, command).unwrap();
        simulation.place().unwrap();
        simulation
    };
    let mut told = 0;
    for (text, what, axis, size) in [
        (&plate, "force", 0, 1.0),
        (&plate, "force", 2, 1.0),
        (&plate, "torque", 1, 0.1),
        (&tilted, "rotation", 0, 1e-6),
        (&tilted, "rotation", 1, 1e-6),
    ] {
        let change = along(what, axis);
        let here = start(text, Command::default());
        let column = derivative(&here, 0, change);
        let [low, high] = [-size, size].map(|size| {
            let simulation = start(text, Command::default().plus(&change, size));
            assert_eq!(contacts(&simulation), contacts(&here), "{what} {axis}");
            measured(&simulation)
        });
        let difference = quotient(&low, &high, size);
        for (name, derivative) in &column {
            let whole = scale(&column, name).max(scale(&difference, name));
            // Forces at rest are solved to 1e-8.
            let rounding = 1e-7 * (scale(&low, name) + 1e-6) / size;
            if !name.starts_with("boundary.") || rounding > 1e-4 * whole {
                continue;
            }
            told += 1;
            let off = (difference[name] - derivative).abs() / whole;
            assert!(
                off < 1e-3,
                "{what} {axis} {name}: {derivative} {}",
                difference[name]
            );
        }
    }
    assert!(told > 10, "{told} comparisons");
}

/// The margin falls to 0 where friction is just enough: `F = mu m g` at the floor's acceleration `a = 3.5 mu g`.
#[test]
fn the_margin_warns_of_a_kink() {
    let margin = |share: f64| {
        let mut simulation = simulation(&[HEAD, BALL, FLOOR, "input = \"twist\""]);
        // One internal step from rest: the impulse that makes the ball roll is 2/7 m V.
        let command = Command {
            velocity: Vec3::x() * (share * 3.5 * 0.3 * G * 1e-3),
            ..Command::default()
        };
        simulation.command(0, command).unwrap();
        simulation.advance(1e-3).unwrap();
        measured(&simulation)["solver.activeSetMargin"]
    };
    for (share, expected) in [(0.5, 0.5), (0.999, 1e-3), (1.001, 1e-3), (1.25, 0.25)] {
        let found = margin(share);
        assert!((found - expected).abs() < 1e-6, "{share}: {found}");
    }
}

/// Where commands or gravity change between internal steps, the derivative is by what was set last: of the averages over the whole step
/// too. Fault: gravity alone was not noticed, the derivative was by commands of the whole step, under the gravity that it began with.
#[test]
fn commands_that_change_within_a_step_count_from_there() {
    for (first, gravity) in [(0.0, 9.81), (0.4, 12.0)] {
        commands_count_from(first, gravity);
    }
}

/// The floor moves by `first` \[m/s\] faster until both that and gravity \[m/s^2\] change.
fn commands_count_from(first: f64, gravity: f64) {
    let text = [HEAD, BALL, FLOOR, "input = \"twist\""].concat();
    let run = |last: f64| {
        let mut simulation = simulation(&[&text]);
        let slow = Command {
            velocity: Vec3::new(0.5, 0.2, 0.01),
            ..Command::default()
        };
        let faster = |by: f64| slow.plus(&velocity(1), by);
        simulation.command(0, faster(first)).unwrap();
        let mut march = simulation.begin(5e-3).unwrap();
        for k in 0..5 {
            if k == 2 {
                simulation.command(0, faster(last)).unwrap();
                simulation.set_gravity(-Vec3::z() * gravity).unwrap();
            }
            simulation.internal_step(&mut march).unwrap();
        }
        simulation.end(march);
        simulation
    };
    let column = derivative(&run(0.4), 0, velocity(1));
    let [low, high] = [0.3999, 0.4001].map(|last| measured(&run(last)));
    for name in [
        "boundary.floor.averageForce[1]",
        "boundary.floor.averageForce[2]",
        "probe.ball.velocity[2]",
    ] {
        let difference = (high[name] - low[name]) / 2e-4;
        assert!(difference.abs() > 1e-4, "{name}");
        assert!(
            (difference - column[name]).abs() < 1e-6 * difference.abs().max(1.0),
            "{name}: {difference} {}",
            column[name]
        );
    }
}

/// A step that does not begin leaves the derivatives of the last; one that begins and is given up leaves none.
#[test]
fn a_step_given_up_has_no_derivatives() {
    let text = [HEAD, BALL, FLOOR, "input = \"twist\""].concat();
    let mut simulation = simulation(&[&text]);
    let directions = [Direction {
        boundary: 0,
        change: velocity(1),
    }];
    simulation.advance(5e-3).unwrap();
    let before = simulation.directional_derivatives(&directions).unwrap();
    let fast = Command::default().plus(&velocity(1), 1e6);
    simulation.command(0, fast).unwrap();
    let jump = simulation.begin(1e-2).unwrap_err();
    assert!(matches!(jump, StepError::Jump { .. }), "{jump}");
    assert_eq!(
        simulation.directional_derivatives(&directions).unwrap(),
        before
    );
    simulation.command(0, Command::default()).unwrap();
    drop(simulation.begin(1e-2).unwrap());
    let by_command = simulation.directional_derivatives(&directions).map(|_| ());
    for refused in [by_command, simulation.time_derivatives().map(|_| ())] {
        let error = refused.unwrap_err();
        assert!(error.to_string().contains("no whole step"), "{error}");
    }
    simulation.advance(5e-3).unwrap();
    simulation.directional_derivatives(&directions).unwrap();
}

/// Spheres that come within the step and land take part from there.
#[test]
fn spheres_that_come_within_the_step_take_part() {
    let source = r#"
[[source]]
name = "rain"
material = "glass"
radius = 0.02
capacity = 5
rate = 500.0
velocity = [0.0, 0.0, -1.0]
region = { box = { min = [1.0, 1.0, 0.001], max = [1.5, 1.5, 0.05] } }
seed = 3
"#;
    let text = [HEAD, BALL, FLOOR, source].concat();
    let text = text.replace(
        "0.0, 0.0, 1.0] } }]\n",
        "0.0, 0.0, 1.0] } }]\ninput = \"twist\"\n",
    );
    let step = |change: f64| {
        let mut simulation = simulation(&[&text]);
        let command = slipping(0).plus(&velocity(1), change);
        simulation.command(0, command).unwrap();
        simulation.advance(2e-2).unwrap();
        simulation
    };
    let column = derivative(&step(0.0), 0, velocity(1));
    let [low, high] = [-1e-5, 1e-5].map(|change| measured(&step(change)));
    assert!(low["sphereCount"] > 4.0 && low["contactCount"] > 3.0);
    let difference = quotient(&low, &high, 1e-5);
    for name in [
        "boundary.floor.averageForce[2]",
        "boundary.floor.averageTorque[3]",
        "angularMomentum[3]",
    ] {
        let off = (difference[name] - column[name]).abs() / difference[name].abs();
        assert!(off < 1e-5, "{name}: {} {}", column[name], difference[name]);
    }
}

/// A sphere between a floor that rises at a constant speed and a lid that gives way: the force on the lid rises by `k v`.
/// Symptom: where the speed was set within the step, its average rose by a quarter of that. Cause: the average before the last
/// command was taken for that of the communication step before.
#[test]
fn averages_rise_alike_whenever_commands_come() {
    let text = r#"
[simulation]
duration = 1.0
step = 1e-3
fixed_step = true
communication_step = 1e-2
gravity = [0, 0, 0]
[[material]]
name = "glass"
density = 1000
[[spheres]]
name = "ball"
material = "glass"
radius = 0.01
positions = [[0, 0, 0.01]]
[[boundary]]
name = "lid"
material = "glass"
stiffness = 1e4
faces = [{ plane = { point = [0, 0, 0.02], normal = [0, 0, -1] } }]
[[boundary]]
name = "floor"
material = "glass"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
input = { slide_speed = [0, 0, 1] }
"#;
    let speed = 0.01;
    let given = |scalar: f64| Command {
        scalar,
        ..Command::default()
    };
    for midway in [false, true] {
        let mut simulation = simulation(&[text]);
        simulation.command(1, given(speed)).unwrap();
        for k in 1..=5 {
            let mut march = simulation.begin(f64::from(k) * 1e-2).unwrap();
            for n in 0..10 {
                if midway && n == 5 {
                    let close = speed * (1.0 + 1e-12 * f64::from(k));
                    simulation.command(1, given(close)).unwrap();
                }
                simulation.internal_step(&mut march).unwrap();
            }
            simulation.end(march);
        }
        let rates = simulation
            .time_derivatives_of(|now| vec![now.mean_wrench(0).force.z])
            .unwrap();
        assert!(
            (rates[0] / (1e4 * speed) - 1.0).abs() < 1e-6,
            "{midway}: {} N/s",
            rates[0]
        );
    }
}
