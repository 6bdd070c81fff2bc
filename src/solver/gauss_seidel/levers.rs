//! Contacts of bodies that are no spheres: arms across the normal, inertia of any kind.
//!
//! With `s = L w`, `L` being the length by which the spin of a body is scaled, a contact at `r_A`, `r_B` from its bodies has
//!
//! ```text
//! u   = v_A - v_B + s_A x a - s_B x b,    a = r_A/L_A, b = r_B/L_B          [m/s]
//! v_A += m_A dp,  v_B -= m_B dp                                             m: inverse mass [1/kg]
//! s_A += T_A dp,  s_B -= T_B dp,          T = L J^-1 [r x]                  [1/kg]
//! ```
//!
//! Its law is solved with the bounds of its operator along the normal and across it ([`Problem::delassus`]).

use super::batch::{Batch, Extra, PLAIN, Vector};
use super::lanes::{Body, Columns, Lanes, Pack, Real, Sixteen, changed};
use super::local::{Constants, Seen, cross, dot, each, vector};
use crate::Vec3;
use crate::problem::{GROUND, Problem};

/// Those of a block, also of its contacts of spheres.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Levers<T> {
    /// `a` and `b` \[-\].
    pub(super) arms: [Vector<T>; 2],
    /// Columns of `T_A` and `T_B` \[1/kg\].
    pub(super) turns: [[Vector<T>; 3]; 2],
    /// `w_n` and `w_t` \[1/kg\].
    pub(super) scale: [Sixteen<T>; 2],
}

impl Levers<f64> {
    /// Those of the contacts that are `rows` of `problem`; spins of bodies are scaled by `length` \[m\].
    pub(super) fn of(problem: &Problem, rows: &[u32], length: impl Fn(usize) -> f64) -> Self {
        let mut levers = Self::default();
        for (lane, &k) in rows.iter().enumerate() {
            let row = problem.rows.get(k as usize);
            for (side, (body, arm)) in [(row.a, row.arm_a), (row.b, row.arm_b)].iter().enumerate() {
                if *body == GROUND {
                    continue;
                }
                let length = length(*body as usize);
                let grip = row.jacobian()[side];
                for axis in 0..3 {
                    levers.arms[side][axis][lane] = arm[axis] / length;
                    let unit = Vec3::ith(axis, 1.0);
                    let turn = problem.velocity_change(*body, &grip.momentum(unit)).angular;
                    for (lanes, x) in levers.turns[side][axis].iter_mut().zip(&turn) {
                        lanes[lane] = x * length;
                    }
                }
            }
            let (normal, tangential) = problem.delassus(&row);
            (levers.scale[0][lane], levers.scale[1][lane]) = (normal, tangential);
        }
        levers
    }

    /// In another precision, inverse masses times `share`.
    pub(super) fn of_share<T: Real>(&self, share: f64) -> Levers<T> {
        let scaled = |x: &Sixteen<f64>| changed(x, |x| T::of(x * share));
        let [turn_a, turn_b] = &self.turns;
        let turned = |columns: &[Vector<f64>; 3]| each(|j| each(|k| scaled(&columns[j][k])));
        Levers {
            arms: [0, 1].map(|side| each(|k| changed(&self.arms[side][k], T::of))),
            turns: [turned(turn_a), turned(turn_b)],
            scale: [scaled(&self.scale[0]), scaled(&self.scale[1])],
        }
    }
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
            w_n: l.load(&self.scale[0], pass),
            w_t: l.load(&self.scale[1], pass),
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
        let [turn_a, turn_b] = &self.turns;
        for k in 0..3 {
            a[k] = a[k].plus(a[3], d[k]);
            b[k] = b[k].less(b[3], d[k]);
            for axis in 0..3 {
                a[k + 4] = a[k + 4].plus(l.load(&turn_a[axis][k], pass), d[axis]);
                b[k + 4] = b[k + 4].less(l.load(&turn_b[axis][k], pass), d[axis]);
            }
        }
    }
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

    /// [`Batch::update`] of contacts with levers.
    #[inline(always)]
    pub(super) fn update_levered<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        (bodies, levers): (&mut [Body<T>], &Levers<T>),
        extras: &[Extra<T>],
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let mut ab = self.columns(l, pass, bodies);
        let own = (vector(l, &self.normal, pass), l.load(&self.bias, pass));
        let seen = levers.see(l, pass, &ab, own, self.drift(l, pass, extras));
        let own = self.solve_seen(l, pass, seen, extras, latest, pace);
        levers.give(l, pass, own.change.d, &mut ab);
        self.put_columns(l, pass, ab, bodies);
        (own.settled, own.change.along, own.squared)
    }
}
