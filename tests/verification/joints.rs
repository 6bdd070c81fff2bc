//! Row 15: rolling over joints of coplanar facets in any direction, over an edge, inside a cone and round its creases.

use std::f64::consts::TAU;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, Revolution};

use crate::support::{Case, G, close, grid};

const RADIUS: f64 = 0.1;

/// A level sheet of 30 x 30 cells, its inner points moved at random, every second triangle turned over.
fn sheet() -> Facets {
    let mut rng = ChaCha8Rng::seed_from_u64(15);
    let mut shifts = Vec::new();
    for _ in 0..31 * 31 {
        shifts.push([rng.random_range(-0.3..0.3), rng.random_range(-0.3..0.3)]);
    }
    let mut facets = grid(30, 30, |i, j| {
        let [dx, dy] = shifts[(31 * j + i) as usize];
        Vec3::new(
            0.1 * (f64::from(i) + dx) - 1.5,
            0.1 * (f64::from(j) + dy) - 1.5,
            0.0,
        )
    });
    for triangle in facets.triangles.iter_mut().step_by(2) {
        triangle.swap(0, 1);
    }
    facets
}

/// Rolling with spin about the vertical on a level sheet: nothing changes, in whatever direction it crosses the joints.
#[test]
fn joints_of_coplanar_facets_are_not_felt() {
    let sheet = sheet();
    for k in 0..12 {
        let angle = (30.0 * f64::from(k) + 0.7 * f64::from(k * k)).to_radians();
        let along = Vec3::new(angle.cos(), angle.sin(), 0.0);
        let speed = 1.5;
        let spin = Vec3::z().cross(&along) * (speed / RADIUS) + Vec3::z() * 3.0;
        let mut run = Case::new(2e-3, 0.5, 0.5)
            .wall(vec![sheet.clone().into()])
            .body(
                RADIUS,
                along * -1.2 + Vec3::z() * RADIUS,
                along * speed,
                spin,
                Default::default(),
            )
            .start();
        for _ in 0..800 {
            run.step();
            let (v, w) = (run.velocity(0) - along * speed, run.spin(0) - spin);
            assert!(
                v.norm() < 1e-9 * speed,
                "direction {k}: {v:?} at {:?}",
                run.position(0)
            );
            assert!(w.norm() * RADIUS < 1e-9 * speed, "direction {k}: {w:?}");
            close(run.normal_force(), run.mass(0) * G, 1e-9, 0.0);
        }
        close(run.position(0).dot(&along), -1.2 + 1.6 * speed, 1e-9, 0.0);
    }
}

/// From a level face onto a slope 20 degrees down: at the joint the contact point stays while the centre swings over
/// the edge, and the energy is kept all the way, for the path has no corner.
///
/// While the normal n turns by th about the edge (unit vectors n, e across, y along it), rolling is `v_y = -R w_e`, and
/// `I w' = -R n x F` with `F_y = m v_y'` gives `dw_n/dth = w_e`, `7/2 dw_e/dth = -w_n`: a sphere that crosses the edge
/// obliquely without spin about n goes on with `v_y cos(sqrt(2/7) th)`.
#[test]
fn over_an_edge_nothing_is_lost() {
    let slope = 20f64.to_radians();
    for degrees in [0.0f64, 30.0] {
        let turned = degrees.to_radians();
        let along = Vec3::new(turned.cos(), turned.sin(), 0.0);
        let speed = 0.6;
        let down = Vec3::new(slope.cos(), 0.0, -slope.sin());
        let plate = |corner, u| Facets::rectangle(corner, u, Vec3::y() * 4.0).expect("a plate");
        let mut run = Case::new(2e-4, 1.0, 0.5)
            .tolerance(1e-8, 1e-8, 1e-8)
            .wall(vec![
                plate(Vec3::new(-1.0, -2.0, 0.0), Vec3::x()).into(),
                plate(Vec3::new(0.0, -2.0, 0.0), down * 2.0).into(),
            ])
            .body(
                RADIUS,
                along * -0.15 + Vec3::z() * RADIUS,
                along * speed,
                Vec3::z().cross(&along) * (speed / RADIUS),
                Default::default(),
            )
            .start();
        let start = run.energy();
        for _ in 0..3000 {
            run.step();
            assert_eq!(
                run.simulation.contacts().len(),
                1,
                "at {:?}",
                run.position(0)
            );
            let lost = start - run.energy();
            assert!(
                lost.abs() < 1e-4 * start,
                "{lost:e} of {start:e} J at {:?}",
                run.position(0)
            );
        }
        assert!(run.position(0).x > 0.2);
        let sideways = ((2.0f64 / 7.0).sqrt() * slope).cos();
        close(
            run.velocity(0).y,
            speed * turned.sin() * sideways,
            1e-5,
            speed,
        );
    }
}

/// A frictionless sphere on a circle inside an upright cone of half-angle A: `v^2 = g rho tan(90 - A) = g rho / tan A`, and
/// the force is `m g / sin A`.
#[test]
fn a_circle_inside_a_cone() {
    let half = 40f64.to_radians();
    // Distance of the centre from the axis, and its height over the apex.
    let rho = 0.8;
    let z = rho / half.tan() + RADIUS / half.sin();
    let speed = (G * rho / half.tan()).sqrt();
    let top = 2.0;
    let cone =
        Revolution::frustum(Vec3::zeros(), Vec3::z(), 0.0, top * half.tan(), top).expect("a cone");
    let mut run = Case::new(1e-3, 0.0, 0.5)
        .wall(vec![cone.into()])
        .sphere(RADIUS, Vec3::new(rho, 0.0, z), Vec3::new(0.0, speed, 0.0))
        .start();
    for _ in 0..4000 {
        run.step();
        close(run.position(0).xy().norm(), rho, 2e-3, 0.0);
        close(run.velocity(0).norm(), speed, 2e-3, 0.0);
        close(run.normal_force(), run.mass(0) * G / half.sin(), 1e-2, 0.0);
    }
}

/// A frictionless sphere without restitution and weight inside a cone of 36 flat faces, each of two triangles: straight on
/// along the offset plane of a face until it meets the next one, which takes the velocity along its normal `n` and nothing
/// else, `v' = v - (v.n) n`. Followed from crease to crease in closed form. No joint within a face is felt, the creases take
/// their share and no more.
#[test]
fn creases_of_a_cone_of_facets_take_their_share() {
    const FACES: u32 = 36;
    let half = 40f64.to_radians();
    let at = |i: u32, z: f64| {
        let (sin, cos) = (TAU * f64::from(i % FACES) / f64::from(FACES)).sin_cos();
        Vec3::new(z * half.tan() * cos, z * half.tan() * sin, z)
    };
    let cone = grid(FACES, 1, |i, j| at(i, 0.3 + 2.0 * f64::from(j)));
    // Inward normal of the plane through the apex and two corners.
    let normals: Vec<Vec3> = (0..FACES)
        .map(|i| at(i + 1, 1.0).cross(&at(i, 1.0)).normalize())
        .map(|n| if n.z > 0.0 { n } else { -n })
        .collect();
    let middle = at(0, 1.2).lerp(&at(1, 1.2), 0.5);
    let (mut face, mut x) = (0, middle + normals[0] * RADIUS);
    let level = Vec3::z().cross(&normals[0]).normalize();
    let mut v = (level * 2.0 - normals[0].cross(&level) * 0.3) * (level.y.signum());
    let mut run = Case::new(1e-3, 0.0, 0.0)
        .without_gravity()
        .wall(vec![cone.into()])
        .sphere(RADIUS, x, v)
        .start();
    let (start, mut creases, mut left) = (v.norm(), 0, 1.0);
    run.steps((left / 1e-3_f64).round() as usize);
    loop {
        let next = normals[(face + 1) % FACES as usize];
        let way = (next.dot(&x) - RADIUS) / -next.dot(&v);
        if way >= left {
            x += v * left;
            break;
        }
        x += v * way;
        v -= next * next.dot(&v);
        left -= way;
        face += 1;
        creases += 1;
    }
    assert!(creases > 5, "{creases} creases");
    assert!(v.norm() < 0.98 * start, "creases take something");
    let off = (run.velocity(0) - v).norm();
    assert!(off < 1e-9 * start, "{off:e} m/s after {creases} creases");
    // Each crease is met at the end of a step: up to a step's way with the speed that is lost there.
    let late = (run.position(0) - x).norm();
    assert!(late < f64::from(creases) * 1e-3 * 0.2 * start, "{late:e} m");
}
