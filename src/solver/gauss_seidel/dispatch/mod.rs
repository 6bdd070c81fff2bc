//! Sweeps, pushes and judgements with the widest registers that the processor has, or those that are asked for.

use super::batch::{Batch, Extra, Form, Group, Progress, SweepParams, Vector};
use super::heavy::{Given, Heavy};
use super::lanes::{Body, FUSES, Lanes, Plain, Real, Sixteen};
use super::levers::{Levers, Shared};
use super::local::{Constants, Source};
use super::resistance::{self, Resistances};
use crate::Vec3;
use crate::solver::params::Registers;
use crate::solver::residual::Residual;

/// What a sweep goes over, in one precision: all of one group.
#[derive(Debug)]
pub(super) struct Sweep<'a, T> {
    pub(super) blocks: &'a mut [Batch<T>],
    /// By block.
    pub(super) unsettled: &'a mut [u16],
    pub(super) resistances: &'a mut [Resistances<T>],
    pub(super) bodies: &'a mut [Body<T>],
    pub(super) extras: &'a [Extra<T>],
    /// Of all groups.
    pub(super) levers: &'a [Levers<T>],
    pub(super) heavy: &'a [Heavy<T>],
    pub(super) form: Form,
    /// Which of the blocks' impulses are the last.
    pub(super) latest: usize,
    pub(super) pace: SweepParams,
}

/// Blocks' contacts in double precision.
#[derive(Debug, Clone, Copy)]
pub(super) struct Exact<'a> {
    pub(super) source: Source<'a>,
    /// Rows of each block.
    pub(super) rows: &'a [Sixteen<u32>],
    /// Resistances of those blocks that have such.
    pub(super) resistances: &'a [resistance::Source],
    /// By [`Batch::levers`].
    pub(super) levers: &'a [Levers<f64>],
    /// By [`Batch::heavy`].
    pub(super) heavy: &'a [Heavy<f64>],
}

impl Exact<'_> {
    /// Those of a group.
    pub(super) fn of(self, group: &Group) -> Self {
        Self {
            rows: &self.rows[group.blocks.clone()],
            resistances: &self.resistances[group.resistances.clone()],
            ..self
        }
    }
}

/// What fills blocks from `impulses`, `[C]`, and all else of their rows.
#[derive(Debug)]
pub(super) struct Fill<'a, T> {
    pub(super) exact: Exact<'a>,
    pub(super) blocks: &'a mut [Batch<T>],
    pub(super) impulses: &'a [Vec3],
}

/// What gives bodies their impulses.
#[derive(Debug)]
pub(super) struct Push<'a, T> {
    pub(super) exact: Exact<'a>,
    pub(super) blocks: (&'a [Batch<T>], &'a [Resistances<T>]),
    pub(super) bodies: &'a mut [Body<f64>],
    pub(super) latest: usize,
}

/// What finds out what the blocks' contacts are off by where the bodies move as the impulses make them.
#[derive(Debug)]
pub(super) struct Judge<'a, T> {
    pub(super) exact: Exact<'a>,
    pub(super) blocks: (&'a [Batch<T>], &'a [Resistances<T>]),
    pub(super) bodies: &'a [Body<f64>],
    pub(super) extras: &'a [Extra<f64>],
    pub(super) latest: usize,
}

/// Work on blocks that goes some numbers at a time.
pub(super) trait Task: Sized {
    /// Precision of its numbers.
    type Real: Real;
    /// What it finds.
    type Output;

    /// Does it with `lanes`.
    fn with<L: Lanes<Self::Real>>(self, lanes: L) -> Self::Output;
}

/// A precision with its registers.
pub(super) trait Precision: Real {
    /// Does `work` with these registers, narrower ones where the processor has none of them.
    fn with<W: Task<Real = Self>>(registers: Registers, work: W) -> W::Output;
}

macro_rules! precision {
    ($real:ty) => {
        impl Precision for $real {
            #[cfg_attr(not(target_arch = "x86_64"), expect(unused_variables))]
            fn with<W: Task<Real = Self>>(registers: Registers, work: W) -> W::Output {
                #[cfg(target_arch = "x86_64")]
                if registers == Registers::Widest
                    && let Some(lanes) = pulp::x86::V4::try_new()
                {
                    return lanes.vectorize(Job { work, lanes });
                }
                #[cfg(target_arch = "x86_64")]
                if registers != Registers::Plain
                    && let Some(lanes) = pulp::x86::V3::try_new()
                {
                    return lanes.vectorize(Job { work, lanes });
                }
                work.with(Plain::<4, FUSES>)
            }
        }
    };
}

precision!(f64);
precision!(f32);

/// Work with its lanes.
#[cfg(target_arch = "x86_64")]
struct Job<W, L> {
    work: W,
    lanes: L,
}

#[cfg(target_arch = "x86_64")]
impl<W: Task, L: Lanes<W::Real>> pulp::NullaryFnOnce for Job<W, L> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.work.with(self.lanes)
    }
}

impl<T: Real> Task for Sweep<'_, T> {
    type Real = T;
    type Output = Progress;

    #[inline(always)]
    fn with<L: Lanes<T>>(self, l: L) -> Progress {
        // Apart: in one loop plain blocks take longer.
        match (self.form, self.resistances.is_empty()) {
            (Form::Spheres, true) => self.over_blocks::<L, false, false, false>(l),
            (Form::Spheres, false) => self.over_blocks::<L, true, false, false>(l),
            (Form::Levered, _) => self.over_blocks::<L, true, true, false>(l),
            (Form::Heavy, _) => self.over_blocks::<L, false, false, true>(l),
        }
    }
}

impl<T: Real> Sweep<'_, T> {
    /// Over all blocks, of which some may have resistances, and some levers, or all are on heavy bodies.
    #[inline(always)]
    fn over_blocks<L: Lanes<T>, const RESISTED: bool, const LEVERED: bool, const HEAVY: bool>(
        self,
        l: L,
    ) -> Progress {
        let pace = Constants::of(l, &self.pace);
        let mut all_settled = true;
        // Lane by lane, so that every width sums in the same order.
        let mut along = Sixteen::<T>::default();
        let mut change = Sixteen::<T>::default();
        let (extras, latest) = (self.extras, self.latest);
        let mut resistances = self.resistances.iter_mut();
        for (block, unsettled) in self.blocks.iter_mut().zip(self.unsettled) {
            let mut resisted = match RESISTED && block.resisted {
                true => resistances.next(),
                false => None,
            };
            let levers = match LEVERED {
                true => block.levers(self.levers),
                false => None,
            };
            let mut shared = Shared::of(block, levers, self.bodies);
            let mut heavy = match HEAVY {
                true => Some((&self.heavy[block.heavy as usize], Given::none())),
                false => None,
            };
            let mut off = 0;
            for pass in block.passes::<L, T>() {
                let bodies = &mut *self.bodies;
                let (within, a, c) = match (levers, resisted.as_deref_mut()) {
                    _ if let Some((heavy, given)) = &mut heavy => {
                        let moved = (bodies, given);
                        block.update_on_heavy(l, pass, moved, (*heavy, extras), latest, &pace)
                    }
                    (None, None) => block.update(l, pass, bodies, extras, latest, &pace),
                    (None, Some(own)) => {
                        block.update_resisted(l, pass, (bodies, own), extras, latest, &pace)
                    }
                    (Some(levers), own) => {
                        let (moved, has) = ((bodies, &mut shared), (levers, own, extras));
                        block.update_levered(l, pass, moved, has, latest, &pace)
                    }
                };
                off |= (L::ALL & !within) << (pass * L::WIDTH);
                l.store(l.load(&along, pass) + a, &mut along, pass);
                l.store(l.load(&change, pass) + c, &mut change, pass);
            }
            *unsettled = off;
            all_settled &= off == 0;
            if let Some(shared) = shared {
                shared.finish(self.bodies);
            }
            if let Some((heavy, given)) = heavy {
                given.finish(heavy, self.bodies);
            }
        }
        let sum = |x: Sixteen<T>| x.iter().map(|x| x.exact()).sum();
        Progress {
            settled: all_settled,
            along: sum(along),
            change: sum(change),
        }
    }
}

/// What moves bodies on by `momentum` times their last change, and keeps where they were in `before`.
#[derive(Debug)]
pub(super) struct Drift<'a, T> {
    pub(super) bodies: &'a mut [Body<T>],
    pub(super) before: &'a mut [Body<T>],
    pub(super) momentum: f64,
}

impl<T: Real> Task for Drift<'_, T> {
    type Real = T;
    type Output = ();

    #[inline(always)]
    fn with<L: Lanes<T>>(self, _: L) {
        let momentum = T::of(self.momentum);
        for (body, before) in self.bodies.iter_mut().zip(self.before) {
            // Masses do not change, so that they stay.
            for (x, x_before) in body.0.iter_mut().zip(&mut before.0) {
                let now = *x;
                *x += momentum * (now - *x_before);
                *x_before = now;
            }
        }
    }
}

impl<T: Real> Task for Fill<'_, T> {
    type Real = f64;
    type Output = ();

    #[inline(always)]
    fn with<L: Lanes<f64>>(self, l: L) {
        let Exact { source, rows, .. } = self.exact;
        for (block, rows) in self.blocks.iter_mut().zip(rows) {
            block.fill(l, &source, rows);
            let mut impulse = Vector::<T>::default();
            for (lane, &row) in rows[..block.count as usize].iter().enumerate() {
                let p = &self.impulses[row as usize];
                for axis in 0..3 {
                    impulse[axis][lane] = T::of(p[axis] * source.unit);
                }
            }
            block.impulse = [impulse; 2];
        }
    }
}

impl<T: Real> Task for Push<'_, T> {
    type Real = f64;
    type Output = ();

    #[inline(always)]
    fn with<L: Lanes<f64>>(self, l: L) {
        let Exact {
            source,
            rows,
            resistances,
            levers,
            heavy,
        } = self.exact;
        let mut resisted = resistances.iter().zip(self.blocks.1);
        for (block, rows) in self.blocks.0.iter().zip(rows) {
            let (levers, heavy) = (block.levers(levers), block.heavy(heavy));
            let how = (levers, heavy);
            block.push(l, (&source, rows), how, self.bodies, self.latest);
            if block.resisted
                && let Some((own, held)) = resisted.next()
            {
                let impulse = held.exact(self.latest, source.unit);
                own.push(l, (block, levers), &impulse, self.bodies);
            }
        }
    }
}

impl<T: Real> Task for Judge<'_, T> {
    type Real = f64;
    type Output = Residual;

    #[inline(always)]
    fn with<L: Lanes<f64>>(self, l: L) -> Residual {
        let Exact {
            source,
            rows,
            resistances,
            levers,
            heavy,
        } = self.exact;
        let mut residual = Residual::default();
        let mut resisted = resistances.iter().zip(self.blocks.1);
        for (block, rows) in self.blocks.0.iter().zip(rows) {
            let moving = (self.bodies, self.extras);
            let (levers, heavy) = (block.levers(levers), block.heavy(heavy));
            let how = (levers, heavy);
            let found = block.judge(l, (&source, rows), how, moving, self.latest);
            let [gaps, slips, forces, margins] = found;
            for (lane, &row) in rows[..block.count as usize].iter().enumerate() {
                let values = [gaps[lane], slips[lane], forces[lane]];
                residual.include(row as usize, values, margins[lane]);
            }
            if block.resisted
                && let Some((own, held)) = resisted.next()
            {
                let impulses = [
                    &block.exact(self.latest, source.unit),
                    &held.exact(self.latest, source.unit),
                ];
                let contacts = (block, levers);
                let found = own.judge(l, contacts, (&source, rows), impulses, self.bodies);
                let [gaps, slips, forces, margins] = found;
                for (lane, row) in own.lanes() {
                    let values = [gaps[lane], slips[lane], forces[lane]];
                    residual.include(row, values, margins[lane]);
                }
            }
        }
        residual
    }
}

mod tests;
