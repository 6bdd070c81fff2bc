//! The part of a problem around rows that are not solved, with everything farther off held.
//!
//! Bodies that some number of contacts lead to from the rows in question take part; the bodies they touch keep their
//! present velocity (their inverse mass is zero in the part). What the part changes in their balance, the solver of the whole
//! has to settle.

use std::collections::BTreeMap;

use crate::Vec3;
use crate::problem::{GROUND, Law, Problem};
use crate::spatial::{SpatialOperator, SpatialVector};

/// A part of a problem.
pub(super) struct LocalProblem {
    /// The problem of the bodies that take part and, held, of those they touch.
    pub(super) problem: Problem,
    /// Rank of each of its rows in the whole problem, ascending.
    pub(super) rows: Vec<usize>,
    /// Whether nothing is held: a larger part would be no other.
    pub(super) closed: bool,
}

impl LocalProblem {
    /// The part of `problem` within `rings` contacts of the rows `seeds`; `impulses` give the velocities of what is held.
    pub(super) fn around(
        problem: &Problem,
        impulses: &[Vec3],
        seeds: impl Iterator<Item = usize>,
        rings: usize,
    ) -> Self {
        let bodies = |k: usize| {
            let bodies = problem.rows.bodies(k);
            bodies.into_iter().filter(|&body| body != GROUND)
        };
        let mut inside = vec![false; problem.free.len()];
        seeds
            .flat_map(bodies)
            .for_each(|body| inside[body as usize] = true);
        for _ in 0..rings {
            let before = inside.clone();
            for k in 0..problem.rows.len() {
                if bodies(k).any(|body| before[body as usize]) {
                    bodies(k).for_each(|body| inside[body as usize] = true);
                }
            }
        }
        let rows: Vec<usize> = (0..problem.rows.len())
            .filter(|&k| bodies(k).any(|body| inside[body as usize]))
            .collect();
        let velocity = problem.velocities(impulses);
        let mut part = Problem {
            step: problem.step,
            ..Problem::default()
        };
        let mut rank = BTreeMap::new();
        let spheres = problem.inverse_mass.len();
        // Spheres come before the other bodies, as in the whole.
        for other in [false, true] {
            let of_kind = rows.iter().flat_map(|&k| bodies(k));
            for body in of_kind.filter(|&body| (body as usize >= spheres) == other) {
                rank.entry(body).or_insert_with(|| {
                    let i = body as usize;
                    part.free.push(if inside[i] {
                        problem.free[i]
                    } else {
                        velocity[i]
                    });
                    match (other, inside[i]) {
                        (false, true) => part.inverse_mass.push(problem.inverse_mass[i]),
                        (false, false) => part.inverse_mass.push(SpatialVector::ZERO),
                        (true, true) => part.operators.push(problem.operators[i - spheres]),
                        (true, false) => part.operators.push(SpatialOperator::zero()),
                    }
                    part.free.len() as u32 - 1
                });
            }
        }
        let own = |&k: &usize| {
            let mut row = problem.rows.get(k);
            row.a = rank[&row.a];
            if row.b != GROUND {
                row.b = rank[&row.b];
            }
            if let Law::Resistance { contact, .. } = &mut row.law {
                // It has its contact's bodies, so both take part.
                *contact = rows.partition_point(|&k| k < *contact as usize) as u32;
            }
            row
        };
        part.rows = rows.iter().map(own).collect();
        Self {
            problem: part,
            closed: rows
                .iter()
                .all(|&k| bodies(k).all(|body| inside[body as usize])),
            rows,
        }
    }
}
