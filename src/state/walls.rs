//! What the triangles of boundaries with `wall_fields` have felt.

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::communication_points::due;
use crate::contact::ContactForce;
use crate::scene::{Boundary, Scene};

/// A part of the contact forces on a boundary \[N\], or their impulse \[N s\].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct WallLoad {
    /// Sum of the normal forces of the contacts, a positive number each.
    pub normal: f64,
    /// Sum of what acts across their normals, world axes.
    pub shear: Vec3,
    /// Sum of the forces, world axes.
    pub force: Vec3,
}

impl WallLoad {
    /// What a contact does to its boundary.
    pub(crate) fn of(load: &ContactForce) -> Self {
        let normal = load.force.dot(&load.normal);
        Self {
            normal,
            shear: load.normal * normal - load.force,
            force: -load.force,
        }
    }

    /// Adds `share` of `other`.
    pub(crate) fn add(&mut self, other: &Self, share: f64) {
        self.normal += other.normal * share;
        self.shear += other.shear * share;
        self.force += other.force * share;
    }
}

/// Of one triangle.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct TriangleSums {
    /// Impulses \[N s\] since [`Walls::starts`].
    pub impulse: [WallLoad; 2],
    /// Energy lost by friction since t = 0, resistance to rolling and twisting included \[J\].
    pub friction: f64,
    /// Energy lost along the normals of impacts and in dampers since t = 0 \[J\].
    pub impact: f64,
    /// Volume worn off since t = 0 \[m^3\]: `k F_n s` of all contacts.
    pub wear: f64,
}

/// Loads of some triangles \[N\], by number.
pub(crate) type TriangleLoads = Vec<(u32, WallLoad)>;

/// Of one boundary.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Wall {
    /// By the triangles of [`crate::geometry::Geometry::tessellate`], `[T]`; empty without `wall_fields`.
    pub triangles: Vec<TriangleSums>,
    /// Of the last internal step, as [`super::State::wrenches`]; and by contacts that were no impacts, as
    /// [`super::State::smooth_wrenches`].
    pub(crate) loads: TriangleLoads,
    pub(crate) smooth: TriangleLoads,
}

impl Wall {
    /// Whether it keeps anything.
    pub(crate) fn is_kept(&self) -> bool {
        !self.triangles.is_empty()
    }

    /// Adds `time` \[s\] of `loads` to the impulses.
    pub(crate) fn press(triangles: &mut [TriangleSums], loads: &[(u32, WallLoad)], time: f64) {
        for (triangle, load) in loads {
            for impulse in &mut triangles[*triangle as usize].impulse {
                impulse.add(load, time);
            }
        }
    }

    fn fits(&self, boundary: &Boundary) -> bool {
        let count = kept_triangles(boundary);
        let known = |loads: &TriangleLoads| loads.iter().all(|(t, _)| (*t as usize) < count);
        self.triangles.len() == count && known(&self.loads) && known(&self.smooth)
    }
}

/// Of all boundaries.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Walls {
    /// Since when the two kinds of impulses are summed up \[s\]: the begin of the last communication step, and that of the interval
    /// of frames, `vtu_interval`, in which it ended.
    pub starts: [f64; 2],
    /// `[B]`; empty where no boundary keeps anything.
    pub list: Vec<Wall>,
}

impl Walls {
    /// Before the first step.
    pub(crate) fn of(scene: &Scene) -> Self {
        let any = scene.boundaries.iter().any(|boundary| boundary.wall_fields);
        let wall = |boundary: &Boundary| Wall {
            triangles: vec![TriangleSums::default(); kept_triangles(boundary)],
            ..Wall::default()
        };
        let walls = scene.boundaries.iter().filter(|_| any).map(wall);
        Self {
            starts: [0.0; 2],
            list: walls.collect(),
        }
    }

    /// Begins the impulses of a communication step at time `t` \[s\] anew, and those of an interval of frames where one has ended.
    pub(crate) fn begin(&mut self, t: f64, frames: f64) {
        let [step, frame] = self.starts;
        for (kind, since) in [(0, step < t), (1, due(t, frames, Some(frame)))] {
            if !since {
                continue;
            }
            self.starts[kind] = t;
            let triangles = self.list.iter_mut().flat_map(|wall| &mut wall.triangles);
            triangles.for_each(|sums| sums.impulse[kind] = WallLoad::default());
        }
    }

    /// Adds `time` \[s\] of the loads of the last internal step.
    pub(crate) fn stand(&mut self, time: f64) {
        for wall in &mut self.list {
            Wall::press(&mut wall.triangles, &wall.loads, time);
        }
    }

    pub(crate) fn fits(&self, scene: &Scene) -> bool {
        let any = scene.boundaries.iter().any(|boundary| boundary.wall_fields);
        let boundaries = if any { &scene.boundaries[..] } else { &[] };
        let mut pairs = self.list.iter().zip(boundaries);
        self.list.len() == boundaries.len() && pairs.all(|(wall, boundary)| wall.fits(boundary))
    }
}

/// Triangles of a boundary that keep what they feel.
fn kept_triangles(boundary: &Boundary) -> usize {
    match boundary.wall_fields {
        true => boundary.geometry.triangles(),
        false => 0,
    }
}
