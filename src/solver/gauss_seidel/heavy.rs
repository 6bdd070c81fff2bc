//! Contacts of spheres on a body that is heavy beside them, as driven ones are.
//!
//! The `c` contacts of a block share it as [levers] do: each has a part of a `c`-th of its mass, and it gets what the sum of their
//! impulses gives it. With the arm `b = r_B/L_B` from its centre and a sphere as in [`local`](super::local) a contact has
//!
//! ```text
//! u   = v_A - v_B - s_A x n - s_B x b               [m/s]
//! v_A += m_A dp,          v_B -= M_B sum dp         M_B: inverse mass [1/kg]
//! s_A -= k_A (n x dp),    s_B -= K_B sum (b x dp)   K_B = L_B^2 J_B^-1 [1/kg]
//! ```
//!
//! So it is read once for a block and written once, and costs little more than ground that moves.
//!
//! [levers]: super::levers

use super::batch::{Batch, Extra, PLAIN, Vector};
use super::lanes::{Body, Lanes, Pack, Real, Sixteen, changed, sum_by_halves};
use super::levers::Bounds;
use super::local::{Seen, cross, each, vector};

/// A body and the contacts of a block that are on it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Heavy<T> {
    /// Its place.
    pub(super) at: u32,
    /// `b` of each contact \[-\].
    pub(super) arms: Vector<T>,
    /// Of the contacts' operators, of which each has all of the body, or a part of it.
    pub(super) bounds: Bounds<T>,
    /// [`ELEMENTS`](crate::problem::ELEMENTS) of `M_B` and `K_B` \[1/kg\].
    pub(super) mass: [T; 6],
    pub(super) turn: [T; 6],
}

/// What the contacts of a block give their heavy body: impulses, and couples over `L_B`.
pub(super) struct Given<T>([Sixteen<T>; 6]);

impl Heavy<f64> {
    /// Leaves in `heavy` what this is in another precision, with these bounds and inverse masses times `share`.
    pub(super) fn write<T: Real>(&self, bounds: &Bounds<f64>, share: f64, heavy: &mut Heavy<T>) {
        let scaled = |x: f64| T::of(x * share);
        *heavy = Heavy {
            at: self.at,
            arms: each(|k| changed(&self.arms[k], T::of)),
            bounds: [changed(&bounds[0], scaled), changed(&bounds[1], scaled)],
            mass: self.mass.map(scaled),
            turn: self.turn.map(scaled),
        };
    }
}

impl<T: Real> Batch<T> {
    /// Its own of `all`, if its contacts are on a heavy body.
    #[inline(always)]
    pub(super) fn heavy<'a, R>(&self, all: &'a [Heavy<R>]) -> Option<&'a Heavy<R>> {
        match self.heavy {
            PLAIN => None,
            heavy => Some(&all[heavy as usize]),
        }
    }

    /// Spheres of a pass, by components: bodies A of contacts on a heavy body.
    #[inline(always)]
    pub(super) fn spheres<L: Lanes<R>, R: Real>(
        &self,
        l: L,
        pass: usize,
        bodies: &[Body<R>],
    ) -> [L::Pack; 8] {
        l.columns(l.fetch(bodies, &self.bodies[0], pass))
    }
}

impl<T: Real> Heavy<T> {
    /// What contacts of `block` with normals `n` and the given biases see of the spheres `a`, by components, and of the body.
    #[inline(always)]
    pub(super) fn see<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        (block, a): (&Batch<impl Real>, &[L::Pack; 8]),
        own: ([L::Pack; 3], L::Pack),
        (bodies, extras): (&[Body<T>], &[Extra<T>]),
    ) -> Seen<L::Pack> {
        let Body(b) = &bodies[self.at as usize];
        let turning = [l.splat(b[4]), l.splat(b[5]), l.splat(b[6])];
        let at_b = cross(turning, vector(l, &self.arms, pass));
        let between = [
            (a[0] - l.splat(b[0])) - at_b[0],
            (a[1] - l.splat(b[1])) - at_b[1],
            (a[2] - l.splat(b[2])) - at_b[2],
            a[3],
            a[4],
            a[5],
            a[6],
            a[7],
        ];
        Seen {
            w_n: l.load(&self.bounds[0], pass),
            w_t: l.load(&self.bounds[1], pass),
            ..block.see(l, pass, between, own, extras)
        }
    }

    /// Gives the spheres `a` of contacts of `block` with normals `n` the impulses `d`, and keeps what the body gets.
    #[inline(always)]
    pub(super) fn give<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        (block, mut a): (&Batch<impl Real>, [L::Pack; 8]),
        (n, d): ([L::Pack; 3], [L::Pack; 3]),
        (bodies, given): (&mut [Body<T>], &mut Given<T>),
    ) {
        let turned = cross(n, d);
        let couple = cross(vector(l, &self.arms, pass), d);
        for k in 0..3 {
            a[k] = a[k].plus(a[3], d[k]);
            a[k + 4] = a[k + 4].less(a[7], turned[k]);
            l.store(d[k], &mut given.0[k], pass);
            l.store(couple[k], &mut given.0[k + 3], pass);
        }
        l.put(l.rows(a), bodies, &block.bodies[0], pass);
    }
}

impl<T: Real> Given<T> {
    /// Nothing yet.
    #[inline(always)]
    pub(super) fn none() -> Self {
        Self([Sixteen::default(); 6])
    }

    /// Gives it to the body of `heavy`.
    #[inline(always)]
    pub(super) fn finish(&self, heavy: &Heavy<T>, bodies: &mut [Body<T>]) {
        let sum = |k: usize| sum_by_halves(self.0[k]);
        let Body(x) = &mut bodies[heavy.at as usize];
        for (first, elements, given) in [
            (0, &heavy.mass, [sum(0), sum(1), sum(2)]),
            (4, &heavy.turn, [sum(3), sum(4), sum(5)]),
        ] {
            let [xx, yy, zz, yz, zx, xy] = *elements;
            let [a, b, c] = given;
            x[first] = x[first] - (xx * a + xy * b + zx * c);
            x[first + 1] = x[first + 1] - (xy * a + yy * b + yz * c);
            x[first + 2] = x[first + 2] - (zx * a + yz * b + zz * c);
        }
    }
}
