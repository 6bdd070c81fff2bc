//! Rows as they were given, and as they are changed.

#![cfg(test)]

use super::*;

fn row(b: u32, arm_b: Vec3) -> Row {
    let normal = Vec3::new(0.6, 0.0, 0.8);
    Row {
        a: 1,
        b,
        normal,
        arm_a: normal * -0.3,
        arm_b,
        prescribed_velocity: Vec3::zeros(),
        bias: normal * 0.1,
        compliance_n: 0.0,
        compliance_t: 0.0,
        law: Law::Contact { mu: 0.4 },
        radius: 0.2,
        impulse_scale: 1e-3,
    }
}

/// One of each kind: plain ones, and one for each thing that a plain one has not.
fn all() -> Vec<Row> {
    let n = row(GROUND, Vec3::zeros()).normal;
    let plain = row(3, n * 0.2);
    let x = Vec3::x();
    vec![
        plain,
        row(GROUND, Vec3::zeros()),
        Row { arm_b: x, ..plain },
        Row {
            arm_a: n * -0.31,
            ..plain
        },
        Row {
            prescribed_velocity: x,
            ..plain
        },
        Row { bias: x, ..plain },
        Row {
            compliance_n: 1.0,
            ..plain
        },
        Row {
            compliance_t: 1.0,
            ..plain
        },
        Row {
            law: Law::Bilateral,
            ..plain
        },
        Row {
            bias: n * -0.3,
            ..plain
        },
    ]
}

fn close(found: &Row, expected: &Row) -> bool {
    let vectors = |row: &Row| {
        [
            row.normal,
            row.arm_a,
            row.arm_b,
            row.prescribed_velocity,
            row.bias,
        ]
    };
    let apart = vectors(found).into_iter().zip(vectors(expected));
    let zero = Vec3::zeros();
    let rest = |row: &Row| Row {
        normal: zero,
        arm_a: zero,
        arm_b: zero,
        prescribed_velocity: zero,
        bias: zero,
        ..*row
    };
    apart.into_iter().all(|(a, b)| (a - b).norm() < 1e-15) && rest(found) == rest(expected)
}

#[test]
fn rows_come_back_as_they_were_given() {
    let given = all();
    let rows: Rows = given.iter().copied().collect();
    assert_eq!(rows.general.len(), 7, "three are plain");
    let velocity = |i: usize| SpatialVector {
        linear: Vec3::new(1.0, i as f64, 0.5),
        angular: Vec3::new(0.3, -2.0, i as f64),
    };
    for (k, expected) in given.iter().enumerate() {
        assert!(close(&rows.get(k), expected), "row {k}: {:?}", rows.get(k));
        let u = rows.relative(k, velocity);
        assert!((u - expected.relative(velocity)).norm() < 1e-15, "row {k}");
        let p = Vec3::new(0.4, -1.0, 2.0);
        let momenta = rows.momenta(k, p).into_iter().zip(expected.momenta(p));
        let held = momenta.zip([expected.a, expected.b]);
        for ((found, expected), _) in held.filter(|(_, body)| *body != GROUND) {
            let apart = found.plus(&expected, -1.0);
            assert!(apart.dot(&apart) < 1e-29, "row {k}");
        }
        assert_eq!(rows.compliance(k), expected.compliance_n);
        assert_eq!(rows.bodies(k), [expected.a, expected.b]);
    }
}

/// Rows that are written side by side, of which those that are no plain ones follow later.
#[test]
fn rows_written_first_and_kept_whole_later_are_those_that_are_pushed() {
    let given = all();
    let pushed: Rows = given.iter().copied().collect();
    let mut rows = Rows::default();
    let mut writer = rows.rewrite(&[0.0, 0.3, 0.0, 0.2], given.len());
    // What is written as no plain one may be one all the same.
    let plain = |k: usize| k == 0 || k == 9;
    for (k, row) in given.iter().enumerate() {
        writer.write(k, row, plain(k));
    }
    let whole = given.iter().enumerate().filter(|(k, _)| !plain(*k));
    rows.settle(whole.map(|(_, row)| *row));
    assert_eq!(rows, pushed);
    for (k, row) in given.iter().enumerate() {
        assert!(rows.with(k, |found| close(found, row)), "row {k}");
    }
}

/// Rows whose arms are radii, whatever else they have, as they are given and as they are changed.
#[test]
fn arms_that_are_radii_are_known() {
    let mut rows: Rows = all().into_iter().collect();
    let radial =
        |rows: &Rows| -> Vec<bool> { (0..rows.len()).map(|k| rows.is_of_spheres(k)).collect() };
    let mut expected = [
        true, true, false, false, true, true, true, true, false, true,
    ];
    assert_eq!(radial(&rows), expected);
    assert!(!rows.are_of_spheres() && !rows.are_plain());
    rows.update(2, |row| row.arm_b = row.normal * 0.2);
    rows.update(4, |row| row.arm_a = Vec3::y());
    (expected[2], expected[4]) = (true, false);
    assert_eq!(radial(&rows), expected);
    let soft = |k: usize| rows.get(k);
    let rows: Rows = [0, 1, 5, 6].map(soft).into_iter().collect();
    assert!(rows.are_of_spheres() && !rows.are_plain());
}

#[test]
fn changes_reach_rows_of_either_kind() {
    let mut given = all();
    let mut rows: Rows = given.iter().copied().collect();
    rows.insert_all(&[1], &[given[4]]);
    given.insert(1, given[4]);
    for (k, row) in given.iter_mut().enumerate() {
        rows.shift(k, 0.7);
        row.bias += row.normal * 0.7;
    }
    rows.update_all(|k, row| row.prescribed_velocity.y += (k % 2) as f64);
    for (k, row) in given.iter_mut().enumerate() {
        row.prescribed_velocity.y += (k % 2) as f64;
    }
    let keep = [true, false, true];
    rows.retain(&keep);
    given.remove(1);
    rows.truncate(9);
    for (k, expected) in given.iter().take(9).enumerate() {
        assert!(close(&rows.get(k), expected), "row {k}: {:?}", rows.get(k));
    }
    assert_eq!(rows.len(), 9);
}

/// A contact that joins shifts those at its place and behind it, and what their resistances are bound to.
#[test]
fn resistances_follow_their_contacts() {
    let plain = all()[0];
    let of = |contact| Row {
        law: Law::Resistance {
            contact,
            rolling: 0.1,
            twisting: 0.1,
        },
        ..plain
    };
    let mut rows: Rows = [plain, plain, of(0), of(1)].into_iter().collect();
    rows.insert_all(&[1, 1], &[plain; 2]);
    let found: Vec<_> = rows.resistances().collect();
    assert_eq!(found, [(4, 0), (5, 3)]);
}
