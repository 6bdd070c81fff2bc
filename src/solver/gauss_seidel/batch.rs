//! Contacts of spheres in blocks, and how a sweep over them goes.

use std::ops::Range;
use std::sync::atomic::AtomicU32;

use super::lanes::{Real, Sixteen};
use crate::solver::Tolerance;

/// A vector of each of sixteen contacts, by components.
pub(super) type Vector<T> = [Sixteen<T>; 3];

/// [`Batch::extra`] where all contacts are plain, likewise [`Batch::levers`] and [`Batch::heavy`].
pub(super) const PLAIN: u32 = u32::MAX;

/// What contacts of a block have beyond plain ones.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Extra<T> {
    /// Velocities of moving ground, and biases across the normal \[m/s\].
    pub(super) velocity: Vector<T>,
    /// Compliances along the normal and across it \[1/kg\].
    pub(super) compliance: [Sixteen<T>; 2],
}

/// Contacts without a common moving body. What a sweep needs and no more: it lasts as long as memory takes to bring this.
/// Lanes beyond `count` are contacts of a body that never moves with itself.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C, align(64))]
pub(super) struct Batch<T> {
    /// Normals.
    pub(super) normal: Vector<T>,
    /// Impulses \[N s\] after the last sweep, at [`Batches::latest`](super::batches::Batches::latest), and after the last but one.
    pub(super) impulse: [Vector<T>; 2],
    /// Biases along the normal \[m/s\].
    pub(super) bias: Sixteen<T>,
    /// Friction coefficients.
    pub(super) friction: Sixteen<T>,
    /// Squares of the radius over the step \[m^2/s^2\], the scale of gap and slip.
    pub(super) length: Sixteen<T>,
    /// Squared scales of the force residual \[N^2 s^2\].
    pub(super) scale: Sixteen<T>,
    /// Bodies A and B, counted from the first one of the group.
    pub(super) bodies: [Sixteen<u32>; 2],
    /// How many contacts there are.
    pub(super) count: u32,
    /// Which of [`Batches::extras`](super::batches::Batches::extras) these contacts have; [`PLAIN`] without any.
    pub(super) extra: u32,
    /// Which of [`Batches::levers`](super::batches::Batches::levers) these contacts have; [`PLAIN`] where all are of spheres.
    pub(super) levers: u32,
    /// Which of [`Batches::heavy`](super::batches::Batches::heavy) these contacts have; [`PLAIN`] where they are on no heavy body.
    pub(super) heavy: u32,
    /// Whether some of these contacts have resistances, which are the next ones of the group.
    pub(super) resisted: bool,
}

/// Blocks that are swept together, their resistances, and the bodies they move.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Group {
    pub(super) blocks: Range<usize>,
    pub(super) resistances: Range<usize>,
    pub(super) bodies: Range<usize>,
    pub(super) form: Form,
}

/// The contacts of blocks by group; its memory serves from problem to problem.
#[derive(Debug, Default)]
pub(super) struct Grouped {
    /// Of what group each row is, `[C]`, or [`NONE`](super::kinds::NONE).
    pub(super) group: Vec<u32>,
    /// The contacts in order, and where those of each group end.
    pub(super) order: Vec<u32>,
    pub(super) ends: Vec<u32>,
    /// Where each of `order` is among the lanes of its group's blocks.
    pub(super) slots: Vec<u32>,
    /// Where each row is among the lanes of all blocks, `[C]`, or [`NONE`](super::kinds::NONE): groups write theirs side by side.
    pub(super) lanes: Vec<AtomicU32>,
}

/// What contacts the blocks of a group have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// Of spheres, some with resistances.
    Spheres,
    /// Likewise; some have levers.
    Levered,
    /// Of spheres on heavy bodies.
    Heavy,
}

/// How a sweep goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct SweepParams {
    /// Share of the last sweep's change by which a contact's impulse is moved before it is solved.
    pub(super) momentum: f64,
    /// Share of a contact's correction that is applied.
    pub(super) damping: f64,
    /// Share of the tolerances that counts as settled.
    pub(super) strictness: f64,
    /// The tolerances.
    pub(super) tolerance: Tolerance,
}

/// What a block's contacts are off by, each lane: gap, slip and force residual, and margin.
pub(super) type BatchResidual = [Sixteen<f64>; 4];

/// What a sweep saw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Progress {
    /// Whether every contact was within the tolerances when its turn came.
    pub(super) settled: bool,
    /// Corrections times changes of the impulses \[N^2 s^2\]: negative where momentum leads astray.
    pub(super) along: f64,
    /// Squared corrections \[N^2 s^2\], before damping.
    pub(super) change: f64,
}

impl Progress {
    /// Of no contact.
    pub(super) const NONE: Self = Self {
        settled: true,
        along: 0.0,
        change: 0.0,
    };

    /// With that of other contacts.
    pub(super) fn with(self, other: &Self) -> Self {
        Self {
            settled: self.settled && other.settled,
            along: self.along + other.along,
            change: self.change + other.change,
        }
    }
}

impl<T: Real> Batch<T> {
    /// Zeros in lane `first` and all beyond, but for the impulses.
    pub(super) fn clear_from(&mut self, first: usize) {
        let numbers = [&mut self.bias, &mut self.friction];
        let squares = [&mut self.length, &mut self.scale];
        for lanes in self.normal.iter_mut().chain(numbers).chain(squares) {
            lanes[first..].fill(T::default());
        }
    }
}
