//! Scenes that nobody tuned, with elastic grains that adhere or are bonded, and everything else at once.

use std::sync::Arc;

use sphere_dda::contact::cohesion::Hold;
use sphere_dda::scene::Scene;

use crate::scenes::{broken_in_part, check, held, scene, start};

/// Soft grains of two sizes adhere in a periodic box with a floor that shakes, into which they fall.
const STICKY: &str = r#"
[simulation]
duration = 1.0
communication_step = 0.005
[cell]
x = [0.0, 0.06]
y = [0.0, 0.06]
[[material]]
name = "grain"
density = 2500.0
young = 2e6
poisson = 0.3
[[material]]
name = "wall"
[pair_default]
friction = 0.4
restitution = 0.5
rolling_friction = 0.1
surface_energy = 0.2
adhesion = "jkr"
[[spheres]]
name = "grains"
material = "grain"
seed = 7
size = { uniform = { min = 0.003, max = 0.004 } }
lattice = { origin = [0.008, 0.008, 0.01], count = [5, 5, 4], spacing = 0.011, jitter = 0.1 }
[[boundary]]
name = "floor"
material = "wall"
motion = { sinusoid = { translation = [0.0, 0.0, 0.001], frequency = 10.0 } }
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
"#;

/// A rock of grains that are bonded over gaps, elastic, falls on a slope and breaks; which keeps what it feels.
const ROCK: &str = r#"
[simulation]
duration = 1.0
communication_step = 0.005
[[material]]
name = "grain"
density = 2500.0
young = 1e8
[[material]]
name = "wall"
[pair_default]
friction = 0.5
restitution = 0.2
[[pair]]
materials = ["grain", "grain"]
rolling_friction = 0.02
bond = { normal_strength = 1e5, shear_strength = 1e5, reach = 3e-4, young = 1e8 }
surface_energy = 0.5
[[spheres]]
name = "rock"
material = "grain"
radius = 0.005
velocity = [0.3, 0.0, -2.0]
lattice = { origin = [0.0, 0.0, 0.02], count = [4, 3, 4], spacing = 0.0102 }
[[boundary]]
name = "slope"
material = "wall"
wall_fields = true
faces = [{ rectangle = { corner = [-0.2, -0.2, -0.02], u = [0.4, 0.0, 0.04], v = [0.0, 0.4, 0.0] } }]
"#;

/// Grains rain from a source onto a heap on a tray on a spring, all of which adheres, and leave by a sink.
const RAIN: &str = r#"
[simulation]
duration = 1.0
communication_step = 0.005
[[material]]
name = "grain"
density = 2500.0
young = 5e6
[[material]]
name = "wall"
[pair_default]
friction = 0.3
restitution = 0.3
surface_energy = 0.3
adhesion = "jkr"
[[spheres]]
name = "heap"
material = "grain"
radius = 0.004
lattice = { origin = [-0.012, -0.012, 0.0045], count = [4, 4, 2], spacing = 0.0085 }
[[source]]
name = "cloud"
material = "grain"
radius = 0.003
capacity = 40
region = { box = { min = [-0.015, -0.015, 0.05], max = [0.015, 0.015, 0.06] } }
rate = 200.0
velocity = [0.0, 0.0, -0.5]
[[sink]]
name = "edge"
region = { box = { min = [-1.0, -1.0, -0.2], max = [1.0, 1.0, -0.05] } }
[[boundary]]
name = "tray"
material = "wall"
faces = [{ rectangle = { corner = [-0.02, -0.02, 0.0], u = [0.04, 0.0, 0.0], v = [0.0, 0.04, 0.0] } }]
body = { mass = 0.2, centre = [0.0, 0.0, -0.01], inertia = [1e-4, 1e-4, 1e-4], joint = { slide = [0.0, 0.0, 1.0] }, damping = 2.0, spring = { stiffness = 400.0, rest = 0.0 } }
"#;

#[test]
fn soft_grains_adhere_in_a_periodic_box() {
    let run = check(STICKY, 60);
    let attached = held(&run, |hold| *hold == Hold::Attached);
    assert!(attached > 60, "{attached}");
}

#[test]
fn an_elastic_rock_breaks_where_it_falls() {
    broken_in_part(&check(ROCK, 60));
}

#[test]
fn drops_adhere_to_a_tray_on_a_spring() {
    let scene = scene(RAIN);
    let mut threads = Scene::clone(&scene);
    threads.settings.threads = 2;
    let (mut run, mut again) = (start(&scene), start(&Arc::new(threads)));
    for k in 0..60 {
        if k == 30 {
            again
                .simulation
                .restore(&run.simulation.snapshot())
                .unwrap();
        }
        for one in [Some(&mut run), (k >= 30).then_some(&mut again)] {
            let report = one.map(|one| one.simulation.advance(0.005).expect("a step"));
            assert!(report.is_none_or(|report| report.unconverged_steps == 0));
        }
    }
    assert_eq!(run.simulation.snapshot(), again.simulation.snapshot());
    let attached = held(&run, |hold| *hold == Hold::Attached);
    assert!(attached > 15, "{attached}");
}
