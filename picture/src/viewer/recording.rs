//! What is to be shown: the frames of a folder, or the one of a scene before it has run.

use std::collections::BTreeMap;

use sphere_dda::Vec3;
use sphere_dda::formats::vtu::{Contents, Field};
use sphere_dda::observe::walls::is_array;
use sphere_dda::results::folder::{Folder, Frame};

use super::error::ViewError;

/// Frames by index.
#[derive(Debug)]
pub enum Recording {
    /// A result folder.
    Folder(Folder),
    /// One frame.
    Still(Box<Frame>),
}

impl Recording {
    /// Times \[s\] of the frames.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        match self {
            Self::Folder(folder) => folder.times(),
            Self::Still(frame) => std::slice::from_ref(&frame.time),
        }
    }

    /// Frames in the order of `indices`, each read while `take` has the one before.
    ///
    /// # Errors
    /// What cannot be read, or what `take` says; it ends all by `false`.
    pub(super) fn each(
        &self,
        indices: &[usize],
        mut take: impl FnMut(Moment) -> Result<bool, ViewError> + Send,
    ) -> Result<(), ViewError> {
        let mut next = indices
            .first()
            .map(|&index| self.frame(index))
            .transpose()?;
        let mut rest = indices.iter().skip(1);
        while let Some(moment) = next {
            let after = rest.next();
            let read = || after.map(|&index| self.frame(index)).transpose();
            let (goes_on, read) = rayon::join(|| take(moment), read);
            next = if goes_on? { read? } else { None };
        }
        Ok(())
    }

    pub(super) fn frame(&self, index: usize) -> Result<Moment, ViewError> {
        match self {
            Self::Folder(folder) => Moment::of(folder.frame(index)?),
            Self::Still(frame) => Moment::of((**frame).clone()),
        }
    }
}

/// Arrays over spheres that the page has in another form.
const OWN: [&str; 4] = ["id", "radius", "material", "image"];

/// A frame with its arrays by their meaning.
pub(super) struct Moment {
    pub(super) time: f64,
    pub(super) spheres: Spheres,
    pub(super) contacts: Vec<Contact>,
    pub(super) surface: Surface,
}

/// The spheres of a frame, `[N]` each.
#[derive(Default)]
pub(super) struct Spheres {
    pub(super) id: Vec<i64>,
    pub(super) material: Vec<i64>,
    pub(super) radius: Vec<f64>,
    pub(super) position: Vec<Vec3>,
    /// Whole edges of the periodic cell, in scenes that have one.
    pub(super) image: Option<Vec<[f64; 3]>>,
    pub(super) fields: Vec<Field>,
}

/// A contact of a frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    /// Ids of its sphere and of its partner, a sphere or a boundary.
    pub(super) ids: [i64; 2],
    pub(super) with_boundary: bool,
    /// From centre 1 to centre 2 or to the closest point \[m\].
    pub(super) branch: Vec3,
    /// Normal force \[N\].
    pub(super) force: f64,
}

/// The boundaries of a frame.
#[derive(Default)]
pub(super) struct Surface {
    pub(super) points: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Boundary of each triangle.
    pub(super) owner: Vec<usize>,
    /// Force \[N\] on the whole boundary, by boundary.
    pub(super) force: BTreeMap<usize, Vec3>,
    /// What the triangles feel, if any keep it.
    pub(super) felt: Vec<Field>,
}

/// Refuses what no run writes.
fn refuse(time: f64, what: &str, found: impl ToString, expected: &str) -> ViewError {
    ViewError::Frame {
        time,
        what: what.to_owned(),
        found: found.to_string(),
        expected: expected.to_owned(),
    }
}

/// The array `name` with `components` numbers each.
fn array<'a>(
    fields: &'a [Field],
    name: &str,
    components: usize,
    time: f64,
) -> Result<&'a [f64], ViewError> {
    let what = format!("array `{name}`");
    match fields.iter().find(|field| field.name == name) {
        Some(field) if field.components == components => Ok(&field.values),
        Some(field) => Err(refuse(
            time,
            &what,
            format!("of {} components", field.components),
            &components.to_string(),
        )),
        None => Err(refuse(time, &what, "missing", "an array")),
    }
}

impl Moment {
    fn of(frame: Frame) -> Result<Self, ViewError> {
        let time = frame.time;
        let spheres = frame.spheres.map(|grid| Spheres::of(grid, time));
        let contacts = frame.contacts.map(|grid| contacts(&grid, time));
        let surface = frame.boundaries.map(|grid| Surface::of(&grid, time));
        Ok(Self {
            time,
            spheres: spheres.transpose()?.unwrap_or_default(),
            contacts: contacts.transpose()?.unwrap_or_default(),
            surface: surface.transpose()?.unwrap_or_default(),
        })
    }
}

impl Spheres {
    fn of(grid: Contents, time: f64) -> Result<Self, ViewError> {
        let data = &grid.point_data;
        let whole = |name| -> Result<Vec<i64>, ViewError> {
            Ok(array(data, name, 1, time)?
                .iter()
                .map(|&v| v as i64)
                .collect())
        };
        let (id, material) = (whole("id")?, whole("material")?);
        let radius = array(data, "radius", 1, time)?.to_vec();
        if id.iter().any(|&id| id < 0) {
            // What stands in a frame without spheres.
            let fields = data.iter().filter(|field| !OWN.contains(&&*field.name));
            let none = |field: &Field| Field {
                values: Vec::new(),
                ..field.clone()
            };
            return Ok(Self {
                fields: fields.map(none).collect(),
                ..Self::default()
            });
        }
        let image = data.iter().find(|field| field.name == "image");
        let image = image.map(|field| field.values.as_chunks::<3>().0.to_vec());
        let fields = grid.point_data;
        Ok(Self {
            id,
            material,
            radius,
            position: grid.points,
            image,
            fields: fields
                .into_iter()
                .filter(|field| !OWN.contains(&&*field.name))
                .collect(),
        })
    }
}

fn contacts(grid: &Contents, time: f64) -> Result<Vec<Contact>, ViewError> {
    let data = &grid.cell_data;
    let [id1, id2, kind] = [
        array(data, "id1", 1, time)?,
        array(data, "id2", 1, time)?,
        array(data, "kind", 1, time)?,
    ];
    let force = array(data, "normal_force", 1, time)?;
    if kind.iter().any(|&kind| kind < 0.0) {
        return Ok(Vec::new());
    }
    let ends = grid.connectivity.as_chunks::<2>().0;
    if ends.len() != id1.len() {
        let found = format!("{} lines", ends.len());
        return Err(refuse(
            time,
            "the grid of contacts",
            found,
            "a line for each contact",
        ));
    }
    let contact = |(k, &[a, b]): (usize, &[u32; 2])| Contact {
        ids: [id1[k] as i64, id2[k] as i64],
        with_boundary: kind[k] > 0.0,
        branch: grid.points[b as usize] - grid.points[a as usize],
        force: force[k],
    };
    Ok(ends.iter().enumerate().map(contact).collect())
}

impl Surface {
    fn of(grid: &Contents, time: f64) -> Result<Self, ViewError> {
        let owner = array(&grid.cell_data, "boundary", 1, time)?;
        let owner: Vec<usize> = owner.iter().map(|&b| b as usize).collect();
        let force = array(&grid.cell_data, "force", 3, time)?.as_chunks::<3>().0;
        let triangles = grid.connectivity.as_chunks::<3>().0.to_vec();
        if triangles.len() != owner.len() {
            let found = format!("{} triangles", triangles.len());
            let expected = "one for each cell";
            return Err(refuse(time, "the grid of boundaries", found, expected));
        }
        let felt = grid.cell_data.iter();
        let felt = felt.filter(|field| is_array(&field.name));
        let force = owner.iter().zip(force);
        Ok(Self {
            points: grid.points.clone(),
            triangles,
            force: force.map(|(&b, &f)| (b, Vec3::from(f))).collect(),
            felt: felt.cloned().collect(),
            owner,
        })
    }
}
