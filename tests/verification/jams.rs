//! Grains that boundaries jam, and steps that do not meet their tolerances: they make no energy.

use sphere_dda::Vec3;
use sphere_dda::scene::Motion;
use sphere_dda::spatial::Twist;

use crate::scenes::{scene, start};
use crate::support::{Case, Run, grid};

const ROCK: &str = r#"
[[material]]
name = "rock"
density = 2700.0
friction = 0.6
restitution = 0.2
"#;

/// Energy \[J\] of motion and height, and what the boundaries have worked.
fn energy(run: &Run) -> [f64; 2] {
    let whole = run.whole_energy();
    [
        whole.kinetic() + whole.gravity,
        run.simulation.work().boundaries,
    ]
}

/// Runs for `count` communication steps; whatever gives way takes work of the boundaries and makes none: `E - E_0 <= W`, and no sphere
/// is faster than `fastest` \[m/s\]. Returns how many steps did not converge.
fn makes_no_energy(text: &str, count: usize, fastest: f64) -> u64 {
    let scene = scene(&[text, ROCK].concat());
    let mut run = start(&scene);
    let ([before, _], mut unconverged) = (energy(&run), 0);
    for _ in 0..count {
        let h = scene.settings.communication_step;
        run.simulation.advance(h).expect("a step");
        let report = run.simulation.report();
        unconverged += report.unconverged_steps;
        if report.max_overlap > scene.settings.tolerance.gap {
            assert!(
                report.unconverged_steps > 0,
                "an overlap that nobody is told"
            );
        }
        let [now, work] = energy(&run);
        let (time, gained) = (run.simulation.time(), now - before - work);
        assert!(gained <= 1e-3 * before, "{gained:e} J at {time} s");
        for i in 0..scene.particles.len() {
            let speed = run.velocity(i).norm();
            assert!(speed < fastest, "sphere {i}: {speed} m/s at {time} s");
        }
    }
    unconverged
}

/// The edge of a gate comes down on a ball, a little beside its centre: the line from edge to floor lies within both friction
/// cones, so that no rigid answer exists. It gives way; it is not shot away by `overlap/dt` of a step that was cut.
#[test]
fn a_ball_that_a_gate_jams_stays_where_it_is() {
    let down = gate("constant = { velocity = [0.0, 0.0, -0.3] }");
    assert!(makes_no_energy(&down, 60, 0.6) > 0, "it does not jam");
}

/// The gate goes up again: what it has pressed in comes out at the pace of a longest step, and steps are told as unconverged until it
/// is out, also those whose problems are solved.
#[test]
fn a_ball_that_a_gate_lets_go_comes_out_slowly() {
    let up = gate(
        "table = { time = [0.0, 0.4, 0.8], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, -0.12], [0.0, 0.0, 0.0]] }",
    );
    assert!(makes_no_energy(&up, 80, 2.0) > 0, "it does not jam");
}

/// The edge of a gate with this motion over a ball, beside its centre.
fn gate(motion: &str) -> String {
    let text = r#"
[simulation]
duration = 1.0
communication_step = 0.01
[[spheres]]
name = "s"
material = "rock"
radius = 0.25
positions = [[0.0, 0.0, 0.25]]
[[boundary]]
name = "floor"
material = "rock"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
[[boundary]]
name = "gate"
material = "rock"
faces = [{ rectangle = { corner = [-0.5, 0.02, 0.6], u = [1.0, 0.0, 0.0], v = [0.0, 0.0, 1.0] } }]
motion = { MOTION }
"#;
    text.replace("MOTION", motion)
}

/// A lid with ridges of triangles slides over a ball and presses it into the floor, in steps far shorter than the longest. Where the ball
/// meets another triangle it is pushed out no faster than in a longest step, by `overlap/step`.
#[test]
fn a_mesh_that_slides_over_a_squeezed_ball_does_not_shoot_it() {
    let (radius, step, h) = (0.1, 1e-2, 1e-4);
    let ridges = grid(80, 4, |i, j| {
        let [x, y] = [0.025 * f64::from(i) - 1.0, 0.1 * f64::from(j) - 0.2];
        // Its triangles look down.
        Vec3::new(-x, y, 2.0 * radius + 1e-4 + 2e-4 * f64::from(i % 2))
    });
    let motion = Motion::Constant(Twist {
        linear: Vec3::new(0.7, 0.0, -0.1),
        angular: Vec3::zeros(),
    });
    let mut run = Case::new(step, 0.6, 0.3)
        .settings(|s| s.strict = false)
        .floor()
        .moving(vec![ridges.into()], motion)
        .sphere(radius, Vec3::z() * radius, Vec3::zeros())
        .start();
    for _ in 0..2000 {
        let report = run.simulation.advance(h).expect("it gives way");
        let pressed = 0.1 * run.simulation.time();
        assert!(report.max_overlap * radius <= pressed, "{report:?}");
        let speed = run.velocity(0).norm();
        assert!(speed < 0.7 + 0.1 + pressed / step, "{speed} m/s");
    }
    assert!(run.force_on_boundary(1).z > 0.0, "it is not squeezed");
}

/// A gate falls on a pile with resistance to rolling: some of its contacts are impacts while others hold, with forces a million times
/// the weight that cancel. None of these goes on into a step of another length.
#[test]
fn a_pile_that_a_fast_gate_hits_is_not_shot_away() {
    let text = r#"
[simulation]
duration = 0.6
communication_step = 0.01
[pair_default]
friction = 0.6
restitution = 0.2
rolling_friction = 0.1
twisting_friction = 0.02
[[spheres]]
name = "stones"
material = "rock"
radius = 0.18
positions = [[-0.25, -0.1, 0.18], [0.15, -0.15, 0.18], [0.0, 0.25, 0.18]]
[[spheres]]
name = "b"
material = "rock"
radius = 0.25
positions = [[0.0, 0.0, 0.65]]
[[boundary]]
name = "pit"
material = "rock"
faces = [{ box = { min = [-0.8, -0.8, 0.0], max = [0.8, 0.8, 3.0] } }]
[[boundary]]
name = "gate"
material = "rock"
faces = [{ rectangle = { corner = [-0.45, 0.02, 1.1], u = [0.9, 0.0, 0.0], v = [0.0, 0.0, 1.0] } }]
motion = { constant = { velocity = [0.0, 0.0, -1.75] } }
"#;
    // The gate at 1.75 m/s, a fall of 0.2 m, and what springs give back of its work.
    makes_no_energy(text, 24, 4.0);
}

/// Grains that are rough and rebound fall into a box: steps that miss their tolerances lose energy all the same.
#[test]
fn rough_grains_that_rebound_do_not_explode() {
    let mut positions = String::new();
    for k in 0..250_u32 {
        // A lattice, shaken by the golden ratio.
        let shaken = |seed: u32| (f64::from(k * seed) * 0.618_034).fract() * 0.004;
        let [x, y, z] = [k % 5, k / 5 % 5, k / 25].map(|n| 0.015 + 0.024 * f64::from(n));
        positions += &format!("[{}, {}, {}],", x + shaken(1), y + shaken(3), z + shaken(7));
    }
    let text = format!(
        r#"
[simulation]
duration = 1.0
communication_step = 0.01
[pair_default]
friction = 1.0
restitution = 0.6
[[spheres]]
name = "g"
material = "rock"
radius = 0.01
positions = [{positions}]
[[boundary]]
name = "box"
material = "rock"
faces = [{{ box = {{ min = [0.0, 0.0, 0.0], max = [0.13, 0.13, 1.0] }} }}]
"#
    );
    // A fall from the top of the lattice brings 2.2 m/s.
    makes_no_energy(&text, 50, 4.0);
}

/// Whatever the length of the communication step, a belt that starts under a ball which may not turn feels `-mu m g`, and means
/// give the change of momentum.
#[test]
fn means_of_short_communication_steps_are_no_larger_than_friction() {
    for h in [2e-3, 5e-4, 1e-4, 2e-5] {
        let text = r#"
[simulation]
duration = 1.0
step = 0.004
[[spheres]]
name = "s"
material = "rock"
radius = 0.05
positions = [[0.0, 0.0, 0.05]]
lock = ["rotations"]
[[boundary]]
name = "belt"
material = "rock"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
surface_input = true
"#;
        let scene = scene(&[text, ROCK].concat());
        let mut run = start(&scene);
        for _ in 0..3 {
            run.advance(h);
        }
        let mut command = run.simulation.state().commands[0];
        command.surface_velocity = Vec3::new(1.0, 0.0, 0.0);
        run.simulation.command(0, command).expect("an input");
        let (most, before) = (0.6 * run.mass(0) * crate::support::G, run.momentum());
        let mut impulse = 0.0;
        for _ in 0..8 {
            run.advance(h);
            let force = run.simulation.mean_wrench(0).force.x;
            assert!(
                (-1.000_001 * most..=0.0).contains(&force),
                "{force} of {most} N"
            );
            impulse -= force * h;
        }
        let gained = (run.momentum() - before).x;
        assert!(
            (impulse - gained).abs() < 1e-9 * most * h,
            "{impulse} {gained}"
        );
    }
}
