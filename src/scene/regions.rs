//! Regions of space, from the file.

use super::build::direction;
use super::document::Document;
use super::file;
use crate::Vec3;
use crate::region::Region;

/// What a region is for: not every one serves everything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    /// Spheres are put into it.
    Filling,
    /// It is measured.
    Measuring,
    /// Spheres are taken out of it.
    Emptying,
}

/// The region given at `path`.
pub(super) fn region(
    document: &mut Document<'_>,
    path: &str,
    given: &file::Region,
    purpose: Use,
) -> Option<Region> {
    match given {
        file::Region::Box(cuboid) => {
            let (min, max) = (Vec3::from(cuboid.min), Vec3::from(cuboid.max));
            let proper = (0..3).all(|k| min[k] < max[k]);
            let found = format!("min {:?} and max {:?}", cuboid.min.0, cuboid.max.0);
            let expected = "min < max in every coordinate [m]";
            document
                .demand(proper, format!("{path}.box"), found, expected)
                .then_some(Region::Box { min, max })
        }
        file::Region::Cylinder(tube) => {
            let path = format!("{path}.cylinder");
            let axis = direction(document, &format!("{path}.axis"), tube.axis);
            let mut positive = |key: &str, value: f64| {
                document.demand(
                    value > 0.0,
                    format!("{path}.{key}"),
                    value,
                    "a length > 0 [m]",
                )
            };
            let proper = positive("radius", tube.radius) & positive("height", tube.height);
            proper.then_some(Region::Cylinder {
                base: tube.base.into(),
                axis: axis?,
                radius: tube.radius,
                height: tube.height,
            })
        }
        file::Region::Mesh(_) => {
            document.error(
                path,
                "regions of meshes are not read yet",
                "use a box or a cylinder",
            );
            None
        }
        file::Region::Beyond(plane) => {
            let normal = direction(document, &format!("{path}.beyond.normal"), plane.normal);
            let expected = "a bounded region: box or cylinder";
            let fits = document.demand(purpose == Use::Emptying, path, "`beyond`", expected);
            fits.then_some(Region::Beyond {
                point: plane.point.into(),
                normal: normal?,
            })
        }
    }
}
