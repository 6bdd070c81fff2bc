//! Named rigid boundaries: faces with a material and a motion.

use nalgebra::Quaternion;
use serde::{Deserialize, Serialize};

use super::{Command, InputKind, Motion};
use crate::Vec3;
use crate::geometry::{ClosestPoint, Geometry};
use crate::spatial::Pose;
use crate::spatial::cell::Cell;

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
    /// The belt it is covered with; `None`: its surface moves with its shape.
    pub belt: Option<Belt>,
    /// Whether its triangles keep what they feel: [`crate::state::Wall`]. Half-spaces have none.
    pub wall_fields: bool,
}

/// A surface that runs along the shape of its boundary, as the belt of a conveyor does: contacts feel the part of the
/// velocity in their tangent plane, the shape stays.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Belt {
    /// Velocity \[m/s\] against the boundary, in the boundary's own axes.
    pub velocity: Vec3,
    /// Whether [`Command::surface_velocity`] stands in its place.
    pub input: bool,
}

impl Boundary {
    /// Where the world point `x` \[m\] lies in the boundary's own frame, when it is displaced by `pose`:
    /// `a + Q^T (x - a - s)`.
    pub(crate) fn to_frame(&self, pose: &Pose, x: Vec3) -> Vec3 {
        pose.inverse_apply(self.point_of_action, x)
    }

    /// The copy of the world point `x` \[m\] that is nearest to the boundary at `pose`. One without bounds is the same for
    /// all copies.
    pub(crate) fn copy_near(&self, cell: &Cell, pose: &Pose, x: Vec3) -> Vec3 {
        if cell.is_open() {
            return x;
        }
        let middle = |(min, max): (Vec3, Vec3)| self.from_frame(pose, (min + max) * 0.5);
        self.geometry
            .finite_bounds()
            .map_or(x, |bounds| cell.nearest(x, middle(bounds)))
    }

    /// Appends to `out` where the boundary at `pose` is within `reach` \[m\] of a sphere of `radius` \[m\] at the world point `x` \[m\],
    /// or of its copy nearest to the boundary; points \[m\] are in the boundary's own frame, normals in the world.
    pub(crate) fn closest_points(
        &self,
        (cell, pose): (&Cell, &Pose),
        (x, radius): (Vec3, f64),
        reach: f64,
        out: &mut Vec<ClosestPoint>,
    ) {
        let first = out.len();
        let centre = self.to_frame(pose, self.copy_near(cell, pose, x));
        self.geometry.closest_points(centre, radius, reach, out);
        for point in &mut out[first..] {
            point.normal = pose.rotation * point.normal;
        }
    }

    /// Where the point `x_0` \[m\] of the boundary's own frame lies in the world: `a + s + Q (x_0 - a)`.
    pub fn from_frame(&self, pose: &Pose, x_0: Vec3) -> Vec3 {
        pose.apply(self.point_of_action, x_0)
    }

    /// Velocity \[m/s\] of the surface against the shape when the boundary is displaced by `pose`, world axes; contacts
    /// take the part across their normal.
    pub(crate) fn surface_velocity(&self, pose: &Pose, command: &Command) -> Vec3 {
        match &self.belt {
            None => Vec3::zeros(),
            Some(belt) if belt.input => pose.rotation * command.surface_velocity,
            Some(belt) => pose.rotation * belt.velocity,
        }
    }

    /// The command that leaves everything as in the scene.
    #[must_use]
    pub fn rest(&self) -> Command {
        let (position, orientation) = match self.motion.input() {
            Some(InputKind::WorldPose { reference }) => (reference, Quaternion::identity()),
            _ => Default::default(),
        };
        Command {
            position,
            orientation,
            surface_velocity: self.belt.map_or_else(Vec3::zeros, |belt| belt.velocity),
            pressure: self.motion.pressure_input().unwrap_or_default(),
            ..Command::default()
        }
    }

    /// Whether a [`Command`] moves or presses the boundary or moves its surface.
    #[must_use]
    pub fn is_commanded(&self) -> bool {
        self.motion.input().is_some()
            || self.motion.pressure_input().is_some()
            || self.belt.is_some_and(|belt| belt.input)
    }
}
