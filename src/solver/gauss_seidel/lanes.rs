//! Eight numbers at a time, in registers where the processor has such, else one after the other: the same bits.

use std::fmt::Debug;
use std::ops::{Add, Mul, Sub};

/// A body as blocks see it: velocity \[m/s\] and inverse mass \[1/kg\], `R w` \[m/s\] and `R^2/I` \[1/kg\].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[repr(C, align(32))]
pub(super) struct Body<T>(pub(super) [T; 8]);

/// Eight numbers in memory.
pub(super) type Eight<T> = [T; 8];

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
    /// Whether all are `<= limit`.
    fn all_within(self, limit: Self) -> bool;
}

/// What makes packs of numbers `T`: the proof that the processor has the registers. Eight numbers take one pass or more.
pub(super) trait Lanes<T>: Copy {
    /// Its pack.
    type Pack: Pack;
    /// Numbers of a pack.
    const WIDTH: usize;

    /// The same number everywhere.
    fn splat(self, x: T) -> Self::Pack;
    /// Those of pass `pass`.
    fn load(self, x: &Eight<T>, pass: usize) -> Self::Pack;
    /// Likewise to memory.
    fn store(self, pack: Self::Pack, x: &mut Eight<T>, pass: usize);
    /// The bodies that the pass's part of `at` names, by components.
    fn gather(self, bodies: &[Body<T>], at: &[u32; 8], pass: usize) -> [Self::Pack; 8];
    /// Puts back the first `count` of the eight, as far as they are of this pass.
    fn scatter(
        self,
        packs: [Self::Pack; 8],
        bodies: &mut [Body<T>],
        at: &[u32; 8],
        pass: usize,
        count: usize,
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

    fn load(self, x: &Eight<T>, pass: usize) -> Many<T, W> {
        Many(std::array::from_fn(|k| x[pass * W + k]))
    }

    fn store(self, pack: Many<T, W>, x: &mut Eight<T>, pass: usize) {
        x[pass * W..][..W].copy_from_slice(&pack.0);
    }

    fn gather(self, bodies: &[Body<T>], at: &[u32; 8], pass: usize) -> [Many<T, W>; 8] {
        let body = |lane: usize| &bodies[at[pass * W + lane] as usize].0;
        std::array::from_fn(|k| Many(std::array::from_fn(|lane| body(lane)[k])))
    }

    fn scatter(
        self,
        packs: [Many<T, W>; 8],
        bodies: &mut [Body<T>],
        at: &[u32; 8],
        pass: usize,
        count: usize,
    ) {
        for lane in 0..W.min(count.saturating_sub(pass * W)) {
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

    fn all_within(self, limit: Self) -> bool {
        (0..W).all(|k| self.0[k] <= limit.0[k])
    }
}

#[cfg(target_arch = "x86_64")]
mod wide {
    use std::arch::x86_64::{__m256, __m256d, _CMP_LE_OQ};
    use std::ops::{Add, Mul, Sub};

    use pulp::cast;
    use pulp::x86::V3;

    use super::{Body, Eight, Lanes, Pack};

    /// One register; the token is of no size.
    #[derive(Debug, Clone, Copy)]
    pub(in super::super) struct Register<R>(V3, R);

    macro_rules! arithmetic {
        ($register:ty, $add:ident, $sub:ident, $mul:ident, $div:ident, $sqrt:ident, $max:ident, $cmp:ident, $blend:ident, $mask:ident, $all:expr) => {
            impl Add for Register<$register> {
                type Output = Self;
                #[inline(always)]
                fn add(self, other: Self) -> Self {
                    Self(self.0, self.0.avx.$add(self.1, other.1))
                }
            }

            impl Sub for Register<$register> {
                type Output = Self;
                #[inline(always)]
                fn sub(self, other: Self) -> Self {
                    Self(self.0, self.0.avx.$sub(self.1, other.1))
                }
            }

            impl Mul for Register<$register> {
                type Output = Self;
                #[inline(always)]
                fn mul(self, other: Self) -> Self {
                    Self(self.0, self.0.avx.$mul(self.1, other.1))
                }
            }

            impl Pack for Register<$register> {
                #[inline(always)]
                fn over(self, other: Self) -> Self {
                    Self(self.0, self.0.avx.$div(self.1, other.1))
                }

                #[inline(always)]
                fn root(self) -> Self {
                    Self(self.0, self.0.avx.$sqrt(self.1))
                }

                #[inline(always)]
                fn or_larger(self, other: Self) -> Self {
                    Self(self.0, self.0.avx.$max(self.1, other.1))
                }

                #[inline(always)]
                fn within(self, limit: Self, yes: Self, no: Self) -> Self {
                    let avx = self.0.avx;
                    let mask = avx.$cmp::<_CMP_LE_OQ>(self.1, limit.1);
                    Self(self.0, avx.$blend(no.1, yes.1, mask))
                }

                #[inline(always)]
                fn all_within(self, limit: Self) -> bool {
                    let avx = self.0.avx;
                    avx.$mask(avx.$cmp::<_CMP_LE_OQ>(self.1, limit.1)) == $all
                }
            }
        };
    }

    arithmetic!(
        __m256d,
        _mm256_add_pd,
        _mm256_sub_pd,
        _mm256_mul_pd,
        _mm256_div_pd,
        _mm256_sqrt_pd,
        _mm256_max_pd,
        _mm256_cmp_pd,
        _mm256_blendv_pd,
        _mm256_movemask_pd,
        0xf
    );
    arithmetic!(
        __m256,
        _mm256_add_ps,
        _mm256_sub_ps,
        _mm256_mul_ps,
        _mm256_div_ps,
        _mm256_sqrt_ps,
        _mm256_max_ps,
        _mm256_cmp_ps,
        _mm256_blendv_ps,
        _mm256_movemask_ps,
        0xff
    );

    /// Four of eight.
    #[inline(always)]
    fn half(x: &Eight<f64>, pass: usize) -> [f64; 4] {
        let at = 4 * pass;
        [x[at], x[at + 1], x[at + 2], x[at + 3]]
    }

    /// A body back to memory.
    #[inline(always)]
    fn put_4(bodies: &mut [Body<f64>], at: u32, linear: __m256d, spin: __m256d) {
        let [a, b, c, d]: [f64; 4] = cast(linear);
        let [e, f, g, h]: [f64; 4] = cast(spin);
        bodies[at as usize] = Body([a, b, c, d, e, f, g, h]);
    }

    /// Rows to columns, or columns to rows.
    #[inline(always)]
    fn transposed_4(v: V3, [a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
        let avx = v.avx;
        let low = [avx._mm256_unpacklo_pd(a, b), avx._mm256_unpacklo_pd(c, d)];
        let high = [avx._mm256_unpackhi_pd(a, b), avx._mm256_unpackhi_pd(c, d)];
        [
            avx._mm256_permute2f128_pd::<0x20>(low[0], low[1]),
            avx._mm256_permute2f128_pd::<0x20>(high[0], high[1]),
            avx._mm256_permute2f128_pd::<0x31>(low[0], low[1]),
            avx._mm256_permute2f128_pd::<0x31>(high[0], high[1]),
        ]
    }

    /// Likewise of eight.
    #[inline(always)]
    fn transposed_8(v: V3, r: [__m256; 8]) -> [__m256; 8] {
        let avx = v.avx;
        let l0 = avx._mm256_unpacklo_ps(r[0], r[1]);
        let l1 = avx._mm256_unpacklo_ps(r[2], r[3]);
        let l2 = avx._mm256_unpacklo_ps(r[4], r[5]);
        let l3 = avx._mm256_unpacklo_ps(r[6], r[7]);
        let h0 = avx._mm256_unpackhi_ps(r[0], r[1]);
        let h1 = avx._mm256_unpackhi_ps(r[2], r[3]);
        let h2 = avx._mm256_unpackhi_ps(r[4], r[5]);
        let h3 = avx._mm256_unpackhi_ps(r[6], r[7]);
        let up = [
            avx._mm256_shuffle_ps::<0x44>(l0, l1),
            avx._mm256_shuffle_ps::<0xee>(l0, l1),
            avx._mm256_shuffle_ps::<0x44>(h0, h1),
            avx._mm256_shuffle_ps::<0xee>(h0, h1),
        ];
        let down = [
            avx._mm256_shuffle_ps::<0x44>(l2, l3),
            avx._mm256_shuffle_ps::<0xee>(l2, l3),
            avx._mm256_shuffle_ps::<0x44>(h2, h3),
            avx._mm256_shuffle_ps::<0xee>(h2, h3),
        ];
        [
            avx._mm256_permute2f128_ps::<0x20>(up[0], down[0]),
            avx._mm256_permute2f128_ps::<0x20>(up[1], down[1]),
            avx._mm256_permute2f128_ps::<0x20>(up[2], down[2]),
            avx._mm256_permute2f128_ps::<0x20>(up[3], down[3]),
            avx._mm256_permute2f128_ps::<0x31>(up[0], down[0]),
            avx._mm256_permute2f128_ps::<0x31>(up[1], down[1]),
            avx._mm256_permute2f128_ps::<0x31>(up[2], down[2]),
            avx._mm256_permute2f128_ps::<0x31>(up[3], down[3]),
        ]
    }

    /// Eight registers with their token. Written out here and below: a closure that is not inlined does not get the wide
    /// registers.
    #[inline(always)]
    fn registers<R: Copy>(v: V3, r: [R; 8]) -> [Register<R>; 8] {
        [
            Register(v, r[0]),
            Register(v, r[1]),
            Register(v, r[2]),
            Register(v, r[3]),
            Register(v, r[4]),
            Register(v, r[5]),
            Register(v, r[6]),
            Register(v, r[7]),
        ]
    }

    impl Lanes<f64> for V3 {
        type Pack = Register<__m256d>;
        const WIDTH: usize = 4;

        #[inline(always)]
        fn splat(self, x: f64) -> Register<__m256d> {
            Register(self, cast([x; 4]))
        }

        #[inline(always)]
        fn load(self, x: &Eight<f64>, pass: usize) -> Register<__m256d> {
            Register(self, cast(half(x, pass)))
        }

        #[inline(always)]
        fn store(self, pack: Register<__m256d>, x: &mut Eight<f64>, pass: usize) {
            let four: [f64; 4] = cast(pack.1);
            x[4 * pass..][..4].copy_from_slice(&four);
        }

        #[inline(always)]
        fn gather(
            self,
            bodies: &[Body<f64>],
            at: &[u32; 8],
            pass: usize,
        ) -> [Register<__m256d>; 8] {
            let at = &at[4 * pass..][..4];
            let [p, q] = [&bodies[at[0] as usize].0, &bodies[at[1] as usize].0];
            let [r, s] = [&bodies[at[2] as usize].0, &bodies[at[3] as usize].0];
            let linear = [
                cast(half(p, 0)),
                cast(half(q, 0)),
                cast(half(r, 0)),
                cast(half(s, 0)),
            ];
            let spin = [
                cast(half(p, 1)),
                cast(half(q, 1)),
                cast(half(r, 1)),
                cast(half(s, 1)),
            ];
            let [a, b, c, d] = transposed_4(self, linear);
            let [e, f, g, h] = transposed_4(self, spin);
            registers(self, [a, b, c, d, e, f, g, h])
        }

        #[inline(always)]
        fn scatter(
            self,
            [a, b, c, d, e, f, g, h]: [Register<__m256d>; 8],
            bodies: &mut [Body<f64>],
            at: &[u32; 8],
            pass: usize,
            count: usize,
        ) {
            let linear = transposed_4(self, [a.1, b.1, c.1, d.1]);
            let spin = transposed_4(self, [e.1, f.1, g.1, h.1]);
            let at = &at[4 * pass..][..4];
            let own = count.saturating_sub(4 * pass);
            if own >= 4 {
                // Written out: a loop would take the registers to memory first.
                put_4(bodies, at[0], linear[0], spin[0]);
                put_4(bodies, at[1], linear[1], spin[1]);
                put_4(bodies, at[2], linear[2], spin[2]);
                put_4(bodies, at[3], linear[3], spin[3]);
                return;
            }
            for lane in 0..own {
                put_4(bodies, at[lane], linear[lane], spin[lane]);
            }
        }
    }

    impl Lanes<f32> for V3 {
        type Pack = Register<__m256>;
        const WIDTH: usize = 8;

        #[inline(always)]
        fn splat(self, x: f32) -> Register<__m256> {
            Register(self, cast([x; 8]))
        }

        #[inline(always)]
        fn load(self, x: &Eight<f32>, _: usize) -> Register<__m256> {
            Register(self, cast(*x))
        }

        #[inline(always)]
        fn store(self, pack: Register<__m256>, x: &mut Eight<f32>, _: usize) {
            *x = cast(pack.1);
        }

        #[inline(always)]
        fn gather(self, bodies: &[Body<f32>], at: &[u32; 8], _: usize) -> [Register<__m256>; 8] {
            let rows = [
                cast(bodies[at[0] as usize].0),
                cast(bodies[at[1] as usize].0),
                cast(bodies[at[2] as usize].0),
                cast(bodies[at[3] as usize].0),
                cast(bodies[at[4] as usize].0),
                cast(bodies[at[5] as usize].0),
                cast(bodies[at[6] as usize].0),
                cast(bodies[at[7] as usize].0),
            ];
            registers(self, transposed_8(self, rows))
        }

        #[inline(always)]
        fn scatter(
            self,
            [a, b, c, d, e, f, g, h]: [Register<__m256>; 8],
            bodies: &mut [Body<f32>],
            at: &[u32; 8],
            _: usize,
            count: usize,
        ) {
            let rows = transposed_8(self, [a.1, b.1, c.1, d.1, e.1, f.1, g.1, h.1]);
            if count >= 8 {
                bodies[at[0] as usize] = Body(cast(rows[0]));
                bodies[at[1] as usize] = Body(cast(rows[1]));
                bodies[at[2] as usize] = Body(cast(rows[2]));
                bodies[at[3] as usize] = Body(cast(rows[3]));
                bodies[at[4] as usize] = Body(cast(rows[4]));
                bodies[at[5] as usize] = Body(cast(rows[5]));
                bodies[at[6] as usize] = Body(cast(rows[6]));
                bodies[at[7] as usize] = Body(cast(rows[7]));
                return;
            }
            for lane in 0..count {
                bodies[at[lane] as usize] = Body(cast(rows[lane]));
            }
        }
    }
}
