//! Which bodies a kernel holds, and where: those that rows touch, in the order of the partition.
//!
//! All others move freely. Each part of the partition ends with a body that never moves; behind the parts are the bodies that are in none.

use std::ops::Range;

use super::partition::Partition;
use crate::problem::Problem;

/// Place of a body that no row touches.
const NOWHERE: u32 = u32::MAX;
/// What is at the place of a body that never moves.
const STILL: u32 = u32::MAX;

/// The places of bodies.
#[derive(Debug, Default)]
pub(super) struct Seats {
    /// Place of each body, `[N + M]`; [`NOWHERE`] without one.
    place: Vec<u32>,
    /// The body at each place; [`STILL`] where it never moves.
    body: Vec<u32>,
    /// First place of each part, and the end of the last.
    starts: Vec<u32>,
}

impl Seats {
    /// Gives places to the bodies of `problem` that rows touch.
    pub(super) fn assign(&mut self, layout: &Partition, problem: &Problem) {
        let (bodies, spheres) = (problem.free.len(), problem.inverse_mass.len());
        self.place.clear();
        self.place.resize(bodies, NOWHERE);
        for &body in problem.rows.all_bodies().as_flattened() {
            if let Some(place) = self.place.get_mut(body as usize) {
                *place = 0;
            }
        }
        // Bodies in the places of spheres that do not move by themselves.
        let seated = (spheres..bodies).filter_map(|i| Some((layout.seat(i, spheres)?.0, i)));
        let mut seated: Vec<(usize, usize)> = seated.collect();
        seated.sort_unstable();
        let mut seated = seated.into_iter().peekable();
        self.body.clear();
        self.starts.clear();
        for part in 0..layout.parts() {
            self.starts.push(self.body.len() as u32);
            for at in layout.part(part, spheres) {
                let own = seated.next_if(|seat| seat.0 == at);
                let body = own.map_or_else(|| layout.sphere(at), |(_, body)| body);
                self.sit(body);
            }
            self.body.push(STILL);
        }
        self.starts.push(self.body.len() as u32);
        for body in (spheres..bodies).filter(|&i| layout.seat(i, spheres).is_none()) {
            self.sit(body);
        }
    }

    /// Gives the next place to a body, if rows touch it.
    fn sit(&mut self, body: usize) {
        if self.place[body] != NOWHERE {
            self.place[body] = self.body.len() as u32;
            self.body.push(body as u32);
        }
    }

    /// How many places there are.
    pub(super) fn count(&self) -> usize {
        self.body.len()
    }

    /// Places of part `k`, the last that of a body that never moves.
    pub(super) fn part(&self, k: usize) -> Range<usize> {
        self.starts[k] as usize..self.starts[k + 1] as usize
    }

    /// The place of the body that never moves at the end of part `k`.
    pub(super) fn still(&self, k: usize) -> usize {
        self.starts[k + 1] as usize - 1
    }

    /// Places behind all parts.
    pub(super) fn behind(&self) -> Range<usize> {
        let parts = self.starts.last().map_or(0, |&end| end as usize);
        parts..self.count()
    }

    /// Place of each body, `[N + M]`; none at all for those that no row touches.
    pub(super) fn places(&self) -> &[u32] {
        &self.place
    }

    /// Place of body `i`, if rows touch it.
    #[inline]
    pub(super) fn of(&self, i: usize) -> Option<usize> {
        let place = self.place[i];
        (place != NOWHERE).then_some(place as usize)
    }

    /// The bodies at `places`; `None` for those that never move.
    pub(super) fn at(&self, places: Range<usize>) -> impl Iterator<Item = Option<usize>> {
        let bodies = self.body[places].iter();
        bodies.map(|&body| (body != STILL).then_some(body as usize))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vec3;
    use crate::parallel::Pool;
    use crate::problem::{GROUND, Law, Row};
    use crate::solver::Tolerance;
    use crate::solver::bodies::probe_row;
    use crate::solver::gauss_seidel::Kernel;
    use crate::solver::gauss_seidel::partition::SMALL;
    use crate::spatial::{SpatialOperator, SpatialVector};

    /// Spheres in a row in two parts, of which rows touch few; behind them a body of its own, one in the place of the last sphere,
    /// and one in the place of sphere 5 that no row touches.
    #[test]
    fn bodies_have_places_where_rows_touch_them() {
        let n = SMALL;
        let centres: Vec<Vec3> = (0..n).map(|i| Vec3::x() * i as f64).collect();
        let mut layout = Partition::default();
        let seats = [None, Some(n - 1), Some(5)];
        layout.arrange((&centres, 1.0), seats.into_iter(), &Pool::default());
        assert_eq!(layout.parts(), 2);
        let of_unit = SpatialVector {
            linear: Vec3::repeat(1.0),
            angular: Vec3::repeat(2.5),
        };
        let moves = |i: usize| SpatialVector {
            linear: Vec3::y() / (3.0 + i as f64),
            angular: Vec3::z() / (7.0 + i as f64),
        };
        let [own, last] = [n as u32, n as u32 + 1];
        let who = [
            [20, GROUND],
            [7, 3],
            [own, 12],
            [9, last],
            [n as u32 - 2, GROUND],
        ];
        let row = |[a, b]: [u32; 2]| Row {
            a,
            b,
            ..probe_row(Law::Contact { mu: 0.1 })
        };
        let problem = Problem {
            step: 1e-3,
            free: (0..n + 3).map(moves).collect(),
            inverse_mass: vec![of_unit; n],
            operators: vec![SpatialOperator::zero(); 3],
            rows: who.into_iter().map(row).collect(),
        };
        let mut seats = Seats::default();
        seats.assign(&layout, &problem);
        let held: Vec<_> = seats.at(0..seats.count()).collect();
        let [first, second] = [[3, 7, 9, 12, 20].map(Some), [None; 5]];
        let expected = [
            &first[..],
            &second[..1],
            &[Some(n - 2), Some(n + 1), None],
            &[Some(n)],
        ];
        assert_eq!(held, expected.concat());
        assert_eq!(
            [seats.part(0), seats.part(1), seats.behind()],
            [0..6, 6..9, 9..10]
        );
        assert_eq!([0, 1].map(|k| seats.still(k)), [5, 8]);
        let known = (0..n + 3).filter_map(|i| Some((i, seats.of(i)?)));
        assert!(known.clone().all(|(i, place)| held[place] == Some(i)));
        assert_eq!(known.count(), 8);
        // What no row touches moves freely, to the last bit.
        let mut kernel = Kernel::default();
        kernel.prepare(&centres, 1.0, [None, Some(n - 1), Some(5)].into_iter());
        kernel.compile(&problem, &Tolerance::default(), &[Vec3::zeros(); 5]);
        kernel.judge(&problem);
        let mut velocity = Vec::new();
        kernel.velocities_into(&problem, &mut velocity);
        assert!((0..n + 3).all(|i| velocity[i].linear == moves(i).linear));
        assert!((0..n + 3).all(|i| seats.of(i).is_some() || velocity[i] == moves(i)));
    }

    /// Rows know nothing of spheres behind those that they touch, not even their radius.
    #[test]
    fn spheres_behind_all_that_rows_touch_move_freely() {
        let free = |i: u32| SpatialVector {
            linear: Vec3::y() * f64::from(i),
            angular: Vec3::z(),
        };
        let of_unit = SpatialVector {
            linear: Vec3::repeat(1.0),
            angular: Vec3::repeat(2.5),
        };
        let problem = Problem {
            step: 1e-3,
            free: (0..3).map(free).collect(),
            inverse_mass: vec![of_unit; 3],
            operators: Vec::new(),
            rows: [probe_row(Law::Contact { mu: 0.1 })].into_iter().collect(),
        };
        let mut kernel = Kernel::default();
        kernel.compile(&problem, &Tolerance::default(), &[Vec3::zeros()]);
        kernel.judge(&problem);
        let mut velocity = Vec::new();
        kernel.velocities_into(&problem, &mut velocity);
        assert_eq!(velocity[1..], problem.free[1..]);
    }
}
