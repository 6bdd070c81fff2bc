//! Numbers of a block's contacts, some at a time: in registers where the processor has such, else one after the other, with
//! the same bits.

use std::fmt::Debug;
use std::ops::{Add, Mul, Sub};

/// A body as blocks see it: velocity \[m/s\] and inverse mass \[1/kg\], `R w` \[m/s\] and `R^2/I` \[1/kg\].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[repr(C, align(32))]
pub(super) struct Body<T>(pub(super) [T; 8]);

/// Contacts of a block.
pub(super) const LANES: usize = 16;

/// A number of each contact of a block, in memory.
pub(super) type Sixteen<T> = [T; LANES];

/// Single or double precision.
pub(super) trait Real:
    Copy
    + Default
    + Debug
    + Send
    + Sync
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + std::ops::Div<Output = Self>
    + std::ops::AddAssign
{
    /// The nearest.
    fn of(x: f64) -> Self;
    /// Exactly.
    fn exact(self) -> f64;
    /// Square root.
    fn root(self) -> Self;
}

impl Real for f64 {
    fn of(x: f64) -> Self {
        x
    }
    fn exact(self) -> f64 {
        self
    }
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Real for f32 {
    fn of(x: f64) -> Self {
        x as Self
    }
    fn exact(self) -> f64 {
        f64::from(self)
    }
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// A register's numbers.
pub(super) trait Pack:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// `self / other`.
    fn over(self, other: Self) -> Self;
    /// Square roots.
    fn root(self) -> Self;
    /// The larger ones; of equal ones, and where one is no number, `other`.
    fn or_larger(self, other: Self) -> Self;
    /// `yes` where `self <= limit`, else `no`.
    fn within(self, limit: Self, yes: Self, no: Self) -> Self;
    /// Which are `<= limit`: a bit each, the first number's the lowest.
    fn bits_within(self, limit: Self) -> u16;
}

/// What makes packs of numbers `T`: the proof that the processor has the registers. A block takes one pass or more.
pub(super) trait Lanes<T>: Copy {
    /// Its pack.
    type Pack: Pack;
    /// Numbers of a pack.
    const WIDTH: usize;
    /// Passes over a block.
    const PASSES: usize = LANES / Self::WIDTH;
    /// [`Pack::bits_within`] where all are.
    const ALL: u16 = u16::MAX >> (LANES - Self::WIDTH);

    /// The same number everywhere.
    fn splat(self, x: T) -> Self::Pack;
    /// Those of pass `pass`.
    fn load(self, x: &Sixteen<T>, pass: usize) -> Self::Pack;
    /// Likewise to memory.
    fn store(self, pack: Self::Pack, x: &mut Sixteen<T>, pass: usize);
    /// The bodies that the pass's part of `at` names, by components.
    fn gather(self, bodies: &[Body<T>], at: &Sixteen<u32>, pass: usize) -> [Self::Pack; 8];
    /// Puts them back.
    fn scatter(
        self,
        packs: [Self::Pack; 8],
        bodies: &mut [Body<T>],
        at: &Sixteen<u32>,
        pass: usize,
    );
}

/// One after the other, `W` in a pass.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plain<const W: usize>;

#[derive(Debug, Clone, Copy)]
pub(super) struct Many<T, const W: usize>([T; W]);

impl<T: Real, const W: usize> Many<T, W> {
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        Self(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
}

impl<T: Real, const W: usize> Lanes<T> for Plain<W> {
    type Pack = Many<T, W>;
    const WIDTH: usize = W;

    fn splat(self, x: T) -> Many<T, W> {
        Many([x; W])
    }

    fn load(self, x: &Sixteen<T>, pass: usize) -> Many<T, W> {
        Many(std::array::from_fn(|k| x[pass * W + k]))
    }

    fn store(self, pack: Many<T, W>, x: &mut Sixteen<T>, pass: usize) {
        x[pass * W..][..W].copy_from_slice(&pack.0);
    }

    fn gather(self, bodies: &[Body<T>], at: &Sixteen<u32>, pass: usize) -> [Many<T, W>; 8] {
        let body = |lane: usize| &bodies[at[pass * W + lane] as usize].0;
        std::array::from_fn(|k| Many(std::array::from_fn(|lane| body(lane)[k])))
    }

    fn scatter(
        self,
        packs: [Many<T, W>; 8],
        bodies: &mut [Body<T>],
        at: &Sixteen<u32>,
        pass: usize,
    ) {
        for lane in 0..W {
            bodies[at[pass * W + lane] as usize] = Body(packs.map(|pack| pack.0[lane]));
        }
    }
}

impl<T: Real, const W: usize> Add for Many<T, W> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl<T: Real, const W: usize> Sub for Many<T, W> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl<T: Real, const W: usize> Mul for Many<T, W> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl<T: Real, const W: usize> Pack for Many<T, W> {
    fn over(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }

    fn root(self) -> Self {
        Self(self.0.map(T::root))
    }

    fn or_larger(self, other: Self) -> Self {
        self.with(other, |a, b| if a > b { a } else { b })
    }

    fn within(self, limit: Self, yes: Self, no: Self) -> Self {
        let lane = |k: usize| match self.0[k] <= limit.0[k] {
            true => yes.0[k],
            false => no.0[k],
        };
        Self(std::array::from_fn(lane))
    }

    fn bits_within(self, limit: Self) -> u16 {
        (0..W).fold(0, |bits, k| bits | u16::from(self.0[k] <= limit.0[k]) << k)
    }
}
