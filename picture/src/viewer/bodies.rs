//! Boundaries as rigid bodies: their triangles once, and where each frame has them.
//!
//! Frames hold points. The displacement of a boundary is the rotation `Q` and the translation `s` with the least
//! `sum |c + s + Q (x_0 - c) - x|^2` over its points (Kabsch, Acta Cryst. A32, 1976, 922), `c` being their centroid in
//! the first frame.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use sphere_dda::Vec3;
use sphere_dda::nalgebra;

use super::error::ViewError;
use super::recording::{Moment, Surface};

/// Largest distance of a point from where the displacement puts it, over the size of the boundary: rounding to single
/// precision, also far from the origin, stays below.
const RIGID: f64 = 1e-3;

/// A boundary as the first frame has it.
#[derive(Debug)]
pub(super) struct Body {
    /// Index in the scene.
    pub(super) index: usize,
    /// Ranks of its points.
    points: Vec<u32>,
    /// Its triangles, over its own points.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Centroid \[m\].
    pub(super) centre: Vec3,
    /// Points from the centroid \[m\].
    pub(super) arms: Vec<Vec3>,
}

/// All boundaries of a recording.
#[derive(Debug, Default)]
pub(super) struct Bodies {
    pub(super) list: Vec<Body>,
    /// For each frame and boundary: translation \[m\], quaternion w, x, y, z.
    pub(super) motion: Vec<f32>,
    /// For each frame and boundary: force \[N\].
    pub(super) force: Vec<f32>,
}

impl Bodies {
    pub(super) fn new(surface: &Surface) -> Self {
        // As many as there are in the file, whatever their numbers: it may be damaged.
        let mut bodies = BTreeMap::new();
        let mut places: Vec<Option<u32>> = vec![None; surface.points.len()];
        for (triangle, &owner) in surface.triangles.iter().zip(&surface.owner) {
            let body: &mut Body = bodies.entry(owner).or_insert_with(|| Body::empty(owner));
            let corner = |point: u32| {
                *places[point as usize].get_or_insert_with(|| {
                    body.points.push(point);
                    body.points.len() as u32 - 1
                })
            };
            let own = triangle.map(corner);
            body.triangles.push(own);
        }
        let mut list: Vec<Body> = bodies.into_values().collect();
        for body in &mut list {
            let points = body.points.iter().map(|&p| surface.points[p as usize]);
            body.centre = points.clone().sum::<Vec3>() / body.points.len() as f64;
            body.arms = points.map(|x| x - body.centre).collect();
        }
        Self {
            list,
            ..Self::default()
        }
    }

    /// Adds where a frame has the boundaries.
    pub(super) fn push(&mut self, moment: &Moment) -> Result<(), ViewError> {
        let surface = &moment.surface;
        for body in &self.list {
            let all = surface.points.len();
            if body.points.iter().any(|&p| p as usize >= all) {
                return Err(self.refuse(moment, body, format!("of {all} points in all")));
            }
            let now = body.points.iter().map(|&p| surface.points[p as usize]);
            let (shift, turn, left) = body.displacement(now);
            let size = body.arms.iter().map(Vec3::norm).fold(0.0, f64::max);
            if left > RIGID * size {
                return Err(self.refuse(moment, body, format!("bent by {left:.1e} m")));
            }
            let numbers = [shift.x, shift.y, shift.z, turn.w, turn.i, turn.j, turn.k];
            self.motion.extend(numbers.map(|v| v as f32));
            let force = surface.force.get(&body.index).copied().unwrap_or_default();
            self.force.extend(<[f64; 3]>::from(force).map(|v| v as f32));
        }
        Ok(())
    }

    fn refuse(&self, moment: &Moment, body: &Body, found: String) -> ViewError {
        ViewError::Frame {
            time: moment.time,
            what: format!("boundary {}", body.index),
            found,
            expected: "the same shape as in the first frame".to_owned(),
        }
    }

    /// Forgets all frames.
    pub(super) fn restart(&mut self) {
        self.motion.clear();
        self.force.clear();
    }
}

impl Body {
    /// The boundary of this index, without triangles yet.
    fn empty(index: usize) -> Self {
        Self {
            index,
            points: Vec::new(),
            triangles: Vec::new(),
            centre: Vec3::zeros(),
            arms: Vec::new(),
        }
    }

    /// Translation \[m\], rotation, and the largest distance of a point from where they put it \[m\].
    fn displacement(
        &self,
        now: impl Iterator<Item = Vec3> + Clone,
    ) -> (Vec3, UnitQuaternion<f64>, f64) {
        let pairs = || self.arms.iter().zip(now.clone());
        let left = |shift: Vec3, turn: UnitQuaternion<f64>| {
            let distance = |(arm, x): (&Vec3, Vec3)| (self.centre + shift + turn * arm - x).norm();
            pairs().map(distance).fold(0.0, f64::max)
        };
        let size = self.arms.iter().map(Vec3::norm).fold(0.0, f64::max);
        let still = (Vec3::zeros(), UnitQuaternion::identity());
        let rest = left(still.0, still.1);
        if rest <= 1e-7 * size {
            return (still.0, still.1, rest);
        }
        let middle = now.clone().sum::<Vec3>() / self.arms.len() as f64;
        let covariance: Matrix3<f64> = pairs().map(|(arm, x)| (x - middle) * arm.transpose()).sum();
        let svd = covariance.svd(true, true);
        let (Some(mut u), Some(v)) = (svd.u, svd.v_t) else {
            return (still.0, still.1, rest);
        };
        if (u * v).determinant() < 0.0 {
            // The axis that matters least is turned: for flat boundaries it has no weight at all.
            let least = svd.singular_values.imin();
            let turned = -u.column(least);
            u.set_column(least, &turned);
        }
        let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(u * v));
        let shift = middle - self.centre;
        (shift, turn, left(shift, turn))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fault: the list was as long as the largest number of a boundary in the file: a damaged one took all memory.
    #[test]
    fn numbers_of_boundaries_take_no_memory() {
        let surface = Surface {
            points: vec![Vec3::zeros(), Vec3::x(), Vec3::y()],
            triangles: vec![[0, 1, 2]; 2],
            owner: vec![3, usize::MAX / 64],
            ..Surface::default()
        };
        let bodies = Bodies::new(&surface);
        let indices: Vec<usize> = bodies.list.iter().map(|body| body.index).collect();
        assert_eq!(indices, surface.owner);
    }
}
