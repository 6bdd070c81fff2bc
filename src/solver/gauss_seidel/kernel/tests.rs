//! Blocks against rows one by one.

#![cfg(test)]

use super::*;
use crate::problem::{GROUND, Law, Row};
use crate::solver::gauss_seidel::batch::PLAIN;
use crate::solver::residual::{Scale, evaluate};
use crate::spatial::SpatialOperator;
use nalgebra::{Matrix3, Vector3};

/// A row of spheres of different sizes on the ground, pushed, with one that has springs; most contacts have a resistance.
fn problem() -> Problem {
    let mut problem = Problem {
        step: 1e-3,
        ..Problem::default()
    };
    let radius = |i: usize| 0.01 * (1.0 + 0.1 * (i % 4) as f64);
    for i in 0..23 {
        let x = i as f64;
        let mass = 2e4 * radius(i).powi(3);
        problem.free.push(SpatialVector {
            linear: Vector3::new(0.3 - 0.05 * x, 0.1 * (x * 1.7).sin(), -0.1),
            angular: Vector3::new((x * 0.9).cos(), 0.5, (x * 2.3).sin()),
        });
        let inverse = 1.0 / (0.4 * mass * radius(i) * radius(i));
        problem.inverse_mass.push(SpatialVector {
            linear: Vector3::repeat(1.0 / mass),
            angular: Vector3::repeat(inverse),
        });
    }
    for a in 0..23_u32 {
        for b in [a + 1, GROUND] {
            if b == 23 {
                continue;
            }
            let normal = if b == GROUND {
                Vector3::z()
            } else {
                -Vector3::new(1.0, 0.1, 0.05 * f64::from(a % 3)).normalize()
            };
            let [ra, rb] = [a, b.min(22)].map(|i| radius(i as usize));
            problem.rows.push(Row {
                a,
                b,
                normal,
                arm_a: normal * if a == 7 { -1.1 * ra } else { -ra },
                arm_b: if b == GROUND {
                    Vec3::zeros()
                } else {
                    normal * rb
                },
                prescribed_velocity: Vec3::zeros(),
                bias: normal * 0.01,
                compliance_n: if a == 11 { 0.1 } else { 0.0 },
                compliance_t: if a == 11 { 0.2 } else { 0.0 },
                law: Law::Contact { mu: 0.3 },
                radius: ra.min(rb),
                impulse_scale: 1e-4,
            });
        }
    }
    for contact in (0..problem.rows.len()).filter(|k| k % 5 != 3) {
        let row = problem.rows.get(contact);
        let turning = Vec3::new(0.02, -0.01, 0.005 * f64::from(row.a % 3));
        problem.rows.push(resistance(contact, row, turning));
    }
    problem
}

/// With three bodies of any inertia, on the ground, on spheres and on each other, of which one slides along a line; a sphere that is
/// locked in one direction, a spring, and a resistance that has a spring.
fn with_clumps(mut problem: Problem) -> Problem {
    problem.inverse_mass[15].linear.y = 0.0;
    let mut spring = problem.rows.get(0);
    (spring.law, spring.compliance_n, spring.compliance_t) = (Law::Bilateral, 30.0, 30.0);
    problem.rows.push(spring);
    problem.rows.update_all(|_, row| {
        if let Law::Resistance { contact: 4, .. } = row.law {
            row.compliance_t = 20.0;
        }
    });
    for d in 0..3_u32 {
        let turned = Matrix3::new(3.0, 0.5, -0.2, 0.5, 2.0, 0.4, -0.2, 0.4, 1.5);
        let along = Vec3::new(0.6, 0.0, 0.8);
        problem.operators.push(SpatialOperator {
            linear: match d {
                2 => along * along.transpose() * 40.0,
                d => Matrix3::identity() * (40.0 + f64::from(d)),
            },
            angular: turned * 1e5,
        });
        problem.free.push(SpatialVector {
            linear: Vector3::new(0.1, -0.2, -0.5 - 0.05 * f64::from(d)),
            angular: Vector3::new(1.0, 2.0, -3.0),
        });
        for (k, b) in [GROUND, 6 * d, 23 + (d + 1) % 3].into_iter().enumerate() {
            let k = k as f64;
            let normal = Vector3::new(0.3 * k, -0.2, 1.0).normalize();
            let arm_b = match b {
                GROUND => Vec3::zeros(),
                b if b < 23 => normal * 0.01 * (1.0 + 0.1 * f64::from(b % 4)),
                _ => Vec3::new(0.004, 0.005, 0.009),
            };
            problem.rows.push(Row {
                a: 23 + d,
                b,
                normal,
                arm_a: Vec3::new(-0.003 * k, 0.006, -0.01),
                arm_b,
                prescribed_velocity: match b {
                    GROUND => Vec3::new(0.02, 0.01, 0.0),
                    _ => Vec3::zeros(),
                },
                bias: normal * 0.01,
                compliance_n: 0.05 * k,
                compliance_t: 0.02 * k,
                law: Law::Contact { mu: 0.4 },
                radius: 0.01,
                impulse_scale: 1e-4,
            });
            let contact = problem.rows.len() - 1;
            if contact % 3 != 1 {
                let turning = Vec3::new(0.02, -0.01, 0.005 * k);
                let row = resistance(contact, problem.rows.get(contact), turning);
                problem.rows.push(row);
            }
        }
    }
    problem
}

/// A resistance of the contact that is row `contact`.
fn resistance(contact: usize, row: Row, turning: Vec3) -> Row {
    Row {
        arm_a: Vec3::zeros(),
        arm_b: Vec3::zeros(),
        prescribed_velocity: match row.b {
            GROUND => turning,
            _ => Vec3::zeros(),
        },
        bias: Vec3::zeros(),
        compliance_n: 0.0,
        compliance_t: 0.0,
        law: Law::Resistance {
            contact: contact as u32,
            rolling: 0.05 * (contact % 3) as f64,
            twisting: 0.02 * (contact % 4) as f64,
        },
        ..row
    }
}

/// A sweep without momentum.
fn plain_sweep() -> SweepParams {
    SweepParams {
        momentum: 0.0,
        damping: 1.0,
        strictness: 1.0,
        tolerance: Tolerance::default(),
    }
}

/// The oracle is the row's own operations, one row after the other in the order of the blocks.
#[test]
fn blocks_do_what_rows_do_one_after_the_other() {
    let problem = with_clumps(problem());
    let start: Vec<Vec3> = (0..problem.rows.len())
        .map(|k| problem.rows.normal(k) * (1e-4 * (k % 5) as f64))
        .collect();
    let pace = SweepParams {
        damping: 0.8,
        ..plain_sweep()
    };
    let mut kernel = Kernel::default();
    kernel.compile(&problem, &Tolerance::default(), &start);
    assert_eq!(
        kernel.others.places().len(),
        3,
        "a spring, and a contact with a resistance that has one"
    );
    assert!(!kernel.single);
    let levered: u32 = (kernel.exact.blocks.iter())
        .filter(|block| block.levers != PLAIN)
        .map(|block| block.count)
        .sum();
    let of_spheres = 5;
    assert_eq!(
        levered,
        9 + of_spheres,
        "those of clumps, and of two spheres"
    );
    let blocks = kernel.exact.blocks.iter().zip(&kernel.contents.rows);
    let rows = blocks.flat_map(|(block, rows)| &rows[..block.count as usize]);
    let with_resistance = |&k: &u32| [Some(k), kernel.kinds.resistance(k)];
    let mut order: Vec<u32> = rows.flat_map(with_resistance).flatten().collect();
    assert!(order.len() > problem.rows.len() / 2 + 8);
    order.extend(kernel.others.places());
    let mut sorted = order.clone();
    sorted.sort_unstable();
    assert!(sorted.into_iter().eq(0..problem.rows.len() as u32));

    let mut expected = start.clone();
    let mut velocity = problem.velocities(&start);
    let mut found = start;
    for sweep in 0..3 {
        let progress = kernel.sweep(&problem, pace);
        kernel.store(&problem, &mut found);
        let mut change = 0.0;
        for &k in &order {
            let row = &problem.rows.get(k as usize);
            let load = row.load(&problem.rows, &expected);
            let p = &mut expected[k as usize];
            let scale = Scale::of_row(&problem, row);
            let natural_map = scale.natural_map(row, row.relative_velocity(&velocity), *p, load);
            let full = row.normal * natural_map.normal + natural_map.tangential;
            change += full.norm_squared();
            *p += full * pace.damping;
            problem.apply(row, &mut velocity, full * pace.damping);
        }
        for (k, (p, q)) in found.iter().zip(&expected).enumerate() {
            assert!((p - q).norm() < 1e-15, "sweep {sweep}, row {k}: {p} {q}");
        }
        assert!((progress.change - change).abs() < 1e-9 * change);
        assert!(!progress.settled);
        let judged = kernel.judge(&problem);
        let common = evaluate(&problem, &Scale::of(&problem), &found);
        let same = |a: f64, b: f64| assert!((a - b).abs() < 1e-9 * b.abs(), "{a} {b}");
        same(judged.gap, common.gap);
        same(judged.slip, common.slip);
        same(judged.force, common.force);
        same(judged.active_set_closeness, common.active_set_closeness);
        assert_eq!(judged.worst, common.worst);
    }
}

/// With a plate of 1.4 kg in the place of the ground.
fn on_plate(mut problem: Problem) -> Problem {
    let plate = 23;
    let angular = Matrix3::new(3.0, 0.5, -0.2, 0.5, 2.0, 0.4, -0.2, 0.4, 1.5) * 4.0;
    problem.operators.push(SpatialOperator {
        linear: Matrix3::identity() * 0.7,
        angular,
    });
    problem.free.push(SpatialVector {
        linear: Vector3::new(0.1, 0.0, 0.05),
        angular: Vector3::new(0.1, -0.2, 0.3),
    });
    problem.rows.update_all(|_, row| {
        if row.b == GROUND {
            let arm = Vec3::new(0.05 * f64::from(row.a % 5) - 0.1, 0.03, 0.002);
            (row.b, row.arm_b, row.prescribed_velocity) = (plate, arm, Vec3::zeros());
        }
    });
    problem
}

/// Contacts of a block share a heavy body as if each had its own part of the mass, and the whole had the mean of the parts' velocities:
/// those with resistances or springs of their own in blocks that have levers, the others apart.
#[test]
fn a_shared_body_is_the_mean_of_its_parts() {
    let (mut problem, plate) = (on_plate(problem()), 23);
    problem.rows.update(33, |row| row.arm_a *= 1.1);
    let mut found: Vec<Vec3> = (0..problem.rows.len())
        .map(|k| problem.rows.normal(k) * (1e-4 * (k % 5) as f64))
        .collect();
    let mut expected = found.clone();
    let mut kernel = Kernel::default();
    kernel.compile(&problem, &Tolerance::default(), &found);
    let (mut velocity, mut shared, mut on_heavy) = (problem.velocities(&found), 0, 0);
    for sweep in 0..3 {
        kernel.sweep(&problem, plain_sweep());
        kernel.store(&problem, &mut found);
        for (block, rows) in kernel.exact.blocks.iter().zip(&kernel.contents.rows) {
            let rows = &rows[..block.count as usize];
            let touches = |k: &&u32| problem.rows.bodies(**k as usize)[1] == plate;
            let parts = rows.iter().filter(touches).count().max(1) as f64;
            match block.heavy {
                PLAIN => shared = shared.max(parts as usize),
                _ => on_heavy = on_heavy.max(parts as usize),
            }
            let mut split = problem.clone();
            split.operators[0].linear *= parts;
            split.operators[0].angular *= parts;
            let whole = velocity[plate as usize];
            let mut change = SpatialVector::ZERO;
            for &k in rows {
                velocity[plate as usize] = whole;
                for k in [Some(k), kernel.kinds.resistance(k)].into_iter().flatten() {
                    let row = split.rows.get(k as usize);
                    let load = row.load(&split.rows, &expected);
                    let p = &mut expected[k as usize];
                    let scale = Scale::of_row(&split, &row);
                    let map = scale.natural_map(&row, row.relative_velocity(&velocity), *p, load);
                    let full = row.normal * map.normal + map.tangential;
                    *p += full;
                    split.apply(&row, &mut velocity, full);
                }
                let part = velocity[plate as usize];
                change = change.plus(&part, 1.0 / parts).plus(&whole, -1.0 / parts);
            }
            velocity[plate as usize] = whole.plus(&change, 1.0);
        }
        for (k, (p, q)) in found.iter().zip(&expected).enumerate() {
            assert!((p - q).norm() < 1e-14, "sweep {sweep}, row {k}: {p} {q}");
        }
        let judged = kernel.judge(&problem);
        let common = evaluate(&problem, &Scale::of(&problem), &found);
        assert!((judged.slip - common.slip).abs() < 1e-9 * common.slip);
        assert!((judged.force - common.force).abs() < 1e-9 * common.force);
    }
    for shared in [shared, on_heavy] {
        assert!(shared > 3, "{shared} contacts of a block share the plate");
    }
}

/// Of a problem that has been solved before nothing stays that is not so of the next one.
#[test]
fn a_kernel_that_goes_on_is_a_new_one() {
    let first = on_plate(problem());
    let lighter = |factor: f64| {
        let mut problem = first.clone();
        problem.operators[0].linear *= factor;
        problem
    };
    let mut locked = first.clone();
    locked.inverse_mass[4].linear.z = 0.0;
    let (mut springs, mut arms) = (first.clone(), first.clone());
    springs.rows.update_all(|_, row| {
        if let Law::Resistance { contact: 4 | 5, .. } = row.law {
            row.compliance_t = 20.0;
        }
    });
    arms.rows.update_all(|k, row| {
        if k == 8 {
            row.arm_a *= 1.2;
        }
    });
    let mut others = first.clone();
    others.rows.update_all(|_, row| {
        if let Law::Resistance { contact, .. } = &mut row.law {
            *contact = match *contact {
                0 => 2,
                2 => 0,
                other => other,
            };
        }
    });
    let pace = plain_sweep();
    let solved = |kernel: &mut Kernel, problem: &Problem| {
        let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
        kernel.compile(problem, &Tolerance::default(), &impulses);
        for _ in 0..3 {
            kernel.sweep(problem, pace);
        }
        kernel.store(problem, &mut impulses);
        impulses
    };
    let (few, fewer) = (lighter(3.0), lighter(6.0));
    let all = [&first, &few, &fewer, &locked, &springs, &arms, &others];
    for (j, before) in all.into_iter().enumerate() {
        for (k, problem) in all.into_iter().enumerate() {
            let mut kernel = Kernel::default();
            solved(&mut kernel, before);
            let found = solved(&mut kernel, problem);
            let expected = solved(&mut Kernel::default(), problem);
            assert_eq!(found, expected, "problem {k} after problem {j}");
        }
    }
}

/// Contacts of clumps in single precision: the impulses of double precision but for its rounding.
#[test]
fn clumps_in_single_precision_differ_by_rounding() {
    let problem = with_clumps(problem());
    let loose = Tolerance {
        gap: 1e-4,
        slip: 1e-4,
        force: 0.1,
    };
    let pace = SweepParams {
        tolerance: loose,
        ..plain_sweep()
    };
    let found = [loose, Tolerance::default()].map(|tolerance| {
        let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
        let mut kernel = Kernel::default();
        kernel.compile(&problem, &tolerance, &impulses);
        assert_eq!(kernel.single, tolerance == loose);
        for _ in 0..4 {
            kernel.sweep(&problem, pace);
        }
        kernel.store(&problem, &mut impulses);
        impulses
    });
    let [single, double] = found;
    let largest = double.iter().map(Vec3::norm).fold(0.0, f64::max);
    let mut loaded = 0;
    for (k, (p, q)) in single.iter().zip(&double).enumerate() {
        assert!((p - q).norm() < 1e-5 * largest, "row {k}: {p} {q}");
        let levered = problem.rows.bodies(k)[0] >= 23;
        loaded += usize::from(levered && *q != Vec3::zeros());
    }
    assert!(loaded >= 6, "{loaded} of 9 contacts of clumps carry");
}

/// Alone, resistances are the worst rows: their slip and force come out as in the common residual.
#[test]
fn resistances_are_judged_as_by_the_common_residual() {
    let mut problem = problem();
    problem.rows.update_all(|k, row| {
        row.compliance_n = 0.0;
        if let Law::Contact { mu } = &mut row.law {
            // Nothing slips: what remains is rolling.
            (*mu, row.bias) = (if k % 2 == 0 { 1e9 } else { 0.0 }, row.normal * 1e-12);
        }
    });
    let mut impulses: Vec<Vec3> = (0..problem.rows.len()).map(|_| Vec3::zeros()).collect();
    for (k, row) in problem.rows.iter().enumerate() {
        if matches!(row.law, Law::Contact { .. }) {
            impulses[k] = row.normal * 1e-4;
        }
    }
    let mut kernel = Kernel::default();
    kernel.compile(&problem, &Tolerance::default(), &impulses);
    let pace = plain_sweep();
    for _ in 0..40 {
        kernel.sweep(&problem, pace);
        let judged = kernel.judge(&problem);
        kernel.store(&problem, &mut impulses);
        let common = evaluate(&problem, &Scale::of(&problem), &impulses);
        assert!((judged.slip - common.slip).abs() <= 1e-6 * common.slip + 1e-15);
        assert!((judged.force - common.force).abs() <= 1e-6 * common.force + 1e-12);
    }
}

/// What two sweeps leave and momentum moves is the same in impulses and velocities.
#[test]
fn momentum_moves_impulses_and_velocities_together() {
    let problem = problem();
    let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
    let mut kernel = Kernel::default();
    kernel.compile(&problem, &Tolerance::default(), &impulses);
    for k in 0..20 {
        let momentum = if k < 3 { 0.0 } else { 0.7 };
        let pace = SweepParams {
            momentum,
            ..plain_sweep()
        };
        kernel.sweep(&problem, pace);
    }
    kernel.store(&problem, &mut impulses);
    let velocity = problem.velocities(&impulses);
    for (i, v) in velocity.iter().enumerate() {
        let body = &kernel.exact.bodies[kernel.seats.places()[i] as usize].0;
        let (linear, spin) = (v.linear, v.angular * spin_scale(&kernel.radius, i));
        for k in 0..3 {
            assert!((body[k] - linear[k]).abs() < 1e-12);
            assert!((body[k + 4] - spin[k]).abs() < 1e-12);
        }
    }
    kernel.judge(&problem);
    let mut judged = Vec::new();
    kernel.velocities_into(&problem, &mut judged);
    assert_eq!(judged.len(), velocity.len());
    for (found, expected) in judged.iter().zip(&velocity) {
        assert!((found.linear - expected.linear).norm() < 1e-12);
        assert!((found.angular - expected.angular).norm() < 1e-10);
    }
}

/// Single precision is left in the middle of a solve: what follows are the sweeps that start in double precision from there.
#[test]
fn a_kernel_that_is_refined_goes_on_in_double_precision() {
    let mut problem = problem();
    problem.rows.update_all(|k, row| {
        row.compliance_n = 0.0;
        if k % 6 == 1 {
            row.prescribed_velocity = Vec3::new(0.02, -0.01, 0.0);
        }
    });
    let loose = Tolerance {
        gap: 1e-4,
        slip: 1e-4,
        force: 0.1,
    };
    let fine = Tolerance {
        gap: 1e-9,
        slip: 1e-9,
        force: 1e-9,
    };
    let pace = |momentum| SweepParams {
        momentum,
        tolerance: loose,
        ..plain_sweep()
    };
    let mut found = vec![Vec3::zeros(); problem.rows.len()];
    let mut kernel = Kernel::default();
    kernel.compile(&problem, &loose, &found);
    assert!(kernel.single && !kernel.extras.is_empty());
    kernel.sweep(&problem, pace(0.0));
    kernel.judge(&problem);
    kernel.refine(&problem, &mut found);
    let mut expected = found.clone();
    let mut other = Kernel::default();
    other.compile(&problem, &fine, &found);
    assert!(!kernel.single && !other.single);
    for momentum in [0.0, 0.5, 0.7] {
        let sweeps = [&mut kernel, &mut other].map(|k| k.sweep(&problem, pace(momentum)));
        assert!((sweeps[0].change - sweeps[1].change).abs() <= 1e-9 * sweeps[1].change);
    }
    kernel.store(&problem, &mut found);
    other.store(&problem, &mut expected);
    for (p, q) in found.iter().zip(&expected) {
        assert!((p - q).norm() < 1e-15, "{p} {q}");
    }
}
