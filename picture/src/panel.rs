//! Pictures as SVG: spheres and boundaries in orthographic projection, far things first.
//!
//! A view looks along `direction`; with `right = direction x up` and `top = right x direction` a point `x` \[m\] lies at
//! `(x . right, x . top)` of the picture and at depth `x . direction`. Spheres are discs with a highlight at the depth of
//! their centre; boundaries are translucent triangles at the depth of their centroid.

use std::fmt::Write as _;

use sphere_dda::Vec3;

/// From where a picture is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    right: Vec3,
    top: Vec3,
    forward: Vec3,
}

impl View {
    /// Looks along `direction` with `up` pointing up in the picture; neither needs a length of 1, but they must not be
    /// parallel.
    #[must_use]
    pub fn along(direction: Vec3, up: Vec3) -> Self {
        let forward = direction.normalize();
        let right = forward.cross(&up).normalize();
        Self {
            right,
            top: right.cross(&forward),
            forward,
        }
    }

    /// Picture coordinates \[m\] of `x`: to the right, up, and away from the viewer.
    #[must_use]
    pub fn project(&self, x: Vec3) -> Vec3 {
        Vec3::new(x.dot(&self.right), x.dot(&self.top), x.dot(&self.forward))
    }
}

/// A sphere of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Centre \[m\].
    pub centre: Vec3,
    /// Radius \[m\].
    pub radius: f64,
    /// Colour, an index into [`COLOURS`].
    pub colour: usize,
}

/// Colours of spheres: light and dark side.
pub const COLOURS: [(&str, &str); 5] = [
    ("#ffd9a8", "#c96a10"),
    ("#b5dcf7", "#1f6fa8"),
    ("#c9efcf", "#2c8a4b"),
    ("#ffb3ab", "#b3140c"),
    ("#e6e6e6", "#6e6e6e"),
];

/// A part of a picture with its own scale: a rectangle of the view.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Text above it.
    pub title: String,
    /// From where it is seen.
    pub view: View,
    /// Lower left and upper right corner in picture coordinates \[m\].
    pub window: [(f64, f64); 2],
    /// Width in the picture \[px\]; the height follows.
    pub width: f64,
    /// The spheres.
    pub balls: Vec<Ball>,
    /// Triangles of the boundaries \[m\].
    pub triangles: Vec<[Vec3; 3]>,
    /// Lines \[m\]: edges of the boundaries that shall be seen.
    pub lines: Vec<[Vec3; 2]>,
}

/// Space around and between panels \[px\].
const MARGIN: f64 = 12.0;
/// Height of a panel's title \[px\].
const TITLE: f64 = 22.0;

impl Panel {
    pub(crate) fn height(&self) -> f64 {
        let [(x0, y0), (x1, y1)] = self.window;
        self.width * (y1 - y0) / (x1 - x0)
    }

    /// Scale \[px/m\].
    fn scale(&self) -> f64 {
        self.width / (self.window[1].0 - self.window[0].0)
    }

    /// Pixel of a point in the panel, and its depth \[m\].
    fn place(&self, x: Vec3) -> (f64, f64, f64) {
        let p = self.view.project(x);
        let s = self.scale();
        let [(x0, _), (_, y1)] = self.window;
        ((p.x - x0) * s, (y1 - p.y) * s, p.z)
    }

    /// Everything that is seen in the panel, far things first.
    pub(crate) fn items(&self) -> Vec<Item> {
        let mut items: Vec<(f64, Item)> = Vec::new();
        let (width, height) = (self.width, self.height());
        for triangle in &self.triangles {
            let corners = triangle.map(|x| self.place(x));
            if corners.iter().all(|c| c.0 < 0.0)
                || corners.iter().all(|c| c.0 > width)
                || corners.iter().all(|c| c.1 < 0.0)
                || corners.iter().all(|c| c.1 > height)
            {
                continue;
            }
            let depth = corners.iter().map(|c| c.2).sum::<f64>() / 3.0;
            items.push((depth, Item::Wall(corners.map(|c| (c.0, c.1)))));
        }
        for line in &self.lines {
            let [a, b] = line.map(|x| self.place(x));
            items.push((0.5 * (a.2 + b.2), Item::Line([(a.0, a.1), (b.0, b.1)])));
        }
        for ball in &self.balls {
            let (x, y, depth) = self.place(ball.centre);
            let radius = (ball.radius * self.scale()).max(1.2);
            if x < -radius || x > width + radius || y < -radius || y > height + radius {
                continue;
            }
            let colour = ball.colour % COLOURS.len();
            let centre = (x, y);
            items.push((
                depth,
                Item::Disc {
                    centre,
                    radius,
                    colour,
                },
            ));
        }
        // Stable, so that equal depths keep the order of the scene.
        items.sort_by(|a, b| b.0.total_cmp(&a.0));
        items.into_iter().map(|(_, item)| item).collect()
    }

    /// Its items as elements of an SVG.
    fn draw(&self, out: &mut String) {
        for item in self.items() {
            // Writing to a String cannot fail.
            let _ = match item {
                Item::Wall([a, b, c]) => writeln!(
                    out,
                    "<polygon class=\"wall\" points=\"{:.1},{:.1} {:.1},{:.1} {:.1},{:.1}\"/>",
                    a.0, a.1, b.0, b.1, c.0, c.1
                ),
                Item::Line([a, b]) => writeln!(
                    out,
                    "<line x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\"/>",
                    a.0, a.1, b.0, b.1
                ),
                Item::Disc {
                    centre: (x, y),
                    radius,
                    colour,
                } => writeln!(
                    out,
                    "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\" fill=\"url(#s{colour})\"/>"
                ),
            };
        }
    }
}

/// What is drawn, in pixels from the panel's upper left corner.
pub(crate) enum Item {
    Wall([(f64, f64); 3]),
    Line([(f64, f64); 2]),
    Disc {
        centre: (f64, f64),
        radius: f64,
        colour: usize,
    },
}

/// Rows of panels as one SVG; panels of a row stand side by side.
#[must_use]
pub fn svg(rows: &[Vec<Panel>]) -> String {
    let row_width =
        |row: &Vec<Panel>| -> f64 { row.iter().map(|p| p.width + MARGIN).sum::<f64>() + MARGIN };
    let row_height = |row: &Vec<Panel>| -> f64 {
        row.iter().map(Panel::height).fold(0.0, f64::max) + TITLE + MARGIN
    };
    let width = rows.iter().map(row_width).fold(0.0, f64::max);
    let height = rows.iter().map(row_height).sum::<f64>() + MARGIN;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" height=\"{height:.0}\">\n<defs>\n"
    );
    for (k, (light, dark)) in COLOURS.iter().enumerate() {
        // Writing to a String cannot fail.
        let _ = writeln!(
            out,
            "<radialGradient id=\"s{k}\" cx=\"0.36\" cy=\"0.32\" r=\"0.72\"><stop offset=\"0\" stop-color=\"{light}\"/><stop offset=\"1\" stop-color=\"{dark}\"/></radialGradient>"
        );
    }
    out += "</defs>\n<style>.wall{fill:#8796a5;fill-opacity:.16;stroke:#5d6b78;stroke-opacity:.16;stroke-width:.5}\
            line{stroke:#3f4a54;stroke-width:1}text{font:14px sans-serif;fill:#222}circle{stroke:#000;stroke-opacity:.35;stroke-width:.4}</style>\n\
            <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    let mut top = MARGIN;
    let mut number = 0;
    for row in rows {
        let mut left = MARGIN;
        for panel in row {
            let (w, h) = (panel.width, panel.height());
            let _ = write!(
                out,
                "<text x=\"{left:.1}\" y=\"{:.1}\">{}</text>\n<clipPath id=\"c{number}\"><rect width=\"{w:.1}\" height=\"{h:.1}\"/></clipPath>\n\
                 <g transform=\"translate({left:.1},{:.1})\"><rect width=\"{w:.1}\" height=\"{h:.1}\" fill=\"#fbfcfd\" stroke=\"#b8c0c8\"/>\n<g clip-path=\"url(#c{number})\">\n",
                top + 15.0,
                escape(&panel.title),
                top + TITLE
            );
            panel.draw(&mut out);
            out += "</g></g>\n";
            left += w + MARGIN;
            number += 1;
        }
        top += row_height(row);
    }
    out + "</svg>\n"
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(balls: Vec<Ball>) -> Panel {
        Panel {
            title: "a & b".into(),
            view: View::along(Vec3::y(), Vec3::z()),
            window: [(-1.0, -1.0), (3.0, 1.0)],
            width: 400.0,
            balls,
            triangles: vec![],
            lines: vec![],
        }
    }

    fn ball(x: f64, y: f64, z: f64, colour: usize) -> Ball {
        Ball {
            centre: Vec3::new(x, y, z),
            radius: 0.25,
            colour,
        }
    }

    /// Looking along y with z up: x to the right, z up, y is depth. 100 px/m: (1, ., 0.5) is at (200, 50) px.
    #[test]
    fn points_are_where_the_projection_puts_them() {
        let text = svg(&[vec![panel(vec![ball(1.0, 7.0, 0.5, 2)])]]);
        assert!(text.contains("cx=\"200.0\" cy=\"50.0\" r=\"25.0\" fill=\"url(#s2)\""));
        assert!(text.contains("a &amp; b"));
        let view = View::along(Vec3::new(1.0, 2.0, -0.5), Vec3::z());
        let x = Vec3::new(0.3, -0.2, 0.9);
        let p = view.project(x);
        assert!((p.norm() - x.norm()).abs() < 1e-15, "a rotation");
        assert!(view.project(Vec3::z()).y > 0.0, "up is up");
    }

    #[test]
    fn near_things_are_drawn_last_and_far_away_ones_not_at_all() {
        let near = ball(0.0, -1.0, 0.0, 0);
        let far = ball(0.1, 4.0, 0.0, 1);
        let outside = ball(9.0, 0.0, 0.0, 3);
        let text = svg(&[vec![panel(vec![near, far, outside])]]);
        let at = |k: usize| text.find(&format!("fill=\"url(#s{k})\""));
        assert!(at(1) < at(0) && at(1).is_some());
        assert_eq!(at(3), None);
    }
}
