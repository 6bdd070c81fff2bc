//! What a variable stands for in the simulation.

use std::ops::Range;

use serde::Serialize;
use sphere_dda::observe::quantities::{WXYZ, XYZ};
use sphere_dda::scene::Command;

/// What a variable stands for: the getter, and for inputs and parameters the setter.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub enum Binding {
    /// Time at the last communication point \[s\].
    Time,
    /// A setting of the run: its rank in [`super::PARAMETERS`].
    Parameter(usize),
    /// A parameter of the scene: its rank in [`sphere_dda::scene::Scene::parameters`].
    SceneParameter(usize),
    /// A part of the command of a driven boundary.
    Input {
        /// Index of the boundary.
        boundary: usize,
        /// Which part of the command.
        input: Input,
    },
    /// A measured quantity: rank of its first component in [`sphere_dda::observe::quantities::values`].
    Output(usize),
    /// The same quantity of every boundary: the rank of each first component.
    Boundaries(Vec<usize>),
    /// A field of all spheres.
    Spheres(Field),
    /// All spheres as one binary.
    Document,
    /// A field of the loaded contacts.
    Contacts(ContactField),
    /// All loaded contacts as one binary.
    ContactsDocument,
    /// Forces applied at the centres of all spheres \[N\].
    AppliedForces,
    /// Corners of the triangles of a boundary.
    WallCorners(usize),
    /// What they feel.
    Wall {
        /// Index of the boundary.
        boundary: usize,
        /// Rank in [`sphere_dda::observe::walls::FIELDS`].
        field: usize,
    },
}

/// Parts of a [`Command`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Input {
    /// Total translation \[m\].
    Translation,
    /// Total rotation vector \[rad\].
    Rotation,
    /// Position \[m\] of the reference point.
    Position,
    /// Orientation, quaternion w, x, y, z.
    Orientation,
    /// Velocity \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\].
    AngularVelocity,
    /// Force \[N\] on a driven body.
    Force,
    /// Torque \[N m\] on a driven body.
    Torque,
    /// Displacement, speed, angle, angular speed, force or torque of a slide or hinge.
    Scalar,
    /// Velocity of the surface against the boundary \[m/s\].
    SurfaceVelocity,
    /// Pressure of a servo wall \[Pa\].
    Pressure,
}

impl Input {
    /// A component of this part, from 0.
    #[must_use]
    pub fn of(self, command: &mut Command, component: usize) -> &mut f64 {
        match self {
            Self::Translation => &mut command.translation[component],
            Self::Rotation => &mut command.rotation[component],
            Self::Position => &mut command.position[component],
            // nalgebra has the scalar part last.
            Self::Orientation => &mut command.orientation.coords[(component + 3) % 4],
            Self::Velocity => &mut command.velocity[component],
            Self::AngularVelocity => &mut command.angular_velocity[component],
            Self::Force => &mut command.force[component],
            Self::Torque => &mut command.torque[component],
            Self::Scalar => &mut command.scalar,
            Self::Pressure => &mut command.pressure,
            Self::SurfaceVelocity => &mut command.surface_velocity[component],
        }
    }

    pub(super) fn components(self) -> &'static [&'static str] {
        match self {
            Self::Scalar | Self::Pressure => &[],
            Self::Orientation => WXYZ,
            _ => XYZ,
        }
    }
}

/// What is known of every sphere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Field {
    /// Row, from 0.
    Id,
    /// Whether it is in the scene.
    Present,
    /// Radius \[m\].
    Radius,
    /// Centre \[m\].
    Position,
    /// Orientation, unit quaternion w, x, y, z.
    Orientation,
    /// Velocity of the centre \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\], world axes.
    AngularVelocity,
}

impl Field {
    /// Where it stands among the numbers of a sphere's motion: position, orientation, velocity, angular velocity.
    #[must_use]
    pub fn columns(self) -> Option<Range<usize>> {
        match self {
            Self::Id | Self::Present | Self::Radius => None,
            Self::Position => Some(0..3),
            Self::Orientation => Some(3..7),
            Self::Velocity => Some(7..10),
            Self::AngularVelocity => Some(10..13),
        }
    }
}

/// What is known of every loaded contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum ContactField {
    /// Row of sphere A; row of sphere B, or -1 - index of the boundary.
    Bodies,
    /// Closest point on B \[m\].
    Position,
    /// Unit normal from B to A.
    Normal,
    /// Force on A \[N\].
    Force,
    /// Couple of resistances on A \[N m\].
    Torque,
    /// Gap \[m\].
    Gap,
}

impl ContactField {
    /// Where it stands among the 13 real numbers of a contact: position, normal, force, torque, gap.
    #[must_use]
    pub fn columns(self) -> Option<Range<usize>> {
        match self {
            Self::Bodies => None,
            Self::Position => Some(0..3),
            Self::Normal => Some(3..6),
            Self::Force => Some(6..9),
            Self::Torque => Some(9..12),
            Self::Gap => Some(12..13),
        }
    }
}
