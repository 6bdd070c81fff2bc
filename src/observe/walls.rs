//! What the triangles of a boundary feel: means of loads over an interval, energies and wear since the start.
//!
//! ```text
//! pressure p = sum of normal impulses / (A T)     shear t = sum of impulses across the normals / (A T)
//! traction   = sum of impulses / (A T)            wear depth = sum of k F_n s / A
//! ```
//!
//! with the area `A` of the triangle and the interval `T`. Normals are those of the contacts: on a face that of the triangle.
//! Areas times tractions add up to the force on the boundary, energies to what its contacts have lost.

use super::Observation;
use crate::Vec3;
use crate::state::{TriangleSums, WallLoad};

/// Over which interval loads are means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interval {
    /// The last communication step.
    Step,
    /// The time since the last frame.
    Frame,
}

/// What one triangle feels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Its area \[m^2\].
    pub area: f64,
    /// Mean loads \[N\].
    pub load: WallLoad,
    /// Energies and volume worn off since the start.
    pub sums: TriangleSums,
}

/// One quantity of all triangles of a boundary.
#[derive(Debug)]
pub struct Field {
    /// Name of a variable: `wall.BOUNDARY.NAME`.
    pub name: &'static str,
    /// Name of an array of a frame.
    pub array: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// One line for people.
    pub text: &'static str,
    value: Read,
}

#[derive(Debug)]
enum Read {
    Real(fn(&Reading) -> f64),
    Vector(fn(&Reading) -> Vec3),
}

impl Field {
    /// Whether it is a vector.
    #[must_use]
    pub fn is_vector(&self) -> bool {
        matches!(self.value, Read::Vector(_))
    }

    /// Appends the value of a triangle, or its components.
    pub fn read(&self, triangle: &Reading, list: &mut Vec<f64>) {
        match self.value {
            Read::Real(of) => list.push(of(triangle)),
            Read::Vector(of) => list.extend_from_slice(of(triangle).as_slice()),
        }
    }
}

/// All of them.
#[rustfmt::skip]
pub const FIELDS: [Field; 7] = [
    Field { name: "area", array: "area", unit: "m2", text: "Area of the triangle", value: Read::Real(|t| t.area) },
    Field { name: "pressure", array: "pressure", unit: "Pa", text: "Sum of the contacts' normal forces over the area, mean over the interval", value: Read::Real(|t| t.load.normal / t.area) },
    Field { name: "shear", array: "shear", unit: "Pa", text: "Contact forces across their normals over the area, mean over the interval, world axes", value: Read::Vector(|t| t.load.shear / t.area) },
    Field { name: "traction", array: "traction", unit: "Pa", text: "Contact forces over the area, mean over the interval, world axes", value: Read::Vector(|t| t.load.force / t.area) },
    Field { name: "frictionEnergy", array: "friction_energy", unit: "J", text: "Energy lost by sliding friction and by resistance to rolling and twisting since the start", value: Read::Real(|t| t.sums.friction) },
    Field { name: "impactEnergy", array: "impact_energy", unit: "J", text: "Energy lost along the normals of impacts since the start", value: Read::Real(|t| t.sums.impact) },
    Field { name: "wearDepth", array: "wear_depth", unit: "m", text: "Depth worn off since the start (Archard): volume over the area", value: Read::Real(|t| t.sums.wear / t.area) },
];

/// Whether an array of a frame is one of [`FIELDS`].
#[must_use]
pub fn is_array(name: &str) -> bool {
    FIELDS.iter().any(|field| field.array == name)
}

/// What the triangles of boundary `b` feel, `[T]`; empty unless it has `wall_fields`.
#[must_use]
pub fn readings(state: &Observation, b: usize, interval: Interval) -> Vec<Reading> {
    let Some(wall) = state.walls.list.get(b).filter(|wall| wall.is_kept()) else {
        return Vec::new();
    };
    let kind = interval as usize;
    let length = state.time - state.walls.starts[kind];
    let mut loads: Vec<WallLoad> = Vec::with_capacity(wall.triangles.len());
    for sums in &wall.triangles {
        let mut mean = WallLoad::default();
        if length > 0.0 {
            mean.add(&sums.impulse[kind], length.recip());
        }
        loads.push(mean);
    }
    // Before the first step: the forces at rest.
    if length == 0.0 {
        for (triangle, load) in &wall.loads {
            loads[*triangle as usize].add(load, 1.0);
        }
    }
    let areas = state.scene.boundaries[b].geometry.areas();
    let triangles = areas.zip(loads).zip(&wall.triangles);
    let reading = |((area, load), sums): ((f64, WallLoad), &TriangleSums)| Reading {
        area,
        load,
        sums: *sums,
    };
    triangles.map(reading).collect()
}

/// Corners of the triangles of boundary `b` as in the scene \[m\], `[T]`.
#[must_use]
pub fn corners(state: &Observation, b: usize) -> Vec<[Vec3; 3]> {
    state.scene.boundaries[b].geometry.corners()
}

/// Sums over the triangles of a boundary since the start.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Totals {
    /// Energy lost by friction \[J\].
    pub friction: f64,
    /// Energy lost in impacts \[J\].
    pub impact: f64,
    /// Volume worn off \[m^3\].
    pub wear: f64,
}

impl Totals {
    /// Of boundary `b`; zero unless it has `wall_fields`.
    #[must_use]
    pub fn of(state: &Observation, b: usize) -> Self {
        let wall = state.walls.list.get(b);
        let triangles = wall.into_iter().flat_map(|wall| &wall.triangles);
        triangles.fold(Self::default(), |sum, own| Self {
            friction: sum.friction + own.friction,
            impact: sum.impact + own.impact,
            wear: sum.wear + own.wear,
        })
    }
}
