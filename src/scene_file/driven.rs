//! `body` of a boundary, checked: mass, inertia, joint, loads.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use super::checks::direction;
use super::document::Document;
use super::file;
use super::names::Names;
use crate::Vec3;
use crate::scene::body::{Area, Body, Joint, Servo, Spring};
use crate::spatial::{Pose, Twist};

/// Largest asymmetry of an inertia, and how far a moment may exceed the sum of the others, over the largest \[-\].
const ROUNDING: f64 = 1e-9;

/// Builds a body; `None` if a part of it was refused. `input`: whether loads are inputs as well.
pub(super) fn body(
    document: &mut Document<'_>,
    names: &Names,
    path: &str,
    given: &file::Body,
    point_of_action: Vec3,
    input: bool,
) -> Option<Body> {
    let at = |key: &str| format!("{path}.{key}");
    for (key, value, unit) in [
        ("damping", given.damping, "a damping >= 0 [N s/m]"),
        (
            "angular_damping",
            given.angular_damping,
            "a damping >= 0 [N m s/rad]",
        ),
    ] {
        document.within(at(key), value, 0.0.., unit);
    }
    let heavy = document.positive(at("mass"), given.mass, "a mass > 0 [kg]");
    let joint = match given.joint {
        file::Joint::Free => Some(Joint::Free),
        file::Joint::Slide(v) => {
            direction(document, &at("joint.slide"), v).map(|axis| Joint::Slide { axis })
        }
        file::Joint::Hinge(v) => {
            direction(document, &at("joint.hinge"), v).map(|axis| Joint::Hinge { axis })
        }
    };
    let principal = match &given.inertia {
        None => Some((Vec3::zeros(), UnitQuaternion::identity())),
        Some(rows) => principal(document, &at("inertia"), rows),
    };
    let servo = match &given.servo {
        None => None,
        Some(servo) => Some(self::servo(
            document,
            names,
            &at("servo"),
            servo,
            given.joint,
        )?),
    };
    let limits = limits(document, &at("limits"), given);
    let spring = spring(document, &at("spring"), given);
    let (joint, (moments, axes)) = (joint?, principal?);
    let body = Body {
        mass: given.mass,
        centre: given.centre.map_or(point_of_action, Vec3::from),
        moments,
        axes,
        joint,
        force: given.force.into(),
        torque: given.torque.into(),
        servo,
        limits: limits?,
        spring: spring?,
        damping: [given.damping, given.angular_damping],
        gravity: given.gravity,
        hold_while_settling: given.hold_while_settling,
        pose: Pose::default(),
        start_position: 0.0,
        twist: Twist {
            linear: given.velocity.into(),
            angular: given.angular_velocity.into(),
        },
        input,
    };
    (turns(document, &at("inertia"), &body, point_of_action)
        && starts(document, path, &body)
        && heavy)
        .then_some(body)
}

/// Whether `path` of a body is on a joint with one free direction.
fn guided(document: &mut Document<'_>, path: &str, joint: file::Joint) -> bool {
    document.demand(
        !matches!(joint, file::Joint::Free),
        path,
        "a free body",
        "joint = { slide = axis } or { hinge = axis }",
    )
}

/// Stops; `None` if refused.
fn limits(document: &mut Document<'_>, path: &str, given: &file::Body) -> Option<[Option<f64>; 2]> {
    let Some(file::Limits { lower, upper }) = given.limits else {
        return Some([None; 2]);
    };
    let guided = guided(document, path, given.joint);
    let any = document.demand(
        lower.is_some() || upper.is_some(),
        path,
        "neither `lower` nor `upper`",
        "at least one of them",
    );
    let (low, high) = (lower.unwrap_or(-1.0), upper.unwrap_or(1.0));
    let expected = "lower <= 0 <= upper, with room between: the scene's placement is 0 [m or rad]";
    let around = document.demand(
        low <= 0.0 && 0.0 <= high && low < high,
        path,
        format!("lower = {low}, upper = {high}"),
        expected,
    );
    (guided && any && around).then_some([lower, upper])
}

/// A joint's spring; `None` if refused.
fn spring(document: &mut Document<'_>, path: &str, given: &file::Body) -> Option<Option<Spring>> {
    let Some(file::JointSpring { stiffness, rest }) = given.spring else {
        return Some(None);
    };
    let guided = guided(document, path, given.joint);
    let stiff = document.positive(
        (path, "stiffness"),
        stiffness,
        "a stiffness > 0 [N/m or N m/rad]",
    );
    (guided && stiff).then_some(Some(Spring { stiffness, rest }))
}

/// A body that can turn needs inertia.
fn turns(document: &mut Document<'_>, path: &str, body: &Body, point_of_action: Vec3) -> bool {
    let (enough, expected) = match body.joint {
        Joint::Slide { .. } => (true, ""),
        Joint::Free => (
            body.moments.min() > 0.0,
            "three moments > 0 [kg m^2] for a free body",
        ),
        Joint::Hinge { axis } => (
            body.moment_about(axis, point_of_action) > 0.0,
            "a moment > 0 [kg m^2] about the hinge, or a centre of mass off its axis",
        ),
    };
    let found = match body.moments == Vec3::zeros() {
        true => "none".to_owned(),
        false => format!("principal moments {:?}", body.moments.as_slice()),
    };
    document.demand(enough, path, found, expected)
}

/// The velocity at t = 0 must be one that the joint allows.
fn starts(document: &mut Document<'_>, path: &str, body: &Body) -> bool {
    let allowed = |v: Vec3, axis: Option<Vec3>| {
        let rest = axis.map_or(v, |axis| v - axis * axis.dot(&v));
        rest.norm() <= ROUNDING * v.norm()
    };
    let [linear, angular, expected] = match body.joint {
        Joint::Free => return true,
        Joint::Slide { axis } => [
            allowed(body.twist.linear, Some(axis)),
            allowed(body.twist.angular, None),
            true,
        ],
        Joint::Hinge { axis } => [
            allowed(body.twist.linear, None),
            allowed(body.twist.angular, Some(axis)),
            false,
        ],
    };
    let [slides, turns] = match expected {
        true => ["along the slide", "zero: a slide does not turn"],
        false => ["zero: a hinge stays in its place", "about the hinge"],
    };
    let show = |v: Vec3| format!("{:?}", v.as_slice());
    let good = document.demand(linear, (path, "velocity"), show(body.twist.linear), slides);
    let key = format!("{path}.angular_velocity");
    document.demand(angular, key, show(body.twist.angular), turns) && good
}

/// Principal moments \[kg m^2\] and axes of an inertia as typed.
pub(super) fn principal(
    document: &mut Document<'_>,
    path: &str,
    rows: &[file::OneOrMany<f64>],
) -> Option<(Vec3, UnitQuaternion<f64>)> {
    let typed: Vec<Vec<f64>> = rows
        .iter()
        .map(|row| match row {
            file::OneOrMany::One(moment) => vec![*moment],
            file::OneOrMany::Many(list) => list.clone(),
        })
        .collect();
    let flat: Vec<f64> = typed.iter().flatten().copied().collect();
    let matrix = match (typed.len(), flat.len()) {
        (3, 3) if typed.iter().all(|row| row.len() == 1) => {
            Matrix3::from_diagonal(&Vec3::from_row_slice(&flat))
        }
        (3, 9) if typed.iter().all(|row| row.len() == 3) => Matrix3::from_row_slice(&flat),
        _ => {
            let found = format!("{} entries in {} rows", flat.len(), typed.len());
            return document.refuse(
                path,
                found,
                "[Ixx, Iyy, Izz] or three rows of three [kg m^2]",
            );
        }
    };
    let largest = matrix.amax();
    let skew = (matrix - matrix.transpose()).amax();
    let found = format!("{flat:?}");
    let symmetric = document.demand(
        skew <= ROUNDING * largest,
        path,
        &found,
        "a symmetric inertia",
    );
    // Diagonal input keeps its axes to the last bit.
    let (moments, axes) = if matrix == Matrix3::from_diagonal(&matrix.diagonal()) {
        (matrix.diagonal(), UnitQuaternion::identity())
    } else {
        let eigen = matrix.symmetric_eigen();
        let mut axes = eigen.eigenvectors;
        if axes.determinant() < 0.0 {
            axes.column_mut(0).neg_mut();
        }
        let axes = Rotation3::from_matrix_unchecked(axes);
        (
            eigen.eigenvalues,
            UnitQuaternion::from_rotation_matrix(&axes),
        )
    };
    let sum = moments.sum();
    let real = moments.min() >= 0.0 && moments.iter().all(|j| 2.0 * j <= sum * (1.0 + ROUNDING));
    let expected = "moments >= 0 of which none exceeds the sum of the others [kg m^2]";
    let real = symmetric && document.demand(real, path, &found, expected);
    real.then_some((moments, axes))
}

fn servo(
    document: &mut Document<'_>,
    names: &Names,
    path: &str,
    given: &file::Servo,
    joint: file::Joint,
) -> Option<Servo> {
    let slides = matches!(joint, file::Joint::Slide(_));
    let slides = document.demand(
        slides,
        path,
        "a body that is not on a slide",
        "joint = { slide = axis }",
    );
    let area = match (given.area, &given.between) {
        (Some(area), None) => document
            .positive((path, "area"), area, "an area > 0 [m^2]")
            .then_some(Area::Constant(area)),
        (None, Some(pairs)) => between(document, names, &format!("{path}.between"), pairs),
        _ => {
            let help = "give `area = ...` in m^2, or `between = [[a, b], [c, d]]` with the names of four boundaries";
            document.reject(
                path,
                "found none or both of `area` and `between`, expected one of them",
                help,
            )
        }
    };
    let area = area.filter(|_| slides)?;
    Some(Servo {
        pressure: given.pressure,
        area,
        input: given.input,
    })
}

fn between(
    document: &mut Document<'_>,
    names: &Names,
    path: &str,
    pairs: &[Vec<String>],
) -> Option<Area> {
    let found = format!("{pairs:?}");
    let shaped = pairs.len() == 2 && pairs.iter().all(|pair| pair.len() == 2);
    if !document.demand(
        shaped,
        path,
        found,
        "two pairs of boundary names [[a, b], [c, d]]",
    ) {
        return None;
    }
    let mut boundary =
        |i: usize, k: usize| names.resolve(document, &format!("{path}[{i}][{k}]"), &pairs[i][k]);
    let found = [
        [boundary(0, 0), boundary(0, 1)],
        [boundary(1, 0), boundary(1, 1)],
    ];
    match found {
        [[Some(a), Some(b)], [Some(c), Some(d)]] => Some(Area::Between([[a, b], [c, d]])),
        _ => None,
    }
}
