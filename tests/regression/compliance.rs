//! Fault 2. Symptom: at a boundary with `stiffness`, and with the penalty method, a ball rebounds with 0.985 of its speed
//! whatever `restitution` is, and the energy that the contact stores is booked as an impact's loss. Cause: the row of a
//! compliant contact was a pure spring, and what it stored was taken for `-p_n u_n` lost.

use sphere_dda::Vec3;

use crate::support::{Case, Run};

const R: f64 = 0.05;
const V: f64 = 1.0;

/// A ball that flies at 1 m/s on a plane with contact springs; no gravity. The contact lasts `pi sqrt(m/k)`, 36 ms.
fn flying(step: f64, restitution: f64, penalty: bool) -> Run {
    let face = "plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }";
    let case = Case::new(step)
        .gravity(Vec3::zeros())
        .contact(0.0, restitution);
    let case = if penalty {
        case.set("method = \"penalty\"")
            .set("penalty = 1e4")
            .boundary(face, "")
    } else {
        case.boundary(face, "stiffness = 1e4")
    };
    let case = case.sphere(R, Vec3::z() * (R + 1e-4), -Vec3::z() * V, Vec3::zeros());
    case.start()
}

fn rebounds(penalty: bool) {
    for e in [0.0, 0.5, 1.0] {
        let mut run = flying(1e-5, e, penalty);
        run.until(0.06);
        let found = run.velocity(0).z / V;
        assert!((found - e).abs() < 0.02, "e = {e}: {found}");
    }
}

/// Kelvin-Voigt contact: the speed of separation is e times that of approach.
#[test]
fn a_ball_rebounds_from_a_stiffness_by_its_restitution() {
    rebounds(false);
}

#[test]
fn a_ball_rebounds_by_its_restitution_with_the_penalty_method() {
    rebounds(true);
}

/// What is lost is `(1 - e^2) m v^2/2`, never more on the way, and kinetic energy and the contact's own add up to the rest.
fn ledger(penalty: bool) {
    for e in [0.0, 0.5, 1.0] {
        let mut run = flying(1e-5, e, penalty);
        let before = run.energy().kinetic();
        let lost = (1.0 - e * e) * before;
        for _ in 0..6000 {
            run.step();
            let impact = run.simulation.work().impact;
            assert!(
                impact <= lost + 0.02 * before,
                "e = {e}: {:.3} of the energy is lost",
                impact / before
            );
        }
        let work = run.simulation.work();
        assert!(
            (work.impact - lost).abs() < 0.02 * before,
            "e = {e}: {}",
            work.impact / before
        );
        assert!(
            work.numerical_work.abs() < 0.02 * before,
            "e = {e}: {}",
            work.numerical_work / before
        );
        let stored = -work.contacts;
        let balance = run.energy().kinetic() + stored - before + work.impact - work.numerical_work;
        assert!(
            balance.abs() < 1e-9 * before,
            "e = {e}: {:e}",
            balance / before
        );
    }
}

#[test]
fn energy_stored_in_a_stiff_contact_is_no_loss() {
    ledger(false);
}

#[test]
fn energy_stored_with_the_penalty_method_is_no_loss() {
    ledger(true);
}

/// From 3600 steps in a contact to 400 contacts in a step.
#[test]
fn restitution_holds_at_any_step() {
    for step in [1e-4, 3e-4, 1e-3, 2e-3, 3e-3, 3.5e-3, 4e-3, 1e-2, 3e-2] {
        for e in [0.0, 0.2, 0.5, 0.8, 1.0] {
            let mut run = flying(step, e, false);
            run.until(0.2);
            let found = run.velocity(0).z / V;
            assert!((found - e).abs() < 0.03, "e = {e} at {step} s: {found}");
        }
    }
}
