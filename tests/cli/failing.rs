//! Foreign FMUs that fail in every way: one clear message, exit code 1 for a run that failed or 2 for an FMU that
//! cannot be used, and never a crash.

use std::path::Path;

use crate::command::{Said, command, said};
use crate::foreign_fmu::{Build, entries, pack, write_archive};

/// Simulates `bad.fmu` in `folder`; the message must be one, of this code, with these parts.
pub(crate) fn fails(folder: &Path, arguments: &[&str], code: i32, parts: &[&str]) -> Said {
    let said = said(folder, &[&["simulate", "bad.fmu"], arguments].concat());
    assert_eq!(said.code, Some(code), "{arguments:?}: {}", said.error);
    let reports = said.error.lines().filter(|line| line.contains('×')).count();
    assert_eq!(reports, 1, "{arguments:?}: {}", said.error);
    // The report is broken into lines at blanks.
    let words = said.error.split_whitespace().filter(|word| *word != "│");
    let text = words.collect::<Vec<_>>().join(" ");
    for part in parts {
        assert!(
            text.contains(part),
            "{arguments:?}: {part} is not in\n{text}"
        );
    }
    said
}

#[test]
fn every_status_of_every_call_is_a_message() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    pack(&folder.join("bad.fmu"), Build::Whole, |_| ());
    std::fs::write(folder.join("drive.csv"), "time,force[1],level\n0,1,high\n").unwrap();
    for function in [
        "fmi2EnterInitializationMode",
        "fmi2ExitInitializationMode",
        "fmi2SetReal",
        "fmi2SetInteger",
        "fmi2GetReal",
        "fmi2GetInteger",
        "fmi2GetString",
        "fmi2DoStep",
        "fmi2Terminate",
    ] {
        for (status, name) in [
            (2, "Discard"),
            (3, "Error"),
            (4, "Fatal"),
            (5, "Pending"),
            (77, "77, expected 0 to 5"),
            (-1, "-1, expected 0 to 5"),
        ] {
            let fault = format!("fault={function}:{status}");
            let part = match (function, status) {
                // It is tried again with shorter steps first.
                ("fmi2DoStep", 2) => "fmi2DoStep: found a discarded step".to_owned(),
                _ => format!("{function}: found status {name}"),
            };
            let arguments = ["--set", &fault, "--input", "drive.csv"];
            let place = match function {
                "fmi2Terminate" => "at time 2 s: ",
                _ => "at time 0 s: ",
            };
            let said = fails(folder, &arguments, 1, &[place, &part]);
            assert_eq!(
                said.error.matches("found ").count(),
                1,
                "told twice: {}",
                said.error
            );
            assert!(said.error.contains("failed on purpose"), "{}", said.error);
        }
        let fault = format!("fault={function}:1");
        let warned = [
            "simulate",
            "bad.fmu",
            "--set",
            &fault,
            "--input",
            "drive.csv",
        ];
        assert_eq!(
            said(folder, &warned).code,
            Some(0),
            "{function} with a warning"
        );
    }
}

#[test]
fn runs_that_go_wrong_are_runs_that_failed() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    pack(&folder.join("bad.fmu"), Build::Whole, |_| ());
    for (set, parts) in [
        ("nan", &["at time 0.05 s: variable `mass.x`: found NaN"][..]),
        (
            "terminate",
            &["an FMU ended the simulation at 0 s, expected 2 s"],
        ),
        (
            "logger",
            &["fmi2DoStep: found status Error", "the FMU says:"],
        ),
    ] {
        let said = fails(folder, &["--set", &format!("fault={set}")], 1, parts);
        if set == "logger" {
            assert!(said.error.contains("is not UTF-8"), "{}", said.error);
            assert!(
                said.error.contains("more messages were lost"),
                "{}",
                said.error
            );
        }
    }
    // What was recorded before is written.
    let late = [
        "--set",
        "fault=fmi2DoStep:3",
        "--set",
        "faultTime=1",
        "-o",
        "out.csv",
    ];
    fails(folder, &late, 1, &["at time 1 s: fmi2DoStep"]);
    let text = std::fs::read_to_string(folder.join("out.csv")).unwrap();
    assert_eq!(text.lines().count(), 22);
}

#[test]
fn fmus_that_cannot_be_used_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let path = folder.join("bad.fmu");
    for (build, code, part) in [
        (Build::NoInstance, 2, "fmi2Instantiate: found no instance"),
        (Build::WithoutDoStep, 2, "found no function `fmi2DoStep`"),
        (Build::UndefinedSymbol, 2, "undefined symbol"),
        (
            Build::OtherVersion,
            2,
            "fmi2GetVersion: found \"1.0\", expected \"2.0\"",
        ),
        (
            Build::OtherTypes,
            2,
            "fmi2GetTypesPlatform: found \"\", expected \"default\"",
        ),
        (
            Build::SetupFails,
            1,
            "fmi2SetupExperiment: found status Error",
        ),
    ] {
        pack(&path, build, |_| ());
        fails(folder, &[], code, &[part]);
    }
    let edits: [(&str, &str, &str); 6] = [
        (
            "{foreign-oscillator}",
            "{another}",
            "fmi2Instantiate: found no instance",
        ),
        ("<CoSimulation", "<ModelExchange", "found no <CoSimulation>"),
        ("fmiVersion=\"2.0\"", "fmiVersion=\"3.0\"", "2.0"),
        ("</ModelVariables>", "", "modelDescription.xml"),
        (
            "valueReference=\"1\"",
            "valueReference=\"x\"",
            "modelDescription.xml",
        ),
        (
            "modelIdentifier=\"oscillator\"",
            "modelIdentifier=\"../../x\"",
            "expected a C identifier",
        ),
    ];
    for (from, to, part) in edits {
        pack(&path, Build::Whole, |xml| {
            assert!(xml.contains(from), "{from}");
            *xml = xml.replace(from, to);
        });
        fails(folder, &[], 2, &[part]);
    }

    let whole = entries(Build::Whole, |_| ());
    let other: Vec<(&str, Vec<u8>)> = whole
        .iter()
        .map(|(name, bytes)| match name.starts_with("binaries/") {
            true => ("binaries/plan9/oscillator.so", bytes.clone()),
            false => (&**name, bytes.clone()),
        })
        .collect();
    write_archive(&path, &other);
    fails(
        folder,
        &[],
        2,
        &["found binaries for plan9, expected binaries/"],
    );
    write_archive(&path, &other[1..]);
    fails(folder, &[], 2, &["modelDescription.xml"]);
    let text: Vec<(&str, Vec<u8>)> = whole
        .iter()
        .map(|(name, bytes)| match name.starts_with("binaries/") {
            true => (&**name, b"not a library".to_vec()),
            false => (&**name, bytes.clone()),
        })
        .collect();
    write_archive(&path, &text);
    fails(folder, &[], 2, &["expected a shared library"]);
    std::fs::write(&path, "not an archive").unwrap();
    fails(folder, &[], 2, &["bad.fmu"]);
    std::fs::remove_file(&path).unwrap();
    fails(folder, &[], 2, &["bad.fmu"]);
}

#[test]
fn a_scene_is_no_fmu_and_has_a_command_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let said = said(folder.path(), &["simulate", "silo.toml"]);
    assert_eq!(said.code, Some(2), "{}", said.error);
    for part in ["found the scene `silo.toml`", "sphere-dda run silo.toml"] {
        assert!(
            said.error.contains(part),
            "{part} is not in\n{}",
            said.error
        );
    }
}

#[test]
fn several_fmus_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for name in ["good", "bad"] {
        pack(&folder.join(format!("{name}.fmu")), Build::Whole, |_| ());
    }
    let fault = [
        "good.fmu",
        "--set",
        "bad.fault=fmi2DoStep:4",
        "--coupling",
        "gauss-seidel",
    ];
    fails(
        folder,
        &fault,
        1,
        &["at time 0 s: bad: fmi2DoStep: found status Fatal"],
    );
    let units = [
        "good.fmu",
        "--connect",
        "good.mass.x=bad.force[1]",
        "--connect",
        "good.echo=bad.forces",
    ];
    fails(
        folder,
        &units,
        2,
        &["found units `m` and `N`", "did you mean `bad.force[1]`"],
    );
    fails(folder, &["bad.fmu"], 2, &["found two named `bad`"]);
    fails(
        folder,
        &["good.fmu", "--set", "fault=1"],
        2,
        &["expected `<FMU>.<variable>`"],
    );
}

#[test]
fn warnings_about_a_description_are_told_and_are_no_failure() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let inspect = ["inspect", "odd.fmu", "--validate"];
    let outputs = "<Outputs><Unknown index=\"1\"/><Unknown index=\"2\"/>";
    for (found, code, told) in [
        (
            "<Outputs><Unknown index=\"2\"/><Unknown index=\"1\"/>",
            0,
            "warning: ModelStructure/Outputs",
        ),
        (
            "<Outputs><Unknown index=\"2\"/>",
            2,
            "error: ModelStructure/Outputs",
        ),
    ] {
        pack(&folder.join("odd.fmu"), Build::Whole, |xml| {
            assert!(xml.contains(outputs));
            *xml = xml.replace(outputs, found);
        });
        let said = said(folder, &inspect);
        assert!(said.out.contains(told), "{}", said.out);
        assert_eq!(said.code, Some(code), "{}", said.error);
    }
}

#[test]
fn a_temporary_folder_that_cannot_be_used_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    pack(&folder.join("bad.fmu"), Build::Whole, |_| ());
    let mut command = command(folder, &["simulate", "bad.fmu"]);
    let output = command.env("TMPDIR", folder.join("none")).output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(error.contains("cannot unpack to"), "{error}");
    assert!(error.contains("set TMPDIR"), "{error}");
    assert!(!error.contains("export the FMU again"), "{error}");
}
