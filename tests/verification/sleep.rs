//! Parts of a scene that sleep beside others that move. [`Run::advance`] checks momentum to 1e-9 and overlaps in every step.

use sphere_dda::Vec3;

use crate::scenes::{scene, start};
use crate::support::{G, Run, close};

const R: f64 = 0.01;

fn asleep(run: &Run) -> usize {
    let spheres = run.simulation.scene().particles.len();
    (0..spheres)
        .filter(|&i| run.velocity(i) == Vec3::zeros() && run.spin(i) == Vec3::zeros())
        .count()
}

/// Rows of the problem of a step.
fn rows(run: &Run) -> usize {
    let problem = run.simulation.problem(1e-3).expect("a problem");
    problem.0.rows.len()
}

/// A long trough with a blade at one end that begins to move at 0.8 s.
fn trough(rest_speed: f64) -> Run {
    let mut positions = String::new();
    for k in 0..480_u32 {
        let shaken = |seed: u32| (f64::from(k * seed) * 0.618_034).fract() * 0.002;
        let [x, y, z] = [k % 40, k / 40 % 3, k / 120].map(|n| 0.02 + 0.024 * f64::from(n));
        positions += &format!("[{}, {}, {}],", x + shaken(1), y + shaken(3), z + shaken(7));
    }
    let text = format!(
        r#"
[simulation]
duration = 2.0
communication_step = 0.01
rest_speed = {rest_speed:?}
[[spheres]]
name = "grains"
material = "grain"
radius = {R}
positions = [{positions}]
[[boundary]]
name = "trough"
material = "grain"
faces = [{{ box = {{ min = [0.0, 0.0, 0.0], max = [1.0, 0.09, 1.0] }} }}]
[[boundary]]
name = "blade"
material = "grain"
faces = [{{ box = {{ min = [0.0, 0.002, 0.002], max = [0.008, 0.088, 0.2] }} }}]
motion = {{ table = {{ time = [0.0, 0.8, 1.8], translation = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.1, 0.0, 0.0]] }} }}
[pair_default]
friction = 0.5
"#
    );
    start(&scene(&text))
}

/// A blade ploughs one end of a bed, the other end sleeps on, and what it feels is what it feels where nothing sleeps.
#[test]
fn what_lies_far_from_a_blade_sleeps() {
    let [mut sleeping, mut awake] = [0.01, 0.0].map(trough);
    let (mut means, mut sleep) = ([0.0; 2], [0.0; 2]);
    let runs = [&mut sleeping, &mut awake].into_iter();
    for ((run, mean), sleep) in runs.zip(&mut means).zip(&mut sleep) {
        while run.simulation.time() < 1.4 - 1e-9 {
            run.advance(0.01);
            assert_eq!(run.simulation.report().unconverged_steps, 0);
            if run.simulation.time() > 1.1 {
                *mean += run.simulation.mean_wrench(1).force.x / 30.0;
            }
            if run.simulation.time() > 0.8 {
                *sleep += asleep(run) as f64 / 60.0;
            }
        }
    }
    // On average: how many sleep at one time changes by half with the last bits.
    assert!(sleep[0] > 240.0, "{} sleep", sleep[0]);
    assert!(
        asleep(&sleeping) < 470,
        "what the blade moves does not sleep"
    );
    assert!(asleep(&awake) == 0);
    // Two runs of a bed differ by so much.
    close(means[0], means[1], 0.25, 0.0);
}

/// Balls in a row along x on a floor, at first as fast as `speed`, with a plate behind them that moves at `plate` \[m/s\]. Gravity
/// has a share `slope` along x.
fn row(balls: u32, [slope, friction]: [f64; 2], [speed, plate]: [f64; 2]) -> Run {
    let g = [slope * G, 0.0, -G];
    let place = |k: u32| format!("[{}, 0.0, {R}],", R * f64::from(2 * k + 1));
    let positions: String = (0..balls).map(place).collect();
    let text = format!(
        r#"
[simulation]
duration = 2.0
communication_step = 0.01
gravity = {g:?}
rest_speed = 0.01
[[spheres]]
name = "row"
material = "grain"
radius = {R}
positions = [{positions}]
velocity = [{speed:?}, 0.0, 0.0]
[[boundary]]
name = "floor"
material = "grain"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }}]
[[boundary]]
name = "plate"
material = "grain"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] }} }}]
motion = {{ constant = {{ velocity = [{plate:?}, 0.0, 0.0] }} }}
[pair_default]
friction = {friction:?}
"#
    );
    start(&scene(&text))
}

/// A ball that rolls at half of the rest speed stops, though nothing brakes it. One that starts to roll on a slope has its
/// `v = 5/7 slope g t`, and the balls of a row that a plate pushes up a slope have its velocity.
#[test]
fn what_rolls_slowly_stops_and_what_is_pushed_does_not() {
    let mut alone = row(1, [0.0, 0.5], [0.005, -0.1]);
    let mut sloped = row(1, [0.004, 0.5], [0.0, -0.1]);
    let mut pushed = row(5, [-0.05, 0.0], [0.005, 0.005]);
    for _ in 0..100 {
        for run in [&mut alone, &mut sloped, &mut pushed] {
            run.advance(0.002);
        }
        assert_eq!(asleep(&pushed), 0);
    }
    assert_eq!(asleep(&alone), 1);
    close(sloped.velocity(0).x, 5.0 / 7.0 * 0.004 * G * 0.2, 1e-3, 0.0);
    for i in 0..5 {
        close(pushed.velocity(i).x, 0.005, 0.02, 0.0);
    }
}

/// A pile asleep, on whose top ball a force pulls with a tenth of its weight: nothing else wakes, and the floor feels it.
#[test]
fn a_small_force_wakes_one_ball() {
    let text = format!(
        r#"
[simulation]
duration = 2.0
communication_step = 0.01
rest_speed = 0.001
tolerance = {{ force = 0.1 }}
[[spheres]]
name = "pile"
material = "grain"
radius = {R}
positions = [[0.0, 0.0, {R}], [0.0, 0.0, {}], [0.0, 0.0, {}]]
[[boundary]]
name = "floor"
material = "grain"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }}]
[pair_default]
friction = 0.5
"#,
        3.0 * R,
        5.0 * R
    );
    let mut run = start(&scene(&text));
    loop {
        run.advance(0.01);
        if asleep(&run) == 3 && run.simulation.report().sweeps == 0 {
            break;
        }
        assert!(run.simulation.time() < 1.0, "it does not sleep");
    }
    let pull = 0.1 * run.mass(2) * G;
    assert_eq!(rows(&run), 0);
    for share in [1.0, 0.5, 1.0] {
        let forces = [Vec3::zeros(), Vec3::zeros(), Vec3::z() * (share * pull)];
        run.simulation.apply_forces(&forces).expect("forces");
        // The mean of the first step has the change of the force in it.
        for _ in 0..2 {
            run.simulation.advance(0.01).expect("a step");
        }
        assert!(run.simulation.report().sweeps > 0, "the ball is awake");
        for i in 0..2 {
            assert!(run.velocity(i) == Vec3::zeros(), "ball {i} woke");
        }
        assert_eq!(rows(&run), 1);
        let weight = 3.0 * run.mass(0) * G - share * pull;
        close(-run.simulation.mean_wrench(0).force.z, weight, 1e-6, 0.0);
        close(-run.simulation.wrench(0).force.z, weight, 1e-6, 0.0);
    }
}

/// Balls whose contacts give way are compressed while they sleep. That is no overlap, and the floor bears their weight.
#[test]
fn elastic_balls_sleep_on_their_weight() {
    let text = format!(
        r#"
[simulation]
duration = 3.0
communication_step = 0.02
rest_speed = 0.01
[[material]]
name = "grain"
density = 2500.0
young = 1e7
[pair_default]
friction = 0.5
restitution = 0.2
[[spheres]]
name = "b"
material = "grain"
radius = {R}
positions = [[0.05, 0.05, 0.012], [0.08, 0.05, 0.2], [0.08, 0.05, 0.3]]
[[boundary]]
name = "floor"
material = "grain"
faces = [{{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }}]
"#
    );
    let mut run = start(&scene(&text));
    let weight = 3.0 * run.mass(0) * G;
    while run.simulation.time() < 3.0 - 1e-9 {
        run.advance(0.02);
        if run.simulation.time() > 2.0 {
            close(-run.simulation.mean_wrench(0).force.z, weight, 1e-6, 0.0);
        }
    }
    assert_eq!(asleep(&run), 3);
    assert_eq!(run.simulation.report().sweeps, 0);
}
