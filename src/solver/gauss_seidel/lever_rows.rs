//! From rows to levers: arms and masses of the contacts of a block, and the bounds of their operators.

use super::batch::{Batch, Vector};
use super::dispatch::{Precision, Task};
use super::lanes::{Lanes, Pack, Real, Sixteen};
use super::levers::{Levers, Symmetric, alike, symmetric};
use super::local::{dot, vector};
use crate::problem::{CONSTANTS, ELEMENTS, GROUND, Problem, Row, bounds};
use crate::solver::params::Registers;
use nalgebra::Matrix3;

/// Elements of `matrix` into lane `lane`.
fn set(elements: &mut Symmetric<f64>, lane: usize, matrix: &Matrix3<f64>) {
    for (lanes, element) in elements.iter_mut().zip(ELEMENTS) {
        lanes[lane] = matrix[element];
    }
}

impl Levers<f64> {
    /// Makes empty ones those of the contacts that are `rows` of `problem`, where `resistance` gives the row of each
    /// one's; spins of bodies are scaled by `length` \[m\].
    pub(super) fn fill(
        &mut self,
        problem: &Problem,
        rows: &[u32],
        resistance: impl Fn(u32) -> Option<Row>,
        length: impl Fn(usize) -> f64,
        registers: Registers,
    ) {
        let mut contacts = Operators {
            levers: self,
            normal: Vector::default(),
            resisted: false,
            couple: Default::default(),
        };
        for (lane, &k) in rows.iter().enumerate() {
            let row = problem.rows.get(k as usize);
            for (lanes, x) in contacts.normal.iter_mut().zip(&row.normal) {
                lanes[lane] = *x;
            }
            let couple = resistance(k).map(|row| row.radius);
            for (side, (body, arm)) in [(row.a, row.arm_a), (row.b, row.arm_b)].iter().enumerate() {
                if *body == GROUND {
                    continue;
                }
                let (operator, length) = (problem.operator(*body), length(*body as usize));
                for (lanes, x) in contacts.levers.arms[side].iter_mut().zip(arm) {
                    lanes[lane] = x / length;
                }
                let turn = operator.angular * (length * length);
                set(&mut contacts.levers.turns[side], lane, &turn);
                set(&mut contacts.levers.masses[side], lane, &operator.linear);
                contacts.levers.directed |= alike(&operator.linear).is_none();
                if let Some(lever) = couple {
                    contacts.resisted = true;
                    contacts.couple[side][lane] = (lever / length).powi(2);
                }
            }
        }
        f64::with(registers, contacts);
    }

    /// With parts in place of a body that contacts of `block` share, if there is one; else as for [`Self::fill`].
    pub(super) fn split(
        &self,
        problem: &Problem,
        block: &Batch<impl Real>,
        rows: &[u32],
        resistance: impl Fn(u32) -> Option<Row>,
    ) -> Option<Self> {
        let (at, _) = self.shared?;
        let count = block.holding(at).count() as f64;
        let mut split = Self {
            shared: Some((at, 1.0 / count)),
            directed: true,
            ..*self
        };
        for (side, lane) in block.holding(at) {
            for elements in [&mut split.turns[side], &mut split.masses[side]] {
                elements.iter_mut().for_each(|lanes| lanes[lane] *= count);
            }
            let mut parts = [1.0; 2];
            parts[side] = count;
            let own = [
                Some(problem.rows.get(rows[lane] as usize)),
                resistance(rows[lane]),
            ];
            for (bounds, row) in split.bounds.iter_mut().zip(own) {
                if let Some(row) = row {
                    (bounds[0][lane], bounds[1][lane]) = problem.split_delassus(&row, parts);
                }
            }
        }
        Some(split)
    }
}

/// Contacts whose [`Levers::bounds`] are to be found from all else of their levers.
struct Operators<'a> {
    levers: &'a mut Levers<f64>,
    normal: Vector<f64>,
    /// Whether some have resistances, and squares of the levers of their couples over the lengths of bodies A and B.
    resisted: bool,
    couple: [Sixteen<f64>; 2],
}

impl Task for Operators<'_> {
    type Real = f64;
    type Output = ();

    #[inline(always)]
    fn with<L: Lanes<f64>>(self, l: L) {
        let (levers, zero) = (self.levers, l.splat(0.0));
        let mut constants = [zero; CONSTANTS.len()];
        for (own, constant) in constants.iter_mut().zip(CONSTANTS) {
            *own = l.splat(constant);
        }
        for pass in 0..L::PASSES {
            let n = vector(l, &self.normal, pass);
            let mut operator = [zero; 6];
            for side in 0..2 {
                // Of a unit impulse along each axis: the couple at the body, and the turn that it makes.
                let [x, y, z] = vector(l, &levers.arms[side], pass);
                let couples = [
                    [zero, z, zero - y],
                    [zero - z, zero, x],
                    [y, zero - x, zero],
                ];
                let mut turns = couples;
                for couple in &mut turns {
                    *couple = symmetric(l, pass, &levers.turns[side], *couple);
                }
                for (k, (i, j)) in ELEMENTS.into_iter().enumerate() {
                    let mass = l.load(&levers.masses[side][k], pass);
                    operator[k] = operator[k] + mass + dot(couples[i], turns[j]);
                }
            }
            let found = bounds(operator, n, constants);
            l.store(found.0, &mut levers.bounds[0][0], pass);
            l.store(found.1, &mut levers.bounds[0][1], pass);
            if self.resisted {
                let mut operator = [zero; 6];
                for side in 0..2 {
                    let share = l.load(&self.couple[side], pass);
                    for (own, turn) in operator.iter_mut().zip(&levers.turns[side]) {
                        *own = own.plus(l.load(turn, pass), share);
                    }
                }
                let found = bounds(operator, n, constants);
                l.store(found.0, &mut levers.bounds[1][0], pass);
                l.store(found.1, &mut levers.bounds[1][1], pass);
            }
        }
    }
}
