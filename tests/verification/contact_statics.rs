//! Rows 6 and 7: stack and groove.

use sphere_dda::Vec3;
use sphere_dda::scene::Method;
use sphere_dda::solver::SolverKind;

use crate::support::{Case, G, close};

const SOLVERS: [SolverKind; 3] = [
    SolverKind::Auto,
    SolverKind::Direct,
    SolverKind::GaussSeidel,
];

fn stack(n: usize, radius: f64) -> Case {
    (0..n).fold(Case::new(1e-3, 0.3, 0.0).floor(), |case, k| {
        let height = radius * (2 * k + 1) as f64;
        case.sphere(radius, Vec3::new(0.0, 0.0, height), Vec3::zeros())
    })
}

/// Row 6: under the k-th sphere from the top acts `k m g`; at t = 0 and in every step, whatever the solver.
#[test]
fn stack_forces() {
    for solver in SOLVERS {
        let n = 8;
        let mut run = stack(n, 0.1)
            .tolerance(1e-9, 1e-9, 1e-8)
            .settings(|s| s.solver = solver)
            .start();
        for step in 0..50 {
            let mut contacts: Vec<_> = run.simulation.contacts().to_vec();
            contacts.sort_by(|a, b| b.point.z.total_cmp(&a.point.z));
            assert_eq!(contacts.len(), n, "step {step}");
            for (k, contact) in contacts.iter().enumerate() {
                close(
                    contact.force.dot(&contact.normal).abs(),
                    (k + 1) as f64 * run.mass(0) * G,
                    1e-6,
                    0.0,
                );
            }
            run.step();
            assert!(run.simulation.report().max_overlap <= 1e-9);
        }
    }
}

/// Row 6, penalty method: each contact spring of stiffness P carries `k m g`, so it overlaps by `k m g / P`.
#[test]
fn stack_overlaps_under_penalty() {
    let (n, penalty) = (5, 1e7);
    // At rest from the start: the spheres are placed with the overlaps they end with.
    let radius = 0.1;
    let mass = 4.0 / 3.0 * std::f64::consts::PI * 2500.0 * radius * radius * radius;
    let overlap = |k: usize| k as f64 * mass * G / penalty;
    for solver in SOLVERS {
        let mut case = Case::new(1e-3, 0.3, 0.0).floor().settings(|s| {
            s.method = Method::Penalty;
            s.penalty = Some(penalty);
            s.solver = solver;
            s.tolerance.force = 1e-9;
        });
        let mut z = 0.0;
        for k in (1..=n).rev() {
            z += if k == n { radius } else { 2.0 * radius } - overlap(k);
            case = case.sphere(radius, Vec3::new(0.0, 0.0, z), Vec3::zeros());
        }
        let mut run = case.start();
        run.steps(100);
        let mut contacts: Vec<_> = run.simulation.contacts().to_vec();
        contacts.sort_by(|a, b| b.point.z.total_cmp(&a.point.z));
        assert_eq!(contacts.len(), n);
        for (k, contact) in contacts.iter().enumerate() {
            close(-contact.gap, overlap(k + 1), 1e-6, 0.0);
        }
        // These springs are the method's, not the material's: what they give way is an error.
        let report = run.simulation.report();
        close(report.max_overlap, overlap(n) / radius, 1e-6, 0.0);
        assert!(report.max_compression == 0.0, "{}", report.max_compression);
    }
}

/// Row 7: a frictionless sphere between walls inclined by b1, b2: `N1 = m g sin b2 / sin(b1 + b2)`.
#[test]
fn groove() {
    let (b1, b2) = (30f64.to_radians(), 45f64.to_radians());
    let (n1, n2) = (
        Vec3::new(b1.sin(), 0.0, b1.cos()),
        Vec3::new(-b2.sin(), 0.0, b2.cos()),
    );
    let radius = 0.2;
    // Centre at distance R from both walls through the origin.
    let x = radius * (b2.cos() - b1.cos()) / (b1 + b2).sin();
    let z = radius * (b1.sin() + b2.sin()) / (b1 + b2).sin();
    for solver in SOLVERS {
        let mut run = Case::new(1e-3, 0.0, 0.0)
            .tolerance(1e-8, 1e-8, 1e-8)
            .settings(|s| s.solver = solver)
            .plane(Vec3::zeros(), n1)
            .plane(Vec3::zeros(), n2)
            .sphere(radius, Vec3::new(x, 0.0, z), Vec3::zeros())
            .start();
        for _ in 0..20 {
            let weight = run.mass(0) * G;
            close(
                run.force_on_boundary(0).norm(),
                0.732051 * weight,
                2e-6,
                0.0,
            );
            close(
                run.force_on_boundary(0).norm(),
                weight * b2.sin() / (b1 + b2).sin(),
                1e-6,
                0.0,
            );
            close(
                run.force_on_boundary(1).norm(),
                weight * b1.sin() / (b1 + b2).sin(),
                1e-6,
                0.0,
            );
            run.step();
        }
    }
}
