//! The periodic cell: what lies in it is repeated without end along one to three coordinate axes.
//!
//! ```text
//! x + k L        the copy of x in image k, k: three whole numbers, L = (L_x, L_y, L_z) the edges [m]
//! ```
//!
//! Positions in a state are never put back: a sphere that leaves through a face goes on outside, and its path stays smooth.
//! A contact of spheres i and j therefore says which copy of j sphere i touches, `x_j + k L`, and `k` stays the same for as
//! long as the contact lasts, wherever the two have gone. A pair may touch through several faces at once.
//!
//! What is bounded otherwise (boundaries with edges, regions, gates) lies in the cell once, and a sphere meets the copy
//! that is nearest to it. Half-spaces along a periodic axis are their own copies.

use serde::{Deserialize, Serialize};

use crate::Vec3;

/// Which copy of body B a contact is with: whole edges along x, y, z.
pub type Image = [i32; 3];

/// The body itself.
pub const HERE: Image = [0; 3];

/// A periodic cell.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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

    /// Edge \[m\] along an axis, if it is periodic.
    #[must_use]
    pub fn edge(&self, axis: usize) -> Option<f64> {
        Some(self.edge[axis]).filter(|edge| *edge > 0.0)
    }

    /// Lower and upper face \[m\] across an axis, if it is periodic.
    #[must_use]
    pub fn faces(&self, axis: usize) -> Option<[f64; 2]> {
        self.edge(axis).map(|edge| [self.low[axis], self.low[axis] + edge])
    }

    /// Displacement \[m\] of an image: `k L`.
    #[must_use]
    pub fn shift(&self, image: Image) -> Vec3 {
        Vec3::from(image.map(f64::from)).component_mul(&self.edge)
    }

    /// The image that a point \[m\] lies in, [`HERE`] for the cell itself.
    #[must_use]
    pub fn image(&self, x: Vec3) -> Image {
        self.count(x - self.low, f64::floor)
    }

    /// The copy of a point \[m\] in the cell.
    #[must_use]
    pub fn wrapped(&self, x: Vec3) -> Vec3 {
        x - self.shift(self.image(x))
    }

    /// The copy of a point \[m\] nearest to `to` \[m\].
    #[must_use]
    pub fn nearest(&self, x: Vec3, to: Vec3) -> Vec3 {
        x - self.shift(self.count(x - to, f64::round))
    }

    fn count(&self, arm: Vec3, round: impl Fn(f64) -> f64) -> Image {
        std::array::from_fn(|k| match self.edge(k) {
            Some(edge) => round(arm[k] / edge) as i32,
            None => 0,
        })
    }

    /// Displacements \[m\] of all copies of a point \[m\] that lie within `reach` \[m\] of a box, along every axis.
    pub fn copies(
        &self,
        x: Vec3,
        (min, max): (Vec3, Vec3),
        reach: f64,
    ) -> impl Iterator<Item = Image> + use<> {
        let range = |k: usize| match self.edge(k) {
            Some(edge) => {
                let first = ((min[k] - reach - x[k]) / edge).ceil() as i32;
                let last = ((max[k] + reach - x[k]) / edge).floor() as i32;
                first..=last
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
}
