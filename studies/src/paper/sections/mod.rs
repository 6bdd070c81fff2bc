//! The report's sections: tables, plots and words from what was run.

mod penalties;

use sphere_dda::geometry::Shape;
use sphere_dda::scene::Method;
use sphere_dda_picture::plot::{Axis, Plot, Style};

use super::pictures::picture;
use super::stepping::{Example, Moment, Record, integrator_name, method_name};
use super::study::Study;
use super::text::{self, mean};
use crate::document::Document;
use crate::error::ReportError;
use crate::folder::Folder;
use crate::report::Report;
use crate::table::{Table, number};

/// The report of a study.
pub(super) fn write(study: &Study) -> Result<Folder, ReportError> {
    let mut report = Report::new("paper", "The paper reproduced");
    introduction(&mut report.document, study);
    overlaps(&mut report, study)?;
    places(&mut report, study)?;
    pictures(&mut report, study);
    work(&mut report, study)?;
    penalties::conditioning(&mut report, study)?;
    penalties::statics(&mut report, study)?;
    penalties::counts(&mut report, study)?;
    penalties::held(&mut report, study)?;
    report.document.heading(2, "The loop as implemented");
    report.document.text(
        "The paper's Fig. 2. *P* is adapted unless `adapt_penalty = false`; then, with `solver = \"direct\"`, it is exactly the paper's loop.",
    );
    report.document.code("mermaid", text::LOOP);
    report.document.heading(2, "The paper's slips in print");
    report.document.text(text::MISPRINTS);
    Ok(report.finish())
}

fn introduction(document: &mut Document, study: &Study) {
    document.text(
        "S. A. R. Beyabanaki, A. C. Bagtzoglou, *Modified contact constraints in sphere-based 3-D DDA*, American Journal of Engineering Research 9(4), 2020, \
         \"the paper\": its two examples, and what it claims, as numbers. This page with its drawings and tables is the output of",
    );
    document.code("sh", "sphere-dda reproduce-paper -o docs --overwrite");
    if study.duration < 1.0 {
        document.text(&format!(
            "**A trial: every run ends after {} of its duration, so the numbers below are not the examples'.**",
            study.duration
        ));
    }
    document.heading(2, "What the paper claims, and what was found");
    let worst = |method| {
        let records = study.records.iter().filter(|r| r.case.method == method);
        records.map(|r| r.overlaps.largest).fold(0.0, f64::max)
    };
    let most = |method| {
        let records = study.records.iter().filter(|r| r.case.method == method);
        records.map(|r| r.most_beyond).max().unwrap_or(0)
    };
    let kappa = |k: fn(&[f64]) -> Option<f64>| {
        let all: Vec<f64> = study
            .sweeps
            .iter()
            .filter_map(|(_, points)| {
                let kappas: Vec<f64> = points.iter().filter_map(|p| p.condition).collect();
                k(&kappas)
            })
            .collect();
        all.iter()
            .map(|&v| number(v))
            .collect::<Vec<_>>()
            .join(" and ")
    };
    document.text(&format!(
        "- *\"When using the ALM, no sphere interpenetration occurs, even though the initial penalty number is low.\"* Over all steps of both examples and both integrators \
           the largest overlap is {} of a radius with ALM (asked for: 1e-6) and {} with the penalty method.\n\
         - *\"The spheres move along the inclined planes without any violation of boundary planes constraints when the ALM is used.\"* At most {} spheres are beyond a boundary \
           with ALM, {} with the penalty method.\n\
         - *\"A very high penalty number leads to progressive ill-conditioning.\"* Six decades of P take the condition number of K from {} to {} (funnel and slopes): it grows with P. \
           In double precision the factor still has digits to spare there; an iterative solver would pay with its square root.\n\
         - *\"If the initial penalty number is too small, a large number of iterations is required.\"* With P held the loop takes ln(tol/d0)/ln q augmentations, to the count: \
           {} for one sphere and {} for a stack of ten with the funnel's numbers. Raising P while it gains too little is the cure used here.\n\
         - *\"The final exact contact forces can always be obtained by the iterative method, even with small initial values of the penalty number.\"* Forces equal statics at every P \
           as far as the tolerance on forces says; a tolerance on overlaps alone says little.",
        number(worst(Method::Alm)),
        number(worst(Method::Penalty)),
        most(Method::Alm),
        most(Method::Penalty),
        kappa(|k| k.first().copied()),
        kappa(|k| k.last().copied()),
        plain_count(study, 1),
        plain_count(study, 10),
    ));
    document.heading(2, "What is the paper's and what is reconstructed");
    document.text(text::RECONSTRUCTION);
}

/// Count by the force tolerance at the paper's own penalty, funnel.
fn plain_count(study: &Study, spheres: usize) -> String {
    let row = study
        .stacks
        .iter()
        .find(|row| row.example == Example::Funnel && row.spheres == spheres && row.factor == 1.0);
    row.map_or_else(String::new, |row| row.force.1.to_string())
}

/// The three cells that name a run.
fn run_cells(record: &Record) -> [String; 3] {
    let case = &record.case;
    [
        case.example.name().to_owned(),
        integrator_name(case.integrator).to_owned(),
        method_name(case.method).to_owned(),
    ]
}

/// The moments after the start.
fn later(record: &Record) -> impl Iterator<Item = &Moment> {
    record.moments.iter().filter(|m| m.time > 0.0)
}

fn overlaps(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report
        .document
        .heading(2, "Overlaps and spheres beyond a boundary");
    let mut table = Table::new(&[
        "example",
        "integrator",
        "method",
        "time [s]",
        "max overlap/R",
        "RMS overlap/R",
        "overlapping pairs",
        "spheres beyond a boundary",
    ]);
    for record in &study.records {
        for moment in later(record) {
            let overlaps = &moment.overlaps;
            table.row(run_cells(record).into_iter().chain([
                moment.time.to_string(),
                number(overlaps.largest),
                number(overlaps.rms()),
                overlaps.pairs.to_string(),
                moment.beyond_count().to_string(),
            ]));
        }
        let overlaps = &record.overlaps;
        table.row(run_cells(record).into_iter().chain([
            "all steps".to_owned(),
            number(overlaps.largest),
            number(overlaps.rms()),
            overlaps.pairs.to_string(),
            format!("{} at most", record.most_beyond),
        ]));
    }
    report.table("overlap", &table)?;
    report.document.text(text::DEFINITIONS);
    let failures: Vec<String> = study
        .records
        .iter()
        .filter_map(|r| Some(format!("- {}: {}", r.case.name(), r.failure.as_ref()?)))
        .collect();
    if !failures.is_empty() {
        report.document.text("Runs that ended before their time:");
        report.document.text(&failures.join("\n"));
    }
    for example in Example::ALL {
        let mut plot = Plot::new(
            &format!("{}: largest overlap of every step", example.name()),
            Axis::linear("time [s]"),
            Axis::logarithmic("overlap over radius [-]"),
        );
        for record in study.records.iter().filter(|r| r.case.example == example) {
            let [_, integrator, method] = run_cells(record);
            // Steps without any overlap have no place on a logarithmic axis.
            let points = record.history.iter().map(|h| (h.0, h.1));
            plot.add(
                &format!("{method}, {integrator}"),
                Style::Line,
                points.filter(|p| p.1 > 1e-12).collect(),
            );
        }
        let caption = "The penalty method overlaps by tenths of a radius; ALM stays below its tolerance of 1e-6";
        report.plot(&format!("overlap-{}", example.name()), &plot, caption)?;
    }
    Ok(())
}

fn places(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report
        .document
        .heading(2, "Where the spheres are at the printed times");
    let mut funnel = Table::new(&[
        "integrator",
        "method",
        "time [s]",
        "in the funnel",
        "through the outlet",
        "through its wall",
        "empty at [s]",
    ]);
    let mut slopes = Table::new(&[
        "integrator",
        "method",
        "time [s]",
        "plane 1",
        "plane 2",
        "plane 3",
        "plane 4",
        "plane 5",
        "run-out",
        "beyond",
    ]);
    for record in &study.records {
        let [_, integrator, method] = run_cells(record);
        for moment in later(record) {
            let own = || {
                let spheres = moment.position.iter().zip(&moment.beyond);
                spheres.filter(|(_, beyond)| !**beyond).map(|(x, _)| *x)
            };
            let mut cells = vec![integrator.clone(), method.clone(), moment.time.to_string()];
            let beyond = moment.beyond_count().to_string();
            match record.case.example {
                Example::Funnel => {
                    let below = own().filter(|x| x.z < 0.0).count();
                    let inside = own().count() - below;
                    let emptied = record.emptied.map_or("-".to_owned(), |t| format!("{t:.2}"));
                    cells.extend([inside.to_string(), below.to_string(), beyond, emptied]);
                    funnel.row(cells);
                }
                Example::Slopes => {
                    let starts = plane_starts(record);
                    for plane in 1..=starts.len() {
                        let on = |x: f64| starts.iter().filter(|&&s| s <= x).count().max(1);
                        let count = own().filter(|x| on(x.x) == plane).count();
                        cells.push(count.to_string());
                    }
                    cells.push(beyond);
                    slopes.row(cells);
                }
            }
        }
    }
    report.document.text("Funnel, 200 spheres:");
    report.table("funnel-places", &funnel)?;
    report.document.text("Slopes, 180 spheres:");
    report.table("slopes-places", &slopes)
}

/// Where each plane of the slopes begins \[m\], ascending.
fn plane_starts(record: &Record) -> Vec<f64> {
    let shapes = record.scene.boundaries.iter();
    let mut starts: Vec<f64> = shapes
        .flat_map(|b| b.geometry.shapes())
        .filter_map(|shape| match shape {
            Shape::Facets(f) => f.vertices.iter().map(|v| v.x).min_by(f64::total_cmp),
            _ => None,
        })
        .collect();
    starts.sort_by(f64::total_cmp);
    starts
}

fn pictures(report: &mut Report, study: &Study) {
    report.document.heading(2, "Pictures");
    report.document.text(
        "Integrator `shi`. Colours are the layers the spheres start in; red spheres are beyond a boundary. The early times are not the paper's: \
         they show the spheres while most of them touch.",
    );
    for example in Example::ALL {
        let records: Vec<&Record> = study
            .records
            .iter()
            .filter(|r| r.case.example == example)
            .take(2)
            .collect();
        let times = [0.0, example.early()];
        for &time in times.iter().chain(example.printed()) {
            if let Some(svg) = picture(&records, time) {
                let caption = format!("{} at {time} s: ALM and penalty method", example.name());
                report.picture(&format!("{}-{time}s", example.name()), svg, &caption);
            }
        }
    }
}

fn work(report: &mut Report, study: &Study) -> Result<(), ReportError> {
    report.document.heading(2, "Work per step");
    report.document.text(
        "Direct solver, penalty adapted from the paper's value, warm start: overlap, slip and force to 1e-6 in every step.",
    );
    let mut table = Table::new(&[
        "example",
        "integrator",
        "method",
        "steps",
        "augmentations, mean",
        "max",
        "linear solves, mean",
        "max",
    ]);
    for record in &study.records {
        let (a, s) = (record.augmentations, record.solves);
        table.row(run_cells(record).into_iter().chain([
            record.steps.to_string(),
            mean(a, record.steps),
            a.max.to_string(),
            mean(s, record.steps),
            s.max.to_string(),
        ]));
    }
    report.table("work", &table)
}
