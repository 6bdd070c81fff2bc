//! A panel as PNG, without its title.

use tiny_skia::{
    Color, FillRule, GradientStop, Mask, Paint, PathBuilder, Pixmap, Point, RadialGradient, Rect,
    Shader, SpreadMode, Stroke, Transform,
};

use crate::error::DrawingError;
use crate::panel::{COLOURS, Item, Panel};

/// Background, walls and lines: red, green, blue, alpha.
const PAPER: [u8; 4] = [251, 252, 253, 255];
const WALL: [u8; 4] = [135, 150, 165, 60];
const LINE: [u8; 4] = [63, 74, 84, 255];

impl Panel {
    /// The panel as PNG of `width` pixels; the same panel gives the same bytes.
    ///
    /// # Errors
    /// [`DrawingError`] if the window has no area or more than a bitmap can have.
    pub fn png(&self) -> Result<Vec<u8>, DrawingError> {
        let refused = |found: String| DrawingError {
            name: self.title.clone(),
            found,
            expected: "a window with an area of at most 10000 x 10000 px",
        };
        let size = (self.width.round(), self.height().round());
        let pixels = |side: f64| (1.0..=1e4).contains(&side).then_some(side as u32);
        let map = pixels(size.0).zip(pixels(size.1));
        let Some(mut map) = map.and_then(|(width, height)| Pixmap::new(width, height)) else {
            return Err(refused(format!("{} x {} px", size.0, size.1)));
        };
        map.fill(colour(PAPER));
        for item in self.items() {
            paint(&mut map, item);
        }
        map.encode_png().map_err(|error| refused(error.to_string()))
    }
}

/// Paints an item; one without area is not seen.
fn paint(map: &mut Pixmap, item: Item) {
    const WHOLE: Option<&Mask> = None;
    let mut outline = PathBuilder::new();
    let mut paint = Paint::default();
    match item {
        Item::Wall([a, b, c]) => {
            outline.move_to(a.0 as f32, a.1 as f32);
            outline.line_to(b.0 as f32, b.1 as f32);
            outline.line_to(c.0 as f32, c.1 as f32);
            outline.close();
            paint.set_color(colour(WALL));
        }
        Item::Line([a, b]) => {
            outline.move_to(a.0 as f32, a.1 as f32);
            outline.line_to(b.0 as f32, b.1 as f32);
            paint.set_color(colour(LINE));
            if let Some(path) = outline.finish() {
                let stroke = Stroke::default();
                map.stroke_path(&path, &paint, &stroke, Transform::identity(), WHOLE);
            }
            return;
        }
        Item::Disc {
            centre: (x, y),
            radius,
            colour,
        } => {
            let (x, y, r) = (x as f32, y as f32, radius as f32);
            if let Some(square) = Rect::from_xywh(x - r, y - r, 2.0 * r, 2.0 * r) {
                outline.push_oval(square);
            }
            paint.shader = shade(x, y, r, colour);
        }
    }
    if let Some(path) = outline.finish() {
        map.fill_path(
            &path,
            &paint,
            FillRule::Winding,
            Transform::identity(),
            WHOLE,
        );
    }
}

/// Lit from the upper left, as in the SVG.
fn shade(x: f32, y: f32, r: f32, index: usize) -> Shader<'static> {
    let (light, dark) = COLOURS[index];
    let light_at = Point::from_xy(x - 0.28 * r, y - 0.36 * r);
    let stops = vec![
        GradientStop::new(0.0, hexadecimal(light)),
        GradientStop::new(1.0, hexadecimal(dark)),
    ];
    RadialGradient::new(
        light_at,
        0.0,
        light_at,
        1.44 * r,
        stops,
        SpreadMode::Pad,
        Transform::identity(),
    )
    .unwrap_or(Shader::SolidColor(hexadecimal(dark)))
}

fn colour([r, g, b, a]: [u8; 4]) -> Color {
    Color::from_rgba8(r, g, b, a)
}

/// A colour of [`COLOURS`], `#rrggbb`.
fn hexadecimal(text: &str) -> Color {
    let part = |k: usize| {
        let digits = text.get(1 + 2 * k..3 + 2 * k).unwrap_or_default();
        u8::from_str_radix(digits, 16).unwrap_or_default()
    };
    colour([part(0), part(1), part(2), 255])
}

#[cfg(test)]
mod tests {
    use sphere_dda::Vec3;

    use super::*;
    use crate::panel::{Ball, View};

    fn panel(window: [(f64, f64); 2]) -> Panel {
        Panel {
            title: "one ball".into(),
            view: View::along(Vec3::y(), Vec3::z()),
            window,
            width: 40.0,
            balls: vec![Ball {
                centre: Vec3::new(1.0, 0.0, 1.0),
                radius: 0.5,
                colour: 3,
            }],
            triangles: vec![],
            lines: vec![],
        }
    }

    /// 10 px/m, 4 m x 2 m: the ball's centre is at (10, 10), its edge at (15, 10); it is red, the paper nearly white.
    #[test]
    fn a_ball_is_where_the_projection_puts_it() {
        let png = panel([(0.0, 0.0), (4.0, 2.0)]).png().unwrap();
        let map = Pixmap::decode_png(&png).unwrap();
        assert_eq!((map.width(), map.height()), (40, 20));
        let red = |x: u32, y: u32| {
            let p = map.pixel(x, y).unwrap();
            let [r, g, b] = [p.red(), p.green(), p.blue()].map(u32::from);
            r > 2 * b.min(g) || r > b + 40
        };
        assert!(red(10, 10) && red(7, 10) && red(13, 10));
        assert!(!red(16, 10) && !red(10, 3) && !red(30, 10));
        assert_eq!(png, panel([(0.0, 0.0), (4.0, 2.0)]).png().unwrap());
    }

    #[test]
    fn a_window_without_area_is_refused() {
        for corner in [(4.0, 0.0), (0.0, 2.0), (f64::NAN, 2.0)] {
            let error = panel([(0.0, 0.0), corner]).png().unwrap_err();
            assert!(error.to_string().contains("`one ball`"), "{error}");
        }
    }
}
