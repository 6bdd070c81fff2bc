//! The report's sections: a table of all laws, then each with its plot.

use sphere_dda_picture::plot::{Axis, Plot, Style};

use super::beverloo::Outflow;
use super::collapse::CHANGE;
use super::study::Study;
use super::{beverloo, collapse, repose};
use crate::error::ReportError;
use crate::folder::Folder;
use crate::report::Report;
use crate::table::{Table, number};

/// Source of the angle without friction.
const PEYNEAU: &str = "Peyneau & Roux 2008";

/// A measured figure and what it must be.
struct Check {
    case: &'static str,
    quantity: &'static str,
    reference: String,
    source: &'static str,
    measured: f64,
    /// What is allowed, both ends included.
    allowed: [f64; 2],
}

impl Check {
    fn passes(&self) -> bool {
        (self.allowed[0]..=self.allowed[1]).contains(&self.measured)
    }

    /// Distance from the middle of what is allowed, over its half width.
    fn error(&self) -> f64 {
        let [low, high] = self.allowed;
        (2.0 * self.measured - low - high) / (high - low)
    }
}

/// The report of a study.
pub(super) fn write(study: &Study) -> Result<Folder, ReportError> {
    let mut report = Report::new("verification", "Laws of granular matter");
    report.document.text(
        "What closed forms of a few bodies cannot show: laws that beds of some thousand grains obey. The closed forms themselves are ordinary tests \
         (`tests/verification/`). This page with its plots and tables is the output of",
    );
    report
        .document
        .code("sh", "sphere-dda verify -o docs --overwrite");
    if study.share < 1.0 {
        report.document.text(&format!(
            "**A trial:** {} of the grains. Its figures prove nothing.",
            number(study.share)
        ));
    }
    summary(&mut report, study)?;
    janssen(&mut report, study)?;
    beverloo(&mut report, study)?;
    collapse(&mut report, study)?;
    repose(&mut report, study)?;
    triaxial(&mut report, study)?;
    Ok(report.finish())
}

fn checks(study: &Study) -> Vec<Check> {
    let janssen = &study.janssen;
    let beverloo = &study.beverloo;
    let halves = beverloo.outflows.iter().map(Outflow::halves);
    let heads = halves.map(|[first, second]| second / first);
    // Fluctuations of a rate of few grains say nothing of the head: the mean over all orifices.
    let head = heads.sum::<f64>() / beverloo.outflows.len() as f64 - 1.0;
    let [low, high] = study.collapse.laws;
    let lube = "Lube et al. 2004";
    let angles: Vec<f64> = study.repose.iter().map(|s| s.angle()[0]).collect();
    let rise = angles.windows(2).map(|pair| pair[1] - pair[0]);
    let zhou = "Zhou et al. 2002";
    let peaks: Vec<f64> = study.triaxial.iter().map(|t| t.peak).collect();
    let peak_rise = peaks.windows(2).map(|p| p[1] - p[0]);
    let dilation = |t: &super::triaxial::Test| t.solid[1] - t.solid[0];
    let near = |value: f64, off: f64| [value - off, value + off];
    let check = |case, quantity, reference: &str, source, measured, allowed| Check {
        case,
        quantity,
        reference: reference.to_owned(),
        source,
        measured,
        allowed,
    };
    vec![
        check(
            "silo",
            "stress ratio K",
            "0.4 to 1.2",
            "Janssen 1895",
            janssen.ratio,
            [0.4, 1.2],
        ),
        check(
            "silo",
            "R² of the exponential",
            "> 0.98",
            "Janssen 1895",
            janssen.r2,
            [0.98, 1.0],
        ),
        check(
            "outflow",
            "exponent of D - 1.4 d",
            "2.5 ± 0.15",
            "Beverloo 1961",
            beverloo.exponent,
            near(2.5, 0.15),
        ),
        check(
            "outflow",
            "change of rate with the head",
            "0 ± 0.05",
            "Beverloo 1961",
            head,
            near(0.0, 0.05),
        ),
        check(
            "collapse, a < 1.7",
            "exponent",
            "1 ± 0.1",
            lube,
            low.0,
            near(1.0, 0.1),
        ),
        check(
            "collapse, a < 1.7",
            "prefactor",
            "1.24 ± 30 %",
            lube,
            low.1,
            near(1.24, 0.3 * 1.24),
        ),
        check(
            "collapse, a > 1.7",
            "exponent",
            "0.5 ± 0.1",
            lube,
            high.0,
            near(0.5, 0.1),
        ),
        check(
            "collapse, a > 1.7",
            "prefactor",
            "1.6 ± 30 %",
            lube,
            high.1,
            near(1.6, 0.3 * 1.6),
        ),
        check(
            "repose",
            "smallest angle [deg]",
            "≥ 15",
            zhou,
            angles.iter().copied().fold(f64::INFINITY, f64::min),
            [15.0, 25.0],
        ),
        check(
            "repose",
            "largest angle [deg]",
            "≤ 25",
            zhou,
            angles.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            [15.0, 25.0],
        ),
        check(
            "repose",
            "least rise with friction [deg]",
            "> 0",
            zhou,
            rise.fold(f64::INFINITY, f64::min),
            [0.0, 25.0],
        ),
        check(
            "triaxial, no friction",
            "mean angle at the end [deg]",
            "5.76, more with the rate",
            PEYNEAU,
            study.triaxial.first().map_or(f64::NAN, |t| t.end),
            [4.0, 10.0],
        ),
        check(
            "triaxial, no friction",
            "change of the solid fraction",
            "0 ± 0.01",
            PEYNEAU,
            study.triaxial.first().map_or(f64::NAN, dilation),
            near(0.0, 0.01),
        ),
        check(
            "triaxial",
            "least rise of the peak with friction [deg]",
            "> 0",
            "Göncü & Luding 2013",
            peak_rise.clone().fold(f64::INFINITY, f64::min),
            [0.0, 45.0],
        ),
        check(
            "triaxial",
            "last rise of the peak over the first, per friction",
            "< 1",
            "Göncü & Luding 2013",
            saturation(study),
            [0.0, 1.0],
        ),
    ]
}

/// Slope of the peak angle over the friction coefficient, in the last step of it over that in the first.
fn saturation(study: &Study) -> f64 {
    let slopes: Vec<f64> = study
        .triaxial
        .windows(2)
        .map(|t| (t[1].peak - t[0].peak) / (t[1].friction - t[0].friction))
        .collect();
    match slopes.as_slice() {
        [first, .., last] => last / first,
        _ => f64::NAN,
    }
}

fn summary(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    let mut table = Table::new(&[
        "case",
        "quantity",
        "reference",
        "source",
        "measured",
        "error",
        "pass",
    ]);
    for check in checks(study) {
        table.row([
            check.case.to_owned(),
            check.quantity.to_owned(),
            check.reference.clone(),
            check.source.to_owned(),
            number(check.measured),
            number(check.error()),
            if check.passes() { "yes" } else { "**no**" }.to_owned(),
        ]);
    }
    report.document.heading(2, "Summary");
    report.document.text("*error*: distance from the middle of what is allowed, over its half width; ±1 is the border.");
    report.table("summary", &table)
}

fn janssen(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    let silo = &study.janssen;
    report.document.heading(2, "Janssen's silo");
    report.document.text(&format!(
        "A silo ten grains wide; its floor sinks by 10 mm/s, so that wall friction (0.3, the grains have 0.5) points up. Weight above a level over the cross-section, *s*, against the vertical \
         stress that is left, by the balance of forces on all that lies above. The line is *s*∞ (1 - exp(-*s*/*s*∞)) with *s*∞ = {} Pa, that is *K* = {} at a bulk density of {} kg/m³.",
        number(silo.limit), number(silo.ratio), number(silo.bulk_density)
    ));
    let mut plot = Plot::new(
        "Stress in a silo",
        Axis::linear("weight above / area [Pa]"),
        Axis::linear("vertical stress [Pa]"),
    );
    let deepest = silo.profile.last().map_or(0.0, |p| p.0);
    let line = |f: &dyn Fn(f64) -> f64| {
        (0..=60)
            .map(|k| deepest * f64::from(k) / 60.0)
            .map(|s| (s, f(s)))
            .collect()
    };
    plot.add("measured", Style::Marks, silo.profile.clone());
    plot.add("Janssen", Style::Line, line(&|s| silo.law(s)));
    plot.add("hydrostatic", Style::Line, line(&|s| s));
    report.plot(
        "janssen",
        &plot,
        "Stress in the silo against the weight above",
    )
}

fn beverloo(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    let law = &study.beverloo;
    report.document.heading(2, "Beverloo's outflow");
    report.document.text(&format!(
        "A flat-bottomed bin eighteen grains wide, friction 0.5, with orifices of 4 to 10 grains. The rate is the slope of the mass that has left, from 0.2 s until 45 % have. \
         Means over {} packings but for those that jam, of which no grain leaves for 0.1 s: below five grains orifices do (Zuriguel et al. 2005); the first one's history is drawn. Fitted exponent of *D* - 1.4 *d*: {}; *C* = {} with the exponent 5/2 (Beverloo: 0.55 to 0.65).",
        beverloo::PACKINGS, number(law.exponent), number(law.coefficient)
    ));
    let mut table = Table::new(&[
        "D/d",
        "rate [kg/s]",
        "standard error",
        "first half [kg/s]",
        "second half [kg/s]",
        "C",
        "jammed",
    ]);
    for o in &law.outflows {
        let ([rate, scatter], [first, second]) = (o.rate(), o.halves());
        let c = rate / (law.bulk_density * super::bed::G.sqrt() * o.effective().powf(2.5));
        let values = [o.orifice, rate, scatter, first, second, c].map(number);
        table.row(values.into_iter().chain([o.jams().to_string()]));
    }
    report.table("beverloo", &table)?;
    let mut plot = Plot::new(
        "Outflow",
        Axis::logarithmic("D - 1.4 d [m]"),
        Axis::logarithmic("rate [kg/s]"),
    );
    let points: Vec<(f64, f64)> = law
        .outflows
        .iter()
        .map(|o| (o.effective(), o.rate()[0]))
        .collect();
    let scale = law.coefficient * law.bulk_density * super::bed::G.sqrt();
    let line = points
        .iter()
        .map(|p| (p.0, scale * p.0.powf(2.5)))
        .collect();
    plot.add("measured", Style::Marks, points);
    plot.add("exponent 5/2", Style::Line, line);
    report.plot("beverloo", &plot, "Rate against the effective orifice")?;
    let mut plot = Plot::new(
        "Mass that has left",
        Axis::linear("time [s]"),
        Axis::linear("mass [kg]"),
    );
    for o in &law.outflows {
        plot.add(
            &format!("D = {} d", o.orifice),
            Style::Line,
            o.flows.first().map_or_else(Vec::new, |f| f.history.clone()),
        );
    }
    report.plot(
        "beverloo-history",
        &plot,
        "Mass that has left: straight whatever the head",
    )
}

fn collapse(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    let study = &study.collapse;
    report.document.heading(2, "Collapse of a column");
    report.document.text(&format!(
        "A cylinder of grains (friction 0.5, rolling resistance 0.05 and on the floor 0.2) whose wall vanishes. *a*: height over radius as it stood; the front is where the deposit covers a twentieth of what a dense single layer does. Means over {} packings.",
        collapse::PACKINGS
    ));
    let mut table = Table::new(&[
        "a",
        "grains",
        "run-out (r∞ - r₀)/r₀",
        "standard error",
        "Lube",
        "all at rest [s]",
    ]);
    let lube = |a: f64| if a < CHANGE { 1.24 * a } else { 1.6 * a.sqrt() };
    for c in &study.columns {
        let (aspect, [runout, scatter]) = (c.aspect(), c.runout());
        let rest = c.deposits.iter().map(|d| d.rest).fold(0.0, f64::max);
        table.row([
            number(aspect),
            c.grains.to_string(),
            number(runout),
            number(scatter),
            number(lube(aspect)),
            number(rest),
        ]);
    }
    report.table("collapse", &table)?;
    let mut plot = Plot::new(
        "Run-out",
        Axis::logarithmic("a"),
        Axis::logarithmic("(r - r0)/r0"),
    );
    let points = study.columns.iter().map(|c| (c.aspect(), c.runout()[0]));
    let points: Vec<(f64, f64)> = points.collect();
    plot.add(
        "Lube et al.",
        Style::Line,
        points.iter().map(|p| (p.0, lube(p.0))).collect(),
    );
    plot.add("measured", Style::Marks, points);
    report.plot("collapse", &plot, "Run-out against the aspect ratio")
}

fn repose(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report.document.heading(2, "Angle of repose");
    report.document.text(&format!(
        "A box of grains on a floor of held grains, front and back without friction: its right wall vanishes, what stays has a slope. No rolling resistance. Means and standard errors over {} packings; the slopes drawn are those of the first.",
        repose::PACKINGS
    ));
    let mut table = Table::new(&[
        "friction",
        "angle [deg]",
        "standard error [deg]",
        "least R² of a line",
        "all at rest [s]",
    ]);
    for s in &study.repose {
        let r2 = s.heaps.iter().map(|h| h.r2).fold(1.0, f64::min);
        let rest = s.heaps.iter().map(|h| h.rest).fold(0.0, f64::max);
        let [angle, scatter] = s.angle();
        table.row([s.friction, angle, scatter, r2, rest].map(number));
    }
    report.table("repose", &table)?;
    let mut plot = Plot::new(
        "Angle of repose",
        Axis::linear("friction coefficient"),
        Axis::linear("angle [deg]"),
    );
    plot.add(
        "measured",
        Style::Both,
        study
            .repose
            .iter()
            .map(|s| (s.friction, s.angle()[0]))
            .collect(),
    );
    report.plot("repose", &plot, "Angle of repose against friction")?;
    let mut plot = Plot::new(
        "Slopes",
        Axis::linear("distance from the wall [m]"),
        Axis::linear("height [m]"),
    );
    for s in &study.repose {
        plot.add(
            &format!("friction {}", s.friction),
            Style::Both,
            s.heaps.first().map_or_else(Vec::new, |h| h.surface.clone()),
        );
    }
    report.plot("slopes", &plot, "Surfaces that stay")
}

fn triaxial(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report.document.heading(2, "Triaxial compression");
    let grains = study.triaxial.first().map_or(0, |t| t.grains);
    report.document.text(&format!(
        "{grains} grains between six frictionless walls without gravity, compacted without friction, so dense; then their friction is that of the table, the top comes down and servo walls hold \
         the pressure at the sides, with an inertial number of 0.001. Friction angle: sin φ = (s₁ - s₃)/(s₁ + s₃), means over 0.05 s. Without friction the angle is that of Peyneau and Roux, \
         a little above their limit of slow shear, and nothing dilates; with friction the sample dilates as it reaches its peak. *Servo*: what the side walls feel over the pressure they are to hold, less one.",
    ));
    let mut table = Table::new(&[
        "friction",
        "peak [deg]",
        "end [deg]",
        "solid fraction, start",
        "end",
        "servo",
    ]);
    for t in &study.triaxial {
        table.row([t.friction, t.peak, t.end, t.solid[0], t.solid[1], t.servo].map(number));
    }
    report.table("triaxial", &table)?;
    let mut plot = Plot::new(
        "Peak friction angle",
        Axis::linear("friction coefficient"),
        Axis::linear("angle [deg]"),
    );
    let points = |f: &dyn Fn(&super::triaxial::Test) -> f64| {
        study.triaxial.iter().map(|t| (t.friction, f(t))).collect()
    };
    plot.add("peak", Style::Both, points(&|t| t.peak));
    plot.add("end", Style::Both, points(&|t| t.end));
    report.plot(
        "triaxial",
        &plot,
        "Friction angle of a dense sample against friction",
    )?;
    let mut plot = Plot::new(
        "Triaxial compression",
        Axis::linear("axial strain"),
        Axis::linear("mobilised friction angle [deg]"),
    );
    for t in &study.triaxial {
        plot.add(
            &format!("friction {}", t.friction),
            Style::Line,
            t.history.clone(),
        );
    }
    report.plot(
        "triaxial-history",
        &plot,
        "Mobilised friction angle by strain",
    )
}
