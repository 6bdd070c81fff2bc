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

use super::batch::{Batch, Extra, Vector};
use super::dispatch::{Precision, Task};
use super::lanes::{Body, Lanes, Pack, Real, Sixteen, changed, sum_by_halves};
use super::levers::Bounds;
use super::local::{Seen, cross, dot, each, vector};
use crate::problem::{CONSTANTS, ELEMENTS, GROUND, Problem, bounds};
use crate::solver::params::Registers;

/// A body and the contacts of a block that are on it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Heavy<T> {
    /// Its place.
    pub(super) at: u32,
    /// `b` of each contact \[-\].
    pub(super) arms: Vector<T>,
    /// Of the contacts' operators, of which each has all of the body, or a part of it.
    pub(super) bounds: Bounds<T>,
    /// [`ELEMENTS`] of `M_B` and `K_B` \[1/kg\].
    pub(super) mass: [T; 6],
    pub(super) turn: [T; 6],
}

/// What the contacts of a block give their heavy body: impulses, and couples over `L_B`.
pub(super) struct Given<T>([Sixteen<T>; 6]);

impl Heavy<f64> {
    /// Takes the contacts that are `rows` of `problem`, all of one body; bodies are at `place`, spins of bodies are scaled by `length` \[m\].
    /// Returns their bounds where each has a part of the body.
    pub(super) fn fill(
        &mut self,
        (problem, rows): (&Problem, &[u32]),
        place: &[u32],
        length: impl Fn(usize) -> f64,
        registers: Registers,
    ) -> Bounds<f64> {
        let mut spheres = Spheres::default();
        *self = Self::default();
        for (lane, &k) in rows.iter().enumerate() {
            let [a, b] = problem.rows.bodies(k as usize);
            debug_assert!(b != GROUND);
            let (sphere, scale) = (&problem.inverse_mass[a as usize], length(a as usize));
            spheres.mass[lane] = sphere.linear.x;
            spheres.turn[lane] = sphere.angular.x * scale * scale;
            spheres.held[lane] = 1.0;
            let (normal, arm) = (
                problem.rows.normal(k as usize),
                problem.rows.arm_b(k as usize),
            );
            let scale = length(b as usize);
            for axis in 0..3 {
                spheres.normal[axis][lane] = normal[axis];
                self.arms[axis][lane] = arm[axis] / scale;
            }
            if lane == 0 {
                let operator = problem.operator(b);
                self.at = place[b as usize];
                self.mass = ELEMENTS.map(|at| operator.linear[at]);
                self.turn = ELEMENTS.map(|at| operator.angular[at] * (scale * scale));
            }
        }
        let find = FindBounds {
            heavy: self,
            spheres: &spheres,
            shares: [1.0, rows.len() as f64],
        };
        let [whole, parts] = f64::with(registers, find);
        self.bounds = whole;
        parts
    }

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

/// The spheres of the contacts of a block; zeros where there is none.
#[derive(Default)]
struct Spheres {
    normal: Vector<f64>,
    mass: Sixteen<f64>,
    turn: Sixteen<f64>,
    /// One where there is a contact.
    held: Sixteen<f64>,
}

/// Contacts whose bounds are to be found where each has `shares` times the mobility of the body.
struct FindBounds<'a> {
    heavy: &'a Heavy<f64>,
    spheres: &'a Spheres,
    shares: [f64; 2],
}

impl Task for FindBounds<'_> {
    type Real = f64;
    type Output = [Bounds<f64>; 2];

    #[inline(always)]
    fn with<L: Lanes<f64>>(self, l: L) -> [Bounds<f64>; 2] {
        let (heavy, spheres, zero) = (self.heavy, self.spheres, l.splat(0.0));
        let mut constants = [zero; CONSTANTS.len()];
        for (own, constant) in constants.iter_mut().zip(CONSTANTS) {
            *own = l.splat(constant);
        }
        let mut found = [Bounds::default(); 2];
        for pass in 0..L::PASSES {
            let n = vector(l, &spheres.normal, pass);
            let held = l.load(&spheres.held, pass);
            let (mass, turn) = (l.load(&spheres.mass, pass), l.load(&spheres.turn, pass));
            // Of a unit impulse along each axis: the couple at the body, and the turn that it makes.
            let [x, y, z] = vector(l, &heavy.arms, pass);
            let couples = [
                [zero, z, zero - y],
                [zero - z, zero, x],
                [y, zero - x, zero],
            ];
            let mut turns = couples;
            for couple in &mut turns {
                *couple = times(l, &heavy.turn, *couple);
            }
            let (mut of_a, mut of_b) = ([zero; 6], [zero; 6]);
            for (k, (i, j)) in ELEMENTS.into_iter().enumerate() {
                of_b[k] = held * (l.splat(heavy.mass[k]) + dot(couples[i], turns[j]));
                of_a[k] = zero - turn * (n[i] * n[j]);
                if i == j {
                    of_a[k] = of_a[k] + mass + turn;
                }
            }
            for (share, found) in self.shares.into_iter().zip(&mut found) {
                let share = l.splat(share);
                let mut operator = of_a;
                for k in 0..6 {
                    operator[k] = operator[k].plus(share, of_b[k]);
                }
                let (w_n, w_t) = bounds(operator, n, constants);
                l.store(w_n, &mut found[0], pass);
                l.store(w_t, &mut found[1], pass);
            }
        }
        found
    }
}

/// What the symmetric matrix of these elements makes of each `x`.
#[inline(always)]
fn times<T: Real, L: Lanes<T>>(l: L, elements: &[T; 6], x: [L::Pack; 3]) -> [L::Pack; 3] {
    let [xx, yy, zz, yz, zx, xy] = elements.map(|x| l.splat(x));
    [
        dot([xx, xy, zx], x),
        dot([xy, yy, yz], x),
        dot([zx, yz, zz], x),
    ]
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
