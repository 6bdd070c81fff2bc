//! Names in the picture of a scene: boundaries with their inputs, sensors, sources and sinks where they are.

use std::f64::consts::TAU;

use serde::Serialize;
use sphere_dda::Vec3;
use sphere_dda::geometry::region::{Primitive, Region};
use sphere_dda::scene::{Measure, Scene};

/// Segments of a circle.
const SEGMENTS: usize = 48;

/// What a name belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// An input of a boundary.
    Input,
    /// A sensor.
    Sensor,
    /// A source of spheres.
    Source,
    /// A sink.
    Sink,
    /// A probed sphere.
    Probe,
}

/// A name with its place and the outline of what it names.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Label {
    text: String,
    kind: Kind,
    /// Where \[m\]; of an input that of its boundary.
    at: [f64; 3],
    /// Index of the boundary that it belongs to.
    boundary: Option<usize>,
    /// Ends of lines \[m\].
    lines: Vec<[[f64; 3]; 2]>,
}

impl Label {
    fn new(text: impl Into<String>, kind: Kind, at: Vec3, lines: Vec<[Vec3; 2]>) -> Self {
        Self {
            text: text.into(),
            kind,
            at: at.into(),
            boundary: None,
            lines: lines.iter().map(|ends| ends.map(Into::into)).collect(),
        }
    }
}

/// The names of a scene, as its outputs have them; `inputs` are those of its boundaries, as the FMU has them.
#[must_use]
pub fn labels(scene: &Scene, inputs: &[(usize, String)]) -> Vec<Label> {
    let mut list = Vec::new();
    for (b, name) in inputs {
        let boundary = &scene.boundaries[*b];
        let at = boundary.point_of_action;
        list.push(Label {
            boundary: Some(*b),
            ..Label::new(name, Kind::Input, at, Vec::new())
        });
    }
    for sensor in &scene.sensors {
        let (at, lines) = match &sensor.measure {
            Measure::Region(primitive) => outlined(primitive),
            Measure::Wrench { boundary } => {
                let at = scene.boundaries[*boundary].point_of_action;
                (at, Vec::new())
            }
            Measure::MassFlow {
                point,
                normal,
                outline,
            } => gate(scene, *point, *normal, outline),
        };
        list.push(Label::new(
            format!("sensor.{}", sensor.name),
            Kind::Sensor,
            at,
            lines,
        ));
    }
    let sources = scene.sources.iter();
    let sources = sources.map(|one| (format!("source.{}", one.name), Kind::Source, &one.region));
    let sinks = scene.sinks.iter();
    let sinks = sinks.map(|one| (format!("sink.{}", one.name), Kind::Sink, &one.region));
    for (name, kind, region) in sources.chain(sinks) {
        let (at, lines) = region_outline(scene, region);
        list.push(Label::new(name, kind, at, lines));
    }
    for probe in &scene.probes {
        let at = scene.initial.position[probe.sphere];
        list.push(Label::new(
            format!("probe.{}", probe.name),
            Kind::Probe,
            at,
            Vec::new(),
        ));
    }
    list
}

/// Centre and edges of a region; of an unbounded one the plane where it begins.
fn region_outline(scene: &Scene, region: &Region) -> (Vec3, Vec<[Vec3; 2]>) {
    match region {
        Region::Primitive(primitive) => outlined(primitive),
        Region::Mesh(solid) => box_edges(solid.bounds()),
        Region::Outside { min, max } => box_edges((*min, *max)),
        Region::Beyond { point, normal } => gate(scene, *point, *normal, &[]),
    }
}

fn outlined(primitive: &Primitive) -> (Vec3, Vec<[Vec3; 2]>) {
    match *primitive {
        Primitive::Box { min, max } => box_edges((min, max)),
        Primitive::Cylinder {
            base,
            axis,
            radius,
            height,
        } => {
            let (u, v) = across(axis);
            let rim = |k: usize, end: f64| {
                let (sin, cos) = (TAU * k as f64 / SEGMENTS as f64).sin_cos();
                base + axis * end + (u * cos + v * sin) * radius
            };
            let mut lines = Vec::new();
            for k in 0..SEGMENTS {
                lines.push([rim(k, 0.0), rim(k + 1, 0.0)]);
                lines.push([rim(k, height), rim(k + 1, height)]);
                if k.is_multiple_of(SEGMENTS / 4) {
                    lines.push([rim(k, 0.0), rim(k, height)]);
                }
            }
            (base + axis * (0.5 * height), lines)
        }
    }
}

fn box_edges((min, max): (Vec3, Vec3)) -> (Vec3, Vec<[Vec3; 2]>) {
    let corner =
        |k: usize| Vec3::from_fn(|axis, _| if k >> axis & 1 == 0 { min } else { max }[axis]);
    let edges = (0..8).flat_map(|k| (0..3).map(move |axis| (k, k | 1 << axis)));
    let lines = edges.filter(|(a, b)| a != b);
    let lines = lines.map(|(a, b)| [corner(a), corner(b)]);
    (0.5 * (min + max), lines.collect())
}

/// The corners of a gate, or a square of the plane near the scene, and its normal.
fn gate(scene: &Scene, point: Vec3, normal: Vec3, outline: &[Vec3]) -> (Vec3, Vec<[Vec3; 2]>) {
    let mut corners = outline.to_vec();
    if corners.is_empty() {
        let bounds = scene.boundaries.iter().filter_map(|b| b.geometry.bounds());
        let (min, max) = bounds
            .reduce(|(l, h), (m, n)| (l.inf(&m), h.sup(&n)))
            .unwrap_or((point.add_scalar(-0.5), point.add_scalar(0.5)));
        let middle = 0.5 * (min + max);
        let centre = middle - normal * (middle - point).dot(&normal);
        let (u, v) = across(normal);
        let side = 0.2 * (max - min).norm();
        corners = [-u - v, u - v, u + v, v - u]
            .map(|arm| centre + arm * side)
            .to_vec();
    }
    let middle = corners.iter().sum::<Vec3>() / corners.len() as f64;
    let next = corners.iter().cycle().skip(1);
    let mut lines: Vec<[Vec3; 2]> = corners.iter().zip(next).map(|(&a, &b)| [a, b]).collect();
    let reach = corners
        .iter()
        .map(|c| (c - middle).norm())
        .fold(0.0, f64::max);
    lines.push([middle, middle + normal * (0.3 * reach)]);
    (middle, lines)
}

/// Two unit vectors across a unit vector and each other.
fn across(axis: Vec3) -> (Vec3, Vec3) {
    let u = axis.cross(&Vec3::ith(axis.iamin(), 1.0)).normalize();
    (u, axis.cross(&u))
}
