//! A problem compiled for sweeps: contacts of spheres in blocks, every other row as it is.

use super::block::{Pace, Progress, Verdict};
use super::lanes::{Body, Sixteen};
use super::layout::Layout;
use super::sheet::{Sheet, Turns};
use crate::Vec3;
use crate::parallel::Pool;
use crate::problem::{Dof6, Law, Problem, Row};
use crate::scene::Tolerance;
use crate::solver::residual::{Residual, Scale};

/// Tolerances of gap and slip, and of force, from which single precision finds impulses that double precision confirms.
const SINGLE: [f64; 2] = [1e-7, 1e-3];

/// A row that is no contact of spheres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Other {
    row: u32,
    scale: Scale,
    impulse: Vec3,
    previous: Vec3,
}

/// The compiled problem; its memory serves from solve to solve.
#[derive(Debug, Default)]
pub struct Kernel {
    pub(super) exact: Sheet<f64>,
    /// The rows of the blocks.
    pub(super) rows: Vec<Sixteen<u32>>,
    /// The same in single precision, while that is good enough.
    pub(super) quick: Sheet<f32>,
    /// Factor on the impulses of `quick`: the largest inverse mass.
    pub(super) unit: f64,
    pub(super) single: bool,
    pub(super) pool: Pool,
    pub(super) layout: Layout,
    pub(super) turns: Turns,
    /// Where each body is, `[N + D]`. Each part ends with a body that never moves, and driven bodies are behind them all.
    pub(super) place: Vec<u32>,
    /// Length by which each body's spin is scaled \[m\], `[N + D]`: its radius; zero until a contact gives it.
    pub(super) radius: Vec<f64>,
    pub(super) others: Vec<Other>,
    /// Velocities of the bodies that other rows move, while such a row is under way, `[N + D]`.
    pub(super) velocity: Vec<Dof6>,
    /// Whether a row is a contact with a resistance, `[C]`: both go with the other rows.
    pub(super) resisted: Vec<bool>,
    /// Rows of the blocks by group, and which group each is of.
    pub(super) order: Vec<u32>,
    pub(super) group: Vec<u32>,
    pub(super) by_place: Vec<u32>,
    pub(super) counts: Vec<u32>,
    /// Blocks in use while they fill.
    pub(super) used: usize,
    /// What [`Sheet::judge`] finds.
    pub(super) verdicts: Vec<Verdict>,
    /// For each body of the group that fills, by its place in it, the filling blocks that hold it, as bits.
    pub(super) held: Vec<u16>,
    pub(super) tolerance: Tolerance,
    pub(super) step: f64,
}

impl Kernel {
    /// Compiles `problem`, velocities being those of `impulses`.
    pub(super) fn compile(&mut self, problem: &Problem, tolerance: &Tolerance, impulses: &[Vec3]) {
        let spheres = problem.inverse_mass.len();
        self.tolerance = *tolerance;
        self.step = problem.step;
        let same = |v: &Vec3| v.x == v.y && v.y == v.z;
        self.radius.clear();
        self.radius.extend(problem.inverse_mass.iter().map(|w| {
            match same(&w.linear) && same(&w.angular) {
                true => 0.0,
                false => NO_SPHERE,
            }
        }));
        self.radius.resize(problem.free.len(), NO_SPHERE);
        refill(&mut self.velocity, problem.free.len(), Dof6::ZERO);
        refill(&mut self.resisted, problem.rows.len(), false);
        for row in &problem.rows {
            if let Law::Resistance { contact, .. } = row.law {
                self.resisted[contact as usize] = true;
            }
        }
        self.layout.fit(spheres);
        let (layout, parts) = (&self.layout, self.layout.parts());
        refill(&mut self.held, problem.free.len() + parts, 0);
        self.place.clear();
        self.place.extend((0..spheres).map(|i| {
            let (place, part) = layout.place(i);
            (place + part) as u32
        }));
        let driven = (spheres..problem.free.len()).map(|d| (d + parts) as u32);
        self.place.extend(driven);
        self.sort(problem);
        self.fill_groups(problem, impulses);
        self.take_others(problem, impulses);
        self.reload(problem);
        let [length, force] = SINGLE;
        self.single = self.others.is_empty()
            && tolerance.gap.min(tolerance.slip) >= length
            && tolerance.force >= force;
        if self.single {
            let masses = problem.inverse_mass.iter().map(|w| w.linear.max());
            self.unit = masses.fold(f64::MIN_POSITIVE, f64::max);
            let (turns, pool) = (&self.turns, &mut self.pool);
            self.exact.single(self.unit, turns, pool, &mut self.quick);
        }
    }

    /// Says how many threads to use and where the spheres are, `[N]` \[m\]; `diameter` \[m\] is the largest. Forgotten by a
    /// problem of another size.
    pub fn prepare(&mut self, threads: usize, centres: &[Vec3], diameter: f64) {
        if self.pool.threads() != threads {
            self.pool = Pool::new(threads);
        }
        self.layout.arrange(centres, diameter);
    }

    /// Whether sweeps are in single precision.
    pub(super) fn is_single(&self) -> bool {
        self.single
    }

    /// Leaves single precision behind.
    pub(super) fn refine(&mut self) {
        self.single = false;
    }

    /// Rows that are in no block.
    fn take_others(&mut self, problem: &Problem, impulses: &[Vec3]) {
        self.others.clear();
        for (k, row) in problem.rows.iter().enumerate() {
            if self.group[k] == NONE {
                self.others.push(Other {
                    row: k as u32,
                    scale: Scale::of_row(problem, row),
                    impulse: impulses[k],
                    previous: impulses[k],
                });
            }
        }
    }

    /// Takes the velocities of the impulses anew, without rounding from many sweeps.
    fn reload(&mut self, problem: &Problem) {
        let bodies = &mut self.exact.bodies;
        let parts = self.turns[0].len();
        refill(bodies, problem.free.len() + parts, Body::default());
        for (i, v) in problem.free.iter().enumerate() {
            let scale = scale(&self.radius, i);
            // Driven bodies move by other rows only, which have their own operator.
            let w = problem.inverse_mass.get(i).copied().unwrap_or(Dof6::ZERO);
            let (v, s) = (v.linear, v.angular * scale);
            let (m, k) = (w.linear.x, w.angular.x * scale * scale);
            bodies[self.place[i] as usize] = Body([v.x, v.y, v.z, m, s.x, s.y, s.z, k]);
        }
        self.exact.push(&self.turns, &mut self.pool);
        for at in 0..self.others.len() {
            let other = self.others[at];
            let row = &problem.rows[other.row as usize];
            self.see(row);
            self.give(problem, row, other.impulse);
        }
        self.exact.before.clone_from(&self.exact.bodies);
    }

    /// Writes the velocities of all bodies \[m/s\], \[rad/s\], `[N + D]`: those of the impulses that were judged last.
    pub fn velocities_into(&self, velocities: &mut Vec<Dof6>) {
        velocities.clear();
        let bodies = self.place.iter().enumerate();
        velocities.extend(bodies.map(|(i, &at)| self.velocity_of(i, at)));
    }

    /// Velocity of body `i` at place `at`.
    fn velocity_of(&self, i: usize, at: u32) -> Dof6 {
        let [a, b, c, _, d, e, f, _] = self.exact.bodies[at as usize].0;
        Dof6 {
            linear: Vec3::new(a, b, c),
            angular: Vec3::new(d, e, f) / scale(&self.radius, i),
        }
    }

    /// The residual of the impulses, with velocities taken anew from them, always in double precision.
    pub(super) fn judge(&mut self, problem: &Problem) -> Residual {
        if self.single {
            self.exact.take_impulses(self.unit, &self.quick);
        }
        self.reload(problem);
        if self.single {
            self.exact.single_bodies(self.unit, &mut self.quick);
        }
        let mut residual = Residual::default();
        let (turns, pool) = (&self.turns, &mut self.pool);
        self.exact.judge(turns, pool, &mut self.verdicts);
        let blocks = self.exact.blocks.iter().zip(&self.rows);
        for ((block, rows), [gaps, slips, forces, margins]) in blocks.zip(&self.verdicts) {
            for (lane, &row) in rows[..block.count as usize].iter().enumerate() {
                let values = [gaps[lane], slips[lane], forces[lane]];
                residual.include(row as usize, values, margins[lane]);
            }
        }
        for at in 0..self.others.len() {
            let other = self.others[at];
            let row = &problem.rows[other.row as usize];
            self.see(row);
            let (u, p) = (row.relative_velocity(&self.velocity), other.impulse);
            let load = self.load(problem, row);
            let correction = other.scale.correction(row, u, p, load);
            let values = other.scale.residuals(row, problem.step, &correction);
            let margin = other.scale.margin(row, u, p, load);
            residual.include(other.row as usize, values, margin);
        }
        residual
    }

    /// Velocities of the bodies of `row`.
    fn see(&mut self, row: &Row) {
        for i in row.bodies() {
            self.velocity[i] = self.velocity_of(i, self.place[i]);
        }
    }

    /// Gives the bodies of `row`, whose velocities are seen, an impulse.
    fn give(&mut self, problem: &Problem, row: &Row, impulse: Vec3) {
        problem.apply(row, &mut self.velocity, impulse);
        for i in row.bodies() {
            let Dof6 { linear, angular } = self.velocity[i];
            let spin = angular * scale(&self.radius, i);
            let body = &mut self.exact.bodies[self.place[i] as usize].0;
            body[..3].copy_from_slice(linear.as_slice());
            body[4..7].copy_from_slice(spin.as_slice());
        }
    }

    /// One sweep: the blocks, then the other rows.
    pub(super) fn sweep(&mut self, problem: &Problem, pace: Pace) -> Progress {
        if self.single {
            return self.quick.sweep(&self.turns, &mut self.pool, pace);
        }
        let mut progress = self.exact.sweep(&self.turns, &mut self.pool, pace);
        let mut change = Residual::default();
        for other in 0..self.others.len() {
            let [along, squared] = self.other(problem, pace, other, &mut change);
            progress.along += along;
            progress.change += squared;
        }
        progress.settled &= change.within(&self.tolerance.scaled(pace.strictness));
        progress
    }

    /// Solves one of the other rows, by the operations that every row has.
    fn other(
        &mut self,
        problem: &Problem,
        pace: Pace,
        at: usize,
        change: &mut Residual,
    ) -> [f64; 2] {
        let mut other = self.others[at];
        let row = &problem.rows[other.row as usize];
        self.see(row);
        let old = other.impulse;
        let p = old + (old - other.previous) * pace.momentum;
        let u = row.relative_velocity(&self.velocity);
        let correction = other.scale.correction(row, u, p, self.load(problem, row));
        let values = other.scale.residuals(row, problem.step, &correction);
        change.include(other.row as usize, values, 1.0);
        let full = row.normal * correction.normal + correction.tangential;
        let delta = full * pace.damping;
        other.impulse = p + delta;
        other.previous = old;
        self.others[at] = other;
        if delta != Vec3::zeros() {
            self.give(problem, row, delta);
        }
        [delta.dot(&(other.impulse - old)), full.norm_squared()]
    }

    /// Normal impulse \[N s\] that bounds a resistance; zero for all other rows.
    fn load(&self, problem: &Problem, row: &Row) -> f64 {
        let Law::Resistance { contact, .. } = row.law else {
            return 0.0;
        };
        let found = self
            .others
            .binary_search_by_key(&contact, |other| other.row);
        let normal = problem.rows[contact as usize].normal;
        found.map_or(0.0, |at| self.others[at].impulse.dot(&normal).max(0.0))
    }

    /// Writes the impulses of all rows \[N s\], `[C]`: those that were judged last.
    pub(super) fn store(&self, impulses: &mut [Vec3]) {
        for (block, rows) in self.exact.blocks.iter().zip(&self.rows) {
            let [x, y, z] = &block.impulse[self.exact.latest];
            for (lane, &row) in rows[..block.count as usize].iter().enumerate() {
                impulses[row as usize] = Vec3::new(x[lane], y[lane], z[lane]);
            }
        }
        for other in &self.others {
            impulses[other.row as usize] = other.impulse;
        }
    }
}

/// Radius of a body that does not move alike in all directions.
const NO_SPHERE: f64 = -1.0;
/// Group of a row that no block has.
pub(super) const NONE: u32 = u32::MAX;

/// Length by which the spin of body `i` is scaled \[m\].
fn scale(radius: &[f64], i: usize) -> f64 {
    match radius[i] {
        radius if radius > 0.0 => radius,
        _ => 1.0,
    }
}

/// `items` as so many copies of `value`.
pub(super) fn refill<T: Clone>(items: &mut Vec<T>, count: usize, value: T) {
    items.clear();
    items.resize(count, value);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::GROUND;
    use nalgebra::Vector3;

    /// A row of spheres of different sizes on the ground, pushed, with one row that is no contact of spheres.
    fn problem() -> Problem {
        let mut problem = Problem {
            step: 1e-3,
            ..Problem::default()
        };
        let radius = |i: usize| 0.01 * (1.0 + 0.1 * (i % 4) as f64);
        for i in 0..23 {
            let x = i as f64;
            let mass = 2e4 * radius(i).powi(3);
            problem.free.push(Dof6 {
                linear: Vector3::new(0.3 - 0.05 * x, 0.1 * (x * 1.7).sin(), -0.1),
                angular: Vector3::new((x * 0.9).cos(), 0.5, (x * 2.3).sin()),
            });
            let inverse = 1.0 / (0.4 * mass * radius(i) * radius(i));
            problem.inverse_mass.push(Dof6 {
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
                    arm_a: normal * -ra,
                    arm_b: if b == GROUND {
                        Vec3::zeros()
                    } else {
                        normal * rb
                    },
                    drift: Vec3::zeros(),
                    bias: normal * 0.01,
                    compliance_n: if a == 7 { 0.1 } else { 0.0 },
                    compliance_t: 0.0,
                    law: Law::Contact { mu: 0.3 },
                    radius: ra.min(rb),
                    impulse_scale: 1e-4,
                });
            }
        }
        problem
    }

    /// The oracle is the row's own operations, one row after the other in the order of the blocks.
    #[test]
    fn blocks_do_what_rows_do_one_after_the_other() {
        let problem = problem();
        let start: Vec<Vec3> = (0..problem.rows.len())
            .map(|k| problem.rows[k].normal * (1e-4 * (k % 5) as f64))
            .collect();
        let pace = Pace {
            momentum: 0.0,
            damping: 0.8,
            strictness: 1.0,
            tolerance: Tolerance::default(),
        };
        let mut kernel = Kernel::default();
        kernel.compile(&problem, &Tolerance::default(), &start);
        assert_eq!(kernel.others.len(), 2, "one springy sphere's rows");
        let blocks = kernel.exact.blocks.iter().zip(&kernel.rows);
        let rows = blocks.flat_map(|(block, rows)| &rows[..block.count as usize]);
        let mut order: Vec<u32> = rows.copied().collect();
        order.extend(kernel.others.iter().map(|other| other.row));
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..problem.rows.len() as u32));

        let mut expected = start.clone();
        let mut velocity = problem.velocities(&start);
        let mut found = start;
        for sweep in 0..3 {
            let progress = kernel.sweep(&problem, pace);
            kernel.store(&mut found);
            let mut change = 0.0;
            for &k in &order {
                let row = &problem.rows[k as usize];
                let p = &mut expected[k as usize];
                let scale = Scale::of_row(&problem, row);
                let correction = scale.correction(row, row.relative_velocity(&velocity), *p, 0.0);
                let full = row.normal * correction.normal + correction.tangential;
                change += full.norm_squared();
                *p += full * pace.damping;
                problem.apply(row, &mut velocity, full * pace.damping);
            }
            for (k, (p, q)) in found.iter().zip(&expected).enumerate() {
                assert!((p - q).norm() < 1e-15, "sweep {sweep}, row {k}: {p} {q}");
            }
            assert!((progress.change - change).abs() < 1e-9 * change);
            assert!(!progress.settled);
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
            let pace = Pace {
                momentum,
                damping: 1.0,
                strictness: 1.0,
                tolerance: Tolerance::default(),
            };
            kernel.sweep(&problem, pace);
        }
        kernel.store(&mut impulses);
        let velocity = problem.velocities(&impulses);
        for (i, v) in velocity.iter().enumerate() {
            let body = &kernel.exact.bodies[kernel.place[i] as usize].0;
            let (linear, spin) = (v.linear, v.angular * scale(&kernel.radius, i));
            for k in 0..3 {
                assert!((body[k] - linear[k]).abs() < 1e-12);
                assert!((body[k + 4] - spin[k]).abs() < 1e-12);
            }
        }
        kernel.judge(&problem);
        let mut judged = Vec::new();
        kernel.velocities_into(&mut judged);
        assert_eq!(judged.len(), velocity.len());
        for (found, expected) in judged.iter().zip(&velocity) {
            assert!((found.linear - expected.linear).norm() < 1e-12);
            assert!((found.angular - expected.angular).norm() < 1e-10);
        }
    }
}
