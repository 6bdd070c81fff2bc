//! Solvers against each other and against closed forms, on one problem at a time.

use sphere_dda::Vec3;
use sphere_dda::geometry::HalfSpace;
use sphere_dda::linalg::LinearError;
use sphere_dda::problem::{GROUND, Law, Problem, Row};
use sphere_dda::scene::body::{Area, Joint, Servo};
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::augmented_lagrangian::SolverWorkspace;
use sphere_dda::solver::residual::{Scale, evaluate};
use sphere_dda::solver::{Params, Report, SMOOTHING, newton, solve};
use sphere_dda::solver::{SolverKind, Tolerance};
use sphere_dda::spatial::SpatialVector;

use crate::support::{self, Case};

const R: f64 = 0.1;
const DT: f64 = 1e-3;

fn body(velocity: Vec3) -> (SpatialVector, SpatialVector) {
    let mass = 2.0;
    let inertia = 0.4 * mass * R * R;
    let free = SpatialVector {
        linear: velocity,
        angular: Vec3::zeros(),
    };
    let inverse = SpatialVector {
        linear: Vec3::repeat(1.0 / mass),
        angular: Vec3::repeat(1.0 / inertia),
    };
    (free, inverse)
}

fn row(a: u32, b: u32, normal: Vec3, mu: f64) -> Row {
    Row {
        a,
        b,
        normal,
        arm_a: normal * -R,
        arm_b: if b == GROUND {
            Vec3::zeros()
        } else {
            normal * R
        },
        prescribed_velocity: Vec3::zeros(),
        bias: Vec3::zeros(),
        compliance_n: 0.0,
        compliance_t: 0.0,
        law: Law::Contact { mu },
        radius: R,
        impulse_scale: 2.0 * 9.81 * DT,
    }
}

/// A leaning pyramid of ten spheres on the ground, pushed sideways: sticking and slipping contacts.
fn pyramid(mu: f64) -> Problem {
    let mut problem = Problem {
        step: DT,
        ..Problem::default()
    };
    let side = 2.0 * R;
    let mut centres = Vec::new();
    for (layer, n) in [(0, 3), (1, 2), (2, 1)] {
        for i in 0..n {
            for j in 0..n - i {
                let x = side * (f64::from(i) + 0.5 * f64::from(j));
                let y = side * (3f64.sqrt() / 2.0 * f64::from(j));
                let shift = f64::from(layer) * side;
                let z = shift * (2.0f64 / 3.0).sqrt();
                centres.push(Vec3::new(
                    x + 0.5 * shift,
                    y + shift / (2.0 * 3f64.sqrt()),
                    z,
                ));
            }
        }
    }
    for (i, c) in centres.iter().enumerate() {
        let (free, inverse) = body(Vec3::new(0.02, 0.01 * i as f64, -9.81 * DT));
        problem.free.push(free);
        problem.inverse_mass.push(inverse);
        for (j, d) in centres.iter().enumerate().skip(i + 1) {
            let distance = c - d;
            if distance.norm() < 1.0001 * side {
                problem
                    .rows
                    .push(row(i as u32, j as u32, distance.normalize(), mu));
            }
        }
        if c.z == 0.0 {
            problem.rows.push(row(i as u32, GROUND, Vec3::z(), mu));
        }
    }
    problem
}

/// The pyramid with resistance to rolling and twisting at every contact.
fn stiff_pyramid(mu: f64, rolling: f64, twisting: f64) -> Problem {
    let mut problem = pyramid(mu);
    for (velocity, k) in problem.free.iter_mut().zip(0..) {
        velocity.angular = Vec3::new(0.3, -0.2, 0.1 * f64::from(k));
    }
    for k in 0..problem.rows.len() {
        problem.rows.push(Row {
            law: Law::Resistance {
                contact: k as u32,
                rolling,
                twisting,
            },
            ..problem.rows.get(k)
        });
    }
    problem
}

fn solved(problem: &Problem, kind: SolverKind) -> (Vec<Vec3>, Report) {
    let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
    let workspace = &mut SolverWorkspace::default();
    let report = solve(problem, &params(kind), workspace, &mut impulses);
    assert!(report.converged, "{kind:?}: {report:?}");
    (impulses, report)
}

fn params(kind: SolverKind) -> Params {
    Params {
        kind,
        tolerance: Tolerance {
            gap: 1e-11,
            slip: 1e-11,
            force: 1e-9,
        },
        accept: false,
        min_sweeps: 1,
        max_sweeps: 100_000,
        max_factorizations: 2000,
        penalty: 1e5,
        adapt_penalty: true,
        smoothing: SMOOTHING,
    }
}

/// Both solvers meet the same conditions and move the bodies alike, with and without friction.
#[test]
fn solvers_agree_on_a_pushed_pyramid() {
    for mu in [0.0, 0.2, 0.6] {
        let problem = pyramid(mu);
        let [a, b] = [SolverKind::GaussSeidel, SolverKind::Direct].map(|kind| {
            let (impulses, _) = solved(&problem, kind);
            problem.velocities(&impulses)
        });
        for (a, b) in a.iter().zip(&b) {
            assert!(
                (a.linear - b.linear).norm() < 1e-8,
                "{:?} {:?}",
                a.linear,
                b.linear
            );
        }
    }
}

/// With resistance to rolling and twisting as well: all three solvers, rows that stick and rows at their limits, the
/// couples within them and against the motion.
#[test]
fn solvers_agree_on_a_pyramid_that_resists_rolling() {
    let [mut held, mut limited] = [0; 2];
    for (mu, rolling, twisting) in [
        (0.2, 0.05, 0.02),
        (0.6, 0.1, 0.0),
        (0.6, 0.0, 0.3),
        (0.6, 0.6, 0.2),
    ] {
        let problem = stiff_pyramid(mu, rolling, twisting);
        let (impulses, _) = solved(&problem, SolverKind::GaussSeidel);
        let expected = problem.velocities(&impulses);
        let (by_direct, _) = solved(&problem, SolverKind::Direct);
        let mut by_newton = vec![Vec3::zeros(); problem.rows.len()];
        let params = params(SolverKind::Auto);
        let report = newton::solve(&problem, &params, &mut by_newton).unwrap();
        assert!(report.converged, "{report:?}");
        for other in [by_direct, by_newton] {
            for (a, b) in expected.iter().zip(&problem.velocities(&other)) {
                let error = (a.linear - b.linear).norm() + R * (a.angular - b.angular).norm();
                assert!(error < 1e-8, "{a:?} {b:?}");
            }
        }
        let contacts = problem.rows.len() / 2;
        for k in contacts..problem.rows.len() {
            let n = problem.rows.normal(k);
            let pressure = impulses[k - contacts].dot(&n);
            let p = impulses[k];
            let across = p - n * p.dot(&n);
            assert!(across.norm() <= rolling * pressure * (1.0 + 1e-9) + 1e-15);
            assert!(p.dot(&n).abs() <= twisting * pressure * (1.0 + 1e-9) + 1e-15);
            let u = problem.rows.get(k).relative_velocity(&expected);
            assert!(p.dot(&u) <= 1e-12, "it takes energy");
            if pressure > 0.0 && rolling > 0.0 {
                let full = across.norm() > rolling * pressure * (1.0 - 1e-6);
                if full { limited += 1 } else { held += 1 }
            }
        }
    }
    assert!(held > 0 && limited > 0, "{held} {limited}");
}

/// Newton's finish on a part of the problem: beside a pyramid at rest, whose rows come first, another one is pushed.
#[test]
fn a_part_that_resists_rolling_is_finished() {
    let pushed = stiff_pyramid(0.6, 0.1, 0.05);
    let contacts = pushed.rows.len() / 2;
    let mut both = pushed.clone();
    for free in &mut both.free {
        *free = SpatialVector::ZERO;
    }
    both.free.extend(&pushed.free);
    both.inverse_mass.extend(&pushed.inverse_mass);
    let bodies = pushed.free.len() as u32;
    let moved = |row: Row| Row {
        a: row.a + bodies,
        b: if row.b == GROUND {
            GROUND
        } else {
            row.b + bodies
        },
        ..row
    };
    let rows: Vec<Row> = pushed.rows.iter().collect();
    let (touching, resistances) = rows.split_at(contacts);
    both.rows.truncate(contacts);
    both.rows.extend(touching.iter().map(|row| moved(*row)));
    both.rows.extend(resistances.iter().copied());
    both.rows.extend(resistances.iter().map(|&row| {
        let Law::Resistance {
            contact,
            rolling,
            twisting,
        } = row.law
        else {
            panic!("a resistance");
        };
        Row {
            law: Law::Resistance {
                contact: contact + contacts as u32,
                rolling,
                twisting,
            },
            ..moved(row)
        }
    }));
    let mut impulses = vec![Vec3::zeros(); both.rows.len()];
    let brief = Params {
        max_sweeps: 2,
        ..params(SolverKind::Auto)
    };
    let report = solve(
        &both,
        &brief,
        &mut SolverWorkspace::default(),
        &mut impulses,
    );
    assert!(report.converged && report.factorizations > 0, "{report:?}");
    let (alone, _) = solved(&pushed, SolverKind::GaussSeidel);
    let velocities = both.velocities(&impulses);
    let (still, pushed) = (&velocities[..10], pushed.velocities(&alone));
    assert!(still.iter().all(|v| v.linear.norm() < 1e-12));
    for (a, b) in velocities[10..].iter().zip(&pushed) {
        assert!((a.linear - b.linear).norm() + R * (a.angular - b.angular).norm() < 1e-8);
    }
}

/// The residual sees each way of being wrong: overlap, pull, friction beyond the cone, slip while sticking.
#[test]
fn residual_judges() {
    let mut problem = Problem {
        step: DT,
        ..Problem::default()
    };
    let (free, inverse) = body(Vec3::new(0.01, 0.0, -0.1));
    problem.free.push(free);
    problem.inverse_mass.push(inverse);
    problem.rows.push(row(0, GROUND, Vec3::z(), 0.5));
    let scales = Scale::of(&problem);
    let residual = |p: Vec3| evaluate(&problem, &scales, &[p]);
    // Closed form: p_n = m 0.1 stops the approach, the surface sticks with p_t = -2/7 m 0.01.
    let exact = Vec3::new(-2.0 * 0.01 / 3.5, 0.0, 0.2);
    let right = residual(exact);
    assert!(
        right.gap < 1e-15 && right.slip < 1e-15 && right.force < 1e-13,
        "{right:?}"
    );
    let open = residual(Vec3::zeros());
    assert!(
        (open.gap - 0.1 * DT / R).abs() < 1e-15,
        "overlap of v dt over R: {open:?}"
    );
    assert!(
        residual(exact + Vec3::z() * 0.02).gap > 9e-5,
        "a contact that pulls away under load"
    );
    assert!(
        residual(exact - Vec3::x() * 0.2).slip > 1e-4,
        "friction beyond the cone"
    );
    let sliding = residual(Vec3::new(0.0, 0.0, 0.2));
    assert!(
        (sliding.slip - 0.01 * DT / R).abs() < 1e-15,
        "slip while it could stick: {sliding:?}"
    );
}

/// Work is pinned, not time: sweeps and factorizations on the pyramid.
#[test]
fn iteration_counts_are_pinned() {
    let problems = [pyramid(0.2), stiff_pyramid(0.2, 0.05, 0.02)];
    let counts = problems.iter().flat_map(|problem| {
        [SolverKind::GaussSeidel, SolverKind::Direct].map(|kind| {
            let (_, report) = solved(problem, kind);
            format!(
                "{} sweeps, {} augmentations, {} factorizations",
                report.sweeps, report.augmentations, report.factorizations
            )
        })
    });
    insta::assert_snapshot!(counts.collect::<Vec<_>>().join("\n"), @r"
    39 sweeps, 0 augmentations, 0 factorizations
    0 sweeps, 2 augmentations, 4 factorizations
    38 sweeps, 0 augmentations, 0 factorizations
    0 sweeps, 1 augmentations, 3 factorizations
    ");
}

/// A force that nothing loads is judged by what acts elsewhere: without gravity spheres at rest are pressed by a piston with
/// `F` alone, and the scale of their forces is `m F/(2 m + M) dt`.
#[test]
fn forces_without_gravity_have_a_scale() {
    const FORCE: f64 = 30.0;
    let mut piston = support::body(
        4.0,
        Vec3::z() * 0.4,
        Vec3::zeros(),
        Joint::Slide { axis: Vec3::z() },
    );
    piston.servo = Some(Servo {
        pressure: -FORCE,
        area: Area::Constant(1.0),
        input: false,
    });
    let lid = HalfSpace::new(Vec3::z() * 0.4, -Vec3::z()).expect("a plane");
    let case = Case::new(DT, 0.3, 0.0)
        .without_gravity()
        .floor()
        .driven(vec![lid.into()], piston)
        .sphere(R, Vec3::z() * R, Vec3::zeros())
        .sphere(R, Vec3::z() * 3.0 * R, Vec3::zeros());
    let run = case.start();
    assert_eq!(run.simulation.contacts().len(), 3);
    for contact in run.simulation.contacts() {
        support::close(contact.force.norm(), FORCE, 1e-6, 0.0);
    }
    let (problem, _) = run.simulation.problem(DT).expect("a problem");
    let mass = run.mass(0);
    let expected = mass * FORCE / (2.0 * mass + 4.0) * DT;
    let between = problem
        .rows
        .iter()
        .find(|row| row.b == 1 || row.a == 1 && row.b == 0);
    support::close(
        between.expect("the pair").impulse_scale,
        expected,
        1e-9,
        0.0,
    );
}

/// A row without any scale reports how far it is off as a share of itself, not as a number beyond all bounds.
#[test]
fn a_residual_without_scale_is_a_share() {
    let mut problem = pyramid(0.3);
    problem.rows.truncate(1);
    problem.rows.update(0, |row| row.impulse_scale = 0.0);
    for free in &mut problem.free {
        *free = SpatialVector::ZERO;
    }
    let scales = Scale::of(&problem);
    let pushed = [problem.rows.normal(0) * 1e-60];
    let found = evaluate(&problem, &scales, &pushed);
    assert_eq!(found.force, 1.0, "{found:?}");
    assert_eq!(evaluate(&problem, &scales, &[Vec3::zeros()]).force, 0.0);
}

/// What ends the direct solver early is in its report, and the impulses it was given are not made worse.
#[test]
fn a_broken_factorization_is_reported() {
    let problem = pyramid(0.2);
    let start: Vec<Vec3> = problem.rows.iter().map(|row| row.normal * 1e-3).collect();
    let mut impulses = start.clone();
    // A negative penalty makes the matrix indefinite; without sweeps between Newton does not finish.
    let params = Params {
        penalty: -1e9,
        smoothing: 0,
        ..params(SolverKind::Direct)
    };
    let report = solve(
        &problem,
        &params,
        &mut SolverWorkspace::default(),
        &mut impulses,
    );
    let rows = 6 * problem.free.len();
    assert_eq!(
        report.broken,
        Some(LinearError::NotPositiveDefinite { rows })
    );
    assert!(!report.converged && impulses == start, "{report:?}");

    let case = Case::new(DT, 0.3, 0.0).floor().settings(|s| {
        s.solver = SolverKind::Direct;
        s.penalty = Some(-1e9);
        s.adapt_penalty = false;
    });
    let case = case.sphere(R, Vec3::z() * R, Vec3::zeros());
    let error = Simulation::new(std::sync::Arc::new(case.scene)).expect_err("it cannot start");
    let message = error.to_string();
    assert!(message.contains("not positive definite"), "{message}");
}

/// Steps that the direct solver does not finish end with the best impulses it met: more work never makes them worse.
#[test]
fn more_work_leaves_no_larger_residual() {
    let problem = stiff_pyramid(0.6, 0.3, 0.2);
    let mut last = f64::INFINITY;
    for max_factorizations in 1..30 {
        let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
        let params = Params {
            max_factorizations,
            smoothing: 0,
            penalty: 1e9,
            ..params(SolverKind::Direct)
        };
        solve(
            &problem,
            &params,
            &mut SolverWorkspace::default(),
            &mut impulses,
        );
        let excess = evaluate(&problem, &Scale::of(&problem), &impulses).excess(&params.tolerance);
        assert!(
            excess <= last,
            "{max_factorizations}: {excess:e} after {last:e}"
        );
        last = excess;
    }
}
