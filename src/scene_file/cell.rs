//! The periodic cell, checked, and whether the scene fits into it.

use super::decode::Entry;
use super::document::Document;
use super::file;
use crate::Vec3;
use crate::geometry::Shape;
use crate::scene::body::Joint;
use crate::scene::{Boundary, InputKind, Measure, Motion, Scene};
use crate::spatial::cell::Cell;

/// Smallest edge over the largest diameter: a sphere never touches its own copy \[-\].
const ROOM: f64 = 1.001;
/// How far a direction may lean from an axis that it should be square to \[-\].
const LEAN: f64 = 1e-9;
const AXES: [&str; 3] = ["x", "y", "z"];

/// The cell of a scene.
pub(super) fn cell(document: &mut Document<'_>, given: &file::Cell) -> Cell {
    let given = [&given.x, &given.y, &given.z];
    Cell::new(std::array::from_fn(|axis| {
        let list = given[axis].as_deref()?;
        let faces = <[f64; 2]>::try_from(list)
            .ok()
            .filter(|[low, high]| low < high);
        let expected = "[lower face, upper face], the second larger [m]";
        let path = format!("cell.{}", AXES[axis]);
        document.demand(faces.is_some(), path, format!("{list:?}"), expected);
        faces
    }))
}

/// Demands an edge along `axis`, where it is periodic, in which the largest of some grains, of this diameter \[m\], keeps clear of its
/// copies.
pub(super) fn clear_of_copies(
    document: &mut Document<'_>,
    cell: &Cell,
    axis: usize,
    (diameter, what): (f64, &str),
) -> bool {
    let Some([low, high]) = cell.faces(axis) else {
        return true;
    };
    let room = diameter * ROOM;
    let found = format!("an edge of {} m", high - low);
    let expected = format!(
        "at least {room} m, {ROOM} diameters of the largest {what}: none may meet its own copy"
    );
    let path = format!("cell.{}", AXES[axis]);
    document.demand(high - low >= room, path, found, &expected)
}

/// Refuses what has no meaning in the cell. Returns whether the spheres fit.
pub(super) fn judge(
    document: &mut Document<'_>,
    scene: &Scene,
    boundaries: &[Entry<file::Boundary>],
    sensors: &[Entry<file::Sensor>],
) -> bool {
    let mut fit = true;
    let largest = scene.particles.largest_radius();
    let room = 2.0 * largest * ROOM;
    for (axis, name) in AXES.iter().enumerate() {
        let Some([low, high]) = scene.cell.faces(axis) else {
            continue;
        };
        fit &= clear_of_copies(document, &scene.cell, axis, (2.0 * largest, "sphere"));
        let frame = scene.settings.rotating_frame;
        if frame.is_some_and(|f| leans(f.angular_velocity, Vec3::ith(axis, 1.0))) {
            let message = format!(
                "the frame turns about an axis that is not {name}, along which the scene is periodic: \
                                   its copies would feel other centrifugal forces"
            );
            let help = format!("let the frame turn about {name}, or take {name} out of `[cell]`");
            document.error("simulation.rotating_frame", message, help);
        }
        for (boundary, element) in scene.boundaries.iter().zip(boundaries) {
            if let Err((found, help)) = fits(boundary, axis, [low, high], room) {
                let message = format!("boundary `{}` {found}", boundary.name);
                document.error(&element.path, message, help);
            }
        }
        for (sensor, element) in scene.sensors.iter().zip(sensors) {
            if let Measure::MassFlow {
                normal, outline, ..
            } = &sensor.measure
                && outline.is_empty()
                && normal[axis].abs() > LEAN
                && leans(*normal, Vec3::ith(axis, 1.0))
            {
                let message = format!(
                    "the plane leans to {name}, along which the scene is periodic: it would meet its copies"
                );
                let help = "turn it square to an axis, or give a polygon in the cell";
                document.error(format!("{}.mass_flow", element.path), message, help);
            }
        }
    }
    fit
}

/// Whether two directions are not parallel.
fn leans(a: Vec3, b: Vec3) -> bool {
    a.cross(&b).norm() > LEAN * a.norm() * b.norm()
}

/// What keeps a boundary from being repeated along an axis with these faces \[m\], and how to mend it; `room` \[m\] has to
/// be left between it and its copy.
fn fits(
    boundary: &Boundary,
    axis: usize,
    [low, high]: [f64; 2],
    room: f64,
) -> Result<(), (String, String)> {
    let name = AXES[axis];
    for shape in boundary.geometry.shapes() {
        let Shape::HalfSpace(plane) = shape else {
            continue;
        };
        if plane.normal[axis].abs() > LEAN {
            let found = format!(
                "crosses the faces of the cell across {name}: the normal of its plane has {name} = {}, expected 0",
                plane.normal[axis]
            );
            let help = format!(
                "a plane must run along periodic axes: turn it, or take {name} out of `[cell]`"
            );
            return Err((found, help));
        }
        if may_tilt(&boundary.motion, plane.normal, axis) {
            let found =
                format!("may tilt its plane towards {name}, along which the scene is periodic");
            let help = "let it turn about its normal or about the only periodic axis, or not at all; `input` may be \
                        slide, slide_speed, or a hinge about such an axis";
            return Err((found, help.to_owned()));
        }
    }
    let Some((min, max)) = boundary.geometry.finite_bounds() else {
        return Ok(());
    };
    if min[axis] < low || max[axis] > high {
        let found = format!(
            "crosses a face of the cell: it reaches from {name} = {} m to {} m, expected {low} m to {high} m",
            min[axis], max[axis]
        );
        let help =
            "a `plane` has no end and may run along the cell; what has edges must lie inside";
        return Err((found, help.to_owned()));
    }
    let length = match turns(&boundary.motion) {
        true => (max - min).norm(),
        false => max[axis] - min[axis],
    };
    if length + room > high - low {
        let found = format!(
            "takes {length} m of the cell's {} m along {name}, expected at most {} m: a sphere could touch it and its copy",
            high - low,
            high - low - room
        );
        let help = "enlarge the cell; a boundary all along it is a `plane`";
        return Err((found, help.to_owned()));
    }
    Ok(())
}

/// Axes about which a motion turns; `None`: any.
fn spins(motion: &Motion) -> Option<Vec<Vec3>> {
    match motion {
        Motion::Fixed => Some(Vec::new()),
        Motion::Constant(twist) => Some(vec![twist.angular]),
        Motion::Sinusoid { rotation, .. } => Some(vec![*rotation]),
        Motion::Table { rotation, .. } => Some(rotation.clone()),
        Motion::Input(kind) => match kind {
            InputKind::Slide { .. }
            | InputKind::SlideSpeed { .. }
            | InputKind::SlideForce { .. } => Some(Vec::new()),
            InputKind::Hinge { axis }
            | InputKind::HingeSpeed { axis }
            | InputKind::HingeTorque { axis } => Some(vec![*axis]),
            InputKind::Pose
            | InputKind::WorldPose { .. }
            | InputKind::Motion
            | InputKind::Twist
            | InputKind::Load => None,
        },
        Motion::Driven(body) => match body.joint {
            Joint::Free => None,
            Joint::Slide { .. } => Some(Vec::new()),
            Joint::Hinge { axis } => Some(vec![axis]),
        },
    }
}

/// Whether a motion may turn.
pub(super) fn turns(motion: &Motion) -> bool {
    spins(motion).is_none_or(|spins| spins.iter().any(|spin| *spin != Vec3::zeros()))
}

/// Whether a motion may turn a plane of this normal, which runs along `axis`, towards it. Between two rows of a table it turns about
/// all axes between theirs.
fn may_tilt(motion: &Motion, normal: Vec3, axis: usize) -> bool {
    let about = |spins: &[Vec3], direction: Vec3| spins.iter().all(|spin| !leans(*spin, direction));
    let keeps = |spins: &[Vec3]| about(spins, normal) || about(spins, Vec3::ith(axis, 1.0));
    spins(motion).is_none_or(|spins| {
        let rows = spins.len().clamp(1, 2);
        !spins.windows(rows).all(keeps)
    })
}
