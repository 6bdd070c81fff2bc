//! Eight contacts: the update of Gauss-Seidel in lanes.
//!
//! With `s = R w`, a contact of two spheres (or of a sphere and the ground) at normal `n` has
//!
//! ```text
//! u   = v_A - v_B - (s_A + s_B) x n + b             [m/s]
//! v_A += m_A dp,  v_B -= m_B dp                     m: inverse mass [1/kg]
//! s_A -= k_A (n x dp),  s_B -= k_B (n x dp)         k = R^2/I [1/kg]
//! ```
//!
//! so that no radius and no arm is needed, and a body is eight numbers. No two contacts of a block share a moving body: the
//! lanes give the bits that one contact after the other gives. No multiplication is fused with an addition, so that
//! processors with and without wide registers agree in every bit.

use super::lanes::{Body, Eight, Lanes, Pack, Plain, Real};

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

/// A precision with its registers.
pub(super) trait Precision: Real {
    /// [`Block`]s swept once; body indices count from `offset`.
    fn sweep(
        blocks: &mut [Block<Self>],
        bodies: &mut [Body<Self>],
        offset: u32,
        pace: Pace,
    ) -> Progress;
}

/// Calls `$call` with the widest registers that the processor has, or `$width` numbers at a time without.
macro_rules! widest {
    ($width:literal, $task:ident { $($field:ident),* }) => {{
        #[cfg(target_arch = "x86_64")]
        if let Some(lanes) = pulp::x86::V3::try_new() {
            return lanes.vectorize($task { lanes, $($field),* });
        }
        pulp::NullaryFnOnce::call($task { lanes: Plain::<$width>, $($field),* })
    }};
}

impl Precision for f64 {
    fn sweep(
        blocks: &mut [Block<Self>],
        bodies: &mut [Body<Self>],
        offset: u32,
        pace: Pace,
    ) -> Progress {
        widest!(
            4,
            Sweep {
                blocks,
                bodies,
                offset,
                pace
            }
        )
    }
}

impl Precision for f32 {
    fn sweep(
        blocks: &mut [Block<Self>],
        bodies: &mut [Body<Self>],
        offset: u32,
        pace: Pace,
    ) -> Progress {
        widest!(
            8,
            Sweep {
                blocks,
                bodies,
                offset,
                pace
            }
        )
    }
}

/// Gives `bodies` the impulses of `blocks`.
pub(super) fn push(blocks: &[Block<f64>], bodies: &mut [Body<f64>], offset: u32) {
    widest!(
        4,
        Push {
            blocks,
            bodies,
            offset
        }
    )
}

/// What each block's contacts are off by where `bodies` move as the impulses make them.
pub(super) fn judge(
    blocks: &[Block<f64>],
    bodies: &[Body<f64>],
    offset: u32,
    verdicts: &mut [Verdict],
) {
    widest!(
        4,
        Judge {
            blocks,
            bodies,
            offset,
            verdicts
        }
    )
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

struct Sweep<'a, T, L> {
    lanes: L,
    blocks: &'a mut [Block<T>],
    bodies: &'a mut [Body<T>],
    offset: u32,
    pace: Pace,
}

impl<T: Real, L: Lanes<T>> pulp::NullaryFnOnce for Sweep<'_, T, L> {
    type Output = Progress;

    #[inline(always)]
    fn call(self) -> Progress {
        let (l, pace) = (self.lanes, &self.pace);
        let strict = pace.strictness * pace.strictness;
        let pace = Constants {
            momentum: l.splat(T::of(pace.momentum)),
            damping: l.splat(T::of(pace.damping)),
            strict: l.splat(T::of(strict)),
            strict_force: l.splat(T::of(strict * pace.force * pace.force)),
            zero: l.splat(T::of(0.0)),
        };
        let mut settled = true;
        let (mut along, mut change) = (pace.zero, pace.zero);
        for block in self.blocks {
            for pass in 0..block.count.div_ceil(L::WIDTH) {
                let (within, a, c) = block.update(l, pass, self.bodies, self.offset, &pace);
                settled &= within;
                along = along + a;
                change = change + c;
            }
        }
        let sum = |x: L::Pack| {
            let mut lanes = Eight::<T>::default();
            l.store(x, &mut lanes, 0);
            lanes.iter().map(|x| x.exact()).sum()
        };
        Progress {
            settled,
            along: sum(along),
            change: sum(change),
        }
    }
}

struct Push<'a, L> {
    lanes: L,
    blocks: &'a [Block<f64>],
    bodies: &'a mut [Body<f64>],
    offset: u32,
}

impl<L: Lanes<f64>> pulp::NullaryFnOnce for Push<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for block in self.blocks {
            for pass in 0..block.count.div_ceil(L::WIDTH) {
                block.push(self.lanes, pass, self.bodies, self.offset);
            }
        }
    }
}

struct Judge<'a, L> {
    lanes: L,
    blocks: &'a [Block<f64>],
    bodies: &'a [Body<f64>],
    offset: u32,
    verdicts: &'a mut [Verdict],
}

impl<L: Lanes<f64>> pulp::NullaryFnOnce for Judge<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for (block, verdict) in self.blocks.iter().zip(self.verdicts) {
            for pass in 0..block.count.div_ceil(L::WIDTH) {
                block.judge(self.lanes, pass, self.bodies, self.offset, verdict);
            }
        }
    }
}

/// [`Pace`] in lanes, squared where squares are compared.
struct Constants<P> {
    momentum: P,
    damping: P,
    strict: P,
    strict_force: P,
    zero: P,
}

/// The bodies of some contacts, by components.
type Bodies<P> = [P; 8];

#[inline(always)]
fn dot<P: Pack>(a: [P; 3], b: [P; 3]) -> P {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<P: Pack>(a: [P; 3], b: [P; 3]) -> [P; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[inline(always)]
fn each<P>(f: impl Fn(usize) -> P) -> [P; 3] {
    [f(0), f(1), f(2)]
}

/// What the law makes of some contacts' impulses.
struct Solved<P> {
    /// Normal impulse.
    normal: P,
    /// Square of the tangential impulse before it is brought onto the disc, and the share that stays.
    squared: P,
    share: P,
    /// Change of the normal impulse and of the tangential one.
    d_n: P,
    d_t: [P; 3],
}

impl<P: Pack> Solved<P> {
    /// Square of the new impulse, at least `scale`.
    #[inline(always)]
    fn size(&self, scale: P) -> P {
        (self.normal * self.normal + self.squared * self.share * self.share).or_larger(scale)
    }
}

impl<T: Real> Block<T> {
    #[inline(always)]
    fn vector<L: Lanes<T>>(l: L, x: &Vector<T>, pass: usize) -> [L::Pack; 3] {
        [
            l.load(&x[0], pass),
            l.load(&x[1], pass),
            l.load(&x[2], pass),
        ]
    }

    /// Bodies A and B, counted from `offset`.
    #[inline(always)]
    fn at(&self, offset: u32) -> [[u32; 8]; 2] {
        let mut at = self.bodies;
        for lane in 0..8 {
            at[0][lane] = at[0][lane].wrapping_sub(offset);
            at[1][lane] = at[1][lane].wrapping_sub(offset);
        }
        at
    }

    /// Relative velocity with the bias.
    #[inline(always)]
    fn approach<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        n: [L::Pack; 3],
        [a, b]: [&Bodies<L::Pack>; 2],
    ) -> [L::Pack; 3] {
        let bias = Self::vector(l, &self.bias, pass);
        let turn = cross([a[4] + b[4], a[5] + b[5], a[6] + b[6]], n);
        each(|k| (a[k] - b[k]) - turn[k] + bias[k])
    }

    /// The law at impulse `p` and relative velocity `u`.
    #[inline(always)]
    fn solve<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        n: [L::Pack; 3],
        p: [L::Pack; 3],
        u: [L::Pack; 3],
    ) -> Solved<L::Pack> {
        let (u_n, p_n) = (dot(u, n), dot(p, n));
        let [mass_n, mass_t] = [l.load(&self.mass[0], pass), l.load(&self.mass[1], pass)];
        let normal = (p_n - u_n * mass_n).or_larger(l.splat(T::of(0.0)));
        // Tangential part of p - u/w_t, on the disc. All as differences: what is solved stays to the last bit.
        let p_t = each(|k| p[k] - n[k] * p_n);
        let t = each(|k| p_t[k] - (u[k] - n[k] * u_n) * mass_t);
        let (squared, limit) = (dot(t, t), l.load(&self.friction, pass) * normal);
        let one = l.splat(T::of(1.0));
        let share = squared.within(limit * limit, one, limit.over(squared.root()));
        Solved {
            normal,
            squared,
            share,
            d_n: normal - p_n,
            d_t: each(|k| t[k] * share - p_t[k]),
        }
    }

    /// Gives the bodies the impulses `d`.
    #[inline(always)]
    fn give<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        (n, d): ([L::Pack; 3], [L::Pack; 3]),
        [mut a, mut b]: [Bodies<L::Pack>; 2],
        bodies: &mut [Body<T>],
        at: &[[u32; 8]; 2],
    ) {
        let c = cross(n, d);
        for k in 0..3 {
            a[k] = a[k] + a[3] * d[k];
            b[k] = b[k] - b[3] * d[k];
            a[k + 4] = a[k + 4] - a[7] * c[k];
            b[k + 4] = b[k + 4] - b[7] * c[k];
        }
        l.scatter(a, bodies, &at[0], pass, self.count);
        l.scatter(b, bodies, &at[1], pass, self.count);
    }

    /// Solves the contacts of a pass: whether all were within the tolerances, and their shares of [`Progress`].
    #[inline(always)]
    fn update<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        bodies: &mut [Body<T>],
        offset: u32,
        pace: &Constants<L::Pack>,
    ) -> (bool, L::Pack, L::Pack) {
        let at = self.at(offset);
        let n = Self::vector(l, &self.normal, pass);
        let old = Self::vector(l, &self.impulse, pass);
        let before = Self::vector(l, &self.previous, pass);
        let a = l.gather(bodies, &at[0], pass);
        let b = l.gather(bodies, &at[1], pass);
        let u = self.approach(l, pass, n, [&a, &b]);
        let p = each(|k| old[k] + pace.momentum * (old[k] - before[k]));
        let solved = self.solve(l, pass, n, p, u);
        let d = each(|k| n[k] * solved.d_n + solved.d_t[k]);
        // Judged before damping.
        let [gap, slip] = [
            l.load(&self.allowed[0], pass),
            l.load(&self.allowed[1], pass),
        ];
        let (nn, tt) = (solved.d_n * solved.d_n, dot(solved.d_t, solved.d_t));
        let dd = nn + tt;
        let size = solved.size(l.load(&self.scale, pass));
        let settled = nn.all_within(pace.strict * gap)
            & tt.all_within(pace.strict * slip)
            & dd.all_within(pace.strict_force * size);
        let d = each(|k| d[k] * pace.damping);
        let new = each(|k| p[k] + d[k]);
        let along = dot(d, each(|k| new[k] - old[k]));
        for k in 0..3 {
            l.store(old[k], &mut self.previous[k], pass);
            l.store(new[k], &mut self.impulse[k], pass);
        }
        // Open contacts move nothing.
        if !dd.all_within(pace.zero) {
            self.give(l, pass, (n, d), [a, b], bodies, &at);
        }
        (settled, along, dd)
    }
}

impl Block<f64> {
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

    /// Gives the bodies its impulses.
    #[inline(always)]
    fn push<L: Lanes<f64>>(&self, l: L, pass: usize, bodies: &mut [Body<f64>], offset: u32) {
        let n = Self::vector(l, &self.normal, pass);
        let p = Self::vector(l, &self.impulse, pass);
        if !dot(p, p).all_within(l.splat(0.0)) {
            let at = self.at(offset);
            let a = l.gather(bodies, &at[0], pass);
            let b = l.gather(bodies, &at[1], pass);
            self.give(l, pass, (n, p), [a, b], bodies, &at);
        }
    }

    /// What its contacts are off by.
    #[inline(always)]
    fn judge<L: Lanes<f64>>(
        &self,
        l: L,
        pass: usize,
        bodies: &[Body<f64>],
        offset: u32,
        verdict: &mut Verdict,
    ) {
        let n = Self::vector(l, &self.normal, pass);
        let p = Self::vector(l, &self.impulse, pass);
        let at = self.at(offset);
        let a = l.gather(bodies, &at[0], pass);
        let b = l.gather(bodies, &at[1], pass);
        let u = self.approach(l, pass, n, [&a, &b]);
        let solved = self.solve(l, pass, n, p, u);
        let (zero, one, tiny) = (l.splat(0.0), l.splat(1.0), l.splat(f64::MIN_POSITIVE));
        let (nn, tt) = (solved.d_n * solved.d_n, dot(solved.d_t, solved.d_t));
        let (dd, scale) = (nn + tt, l.load(&self.scale, pass));
        let [gap, slip] = [
            l.load(&self.allowed[0], pass),
            l.load(&self.allowed[1], pass),
        ];
        let size = solved.size(scale);
        // Without any scale an impulse that should vanish is off by all of itself.
        let size = size.within(zero, dd.or_larger(tiny), size);
        // Distances to the edges of the state: of opening, and of slip.
        let (mass, p_n) = (l.load(&self.mass[0], pass), dot(p, n));
        let held = dot(p, p).or_larger(scale).root();
        let to_opening = p_n - dot(u, n) * mass;
        let opens = to_opening
            .or_larger(zero - to_opening)
            .over(held.or_larger(tiny));
        let opens = held.within(zero, one, opens);
        let bound = l.load(&self.friction, pass) * p_n.or_larger(zero);
        let to_slip = solved.squared.root() - bound;
        let slips = to_slip
            .or_larger(zero - to_slip)
            .over(bound.or_larger(tiny));
        let slips = bound.within(zero, one, slips);
        let nearest = opens.within(slips, opens, slips);
        let [gaps, slipped, forces, margins] = verdict;
        l.store(nn.over(gap).root(), gaps, pass);
        l.store(tt.over(slip).root(), slipped, pass);
        l.store(dd.over(size).root(), forces, pass);
        l.store(mass.within(zero, one, nearest), margins, pass);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Blocks of eight contacts of sixteen bodies from numbers in -1..1, of which the last one is not full.
    fn blocks<T: Real>(numbers: &[f64]) -> ([Block<T>; 2], Vec<Body<T>>) {
        let mut source = numbers.iter().cycle().map(|&x| T::of(x));
        let mut eight =
            || -> Eight<T> { std::array::from_fn(|_| source.next().unwrap_or_default()) };
        let mut vector = || [eight(), eight(), eight()];
        let block = Block {
            normal: vector(),
            impulse: vector(),
            previous: vector(),
            bias: vector(),
            friction: std::array::from_fn(|k| T::of(0.1 * k as f64)),
            mass: [eight(), eight()].map(|m| m.map(|x| x * x)),
            bodies: [0, 8].map(|first| std::array::from_fn(|k| first + k as u32)),
            count: 8,
            ..Block::default()
        };
        let bodies = (0..16).map(|_| Body(eight())).collect();
        ([block, Block { count: 3, ..block }], bodies)
    }

    proptest! {
        #[test]
        fn wide_registers_give_the_same_bits(
            numbers in prop::collection::vec(-1.0..1.0f64, 8 * 16 + 8 * 14),
            momentum in 0.0..1.0f64,
        ) {
            let pace = Pace { momentum, damping: 0.9, strictness: 1.0, force: 0.1 };
            macro_rules! same {
                ($real:ty, $width:literal) => {{
                    let (start, still) = blocks::<$real>(&numbers);
                    let (mut wide, mut moved) = (start, still.clone());
                    let found = <$real>::sweep(&mut wide, &mut moved, 0, pace);
                    let (mut plain, mut bodies) = (start, still);
                    let expected = pulp::NullaryFnOnce::call(Sweep {
                        lanes: Plain::<$width>,
                        blocks: &mut plain,
                        bodies: &mut bodies,
                        offset: 0,
                        pace,
                    });
                    prop_assert_eq!(format!("{wide:?} {moved:?} {found:?}"), format!("{plain:?} {bodies:?} {expected:?}"));
                }};
            }
            same!(f64, 4);
            same!(f32, 8);
        }
    }
}
