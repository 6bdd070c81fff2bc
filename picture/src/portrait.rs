//! One picture of a scene as it is at t = 0.

use sphere_dda::Vec3;
use sphere_dda::geometry::{Geometry, Shape};
use sphere_dda::scene::Scene;

use crate::panel::{Ball, COLOURS, Panel, View};

/// Rim around what is shown, share of its larger side.
const RIM: f64 = 0.04;

/// The scene from the front, the side and above, in a square of `width` \[px\]: all spheres, coloured by material, and
/// all boundaries but half-spaces, which would hide everything.
#[must_use]
pub fn portrait(scene: &Scene, width: f64) -> Panel {
    let view = View::along(Vec3::new(0.5, 1.0, -0.5), Vec3::z());
    let particles = &scene.particles;
    let balls: Vec<Ball> = scene
        .initial
        .position
        .iter()
        .zip(particles.radius.iter().zip(&particles.material))
        .map(|(&centre, (&radius, &material))| Ball {
            centre,
            radius,
            colour: usize::from(material) % COLOURS.len(),
        })
        .collect();
    let triangles = sheets(scene);
    let spheres = balls.iter().flat_map(|ball| {
        let p = view.project(ball.centre);
        let r = ball.radius;
        [(p.x - r, p.y - r), (p.x + r, p.y + r)]
    });
    let corners = triangles.iter().flatten().map(|&x| {
        let p = view.project(x);
        (p.x, p.y)
    });
    let (low, high) = spheres
        .chain(corners)
        .map(|p| (p, p))
        .reduce(|(l, h), (p, q)| ((l.0.min(p.0), l.1.min(p.1)), (h.0.max(q.0), h.1.max(q.1))))
        .unwrap_or(((-0.5, -0.5), (0.5, 0.5)));
    let middle = (0.5 * (low.0 + high.0), 0.5 * (low.1 + high.1));
    let side = (high.0 - low.0).max(high.1 - low.1) * (0.5 + RIM);
    Panel {
        title: scene.title.clone(),
        view,
        window: [
            (middle.0 - side, middle.1 - side),
            (middle.0 + side, middle.1 + side),
        ],
        width,
        balls,
        triangles,
        lines: Vec::new(),
    }
}

/// Triangles of all sheets of the scene; half-spaces would hide everything.
#[must_use]
pub fn sheets(scene: &Scene) -> Vec<[Vec3; 3]> {
    let mut triangles = Vec::new();
    for boundary in &scene.boundaries {
        let shapes = boundary.geometry.shapes().iter();
        let sheets: Vec<Shape> = shapes
            .filter(|shape| !matches!(shape, Shape::HalfSpace(_)))
            .cloned()
            .collect();
        // They were a geometry with the half-spaces; without them they are one still.
        if let Ok(geometry) = Geometry::new(sheets) {
            let drawn = geometry.tessellate((Vec3::zeros(), Vec3::zeros()));
            let corner = |k: u32| drawn.points[k as usize];
            triangles.extend(drawn.triangles.iter().map(|t| t.map(corner)));
        }
    }
    triangles
}
