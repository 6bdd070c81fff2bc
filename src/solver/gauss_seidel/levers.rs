//! Contacts of bodies that are no spheres: arms across the normal, inertia of any kind.
//!
//! With `s = L w`, `L` being the length by which the spin of a body is scaled, a contact at `r_A`, `r_B` from its bodies has
//!
//! ```text
//! u   = v_A - v_B + s_A x a - s_B x b,    a = r_A/L_A, b = r_B/L_B          [m/s]
//! v_A += m_A dp,  v_B -= m_B dp                                             m: inverse mass [1/kg]
//! s_A += K_A (a x dp),  s_B -= K_B (b x dp),          K = L^2 J^-1          [1/kg]
//! ```
//!
//! A couple over the radius `R` turns them by `K_A (R/L_A) dp`, as a [resistance](super::resistance) does. Contacts and resistances
//! are solved with the bounds of their operators along the normal and across it ([`Problem::delassus`]).

use super::batch::{Batch, PLAIN, Vector};
use super::lanes::{Columns, Lanes, Pack, Real, Sixteen, changed};
use super::local::{Seen, cross, dot, each, vector};
use crate::problem::{GROUND, Problem, Row};

/// Those of a block, also of its contacts of spheres.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Levers<T> {
    /// `a` and `b` \[-\].
    pub(super) arms: [Vector<T>; 2],
    /// `K_A` and `K_B` \[1/kg\]: their elements xx, yy, zz, yz, zx, xy.
    pub(super) turns: [[Sixteen<T>; 6]; 2],
    /// `w_n` and `w_t` \[1/kg\] of the contacts.
    pub(super) scale: [Sixteen<T>; 2],
    /// Those of their resistances, zeros where there is none.
    pub(super) resistance_scale: [Sixteen<T>; 2],
}

impl Levers<f64> {
    /// Those of the contacts that are `rows` of `problem`, where `resistance` gives the row of each one's; spins of bodies are scaled
    /// by `length` \[m\].
    pub(super) fn of(
        problem: &Problem,
        rows: &[u32],
        resistance: impl Fn(u32) -> Option<Row>,
        length: impl Fn(usize) -> f64,
    ) -> Self {
        let mut levers = Self::default();
        for (lane, &k) in rows.iter().enumerate() {
            let row = problem.rows.get(k as usize);
            for (side, (body, arm)) in [(row.a, row.arm_a), (row.b, row.arm_b)].iter().enumerate() {
                if *body == GROUND {
                    continue;
                }
                let length = length(*body as usize);
                let turn = problem.operator(*body).angular * (length * length);
                for (lanes, x) in levers.arms[side].iter_mut().zip(arm) {
                    lanes[lane] = x / length;
                }
                let elements = [(0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)];
                for (lanes, element) in levers.turns[side].iter_mut().zip(elements) {
                    lanes[lane] = turn[element];
                }
            }
            let (normal, tangential) = problem.delassus(&row);
            (levers.scale[0][lane], levers.scale[1][lane]) = (normal, tangential);
            if let Some(resistance) = resistance(k) {
                let (twisting, rolling) = problem.delassus(&resistance);
                levers.resistance_scale[0][lane] = twisting;
                levers.resistance_scale[1][lane] = rolling;
            }
        }
        levers
    }

    /// In another precision, inverse masses times `share`.
    pub(super) fn of_share<T: Real>(&self, share: f64) -> Levers<T> {
        let scaled = |x: &Sixteen<f64>| changed(x, |x| T::of(x * share));
        let turned = |elements: &[Sixteen<f64>; 6]| std::array::from_fn(|k| scaled(&elements[k]));
        let both = |scale: &[Sixteen<f64>; 2]| [scaled(&scale[0]), scaled(&scale[1])];
        Levers {
            arms: [0, 1].map(|side| each(|k| changed(&self.arms[side][k], T::of))),
            turns: [turned(&self.turns[0]), turned(&self.turns[1])],
            scale: both(&self.scale),
            resistance_scale: both(&self.resistance_scale),
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
        for k in 0..3 {
            a[k] = a[k].plus(a[3], d[k]);
            b[k] = b[k].less(b[3], d[k]);
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
fn symmetric<T, L: Lanes<T>>(
    l: L,
    pass: usize,
    elements: &[Sixteen<T>; 6],
    x: [L::Pack; 3],
) -> [L::Pack; 3] {
    let [xx, yy, zz, yz, zx, xy] = elements;
    let (yz, zx, xy) = (l.load(yz, pass), l.load(zx, pass), l.load(xy, pass));
    [
        dot([l.load(xx, pass), xy, zx], x),
        dot([xy, l.load(yy, pass), yz], x),
        dot([zx, yz, l.load(zz, pass)], x),
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
}
