//! Boundaries: closed forms of every primitive, properties of every touch, meshes without ghosts.

mod fits;
mod meshes;
mod primitives;
mod properties;
mod refused;
mod terrain;

use sphere_dda::Vec3;
use sphere_dda::geometry::{ClosestPoint, Geometry, Shape};

fn v(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

fn geometry(shapes: impl IntoIterator<Item = impl Into<Shape>>) -> Geometry {
    Geometry::new(shapes.into_iter().map(Into::into).collect()).unwrap()
}

fn closest_points(geometry: &Geometry, centre: Vec3, radius: f64, reach: f64) -> Vec<ClosestPoint> {
    let mut out = Vec::new();
    geometry.closest_points(centre, radius, reach, &mut out);
    out
}

#[track_caller]
fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{a} is not {b}");
}

#[track_caller]
fn same(a: Vec3, b: Vec3) {
    assert!(
        (a - b).norm() <= 1e-12 * (1.0 + b.norm()),
        "{a:?} is not {b:?}"
    );
}
