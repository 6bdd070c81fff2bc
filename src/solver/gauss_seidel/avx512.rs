//! AVX-512: sixteen numbers in single precision, eight in double.

use std::arch::x86_64::{__m256, __m512, __m512d, _CMP_LE_OQ};
use std::ops::{Add, Mul, Sub};

use pulp::cast;
use pulp::x86::V4;

use super::lanes::{Body, Lanes, Pack, Sixteen};
use super::registers::{Register, pack, registers};

pack!(V4, avx512f, __m512: _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_div_ps, _mm512_sqrt_ps, _mm512_max_ps;
    fn within(self, limit: Self, yes: Self, no: Self) -> Self {
        let avx = self.0.avx512f;
        let mask = avx._mm512_cmp_ps_mask::<_CMP_LE_OQ>(self.1, limit.1);
        Self(self.0, avx._mm512_mask_blend_ps(mask, no.1, yes.1))
    }
    fn bits_within(self, limit: Self) -> u16 {
        let avx = self.0.avx512f;
        avx._mm512_cmp_ps_mask::<_CMP_LE_OQ>(self.1, limit.1)
    }
);

pack!(V4, avx512f, __m512d: _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_sqrt_pd, _mm512_max_pd;
    fn within(self, limit: Self, yes: Self, no: Self) -> Self {
        let avx = self.0.avx512f;
        let mask = avx._mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.1, limit.1);
        Self(self.0, avx._mm512_mask_blend_pd(mask, no.1, yes.1))
    }
    fn bits_within(self, limit: Self) -> u16 {
        let avx = self.0.avx512f;
        let mask = avx._mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.1, limit.1);
        u16::from(mask)
    }
);

/// In each quarter of the registers, rows to columns, or columns to rows.
#[inline(always)]
fn transposed_4(v: V4, [a, b, c, d]: [__m512; 4]) -> [__m512; 4] {
    let avx = v.avx512f;
    let low = [avx._mm512_unpacklo_ps(a, b), avx._mm512_unpacklo_ps(c, d)];
    let high = [avx._mm512_unpackhi_ps(a, b), avx._mm512_unpackhi_ps(c, d)];
    [
        avx._mm512_shuffle_ps::<0x44>(low[0], low[1]),
        avx._mm512_shuffle_ps::<0xee>(low[0], low[1]),
        avx._mm512_shuffle_ps::<0x44>(high[0], high[1]),
        avx._mm512_shuffle_ps::<0xee>(high[0], high[1]),
    ]
}

/// Rows to columns, or columns to rows.
#[inline(always)]
fn transposed_8(v: V4, r: [__m512d; 8]) -> [__m512d; 8] {
    let avx = v.avx512f;
    // Of rows (0, 1), (2, 3), (4, 5), (6, 7): even columns, then odd ones.
    let e0 = avx._mm512_unpacklo_pd(r[0], r[1]);
    let e1 = avx._mm512_unpacklo_pd(r[2], r[3]);
    let e2 = avx._mm512_unpacklo_pd(r[4], r[5]);
    let e3 = avx._mm512_unpacklo_pd(r[6], r[7]);
    let o0 = avx._mm512_unpackhi_pd(r[0], r[1]);
    let o1 = avx._mm512_unpackhi_pd(r[2], r[3]);
    let o2 = avx._mm512_unpackhi_pd(r[4], r[5]);
    let o3 = avx._mm512_unpackhi_pd(r[6], r[7]);
    // Columns 0 and 4, 2 and 6, 1 and 5, 3 and 7 of the upper four rows and of the lower.
    let up = [
        avx._mm512_shuffle_f64x2::<0x88>(e0, e1),
        avx._mm512_shuffle_f64x2::<0xdd>(e0, e1),
        avx._mm512_shuffle_f64x2::<0x88>(o0, o1),
        avx._mm512_shuffle_f64x2::<0xdd>(o0, o1),
    ];
    let down = [
        avx._mm512_shuffle_f64x2::<0x88>(e2, e3),
        avx._mm512_shuffle_f64x2::<0xdd>(e2, e3),
        avx._mm512_shuffle_f64x2::<0x88>(o2, o3),
        avx._mm512_shuffle_f64x2::<0xdd>(o2, o3),
    ];
    [
        avx._mm512_shuffle_f64x2::<0x88>(up[0], down[0]),
        avx._mm512_shuffle_f64x2::<0x88>(up[2], down[2]),
        avx._mm512_shuffle_f64x2::<0x88>(up[1], down[1]),
        avx._mm512_shuffle_f64x2::<0x88>(up[3], down[3]),
        avx._mm512_shuffle_f64x2::<0xdd>(up[0], down[0]),
        avx._mm512_shuffle_f64x2::<0xdd>(up[2], down[2]),
        avx._mm512_shuffle_f64x2::<0xdd>(up[1], down[1]),
        avx._mm512_shuffle_f64x2::<0xdd>(up[3], down[3]),
    ]
}

impl Lanes<f64> for V4 {
    type Pack = Register<Self, __m512d>;
    const WIDTH: usize = 8;

    #[inline(always)]
    fn splat(self, x: f64) -> Self::Pack {
        Register(self, cast([x; 8]))
    }

    #[inline(always)]
    fn load(self, x: &Sixteen<f64>, pass: usize) -> Self::Pack {
        Register(self, cast(x.as_chunks::<8>().0[pass]))
    }

    #[inline(always)]
    fn store(self, pack: Self::Pack, x: &mut Sixteen<f64>, pass: usize) {
        x.as_chunks_mut::<8>().0[pass] = cast(pack.1);
    }

    #[inline(always)]
    fn gather(self, bodies: &[Body<f64>], at: &Sixteen<u32>, pass: usize) -> [Self::Pack; 8] {
        let at = &at.as_chunks::<8>().0[pass];
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
        [a, b, c, d, e, f, g, h]: [Self::Pack; 8],
        bodies: &mut [Body<f64>],
        at: &Sixteen<u32>,
        pass: usize,
    ) {
        let at = &at.as_chunks::<8>().0[pass];
        let rows = transposed_8(self, [a.1, b.1, c.1, d.1, e.1, f.1, g.1, h.1]);
        bodies[at[0] as usize] = Body(cast(rows[0]));
        bodies[at[1] as usize] = Body(cast(rows[1]));
        bodies[at[2] as usize] = Body(cast(rows[2]));
        bodies[at[3] as usize] = Body(cast(rows[3]));
        bodies[at[4] as usize] = Body(cast(rows[4]));
        bodies[at[5] as usize] = Body(cast(rows[5]));
        bodies[at[6] as usize] = Body(cast(rows[6]));
        bodies[at[7] as usize] = Body(cast(rows[7]));
    }
}

/// Two bodies in one register.
#[inline(always)]
fn two(v: V4, bodies: &[Body<f32>], low: u32, high: u32) -> __m512 {
    let low: __m256 = cast(bodies[low as usize].0);
    let high: __m256 = cast(bodies[high as usize].0);
    v.avx512dq
        ._mm512_insertf32x8::<1>(v.avx512f._mm512_castps256_ps512(low), high)
}

/// Puts back two bodies whose halves are quarters `Q` and `Q + 1` of `linear` and `spin`.
#[inline(always)]
fn put_two(
    v: V4,
    (linear, spin): (__m512, __m512),
    order: [u64; 8],
    bodies: &mut [Body<f32>],
    low: u32,
    high: u32,
) {
    let avx = v.avx512f;
    let both: __m512 = cast(avx._mm512_permutex2var_pd(cast(linear), cast(order), cast(spin)));
    bodies[low as usize] = Body(cast(avx._mm512_castps512_ps256(both)));
    bodies[high as usize] = Body(cast(v.avx512dq._mm512_extractf32x8_ps::<1>(both)));
}

/// Of the first and of the last two quarters of two registers: one of the first register, one of the second, and so on.
const FIRST: [u64; 8] = [0, 1, 8, 9, 2, 3, 10, 11];
const LAST: [u64; 8] = [4, 5, 12, 13, 6, 7, 14, 15];

impl Lanes<f32> for V4 {
    type Pack = Register<Self, __m512>;
    const WIDTH: usize = 16;

    #[inline(always)]
    fn splat(self, x: f32) -> Self::Pack {
        Register(self, cast([x; 16]))
    }

    #[inline(always)]
    fn load(self, x: &Sixteen<f32>, _: usize) -> Self::Pack {
        Register(self, cast(*x))
    }

    #[inline(always)]
    fn store(self, pack: Self::Pack, x: &mut Sixteen<f32>, _: usize) {
        *x = cast(pack.1);
    }

    #[inline(always)]
    fn gather(self, bodies: &[Body<f32>], at: &Sixteen<u32>, _: usize) -> [Self::Pack; 8] {
        // Of the first eight bodies and of the others: a component of the linear part, and of the spin, in turns of four.
        let up = [
            two(self, bodies, at[0], at[4]),
            two(self, bodies, at[1], at[5]),
            two(self, bodies, at[2], at[6]),
            two(self, bodies, at[3], at[7]),
        ];
        let down = [
            two(self, bodies, at[8], at[12]),
            two(self, bodies, at[9], at[13]),
            two(self, bodies, at[10], at[14]),
            two(self, bodies, at[11], at[15]),
        ];
        let (up, down) = (transposed_4(self, up), transposed_4(self, down));
        let avx = self.avx512f;
        registers(
            self,
            [
                avx._mm512_shuffle_f32x4::<0x88>(up[0], down[0]),
                avx._mm512_shuffle_f32x4::<0x88>(up[1], down[1]),
                avx._mm512_shuffle_f32x4::<0x88>(up[2], down[2]),
                avx._mm512_shuffle_f32x4::<0x88>(up[3], down[3]),
                avx._mm512_shuffle_f32x4::<0xdd>(up[0], down[0]),
                avx._mm512_shuffle_f32x4::<0xdd>(up[1], down[1]),
                avx._mm512_shuffle_f32x4::<0xdd>(up[2], down[2]),
                avx._mm512_shuffle_f32x4::<0xdd>(up[3], down[3]),
            ],
        )
    }

    #[inline(always)]
    fn scatter(
        self,
        [a, b, c, d, e, f, g, h]: [Self::Pack; 8],
        bodies: &mut [Body<f32>],
        at: &Sixteen<u32>,
        _: usize,
    ) {
        let linear = transposed_4(self, [a.1, b.1, c.1, d.1]);
        let spin = transposed_4(self, [e.1, f.1, g.1, h.1]);
        put_two(self, (linear[0], spin[0]), FIRST, bodies, at[0], at[4]);
        put_two(self, (linear[1], spin[1]), FIRST, bodies, at[1], at[5]);
        put_two(self, (linear[2], spin[2]), FIRST, bodies, at[2], at[6]);
        put_two(self, (linear[3], spin[3]), FIRST, bodies, at[3], at[7]);
        put_two(self, (linear[0], spin[0]), LAST, bodies, at[8], at[12]);
        put_two(self, (linear[1], spin[1]), LAST, bodies, at[9], at[13]);
        put_two(self, (linear[2], spin[2]), LAST, bodies, at[10], at[14]);
        put_two(self, (linear[3], spin[3]), LAST, bodies, at[11], at[15]);
    }
}
