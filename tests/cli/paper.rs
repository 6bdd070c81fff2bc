//! `reproduce-paper`, every run cut to a hundredth of its duration.

use std::fs;

use tempfile::tempdir;

#[cfg(target_os = "linux")]
use crate::command::on_a_terminal;
use crate::command::{done, said};

/// On a terminal a bar says how much of the whole is behind and how long the rest takes; a pipe hears of cases alone.
#[cfg(target_os = "linux")]
#[test]
fn a_study_tells_on_a_terminal_when_it_will_be_done() {
    let folder = tempdir().unwrap();
    let command = env!("CARGO_BIN_EXE_sphere-dda");
    let study = format!("{command} reproduce-paper -o report --duration 0.005");
    let text = on_a_terminal(folder.path(), &study);
    let shares: Vec<u32> = text
        .split(" %, ETA ")
        .filter_map(|before| before.rsplit(' ').next()?.parse().ok())
        .collect();
    assert!(shares.len() > 2 && shares.is_sorted(), "{text}");
    assert!(shares.iter().all(|&share| share <= 100), "{shares:?}");
}

#[test]
fn a_short_study_writes_its_report_once() {
    let folder = tempdir().unwrap();
    let study = ["reproduce-paper", "-o", "report", "--duration", "0.005"];
    let first = done(folder.path(), &study);
    assert!(first.out.contains("paper.md"), "{}", first.out);
    assert!(first.error.contains("funnel, shi, ALM"), "{}", first.error);

    let report = folder.path().join("report");
    let text = fs::read_to_string(report.join("paper.md")).unwrap();
    assert!(text.contains("sphere-dda reproduce-paper"));
    assert!(
        text.contains("**A trial"),
        "a short study says that it is one"
    );
    // Everything the text shows or links to is there, and is what its name says.
    let links: Vec<&str> = text
        .split("](paper/")
        .skip(1)
        .map(|rest| rest.split(')').next().unwrap())
        .collect();
    assert!(links.len() > 8, "{links:?}");
    for link in links {
        let file = report.join("paper").join(link);
        if link.ends_with(".csv") {
            // A trial is too short for the places at the printed times.
            let table = fs::read_to_string(&file).unwrap();
            let least = if link.ends_with("-places.csv") { 1 } else { 2 };
            assert!(table.lines().count() >= least, "{link}");
        } else {
            let svg = fs::read_to_string(&file).unwrap();
            assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        }
    }
    // Both examples, integrators and methods, over all steps.
    let work = fs::read_to_string(report.join("paper/work.csv")).unwrap();
    assert_eq!(work.lines().count(), 1 + 8, "{work}");

    let again = said(folder.path(), &study);
    assert_eq!(again.code, Some(2));
    assert!(again.error.contains("--overwrite"), "{}", again.error);

    // Another run gives the same bytes.
    let mut over = study.to_vec();
    over.push("--overwrite");
    done(folder.path(), &over);
    assert_eq!(text, fs::read_to_string(report.join("paper.md")).unwrap());
}
