//! A-B against A-save-B'-restore-B, bit for bit, over random scripts of sets, steps, kept and serialized states, other instances
//! and other processes.

use std::process::Command;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::Scene;
use super::c::{Instance, OK};

const SCRIPTS: u64 = 1000;
/// Every how many scripts B runs in a process of its own.
const ABROAD: u64 = 50;
/// Shortest communication step \[s\].
const TICK: f64 = 4e-3;

/// All that a state has to carry: forces of contacts that stick, slip and resist rolling, a source's random numbers, flows, a belt,
/// a body with stops, a pose, a twist and a world pose from outside.
const RICH: &str = r#"
title = "Everything"
[simulation]
duration = 10.0
step = 2e-3
fixed_step = true
strict = true
communication_step = 4e-3
tolerance = { gap = 1e-4, slip = 1e-4, force = 1e-2, opening = 0 }
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.3
rolling_friction = 0.02
restitution = 0.4
[[boundary]]
name = "floor"
material = "stone"
input = "pose"
surface_velocity = [0.1, 0.0, 0.0]
surface_input = true
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
[[boundary]]
name = "wall"
material = "stone"
input = "twist"
faces = [{ plane = { point = [-0.2, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }]
[[boundary]]
name = "paddle"
material = "stone"
input = "world_pose"
faces = [{ rectangle = { corner = [0.08, -0.15, 0.0], u = [0.0, 0.3, 0.0], v = [0.0, 0.0, 0.1] } }]
[[boundary]]
name = "lid"
material = "stone"
input = "load"
faces = [{ plane = { point = [0.0, 0.0, 0.35], normal = [0.0, 0.0, -1.0] } }]
body = { mass = 1.0, joint = { slide = [0.0, 0.0, 1.0] }, limits = [-0.3, 0.02] }
[[source]]
name = "rain"
material = "stone"
size = { uniform = { min = 0.02, max = 0.03 } }
region = { box = { min = [-0.1, -0.1, 0.12], max = [0.1, 0.1, 0.25] } }
capacity = 8
rate = 60.0
seed = 7
[[sink]]
name = "drain"
region = { beyond = { point = [0.15, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }
recycle = "rain"
[[sensor]]
name = "fall"
mass_flow = { plane = { point = [0.0, 0.0, 0.1], normal = [0.0, 0.0, -1.0] } }
"#;

/// Inputs and how far they may go.
const INPUTS: [(&str, f64); 8] = [
    ("boundary.floor.translation[3]", 2e-3),
    ("boundary.floor.surfaceVelocity[1]", 0.5),
    ("boundary.wall.velocity[1]", 0.2),
    ("boundary.paddle.targetPosition[1]", 2e-3),
    ("boundary.paddle.targetOrientation[3]", 1e-2),
    ("boundary.lid.appliedForce", 30.0),
    ("gravity[1]", 2.0),
    ("gravity[3]", 20.0),
];

#[derive(Debug, Clone, Copy)]
enum Op {
    Set(usize, f64),
    Step(u32),
    /// The state is taken, kept over a step and restored.
    Keep,
    /// The state is read back from its own bytes.
    Reread,
    /// Another instance takes the bytes and goes on.
    Move,
}

fn script(random: &mut ChaCha8Rng) -> Vec<Op> {
    let count = random.random_range(2..7);
    (0..count)
        .map(|_| match random.random_range(0..8) {
            0..3 => {
                let input = random.random_range(0..INPUTS.len());
                Op::Set(input, random.random_range(-1.0..1.0) * INPUTS[input].1)
            }
            3..6 => Op::Step(random.random_range(1..4)),
            6 => [Op::Keep, Op::Reread][random.random_range(0..2)],
            _ => Op::Move,
        })
        .collect()
}

/// An instance and how many ticks it has done.
struct Player<'s> {
    scene: &'s Scene,
    instance: Instance<'static>,
    tick: u32,
}

impl<'s> Player<'s> {
    fn new(scene: &'s Scene) -> Self {
        let instance = scene.instance();
        instance.initialize();
        Self {
            scene,
            instance,
            tick: 0,
        }
    }

    fn step(&mut self, ticks: u32) {
        let (from, length) = (f64::from(self.tick) * TICK, f64::from(ticks) * TICK);
        let log = || self.instance.log();
        assert_eq!(self.instance.step(from, length), OK, "{:?}", log());
        self.tick += ticks;
    }

    fn away_and_back(&mut self) {
        let (tick, saved) = (self.tick, self.instance.state());
        self.step(2);
        assert_eq!(self.instance.restore(saved), OK);
        self.instance.free(saved);
        self.tick = tick;
    }

    /// Plays `ops`; `saving` as they stand, else without what should change nothing.
    fn play(&mut self, ops: &[Op], saving: bool) {
        for op in ops {
            match *op {
                Op::Set(input, value) => {
                    let reference = self.scene.reference(INPUTS[input].0);
                    assert_eq!(self.instance.set(reference, value), OK);
                }
                Op::Step(ticks) => self.step(ticks),
                Op::Keep if saving => self.away_and_back(),
                Op::Reread if saving => {
                    let bytes = self.instance.bytes();
                    assert_eq!(self.instance.load(&bytes), OK);
                }
                Op::Move if saving => {
                    let other = self.scene.instance();
                    assert_eq!(other.load(&self.instance.bytes()), OK);
                    self.instance = other;
                }
                Op::Keep | Op::Reread | Op::Move => {}
            }
        }
    }
}

/// Environment variable that makes this binary the second process; its value is the folder, the seed and the tick.
const CHILD: &str = "SPHERE_DDA_TEST_ROLLBACK";

/// Parts A, B' and B of a script.
fn parts(seed: u64) -> [Vec<Op>; 3] {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    [(); 3].map(|()| script(&mut random))
}

#[test]
fn a_rolled_back_run_is_the_straight_one() {
    let scene = Scene::new(RICH);
    if let Ok(job) = std::env::var(CHILD) {
        let [folder, seed, tick] = job.split('\n').collect::<Vec<_>>()[..] else {
            panic!("{job}")
        };
        let folder = std::path::Path::new(folder);
        let mut player = Player {
            scene: &scene,
            instance: scene.instance(),
            tick: tick.parse().unwrap(),
        };
        let before = std::fs::read(folder.join("before")).unwrap();
        assert_eq!(player.instance.load(&before), OK);
        player.play(&parts(seed.parse().unwrap())[2], true);
        std::fs::write(folder.join("after"), player.instance.bytes()).unwrap();
        return;
    }
    let mut straight = Player::new(&scene);
    let mut rolled = Player::new(&scene);
    let mut different = 0;
    for seed in 0..SCRIPTS {
        // Each script begins where the last one ended, or anew.
        if seed % 10 == 0 {
            (straight, rolled) = (Player::new(&scene), Player::new(&scene));
        }
        let [a, other, b] = parts(seed);
        straight.play(&a, false);
        rolled.play(&a, true);
        let (tick, saved) = (rolled.tick, rolled.instance.bytes());
        let state = rolled.instance.state();
        rolled.play(&other, false);
        different += u64::from(rolled.instance.bytes() != saved);
        assert_eq!(rolled.instance.restore(state), OK);
        rolled.instance.free(state);
        rolled.tick = tick;
        assert!(rolled.instance.bytes() == saved, "script {seed}: restored");
        straight.play(&b, false);
        if seed % ABROAD == 0 {
            let bytes = abroad(seed, tick, &saved);
            assert_eq!(rolled.instance.load(&bytes), OK);
            rolled.tick = straight.tick;
        } else {
            rolled.play(&b, true);
        }
        let (one, two) = (straight.instance.bytes(), rolled.instance.bytes());
        assert!(one == two, "script {seed}: {a:?}, {other:?}, {b:?}");
    }
    assert!(
        different > SCRIPTS * 9 / 10,
        "ways out that change something: {different}"
    );
    assert!(straight.instance.real(scene.reference("impactEnergy")) > 0.0);
}

/// The state after B of script `seed` from `saved` at `tick`, by another process.
fn abroad(seed: u64, tick: u32, saved: &[u8]) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("before"), saved).unwrap();
    let child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "rollback::a_rolled_back_run_is_the_straight_one"])
        .env(
            CHILD,
            format!("{}\n{seed}\n{tick}", folder.path().display()),
        )
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&child.stdout);
    assert!(child.status.success(), "{told}");
    std::fs::read(folder.path().join("after")).unwrap()
}
