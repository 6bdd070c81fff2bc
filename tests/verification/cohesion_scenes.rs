//! Scenes that nobody tuned, with contacts that hold and everything else at once.

use sphere_dda::contact::cohesion::Hold;

use crate::scenes::{broken_in_part, check, held};

/// Wet grains of two sizes with bridges fall into a periodic box with a floor, where they fall asleep.
const WET: &str = r#"
[simulation]
duration = 1.0
communication_step = 0.01
rest_speed = 1e-3
[cell]
x = [0.0, 0.06]
y = [0.0, 0.06]
[pair_default]
friction = 0.4
restitution = 0.5
rolling_friction = 0.1
twisting_friction = 0.05
cohesion = 0.004
rupture_distance = 1e-4
[[spheres]]
name = "grains"
material = "grain"
seed = 7
size = { uniform = { min = 0.003, max = 0.004 } }
lattice = { origin = [0.008, 0.008, 0.01], count = [5, 5, 5], spacing = 0.011, jitter = 0.1 }
[[boundary]]
name = "floor"
material = "wall"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
"#;

/// A paddle on a hinge, driven by a torque, turns among sticky grains in a tray that moves.
const PADDLE: &str = r#"
[simulation]
duration = 1.0
communication_step = 0.01
[pair_default]
friction = 0.3
restitution = 0.3
rolling_friction = 0.05
surface_energy = 0.3
adhesion = "jkr"
[[spheres]]
name = "grains"
material = "grain"
radius = 0.004
seed = 3
lattice = { origin = [-0.02, -0.02, 0.006], count = [5, 5, 4], spacing = 0.0095, jitter = 0.05 }
[[boundary]]
name = "tray"
material = "wall"
faces = [
    { plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } },
    { cylinder = { base = [0.0, 0.0, 0.0], radius = 0.04, height = 0.2 } },
]
motion = { sinusoid = { translation = [0.0, 0.0, 0.002], frequency = 8.0 } }
[[boundary]]
name = "paddle"
material = "wall"
faces = [{ rectangle = { corner = [0.0, 0.0, 0.06], u = [0.03, 0.0, 0.0], v = [0.0, 0.0, 0.02] } }]
body = { mass = 0.05, centre = [0.015, 0.0, 0.07], inertia = [1e-5, 1e-5, 1e-5], joint = { slide = [0.0, 0.0, 1.0] }, damping = 0.5 }
"#;

/// A bonded block falls on its corner and breaks.
const ROCK: &str = r#"
[simulation]
duration = 1.0
communication_step = 0.01
[pair_default]
friction = 0.5
restitution = 0.2
[[pair]]
materials = ["grain", "grain"]
rolling_friction = 0.02
bond = { normal_strength = 1.5e6, shear_strength = 1.5e6 }
[[spheres]]
name = "rock"
material = "grain"
radius = 0.005
velocity = [0.3, 0.0, -2.0]
lattice = { origin = [0.0, 0.0, 0.02], count = [4, 3, 4], spacing = 0.01 }
[[boundary]]
name = "slope"
material = "wall"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.2, 0.1, 1.0] } }]
"#;

fn attached(hold: &Hold) -> bool {
    *hold == Hold::Attached
}

#[test]
fn wet_grains_fall_asleep_in_a_periodic_box() {
    // Awake, for the balance of momentum.
    check(&WET.replace("rest_speed = 1e-3", ""), 40);
    let run = check(WET, 80);
    assert!(held(&run, attached) > 150);
    let asleep = (0..125).filter(|&i| run.velocity(i).norm() == 0.0).count();
    assert!(asleep > 60, "{asleep}");
}

#[test]
fn sticky_grains_carry_a_driven_plate() {
    let run = check(PADDLE, 60);
    assert!(held(&run, attached) > 100);
}

#[test]
fn a_rock_breaks_where_it_falls() {
    broken_in_part(&check(ROCK, 40));
}
