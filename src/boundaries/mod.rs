//! Boundaries: named rigid bodies made of faces, and the closest-point queries on them.
//!
//! For a sphere of centre `c` and radius `R` the closest point `P0` on a face, edge or vertex gives the
//! normal `n = (c - P0)/|c - P0|` and the gap `g = |c - P0| - R` (paper eqs 9-10, section IV).

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::motion::Motion;

/// One place where a sphere may touch a boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Stable number of the feature inside its boundary; coplanar facets that share an edge share it.
    pub feature: u32,
    /// Closest point `P0` \[m\].
    pub point: Vec3,
    /// Unit normal, from the boundary to the sphere.
    pub normal: Vec3,
    /// Distance of the centre along `normal` minus the radius \[m\]; negative: overlap.
    pub gap: f64,
    /// Largest principal curvature of the surface on which the centre moves while the gap stays constant
    /// \[1/m\]: 0 on a plane, `1/|c - P0|` at an edge or vertex, `1/(R_b - R)` inside a cylinder.
    pub curvature: f64,
}

/// A named rigid boundary.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Boundary {
    /// Name, unique in the scene.
    pub name: String,
    /// Index into the scene's materials.
    pub material: u16,
    /// Its faces, in scene coordinates.
    pub geometry: Geometry,
    /// How it moves.
    pub motion: Motion,
    /// Point of action `a` \[m\], scene coordinates: centre of rotation, reference of the torque.
    pub point_of_action: Vec3,
    /// Contact stiffness `k` \[N/m\]; `None` is rigid.
    pub stiffness: Option<f64>,
}

/// The faces of a boundary in its own frame (the scene's at t = 0).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Geometry {
    /// stand-in
    pub planes: Vec<(Vec3, Vec3)>,
}

impl Boundary {
    /// frame
    pub fn to_frame(&self, pose: &crate::motion::Pose, x: Vec3) -> Vec3 {
        self.point_of_action
            + pose.rotation.inverse() * (x - self.point_of_action - pose.translation)
    }
    /// world
    pub fn from_frame(&self, pose: &crate::motion::Pose, x: Vec3) -> Vec3 {
        self.point_of_action + pose.translation + pose.rotation * (x - self.point_of_action)
    }
}

impl Geometry {
    /// Appends every distinct place
    pub fn touches(&self, centre: Vec3, radius: f64, reach: f64, out: &mut Vec<Touch>) {
        for k in 0..self.planes.len() {
            let t = self.follow(k as u32, Vec3::z(), centre, radius);
            if t.gap <= reach {
                out.push(t);
            }
        }
    }

    /// Follows one feature
    #[must_use]
    pub fn follow(&self, feature: u32, _normal: Vec3, centre: Vec3, radius: f64) -> Touch {
        let (p, n) = self.planes[feature as usize];
        let d = n.dot(&(centre - p));
        Touch { feature, point: centre - n * d, normal: n, gap: d - radius, curvature: 0.0 }
    }
}
