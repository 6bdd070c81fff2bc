//! Numbers of a block's contacts, some at a time: in registers where the processor has such, else one after the other.

use std::fmt::Debug;
use std::ops::{Add, Mul, Sub};

use crate::problem::SphereContact;
use crate::problem::law::Number;

/// A body as blocks see it: velocity \[m/s\] and inverse mass \[1/kg\], `R w` \[m/s\] and `R^2/I` \[1/kg\].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[repr(C, align(32))]
pub(super) struct Body<T>(pub(super) [T; 8]);

/// Eight numbers in a row that lanes read as columns.
pub(super) trait Eight<T> {
    /// The numbers.
    fn eight(&self) -> [T; 8];
}

impl<T: Copy> Eight<T> for Body<T> {
    #[inline(always)]
    fn eight(&self) -> [T; 8] {
        self.0
    }
}

impl Eight<f64> for SphereContact {
    #[inline(always)]
    fn eight(&self) -> [f64; 8] {
        self.0
    }
}

/// Contacts of a block.
pub(super) const LANES: usize = 16;

/// A number of each contact of a block, in memory.
pub(super) type Sixteen<T> = [T; LANES];

/// What `change` makes of each number: unlike `map` it is compiled for the registers of who calls it.
#[inline(always)]
pub(super) fn changed<A: Copy, B: Copy + Default>(
    x: &Sixteen<A>,
    change: impl Fn(A) -> B,
) -> Sixteen<B> {
    let mut found = Sixteen::default();
    for lane in 0..LANES {
        found[lane] = change(x[lane]);
    }
    found
}

/// The sum, by halves, so that registers of every width add in the same order.
#[inline(always)]
pub(super) fn sum_by_halves<T: Real>(mut x: Sixteen<T>) -> T {
    let mut half = LANES / 2;
    while half > 0 {
        for lane in 0..half {
            x[lane] += x[lane + half];
        }
        half /= 2;
    }
    x[0]
}

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
    + std::ops::Neg<Output = Self>
    + std::ops::AddAssign
{
    /// The nearest.
    fn of(x: f64) -> Self;
    /// Exactly.
    fn exact(self) -> f64;
    /// Square root.
    fn root(self) -> Self;
    /// `self + a * b`, rounded once.
    fn fused(self, a: Self, b: Self) -> Self;
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
    fn fused(self, a: Self, b: Self) -> Self {
        a.mul_add(b, self)
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
    fn fused(self, a: Self, b: Self) -> Self {
        a.mul_add(b, self)
    }
}

/// A register's numbers.
pub(super) trait Pack:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// `self + a * b`.
    fn plus(self, a: Self, b: Self) -> Self;
    /// `self - a * b`.
    fn less(self, a: Self, b: Self) -> Self;
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

impl<P: Pack> Number for P {
    #[inline(always)]
    fn over(self, other: Self) -> Self {
        Pack::over(self, other)
    }

    #[inline(always)]
    fn root(self) -> Self {
        Pack::root(self)
    }

    #[inline(always)]
    fn or_larger(self, other: Self) -> Self {
        Pack::or_larger(self, other)
    }

    #[inline(always)]
    fn within(self, limit: Self, yes: Self, no: Self) -> Self {
        Pack::within(self, limit, yes, no)
    }
}

/// Bodies A and B by components.
pub(super) type Columns<P> = [[P; 8]; 2];

/// [`Lanes::between`] of bodies by components.
#[inline(always)]
pub(super) fn between<P: Pack>([a, b]: &Columns<P>) -> [P; 8] {
    [
        a[0] - b[0],
        a[1] - b[1],
        a[2] - b[2],
        a[3] + b[3],
        a[4] + b[4],
        a[5] + b[5],
        a[6] + b[6],
        a[7] + b[7],
    ]
}

/// [`Lanes::pushed`] of bodies by components.
#[inline(always)]
pub(super) fn pushed<P: Pack>([mut a, mut b]: Columns<P>, d: [P; 3], c: [P; 3]) -> Columns<P> {
    for k in 0..3 {
        a[k] = a[k].plus(a[3], d[k]);
        b[k] = b[k].less(b[3], d[k]);
        a[k + 4] = a[k + 4].less(a[7], c[k]);
        b[k + 4] = b[k + 4].less(b[7], c[k]);
    }
    [a, b]
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
    /// The items that the pass's part of `at` names, in whatever order takes the least.
    fn fetch(self, items: &[impl Eight<T>], at: &Sixteen<u32>, pass: usize) -> [Self::Pack; 8];
    /// Items as fetched, by components.
    fn columns(self, rows: [Self::Pack; 8]) -> [Self::Pack; 8];
    /// Items by components, as fetched.
    fn rows(self, columns: [Self::Pack; 8]) -> [Self::Pack; 8];
    /// Puts bodies back.
    fn put(self, packs: [Self::Pack; 8], bodies: &mut [Body<T>], at: &Sixteen<u32>, pass: usize);
    /// Of bodies A and B as fetched, by components: velocity of A less that of B, and sums of all else.
    fn between(self, ab: [[Self::Pack; 8]; 2]) -> [Self::Pack; 8];
    /// Bodies A and B as fetched, after the impulses `d` and the turns `c`: `v_A + m_A d`, `v_B - m_B d` and `s - k c`.
    fn pushed(
        self,
        ab: [[Self::Pack; 8]; 2],
        d: [Self::Pack; 3],
        c: [Self::Pack; 3],
    ) -> [[Self::Pack; 8]; 2];
}

/// One after the other, `W` in a pass. Rounds as registers do if `FUSED`, else multiplications and additions each on their own:
/// many times as fast on a processor that cannot fuse them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plain<const W: usize, const FUSED: bool>;

/// Whether the processor that this is built for can fuse.
pub(super) const FUSES: bool = cfg!(any(target_arch = "aarch64", target_feature = "fma"));

#[derive(Debug, Clone, Copy)]
pub(super) struct Many<T, const W: usize, const FUSED: bool>([T; W]);

impl<T: Real, const W: usize, const FUSED: bool> Many<T, W, FUSED> {
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        Self(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
}

impl<T: Real, const W: usize, const FUSED: bool> Lanes<T> for Plain<W, FUSED> {
    type Pack = Many<T, W, FUSED>;
    const WIDTH: usize = W;

    fn splat(self, x: T) -> Many<T, W, FUSED> {
        Many([x; W])
    }

    fn load(self, x: &Sixteen<T>, pass: usize) -> Many<T, W, FUSED> {
        Many(std::array::from_fn(|k| x[pass * W + k]))
    }

    fn store(self, pack: Many<T, W, FUSED>, x: &mut Sixteen<T>, pass: usize) {
        x[pass * W..][..W].copy_from_slice(&pack.0);
    }

    fn fetch(self, items: &[impl Eight<T>], at: &Sixteen<u32>, pass: usize) -> [Self::Pack; 8] {
        let item = |lane: usize| items[at[pass * W + lane] as usize].eight();
        std::array::from_fn(|k| Many(std::array::from_fn(|lane| item(lane)[k])))
    }

    fn columns(self, columns: [Self::Pack; 8]) -> [Self::Pack; 8] {
        columns
    }

    fn rows(self, columns: [Self::Pack; 8]) -> [Self::Pack; 8] {
        columns
    }

    fn put(self, packs: [Self::Pack; 8], bodies: &mut [Body<T>], at: &Sixteen<u32>, pass: usize) {
        for lane in 0..W {
            bodies[at[pass * W + lane] as usize] = Body(packs.map(|pack| pack.0[lane]));
        }
    }

    fn between(self, ab: [[Self::Pack; 8]; 2]) -> [Self::Pack; 8] {
        between(&ab)
    }

    fn pushed(
        self,
        ab: [[Self::Pack; 8]; 2],
        d: [Self::Pack; 3],
        c: [Self::Pack; 3],
    ) -> [[Self::Pack; 8]; 2] {
        pushed(ab, d, c)
    }
}

impl<T: Real, const W: usize, const FUSED: bool> Add for Many<T, W, FUSED> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl<T: Real, const W: usize, const FUSED: bool> Sub for Many<T, W, FUSED> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl<T: Real, const W: usize, const FUSED: bool> Mul for Many<T, W, FUSED> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl<T: Real, const W: usize, const FUSED: bool> Pack for Many<T, W, FUSED> {
    fn plus(self, a: Self, b: Self) -> Self {
        let sum = |x: T, a: T, b: T| match FUSED {
            true => x.fused(a, b),
            false => x + a * b,
        };
        Self(std::array::from_fn(|k| sum(self.0[k], a.0[k], b.0[k])))
    }

    fn less(self, a: Self, b: Self) -> Self {
        self.plus(a, Self(b.0.map(|x| -x)))
    }

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
