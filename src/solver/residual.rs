//! The residual that judges every solver.
//!
//! For each row the natural map of its law, with the row's own operator `w` as scale:
//!
//! ```text
//! r_n = p_n - max(0, p_n - d_n/w_n),  d_n = u_n + b_n + c_n p_n
//! r_t = p_t - Proj_{mu p_n}(p_t - d_t/w_t),  d_t = u_t + b_t + c_t p_t
//! of a resistance, p_n being its contact's: r = m - Proj_{L_r p_n across n, L_t p_n along n}(m - d/w)
//! gap   = |r_n| w_n dt / R      an overlap, or a gap under load, over the smaller radius [-]
//! slip  = |r_t| w_t dt / R      slip distance of a sticking contact over the smaller radius [-];
//!                               of a resistance |r| w dt / R, the angle by which it rolls or twists while it need not
//! force = |r| / max(|p|, m_min |a_f| dt)                                                  [-]
//! ```
//!
//! How near a contact is to opening, closing, or beginning or ending to slip is seen in what its law projects,
//! `y = p - d/w`:
//!
//! ```text
//! margin  |y_n| / max(|p|, m_min |a_f| dt)      to opening or closing
//!         ||y_t| - mu p_n| / (mu p_n)           to stick or slip, likewise of resistances
//! active_set_closeness    1 - the smallest margin of all rows, at least 0
//! ```
//!
//! The residual vanishes exactly at a solution. Velocities are those of the impulses, never a solver's own.

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::problem::law::split;
use crate::problem::{Law, Problem, Row};

/// Dimensionless tolerances of one step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Tolerance {
    /// True geometric overlap over the smaller radius of the pair \[-\], 1e-12..=1e-1.
    pub gap: f64,
    /// Slip distance of a sticking contact over the smaller radius \[-\], same range.
    pub slip: f64,
    /// Force residual over the contact's force scale \[-\], same range.
    pub force: f64,
}

impl Tolerance {
    /// All of them times `factor`.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            gap: self.gap * factor,
            slip: self.slip * factor,
            force: self.force * factor,
        }
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Self {
            gap: 1e-6,
            slip: 1e-6,
            force: 1e-6,
        }
    }
}

/// Largest residual of each kind \[-\], and the rows where they occur.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Residual {
    /// Gap residual.
    pub gap: f64,
    /// Slip residual.
    pub slip: f64,
    /// Force residual.
    pub force: f64,
    /// Row of the largest gap, slip and force residual.
    pub worst: [usize; 3],
    /// How near a row is to the edge of its state: 1 at the edge, 0 far from it.
    pub(crate) active_set_closeness: f64,
}

impl Residual {
    /// Whether each kind is within its tolerance. NaN is not.
    #[must_use]
    pub fn within(&self, tolerance: &Tolerance) -> bool {
        self.each_within(tolerance) == [true; 3]
    }

    fn each_within(&self, tolerance: &Tolerance) -> [bool; 3] {
        [
            self.gap <= tolerance.gap,
            self.slip <= tolerance.slip,
            self.force <= tolerance.force,
        ]
    }

    /// The rows of the residuals that are not within `tolerance`.
    pub(crate) fn unsolved(&self, tolerance: &Tolerance) -> impl Iterator<Item = usize> {
        self.worst
            .into_iter()
            .zip(self.each_within(tolerance))
            .filter(|(_, within)| !within)
            .map(|(row, _)| row)
    }

    /// Largest of the three over its tolerance \[-\]; infinite where one is no number.
    #[must_use]
    pub fn excess(&self, tolerance: &Tolerance) -> f64 {
        let shares = [
            self.gap / tolerance.gap,
            self.slip / tolerance.slip,
            self.force / tolerance.force,
        ];
        match shares.iter().any(|share| share.is_nan()) {
            true => f64::INFINITY,
            false => shares.into_iter().fold(0.0, f64::max),
        }
    }

    /// Takes row `index`'s residuals and its margin into the extremes.
    pub(super) fn include(&mut self, index: usize, values: [f64; 3], margin: f64) {
        let [gap, slip, force] = values;
        self.join(&Self {
            gap,
            slip,
            force,
            worst: [index; 3],
            active_set_closeness: 1.0 - margin,
        });
    }

    /// Takes those of other rows into the extremes.
    pub(super) fn join(&mut self, other: &Self) {
        self.active_set_closeness = self.active_set_closeness.max(other.active_set_closeness);
        let maxima = [&mut self.gap, &mut self.slip, &mut self.force];
        let values = [other.gap, other.slip, other.force];
        for (k, (maximum, value)) in maxima.into_iter().zip(values).enumerate() {
            if value > *maximum || value.is_nan() {
                *maximum = value;
                self.worst[k] = other.worst[k];
            }
        }
    }
}

/// A row's operator with its compliance, the scale of its multiplier update \[1/kg\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// `w_n + c_n`.
    pub normal: f64,
    /// `w_t + c_t`.
    pub tangential: f64,
}

impl Scale {
    /// The scales of all rows, `[C]`.
    #[must_use]
    pub fn of(problem: &Problem) -> Vec<Self> {
        let rows = problem.rows.iter();
        rows.map(|row| Self::of_row(problem, &row)).collect()
    }

    /// The scales of one row.
    pub(crate) fn of_row(problem: &Problem, row: &Row) -> Self {
        let (normal, tangential) = problem.delassus(row);
        Self {
            normal: normal + row.compliance_n,
            tangential: tangential + row.compliance_t,
        }
    }

    /// Change of the row's impulse by its law at relative velocity `u` and impulse `p`: normal first, then
    /// tangential on the disc of the updated normal impulse; `load` bounds a resistance (`Row::load`). Zero at a
    /// solution.
    ///
    /// A row that nothing can move (`w = 0`) keeps its impulse.
    #[must_use]
    #[inline]
    pub fn natural_map(&self, row: &Row, u: Vec3, p: Vec3, load: f64) -> NaturalMap {
        let n = row.normal;
        let (u_n, u_t) = split(u + row.bias, n);
        let open = match row.law {
            Law::Contact { .. } => u_n >= 0.0,
            Law::Bilateral => false,
            Law::Resistance { .. } => load == 0.0,
        };
        if open && p == Vec3::zeros() {
            return NaturalMap::NONE;
        }
        let (p_n, p_t) = split(p, n);
        let d_n = u_n + row.compliance_n * p_n;
        let d_t = u_t + p_t * row.compliance_t;
        let free_n = if self.normal > 0.0 {
            p_n - d_n / self.normal
        } else {
            p_n
        };
        let free_t = if self.tangential > 0.0 {
            p_t - d_t / self.tangential
        } else {
            p_t
        };
        let (new_n, new_t) = row.law.project(free_n, free_t, load);
        NaturalMap {
            normal: new_n - p_n,
            tangential: new_t - p_t,
            magnitude: (new_n * new_n + new_t.norm_squared()).sqrt(),
        }
    }

    /// Distance of a row to the edge of its state over its size, at relative velocity `u` and impulse `p`; 1 where it has
    /// none or nothing can move it.
    #[inline]
    pub(crate) fn margin(&self, row: &Row, u: Vec3, p: Vec3, load: f64) -> f64 {
        if row.law == Law::Bilateral || self.normal <= 0.0 || self.tangential <= 0.0 {
            return 1.0;
        }
        let n = row.normal;
        let ((p_n, p_t), (d_n, d_t)) = (split(p, n), split(u + row.bias, n));
        let y_n = p_n - (d_n + row.compliance_n * p_n) / self.normal;
        let y_t = (p_t - (d_t + p_t * row.compliance_t) / self.tangential).norm();
        let pressing = match row.law {
            Law::Resistance { .. } => load,
            _ => p_n.max(0.0),
        };
        let size = p.norm().max(row.impulse_scale);
        row.law.margin(y_n, y_t, pressing, size)
    }

    /// The three dimensionless residuals of a row whose impulse is off by `natural_map`.
    pub(crate) fn residuals(&self, row: &Row, step: f64, natural_map: &NaturalMap) -> [f64; 3] {
        let tangential = natural_map.tangential.norm();
        let normal = natural_map.normal.abs();
        let force = (normal * normal + tangential * tangential).sqrt();
        let length = step / row.radius;
        let (along, across) = (
            normal * self.normal * length,
            tangential * self.tangential * length,
        );
        let (gap, slip) = match row.law {
            Law::Resistance { .. } => (0.0, along.max(across)),
            _ => (along, across),
        };
        // Without any scale an impulse that should vanish is off by all of itself.
        let size = match natural_map.magnitude.max(row.impulse_scale) {
            0.0 => force.max(f64::MIN_POSITIVE),
            size => size,
        };
        [gap, slip, force / size]
    }
}

/// How far a row's impulse is from its law \[N s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NaturalMap {
    /// Along the normal.
    pub normal: f64,
    /// Across it.
    pub tangential: Vec3,
    /// Size of the corrected impulse.
    pub magnitude: f64,
}

impl NaturalMap {
    /// An open contact that stays open.
    const NONE: Self = Self {
        normal: 0.0,
        tangential: Vec3::new(0.0, 0.0, 0.0),
        magnitude: 0.0,
    };
}

/// The residual of `impulses`, `[C]`.
#[must_use]
pub fn evaluate(problem: &Problem, scales: &[Scale], impulses: &[Vec3]) -> Residual {
    let velocity = problem.velocities(impulses);
    let mut residual = Residual::default();
    for (index, ((row, scale), &p)) in problem.rows.iter().zip(scales).zip(impulses).enumerate() {
        let load = row.load(&problem.rows, impulses);
        let u = row.relative_velocity(&velocity);
        let natural_map = scale.natural_map(&row, u, p, load);
        let values = scale.residuals(&row, problem.step, &natural_map);
        residual.include(index, values, scale.margin(&row, u, p, load));
    }
    residual
}
