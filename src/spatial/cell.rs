//! The periodic cell: what lies in it is repeated without end along one to three coordinate axes.
//!
//! ```text
//! x + k L        the copy of x in image k; k: three whole numbers, L = (L_x, L_y, L_z): edges [m]
//! ```
//!
//! Positions in a state are never put back: a sphere that leaves through a face goes on outside, and its path stays smooth.
//! A contact of spheres i and j therefore says which copy of j it is with, `x_j + k L`, and `k` stays the same for as long
//! as the contact lasts, wherever the two have gone. A pair may touch through several faces at once.
//!
//! What else is bounded (boundaries with edges, regions, gates) stands in the cell and has copies as well: a sphere touches the
//! one nearest to it. Half-spaces along a periodic axis are their own copies.
//!
//! Without periodic axes (the default) everything is its only copy.

use serde::{Deserialize, Serialize};

use crate::Vec3;

/// Which copy of body B a contact is with: whole edges along x, y, z.
pub type Image = [i32; 3];

/// The body itself.
pub const HERE: Image = [0; 3];

/// A periodic cell.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Cell {
    /// Lower corner \[m\]; 0 along axes that are not periodic.
    low: Vec3,
    /// Edges \[m\]; 0 along axes that are not periodic.
    edge: Vec3,
}

impl Cell {
    /// The cell between two coordinates \[m\], the second larger, along each axis that has them.
    #[must_use]
    pub fn new(axes: [Option<[f64; 2]>; 3]) -> Self {
        let range = axes.map(|range| range.unwrap_or([0.0; 2]));
        Self {
            low: Vec3::from(range.map(|[low, _]| low)),
            edge: Vec3::from(range.map(|[low, high]| high - low)),
        }
    }

    /// Whether no axis is periodic.
    pub(crate) fn is_open(&self) -> bool {
        self.edge == Vec3::zeros()
    }

    /// Lower and upper face \[m\] across an axis, if it is periodic.
    pub(crate) fn faces(&self, axis: usize) -> Option<[f64; 2]> {
        let [low, edge] = [self.low[axis], self.edge[axis]];
        (edge > 0.0).then_some([low, low + edge])
    }

    /// The smallest edge \[m\] of a periodic axis, if there is one.
    pub(crate) fn smallest_edge(&self) -> Option<f64> {
        let edges = self.edge.iter().copied().filter(|edge| *edge > 0.0);
        edges.reduce(f64::min)
    }

    /// The same cell with those axes alone that are `chosen`.
    pub(crate) fn along(&self, chosen: [bool; 3]) -> Self {
        let keep = Vec3::from(chosen.map(|is| if is { 1.0 } else { 0.0 }));
        Self {
            low: self.low.component_mul(&keep),
            edge: self.edge.component_mul(&keep),
        }
    }

    /// Displacement `k L` \[m\] of an image.
    pub(crate) fn shift(&self, image: Image) -> Vec3 {
        Vec3::from(image.map(f64::from)).component_mul(&self.edge)
    }

    /// The image that a point \[m\] lies in; [`HERE`] is the cell itself.
    pub(crate) fn image(&self, x: Vec3) -> Image {
        self.count(x - self.low, f64::floor)
    }

    /// The copy of a point \[m\] in the cell.
    pub(crate) fn wrapped(&self, x: Vec3) -> Vec3 {
        x - self.shift(self.image(x))
    }

    /// The copy of a point \[m\] nearest to `to` \[m\].
    pub(crate) fn nearest(&self, x: Vec3, to: Vec3) -> Vec3 {
        x - self.shift(self.count(x - to, f64::round))
    }

    /// Images of a point \[m\] whose copies lie within `reach` \[m\] of a box `(min, max)` \[m\] along every periodic axis.
    pub(crate) fn copies(
        &self,
        x: Vec3,
        (min, max): (Vec3, Vec3),
        reach: f64,
    ) -> impl Iterator<Item = Image> + use<> {
        let range = |k: usize| match self.faces(k) {
            Some([low, high]) => {
                let edges = |length: f64| length / (high - low);
                let first = edges(min[k] - reach - x[k]).ceil() as i32;
                first..=edges(max[k] + reach - x[k]).floor() as i32
            }
            None => 0..=0,
        };
        let [x, y, z] = [range(0), range(1), range(2)];
        z.flat_map(move |c| {
            let x = x.clone();
            y.clone()
                .flat_map(move |b| x.clone().map(move |a| [a, b, c]))
        })
    }

    /// Whole edges in an arm \[m\], rounded by the function given.
    fn count(&self, arm: Vec3, round: impl Fn(f64) -> f64) -> Image {
        std::array::from_fn(|k| match self.edge[k] > 0.0 {
            true => round(arm[k] / self.edge[k]) as i32,
            false => 0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn copies_are_whole_edges_apart(x in prop::array::uniform3(-9.0..9.0_f64), to in prop::array::uniform3(-9.0..9.0_f64)) {
            let (x, to) = (Vec3::from(x), Vec3::from(to));
            let cell = Cell::new([Some([-0.5, 1.5]), None, Some([0.2, 0.5])]);
            let inside = cell.wrapped(x);
            prop_assert!((-0.5..1.5).contains(&inside.x) && (0.2 - 1e-14..0.5 + 1e-14).contains(&inside.z));
            prop_assert!((inside + cell.shift(cell.image(x)) - x).norm() < 1e-14);
            let near = cell.nearest(x, to);
            prop_assert!((near - to).x.abs() <= 1.0 + 1e-14 && (near - to).z.abs() <= 0.15 + 1e-14);
            prop_assert_eq!(near.y, x.y);
            // Of all copies, those in the box, by trying many.
            let (min, max) = (Vec3::new(-3.0, 0.0, 0.0), Vec3::new(2.0, 0.0, 0.7));
            let found: Vec<Image> = cell.copies(x, (min, max), 0.1).collect();
            let mut expected = Vec::new();
            for c in -40..=40 {
                for a in -10..=10 {
                    let copy = x + cell.shift([a, 0, c]);
                    if (-3.1..=2.1).contains(&copy.x) && (-0.1..=0.8).contains(&copy.z) {
                        expected.push([a, 0, c]);
                    }
                }
            }
            prop_assert_eq!(found, expected);
        }
    }

    #[test]
    fn without_edges_everything_is_its_only_copy() {
        let (cell, x) = (Cell::default(), Vec3::new(3.0, -4.0, 1e9));
        assert!(cell.is_open());
        assert_eq!((cell.wrapped(x), cell.nearest(x, Vec3::zeros())), (x, x));
        let copies: Vec<Image> = cell
            .copies(x, (Vec3::zeros(), Vec3::zeros()), 0.0)
            .collect();
        assert_eq!(copies, [HERE]);
    }
}
