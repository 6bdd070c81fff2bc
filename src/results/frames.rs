//! Frames: the grids of spheres, contacts and boundaries at one time.
//!
//! | series | cells | arrays |
//! |---|---|---|
//! | spheres | vertex at the centre | over points: `radius` \[m\], `velocity` \[m/s\], `angular_velocity` \[rad/s\], `force` \[N\] and `torque` \[N m\] of all contacts, `orientation` (w, x, y, z), `id`, `material`, with clumps `clump` (-1: none), where some show their meshes `meshed` (1: its clump does) |
//! | contacts | line from centre 1 to centre 2 or to the closest point | over cells: `normal_force` \[N\], `force` on 1 \[N\], `torque` on 1 \[N m\] of rolling and twisting resistance where the scene has any, `hold` (1 by cohesion, 2 by a bond) where it has any, `overlap` \[m\], `slip` \[m/s\], `id1`, `id2`, `kind` |
//! | boundaries | triangles | over points: `velocity` \[m/s\]; over cells: `force` \[N\] on the whole boundary, `boundary` (index), and [`walls::FIELDS`] where a boundary has `wall_fields`, zero on all others |
//! | clumps | triangles of their meshes | over points: `velocity` \[m/s\]; over cells: `clump` |
//!
//! `kind` is 0 between spheres and 1 on a boundary, `id2` then being the boundary. Readers cannot take a file without
//! cells: a frame without contacts holds the centres, one vertex, zero force, ids and kind -1. Contacts listed are
//! those that carry a force or overlap; `slip` is the tangential relative speed at the contact with the reported
//! velocities.

use nalgebra::UnitQuaternion;

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::{Contact, Partner};
use crate::formats::vtu::{Array, Cell, Grid, Values};
use crate::geometry::Triangulation;
use crate::observe::loads::Loads;
use crate::observe::walls::{self, Interval};
use crate::observe::{BoundaryState, Observation};
use crate::scene::Scene;
use crate::spatial::cell::{HERE, Image};
use crate::spatial::extent::joined;
use crate::spatial::{SpatialVector, Twist, Wrench};

/// The series of a run, in the order they are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Series {
    /// One vertex per sphere.
    Spheres,
    /// One line per contact.
    Contacts,
    /// The boundaries' triangles.
    Boundaries,
    /// The triangles of clumps that show their meshes.
    Clumps,
}

impl Series {
    /// All series.
    pub const ALL: [Self; 4] = [
        Self::Spheres,
        Self::Contacts,
        Self::Boundaries,
        Self::Clumps,
    ];

    /// Stem of the file names.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Spheres => "spheres",
            Self::Contacts => "contacts",
            Self::Boundaries => "boundaries",
            Self::Clumps => "clumps",
        }
    }
}

/// The series that a scene has, in the order of [`Series::ALL`]: one without anything to show (no sphere, no boundary)
/// is left out in all frames.
pub(crate) fn series(scene: &Scene, surface: &Surface) -> Vec<Series> {
    let shown = |series: &Series| match series {
        Series::Spheres | Series::Contacts => !scene.particles.is_empty(),
        Series::Boundaries => !surface.triangles.is_empty(),
        Series::Clumps => shows_meshes(scene),
    };
    Series::ALL.into_iter().filter(shown).collect()
}

/// Whether some clumps show their meshes.
fn shows_meshes(scene: &Scene) -> bool {
    let mut clumps = scene.clumps.iter();
    clumps.any(|clump| clump.shape.surface.is_some())
}

/// Every grid of a frame.
#[must_use]
pub fn frame(state: &Observation, surface: &Surface) -> Vec<(Series, Grid)> {
    let grid = |of: Series| match of {
        Series::Spheres => (of, spheres(state)),
        Series::Contacts => (of, contacts(state)),
        Series::Boundaries => (of, surface.grid(state)),
        Series::Clumps => (of, clumps(state)),
    };
    let shown = series(state.scene, surface);
    shown.into_iter().map(grid).collect()
}

/// One vertex of the grid of spheres.
struct Vertex {
    position: Vec3,
    image: Image,
    orientation: UnitQuaternion<f64>,
    velocity: Twist,
    wrench: Wrench,
    radius: f64,
    id: i32,
    material: i32,
    clump: i32,
}

/// The spheres in the scene, by index. Where there is none, one vertex of radius 0 and id -1 at the origin stands
/// for them: readers refuse files without cells.
#[must_use]
pub fn spheres(state: &Observation) -> Grid {
    let (particles, cell) = (&state.scene.particles, &state.scene.cell);
    let loads = Loads::new(state, 0..particles.len()).spheres;
    let present = state.present().map(|i| Vertex {
        position: cell.wrapped(state.kinematics.position[i]),
        image: cell.image(state.kinematics.position[i]),
        orientation: state.kinematics.orientation[i],
        velocity: state.velocities.reported(i),
        wrench: loads[i].wrench,
        radius: particles.radius[i],
        id: i as i32,
        material: i32::from(particles.material[i]),
        clump: particles.clump(i).map_or(-1, |clump| clump as i32),
    });
    let mut rows: Vec<Vertex> = present.collect();
    if rows.is_empty() {
        rows.push(Vertex {
            position: Vec3::zeros(),
            image: HERE,
            orientation: UnitQuaternion::identity(),
            velocity: Twist::default(),
            wrench: Wrench::default(),
            radius: 0.0,
            id: -1,
            material: -1,
            clump: -1,
        });
    }
    let orientation = rows.iter().map(|row| row.orientation);
    let orientation = orientation.flat_map(|q| [q.w, q.i, q.j, q.k]);
    let mut grid = Grid {
        points: rows.iter().map(|row| row.position).collect(),
        cell: Cell::Vertex,
        connectivity: (0..rows.len() as u32).collect(),
        point_data: vec![
            Array::scalar("radius", "m", rows.iter().map(|row| row.radius)),
            Array::vector(
                "velocity",
                "m/s",
                rows.iter().map(|row| row.velocity.linear),
            ),
            Array::vector(
                "angular_velocity",
                "rad/s",
                rows.iter().map(|row| row.velocity.angular),
            ),
            Array::vector("force", "N", rows.iter().map(|row| row.wrench.force)),
            Array::vector("torque", "N m", rows.iter().map(|row| row.wrench.torque)),
            Array {
                name: "orientation",
                unit: "",
                components: 4,
                values: Values::Real(orientation.collect()),
            },
            Array::integer("id", rows.iter().map(|row| row.id)),
            Array::integer("material", rows.iter().map(|row| row.material)),
        ],
        cell_data: Vec::new(),
    };
    if !state.scene.clumps.is_empty() {
        let clumps = rows.iter().map(|row| row.clump);
        grid.point_data.push(Array::integer("clump", clumps));
        if shows_meshes(state.scene) {
            let clump = |row: &Vertex| state.scene.clumps.get(usize::try_from(row.clump).ok()?);
            let meshed = |row| clump(row).is_some_and(|clump| clump.shape.surface.is_some());
            let meshed = rows.iter().map(|row| i32::from(meshed(row)));
            grid.point_data.push(Array::integer("meshed", meshed));
        }
    }
    if !cell.is_open() {
        grid.point_data.push(Array {
            name: "image",
            unit: "",
            components: 3,
            values: Values::Integer(rows.iter().flat_map(|row| row.image).collect()),
        });
    }
    grid
}

/// The meshes of the clumps in the scene that show them. Where there is none, one vertex at the origin stands for them.
#[must_use]
pub fn clumps(state: &Observation) -> Grid {
    let (mut points, mut velocity) = (Vec::new(), Vec::new());
    let (mut triangles, mut owners) = (Vec::new(), Vec::new());
    for (c, clump) in (0..).zip(&state.scene.clumps) {
        let first = clump.members.start;
        let Some(surface) = &clump.shape.surface else {
            continue;
        };
        if !state.kinematics.present[first] {
            continue;
        }
        let (centre, rotation) = clump.place(state.kinematics);
        let place = state.scene.cell.wrapped(centre);
        let Twist { linear, angular } = state.velocities.reported(first);
        let moves = clump.of_member(rotation, &SpatialVector { linear, angular });
        let before = points.len() as u32;
        for point in &surface.mesh.points {
            let arm = rotation * (point * surface.scale);
            points.push(place + arm);
            velocity.push(moves.at(arm));
        }
        let own = surface.mesh.triangles.iter();
        triangles.extend(own.flatten().map(|corner| before + corner));
        owners.extend(std::iter::repeat_n(c, surface.mesh.triangles.len()));
    }
    let none = owners.is_empty();
    if none {
        (points, velocity) = (vec![Vec3::zeros()], vec![Vec3::zeros()]);
        (triangles, owners) = (vec![0], vec![-1]);
    }
    Grid {
        points,
        cell: if none { Cell::Vertex } else { Cell::Triangle },
        connectivity: triangles,
        point_data: vec![Array::vector("velocity", "m/s", velocity)],
        cell_data: vec![Array::integer("clump", owners)],
    }
}

/// The contacts that carry a force or overlap.
#[must_use]
pub fn contacts(state: &Observation) -> Grid {
    let cell = &state.scene.cell;
    let active: Vec<&Contact> = state.active_contacts().collect();
    if active.is_empty() {
        return Grid {
            // One point alone: others without a cell would show arbitrary values where cell data become point data.
            points: vec![spheres(state).points[0]],
            cell: Cell::Vertex,
            connectivity: vec![0],
            point_data: Vec::new(),
            cell_data: contact_data(state.scene, &[ContactRow::NONE]),
        };
    }
    let mut points = Vec::with_capacity(2 * active.len());
    let mut rows = Vec::with_capacity(active.len());
    for contact in active {
        let a = contact.key.sphere;
        let (id2, kind) = match contact.key.partner {
            Partner::Sphere { index, .. } => (index as i32, 0),
            Partner::Boundary { boundary, .. } => (i32::from(boundary), 1),
        };
        let [end, start] = state.branch(contact);
        let back = cell.shift(cell.image(start));
        points.push(start - back);
        points.push(end - back);
        rows.push(ContactRow {
            normal_force: contact.force.dot(&contact.normal),
            force: contact.force,
            torque: contact.torque,
            hold: match contact.hold {
                Hold::Loose => 0,
                Hold::Attached => 1,
                Hold::Bonded { .. } => 2,
            },
            overlap: (-contact.gap).max(0.0),
            slip: slip(state, contact),
            ids: [a as i32, id2, kind],
        });
    }
    Grid {
        connectivity: (0..points.len() as u32).collect(),
        points,
        cell: Cell::Line,
        point_data: Vec::new(),
        cell_data: contact_data(state.scene, &rows),
    }
}

/// One line of the grid of contacts.
struct ContactRow {
    normal_force: f64,
    force: Vec3,
    torque: Vec3,
    /// 1: by cohesion, 2: by a bond.
    hold: i32,
    overlap: f64,
    slip: f64,
    /// `id1`, `id2`, `kind`.
    ids: [i32; 3],
}

impl ContactRow {
    const NONE: Self = Self {
        normal_force: 0.0,
        force: Vec3::new(0.0, 0.0, 0.0),
        torque: Vec3::new(0.0, 0.0, 0.0),
        hold: 0,
        overlap: 0.0,
        slip: 0.0,
        ids: [-1, -1, -1],
    };
}

fn contact_data(scene: &Scene, rows: &[ContactRow]) -> Vec<Array> {
    let mut arrays = vec![
        Array::scalar("normal_force", "N", rows.iter().map(|row| row.normal_force)),
        Array::vector("force", "N", rows.iter().map(|row| row.force)),
    ];
    if scene.pairs.resists() {
        arrays.push(Array::vector(
            "torque",
            "N m",
            rows.iter().map(|row| row.torque),
        ));
    }
    if scene.pairs.coheres() {
        arrays.push(Array::integer("hold", rows.iter().map(|row| row.hold)));
    }
    arrays.extend([
        Array::scalar("overlap", "m", rows.iter().map(|row| row.overlap)),
        Array::scalar("slip", "m/s", rows.iter().map(|row| row.slip)),
        Array::integer("id1", rows.iter().map(|row| row.ids[0])),
        Array::integer("id2", rows.iter().map(|row| row.ids[1])),
        Array::integer("kind", rows.iter().map(|row| row.ids[2])),
    ]);
    arrays
}

/// Tangential relative speed at a contact \[m/s\].
fn slip(state: &Observation, contact: &Contact) -> f64 {
    let radius = &state.scene.particles.radius;
    let at = |twist: &Twist, arm: Vec3| twist.linear + twist.angular.cross(&arm);
    let a = contact.key.sphere as usize;
    let own = at(&state.velocities.reported(a), contact.normal * -radius[a]);
    let other = match contact.key.partner {
        Partner::Sphere { index, .. } => at(
            &state.velocities.reported(index as usize),
            contact.normal * radius[index as usize],
        ),
        Partner::Boundary { boundary, .. } => {
            let b = usize::from(boundary);
            let pivot = state.scene.boundaries[b].point_of_action;
            let body = &state.boundaries[b];
            body.velocity_at(contact.point, pivot) + body.surface_velocity
        }
    };
    let relative = own - other;
    (relative - contact.normal * relative.dot(&contact.normal)).norm()
}

impl BoundaryState {
    /// Velocity \[m/s\] of the boundary's material point now at `x` \[m\]; `point_of_action` \[m\] as in the scene.
    pub(crate) fn velocity_at(&self, x: Vec3, point_of_action: Vec3) -> Vec3 {
        let arm = x - (point_of_action + self.pose.translation);
        self.twist.linear + self.twist.angular.cross(&arm)
    }
}

/// The triangles of all boundaries, as in the scene; frames move them by the poses.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Surface {
    /// Points in scene coordinates \[m\], `[P]`.
    points: Vec<Vec3>,
    /// Boundary of each point, `[P]`.
    owner: Vec<u16>,
    /// `[T]`.
    triangles: Vec<[u32; 3]>,
}

/// The triangles of each boundary of `scene`, in scene coordinates \[m\]. Half-spaces are cut to a patch under the spheres'
/// initial placement and all bounded boundaries.
pub fn patches(scene: &Scene) -> impl Iterator<Item = Triangulation> {
    let extent = extent(scene);
    let boundaries = scene.boundaries.iter();
    boundaries.map(move |boundary| boundary.geometry.tessellate(extent))
}

impl Surface {
    /// The [`patches`] of `scene`.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut surface = Self::default();
        for (b, patch) in patches(scene).enumerate() {
            let first = surface.points.len() as u32;
            surface
                .owner
                .extend(std::iter::repeat_n(b as u16, patch.points.len()));
            surface.points.extend(patch.points);
            surface
                .triangles
                .extend(patch.triangles.iter().map(|t| t.map(|i| first + i)));
        }
        surface
    }

    /// The surface at the poses of `state`.
    pub(crate) fn grid(&self, state: &Observation) -> Grid {
        let pivot = |b: u16| state.scene.boundaries[usize::from(b)].point_of_action;
        let of = |b: u16| &state.boundaries[usize::from(b)];
        let points: Vec<Vec3> = self
            .points
            .iter()
            .zip(&self.owner)
            .map(|(x0, &b)| state.scene.boundaries[usize::from(b)].from_frame(&of(b).pose, *x0))
            .collect();
        let velocity: Vec<Vec3> = points
            .iter()
            .zip(&self.owner)
            .map(|(&x, &b)| of(b).velocity_at(x, pivot(b)))
            .collect();
        let owners = self.triangles.iter().map(|t| self.owner[t[0] as usize]);
        let mut cell_data = vec![
            Array::vector("force", "N", owners.clone().map(|b| of(b).wrench.force)),
            Array::integer("boundary", owners.clone().map(i32::from)),
        ];
        if !state.walls.list.is_empty() {
            cell_data.extend(wall_data(state, owners));
        }
        Grid {
            points,
            cell: Cell::Triangle,
            connectivity: self.triangles.iter().flatten().copied().collect(),
            point_data: vec![Array::vector("velocity", "m/s", velocity)],
            cell_data,
        }
    }
}

/// What triangles feel whose boundaries are `owners`; zero where a boundary has no `wall_fields`.
fn wall_data(state: &Observation, owners: impl Iterator<Item = u16>) -> Vec<Array> {
    let boundaries = 0..state.scene.boundaries.len();
    let walls = boundaries.map(|b| walls::readings(state, b, Interval::Frame).into_iter());
    let mut walls: Vec<_> = walls.collect();
    let triangles: Vec<_> = owners.map(|b| walls[usize::from(b)].next()).collect();
    let array = |field: &walls::Field| {
        let components = if field.is_vector() { 3 } else { 1 };
        let mut values = Vec::with_capacity(components * triangles.len());
        for triangle in &triangles {
            match triangle {
                Some(triangle) => field.read(triangle, &mut values),
                None => values.resize(values.len() + components, 0.0),
            }
        }
        Array {
            name: field.array,
            unit: field.unit,
            components,
            values: Values::Real(values),
        }
    };
    walls::FIELDS.iter().map(array).collect()
}

/// Box around the spheres as placed and the bounded boundaries \[m\].
fn extent(scene: &Scene) -> (Vec3, Vec3) {
    let spheres = scene
        .initial
        .position
        .iter()
        .zip(&scene.particles.radius)
        .map(|(c, r)| (c.add_scalar(-r), c.add_scalar(*r)));
    let boundaries = scene.boundaries.iter().filter_map(|b| b.geometry.bounds());
    let (min, max) = spheres
        .chain(boundaries)
        .reduce(joined)
        .unwrap_or((Vec3::repeat(-1.0), Vec3::repeat(1.0)));
    // Along periodic axes what is shown is the cell.
    let side = |found: Vec3, side: usize| {
        Vec3::from_fn(|k, _| scene.cell.faces(k).map_or(found[k], |faces| faces[side]))
    };
    (side(min, 0), side(max, 1))
}
