//! The measure against Siconos, solvers on its problems, files in and out, steps with and without their bodies.

#![cfg(test)]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use sphere_dda::formats::problem;
use sphere_dda::problem::reduction::Reduction;
use sphere_dda::problem::{GROUND, Law, Problem, Row, Rows};
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::augmented_lagrangian::SolverWorkspace;
use sphere_dda::solver::{Params, SolverKind, Tolerance};
use sphere_dda::spatial::SpatialVector;

use super::read::parse;
use super::*;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("problems")
}

fn problems() -> BTreeMap<String, Read> {
    let files = files(&[folder()]).expect("a folder");
    files
        .iter()
        .map(|path| (name(path), read(path).expect("a problem")))
        .collect()
}

/// Siconos computed the expected values: see the README beside them.
#[test]
fn the_measure_is_that_of_siconos() {
    let text = std::fs::read_to_string(folder().join("errors.csv")).expect("errors.csv");
    let problems = problems();
    let lines: Vec<Vec<&str>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(lines.len(), problems.len());
    for line in lines {
        let Read {
            problem, dimension, ..
        } = &problems[line[0]];
        let probe = |k: usize| {
            let last = if *dimension == 3 {
                -0.1 * k as f64
            } else {
                0.0
            };
            Vec3::new(1.0 + 0.1 * k as f64, 0.2, last)
        };
        let rest = vec![Vec3::zeros(); problem.contacts()];
        let probe: Vec<Vec3> = (0..problem.contacts()).map(probe).collect();
        for (impulses, expected) in [(rest, line[1]), (probe, line[2])] {
            let expected: f64 = expected.parse().expect("a number");
            let found = problem.error(&impulses);
            assert!(
                (found / expected - 1.0).abs() < 1e-10,
                "{}: {found} {expected}",
                line[0]
            );
        }
    }
}

/// Every solver reaches 1e-8 on every problem; sweeps and factorizations are pinned.
#[test]
fn every_solver_solves_the_problems() {
    let mut told = String::new();
    for (name, read) in problems() {
        told += &format!("{name}:");
        for solver in FrictionSolver::ALL {
            let outcome = once(&read, solver, &FrictionParams::default());
            let error = read.problem.error(&outcome.impulses);
            assert!(error <= 1e-8, "{name} by {}: {error:e}", solver.name());
            let FrictionReport {
                sweeps,
                factorizations,
                converged,
                ..
            } = outcome.report;
            assert!(converged && outcome.report.error == error);
            told += &format!(" {} {sweeps}+{factorizations}", solver.name());
        }
        told += "\n";
    }
    insta::assert_snapshot!(told);
}

/// A tolerance that is not reached is not reported as reached, and the best impulses are kept.
#[test]
fn what_is_not_solved_says_so() {
    let read = &problems()["OneObject-i1028-138.hdf5"];
    let few = FrictionParams {
        max_sweeps: 10,
        max_factorizations: 1,
        ..FrictionParams::default()
    };
    let rest = read
        .problem
        .error(&vec![Vec3::zeros(); read.problem.contacts()]);
    for solver in FrictionSolver::ALL {
        let outcome = once(read, solver, &few);
        assert!(!outcome.report.converged, "{}", solver.name());
        let error = read.problem.error(&outcome.impulses);
        assert!(error == outcome.report.error && error > 1e-8 && error <= rest);
    }
}

#[test]
fn a_written_problem_is_read_in_every_bit() {
    for (name, read) in problems() {
        let text = problem::text(
            &read.problem,
            &["a note".to_owned(), "two\nlines".to_owned()],
        );
        let again = parse(&text).unwrap_or_else(|fault| panic!("{name}: {fault:?}"));
        assert_eq!(again.problem, read.problem, "{name}");
        assert_eq!((again.dimension, again.global), (3, false));
    }
}

/// Matrices in all three storages, and a global problem by the closed form `W = H^T M^-1 H`.
#[test]
fn all_storages_are_read() {
    let dense = "3\n1\n0\n3\n3\n3 3\n2 0 0.5\n0 3 0\n0.25 0 4\n-1 0 0\n0.3\n";
    let title = "CSparse Version 3.1.9, May 4, 2016.  Copyright (c) Timothy A. Davis, 2006-2016";
    let columns = format!(
        "3\n1\n2\n3\n3\n2\n{title}\n3-by-3, nzmax: 5 nnz: 5, 1-norm: 4.5\n    col 0 : locations 0 to 1\n      0 : 2\n      2 : 0.5\n    \
         col 1 : locations 2 to 2\n      1 : 3\n    col 2 : locations 3 to 4\n      0 : 0.25\n      2 : 4\n-1 0 0\n0.3\n"
    );
    let triplets = format!(
        "3\n1\n2\n3\n3\n1\n{title}\ntriplet: 3-by-3, nzmax: 5 nnz: 5\n    0 0 : 2\n    2 2 : 4\n    2 0 : 0.5\n    0 2 : 0.25\n    \
         1 1 : 3\n-1 0 0\n0.3\n"
    );
    let blocks = "3 1 1 3 3 1 1 1 3 3 2 1 0 1 0 0 2 0 0.5 0 3 0 0.25 0 4 -1 0 0 0.3";
    let expected = parse(dense).expect("dense");
    assert!(!expected.global && expected.problem.own(0)[(2, 0)] == 0.5);
    assert!(expected.problem.own(0)[(0, 2)] == 0.25);
    for text in [&columns, &triplets, blocks] {
        assert_eq!(parse(text).expect("a problem"), expected);
    }
    // M = 2, H = [1 2; 0 4], q = (6, 8), b = (-1, 0).
    let global = parse("2 1 0 2 2 2 2 2 0 0 2 0 2 2 2 2 1 0 2 4 6 8 -1 0 0.5").expect("global");
    assert!(global.global && global.dimension == 2);
    assert_eq!(global.problem.free(), [Vec3::new(2.0, 22.0, 0.0)]);
    assert_eq!(global.problem.own(0).diagonal(), Vec3::new(0.5, 10.0, 10.0));
}

#[test]
fn damaged_text_is_refused_with_the_place() {
    let fault = |text: &str| {
        let fault = parse(text).expect_err(text);
        format!(
            "{}: found {}, expected {}",
            fault.line, fault.found, fault.expected
        )
    };
    let cases = [
        (
            "",
            "1: found the end of the file, expected the dimension, 2 or 3",
        ),
        ("4\n1\n", "1: found dimension 4, expected 2 or 3"),
        (
            "3\n-1\n",
            "2: found `-1`, expected rows or columns of contacts",
        ),
        (
            "3\n99999999999\n",
            "2: found 99999999999 rows or columns of contacts, expected at most 1e7",
        ),
        (
            "3\n1\n7\n3\n3\n",
            "5: found storage 7 of W or M, expected 0 (dense), 1 (blocks) or 2 (sparse)",
        ),
        (
            "3\n1\n0\n3\n4\n3 4\n1 2 3 4 5 6 7 8 9 0 1 2\n",
            "7: found 3 rows and 4 columns, expected a square matrix W or M",
        ),
        (
            "3\n1\n0\n3\n3\n3 3\n1 2 3 4\n",
            "7: found 4 more words, expected 9 numbers of W or M",
        ),
        (
            "3\n1\n0\n3\n3\n3 3\n1 0 0 0 nan 0 0 0 1\n0 0 0\n1\n",
            "7: found `nan`, expected a finite number of W or M",
        ),
        (
            "3\n1\n0\n3\n3\n3 3\n1 0 0 0 1 0 0 0 1\n0 0 0\n-1\n",
            "9: found mu = -1, expected friction coefficients of at least 0",
        ),
        (
            "3\n1\n0\n3\n3\n3 3\n1 0 0 0 1 0 0 0 1\n0 0\n",
            "8: found 2 more words, expected 3 numbers of q",
        ),
        (
            "2 1 0 2 2 2 2 0 0 0 0 0 2 2 2 2 1 0 0 4 6 8 -1 0 0.5",
            "1: found a singular M at row 0, expected a regular M",
        ),
        (
            "3 1 1 3 3 1 1 1 3 2 2 1 0 1 0 0 2 0 0.5 0 3 0 0.5 0 4 -1 0 0 0.3",
            "1: found ends of block rows or columns, expected ascending ends, the last at 3",
        ),
        (
            "3 1 2 3 3 1 CSparse\ntriplet: 3-by-3, nzmax: 1 nnz: 1\n 5 0 : 1\n0 0 0\n1\n",
            "3: found an entry at (5, 0), expected a place within 3 by 3",
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(fault(text), expected, "{text}");
    }
    // No prefix of a file, and no word replaced, makes the reader panic.
    let whole = std::fs::read_to_string(folder().join("FC3D_Example1_SBM.dat")).expect("a file");
    for end in 0..whole.len() {
        let _ = parse(&whole[..end]);
    }
    let words: Vec<&str> = whole.split_whitespace().collect();
    for k in 0..words.len() {
        for other in ["-1", "0", "1e400", "18446744073709551615", "x"] {
            let mut words = words.clone();
            words[k] = other;
            let _ = parse(&words.join(" "));
        }
    }
}

#[test]
fn a_file_that_is_no_text_says_what_to_do() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.dat");
    std::fs::write(&path, b"\x89HDF\r\n\x1a\n").expect("a file");
    let told = read(&path).expect_err("HDF5").to_string();
    assert!(
        told.contains("HDF5") && told.contains("convert.py"),
        "{told}"
    );
    let told = read(&folder.path().join("b.dat"))
        .expect_err("none")
        .to_string();
    assert!(
        told.contains("cannot read") && told.contains("b.dat"),
        "{told}"
    );
    std::fs::remove_file(path).expect("a file");
    let told = files(&[folder.path().to_path_buf()])
        .expect_err("none")
        .to_string();
    assert!(told.contains("has no problem"), "{told}");
}

/// Largest difference of contact velocities between impulses of the rows and impulses of the reduction over the largest size.
fn difference(whole: &Problem, solution: &[Vec3], reduction: &Reduction, impulses: &[Vec3]) -> f64 {
    let velocity = whole.velocities(solution);
    let found = reduction.problem.velocities(impulses);
    let mut worst = (0.0f64, 0.0f64);
    for ((&k, axes), found) in reduction.rows.iter().zip(&reduction.axes).zip(found) {
        let row = whole.rows.get(k);
        // Compliance is part of the reduced velocity.
        let p = axes.transpose() * solution[k];
        let soft =
            Vec3::new(row.compliance_n, row.compliance_t, row.compliance_t).component_mul(&p);
        let u = axes.transpose() * (row.relative_velocity(&velocity) + row.bias) + soft;
        worst = (worst.0.max((u - found).norm()), worst.1.max(u.norm()));
    }
    worst.0 / worst.1
}

/// Reduces a step's problem, writes and reads it, and solves it: its contacts move as the step's own solver has them move.
fn same_by_both(whole: &Problem, start: &[Vec3]) -> Reduction {
    let params = Params {
        kind: SolverKind::Auto,
        tolerance: Tolerance {
            gap: 1e-12,
            slip: 1e-12,
            force: 1e-9,
        },
        accept: false,
        min_sweeps: 1,
        max_sweeps: 100_000,
        max_factorizations: 1000,
        penalty: 1e4,
        adapt_penalty: true,
        smoothing: 60,
    };
    let mut solution = start.to_vec();
    let mut workspace = SolverWorkspace::default();
    let report = sphere_dda::solver::solve(whole, &params, &mut workspace, &mut solution);
    assert!(report.converged, "{report:?}");
    let reduction = Reduction::of(whole, &solution);
    // What solves the one solves the other.
    assert!(difference(whole, &solution, &reduction, &reduction.own(&solution)) < 1e-12);
    assert!(reduction.problem.error(&reduction.own(&solution)) < 1e-6);
    let again = parse(&problem::text(&reduction.problem, &[])).expect("what was written");
    assert_eq!(again.problem, reduction.problem);
    let tight = FrictionParams {
        tolerance: 1e-12,
        ..FrictionParams::default()
    };
    let outcome = once(&again, FrictionSolver::Auto, &tight);
    assert!(outcome.report.converged, "{:?}", outcome.report);
    let off = difference(whole, &solution, &reduction, &outcome.impulses);
    assert!(off < 1e-6, "{off:e}");
    reduction
}

/// Spheres dropped on an incline, with what `extra` adds; half a second later.
fn pile(extra: &str) -> Simulation {
    let text = format!(
        r#"
[simulation]
duration = 1.0
step = 2e-3

[[material]]
name = "grain"
density = 2500.0

[pair_default]
friction = 0.4
{extra}
[[boundary]]
name = "box"
material = "grain"
faces = [
    {{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.1, 0.05, 1.0] }} }},
    {{ plane = {{ point = [0.05, 0.0, 0.0], normal = [-1.0, 0.0, 0.0] }} }},
    {{ plane = {{ point = [0.0, 0.05, 0.0], normal = [0.0, -1.0, 0.0] }} }},
]

[[spheres]]
name = "bed"
material = "grain"
radius = 0.01
seed = 2
lattice = {{ origin = [-0.02, -0.02, 0.02], count = [3, 3, 3], spacing = 0.0225, jitter = 0.05 }}
"#
    );
    let scene = Scene::from_toml("pile.toml", &text, Path::new(""))
        .expect("a scene")
        .scene;
    let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
    simulation.advance(0.1).expect("a step");
    simulation
}

#[test]
fn a_step_s_problem_has_the_same_solution_without_its_bodies() {
    let simulation = pile("");
    let (whole, start) = simulation.problem(2e-3).expect("a problem");
    let reduction = same_by_both(&whole, &start);
    assert!(reduction.problem.contacts() > 20);
    assert_eq!((reduction.eliminated, reduction.held), (0, 0));
    // Resistances act with the impulses they have.
    let simulation = pile("rolling_friction = 0.1\n");
    let (whole, start) = simulation.problem(2e-3).expect("a problem");
    let reduction = same_by_both(&whole, &start);
    assert!(reduction.held > 20 && reduction.eliminated == 0);
}

/// Two spheres on a floor and on each other, the upper one tied to a third beside it at a point, stiffly or by a spring.
#[test]
fn bilateral_rows_become_part_of_the_operator() {
    let mass = SpatialVector {
        linear: Vec3::repeat(2.0),
        angular: Vec3::repeat(5.0),
    };
    let falling = |x: f64| SpatialVector {
        linear: Vec3::new(x, 0.2, -0.5),
        angular: Vec3::new(0.1, 0.0, x),
    };
    let row = |a: u32, b: u32, normal: Vec3, law: Law| Row {
        a,
        b,
        normal,
        arm_a: normal * -1.0,
        arm_b: if b == GROUND { Vec3::zeros() } else { normal },
        prescribed_velocity: Vec3::zeros(),
        bias: Vec3::zeros(),
        compliance_n: 0.0,
        compliance_t: 0.0,
        law,
        radius: 1.0,
        impulse_scale: 1e-3,
    };
    let contact = Law::Contact { mu: 0.3 };
    for soft in [0.0, 0.7] {
        let tie = Row {
            compliance_n: soft,
            compliance_t: soft,
            bias: Vec3::new(0.02, 0.0, -0.01),
            ..row(2, 1, Vec3::x(), Law::Bilateral)
        };
        let rows: Rows = [
            row(0, GROUND, Vec3::z(), contact),
            tie,
            row(1, 0, Vec3::z(), contact),
            row(2, GROUND, Vec3::new(0.6, 0.0, 0.8), contact),
        ]
        .into_iter()
        .collect();
        let whole = Problem {
            step: 1e-2,
            free: [0.3, -0.4, 0.9].map(falling).to_vec(),
            inverse_mass: vec![mass; 3],
            operators: Vec::new(),
            rows,
        };
        let reduction = same_by_both(&whole, &[Vec3::zeros(); 4]);
        assert_eq!(reduction.rows, [0, 2, 3]);
        assert_eq!((reduction.eliminated, reduction.held), (1, 0));
    }
}

/// Steps that miss their tolerances are kept with time, reason and a problem that the friction solvers solve.
#[test]
fn failed_steps_are_kept_up_to_the_limit() {
    let mut simulation = pile("");
    simulation.keep_failed_steps(3);
    simulation.advance(2e-3).expect("a step");
    assert_eq!(
        simulation.take_failed_steps(),
        (Vec::new(), 0),
        "nothing has failed"
    );
    let mut scene = Scene::clone(simulation.scene());
    scene.settings.max_iterations = 1;
    scene.settings.solver = SolverKind::GaussSeidel;
    scene.settings.smallest_step = None;
    let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
    simulation.keep_failed_steps(3);
    simulation.advance(0.2).expect("the best iterate is taken");
    let (steps, omitted) = simulation.take_failed_steps();
    assert_eq!(steps.len(), 3);
    assert!(omitted > 0);
    for step in steps {
        assert!(
            step.time > 0.0 && step.step > 0.0 && step.why.contains("residual"),
            "{}",
            step.why
        );
        let reduction = Reduction::of(&step.problem, &step.impulses);
        let read = Read {
            problem: reduction.problem,
            dimension: 3,
            global: false,
        };
        let outcome = once(&read, FrictionSolver::Auto, &FrictionParams::default());
        assert!(outcome.report.converged, "{:?}", outcome.report);
    }
    assert_eq!(simulation.take_failed_steps().0, Vec::new());
}
