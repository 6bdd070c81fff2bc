//! Gases of inelastic grains cool by Haff's law.
//!
//! ```text
//! dE/dt ~ -E^(3/2),   E = E_0 / (1 + t/tau)^2
//! spheres:  1/tau = (1 - e^2)/6 w_0,   w_0 = 4 n d^2 chi sqrt(pi T/m),   chi = (1 - phi/2)/(1 - phi)^3
//! ```
//!
//! with the number density `n`, the diameter `d`, the volume fraction `phi`, `T = m <v^2>/3`: each collision takes a share of the
//! energy that does not depend on the speed, and all times scale with `1/v`. Sources: P. K. Haff, *Grain flow as a fluid-mechanical
//! phenomenon*, Journal of Fluid Mechanics 134 (1983), 401; rate of spheres N. V. Brilliantov, T. Pöschel, *Kinetic Theory of Granular
//! Gases*, 2004, with Carnahan and Starling's `chi`. Rods: K. Harth et al., *Free cooling of a granular gas of rodlike particles in
//! microgravity*, Physical Review Letters 120 (2018), 214301.
//!
//! The gases are dilute and the steps a twentieth of a radius at the mean speed, so that few grains meet two others in one step.

use std::f64::consts::PI;

use nalgebra::UnitQuaternion;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use sphere_dda::Vec3;
use sphere_dda::random::{normal, rotation};
use sphere_dda::scene::clump::ClumpShape;
use sphere_dda::spatial::cell::Cell;

use crate::support::{Case, Run};

/// Radius of a sphere and of a member \[m\], first speed along each axis \[m/s\], restitution.
const RADIUS: f64 = 0.01;
const SPEED: f64 = 1.0;
const RESTITUTION: f64 = 0.8;
/// Grains along an edge of the cell.
const SIDE: usize = 6;
/// Way of a step at the mean speed over the radius.
const WAY: f64 = 0.05;

/// Times \[s\], energies of translation and of rotation \[J\].
type Cooling = Vec<(f64, [f64; 2])>;

/// Frictionless grains on a lattice of `spacing` \[m\] in a periodic cell: rods of two members, or spheres.
fn gas(rod: Option<&ClumpShape>, spacing: f64) -> Run {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let mut draw = |scale: f64| Vec3::from_fn(|_, _| scale * normal(&mut random));
    let count = SIDE.pow(3);
    let mut velocities: Vec<Vec3> = (0..count).map(|_| draw(SPEED)).collect();
    let mean = velocities.iter().sum::<Vec3>() / count as f64;
    velocities.iter_mut().for_each(|v| *v -= mean);
    let mut random = ChaCha8Rng::seed_from_u64(8);
    let mut case = Case::new(1.0, 0.0, RESTITUTION).without_gravity();
    for (k, velocity) in velocities.into_iter().enumerate() {
        let place = [k % SIDE, k / SIDE % SIDE, k / SIDE / SIDE];
        let place = Vec3::from(place.map(|i| (i as f64 + 0.5) * spacing));
        case = match rod {
            None => case.sphere(RADIUS, place, velocity),
            Some(shape) => {
                // Nothing turns a frictionless rod about its axis: that energy would stay.
                let turn: UnitQuaternion<f64> = rotation(&mut random);
                let spin = [0.0, 1.0, 1.0].map(|s| 0.5 * s * SPEED / RADIUS * normal(&mut random));
                case.clump(shape, (place, turn), velocity, turn * Vec3::from(spin))
            }
        };
    }
    let edge = SIDE as f64 * spacing;
    case.scene.cell = Cell::new([Some([0.0, edge]); 3]);
    case.start()
}

/// Lets a gas cool to `share` of its energy.
fn cool(mut run: Run, mass: f64, share: f64) -> Cooling {
    let energies = |run: &Run| {
        let energy = run.whole_energy();
        [energy.translational, energy.rotational]
    };
    let mut cooling = vec![(0.0, energies(&run))];
    let total = |of: &[f64; 2]| of[0] + of[1];
    let end = share * total(&cooling[0].1);
    while total(&cooling[cooling.len() - 1].1) > end {
        let translation = cooling[cooling.len() - 1].1[0];
        let mean = (2.0 * translation / (mass * SIDE.pow(3) as f64)).sqrt();
        run.advance(WAY * RADIUS / mean);
        cooling.push((run.simulation.time(), energies(&run)));
    }
    cooling
}

/// Exponent `p` of `E ~ (1 + t/tau)^-p` below `from` of the first energy: from the slope `1 + 1/p` of `ln(-dE/dt)` over `ln E`, in
/// pieces that take a sixth of the energy; and `tau` \[s\] at the first energy, were `p = 2`.
fn law(cooling: &Cooling, from: f64) -> [f64; 2] {
    let total: Vec<(f64, f64)> = cooling.iter().map(|(t, e)| (*t, e[0] + e[1])).collect();
    let first = total[0].1;
    let mut pieces = Vec::new();
    let mut start = *total.iter().find(|(_, e)| *e <= from * first).unwrap();
    for &(t, e) in &total {
        if t > start.0 && e <= start.1 * (5.0 / 6.0) {
            let middle = (start.1 * e).sqrt();
            pieces.push((middle.ln(), ((start.1 - e) / (t - start.0)).ln()));
            start = (t, e);
        }
    }
    let count = pieces.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| pieces.iter().map(f).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let over: f64 = pieces.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let slope = over / pieces.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>();
    // dE/dt = -2 E^(3/2) / (tau E_0^(1/2)) at the mean of all pieces.
    let tau = 2.0 * (1.5 * x - y).exp() / first.sqrt();
    [1.0 / (slope - 1.0), tau]
}

/// Spheres: exponent and time constant of kinetic theory, over one and a half decades of energy.
#[test]
fn a_gas_of_spheres_cools_by_haffs_law() {
    let spacing = 4.4 * RADIUS;
    let mass = 2500.0 * 4.0 / 3.0 * PI * RADIUS.powi(3);
    let cooling = cool(gas(None, spacing), mass, 0.02);
    let [exponent, tau] = law(&cooling, 1.0);
    let fraction = 4.0 / 3.0 * PI * (RADIUS / spacing).powi(3);
    let chi = (1.0 - 0.5 * fraction) / (1.0 - fraction).powi(3);
    let thermal = (2.0 / 3.0 * cooling[0].1[0] / (mass * SIDE.pow(3) as f64)).sqrt();
    let rate = 4.0 * (2.0 * RADIUS).powi(2) / spacing.powi(3) * chi * PI.sqrt() * thermal;
    let expected = 6.0 / ((1.0 - RESTITUTION * RESTITUTION) * rate);
    assert!((exponent - 2.0).abs() < 0.1, "{exponent}");
    assert!((tau / expected - 1.0).abs() < 0.05, "{tau} {expected}");
}

/// Rods: the exponent over one and a half decades of energy, once translation and rotation have found their ratio, which then stays:
/// near that of equipartition over three ways and two rotations.
#[test]
fn a_gas_of_rods_cools_by_haffs_law() {
    let half = Vec3::x() * RADIUS;
    let shape = ClumpShape::new(&[half, -half], &[RADIUS; 2], 2500.0, None, None);
    let (rod, _) = shape.expect("a rod");
    let cooling = cool(gas(Some(&rod), 5.5 * RADIUS), rod.mass, 0.01);
    let [exponent, _] = law(&cooling, 0.4);
    assert!((exponent - 2.0).abs() < 0.1, "{exponent}");
    let ratio = |part: &[(f64, [f64; 2])]| {
        let sum = |k: usize| part.iter().map(|(_, e)| e[k] / (e[0] + e[1])).sum::<f64>();
        sum(1) / sum(0)
    };
    let third = cooling.len() / 3;
    for part in [&cooling[third..2 * third], &cooling[2 * third..]] {
        assert!((1.5 * ratio(part) - 1.0).abs() < 0.1, "{}", ratio(part));
    }
}
