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

/// Without the proof.
#[inline(always)]
pub(super) fn bare<V: Copy, R: Copy>(r: [Register<V, R>; 8]) -> [R; 8] {
    [
        r[0].1, r[1].1, r[2].1, r[3].1, r[4].1, r[5].1, r[6].1, r[7].1,
    ]
}

/// [`Pack`] of a register by the processor's instructions; the comparisons are written out.
macro_rules! pack {
    ($v:ty, $set:ident, $register:ty: $add:ident, $sub:ident, $mul:ident, $div:ident, $sqrt:ident, $max:ident, $fused:ident: $plus:ident, $less:ident; $($compare:item)*) => {
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
            fn plus(self, a: Self, b: Self) -> Self {
                Self(self.0, self.0.$fused.$plus(a.1, b.1, self.1))
            }

            #[inline(always)]
            fn less(self, a: Self, b: Self) -> Self {
                Self(self.0, self.0.$fused.$less(a.1, b.1, self.1))
            }

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

/// Registers with bodies as they lie in memory: whole ones, or halves, the linear ones first.
pub(super) trait Row: Sized {
    /// Inverse mass in the place of velocity, `R^2/I` in that of spin.
    fn masses(self) -> Self;
    /// The bodies by components.
    fn columns(rows: [Self; 8]) -> [Self; 8];
    /// And back: the same where eight numbers in eight registers are turned.
    #[inline(always)]
    fn rows(columns: [Self; 8]) -> [Self; 8] {
        Self::columns(columns)
    }
}

/// Signs of body B where velocities are subtracted and all else is summed, and of body A where it gets an impulse and a turn.
pub(super) const OTHER: [i8; 8] = [-1, -1, -1, 1, 1, 1, 1, 1];
pub(super) const GIVEN: [i8; 8] = [1, 1, 1, 1, -1, -1, -1, -1];

/// Those of `signs` for what row `k` of `N` numbers holds.
#[inline(always)]
pub(super) fn signed<T: From<i8>, const N: usize>(signs: [i8; 8], k: usize) -> [T; N] {
    let first = if N < 8 { k / N * N } else { 0 };
    std::array::from_fn(|i| signs[(first + i) % 8].into())
}

/// What [`Lanes`] does with two bodies. Differences are turned to columns and impulses to rows, so that each is turned once
/// and not for A and B.
macro_rules! by_rows {
    ($real:ty, $numbers:expr) => {
        #[inline(always)]
        fn columns(self, rows: [Self::Pack; 8]) -> [Self::Pack; 8] {
            Row::columns(rows)
        }

        #[inline(always)]
        fn rows(self, columns: [Self::Pack; 8]) -> [Self::Pack; 8] {
            Row::rows(columns)
        }

        #[inline(always)]
        fn between(self, [mut a, b]: [[Self::Pack; 8]; 2]) -> [Self::Pack; 8] {
            for k in 0..8 {
                let signs = signed::<$real, $numbers>(OTHER, k);
                a[k] = a[k].plus(b[k], Register(self, cast(signs)));
            }
            Row::columns(a)
        }

        #[inline(always)]
        fn pushed(
            self,
            [mut a, mut b]: [[Self::Pack; 8]; 2],
            d: [Self::Pack; 3],
            c: [Self::Pack; 3],
        ) -> [[Self::Pack; 8]; 2] {
            let zero = Register(self, cast([0.0 as $real; $numbers]));
            let given = Row::rows([d[0], d[1], d[2], zero, c[0], c[1], c[2], zero]);
            for k in 0..8 {
                let signs = signed::<$real, $numbers>(GIVEN, k);
                let masses = a[k].masses() * Register(self, cast(signs));
                a[k] = a[k].plus(masses, given[k]);
                b[k] = b[k].less(b[k].masses(), given[k]);
            }
            [a, b]
        }
    };
}

/// [`Lanes`] where a register holds all eight numbers of a body, so that eight bodies are turned as a whole.
macro_rules! eight_lanes {
    ($v:ty, $register:ty, $real:ty, $set:ident: $permute:ident) => {
        impl Row for Register<$v, $register> {
            #[inline(always)]
            fn masses(self) -> Self {
                Self(self.0, self.0.$set.$permute::<0xff>(self.1))
            }

            #[inline(always)]
            fn columns(rows: [Self; 8]) -> [Self; 8] {
                let v = rows[0].0;
                registers(v, transposed_8(v, bare(rows)))
            }
        }

        impl Lanes<$real> for $v {
            type Pack = Register<Self, $register>;
            const WIDTH: usize = 8;

            #[inline(always)]
            fn splat(self, x: $real) -> Self::Pack {
                Register(self, cast([x; 8]))
            }

            #[inline(always)]
            fn load(self, x: &Sixteen<$real>, pass: usize) -> Self::Pack {
                Register(self, cast(x.as_chunks::<8>().0[pass]))
            }

            #[inline(always)]
            fn store(self, pack: Self::Pack, x: &mut Sixteen<$real>, pass: usize) {
                x.as_chunks_mut::<8>().0[pass] = cast(pack.1);
            }

            #[inline(always)]
            fn fetch(
                self,
                items: &[impl Eight<$real>],
                at: &Sixteen<u32>,
                pass: usize,
            ) -> [Self::Pack; 8] {
                let at = &at.as_chunks::<8>().0[pass];
                let rows = [
                    cast(items[at[0] as usize].eight()),
                    cast(items[at[1] as usize].eight()),
                    cast(items[at[2] as usize].eight()),
                    cast(items[at[3] as usize].eight()),
                    cast(items[at[4] as usize].eight()),
                    cast(items[at[5] as usize].eight()),
                    cast(items[at[6] as usize].eight()),
                    cast(items[at[7] as usize].eight()),
                ];
                registers(self, rows)
            }

            #[inline(always)]
            fn put(
                self,
                rows: [Self::Pack; 8],
                bodies: &mut [Body<$real>],
                at: &Sixteen<u32>,
                pass: usize,
            ) {
                let at = &at.as_chunks::<8>().0[pass];
                bodies[at[0] as usize] = Body(cast(rows[0].1));
                bodies[at[1] as usize] = Body(cast(rows[1].1));
                bodies[at[2] as usize] = Body(cast(rows[2].1));
                bodies[at[3] as usize] = Body(cast(rows[3].1));
                bodies[at[4] as usize] = Body(cast(rows[4].1));
                bodies[at[5] as usize] = Body(cast(rows[5].1));
                bodies[at[6] as usize] = Body(cast(rows[6].1));
                bodies[at[7] as usize] = Body(cast(rows[7].1));
            }

            by_rows!($real, 8);
        }
    };
}

pub(super) use {by_rows, eight_lanes, pack};
