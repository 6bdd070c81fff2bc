//! Six scalars a body: what solvers that assemble a matrix share.

use nalgebra::{Matrix3, Matrix3x6};

use crate::Vec3;
use crate::problem::{Dof6, GROUND, Grip, Problem, Row};

/// Mass \[kg\], \[kg m^2\] of each degree of freedom; one where it is locked, so that `K` stays regular.
pub(super) fn masses(inverse_mass: &Dof6) -> [f64; 6] {
    let w = [inverse_mass.linear, inverse_mass.angular];
    std::array::from_fn(|k| {
        let w = w[k / 3][k % 3];
        if w > 0.0 { 1.0 / w } else { 1.0 }
    })
}

/// `d(u)/d(v)` of one body: `[1, -[arm]x]` at a point, `[0, R]` of a couple, with locked degrees of freedom taken out.
pub(super) fn jacobian(grip: Grip, inverse_mass: &Dof6) -> Matrix3x6<f64> {
    let (linear, angular) = match grip {
        Grip::Point(arm) => (Matrix3::identity(), -arm.cross_matrix()),
        Grip::Couple(lever) => (Matrix3::zeros(), Matrix3::identity() * lever),
    };
    let mut j = Matrix3x6::zeros();
    j.fixed_view_mut::<3, 3>(0, 0).copy_from(&linear);
    j.fixed_view_mut::<3, 3>(0, 3).copy_from(&angular);
    for k in 0..3 {
        if inverse_mass.linear[k] == 0.0 {
            j.column_mut(k).fill(0.0);
        }
        if inverse_mass.angular[k] == 0.0 {
            j.column_mut(k + 3).fill(0.0);
        }
    }
    j
}

/// Adds `J^T impulse` of a row to `momentum`, `[6 N]`; locked degrees of freedom do not feel it.
pub(super) fn scatter(problem: &Problem, row: &Row, impulse: Vec3, momentum: &mut [f64]) {
    let mut give = |body: u32, given: Dof6| {
        let body = body as usize;
        let w = &problem.inverse_mass[body];
        for k in 0..3 {
            if w.linear[k] > 0.0 {
                momentum[6 * body + k] += given.linear[k];
            }
            if w.angular[k] > 0.0 {
                momentum[6 * body + 3 + k] += given.angular[k];
            }
        }
    };
    let [grip_a, grip_b] = row.grips();
    give(row.a, grip_a.momentum(impulse));
    if row.b != GROUND {
        give(row.b, grip_b.momentum(-impulse));
    }
}

/// `velocity + scale * step`; `step` has `6 N` entries.
pub(super) fn moved(velocity: &[Dof6], step: &[f64], scale: f64) -> Vec<Dof6> {
    let part = |i: usize| Vec3::new(step[i], step[i + 1], step[i + 2]) * scale;
    velocity
        .iter()
        .enumerate()
        .map(|(i, v)| Dof6 {
            linear: v.linear + part(6 * i),
            angular: v.angular + part(6 * i + 3),
        })
        .collect()
}
