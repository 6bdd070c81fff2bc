//! Rows that are in no block: solved one by one, by the operations that every row has.

use super::batch::{Progress, SweepParams};
use super::lanes::{Body, Real};
use crate::Vec3;
use crate::problem::{GROUND, Law, Problem, Row};
use crate::solver::residual::{Residual, Scale};
use crate::spatial::SpatialVector;

/// A row with its impulses.
#[derive(Debug, Clone, Copy)]
struct GeneralRow {
    /// Its place among all rows.
    at: u32,
    /// Of a resistance, the place of its contact among these rows.
    contact: Option<usize>,
    row: Row,
    scale: Scale,
    /// \[N s\] after the last sweep, and after the last but one.
    impulse: Vec3,
    previous: Vec3,
}

/// The rows that are in no block.
#[derive(Debug, Default)]
pub(super) struct GeneralRows(Vec<GeneralRow>);

/// Bodies as blocks hold them, for rows that hold them otherwise.
pub(super) struct Bodies<'a, T> {
    bodies: &'a mut [Body<T>],
    /// Where each body is, `[N + M]`.
    place: &'a [u32],
    /// Length by which each body's spin is scaled \[m\], `[N + M]`; see [`spin_scale`].
    radius: &'a [f64],
}

/// Length by which the spin of body `i` is scaled \[m\].
pub(super) fn spin_scale(radius: &[f64], i: usize) -> f64 {
    match radius[i] {
        radius if radius > 0.0 => radius,
        _ => 1.0,
    }
}

impl<T: Real> Body<T> {
    /// Its velocity \[m/s\], \[rad/s\], where its spin is scaled by `scale` \[m\].
    #[inline]
    pub(super) fn velocity(&self, scale: f64) -> SpatialVector {
        let [a, b, c, _, d, e, f, _] = self.0.map(T::exact);
        SpatialVector {
            linear: Vec3::new(a, b, c),
            angular: Vec3::new(d, e, f) / scale,
        }
    }

    /// Adds to its velocity.
    #[inline]
    fn add(&mut self, change: &SpatialVector, scale: f64) {
        for k in 0..3 {
            self.0[k] += T::of(change.linear[k]);
            self.0[k + 4] += T::of(change.angular[k] * scale);
        }
    }
}

impl<'a, T: Real> Bodies<'a, T> {
    pub(super) fn of(bodies: &'a mut [Body<T>], place: &'a [u32], radius: &'a [f64]) -> Self {
        Self {
            bodies,
            place,
            radius,
        }
    }

    #[inline]
    fn velocity(&self, i: usize) -> SpatialVector {
        self.bodies[self.place[i] as usize].velocity(spin_scale(self.radius, i))
    }

    /// Gives the bodies of `row` an impulse.
    #[inline]
    fn give(&mut self, problem: &Problem, row: &Row, impulse: Vec3) {
        let [of_a, of_b] = row.momenta(impulse);
        let mut push = |body: u32, momentum: &SpatialVector| {
            let (change, i) = (problem.velocity_change(body, momentum), body as usize);
            let scale = spin_scale(self.radius, i);
            self.bodies[self.place[i] as usize].add(&change, scale);
        };
        push(row.a, &of_a);
        if row.b != GROUND {
            push(row.b, &of_b);
        }
    }
}

impl GeneralRows {
    /// Takes these `rows` of `problem` with their `impulses`, `[C]` \[N s\].
    pub(super) fn take(
        &mut self,
        problem: &Problem,
        impulses: &[Vec3],
        rows: impl Iterator<Item = u32>,
    ) {
        self.0.clear();
        for at in rows {
            let (row, impulse) = (problem.rows.get(at as usize), impulses[at as usize]);
            let contact = match row.law {
                Law::Resistance { contact, .. } => {
                    self.0.binary_search_by_key(&contact, |own| own.at).ok()
                }
                _ => None,
            };
            self.0.push(GeneralRow {
                at,
                contact,
                scale: Scale::of_row(problem, &row),
                row,
                impulse,
                previous: impulse,
            });
        }
    }

    /// Gives the bodies all impulses.
    pub(super) fn push(&self, problem: &Problem, bodies: &mut Bodies<f64>) {
        for own in &self.0 {
            bodies.give(problem, &own.row, own.impulse);
        }
    }

    /// Takes what they are off by into `residual`.
    pub(super) fn judge(&self, problem: &Problem, bodies: &Bodies<f64>, residual: &mut Residual) {
        for (k, own) in self.0.iter().enumerate() {
            let (row, scale) = (&own.row, &own.scale);
            let (u, p, load) = (
                row.relative(|i| bodies.velocity(i)),
                own.impulse,
                self.load(k),
            );
            let natural_map = scale.natural_map(row, u, p, load);
            let values = scale.residuals(row, problem.step, &natural_map);
            residual.include(own.at as usize, values, scale.margin(row, u, p, load));
        }
    }

    /// Solves them one after the other.
    pub(super) fn sweep<T: Real>(
        &mut self,
        problem: &Problem,
        pace: &SweepParams,
        bodies: &mut Bodies<T>,
    ) -> Progress {
        let mut progress = Progress::NONE;
        let mut change = Residual::default();
        for k in 0..self.0.len() {
            let load = self.load(k);
            let own = &mut self.0[k];
            let (row, old) = (&own.row, own.impulse);
            let p = old + (old - own.previous) * pace.momentum;
            let u = row.relative(|i| bodies.velocity(i));
            let natural_map = own.scale.natural_map(row, u, p, load);
            let values = own.scale.residuals(row, problem.step, &natural_map);
            change.include(own.at as usize, values, 1.0);
            let full = row.normal * natural_map.normal + natural_map.tangential;
            let delta = full * pace.damping;
            (own.impulse, own.previous) = (p + delta, old);
            if delta != Vec3::zeros() {
                bodies.give(problem, row, delta);
            }
            progress.along += delta.dot(&(own.impulse - old));
            progress.change += full.norm_squared();
        }
        progress.settled = change.within(&pace.tolerance.scaled(pace.strictness));
        progress
    }

    /// Normal impulse \[N s\] that bounds row `k` of these, if it is a resistance; zero for all others.
    #[inline]
    fn load(&self, k: usize) -> f64 {
        self.0[k].contact.map_or(0.0, |contact| {
            let GeneralRow { row, impulse, .. } = &self.0[contact];
            impulse.dot(&row.normal).max(0.0)
        })
    }

    /// Writes their impulses \[N s\], `[C]`.
    pub(super) fn store(&self, impulses: &mut [Vec3]) {
        for own in &self.0 {
            impulses[own.at as usize] = own.impulse;
        }
    }

    /// Places among all rows, in order.
    #[cfg(test)]
    pub(super) fn places(&self) -> impl ExactSizeIterator<Item = u32> {
        self.0.iter().map(|own| own.at)
    }
}
