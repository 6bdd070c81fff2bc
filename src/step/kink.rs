//! How near a step is to a kink: to a contact that opens, closes, or begins or ends to slip.
//!
//! With a row's operator `w`, its scale of impulse `S = max(|p|, m |a| dt)` and `y = p - (u + b + c p)/w`, what its law projects:
//!
//! ```text
//! margin  |y_n| / S                            to opening or closing
//!         ||y_t| - mu p_n| / (mu p_n)          to stick or slip, likewise of resistances
//! kink    1 - the smallest margin of all rows, at least 0
//! ```

use super::stage::Stage;
use crate::Vec3;
use crate::contacts::law::split;
use crate::problem::{Dof6, Law, Row};

impl Stage<'_> {
    /// How near a row is to the edge of its state after `solution`: 1 at the edge, 0 far from it.
    pub(super) fn kink(&self, solution: &[Dof6]) -> f64 {
        let margins = (0..self.problem.rows.len()).map(|k| self.margin(k, solution));
        1.0 - margins.fold(1.0, f64::min)
    }

    fn margin(&self, k: usize, solution: &[Dof6]) -> f64 {
        let (row, p) = (&self.problem.rows[k], self.impulses[k]);
        if row.law == Law::Bilateral {
            return 1.0;
        }
        let n = row.normal;
        let (p_n, p_t) = split(p, n);
        let (d_n, d_t) = split(row.relative_velocity(solution) + row.bias, n);
        let (w_n, w_t) = self.problem.delassus(row);
        if w_n <= 0.0 || w_t <= 0.0 {
            return 1.0;
        }
        let y_n = p_n - (d_n + row.compliance_n * p_n) / w_n;
        let y_t = p_t - (d_t + p_t * row.compliance_t) / w_t;
        let edge = |size: f64, bound: f64| match bound > 0.0 {
            true => (size - bound).abs() / bound,
            false => 1.0,
        };
        match row.law {
            Law::Contact { mu } => {
                let size = p.norm().max(row.impulse_scale);
                let opens = if size > 0.0 { y_n.abs() / size } else { 1.0 };
                opens.min(edge(y_t.norm(), slipping(row, p, mu)))
            }
            Law::Resistance {
                rolling, twisting, ..
            } => {
                let load = row.load(&self.problem.rows, &self.impulses);
                edge(y_t.norm(), rolling * load).min(edge(y_n.abs(), twisting * load))
            }
            Law::Bilateral => 1.0,
        }
    }
}

/// The friction bound of a contact; none where it is open.
fn slipping(row: &Row, p: Vec3, mu: f64) -> f64 {
    mu * p.dot(&row.normal).max(0.0)
}
