//! Four numbers at a time, in one register where the processor has such, else one after the other: the same bits.

use std::ops::{Add, Mul, Sub};

/// Four numbers.
pub(super) trait Quad:
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

/// What makes quads: the proof that the processor has the registers.
pub(super) trait Lanes: Copy {
    /// Its quad.
    type Quad: Quad;

    /// From memory.
    fn quad(self, x: [f64; 4]) -> Self::Quad;
    /// To memory.
    fn array(self, x: Self::Quad) -> [f64; 4];
    /// Rows to columns, or columns to rows.
    fn transpose(self, rows: [Self::Quad; 4]) -> [Self::Quad; 4];

    /// The same number four times.
    #[inline(always)]
    fn splat(self, x: f64) -> Self::Quad {
        self.quad([x; 4])
    }
}

/// One after the other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plain;

#[derive(Debug, Clone, Copy)]
pub(super) struct Four([f64; 4]);

impl Four {
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
}

impl Lanes for Plain {
    type Quad = Four;

    fn quad(self, x: [f64; 4]) -> Four {
        Four(x)
    }

    fn array(self, x: Four) -> [f64; 4] {
        x.0
    }

    fn transpose(self, rows: [Four; 4]) -> [Four; 4] {
        std::array::from_fn(|k| Four(std::array::from_fn(|l| rows[l].0[k])))
    }
}

impl Add for Four {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl Sub for Four {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl Mul for Four {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl Quad for Four {
    fn over(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }

    fn root(self) -> Self {
        Self(self.0.map(f64::sqrt))
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
        (0..4).all(|k| self.0[k] <= limit.0[k])
    }
}

#[cfg(target_arch = "x86_64")]
mod wide {
    use std::arch::x86_64::{__m256d, _CMP_LE_OQ};
    use std::ops::{Add, Mul, Sub};

    use pulp::cast;
    use pulp::x86::V3;

    use super::{Lanes, Quad};

    /// One register; the token is of no size.
    #[derive(Debug, Clone, Copy)]
    pub(in super::super) struct Register(V3, __m256d);

    impl Lanes for V3 {
        type Quad = Register;

        #[inline(always)]
        fn quad(self, x: [f64; 4]) -> Register {
            Register(self, cast(x))
        }

        #[inline(always)]
        fn array(self, x: Register) -> [f64; 4] {
            cast(x.1)
        }

        #[inline(always)]
        fn transpose(self, [a, b, c, d]: [Register; 4]) -> [Register; 4] {
            let avx = self.avx;
            let low = [
                avx._mm256_unpacklo_pd(a.1, b.1),
                avx._mm256_unpacklo_pd(c.1, d.1),
            ];
            let high = [
                avx._mm256_unpackhi_pd(a.1, b.1),
                avx._mm256_unpackhi_pd(c.1, d.1),
            ];
            [
                Register(self, avx._mm256_permute2f128_pd::<0x20>(low[0], low[1])),
                Register(self, avx._mm256_permute2f128_pd::<0x20>(high[0], high[1])),
                Register(self, avx._mm256_permute2f128_pd::<0x31>(low[0], low[1])),
                Register(self, avx._mm256_permute2f128_pd::<0x31>(high[0], high[1])),
            ]
        }
    }

    impl Add for Register {
        type Output = Self;
        #[inline(always)]
        fn add(self, other: Self) -> Self {
            Self(self.0, self.0.avx._mm256_add_pd(self.1, other.1))
        }
    }

    impl Sub for Register {
        type Output = Self;
        #[inline(always)]
        fn sub(self, other: Self) -> Self {
            Self(self.0, self.0.avx._mm256_sub_pd(self.1, other.1))
        }
    }

    impl Mul for Register {
        type Output = Self;
        #[inline(always)]
        fn mul(self, other: Self) -> Self {
            Self(self.0, self.0.avx._mm256_mul_pd(self.1, other.1))
        }
    }

    impl Quad for Register {
        #[inline(always)]
        fn over(self, other: Self) -> Self {
            Self(self.0, self.0.avx._mm256_div_pd(self.1, other.1))
        }

        #[inline(always)]
        fn root(self) -> Self {
            Self(self.0, self.0.avx._mm256_sqrt_pd(self.1))
        }

        #[inline(always)]
        fn or_larger(self, other: Self) -> Self {
            Self(self.0, self.0.avx._mm256_max_pd(self.1, other.1))
        }

        #[inline(always)]
        fn within(self, limit: Self, yes: Self, no: Self) -> Self {
            let avx = self.0.avx;
            let mask = avx._mm256_cmp_pd::<_CMP_LE_OQ>(self.1, limit.1);
            Self(self.0, avx._mm256_blendv_pd(no.1, yes.1, mask))
        }

        #[inline(always)]
        fn all_within(self, limit: Self) -> bool {
            let avx = self.0.avx;
            avx._mm256_movemask_pd(avx._mm256_cmp_pd::<_CMP_LE_OQ>(self.1, limit.1)) == 0b1111
        }
    }
}
