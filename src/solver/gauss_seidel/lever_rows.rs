//! From rows to levers: arms and masses of the contacts of a block, and the bounds of their operators.

use super::batch::{Batch, Vector};
use super::dispatch::{Precision, Task};
use super::lanes::{Lanes, Pack, Real, Sixteen};
use super::levers::{Levers, Symmetric, alike, loaded, product};
use super::local::{dot, vector};
use crate::problem::{CONSTANTS, ELEMENTS, GROUND, Problem, bounds};
use crate::solver::params::Registers;
use nalgebra::Matrix3;

/// Elements of `matrix` times `share` into lane `lane`.
fn set(elements: &mut Symmetric<f64>, lane: usize, matrix: &Matrix3<f64>, share: f64) {
    for (lanes, element) in elements.iter_mut().zip(ELEMENTS) {
        lanes[lane] = matrix[element] * share;
    }
}

/// What the bounds of contacts depend on beside their levers.
#[derive(Default)]
pub(super) struct Directions {
    normal: Vector<f64>,
    /// Whether some have resistances, and squares of the levers of their couples over the lengths of bodies A and B.
    resisted: bool,
    couple: [Sixteen<f64>; 2],
}

impl Levers<f64> {
    /// Makes empty ones those of the contacts that are `rows` of `problem`, where `lever` is that of the couple of each
    /// one's resistance \[m\]; spins of bodies are scaled by `length` \[m\]. Returns what their bounds also depend on.
    pub(super) fn fill(
        &mut self,
        problem: &Problem,
        rows: &[u32],
        lever: impl Fn(u32) -> Option<f64>,
        length: impl Fn(usize) -> f64,
        registers: Registers,
    ) -> Directions {
        let mut directions = Directions::default();
        for (lane, &k) in rows.iter().enumerate() {
            let couple = lever(k);
            let (normal, bodies) = problem.rows.with(k as usize, |row| {
                (row.normal, [(row.a, row.arm_a), (row.b, row.arm_b)])
            });
            for (lanes, x) in directions.normal.iter_mut().zip(&normal) {
                lanes[lane] = *x;
            }
            for (side, (body, arm)) in bodies.into_iter().enumerate() {
                if body == GROUND {
                    continue;
                }
                let length = length(body as usize);
                for (lanes, x) in self.arms[side].iter_mut().zip(&arm) {
                    lanes[lane] = x / length;
                }
                problem.with_operator(body, |operator| {
                    set(
                        &mut self.turns[side],
                        lane,
                        &operator.angular,
                        length * length,
                    );
                    set(&mut self.masses[side], lane, &operator.linear, 1.0);
                    self.directed |= alike(&operator.linear).is_none();
                });
                if let Some(lever) = couple {
                    directions.resisted = true;
                    directions.couple[side][lane] = (lever / length).powi(2);
                }
            }
        }
        self.find_bounds(&directions, registers);
        directions
    }

    fn find_bounds(&mut self, directions: &Directions, registers: Registers) {
        let levers = self;
        f64::with(registers, Operators { levers, directions });
    }

    /// With parts in place of a body that contacts of `block` share, if there is one; `directions` are those of [`Self::fill`].
    pub(super) fn split(
        &self,
        block: &Batch<impl Real>,
        directions: &Directions,
        registers: Registers,
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
        }
        split.find_bounds(directions, registers);
        Some(split)
    }
}

/// [`CONSTANTS`] in lanes.
#[inline(always)]
pub(super) fn constants<L: Lanes<f64>>(l: L) -> [L::Pack; CONSTANTS.len()] {
    let mut constants = [l.splat(0.0); CONSTANTS.len()];
    for (own, constant) in constants.iter_mut().zip(CONSTANTS) {
        *own = l.splat(constant);
    }
    constants
}

/// Elements of what impulses at `arm` move there by turning a body of the operator `turn`: `-[arm] K [arm]`.
#[inline(always)]
pub(super) fn by_turning<P: Pack>([x, y, z]: [P; 3], turn: [P; 6], zero: P) -> [P; 6] {
    // Of a unit impulse along each axis: the couple at the body, and the turn that it makes.
    let couples = [
        [zero, z, zero - y],
        [zero - z, zero, x],
        [y, zero - x, zero],
    ];
    let mut turns = couples;
    for couple in &mut turns {
        *couple = product(turn, *couple);
    }
    let mut found = [zero; 6];
    for (found, (i, j)) in found.iter_mut().zip(ELEMENTS) {
        *found = dot(couples[i], turns[j]);
    }
    found
}

/// Contacts whose [`Levers::bounds`] are to be found from all else of their levers.
struct Operators<'a> {
    levers: &'a mut Levers<f64>,
    directions: &'a Directions,
}

impl Task for Operators<'_> {
    type Real = f64;
    type Output = ();

    #[inline(always)]
    fn with<L: Lanes<f64>>(self, l: L) {
        let (levers, directions, zero) = (self.levers, self.directions, l.splat(0.0));
        let constants = constants(l);
        for pass in 0..L::PASSES {
            let n = vector(l, &directions.normal, pass);
            let mut operator = [zero; 6];
            for side in 0..2 {
                let arm = vector(l, &levers.arms[side], pass);
                let by_turning = by_turning(arm, loaded(l, pass, &levers.turns[side]), zero);
                for k in 0..6 {
                    let mass = l.load(&levers.masses[side][k], pass);
                    operator[k] = operator[k] + mass + by_turning[k];
                }
            }
            let found = bounds(operator, n, constants);
            l.store(found.0, &mut levers.bounds[0][0], pass);
            l.store(found.1, &mut levers.bounds[0][1], pass);
            if directions.resisted {
                let mut operator = [zero; 6];
                for side in 0..2 {
                    let share = l.load(&directions.couple[side], pass);
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
