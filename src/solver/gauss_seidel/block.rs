//! Contacts of spheres in blocks, and how a sweep over them goes.

use super::lanes::{Body, Eight, Real};

/// A vector of each of eight contacts, by components.
pub(super) type Vector<T> = [Eight<T>; 3];

/// Contacts without a common moving body; lanes beyond `count` hold zeros.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C, align(64))]
pub(super) struct Block<T> {
    /// Normals.
    pub(super) normal: Vector<T>,
    /// Impulses after the last sweep \[N s\].
    pub(super) impulse: Vector<T>,
    /// Impulses after the last but one.
    pub(super) previous: Vector<T>,
    /// Biases with the ground's velocity \[m/s\].
    pub(super) bias: Vector<T>,
    /// Friction coefficients.
    pub(super) friction: Eight<T>,
    /// `1/w_n` and `1/w_t` \[kg\]; zero where nothing moves.
    pub(super) mass: [Eight<T>; 2],
    /// Squared corrections that the tolerances of gap and slip allow \[N^2 s^2\].
    pub(super) allowed: [Eight<T>; 2],
    /// Squared scale of the force residual \[N^2 s^2\].
    pub(super) scale: Eight<T>,
    /// Bodies A and B.
    pub(super) bodies: [[u32; 8]; 2],
    /// The rows.
    pub(super) rows: [u32; 8],
    /// How many contacts there are.
    pub(super) count: usize,
}

/// How a sweep goes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    /// Share of the last sweep's change by which a contact's impulse is moved before it is solved.
    pub(super) momentum: f64,
    /// Share of a contact's correction that is applied.
    pub(super) damping: f64,
    /// Share of the tolerances that counts as settled.
    pub(super) strictness: f64,
    /// Tolerance of the force residual.
    pub(super) force: f64,
}

/// What a block's contacts are off by, each lane: gap and slip residual over their tolerances, force residual, and margin.
pub(super) type Verdict = [Eight<f64>; 4];

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

impl Block<f64> {
    /// Zeros in the lanes beyond `count`.
    pub(super) fn clear_rest(&mut self) {
        let vectors = [
            &mut self.normal,
            &mut self.impulse,
            &mut self.previous,
            &mut self.bias,
        ];
        let others = [&mut self.friction, &mut self.scale];
        let pairs = [&mut self.mass, &mut self.allowed];
        let numbers = vectors.into_iter().flatten().chain(others);
        for lanes in numbers.chain(pairs.into_iter().flatten()) {
            lanes[self.count..].fill(0.0);
        }
    }

    /// Itself in single precision, impulses and masses times `unit`.
    pub(super) fn single(&self, unit: f64) -> Block<f32> {
        let number = |x: &Eight<f64>, unit: f64| x.map(|x| (x * unit) as f32);
        let vector = |v: &Vector<f64>, unit: f64| [0, 1, 2].map(|k| number(&v[k], unit));
        Block {
            normal: vector(&self.normal, 1.0),
            impulse: vector(&self.impulse, unit),
            previous: vector(&self.previous, unit),
            bias: vector(&self.bias, 1.0),
            friction: number(&self.friction, 1.0),
            mass: [0, 1].map(|k| number(&self.mass[k], unit)),
            allowed: [0, 1].map(|k| number(&self.allowed[k], unit * unit)),
            scale: number(&self.scale, unit * unit),
            bodies: self.bodies,
            rows: self.rows,
            count: self.count,
        }
    }
}

/// Moves `bodies` on by `momentum` times their last change, and keeps where they were in `before`.
pub(super) fn drift<T: Real>(bodies: &mut [Body<T>], before: &mut [Body<T>], momentum: f64) {
    let momentum = T::of(momentum);
    for (body, before) in bodies.iter_mut().zip(before) {
        let now = *body;
        // Masses do not change, so that they stay.
        for (x, x_before) in body.0.iter_mut().zip(before.0) {
            *x += momentum * (*x - x_before);
        }
        *before = now;
    }
}
