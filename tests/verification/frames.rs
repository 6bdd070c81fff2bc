//! Gravity that changes with time, and rotating frames of reference.

use nalgebra::{Matrix3, UnitQuaternion};
use sphere_dda::Vec3;
use sphere_dda::integrator::Integrator;
use sphere_dda::observe::Observation;
use sphere_dda::observe::energy::Energy;
use sphere_dda::scene::clump::ClumpShape;
use sphere_dda::scene::gravity::GravityMotion;
use sphere_dda::scene::particles::Locks;
use sphere_dda::scene::rotating_frame::RotatingFrame;

use crate::support::{Case, G, Run};

const BOTH: [Integrator; 2] = [Integrator::Moreau, Integrator::Shi];

/// Asserts that halving the step divides each error by four, within `within` of it.
#[track_caller]
fn second_order<const N: usize>(errors: [[f64; N]; 3], within: f64) {
    for k in 0..N {
        let [a, b, c] = errors.map(|e| e[k]);
        for ratio in [a / b, b / c] {
            assert!((ratio / 4.0 - 1.0).abs() < within, "{errors:?}");
        }
    }
}

/// Gravity `-G (sin wt, 0, cos wt)` turns about y; integrated twice from rest:
/// `v = -G/w (1 - cos wt, 0, sin wt)`, `x = -G/w^2 (wt - sin wt, 0, 1 - cos wt)`. Second order in both integrators.
#[test]
fn gravity_that_turns() {
    let (w, end) = (3.0_f64, 1.28_f64);
    let (sin, cos) = (w * end).sin_cos();
    let v = Vec3::new(1.0 - cos, 0.0, sin) * (-G / w);
    let x = Vec3::new(w * end - sin, 0.0, 1.0 - cos) * (-G / (w * w));
    for integrator in BOTH {
        let errors = [0.02, 0.01, 0.005].map(|dt| {
            let mut run = Case::new(dt, 0.0, 0.0)
                .settings(|s| {
                    s.integrator = integrator;
                    s.gravity_motion = GravityMotion::Rotation {
                        angular_velocity: Vec3::y() * w,
                    };
                })
                .sphere(0.1, Vec3::zeros(), Vec3::zeros())
                .start();
            run.steps((end / dt).round() as usize);
            [(run.position(0) - x).norm(), (run.velocity(0) - v).norm()]
        });
        second_order(errors, 0.03);
    }
}

/// Whatever gravity does and however steps are cut, the momentum changes by the impulse of the body force less that on
/// the boundaries; and what changing gravity does to the potential is booked: kinetic + potential - gravity's work
/// - dissipation is constant to second order.
#[test]
fn changing_gravity_balances() {
    let table = GravityMotion::Table {
        time: vec![0.0, 0.3, 0.31, 0.7],
        gravity: [
            [0.0, 0.0, -9.81],
            [3.0, 0.0, -9.81],
            [3.0, 0.0, 5.0],
            [0.0, 0.0, -9.81],
        ]
        .map(Vec3::from)
        .to_vec(),
    };
    let drift = [4e-3, 2e-3, 1e-3].map(|dt| {
        let mut run = Case::new(dt, 0.0, 0.0)
            .settings(|s| s.gravity_motion = table.clone())
            .floor()
            .sphere(0.1, Vec3::new(0.0, 0.0, 0.1), Vec3::zeros())
            .start();
        let energy = |run: &Run| {
            let energy = Energy::of(&Observation::of(&run.simulation));
            let work = run.simulation.work();
            energy.kinetic() + energy.potential() + work.friction + work.impact - work.gravity
        };
        let start = energy(&run);
        // Until it lifts off: its fall back is an impact.
        run.steps((0.3 / dt).round() as usize);
        assert!(run.force_on_boundary(0).z < -1.0);
        [(energy(&run) - start).abs() / (run.mass(0) * G)]
    });
    second_order(drift, 0.03);
}

/// Gravity set anew before every step, steps of changing length, and boundaries: `Run::advance` checks in each that the momentum
/// changes by the mean body force less the mean force on the floor.
#[test]
fn gravity_set_from_outside_balances() {
    let mut run = Case::new(4e-3, 0.3, 0.5)
        .floor()
        .sphere(0.1, Vec3::new(0.0, 0.0, 0.13), Vec3::x())
        .start();
    for (k, h) in [4e-3, 1e-2, 7e-3, 2e-3]
        .into_iter()
        .cycle()
        .take(60)
        .enumerate()
    {
        let angle = 0.3 * k as f64;
        let gravity = Vec3::new(3.0 * angle.sin(), 2.0 * angle.cos(), -9.81 + angle.sin());
        run.simulation.set_gravity(gravity).expect("a gravity");
        run.advance(h);
    }
}

/// A straight line in the world, seen from a frame that turns with W about p: `x = p + Q^T (x0 + v t - p)` with Q the turn
/// by W t, `dx/dt = Q^T v - W x (x - p)`. The spin in the world stays, so that in the frame it is `Q^T w - W`, and the
/// orientation `Q^T exp(w t)`. Second order in both integrators.
#[test]
fn free_flight_in_a_rotating_frame() {
    let frame = RotatingFrame {
        angular_velocity: Vec3::new(0.5, -1.0, 2.0),
        point: Vec3::new(0.3, 0.2, -0.1),
    };
    let rate = frame.angular_velocity;
    let (x0, v, spin) = (
        Vec3::new(1.0, 0.5, -0.2),
        Vec3::new(-0.7, 1.1, 0.4),
        Vec3::new(3.0, 1.0, -2.0),
    );
    let end = 1.28;
    let back = UnitQuaternion::from_scaled_axis(-rate * end);
    let x = frame.point + back * (x0 + v * end - frame.point);
    let seen = back * v - rate.cross(&(x - frame.point));
    let turned = back * UnitQuaternion::from_scaled_axis(spin * end);
    for integrator in BOTH {
        let errors = [0.02, 0.01, 0.005].map(|dt| {
            let start = v - rate.cross(&(x0 - frame.point));
            let mut run = Case::new(dt, 0.0, 0.0)
                .without_gravity()
                .settings(|s| {
                    s.integrator = integrator;
                    s.rotating_frame = Some(frame);
                })
                .body(0.1, x0, start, spin - rate, Locks::default())
                .start();
            run.steps((end / dt).round() as usize);
            let orientation = run.simulation.kinematics().orientation[0];
            [
                (run.position(0) - x).norm(),
                (run.velocity(0) - seen).norm(),
                (run.spin(0) - (back * spin - rate)).norm(),
                orientation.angle_to(&turned),
            ]
        });
        second_order(errors, 0.1);
    }
}

/// A sphere slides without friction inside a cylinder about y, in a frame that turns about a leaning axis: the energy of its
/// motion and of the centrifugal potential stays. Its error is of second order; what it grows by from the
/// first five seconds to the next, because the Coriolis force knows the last step's contact force, is of third order.
#[test]
fn energy_in_a_rotating_frame_does_not_drift() {
    let locks = Locks {
        translation: [false, true, false],
        rotation: [true; 3],
    };
    let errors = [0.01, 0.005, 0.0025].map(|dt| {
        let mut run = Case::new(dt, 0.0, 0.0)
            .without_gravity()
            .tolerance(1e-10, 1e-10, 1e-10)
            .settings(|s| {
                s.rotating_frame = Some(RotatingFrame {
                    angular_velocity: Vec3::new(1.0, 2.0, 0.5),
                    point: Vec3::new(0.2, 0.0, 0.1),
                });
            })
            .drum(1.0, 0.0)
            .body(0.1, Vec3::x() * 0.9, Vec3::z() * -2.0, Vec3::zeros(), locks)
            .start();
        let energy = |run: &Run| {
            let energy = Energy::of(&Observation::of(&run.simulation));
            (energy.kinetic() + energy.potential()) / run.mass(0)
        };
        let start = energy(&run);
        let half = (5.0 / dt).round() as usize;
        let worst = [(), ()].map(|()| {
            (0..half).fold(0.0, |worst: f64, _| {
                run.step();
                worst.max((energy(&run) - start).abs())
            })
        });
        [worst[1], worst[1] - worst[0]]
    });
    for pair in errors.windows(2) {
        assert!(pair[0][0] > 3.5 * pair[1][0], "{errors:?}");
        assert!(pair[0][1] > 7.0 * pair[1][1], "{errors:?}");
    }
    assert!(errors[2][1] < 5e-5, "{errors:?}");
}

/// A free clump of three moments in a frame that turns about a leaning axis: in the world its centre goes along a straight line, and
/// its angular momentum `Q J (w + W)` and energy stay, with Q the turn of the frame by W t. Its axes are those of the same clump in
/// the world, in an eighth of the step. Second order in both integrators; as seen from the frame the energy with the centrifugal potential
/// stays likewise.
#[test]
fn a_free_clump_in_a_rotating_frame() {
    let frame = RotatingFrame {
        angular_velocity: Vec3::new(0.5, -1.0, 2.0),
        point: Vec3::new(0.3, 0.2, -0.1),
    };
    let rate = frame.angular_velocity;
    let moments = Matrix3::from_diagonal(&Vec3::new(1.0, 1.8, 2.4)) * 1e-3;
    let centres = [Vec3::zeros(), Vec3::x() * 0.06, Vec3::y() * 0.05];
    let radii = [0.05, 0.04, 0.03];
    let (top, _) = ClumpShape::new(&centres, &radii, 2500.0, Some(1.3), Some(moments)).unwrap();
    let (x0, v, spin) = (
        Vec3::new(1.0, 0.5, -0.2),
        Vec3::new(-0.7, 1.1, 0.4),
        Vec3::new(1.0, 2.5, 3.0),
    );
    let (axes, end) = (UnitQuaternion::identity(), 1.28);
    let turn = UnitQuaternion::from_scaled_axis(rate * end);
    for integrator in BOTH {
        let free = |dt: f64| {
            Case::new(dt, 0.0, 0.0)
                .without_gravity()
                .settings(move |s| s.integrator = integrator)
        };
        let errors = [0.02, 0.01, 0.005].map(|dt| {
            let mut world = free(dt / 8.0).clump(&top, (x0, axes), v, spin).start();
            world.steps((end / dt).round() as usize * 8);
            let seen = v - rate.cross(&(x0 - frame.point));
            let mut own = free(dt)
                .settings(|s| s.rotating_frame = Some(frame))
                .clump(&top, (x0, axes), seen, spin - rate)
                .start();
            let energy = |run: &Run| {
                let energy = run.whole_energy();
                energy.kinetic() + energy.potential()
            };
            let start = energy(&own);
            own.steps((end / dt).round() as usize);
            let clump = &own.simulation.scene().clumps[0];
            let (centre, rotation) = clump.place(own.simulation.kinematics());
            let inertia =
                rotation.to_rotation_matrix() * moments * rotation.inverse().to_rotation_matrix();
            let angular = turn * (inertia * (own.spin(0) + rate));
            let (_, real) = clump.place(world.simulation.kinematics());
            [
                (turn * (centre - frame.point) + frame.point - (x0 + v * end)).norm(),
                (angular - moments * spin).norm() / (moments * spin).norm(),
                (turn * rotation).angle_to(&real),
                (energy(&own) - start).abs(),
            ]
        });
        second_order(errors, 0.15);
    }
}

/// Two spheres roll at the bottom of a drum of 0.5 m that turns with W about y; seen from the drum it rests and gravity turns
/// with -W about it. Both runs solve the same problem with different errors: they differ by O(dt) or less, and so do spins,
/// which differ by W, and the forces on the drum.
#[test]
fn a_drum_in_its_own_frame_is_a_turning_drum() {
    let orbit = 0.5 - 0.1;
    // Touching, a little up the side that moves up, as fast as the wall.
    let places = [0.1f64, 0.1 + 2.0 * (0.1f64 / orbit).asin()]
        .map(|angle| Vec3::new(-angle.sin(), 0.0, -angle.cos()) * orbit);
    in_its_own_frame(2, |case, rate| {
        places.iter().fold(case, |case, place| {
            case.body(0.1, *place, rate.cross(place), rate, Locks::default())
        })
    });
}

/// Likewise a dumbbell that leans on the drum with both its spheres.
#[test]
fn a_dumbbell_in_the_frame_of_its_drum_is_one_in_a_turning_drum() {
    let (orbit, half) = (0.5f64 - 0.1, 0.08f64);
    let centres = [Vec3::x() * -half, Vec3::x() * half];
    let (shape, _) = ClumpShape::new(&centres, &[0.1; 2], 2500.0, None, None).unwrap();
    let lean = UnitQuaternion::from_scaled_axis(Vec3::y() * 0.2);
    let centre = lean * Vec3::z() * -(orbit * orbit - half * half).sqrt();
    in_its_own_frame(2, |case, rate| {
        case.clump(&shape, (centre, lean), rate.cross(&centre), rate)
    });
}

/// Places `spheres` spheres with the velocities of a drum of 0.5 m which turns at `W` \[rad/s\], and compares the turning drum with
/// the drum in its own frame.
fn in_its_own_frame(spheres: usize, place: impl Fn(Case, Vec3) -> Case) {
    let (rate, end) = (Vec3::y() * 2.0, 0.6);
    let errors = [4e-3, 2e-3, 1e-3, 5e-4].map(|dt| {
        let case = || Case::new(dt, 0.4, 0.0).tolerance(1e-9, 1e-9, 1e-8);
        let turning = place(case().drum(0.5, rate.y), rate);
        let own = place(case().drum(0.5, 0.0), Vec3::zeros()).settings(|s| {
            s.gravity_motion = GravityMotion::Rotation {
                angular_velocity: -rate,
            };
            s.rotating_frame = Some(RotatingFrame {
                angular_velocity: rate,
                point: Vec3::zeros(),
            });
        });
        let (mut turning, mut own) = (turning.start(), own.start());
        let starts: Vec<Vec3> = (0..spheres).map(|i| turning.position(i)).collect();
        let (mut worst, mut far) = ([0.0_f64; 3], 0.0_f64);
        for k in 1..=(end / dt).round() as usize {
            turning.step();
            own.step();
            let turn = UnitQuaternion::from_scaled_axis(rate * (k as f64 * dt));
            for (i, start) in starts.iter().enumerate() {
                let place = (turn * own.position(i) - turning.position(i)).norm();
                let spin = (turn * (own.spin(i) + rate) - turning.spin(i)).norm();
                far = far.max((turning.position(i) - start).norm());
                worst = [worst[0].max(place), worst[1].max(spin), worst[2]];
            }
        }
        let weight = G * (0..spheres).map(|i| turning.mass(i)).sum::<f64>();
        let turn = UnitQuaternion::from_scaled_axis(rate * (end - dt));
        let force = turn * own.force_on_boundary(0) - turning.force_on_boundary(0);
        worst[2] = force.norm() / weight;
        assert!(far > 0.03, "they move by {far} m");
        worst
    });
    for pair in errors.windows(2) {
        let smaller = pair[0].iter().zip(&pair[1]).all(|(a, b)| *b < 0.62 * a);
        assert!(smaller, "{errors:?}");
    }
    assert!(errors[3][0] < 1e-4, "{errors:?}");
}
