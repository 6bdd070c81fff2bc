//! Row 15: rolling over joints of coplanar facets in any direction, over an edge, and inside a cone.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use sphere_dda::Vec3;
use sphere_dda::boundaries::{Facets, Revolution};

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
/// the force is `m g / sin A`. For the cone of one piece and for one of facets that are tangent to it.
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
