//! Contacts that are no plain ones of spheres: arms across the normal, masses and inertia of any kind.
//!
//! With `s = L w`, `L` being the length by which the spin of a body is scaled, a contact at `r_A`, `r_B` from its bodies has
//!
//! ```text
//! u   = v_A - v_B + s_A x a - s_B x b,    a = r_A/L_A, b = r_B/L_B          [m/s]
//! v_A += M_A dp,          v_B -= M_B dp                                     M: inverse mass [1/kg]
//! s_A += K_A (a x dp),    s_B -= K_B (b x dp),        K = L^2 J^-1          [1/kg]
//! ```
//!
//! A couple over the radius `R` turns them by `K_A (R/L_A) dp`, as a [resistance](super::resistance) does. Contacts and resistances
//! are solved with the bounds of their operators along the normal and across it ([`Problem::delassus`](crate::problem::Problem::delassus)).
//!
//! A heavy body on which many spheres lie would need a block for each of its contacts. Instead `c` contacts of a block may share it:
//! each has a part of its own, a `c`-th of the mass, and the body has the mean of the parts' velocities afterwards. That is what the sum of
//! the impulses gives it.

use super::batch::{Batch, PLAIN, Vector};
use super::lanes::{Body, Columns, Lanes, Pack, Real, Sixteen, changed, sum_by_halves};
use super::local::{Seen, cross, dot, each, vector};
use nalgebra::Matrix3;

/// [`ELEMENTS`](crate::problem::ELEMENTS) of a symmetric matrix of each contact.
pub(super) type Symmetric<T> = [Sixteen<T>; 6];

/// Bounds `w_n` and `w_t` \[1/kg\] of each contact's operator.
pub(super) type Bounds<T> = [Sixteen<T>; 2];

/// Those of a block, also of its contacts of spheres.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Levers<T> {
    /// `a` and `b` \[-\].
    pub(super) arms: [Vector<T>; 2],
    /// `K_A` and `K_B` \[1/kg\].
    pub(super) turns: [Symmetric<T>; 2],
    /// Bounds of the contacts, and of their resistances, zeros where there is none.
    pub(super) bounds: [Bounds<T>; 2],
    /// `M_A` and `M_B` \[1/kg\]; in sweeps where they are `directed` alone.
    pub(super) masses: [Symmetric<T>; 2],
    /// Whether some `M` is no number, so that the bodies' own inverse masses do not do.
    pub(super) directed: bool,
    /// The body that some of the contacts share, if they do, and the share that each of their changes has in its own.
    pub(super) shared: Option<(u32, T)>,
}

impl Levers<f64> {
    /// Leaves in `levers` what these are in another precision, inverse masses times `share`.
    pub(super) fn write<T: Real>(&self, share: f64, levers: &mut Levers<T>) {
        let write = |from: &[Sixteen<f64>], to: &mut [Sixteen<T>], share: f64| {
            for (from, to) in from.iter().zip(to) {
                *to = changed(from, |x| T::of(x * share));
            }
        };
        write(
            self.arms.as_flattened(),
            levers.arms.as_flattened_mut(),
            1.0,
        );
        write(
            self.turns.as_flattened(),
            levers.turns.as_flattened_mut(),
            share,
        );
        write(
            self.bounds.as_flattened(),
            levers.bounds.as_flattened_mut(),
            share,
        );
        if self.directed {
            write(
                self.masses.as_flattened(),
                levers.masses.as_flattened_mut(),
                share,
            );
        }
        levers.directed = self.directed;
        levers.shared = self.shared.map(|(at, share)| (at, T::of(share)));
    }
}

/// The number that `matrix` is, if it is one.
pub(super) fn alike(matrix: &Matrix3<f64>) -> Option<f64> {
    let number = matrix[(0, 0)];
    (*matrix == Matrix3::identity() * number).then_some(number)
}

impl<T: Real> Levers<T> {
    /// What contacts of normals `n` and the given biases see of their bodies `ab`, whose ground drifts by `drift`.
    #[inline(always)]
    pub(super) fn see<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        [a, b]: &Columns<L::Pack>,
        (n, bias): ([L::Pack; 3], L::Pack),
        drift: Option<[L::Pack; 3]>,
    ) -> Seen<L::Pack> {
        let at_a = cross([a[4], a[5], a[6]], vector(l, &self.arms[0], pass));
        let at_b = cross([b[4], b[5], b[6]], vector(l, &self.arms[1], pass));
        let mut u = each(|k| (a[k] - b[k]) + (at_a[k] - at_b[k]));
        if let Some(drift) = drift {
            u = each(|k| u[k] + drift[k]);
        }
        let along = dot(u, n);
        Seen {
            n,
            u_n: along + bias,
            u_t: each(|k| u[k].less(n[k], along)),
            w_n: l.load(&self.bounds[0][0], pass),
            w_t: l.load(&self.bounds[0][1], pass),
        }
    }

    /// Gives the bodies `ab` the impulses `d`.
    #[inline(always)]
    pub(super) fn give<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        d: [L::Pack; 3],
        [a, b]: &mut Columns<L::Pack>,
    ) {
        match self.directed {
            true => {
                let (moved_a, moved_b) = (
                    symmetric(l, pass, &self.masses[0], d),
                    symmetric(l, pass, &self.masses[1], d),
                );
                for k in 0..3 {
                    a[k] = a[k] + moved_a[k];
                    b[k] = b[k] - moved_b[k];
                }
            }
            false => {
                for k in 0..3 {
                    a[k] = a[k].plus(a[3], d[k]);
                    b[k] = b[k].less(b[3], d[k]);
                }
            }
        }
        let at_a = cross(vector(l, &self.arms[0], pass), d);
        let at_b = cross(vector(l, &self.arms[1], pass), d);
        self.turn(l, pass, [at_a, at_b], [a, b]);
    }

    /// Turns bodies A by `K_A x_A`, and B back by `K_B x_B`.
    #[inline(always)]
    pub(super) fn turn<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        [x_a, x_b]: [[L::Pack; 3]; 2],
        [a, b]: [&mut [L::Pack; 8]; 2],
    ) {
        let [turn_a, turn_b] = &self.turns;
        let (turn_a, turn_b) = (
            symmetric(l, pass, turn_a, x_a),
            symmetric(l, pass, turn_b, x_b),
        );
        for k in 0..3 {
            a[k + 4] = a[k + 4] + turn_a[k];
            b[k + 4] = b[k + 4] - turn_b[k];
        }
    }
}

/// What a symmetric matrix of the given elements makes of `x`.
#[inline(always)]
pub(super) fn symmetric<T, L: Lanes<T>>(
    l: L,
    pass: usize,
    elements: &Symmetric<T>,
    x: [L::Pack; 3],
) -> [L::Pack; 3] {
    product(loaded(l, pass, elements), x)
}

/// The elements of a pass.
#[inline(always)]
pub(super) fn loaded<T, L: Lanes<T>>(l: L, pass: usize, elements: &Symmetric<T>) -> [L::Pack; 6] {
    let [xx, yy, zz, yz, zx, xy] = elements;
    [
        l.load(xx, pass),
        l.load(yy, pass),
        l.load(zz, pass),
        l.load(yz, pass),
        l.load(zx, pass),
        l.load(xy, pass),
    ]
}

/// [`symmetric`] of elements in packs.
#[inline(always)]
pub(super) fn product<P: Pack>([xx, yy, zz, yz, zx, xy]: [P; 6], x: [P; 3]) -> [P; 3] {
    [
        dot([xx, xy, zx], x),
        dot([xy, yy, yz], x),
        dot([zx, yz, zz], x),
    ]
}

impl<T: Real> Batch<T> {
    /// Its own of `all`, if it has such.
    #[inline(always)]
    pub(super) fn levers<'a, R>(&self, all: &'a [Levers<R>]) -> Option<&'a Levers<R>> {
        match self.levers {
            PLAIN => None,
            levers => Some(&all[levers as usize]),
        }
    }

    /// Sides and lanes that hold the body at `at`, which is not the one that never moves.
    pub(super) fn holding(&self, at: u32) -> impl Iterator<Item = (usize, usize)> {
        let lanes = (0..self.count as usize).flat_map(|lane| [(0, lane), (1, lane)]);
        lanes.filter(move |&(side, lane)| self.bodies[side][lane] == at)
    }

    /// Puts bodies A and B back, but the one that contacts share.
    #[inline(always)]
    pub(super) fn put<L: Lanes<R>, R: Real>(
        &self,
        l: L,
        pass: usize,
        ab: Columns<L::Pack>,
        (bodies, shared): (&mut [Body<R>], &mut Option<Shared<R>>),
    ) {
        match shared {
            None => self.put_columns(l, pass, ab, bodies),
            Some(shared) => shared.put(l, pass, self, ab, bodies),
        }
    }
}

/// The body that contacts of a block share, while the block is under way.
pub(super) struct Shared<T> {
    at: u32,
    share: T,
    before: Body<T>,
    /// One for each contact that has it as its body A, and as B; else zero.
    holds: [Sixteen<T>; 2],
    /// What each contact adds to its velocity and spin.
    change: [Sixteen<T>; 6],
}

/// Components of a [`Body`] that change.
const MOVING: [usize; 6] = [0, 1, 2, 4, 5, 6];

impl<T: Real> Shared<T> {
    /// That of the contacts of `block`, if they share one.
    #[inline(always)]
    pub(super) fn of(
        block: &Batch<impl Real>,
        levers: Option<&Levers<T>>,
        bodies: &[Body<T>],
    ) -> Option<Self> {
        let (at, share) = levers?.shared?;
        let held = |x: u32| T::of(f64::from(u8::from(x == at)));
        Some(Self {
            at,
            share,
            before: bodies[at as usize],
            holds: [
                changed(&block.bodies[0], held),
                changed(&block.bodies[1], held),
            ],
            change: [Sixteen::default(); 6],
        })
    }

    /// Puts the bodies `ab` of contacts of `block` back, but this one, whose changes are kept.
    #[inline(always)]
    pub(super) fn put<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        block: &Batch<impl Real>,
        ab: Columns<L::Pack>,
        bodies: &mut [Body<T>],
    ) {
        let [of_a, of_b] = &self.holds;
        let (of_a, of_b) = (l.load(of_a, pass), l.load(of_b, pass));
        for (k, change) in MOVING.into_iter().zip(&mut self.change) {
            let before = l.splat(self.before.0[k]);
            let a = of_a * (ab[0][k] - before);
            l.store(a.plus(of_b, ab[1][k] - before), change, pass);
        }
        block.put_columns(l, pass, ab, bodies);
        bodies[self.at as usize] = self.before;
    }

    /// Gives it its share of all changes.
    #[inline(always)]
    pub(super) fn finish(self, bodies: &mut [Body<T>]) {
        let Body(x) = &mut bodies[self.at as usize];
        for (k, change) in MOVING.into_iter().zip(self.change) {
            x[k] += self.share * sum_by_halves(change);
        }
    }
}
