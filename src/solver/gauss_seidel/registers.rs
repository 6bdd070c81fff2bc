//! Numbers in the registers of x86 processors.

/// One register with the proof that the processor has it, which is of no size.
#[derive(Debug, Clone, Copy)]
pub(super) struct Register<V, R>(pub(super) V, pub(super) R);

/// Eight registers. Written out here and in what follows: a closure that is not inlined does not get the wide registers.
#[inline(always)]
pub(super) fn registers<V: Copy, R: Copy>(v: V, r: [R; 8]) -> [Register<V, R>; 8] {
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

/// [`Pack`] of a register by the processor's instructions; the comparisons are written out.
macro_rules! pack {
    ($v:ty, $set:ident, $register:ty: $add:ident, $sub:ident, $mul:ident, $div:ident, $sqrt:ident, $max:ident; $($compare:item)*) => {
        impl Add for Register<$v, $register> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self(self.0, self.0.$set.$add(self.1, other.1))
            }
        }

        impl Sub for Register<$v, $register> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self(self.0, self.0.$set.$sub(self.1, other.1))
            }
        }

        impl Mul for Register<$v, $register> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                Self(self.0, self.0.$set.$mul(self.1, other.1))
            }
        }

        impl Pack for Register<$v, $register> {
            #[inline(always)]
            fn over(self, other: Self) -> Self {
                Self(self.0, self.0.$set.$div(self.1, other.1))
            }

            #[inline(always)]
            fn root(self) -> Self {
                Self(self.0, self.0.$set.$sqrt(self.1))
            }

            #[inline(always)]
            fn or_larger(self, other: Self) -> Self {
                Self(self.0, self.0.$set.$max(self.1, other.1))
            }

            $(#[inline(always)] $compare)*
        }
    };
}

pub(super) use pack;
