//! AVX2: eight numbers in single precision, four in double.

use std::arch::x86_64::{__m256, __m256d, _CMP_LE_OQ};
use std::ops::{Add, Mul, Sub};

use pulp::cast;
use pulp::x86::V3;

use super::lanes::{Body, Eight, Lanes, Pack, Sixteen};
use super::registers::{
    GIVEN, OTHER, Register, Row, bare, by_rows, eight_lanes, pack, registers, signed,
};

pack!(V3, avx, __m256: _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps, _mm256_sqrt_ps, _mm256_max_ps, fma: _mm256_fmadd_ps, _mm256_fnmadd_ps;
    fn within(self, limit: Self, yes: Self, no: Self) -> Self {
        let avx = self.0.avx;
        let mask = avx._mm256_cmp_ps::<_CMP_LE_OQ>(self.1, limit.1);
        Self(self.0, avx._mm256_blendv_ps(no.1, yes.1, mask))
    }
    fn bits_within(self, limit: Self) -> u16 {
        let avx = self.0.avx;
        avx._mm256_movemask_ps(avx._mm256_cmp_ps::<_CMP_LE_OQ>(self.1, limit.1)) as u16
    }
);

pack!(V3, avx, __m256d: _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_sqrt_pd, _mm256_max_pd, fma: _mm256_fmadd_pd, _mm256_fnmadd_pd;
    fn within(self, limit: Self, yes: Self, no: Self) -> Self {
        let avx = self.0.avx;
        let mask = avx._mm256_cmp_pd::<_CMP_LE_OQ>(self.1, limit.1);
        Self(self.0, avx._mm256_blendv_pd(no.1, yes.1, mask))
    }
    fn bits_within(self, limit: Self) -> u16 {
        let avx = self.0.avx;
        avx._mm256_movemask_pd(avx._mm256_cmp_pd::<_CMP_LE_OQ>(self.1, limit.1)) as u16
    }
);

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

/// The two halves of an item.
#[inline(always)]
fn halves(items: &[impl Eight<f64>], at: u32) -> [__m256d; 2] {
    cast(items[at as usize].eight())
}

impl Lanes<f64> for V3 {
    type Pack = Register<Self, __m256d>;
    const WIDTH: usize = 4;

    #[inline(always)]
    fn splat(self, x: f64) -> Self::Pack {
        Register(self, cast([x; 4]))
    }

    #[inline(always)]
    fn load(self, x: &Sixteen<f64>, pass: usize) -> Self::Pack {
        Register(self, cast(x.as_chunks::<4>().0[pass]))
    }

    #[inline(always)]
    fn store(self, pack: Self::Pack, x: &mut Sixteen<f64>, pass: usize) {
        x.as_chunks_mut::<4>().0[pass] = cast(pack.1);
    }

    /// Linear halves, then spins.
    #[inline(always)]
    fn fetch(self, items: &[impl Eight<f64>], at: &Sixteen<u32>, pass: usize) -> [Self::Pack; 8] {
        let at = &at.as_chunks::<4>().0[pass];
        let [p, q] = [halves(items, at[0]), halves(items, at[1])];
        let [r, s] = [halves(items, at[2]), halves(items, at[3])];
        registers(self, [p[0], q[0], r[0], s[0], p[1], q[1], r[1], s[1]])
    }

    #[inline(always)]
    fn put(self, rows: [Self::Pack; 8], bodies: &mut [Body<f64>], at: &Sixteen<u32>, pass: usize) {
        let at = &at.as_chunks::<4>().0[pass];
        bodies[at[0] as usize] = Body(cast([rows[0].1, rows[4].1]));
        bodies[at[1] as usize] = Body(cast([rows[1].1, rows[5].1]));
        bodies[at[2] as usize] = Body(cast([rows[2].1, rows[6].1]));
        bodies[at[3] as usize] = Body(cast([rows[3].1, rows[7].1]));
    }

    by_rows!(f64, 4);
}

impl Row for Register<V3, __m256d> {
    #[inline(always)]
    fn masses(self) -> Self {
        Self(self.0, self.0.avx2._mm256_permute4x64_pd::<0xff>(self.1))
    }

    #[inline(always)]
    fn columns(rows: [Self; 8]) -> [Self; 8] {
        let (v, [a, b, c, d, e, f, g, h]) = (rows[0].0, bare(rows));
        let [a, b, c, d] = transposed_4(v, [a, b, c, d]);
        let [e, f, g, h] = transposed_4(v, [e, f, g, h]);
        registers(v, [a, b, c, d, e, f, g, h])
    }
}

eight_lanes!(V3, __m256, f32, avx: _mm256_permute_ps);
