//! Boundaries: faces to geometry, prescribed and driven motion.

use nalgebra::UnitQuaternion;

use super::checks::{accept, direction, increasing};
use super::columns::Columns;
use super::document::Document;
use super::driven::body;
use super::file;
use super::names::{Context, Names};
use super::units::metres;
use crate::Vec3;
use crate::geometry::{
    Facets, Geometry, GeometryError, HalfSpace, HeightField, Repair, Revolution, Shape,
};
use crate::scene::{Belt, Boundary, InputKind, Motion};
use crate::spatial::Twist;

/// Builds one boundary; `None` if a part of it was refused.
pub(super) fn boundary(
    document: &mut Document<'_>,
    context: &Context,
    boundaries: &Names,
    path: &str,
    value: &file::Boundary,
) -> Option<Boundary> {
    let material =
        context
            .materials
            .resolve(document, &format!("{path}.material"), &value.material);
    document.positive(
        (path, "stiffness"),
        value.stiffness,
        "a stiffness > 0 [N/m]",
    );
    let motion = match (&value.motion, value.input, &value.body) {
        (None, None, None) => Some(Motion::Fixed),
        (Some(given), None, None) => motion(document, &format!("{path}.motion"), given),
        (None, Some(given), None) => {
            let reference = value.point_of_action.into();
            input(document, &format!("{path}.input"), given, reference)
        }
        (None, None | Some(file::Input::Load), Some(given)) => {
            let at = value.point_of_action.into();
            let load = value.input.is_some();
            let body = body(
                document,
                boundaries,
                &format!("{path}.body"),
                given,
                at,
                load,
            );
            body.map(|body| Motion::Driven(Box::new(body)))
        }
        (_, _, Some(_)) => {
            let help = "keep `body`, with `input = \"load\"` if the outside pushes it, or what prescribes its motion";
            document.reject(
                (path, "body"),
                "found `body` and what prescribes the motion, expected one of them",
                help,
            )
        }
        (Some(_), Some(_), None) => {
            let help = "keep `motion` if the scene moves it, `input` if the outside does";
            document.reject(
                (path, "input"),
                "found both `motion` and `input`, expected one of them",
                help,
            )
        }
    };
    let geometry = geometry(document, &format!("{path}.faces"), &value.faces);
    let is_plane = |face: &file::Face| matches!(face, file::Face::Plane(_));
    if value.wall_fields && value.faces.iter().any(is_plane) {
        document.error(
            (path, "wall_fields"),
            "found a `plane` among the faces, expected faces with an area: a plane has no triangles",
            "use a `rectangle`, or give the plane a boundary of its own",
        );
    }
    Some(Boundary {
        name: value.name.clone(),
        material: u16::try_from(material?).ok()?,
        geometry: geometry?,
        motion: motion?,
        point_of_action: value.point_of_action.into(),
        stiffness: value.stiffness,
        belt: belt(value),
        wall_fields: value.wall_fields,
    })
}

fn belt(value: &file::Boundary) -> Option<Belt> {
    let velocity = value.surface_velocity.map(Vec3::from);
    (value.surface_input || velocity.is_some()).then(|| Belt {
        velocity: velocity.unwrap_or_default(),
        input: value.surface_input,
    })
}

/// A motion that is an input.
fn input(
    document: &mut Document<'_>,
    path: &str,
    given: file::Input,
    reference: Vec3,
) -> Option<Motion> {
    let mut axis = |key: &str, v| direction(document, &format!("{path}.{key}"), v);
    let kind = match given {
        file::Input::Pose => InputKind::Pose,
        file::Input::WorldPose => InputKind::WorldPose { reference },
        file::Input::Motion => InputKind::Motion,
        file::Input::Twist => InputKind::Twist,
        file::Input::Slide(v) => InputKind::Slide {
            axis: axis("slide", v)?,
        },
        file::Input::SlideSpeed(v) => InputKind::SlideSpeed {
            axis: axis("slide_speed", v)?,
        },
        file::Input::Hinge(v) => InputKind::Hinge {
            axis: axis("hinge", v)?,
        },
        file::Input::HingeSpeed(v) => InputKind::HingeSpeed {
            axis: axis("hinge_speed", v)?,
        },
        file::Input::Load => {
            let help = "add `body = { mass = ..., ... }`: only a body is moved by force";
            return document.reject(path, "found `load` for a boundary without `body`", help);
        }
    };
    Some(Motion::Input(kind))
}

/// A prescribed motion.
pub(super) fn motion(
    document: &mut Document<'_>,
    path: &str,
    given: &file::Motion,
) -> Option<Motion> {
    match given {
        file::Motion::Constant(c) => Some(Motion::Constant(Twist {
            linear: c.velocity.into(),
            angular: c.angular_velocity.into(),
        })),
        file::Motion::Sinusoid(s) => {
            let key = format!("{path}.sinusoid.frequency");
            let good = document.positive(key, s.frequency, "a frequency > 0 [Hz]");
            good.then_some(Motion::Sinusoid {
                translation: s.translation.into(),
                rotation: s.rotation.into(),
                frequency: s.frequency,
                phase: s.phase,
            })
        }
        file::Motion::Table(table) => {
            let path = format!("{path}.table");
            match (&table.csv, &table.time) {
                (Some(csv), None) if table.translation.is_none() && table.rotation.is_none() => {
                    read_table(document, &format!("{path}.csv"), csv)
                }
                (None, Some(time)) => typed_table(document, &path, time, table),
                _ => {
                    let help = "give `csv = \"file\"` alone, or `time` with `translation`, `rotation` or both";
                    document.reject(
                        path,
                        "found an incomplete or doubled table, expected `csv` or `time`",
                        help,
                    )
                }
            }
        }
    }
}

fn typed_table(
    document: &mut Document<'_>,
    path: &str,
    time: &[f64],
    table: &file::Table,
) -> Option<Motion> {
    let mut good = increasing(document, &format!("{path}.time"), time);
    let mut column = |key: &str, given: &Option<Vec<file::Vector>>| match given {
        None => vec![Vec3::zeros(); time.len()],
        Some(rows) => {
            let expected = format!("{} of them, one for each time", time.len());
            let found = format!("{} vectors", rows.len());
            good &= document.demand(
                rows.len() == time.len(),
                format!("{path}.{key}"),
                found,
                &expected,
            );
            rows.iter().map(|&v| v.into()).collect()
        }
    };
    let translation = column("translation", &table.translation);
    let rotation = column("rotation", &table.rotation);
    good.then(|| Motion::Table {
        time: time.to_vec(),
        translation,
        rotation,
    })
}

fn read_table(document: &mut Document<'_>, path: &str, csv: &str) -> Option<Motion> {
    let content = document.read(path, csv)?.to_owned();
    let names = ["time", "x", "y", "z", "rx", "ry", "rz"];
    let table = Columns::read(document, path, csv, &content, &names, 4)?;
    let vector = |row: &[Option<f64>; 7], k: usize| Vec3::from_fn(|i, _| row[k + i].unwrap_or(0.0));
    let time: Vec<f64> = table.rows.iter().map(|row| row[0].unwrap_or(0.0)).collect();
    increasing(document, path, &time).then(|| Motion::Table {
        translation: table.rows.iter().map(|row| vector(row, 1)).collect(),
        rotation: table.rows.iter().map(|row| vector(row, 4)).collect(),
        time,
    })
}

/// Builds every face, so that each faulty one is reported, then joins them.
fn geometry(document: &mut Document<'_>, path: &str, faces: &[file::Face]) -> Option<Geometry> {
    document
        .demand(
            !faces.is_empty(),
            path,
            "an empty list",
            "at least one face",
        )
        .then_some(())?;
    let mut shapes = Vec::with_capacity(faces.len());
    for (i, face) in faces.iter().enumerate() {
        let path = format!("{path}[{i}]");
        shapes.push(shape(document, &path, face));
    }
    let shapes: Vec<Shape> = shapes.into_iter().collect::<Option<_>>()?;
    let geometry = accept(document, path, Geometry::new(shapes))?;
    tell_dropped(document, path, geometry.repair());
    Some(geometry)
}

/// Warns of facets without area, which meshes leave out.
pub(super) fn tell_dropped(document: &mut Document<'_>, path: &str, repair: Option<&Repair>) {
    let Some(repair) = repair.filter(|r| !r.dropped_facets.is_empty()) else {
        return;
    };
    let dropped = repair.dropped_facets.iter().take(3);
    let named: Vec<String> = dropped
        .map(|(name, facet)| format!("{facet} of {name}"))
        .collect();
    let message = format!(
        "left out {} facets without area: {}{}",
        repair.dropped_facets.len(),
        named.join(", "),
        if repair.dropped_facets.len() > 3 {
            ", ..."
        } else {
            ""
        }
    );
    document.warn(
        path,
        message,
        "spheres do not notice; clean the mesh to silence this",
    );
}

/// One face as a shape.
fn shape(document: &mut Document<'_>, path: &str, face: &file::Face) -> Option<Shape> {
    let corners = |list: &[file::Vector]| list.iter().map(|&v| v.into()).collect::<Vec<Vec3>>();
    let (key, built) = match face {
        file::Face::Plane(p) => {
            let plane = HalfSpace::new(p.point.into(), p.normal.into());
            ("plane", plane.map(Shape::from))
        }
        file::Face::Rectangle(r) => {
            let path = format!("{path}.rectangle");
            let (u, v) = (Vec3::from(r.u), Vec3::from(r.v));
            let square = u.dot(&v).abs() <= 1e-6 * u.norm() * v.norm();
            let found = format!("u = {:?} and v = {:?}", r.u.0, r.v.0);
            let expected = "perpendicular edges; use `polygon` for other shapes";
            if !document.demand(square, path, found, expected) {
                return None;
            }
            (
                "rectangle",
                Facets::rectangle(r.corner.into(), u, v).map(Shape::from),
            )
        }
        file::Face::Triangle(list) => {
            let key = format!("{path}.triangle");
            let three = list.len() == 3;
            if !document.demand(three, key, format!("{} corners", list.len()), "three") {
                return None;
            }
            ("triangle", Facets::polygon(&corners(list)).map(Shape::from))
        }
        file::Face::Polygon(list) => ("polygon", Facets::polygon(&corners(list)).map(Shape::from)),
        file::Face::Box(b) => {
            let cuboid = Facets::cuboid(b.min.into(), b.max.into());
            ("box", cuboid.map(Shape::from))
        }
        file::Face::Cone(c) => {
            let cone = Revolution::frustum(c.base.into(), c.axis.into(), c.r0, c.r1, c.height);
            ("cone", cone.map(Shape::from))
        }
        file::Face::Cylinder(c) => ("cylinder", cylinder(c).map(Shape::from)),
        file::Face::Terrain(grid) => {
            return terrain(document, &format!("{path}.terrain"), grid);
        }
        file::Face::Stl(mesh) => return stl(document, &format!("{path}.stl"), mesh),
    };
    accept(document, &format!("{path}.{key}"), built)
}

fn cylinder(c: &file::Cylinder) -> Result<Revolution, GeometryError> {
    let (base, axis) = (c.base.into(), c.axis.into());
    if c.closed && c.radius > 0.0 && c.height > 0.0 {
        // One profile with its discs: separate ones would meet in ghost edges.
        let (r, h) = (c.radius, c.height);
        return Revolution::new(base, axis, &[[0.0, 0.0], [r, 0.0], [r, h], [0.0, h]]);
    }
    Revolution::cylinder(base, axis, c.radius, c.height)
}

fn stl(document: &mut Document<'_>, path: &str, mesh: &file::Stl) -> Option<Shape> {
    let facets = facets(document, path, mesh)?;
    // Welding and non-manifold edges are judged per file, so that the message points at it.
    let built = Geometry::new(vec![facets.clone().into()]);
    accept(document, &format!("{path}.file"), built)?;
    Some(facets.into())
}

/// The facets of an STL file where the scene puts them.
pub(super) fn facets(document: &mut Document<'_>, path: &str, mesh: &file::Stl) -> Option<Facets> {
    let good = document.positive((path, "scale"), mesh.scale, "a factor > 0 [-]");
    let metres = unit_of_length(document, path, mesh.unit.as_deref());
    let facets = stl_file(document, &format!("{path}.file"), &mesh.file)?;
    let scale = mesh.scale * metres?;
    good.then(|| facets.placed(scale, UnitQuaternion::identity(), mesh.translate.into()))
}

/// The factor of `unit` of the table at `path` to metres.
pub(super) fn unit_of_length(
    document: &mut Document<'_>,
    path: &str,
    unit: Option<&str>,
) -> Option<f64> {
    let unit = unit.unwrap_or("m");
    let metres = metres(unit);
    let expected = "a unit of length like \"mm\"";
    document.demand(
        metres.is_some(),
        (path, "unit"),
        format!("`{unit}`"),
        expected,
    );
    metres
}

/// The facets of the STL file that stands at `key`, as they are.
pub(super) fn stl_file(document: &mut Document<'_>, key: &str, file: &str) -> Option<Facets> {
    document.read(key, file)?;
    let mut facets = accept(document, key, Facets::stl(&document.place(file)))?;
    // The scene must not depend on where its folder lies.
    facets.name = file.to_owned();
    Some(facets)
}

fn terrain(document: &mut Document<'_>, path: &str, grid: &file::Terrain) -> Option<Shape> {
    let scale = match &grid.scale {
        file::OneOrMany::One(s) => vec![*s; 3],
        file::OneOrMany::Many(list) => list.clone(),
    };
    let found = format!("{scale:?}");
    let scale = <[f64; 3]>::try_from(scale).ok();
    let scale = scale.filter(|s| s.iter().all(|&s| s > 0.0));
    let expected = "one or three factors > 0 [-]";
    document.demand(scale.is_some(), (path, "scale"), found, expected);
    let key = format!("{path}.file");
    let content = document.read(&key, &grid.file)?;
    match HeightField::esri_ascii(content) {
        Ok(field) => {
            let facets = field.facets(&grid.file, scale?, grid.translate.into());
            if facets.triangles.is_empty() {
                let message = format!("`{}` has no four neighbouring heights", grid.file);
                return document.reject(key, message, "check NODATA_value");
            }
            Some(facets.into())
        }
        Err(problems) => {
            for problem in problems {
                document.error(&key, format!("`{}` {problem}", grid.file), "");
            }
            None
        }
    }
}
