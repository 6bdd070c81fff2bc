//! What depends on the penalty: conditioning, statics, augmentations at a held penalty.

use sphere_dda_picture::plot::{Axis, Plot, Style};

use super::super::column::{FACTORS, TOLERANCE};
use super::super::held::{MOST, Outcome};
use super::super::stepping::{Example, Record};
use super::super::study::{STACKS, StackRow, Study};
use super::super::text::mean;
use crate::error::ReportError;
use crate::report::Report;
use crate::table::{Table, number};

pub(super) fn conditioning(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report
        .document
        .heading(2, "Conditioning and overlap against the penalty");
    report.document.text(
        "kappa(K) in the 2-norm, by power and inverse iteration, of one step (funnel: at 2 s, slopes: at 5 s) with its loaded contacts; K in the paper's unknowns (u [m], r [rad]), SI units. \
         Overlaps are those of runs with `shi` from the start to the time given, ALM beginning every run with the penalty of the row.",
    );
    let mut growth = Plot::new(
        "Condition number of K",
        Axis::logarithmic("P over the paper's P [-]"),
        Axis::logarithmic("kappa(K) [-]"),
    );
    for (example, points) in &study.sweeps {
        let base = study.penalty(*example);
        let mut table = Table::new(&[
            "P [N/m]",
            "kappa(K)",
            "penalty: max overlap/R",
            "RMS",
            "beyond",
            "ALM: max overlap/R",
            "RMS",
            "beyond",
            "augmentations, mean",
            "max",
        ]);
        for point in points {
            let (penalty, alm) = (&point.penalty, &point.alm);
            table.row([
                format!("{:.0e}", point.factor * base),
                point.condition.map_or("no factor".to_owned(), number),
                number(penalty.overlaps.largest),
                number(penalty.overlaps.rms()),
                penalty.most_beyond.to_string(),
                number(alm.overlaps.largest),
                number(alm.overlaps.rms()),
                alm.most_beyond.to_string(),
                mean(alm.augmentations, alm.steps),
                alm.augmentations.max.to_string(),
            ]);
        }
        let until = points.first().map_or(0.0, |p| p.penalty.case.end);
        report
            .document
            .text(&format!("{}, to {until} s:", example.name()));
        report.table(&format!("penalty-{}", example.name()), &table)?;
        let marks = points.iter().filter_map(|p| Some((p.factor, p.condition?)));
        growth.add(example.name(), Style::Both, marks.collect());
    }
    report.plot(
        "condition",
        &growth,
        "Once contacts are stiffer than inertia, the condition number grows with P",
    )?;
    let mut left = Plot::new(
        "Largest overlap against the penalty",
        Axis::logarithmic("P over the paper's P [-]"),
        Axis::logarithmic("overlap over radius [-]"),
    );
    for (example, points) in &study.sweeps {
        for (method, pick) in [
            (
                "penalty",
                (|p| &p.penalty) as fn(&super::super::conditioning::Point) -> &Record,
            ),
            ("ALM", |p| &p.alm),
        ] {
            let marks = points.iter().map(|p| (p.factor, pick(p).overlaps.largest));
            left.add(
                &format!("{}, {method}", example.name()),
                Style::Both,
                marks.collect(),
            );
        }
    }
    report.plot(
        "overlap-penalty",
        &left,
        "The penalty method overlaps by what P is; ALM by its tolerance",
    )
}

pub(super) fn statics(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report.document.heading(2, "Final forces against statics");
    report.document.text(
        "One sphere and a stack of ten at rest on a floor, with each example's numbers. Forces must be k m g. *Held*: the paper's loop at that P, ended by the force tolerance 1e-6, \
         which is a local one: in a stack of ten what is left of the slowest mode is about 100 times that. *Adapted*: the library's loop at its default tolerances, P changed where it gains too little. \
         *Penalty*: overlap of the lowest contact at rest, n m g/P/R, and as found by steps without memory of velocity; beyond half a radius it is not run.",
    );
    let mut table = Table::new(&[
        "numbers of",
        "spheres",
        "P [N/m]",
        "force error, held",
        "force error, adapted",
        "augmentations, adapted",
        "penalty overlap/R, n m g/P/R",
        "found",
    ]);
    for row in &study.stacks {
        table.row([
            row.example.name().to_owned(),
            row.spheres.to_string(),
            format!("{:.0e}", row.factor * study.penalty(row.example)),
            number(row.error),
            number(row.adapted.1),
            row.adapted.0.to_string(),
            number(row.penalty.0),
            row.penalty.1.map_or("not run".to_owned(), number),
        ]);
    }
    report.table("statics", &table)
}

pub(super) fn counts(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report
        .document
        .heading(2, "Augmentations at a held penalty");
    report.document.text(&format!(
        "The paper's loop and nothing else: multipliers from zero, P held, no sweeps. With K = 2 m/dt^2 one sphere contracts by q = K/(K + P), a stack of n by \
         q = 1/(1 + P/K (2 - 2 cos(pi/(2 n + 1)))) in its slowest mode, and N = ln(tol/a)/ln q with that mode's share *a* of the residual at the start: \
         d0 = g dt^2/2 for one sphere. Tolerance {TOLERANCE:e}, on the overlap over R and, separately, on the force over the contact's force."
    ));
    let mut table = Table::new(&[
        "numbers of",
        "spheres",
        "P [N/m]",
        "1 - q",
        "overlap: predicted",
        "counted",
        "force: predicted",
        "counted",
    ]);
    let mut plot = Plot::new(
        "Augmentations to the force tolerance",
        Axis::logarithmic("P over the paper's P [-]"),
        Axis::logarithmic("augmentations [-]"),
    );
    for row in &study.stacks {
        table.row([
            row.example.name().to_owned(),
            row.spheres.to_string(),
            format!("{:.0e}", row.factor * study.penalty(row.example)),
            number(1.0 - row.contraction),
            format!("{:.1}", row.gap.0),
            row.gap.1.to_string(),
            format!("{:.1}", row.force.0),
            row.force.1.to_string(),
        ]);
    }
    report.table("augmentations", &table)?;
    for example in Example::ALL {
        for spheres in STACKS {
            let of = |row: &&StackRow| row.example == example && row.spheres == spheres;
            let rows: Vec<&StackRow> = study.stacks.iter().filter(of).collect();
            let name = format!("{}, {spheres}", example.name());
            let line = rows.iter().map(|r| (r.factor, r.force.0)).collect();
            plot.add(&format!("{name}: ln(tol/a)/ln q"), Style::Line, line);
            let marks = rows.iter().map(|r| (r.factor, r.force.1 as f64)).collect();
            plot.add(&format!("{name}: counted"), Style::Marks, marks);
        }
    }
    report.plot(
        "augmentations",
        &plot,
        "Counted augmentations lie on the prediction",
    )
}

pub(super) fn held(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report
        .document
        .heading(2, "Whole examples at a held penalty");
    report.document.text(&format!(
        "The paper's loop over the examples, P held from {} P to {} P, `shi`, default tolerances (overlap, slip and force 1e-6). A run is left out as soon as a step needs more than \
         {MOST} augmentations, re-linearised passes together, or three linear solves to each of them; it is not begun if one sphere alone needs more by the force tolerance. \
         At {} P it is also run without friction: leaving friction out does not save it.",
        FACTORS[0], FACTORS[4], FACTORS[4],
    ));
    let mut table = Table::new(&[
        "example",
        "friction",
        "P [N/m]",
        "outcome",
        "augmentations, mean",
        "max",
        "linear solves, mean",
        "max",
        "max overlap/R",
    ]);
    for (held, outcome) in &study.held {
        let mut cells = vec![
            held.example.name().to_owned(),
            if held.friction { "5 degrees" } else { "none" }.to_owned(),
            format!("{:.0e}", held.factor * study.penalty(held.example)),
        ];
        match outcome {
            Outcome::Predicted(count) => {
                cells.push(format!("left out: one sphere needs {count:.0}"));
            }
            Outcome::Stopped { time, before } => {
                cells.push(format!(
                    "left out: the step to {time:.2} s needs more than {MOST}"
                ));
                cells.extend([String::new(), before.max.to_string()]);
            }
            Outcome::Whole {
                steps,
                augmentations,
                solves,
                overlap,
            } => {
                cells.push(format!("whole, {steps} steps"));
                cells.extend([
                    mean(*augmentations, *steps),
                    augmentations.max.to_string(),
                    mean(*solves, *steps),
                    solves.max.to_string(),
                    number(*overlap),
                ]);
            }
        }
        table.row(cells);
    }
    report.table("held", &table)
}
