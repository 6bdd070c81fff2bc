//! Regions of space, from the file: not every one serves every use.

use std::sync::Arc;

use super::bodies::facets;
use super::checks::{accept, direction};
use super::document::Document;
use super::file;
use crate::Vec3;
use crate::geometry::Solid;
use crate::geometry::region::{Primitive, Region};

/// A region that spheres are taken out of: any.
pub(super) fn emptied(
    document: &mut Document<'_>,
    path: &str,
    given: &file::Region,
) -> Option<Region> {
    match given {
        file::Region::Box(cuboid) => boxed(document, path, "box", cuboid).map(Region::from),
        file::Region::Cylinder(tube) => cylinder(document, path, tube).map(Region::from),
        file::Region::Mesh(mesh) => {
            let path = format!("{path}.mesh");
            let facets = facets(document, &path, mesh)?;
            let solid = accept(document, &format!("{path}.file"), Solid::new(facets))?;
            Some(Region::Mesh(Arc::new(solid)))
        }
        file::Region::Beyond(plane) => {
            let normal = direction(document, &format!("{path}.beyond.normal"), plane.normal)?;
            let point = plane.point.into();
            Some(Region::Beyond { point, normal })
        }
        file::Region::Outside(cuboid) => match boxed(document, path, "outside", cuboid)? {
            Primitive::Box { min, max } => Some(Region::Outside { min, max }),
            Primitive::Cylinder { .. } => None,
        },
    }
}

/// A region that spheres are put into: a bounded one.
pub(super) fn filled(
    document: &mut Document<'_>,
    path: &str,
    given: &file::Region,
) -> Option<Region> {
    let found = match given {
        file::Region::Beyond(_) => "`beyond`",
        file::Region::Outside(_) => "`outside`",
        _ => return emptied(document, path, given),
    };
    document.refuse(path, found, "a bounded region: box, cylinder or mesh")
}

/// A region that is measured: one that sensors know the volumes of.
pub(super) fn measured(
    document: &mut Document<'_>,
    path: &str,
    given: &file::Region,
) -> Option<Primitive> {
    let found = match given {
        file::Region::Box(cuboid) => return boxed(document, path, "box", cuboid),
        file::Region::Cylinder(tube) => return cylinder(document, path, tube),
        file::Region::Mesh(_) => "`mesh`",
        file::Region::Beyond(_) => "`beyond`",
        file::Region::Outside(_) => "`outside`",
    };
    document.refuse(path, found, "`box` or `cylinder`")
}

fn boxed(
    document: &mut Document<'_>,
    path: &str,
    key: &str,
    cuboid: &file::Cuboid,
) -> Option<Primitive> {
    let (min, max) = (Vec3::from(cuboid.min), Vec3::from(cuboid.max));
    let proper = (0..3).all(|k| min[k] < max[k]);
    let found = format!("min {:?} and max {:?}", cuboid.min.0, cuboid.max.0);
    let expected = "min < max in every coordinate [m]";
    document
        .demand(proper, (path, key), found, expected)
        .then_some(Primitive::Box { min, max })
}

fn cylinder(document: &mut Document<'_>, path: &str, tube: &file::Tube) -> Option<Primitive> {
    let path = format!("{path}.cylinder");
    let axis = direction(document, &format!("{path}.axis"), tube.axis);
    let mut positive = |key: &str, value: f64| {
        let path = format!("{path}.{key}");
        document.positive(path, value, "a length > 0 [m]")
    };
    let proper = positive("radius", tube.radius) & positive("height", tube.height);
    let cylinder = Primitive::Cylinder {
        base: tube.base.into(),
        axis: axis?,
        radius: tube.radius,
        height: tube.height,
    };
    proper.then_some(cylinder)
}
