//! Fault 2. Symptom: at a boundary with `stiffness`, and with the penalty method, a ball rebounds with 0.985 of its speed
//! whatever `restitution` is, and the energy that the contact stores is booked as an impact's loss. Cause: the row of a
//! compliant contact is a pure spring (`AssemblyInput::contact_row` sets `compliance_n` and the bias of the gap, `relinearise`
//! replaces the rebound), and `Assembly::work_of` takes what it stores for `-p_n u_n` lost.

use sphere_dda::Vec3;

use crate::support::{Case, Run};

const R: f64 = 0.05;
const V: f64 = 1.0;

/// A ball that flies at 1 m/s on a plane with contact springs; no gravity. The contact lasts `pi sqrt(m/k)`, 36 ms.
fn flying(restitution: f64, penalty: bool) -> Run {
    let face = "plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }";
    let case = Case::new(1e-5)
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
        let mut run = flying(e, penalty);
        run.until(0.06);
        let found = run.velocity(0).z / V;
        assert!((found - e).abs() < 0.02, "e = {e}: {found}");
    }
}

/// Kelvin-Voigt contact: the speed of separation is e times that of approach.
#[test]
#[ignore = "fault 2, not mended yet"]
fn a_ball_rebounds_from_a_stiffness_by_its_restitution() {
    rebounds(false);
}

#[test]
#[ignore = "fault 2, not mended yet"]
fn a_ball_rebounds_by_its_restitution_with_the_penalty_method() {
    rebounds(true);
}

/// What is lost is `(1 - e^2) m v^2/2`, never more on the way, and kinetic energy and the contact's own add up to the rest.
fn ledger(penalty: bool) {
    for e in [0.0, 0.5, 1.0] {
        let mut run = flying(e, penalty);
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
        let balance = run.energy().kinetic() - before + work.impact - work.numerical_work;
        assert!(
            balance.abs() < 1e-9 * before,
            "e = {e}: {:e}",
            balance / before
        );
    }
}

#[test]
#[ignore = "fault 2, not mended yet"]
fn energy_stored_in_a_stiff_contact_is_no_loss() {
    ledger(false);
}

#[test]
#[ignore = "fault 2, not mended yet"]
fn energy_stored_with_the_penalty_method_is_no_loss() {
    ledger(true);
}
