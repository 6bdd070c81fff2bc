//! From rows to contacts on heavy bodies: arms, and the bounds of their operators.

use super::batch::Vector;
use super::dispatch::{Precision, Task};
use super::heavy::Heavy;
use super::lanes::{Lanes, Pack, Sixteen};
use super::lever_rows::{by_turning, constants};
use super::levers::Bounds;
use super::local::vector;
use crate::problem::{ELEMENTS, Problem, bounds};
use crate::solver::params::Registers;

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
        let (constants, mut body_turn) = (constants(l), [zero; 6]);
        for (own, element) in body_turn.iter_mut().zip(heavy.turn) {
            *own = l.splat(element);
        }
        let mut found = [Bounds::default(); 2];
        for pass in 0..L::PASSES {
            let n = vector(l, &spheres.normal, pass);
            let held = l.load(&spheres.held, pass);
            let (mass, turn) = (l.load(&spheres.mass, pass), l.load(&spheres.turn, pass));
            let by_turning = by_turning(vector(l, &heavy.arms, pass), body_turn, zero);
            let (mut of_a, mut of_b) = ([zero; 6], [zero; 6]);
            for (k, (i, j)) in ELEMENTS.into_iter().enumerate() {
                of_b[k] = held * (l.splat(heavy.mass[k]) + by_turning[k]);
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
