//! Four contacts at a time: the update of Gauss-Seidel in lanes.
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

use super::lanes::{Lanes, Plain, Quad};

/// A body as blocks see it.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C, align(64))]
pub(super) struct Body {
    /// Velocity \[m/s\] and inverse mass \[1/kg\].
    pub(super) linear: [f64; 4],
    /// `R w` \[m/s\] and `R^2/I` \[1/kg\].
    pub(super) spin: [f64; 4],
}

/// A number of each of four contacts.
pub(super) type Number = [f64; 4];
/// A vector of each, by components.
pub(super) type Vector = [Number; 3];

/// Four contacts without a common moving body; lanes without a contact have zeros and bodies that nothing moves.
#[derive(Debug, Clone, Copy, Default)]
#[repr(C, align(64))]
pub(super) struct Block {
    /// Normals.
    pub(super) normal: Vector,
    /// Impulses after the last sweep \[N s\].
    pub(super) impulse: Vector,
    /// Impulses after the last but one.
    pub(super) previous: Vector,
    /// Biases with the ground's velocity \[m/s\].
    pub(super) bias: Vector,
    /// Friction coefficients.
    pub(super) friction: Number,
    /// `1/w_n` and `1/w_t` \[kg\]; zero where nothing moves.
    pub(super) mass: [Number; 2],
    /// Squared corrections that the tolerances of gap and slip allow \[N^2 s^2\].
    pub(super) allowed: [Number; 2],
    /// Squared scale of the force residual \[N^2 s^2\].
    pub(super) scale: Number,
    /// Bodies A and B.
    pub(super) bodies: [[u32; 4]; 2],
    /// The rows, or [`super::kernel::NONE`].
    pub(super) rows: [u32; 4],
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

/// What a sweep saw.
#[derive(Debug, Clone, Copy)]
pub(super) struct Progress {
    /// Whether every contact was within the tolerances when its turn came.
    pub(super) settled: bool,
    /// Corrections times changes of the impulses \[N^2 s^2\]: negative where momentum leads astray.
    pub(super) along: f64,
    /// Squared corrections \[N^2 s^2\], before damping.
    pub(super) change: f64,
}

/// One sweep over `blocks`.
pub(super) fn sweep(blocks: &mut [Block], bodies: &mut [Body], pace: Pace) -> Progress {
    #[cfg(target_arch = "x86_64")]
    if let Some(wide) = pulp::x86::V3::try_new() {
        return wide.vectorize(Sweep {
            lanes: wide,
            blocks,
            bodies,
            pace,
        });
    }
    plain(blocks, bodies, pace)
}

/// [`sweep`] without wide registers.
fn plain(blocks: &mut [Block], bodies: &mut [Body], pace: Pace) -> Progress {
    pulp::NullaryFnOnce::call(Sweep {
        lanes: Plain,
        blocks,
        bodies,
        pace,
    })
}

struct Sweep<'a, L> {
    lanes: L,
    blocks: &'a mut [Block],
    bodies: &'a mut [Body],
    pace: Pace,
}

impl<L: Lanes> pulp::NullaryFnOnce for Sweep<'_, L> {
    type Output = Progress;

    #[inline(always)]
    fn call(self) -> Progress {
        let (l, pace) = (self.lanes, &self.pace);
        let strict = pace.strictness * pace.strictness;
        let pace = Constants {
            momentum: l.splat(pace.momentum),
            damping: l.splat(pace.damping),
            strict: l.splat(strict),
            strict_force: l.splat(strict * pace.force * pace.force),
            zero: l.splat(0.0),
            one: l.splat(1.0),
        };
        let mut settled = true;
        let (mut along, mut change) = (pace.zero, pace.zero);
        for block in self.blocks {
            let (within, a, c) = block.update(l, self.bodies, &pace);
            settled &= within;
            along = along + a;
            change = change + c;
        }
        let sum = |x| {
            let [a, b, c, d] = l.array(x);
            (a + b) + (c + d)
        };
        Progress {
            settled,
            along: sum(along),
            change: sum(change),
        }
    }
}

/// [`Pace`] in lanes, squared where squares are compared.
struct Constants<Q> {
    momentum: Q,
    damping: Q,
    strict: Q,
    strict_force: Q,
    zero: Q,
    one: Q,
}

/// The bodies of four contacts: `x, y, z` of `v` and inverse mass, of `s` and `R^2/I`.
struct Four<Q> {
    linear: [Q; 4],
    spin: [Q; 4],
}

impl<Q: Quad> Four<Q> {
    // Written out: a closure that is not inlined does not get the wide registers.
    #[inline(always)]
    fn load<L: Lanes<Quad = Q>>(l: L, bodies: &[Body], at: [u32; 4]) -> Self {
        let [p, q] = [&bodies[at[0] as usize], &bodies[at[1] as usize]];
        let [r, s] = [&bodies[at[2] as usize], &bodies[at[3] as usize]];
        let linear = [
            l.quad(p.linear),
            l.quad(q.linear),
            l.quad(r.linear),
            l.quad(s.linear),
        ];
        let spin = [
            l.quad(p.spin),
            l.quad(q.spin),
            l.quad(r.spin),
            l.quad(s.spin),
        ];
        Self {
            linear: l.transpose(linear),
            spin: l.transpose(spin),
        }
    }

    #[inline(always)]
    fn store<L: Lanes<Quad = Q>>(&self, l: L, bodies: &mut [Body], at: [u32; 4]) {
        let linear = l.transpose(self.linear);
        let spin = l.transpose(self.spin);
        for lane in 0..4 {
            bodies[at[lane] as usize] = Body {
                linear: l.array(linear[lane]),
                spin: l.array(spin[lane]),
            };
        }
    }
}

#[inline(always)]
fn dot<Q: Quad>(a: [Q; 3], b: [Q; 3]) -> Q {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<Q: Quad>(a: [Q; 3], b: [Q; 3]) -> [Q; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[inline(always)]
fn each<Q>(f: impl Fn(usize) -> Q) -> [Q; 3] {
    [f(0), f(1), f(2)]
}

impl Block {
    /// Solves the four contacts: whether all were within the tolerances, and their shares of [`Progress`].
    #[inline(always)]
    fn update<L: Lanes>(
        &mut self,
        l: L,
        bodies: &mut [Body],
        pace: &Constants<L::Quad>,
    ) -> (bool, L::Quad, L::Quad) {
        let vector = |x: &Vector| [l.quad(x[0]), l.quad(x[1]), l.quad(x[2])];
        let (n, old) = (vector(&self.normal), vector(&self.impulse));
        let (before, bias) = (vector(&self.previous), vector(&self.bias));
        let mut a = Four::load(l, bodies, self.bodies[0]);
        let mut b = Four::load(l, bodies, self.bodies[1]);
        let turn = cross(each(|k| a.spin[k] + b.spin[k]), n);
        let u = each(|k| (a.linear[k] - b.linear[k]) - turn[k] + bias[k]);
        let p = each(|k| old[k] + pace.momentum * (old[k] - before[k]));
        let (u_n, p_n) = (dot(u, n), dot(p, n));
        let (mass_n, mass_t) = (l.quad(self.mass[0]), l.quad(self.mass[1]));
        let normal = (p_n - u_n * mass_n).or_larger(pace.zero);
        // Tangential part of p - u/w_t, on the disc. All as differences: what is solved stays to the last bit.
        let p_t = each(|k| p[k] - n[k] * p_n);
        let t = each(|k| p_t[k] - (u[k] - n[k] * u_n) * mass_t);
        let (tt, limit) = (dot(t, t), l.quad(self.friction) * normal);
        let share = tt.within(limit * limit, pace.one, limit.over(tt.root()));
        let d_n = normal - p_n;
        let d_t = each(|k| t[k] * share - p_t[k]);
        let d = each(|k| n[k] * d_n + d_t[k]);
        // Judged before damping.
        let (nn, dd_t, [gap, slip]) = (d_n * d_n, dot(d_t, d_t), self.allowed);
        let dd = nn + dd_t;
        let size = (normal * normal + tt * share * share).or_larger(l.quad(self.scale));
        let settled = nn.all_within(pace.strict * l.quad(gap))
            & dd_t.all_within(pace.strict * l.quad(slip))
            & dd.all_within(pace.strict_force * size);
        let d = each(|k| d[k] * pace.damping);
        let new = each(|k| p[k] + d[k]);
        let along = dot(d, each(|k| new[k] - old[k]));
        for k in 0..3 {
            self.previous[k] = l.array(old[k]);
            self.impulse[k] = l.array(new[k]);
        }
        // Open contacts move nothing.
        if !dd.all_within(pace.zero) {
            let c = cross(n, d);
            for k in 0..3 {
                a.linear[k] = a.linear[k] + a.linear[3] * d[k];
                b.linear[k] = b.linear[k] - b.linear[3] * d[k];
                a.spin[k] = a.spin[k] - a.spin[3] * c[k];
                b.spin[k] = b.spin[k] - b.spin[3] * c[k];
            }
            a.store(l, bodies, self.bodies[0]);
            b.store(l, bodies, self.bodies[1]);
        }
        (settled, along, dd)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn wide_registers_give_the_same_bits(
            numbers in prop::collection::vec(-1.0..1.0f64, 8 * 8 + 4 * 17),
            momentum in 0.0..1.0f64,
        ) {
            let mut source = numbers.into_iter();
            let mut four = || std::array::from_fn(|_| source.next().unwrap_or_default());
            let mut vector = || [four(), four(), four()];
            let block = Block {
                normal: vector(),
                impulse: vector(),
                previous: vector(),
                bias: vector(),
                friction: [0.0, 0.1, 0.5, 1.0],
                mass: [four().map(f64::abs), four().map(f64::abs)],
                bodies: [[0, 1, 2, 3], [4, 5, 6, 7]],
                ..Block::default()
            };
            let body = |_| Body { linear: four(), spin: four() };
            let bodies: Vec<Body> = (0..8).map(body).collect();
            let pace = Pace { momentum, damping: 0.9, strictness: 1.0, force: 0.1 };
            let results = [sweep, plain].map(|sweep| {
                let (mut blocks, mut bodies) = ([block; 2], bodies.clone());
                let progress = sweep(&mut blocks, &mut bodies, pace);
                format!("{blocks:?} {bodies:?} {progress:?}")
            });
            prop_assert_eq!(&results[0], &results[1]);
        }
    }
}
