//! Plots as SVG: curves and marks over linear or logarithmic axes.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::error::DrawingError;

/// Size \[px\].
const SIZE: (u32, u32) = (760, 440);
/// Colours that stay apart for colour-blind readers (Okabe and Ito), in order of use.
const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(60, 60, 60),
];

/// How an axis is divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Division {
    /// Evenly.
    Linear,
    /// By decades; values must be > 0, others are left out.
    Logarithmic,
}

/// An axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Axis {
    /// What is laid off, with its unit.
    pub label: String,
    /// How.
    pub division: Division,
}

impl Axis {
    /// A linear axis.
    #[must_use]
    pub fn linear(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            division: Division::Linear,
        }
    }

    /// A logarithmic axis.
    #[must_use]
    pub fn logarithmic(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            division: Division::Logarithmic,
        }
    }

    /// Where `value` lies on the axis; `None` off a logarithmic one.
    fn place(&self, value: f64) -> Option<f64> {
        let placed = match self.division {
            Division::Linear => value,
            Division::Logarithmic => value.log10(),
        };
        placed.is_finite().then_some(placed)
    }

    /// Range that holds all `placed` values, and the number of labels on it.
    fn range(&self, placed: impl Iterator<Item = f64>) -> Option<(f64, f64, usize)> {
        let (low, high) = placed.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        });
        if low > high {
            return None;
        }
        match self.division {
            Division::Logarithmic => {
                let (low, high) = ((low - 0.01).floor(), (high + 0.01).ceil());
                Some((low, high, (high - low) as usize + 1))
            }
            Division::Linear => {
                let margin = 0.04 * (high - low).max(1e-9 * high.abs()).max(1e-12);
                // Counts and times begin at zero.
                let low = if low >= 0.0 { 0.0 } else { low - margin };
                Some((low, high + margin, 8))
            }
        }
    }

    fn text(&self, place: f64) -> String {
        match self.division {
            Division::Linear if place.abs() < 1e-12 => "0".to_owned(),
            Division::Linear if place.abs() >= 1e4 => format!("{place:.0e}"),
            Division::Linear => format!("{}", (place * 1e6).round() / 1e6),
            Division::Logarithmic => format!("1e{place:.0}"),
        }
    }
}

/// How the points of a series are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// Joined by a line.
    Line,
    /// As marks.
    Marks,
    /// As marks joined by a line.
    Both,
}

/// Points with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// `(x, y)`.
    pub points: Vec<(f64, f64)>,
    /// How they are shown.
    pub style: Style,
}

/// A plot.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Title.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// What is plotted, in the order of the legend.
    pub series: Vec<Series>,
}

impl Plot {
    /// A plot without series.
    #[must_use]
    pub fn new(title: &str, x: Axis, y: Axis) -> Self {
        Self {
            title: title.to_owned(),
            x,
            y,
            series: Vec::new(),
        }
    }

    /// Adds a series.
    pub fn add(&mut self, name: &str, style: Style, points: Vec<(f64, f64)>) {
        self.series.push(Series {
            name: name.to_owned(),
            points,
            style,
        });
    }

    fn place(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        Some((self.x.place(x)?, self.y.place(y)?))
    }

    /// Whether there is a point that the axes can show.
    #[must_use]
    pub fn shows(&self) -> bool {
        let mut points = self.series.iter().flat_map(|s| s.points.iter());
        points.any(|&p| self.place(p).is_some())
    }

    /// The plot as SVG.
    ///
    /// # Errors
    /// [`DrawingError`] if there is no point that the axes can show.
    pub fn svg(&self) -> Result<String, DrawingError> {
        let refuse = |found: String| DrawingError {
            name: self.title.clone(),
            found,
            expected: "finite points, positive on logarithmic axes",
        };
        let points = || self.series.iter().flat_map(|s| s.points.iter());
        let shown: Vec<(f64, f64)> = points().filter_map(|&p| self.place(p)).collect();
        let x = self.x.range(shown.iter().map(|p| p.0));
        let y = self.y.range(shown.iter().map(|p| p.1));
        let (Some(x), Some(y)) = (x, y) else {
            return Err(refuse(format!(
                "{} points, none in range",
                points().count()
            )));
        };
        let mut text = String::new();
        {
            let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
            self.draw(&area, x, y).map_err(|e| refuse(e.to_string()))?;
            area.present().map_err(|e| refuse(e.to_string()))?;
        }
        Ok(text)
    }

    /// The corner of the ranges `(low, high, _)` with the fewest points near it: place for the legend.
    fn emptiest_corner(&self, x: (f64, f64, usize), y: (f64, f64, usize)) -> SeriesLabelPosition {
        let points = || self.series.iter().flat_map(|s| s.points.iter());
        let near = |right: bool, top: bool| {
            let beside = |v: f64, (low, high, _): (f64, f64, usize), far: bool| {
                let share = (v - low) / (high - low);
                if far { share > 0.6 } else { share < 0.4 }
            };
            let placed = points().filter_map(|&p| self.place(p));
            placed
                .filter(|p| beside(p.0, x, right) && beside(p.1, y, top))
                .count()
        };
        let corners = [
            (near(true, true), SeriesLabelPosition::UpperRight),
            (near(false, true), SeriesLabelPosition::UpperLeft),
            (near(true, false), SeriesLabelPosition::LowerRight),
            (near(false, false), SeriesLabelPosition::LowerLeft),
        ];
        let emptiest = corners.into_iter().min_by_key(|(count, _)| *count);
        emptiest.map_or(SeriesLabelPosition::UpperRight, |(_, corner)| corner)
    }

    fn draw<D: DrawingBackend>(
        &self,
        area: &DrawingArea<D, Shift>,
        x: (f64, f64, usize),
        y: (f64, f64, usize),
    ) -> Result<(), DrawingAreaErrorKind<D::ErrorType>> {
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, ("sans-serif", 17))
            .margin(12)
            .x_label_area_size(42)
            .y_label_area_size(64)
            .build_cartesian_2d(x.0..x.1, y.0..y.1)?;
        chart
            .configure_mesh()
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .x_labels(x.2)
            .y_labels(y.2)
            .max_light_lines(if self.y.division == Division::Linear {
                2
            } else {
                1
            })
            .x_label_formatter(&|v| self.x.text(*v))
            .y_label_formatter(&|v| self.y.text(*v))
            .label_style(("sans-serif", 13))
            .draw()?;
        for (k, series) in self.series.iter().enumerate() {
            let color = PALETTE[k % PALETTE.len()];
            let line = color.stroke_width(2);
            let points = series.points.iter();
            let placed: Vec<(f64, f64)> = points.filter_map(|&p| self.place(p)).collect();
            if series.style != Style::Marks {
                chart
                    .draw_series(LineSeries::new(placed.iter().copied(), line))?
                    .label(&series.name)
                    .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], line));
            }
            if series.style != Style::Line {
                let marks = placed.iter().map(|&p| Circle::new(p, 4, color.filled()));
                let drawn = chart.draw_series(marks)?;
                if series.style == Style::Marks {
                    drawn
                        .label(&series.name)
                        .legend(move |(x, y)| Circle::new((x + 9, y), 4, color.filled()));
                }
            }
        }
        if self.series.len() > 1 {
            chart
                .configure_series_labels()
                .background_style(WHITE.mix(0.85))
                .border_style(BLACK.mix(0.3))
                .label_font(("sans-serif", 13))
                .position(self.emptiest_corner(x, y))
                .draw()?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn powers() -> Plot {
        let mut plot = Plot::new(
            "a < b",
            Axis::logarithmic("P [N/m]"),
            Axis::logarithmic("overlap [-]"),
        );
        let points = (0..7).map(|k| (10f64.powi(k), 10f64.powi(-k)));
        plot.add("law", Style::Line, points.clone().collect());
        plot.add("found", Style::Marks, points.collect());
        plot
    }

    /// The drawing is the same text every time, and carries every decade and name.
    #[test]
    fn decades_are_labelled_and_the_text_is_the_same_every_time() {
        let svg = powers().svg().expect("a plot");
        assert_eq!(svg, powers().svg().expect("a plot"));
        for label in [
            "1e0", "1e3", "1e6", "1e-6", "law", "found", "P [N/m]", "a &lt; b",
        ] {
            assert!(svg.contains(label), "{label} is missing");
        }
        assert_eq!(
            svg.matches("<circle").count(),
            8,
            "seven points, one legend"
        );
    }

    /// Equal ratios are equal distances: the seven marks of a power law lie on one line, evenly.
    #[test]
    fn a_power_law_is_a_straight_line() {
        let svg = powers().svg().expect("a plot");
        let read = |mark: &str, key: &str| -> f64 {
            let at = mark.find(key).expect("the attribute") + key.len();
            let value = mark[at..].split('"').next().expect("its value");
            value.parse().expect("a number")
        };
        let marks: Vec<(f64, f64)> = svg
            .split("<circle")
            .skip(1)
            .take(7)
            .map(|m| (read(m, "cx=\""), read(m, "cy=\"")))
            .collect();
        for pair in marks.windows(2) {
            let first = (marks[1].0 - marks[0].0, marks[1].1 - marks[0].1);
            let step = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
            // Pixels are whole numbers.
            assert!((step.0 - first.0).abs() <= 1.0 && (step.1 - first.1).abs() <= 1.0);
            assert!(step.0 > 20.0 && step.1 > 20.0, "x to the right, y down");
        }
    }

    #[test]
    fn nothing_to_show_is_an_error() {
        let mut plot = powers();
        plot.series.clear();
        plot.add("zero", Style::Line, vec![(1.0, 0.0), (f64::NAN, 1.0)]);
        assert!(powers().shows() && !plot.shows());
        assert!(matches!(plot.svg(), Err(DrawingError { .. })));
    }
}
