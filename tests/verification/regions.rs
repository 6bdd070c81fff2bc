//! What region sensors and polygons measure, against closed forms, in states that the solver has made.

use std::f64::consts::PI;

use sphere_dda::Vec3;
use sphere_dda::geometry::region::Primitive;
use sphere_dda::observe::Observation;
use sphere_dda::observe::sensors::region::Reading;
use sphere_dda::scene::{Measure, PointLoad, Sensor};

use crate::support::{Case, G, Run, close};

const R: f64 = 0.05;

impl Case {
    fn load(mut self, sphere: usize, force: Vec3) -> Self {
        self.scene.loads.push(PointLoad {
            sphere,
            arm: Vec3::zeros(),
            force,
        });
        self
    }

    fn sensor(mut self, name: &str, measure: Measure) -> Self {
        self.scene.sensors.push(Sensor {
            name: name.into(),
            measure,
        });
        self
    }

    /// `count` spheres per axis at the nodes of a cubic lattice; the first centre is at `(R, R, R)`.
    fn cubic(self, count: [usize; 3]) -> Self {
        let mut case = self;
        for i in 0..count[0] {
            for j in 0..count[1] {
                for k in 0..count[2] {
                    let node = Vec3::new(i as f64, j as f64, k as f64);
                    case = case.sphere(R, node * (2.0 * R) + Vec3::repeat(R), Vec3::zeros());
                }
            }
        }
        case
    }
}

fn cuboid(min: [f64; 3], max: [f64; 3]) -> Primitive {
    Primitive::Box {
        min: Vec3::from(min) * R,
        max: Vec3::from(max) * R,
    }
}

fn read(run: &Run, region: &Primitive) -> Reading {
    Reading::of(region, &Observation::of(&run.simulation))
}

/// Six components against `expected`, to 1e-6 of the largest.
#[track_caller]
fn stress_is(reading: &Reading, expected: [f64; 6]) {
    let scale = expected.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    for (found, expected) in reading.stress.iter().zip(expected) {
        close(*found, expected, 1e-6, scale);
    }
}

/// A simple cubic block on a floor, a load `F` down on each sphere of the top layer. Every column carries `F` and holds
/// a ground area of `(2 R)^2`: `s_zz = F / (4 R^2)` between the floor and the top centres, all else zero. It does not
/// matter where the region cuts the branches: at the contacts, in the middle, or at 0.3 of them.
#[test]
fn a_block_between_plates() {
    let (count, force) = ([4, 3, 5], 37.0);
    let mut case = Case::new(1e-3, 0.0, 0.0)
        .without_gravity()
        .tolerance(1e-9, 1e-9, 1e-8)
        .floor()
        .cubic(count);
    for top in (4..60).step_by(5) {
        case = case.load(top, Vec3::new(0.0, 0.0, -force));
    }
    let mut run = case.start();
    for _ in 0..5 {
        for (low, high) in [(0.0, 9.0), (0.0, 2.0), (1.0, 3.0), (0.6, 6.6), (2.9, 3.1)] {
            let region = cuboid([0.0, 0.0, low], [8.0, 6.0, high]);
            let pressure = force / (4.0 * R * R);
            stress_is(&read(&run, &region), [0.0, 0.0, pressure, 0.0, 0.0, 0.0]);
        }
        // A cylinder round one column.
        let region = Primitive::Cylinder {
            base: Vec3::new(3.1, 3.0, 1.3) * R,
            axis: Vec3::z(),
            radius: 0.9 * R,
            height: 4.4 * R,
        };
        let pressure = force / (PI * 0.81 * R * R);
        stress_is(&read(&run, &region), [0.0, 0.0, pressure, 0.0, 0.0, 0.0]);
        run.step();
    }
}

/// A column under its weight. Below the k-th centre from the bottom, k = 0 first, acts `(n - k) m g`; a slab from `a` to
/// `b` sees the mean of that over its height.
#[test]
fn a_column_under_its_weight() {
    let n = 6;
    let mut run = Case::new(1e-3, 0.4, 0.0)
        .tolerance(1e-9, 1e-9, 1e-8)
        .floor()
        .cubic([1, 1, n])
        .start();
    let weight = run.mass(0) * G;
    for _ in 0..5 {
        for (a, b) in [(0.0_f64, 11.0_f64), (0.4, 1.9), (2.5, 7.7)] {
            // Between the centres at 2 k - 1 and 2 k + 1, in radii; the lowest branch begins at the floor.
            let sum: f64 = (0..n)
                .map(|k| {
                    let (low, high) = (
                        if k == 0 { 0.0 } else { 2.0 * k as f64 - 1.0 },
                        2.0 * k as f64 + 1.0,
                    );
                    (n - k) as f64 * weight * (b.min(high) - a.max(low)).max(0.0)
                })
                .sum();
            let reading = read(&run, &cuboid([0.0, 0.0, a], [2.0, 2.0, b]));
            let mean = sum / (b - a) / (4.0 * R * R);
            stress_is(&reading, [0.0, 0.0, mean, 0.0, 0.0, 0.0]);
        }
        // The lowest sphere has the floor and its neighbour: two contacts, n m g and (n - 1) m g.
        let reading = read(&run, &cuboid([0.0, 0.0, -0.1], [2.0, 2.0, 2.1]));
        assert_eq!((reading.count, reading.coordination_number), (1, 2.0));
        close(reading.max_normal_force, n as f64 * weight, 1e-6, 0.0);
        close(
            reading.mean_normal_force,
            (n as f64 - 0.5) * weight,
            1e-6,
            0.0,
        );
        run.step();
    }
}

/// A cube of 3 x 3 x 3 spheres pressed from all sides by `F` on each outer sphere. Every line of centres carries `F`: the
/// cell of the middle sphere sees `s = F / (4 R^2)` in all three directions. The middle sphere has six contacts.
#[test]
fn a_cube_under_pressure() {
    let force = 12.0;
    let mut case = Case::new(1e-3, 0.0, 0.0)
        .without_gravity()
        .tolerance(1e-9, 1e-9, 1e-8)
        .cubic([3, 3, 3]);
    for sphere in 0..27 {
        let node = [sphere / 9, sphere / 3 % 3, sphere % 3];
        for (axis, place) in node.into_iter().enumerate() {
            if place != 1 {
                let inward = if place == 0 { 1.0 } else { -1.0 };
                case = case.load(sphere, Vec3::ith(axis, inward * force));
            }
        }
    }
    let mut run = case.start();
    for _ in 0..5 {
        let pressure = force / (4.0 * R * R);
        let expected = [pressure, pressure, pressure, 0.0, 0.0, 0.0];
        stress_is(&read(&run, &cuboid([2.0; 3], [4.0; 3])), expected);
        let reading = read(&run, &cuboid([1.5; 3], [4.5; 3]));
        assert_eq!((reading.count, reading.coordination_number), (1, 6.0));
        close(reading.max_normal_force, force, 1e-6, 0.0);
        close(reading.mean_normal_force, force, 1e-6, 0.0);
        let all = read(&run, &cuboid([-1.0; 3], [7.0; 3]));
        // 54 contacts within the cube, each with two ends, on 27 spheres.
        assert_eq!((all.count, all.coordination_number), (27, 4.0));
        close(
            all.solid_fraction,
            27.0 * 4.0 / 3.0 * PI / 512.0,
            1e-12,
            0.0,
        );
        close(all.centre_of_mass.x, 3.0 * R, 1e-9, 0.0);
        run.step();
    }
}

/// A slanting chain pressed at its ends along its direction `d`: `s_ij = F L d_i d_j / V`, with `L` the length in the
/// region. It shows which component is which.
#[test]
fn a_slanting_chain() {
    let direction = Vec3::new(3.0, 2.0, 1.0).normalize();
    let force = 5.0;
    let mut case = Case::new(1e-3, 0.0, 0.0)
        .without_gravity()
        .tolerance(1e-9, 1e-9, 1e-8);
    for k in -2..=2 {
        case = case.sphere(R, direction * (2.0 * R * f64::from(k)), Vec3::zeros());
    }
    let run = case
        .load(0, direction * force)
        .load(4, -direction * force)
        .start();
    // The faces at x = -1.5 R and 2.5 R are the first that the line meets.
    let reading = read(&run, &cuboid([-1.5, -2.0, -2.0], [2.5, 2.0, 2.0]));
    let (length, volume) = (4.0 * R / direction.x, 64.0 * R * R * R);
    let of = |i: usize, j: usize| force * length * direction[i] * direction[j] / volume;
    stress_is(
        &reading,
        [of(0, 0), of(1, 1), of(2, 2), of(0, 1), of(1, 2), of(0, 2)],
    );
}

/// Crystals have the same solid fraction in every box whose edges are whole periods, wherever it lies: pi/6 and
/// pi/(3 sqrt 2). The face-centred one stands on its close-packed layers (period 2 R, 2 sqrt 3 R, 2 sqrt 6 R), so that no
/// face of the box is one of its cubic cell.
#[test]
fn solid_fraction_of_crystals() {
    let sc = Case::new(1e-3, 0.0, 0.0)
        .without_gravity()
        .cubic([6, 6, 6])
        .start();
    for shift in [0.0, 0.31, 1.0, 1.77] {
        let low = [3.0 + shift, 2.0 + 0.7 * shift, 3.0 - 0.4 * shift];
        let region = cuboid(low, low.map(|x| x + 4.0));
        close(read(&sc, &region).solid_fraction, PI / 6.0, 1e-9, 0.0);
    }
    // Not of whole periods, where counting centres is wrong. Every plane at a multiple of R mirrors the lattice, so each cube
    // of edge R holds an eighth of a sphere.
    for (low, size) in [
        ([3.0, 2.0, 4.0], [1.0, 1.0, 1.0]),
        ([3.0, 4.0, 3.0], [3.0, 1.0, 5.0]),
    ] {
        let high = [0, 1, 2].map(|k| low[k] + size[k]);
        let found = read(&sc, &cuboid(low, high)).solid_fraction;
        close(found, PI / 6.0, 1e-9, 0.0);
    }
    // A slab of 1.3 R between two layers of centres: from each side a cap of height h = 0.6 R or 0.7 R, per 4 R^2 of area.
    let cap = |h: f64| PI * h * h * (3.0 - h) / 3.0;
    let slab = read(&sc, &cuboid([3.4, 2.5, 2.2], [4.7, 6.5, 4.2]));
    let expected = (cap(0.6) + cap(0.7)) / (4.0 * 1.3);
    close(slab.solid_fraction, expected, 1e-9, 0.0);
    // So it is for a cylinder that lies within the two layers' caps of one column: axis from centre to centre.
    let between = Primitive::Cylinder {
        base: Vec3::new(3.4, 3.0, 3.0) * R,
        axis: Vec3::x(),
        radius: 0.5 * R,
        height: 1.3 * R,
    };
    // The ends of the two spheres, of height z(rho) = sqrt(1 - rho^2) above their centres, over the disc rho < 0.5.
    let over = 2.0 * PI / 3.0 * (1.0 - 0.75f64.powf(1.5));
    let inside = 2.0 * over - PI * 0.25 * (0.4 + 0.3);
    let expected = inside / (PI * 0.25 * 1.3);
    close(read(&sc, &between).solid_fraction, expected, 1e-9, 0.0);
    let mut case = Case::new(1e-3, 0.0, 0.0).without_gravity();
    let period = [2.0, 2.0 * 3f64.sqrt(), 2.0 * 6f64.sqrt()];
    for layer in 0..9 {
        for row in 0..8 {
            for column in 0..8 {
                let offset = f64::from(row % 2) + f64::from(layer % 3);
                let node = [
                    2.0 * f64::from(column) + offset,
                    period[1] / 2.0 * f64::from(row) + f64::from(layer % 3) / 3f64.sqrt(),
                    period[2] / 3.0 * f64::from(layer),
                ];
                case = case.sphere(R, Vec3::from(node) * R, Vec3::zeros());
            }
        }
    }
    let fcc = case.start();
    for shift in [0.0, 0.31, 1.0, 1.77] {
        let low = [4.0 + shift, 3.0 + 0.7 * shift, 4.0 - 0.4 * shift];
        let high = [
            low[0] + 4.0 * period[0],
            low[1] + 2.0 * period[1],
            low[2] + period[2],
        ];
        let found = read(&fcc, &cuboid(low, high)).solid_fraction;
        close(found, PI / (3.0 * 2f64.sqrt()), 1e-9, 0.0);
        close(found, 0.74048, 1e-5, 0.0);
    }
}

/// A sphere that waits outside the scene is in no region; an empty region answers with its own centre and zeros.
#[test]
fn absent_spheres_and_empty_regions() {
    let mut case = Case::new(1e-3, 0.0, 0.0).without_gravity().cubic([2, 1, 1]);
    case.scene.initial.present[0] = false;
    let run = case.start();
    let reading = read(&run, &cuboid([0.0; 3], [4.0, 2.0, 2.0]));
    assert_eq!((reading.count, reading.mass), (1, run.mass(1)));
    close(reading.solid_fraction, PI / 12.0, 1e-12, 0.0);
    assert!((reading.centre_of_mass - run.position(1)).norm() < 1e-16);
    let empty = Primitive::Cylinder {
        base: Vec3::new(9.0, 0.0, 0.0),
        axis: Vec3::y(),
        radius: 1.0,
        height: 3.0,
    };
    let expected = Reading {
        centre_of_mass: Vec3::new(9.0, 1.5, 0.0),
        ..Reading::default()
    };
    assert_eq!(read(&run, &empty), expected);
}

/// Spheres rain through a window of four panes: each passes one of them, so their flows add up to the plane's.
#[test]
fn panes_share_the_flow_of_their_plane() {
    let pane = |x: [f64; 2], y: [f64; 2]| Measure::MassFlow {
        point: Vec3::zeros(),
        normal: -Vec3::z(),
        // Downwards: the corners turn about -z.
        outline: [[0, 0], [0, 1], [1, 1], [1, 0]]
            .map(|[i, j]| Vec3::new(x[i], y[j], 0.0))
            .to_vec(),
    };
    // Cuts through the second column in x and the third in y, at numbers that floating point holds exactly.
    let (x, y) = ([-1.0, 0.125, 1.0], [-1.0, 0.25, 1.0]);
    let mut case = Case::new(1e-3, 0.0, 0.0);
    for k in 0..32 {
        let node = [k % 4, k / 4 % 4, 1 + k / 16].map(|i| 0.125 * f64::from(i));
        case = case.sphere(R, node.into(), Vec3::zeros());
    }
    case = case.sensor(
        "plane",
        Measure::MassFlow {
            point: Vec3::zeros(),
            normal: -Vec3::z(),
            outline: vec![],
        },
    );
    for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        case = case.sensor("pane", pane([x[i], x[i + 1]], [y[j], y[j + 1]]));
    }
    let mut run = case.start();
    let mass = run.mass(0);
    run.steps(300);
    let passed = &run.simulation.state().passed;
    let count = |s: usize| (passed[s] / mass).round();
    assert_eq!(count(0), 32.0);
    // Columns lie on both cuts. The left of an edge, walked towards +y or +x and seen from below, is +x or -y.
    assert_eq!([1, 2, 3, 4].map(count), [6.0, 18.0, 2.0, 6.0]);
    close(passed[1..].iter().sum(), passed[0], 1e-14, 0.0);
}
