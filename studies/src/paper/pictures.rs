//! Pictures of the examples: ALM above, penalty below, seen as the paper shows them.

use sphere_dda::Vec3;
use sphere_dda_picture::panel::{Ball, Panel, View, svg};
use sphere_dda_picture::portrait::sheets;

use super::stepping::{Example, Moment, Record, method_name};

/// Colour of spheres beyond a boundary.
const BEYOND: usize = 3;
/// Width of the slopes' panels \[px\].
const WIDTH: f64 = 1100.0;
/// Greatest height of a close view \[px\].
const TALLEST: f64 = 300.0;

/// The moment nearest to `time` \[s\] of each record, one picture; `None` if no record came so far.
#[must_use]
pub(super) fn picture(records: &[&Record], time: f64) -> Option<String> {
    let mut rows = Vec::new();
    for record in records {
        let near = |m: &&Moment| (m.time - time).abs() < 1e-6;
        if let Some(moment) = record.moments.iter().find(near) {
            let panels = match record.case.example {
                Example::Funnel => vec![funnel(record, moment)],
                Example::Slopes => slopes(record, moment),
            };
            rows.push(panels);
        }
    }
    if rows.is_empty() {
        return None;
    }
    // The funnel's panels are narrow: side by side.
    let rows = match records[0].case.example {
        Example::Funnel => vec![rows.concat()],
        Example::Slopes => rows.into_iter().flatten().map(|p| vec![p]).collect(),
    };
    Some(svg(&rows))
}

fn title(record: &Record, moment: &Moment) -> String {
    format!(
        "{}, {} s: {} of {} spheres beyond a boundary",
        method_name(record.case.method),
        moment.time,
        moment.beyond_count(),
        moment.position.len()
    )
}

fn balls(record: &Record, moment: &Moment) -> Vec<Ball> {
    let layers = record.case.example.layers();
    let n = moment.position.len();
    (0..n)
        .map(|i| Ball {
            centre: moment.position[i],
            radius: record.scene.particles.radius[i],
            colour: if moment.beyond[i] {
                BEYOND
            } else {
                i * layers / n
            },
        })
        .collect()
}

/// From the side and a little above: the whole funnel and 5 m below its outlet.
fn funnel(record: &Record, moment: &Moment) -> Panel {
    Panel {
        title: title(record, moment),
        view: View::along(Vec3::new(0.35, 1.0, -0.38), Vec3::z()),
        window: [(-4.6, -5.2), (4.6, 5.6)],
        width: 460.0,
        balls: balls(record, moment),
        triangles: sheets(&record.scene),
        lines: Vec::new(),
    }
}

/// All planes from the side and above, and the stretch where the spheres are.
fn slopes(record: &Record, moment: &Moment) -> Vec<Panel> {
    let triangles = sheets(&record.scene);
    let lines: Vec<[Vec3; 2]> = edges(&triangles);
    let view = View::along(Vec3::new(0.0, 1.0, -0.4), Vec3::z());
    let place = |x: Vec3| view.project(x);
    let corners: Vec<Vec3> = triangles.iter().flatten().map(|&x| place(x)).collect();
    // The run-out is longer than the spheres come: 600 m of it are shown.
    let (left, right) = corners
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, r), c| {
            (l.min(c.x), r.max(c.x))
        });
    let right = right - 900.0;
    let low = corners.iter().map(|c| c.y).fold(f64::INFINITY, f64::min);
    let high = corners
        .iter()
        .map(|c| c.y)
        .fold(f64::NEG_INFINITY, f64::max);
    let whole = Panel {
        title: title(record, moment),
        view,
        window: [(left - 40.0, low - 90.0), (right, high + 30.0)],
        width: WIDTH,
        balls: balls(record, moment),
        triangles: triangles.clone(),
        lines: lines.clone(),
    };
    // Where the spheres are that the planes still bear; where none is left, the top of the slope.
    let borne = |beyond: &[bool]| -> Vec<Vec3> {
        let spheres = moment.position.iter().zip(beyond);
        spheres
            .filter(|(_, b)| !**b)
            .map(|(&x, _)| place(x))
            .collect()
    };
    let mut seen = borne(&moment.beyond);
    if seen.is_empty() {
        seen = record.moments[0]
            .position
            .iter()
            .map(|&x| place(x))
            .collect();
    }
    let span = |f: fn(&Vec3) -> f64| {
        seen.iter()
            .map(f)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
                (l.min(v), h.max(v))
            })
    };
    let ((x0, x1), (y0, y1)) = (span(|p| p.x), span(|p| p.y));
    let window = [(x0 - 30.0, y0 - 25.0), (x1 + 30.0, y1 + 25.0)];
    let shape = (window[1].0 - window[0].0) / (window[1].1 - window[0].1);
    let close = Panel {
        title: format!("the same, {:.0} m of it", x1 - x0 + 60.0),
        window,
        width: WIDTH.min(TALLEST * shape),
        ..whole.clone()
    };
    vec![whole, close]
}

/// Edges that only one triangle has, or that two triangles of different planes share: the outline and the bends.
fn edges(triangles: &[[Vec3; 3]]) -> Vec<[Vec3; 2]> {
    let normal = |[a, b, c]: &[Vec3; 3]| (b - a).cross(&(c - a)).normalize();
    let sides = |t: &[Vec3; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let same = |[a, b]: [Vec3; 2], [c, d]: [Vec3; 2]| {
        let near = |p: Vec3, q: Vec3| (p - q).norm() < 1e-6 * (a - b).norm();
        near(a, c) && near(b, d) || near(a, d) && near(b, c)
    };
    let mut found = Vec::new();
    for (k, triangle) in triangles.iter().enumerate() {
        for side in sides(triangle) {
            let flat = triangles.iter().enumerate().any(|(other, t)| {
                other != k
                    && sides(t).iter().any(|&s| same(side, s))
                    && normal(t).dot(&normal(triangle)).abs() > 1.0 - 1e-9
            });
            if !flat {
                found.push(side);
            }
        }
    }
    found
}
