//! A problem compiled for sweeps: contacts of spheres in blocks, every other row as it is.

use std::mem::take;
use std::ops::Range;

use arrayvec::ArrayVec;

use super::batch::{Batch, Extra, Grouped, Progress, SweepParams};
use super::batches::{BODIES, Batches, Colours, split};
use super::dispatch::Exact;
use super::general_rows::{Bodies, GeneralRows, spin_scale};
use super::heavy::Heavy;
use super::kinds::Kinds;
use super::lanes::{Body, Real, Sixteen};
use super::levers::{Bounds, Levers, alike};
use super::light::LightSpheres;
use super::local::Source;
use super::partition::{PARTS, Partition};
use super::resistance;
use super::seats::Seats;
use super::sharing::Sharing;
use crate::Vec3;
use crate::memory;
use crate::parallel::Pool;
use crate::problem::Problem;
use crate::solver::Tolerance;
use crate::solver::params::Registers;
use crate::solver::residual::Residual;
use crate::spatial::SpatialVector;

/// Tolerances of gap and slip, and of force, from which single precision finds impulses that double precision confirms.
const SINGLE: [f64; 2] = [1e-7, 1e-3];

/// The compiled problem; its memory serves from solve to solve.
#[derive(Debug, Default)]
pub struct Kernel {
    pub(super) contents: Contents,
    /// What contacts have beyond plain ones.
    pub(super) extras: Vec<Extra<f64>>,
    /// Whether sweeps go over `quick`, or over the blocks of `exact`, whose bodies are those that are judged in either case.
    pub(super) single: bool,
    pub(super) exact: Batches<f64>,
    pub(super) quick: Batches<f32>,
    /// Factor on the impulses of `quick`: about the largest inverse mass.
    pub(super) unit: f64,
    pub(super) pool: Pool,
    pub(super) layout: Partition,
    pub(super) turns: Colours,
    /// Where the bodies are that rows touch.
    pub(super) seats: Seats,
    /// Length by which each body's spin is scaled \[m\], `[N + M]`: its radius; zero where no contact gives it.
    pub(super) radius: Vec<f64>,
    pub(super) others: GeneralRows,
    light: LightSpheres,
    pub(super) kinds: Kinds,
    pub(super) sharing: Sharing,
    pub(super) grouped: Grouped,
    shared_out: SharedOut,
    pub(super) tolerance: Tolerance,
}

/// What the blocks are made of.
#[derive(Debug, Default)]
pub(super) struct Contents {
    /// Rows of each block.
    pub(super) rows: Vec<Sixteen<u32>>,
    /// Resistances, and levers, of those blocks that have such.
    pub(super) resistances: Vec<resistance::Source>,
    pub(super) levers: Vec<Levers<f64>>,
    /// Those that sweeps have instead, and where: those of bodies that contacts share.
    pub(super) split: Vec<(usize, Levers<f64>)>,
    /// Of those blocks whose contacts are on heavy bodies, and the bounds that sweeps have instead of theirs.
    pub(super) heavy: Vec<Heavy<f64>>,
    pub(super) heavy_parts: Vec<Bounds<f64>>,
}

/// What the share-out of rows among the blocks depends on beside the layout.
#[derive(Debug, Default)]
struct SharedOut {
    /// Bodies of the rows, `[C]`; empty where there were none, or another layout.
    bodies: Vec<[u32; 2]>,
    kinds: Kinds,
    sharing: Sharing,
    /// How many spheres, parts and bodies there were.
    counts: [usize; 3],
}

impl Contents {
    /// Levers and heavy bodies for sweeps, of inverse masses times `share`.
    fn swept<T: Real>(&self, share: f64, batches: &mut Batches<T>) {
        let (levers, heavy) = (&mut batches.levers, &mut batches.heavy);
        heavy.resize_with(self.heavy.len(), Heavy::default);
        for ((own, parts), swept) in self.heavy.iter().zip(&self.heavy_parts).zip(heavy) {
            own.write(parts, share, swept);
        }
        levers.resize_with(self.levers.len(), Levers::default);
        for (own, swept) in self.levers.iter().zip(&mut *levers) {
            own.write(share, swept);
        }
        for (k, own) in &self.split {
            own.write(share, &mut levers[*k]);
        }
    }

    /// Their contacts in double precision; impulses in the blocks are times `unit`.
    fn exact<'a>(&'a self, problem: &'a Problem, unit: f64) -> Exact<'a> {
        Exact {
            source: Source {
                numbers: problem.rows.compact(),
                step: problem.step,
                unit,
            },
            rows: &self.rows,
            resistances: &self.resistances,
            levers: &self.levers,
            heavy: &self.heavy,
        }
    }
}

impl Kernel {
    /// Compiles `problem`, velocities being those of `impulses`.
    pub(super) fn compile(&mut self, problem: &Problem, tolerance: &Tolerance, impulses: &[Vec3]) {
        let spheres = problem.inverse_mass.len();
        self.tolerance = *tolerance;
        self.layout.fit(spheres);
        let seated = self.is_seated(problem);
        if !seated {
            self.seats.assign(&self.layout, problem);
        }
        let same = |v: &Vec3| v.x == v.y && v.y == v.z;
        self.radius.resize(problem.free.len(), NO_SPHERE);
        let radius = |i: usize| match problem.inverse_mass.get(i) {
            Some(w) if same(&w.linear) && same(&w.angular) => problem.rows.radius_of(i),
            _ => NO_SPHERE,
        };
        self.pool.fill(&mut self.radius[..], radius);
        self.kinds
            .find(problem, &self.radius, &mut self.sharing, &self.pool);
        let [length, force] = SINGLE;
        let single = tolerance.gap.min(tolerance.slip) >= length && tolerance.force >= force;
        let known = single == self.single && seated && self.holds_alike();
        self.single = single;
        match single {
            true => {
                let mut blocks = take(&mut self.quick.blocks);
                self.make_blocks(problem, known, &mut blocks);
                self.quick.blocks = blocks;
                // Few problems need double precision: what the last such one left is not kept for the next.
                (self.exact.blocks, self.exact.before) = (Vec::new(), Vec::new());
                self.exact.resistances = Vec::new();
            }
            false => {
                let mut blocks = take(&mut self.exact.blocks);
                self.make_blocks(problem, known, &mut blocks);
                self.exact.blocks = blocks;
            }
        }
        let kinds = &self.kinds;
        self.others.take(problem, impulses, kinds.single());
        self.unit = match self.single {
            // Without its mantissa: powers of two leave all bits as they are, whichever spheres have a place.
            true => f64::from_bits(self.lightest(problem).to_bits() & f64::INFINITY.to_bits()),
            false => 1.0,
        };
        let exact = self.contents.exact(problem, self.unit);
        let (turns, pool) = (&self.turns, &self.pool);
        match self.single {
            true => {
                self.quick.fill(exact, impulses, turns, pool);
                self.contents.swept(1.0 / self.unit, &mut self.quick);
            }
            false => {
                self.exact.fill(exact, impulses, turns, pool);
                self.contents.swept(1.0, &mut self.exact);
            }
        }
        self.reload(problem);
        self.light.forget();
    }

    /// The largest inverse mass of a body that has a place.
    fn lightest(&self, problem: &Problem) -> f64 {
        let others = problem.operators.iter().map(|w| w.linear.diagonal().max());
        let others = others.fold(f64::MIN_POSITIVE, f64::max);
        let of_bodies = |_, places: Range<usize>| {
            let spheres = self.seats.at(places).flatten();
            let masses = spheres.filter_map(|i| Some(problem.inverse_mass.get(i)?.linear.max()));
            masses.fold(others, f64::max)
        };
        self.pool.pieces(0..self.seats.count(), of_bodies, f64::max)
    }

    /// Whether bodies have the places that they would get for `problem`.
    fn is_seated(&self, problem: &Problem) -> bool {
        let (bodies, shared_out) = (problem.rows.all_bodies(), &self.shared_out);
        !shared_out.bodies.is_empty()
            && shared_out.bodies == bodies
            && shared_out.counts == self.counts(problem)
    }

    /// How many spheres, parts and bodies there are.
    fn counts(&self, problem: &Problem) -> [usize; 3] {
        let spheres = problem.inverse_mass.len();
        [spheres, self.layout.parts(), problem.free.len()]
    }

    /// Whether rows of the same bodies would be shared out as those in the blocks were.
    fn holds_alike(&self) -> bool {
        self.shared_out.kinds == self.kinds && self.shared_out.sharing == self.sharing
    }

    /// Makes `blocks` those of `problem`; they are `known` to have its rows.
    fn make_blocks<T: Real>(&mut self, problem: &Problem, known: bool, blocks: &mut Vec<Batch<T>>) {
        if !known {
            self.divide(problem, blocks);
        }
        self.equip(problem, blocks);
        self.add_extras(&problem.rows, blocks);
    }

    /// Puts the rows into blocks.
    fn divide<T: Real>(&mut self, problem: &Problem, blocks: &mut Vec<Batch<T>>) {
        self.share_out(problem, blocks);
        let counts = self.counts(problem);
        let shared_out = &mut self.shared_out;
        memory::copy(&mut shared_out.bodies, problem.rows.all_bodies());
        shared_out.kinds.clone_from(&self.kinds);
        shared_out.sharing.clone_from(&self.sharing);
        shared_out.counts = counts;
    }

    /// Says where the spheres are, `[N]` \[m\], whose largest diameter is `diameter` \[m\]; and of each body behind them, `[M]`, a sphere
    /// that moves with it and has no row, if there is one. Forgotten by a problem of another size.
    pub fn prepare(
        &mut self,
        centres: &[Vec3],
        diameter: f64,
        members: impl Iterator<Item = Option<usize>>,
    ) {
        if self
            .layout
            .arrange((centres, diameter), members, &self.pool)
        {
            self.shared_out.bodies.clear();
        }
    }

    /// Its threads, so many of them. Sweeps then use these registers.
    pub(crate) fn pool(&mut self, threads: usize, registers: Registers) -> Pool {
        self.exact.registers = registers;
        self.quick.registers = registers;
        if self.pool.threads() != threads {
            self.pool = Pool::new(threads);
        }
        self.pool.clone()
    }

    /// Whether sweeps are in single precision.
    pub(super) fn is_single(&self) -> bool {
        self.single
    }

    /// Leaves single precision behind, after a judgement.
    pub(super) fn refine(&mut self, problem: &Problem, impulses: &mut [Vec3]) {
        self.store(problem, impulses);
        let emptied = |block: &Batch<f32>| Batch {
            bodies: block.bodies,
            count: block.count,
            extra: block.extra,
            levers: block.levers,
            heavy: block.heavy,
            resisted: block.resisted,
            ..Batch::default()
        };
        self.exact.blocks.clear();
        self.exact
            .blocks
            .extend(self.quick.blocks.iter().map(emptied));
        (self.single, self.unit) = (false, 1.0);
        let exact = self.contents.exact(problem, self.unit);
        self.exact.fill(exact, impulses, &self.turns, &self.pool);
        self.contents.swept(1.0, &mut self.exact);
        self.start_exact();
    }

    /// Lets sweeps in double precision start where the bodies are, as if they had not moved before.
    fn start_exact(&mut self) {
        self.exact.before.clone_from(&self.exact.bodies);
        self.exact.extras.clone_from(&self.extras);
    }

    /// Takes the velocities of the impulses anew, without rounding from many sweeps.
    fn reload(&mut self, problem: &Problem) {
        let mut bodies = take(&mut self.exact.bodies);
        self.free(problem, &mut bodies);
        let exact = self.contents.exact(problem, self.unit);
        let (turns, pool) = (&self.turns, &self.pool);
        match self.single {
            true => self.quick.push(exact, turns, pool, &mut bodies),
            false => self.exact.push(exact, turns, pool, &mut bodies),
        }
        self.exact.bodies = bodies;
        let mut bodies = Bodies::of(&mut self.exact.bodies, self.seats.places(), &self.radius);
        self.others.push(problem, &mut bodies);
        match self.single {
            true => self
                .quick
                .place(&self.exact.bodies, &self.extras, self.unit, &self.pool),
            false => self.start_exact(),
        }
    }

    /// Places all bodies as they move without impulses.
    fn free(&self, problem: &Problem, bodies: &mut Vec<Body<f64>>) {
        let (seats, spheres) = (&self.seats, problem.inverse_mass.len());
        bodies.resize(seats.count(), Body::default());
        let body = |i: usize| {
            let (v, scale) = (&problem.free[i], spin_scale(&self.radius, i));
            // Of others each contact says how they turn, and how they move if not alike in all directions.
            let (m, k) = match i.checked_sub(spheres) {
                None => {
                    let w = &problem.inverse_mass[i];
                    (w.linear.x, w.angular.x * scale * scale)
                }
                Some(other) => (alike(&problem.operators[other].linear).unwrap_or(0.0), 0.0),
            };
            let (v, s) = (v.linear, v.angular * scale);
            Body([v.x, v.y, v.z, m, s.x, s.y, s.z, k])
        };
        let behind = seats.behind();
        let place = |places: Range<usize>, own: &mut [Body<f64>]| {
            for (own, who) in own.iter_mut().zip(seats.at(places)) {
                *own = who.map_or_else(Body::default, body);
            }
        };
        let (parts, others) = bodies.split_at_mut(behind.start);
        place(behind, others);
        let ranges = self.turns[0].iter().map(|group| group.bodies.clone());
        let mut own: ArrayVec<_, PARTS> = split(parts, ranges.clone())
            .into_iter()
            .zip(ranges)
            .collect();
        self.pool
            .each(seats.count() / BODIES, &mut own, |(own, places)| {
                place(places.clone(), own)
            });
    }

    /// Writes the velocities of all bodies \[m/s\], \[rad/s\], `[N + M]`: those of the impulses that were judged last.
    pub(crate) fn velocities_into(&self, problem: &Problem, velocities: &mut Vec<SpatialVector>) {
        velocities.resize(problem.free.len(), SpatialVector::ZERO);
        let bodies = &self.exact.bodies[..];
        let of = |i: usize| match self.seats.of(i) {
            Some(place) => bodies[place].velocity(spin_scale(&self.radius, i)),
            None => problem.free[i],
        };
        self.pool.fill(&mut velocities[..], of);
    }

    /// The residual of the impulses, with velocities taken anew from them, always in double precision.
    pub(super) fn judge(&mut self, problem: &Problem) -> Residual {
        self.reload(problem);
        let exact = self.contents.exact(problem, self.unit);
        let (turns, pool) = (&self.turns, &self.pool);
        let moving = (&self.exact.bodies[..], &self.extras[..]);
        let mut residual = match self.single {
            true => self.quick.judge(exact, moving, turns, pool),
            false => self.exact.judge(exact, moving, turns, pool),
        };
        let bodies = Bodies::of(&mut self.exact.bodies, self.seats.places(), &self.radius);
        self.others.judge(problem, &bodies, &mut residual);
        residual
    }

    /// One sweep: the blocks, then the other rows.
    pub(super) fn sweep(&mut self, problem: &Problem, pace: SweepParams) -> Progress {
        let (turns, pool) = (&self.turns, &self.pool);
        let blocks = match self.single {
            true => self.quick.sweep(turns, pool, pace),
            false => self.exact.sweep(turns, pool, pace),
        };
        let (place, radius, others) = (self.seats.places(), &self.radius, &mut self.others);
        let others = match self.single {
            true => {
                let mut bodies = Bodies::of(&mut self.quick.bodies, place, radius);
                others.sweep(problem, &pace, &mut bodies)
            }
            false => {
                let mut bodies = Bodies::of(&mut self.exact.bodies, place, radius);
                others.sweep(problem, &pace, &mut bodies)
            }
        };
        // Blocks have their impulses times a unit.
        let unit = self.unit * self.unit;
        blocks.with(&Progress {
            settled: others.settled,
            along: others.along * unit,
            change: others.change * unit,
        })
    }

    /// Solves light spheres between heavy ones with all their contacts, where the last sweep found one not settled.
    pub(super) fn solve_light_spheres(&mut self) {
        match self.single {
            true => self.light.solve(&mut self.quick, &self.turns),
            false => self.light.solve(&mut self.exact, &self.turns),
        }
    }

    /// Writes the impulses of all rows \[N s\], `[C]`: those that were judged last.
    pub(super) fn store(&self, problem: &Problem, impulses: &mut [Vec3]) {
        let exact = self.contents.exact(problem, self.unit);
        let (lanes, pool) = (&self.grouped.lanes[..], &self.pool);
        match self.single {
            true => self.quick.store(exact, lanes, pool, impulses),
            false => self.exact.store(exact, lanes, pool, impulses),
        }
        self.others.store(impulses);
    }
}

/// Radius of a body that does not move alike in all directions.
const NO_SPHERE: f64 = -1.0;

mod tests;
