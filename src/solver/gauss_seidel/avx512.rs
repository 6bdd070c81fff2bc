//! AVX-512: sixteen numbers in single precision, eight in double.

use std::arch::x86_64::{__m256d, __m512, __m512d, _CMP_LE_OQ};
use std::ops::{Add, Mul, Sub};

use pulp::cast;
use pulp::x86::V4;

use super::lanes::{Body, Eight, Lanes, Pack, Sixteen};
use super::registers::{
    GIVEN, OTHER, Register, Row, bare, by_rows, eight_lanes, pack, registers, signed,
};

pack!(V4, avx512f, __m512: _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_div_ps, _mm512_sqrt_ps, _mm512_max_ps, avx512f: _mm512_fmadd_ps, _mm512_fnmadd_ps;
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

pack!(V4, avx512f, __m512d: _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_sqrt_pd, _mm512_max_pd, avx512f: _mm512_fmadd_pd, _mm512_fnmadd_pd;
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

eight_lanes!(V4, __m512d, f64, avx512f: _mm512_permutex_pd);

/// Two items in one register: a register of doubles, or shuffles of it are made of its halves anew.
#[inline(always)]
fn two(v: V4, items: &[impl Eight<f32>], low: u32, high: u32) -> __m512 {
    let low: __m256d = cast(items[low as usize].eight());
    let high: __m256d = cast(items[high as usize].eight());
    let avx = v.avx512f;
    cast(avx._mm512_insertf64x4::<1>(avx._mm512_castpd256_pd512(low), high))
}

/// Puts them back.
#[inline(always)]
fn put_two(v: V4, both: __m512, bodies: &mut [Body<f32>], low: u32, high: u32) {
    bodies[low as usize] = Body(cast(v.avx512f._mm512_castps512_ps256(both)));
    bodies[high as usize] = Body(cast(v.avx512dq._mm512_extractf32x8_ps::<1>(both)));
}

/// Halves of two registers, `order` of their quarters' halves.
#[inline(always)]
fn merged(v: V4, linear: __m512, order: [u64; 8], spin: __m512) -> __m512 {
    let avx = v.avx512f;
    cast(avx._mm512_permutex2var_pd(cast(linear), cast(order), cast(spin)))
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
    fn fetch(self, items: &[impl Eight<f32>], at: &Sixteen<u32>, _: usize) -> [Self::Pack; 8] {
        let rows = [
            two(self, items, at[0], at[4]),
            two(self, items, at[1], at[5]),
            two(self, items, at[2], at[6]),
            two(self, items, at[3], at[7]),
            two(self, items, at[8], at[12]),
            two(self, items, at[9], at[13]),
            two(self, items, at[10], at[14]),
            two(self, items, at[11], at[15]),
        ];
        registers(self, rows)
    }

    #[inline(always)]
    fn put(self, rows: [Self::Pack; 8], bodies: &mut [Body<f32>], at: &Sixteen<u32>, _: usize) {
        put_two(self, rows[0].1, bodies, at[0], at[4]);
        put_two(self, rows[1].1, bodies, at[1], at[5]);
        put_two(self, rows[2].1, bodies, at[2], at[6]);
        put_two(self, rows[3].1, bodies, at[3], at[7]);
        put_two(self, rows[4].1, bodies, at[8], at[12]);
        put_two(self, rows[5].1, bodies, at[9], at[13]);
        put_two(self, rows[6].1, bodies, at[10], at[14]);
        put_two(self, rows[7].1, bodies, at[11], at[15]);
    }

    by_rows!(f32, 16);
}

impl Row for Register<V4, __m512> {
    #[inline(always)]
    fn masses(self) -> Self {
        Self(self.0, self.0.avx512f._mm512_permute_ps::<0xff>(self.1))
    }

    #[inline(always)]
    fn columns(rows: [Self; 8]) -> [Self; 8] {
        let (v, [a, b, c, d, e, f, g, h]) = (rows[0].0, bare(rows));
        // Of the first eight bodies and of the others: a component of the linear part, and of the spin, in turns of four.
        let (up, down) = (transposed_4(v, [a, b, c, d]), transposed_4(v, [e, f, g, h]));
        let avx = v.avx512f;
        registers(
            v,
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
    fn rows(columns: [Self; 8]) -> [Self; 8] {
        let (v, [a, b, c, d, e, f, g, h]) = (columns[0].0, bare(columns));
        let (linear, spin) = (transposed_4(v, [a, b, c, d]), transposed_4(v, [e, f, g, h]));
        registers(
            v,
            [
                merged(v, linear[0], FIRST, spin[0]),
                merged(v, linear[1], FIRST, spin[1]),
                merged(v, linear[2], FIRST, spin[2]),
                merged(v, linear[3], FIRST, spin[3]),
                merged(v, linear[0], LAST, spin[0]),
                merged(v, linear[1], LAST, spin[1]),
                merged(v, linear[2], LAST, spin[2]),
                merged(v, linear[3], LAST, spin[3]),
            ],
        )
    }
}
