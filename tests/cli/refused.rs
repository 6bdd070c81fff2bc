//! Bad command lines and files: one clear message, exit code 2, nothing written.

use std::fs;
use std::path::Path;

use crate::command::{done, funnel, said};

/// Puts what the cases need into `folder`.
fn prepare(folder: &Path) {
    let scene = funnel(folder, &[]);
    done(folder, &["export", scene.to_str().unwrap()]);
    let bad = fs::read_to_string(&scene)
        .unwrap()
        .replacen("radius = 0.25", "radius = -1", 1);
    fs::write(folder.join("bad.toml"), bad).unwrap();
    let plain = fs::read_to_string(&scene)
        .unwrap()
        .replacen("penalty = 1e5", "", 1);
    fs::write(folder.join("no_penalty.toml"), plain).unwrap();
    fs::write(folder.join("text.fmu"), "no archive").unwrap();
    fs::write(folder.join("text.ssp"), "no archive").unwrap();
    fs::write(folder.join("broken.toml"), "title = ").unwrap();
    fs::write(folder.join("bytes.toml"), [0xff, 0xfe, 0x00]).unwrap();
    fs::write(folder.join("drive.csv"), "time,nothing\n0,1\n").unwrap();
    fs::write(folder.join("library.so"), "no library").unwrap();
    fs::write(folder.join("file"), "a file").unwrap();
    fs::create_dir(folder.join("folder")).unwrap();
}

#[test]
fn bad_command_lines_and_files_exit_with_2_and_say_why() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    prepare(folder);
    let before = names(folder);
    let cases: &[(&str, &str)] = &[
        ("", "Usage"),
        ("rum funnel.toml", "unrecognized subcommand"),
        ("simulate text.ssp", "text.ssp: "),
        ("simulate text.ssp funnel.fmu", "one SSP alone"),
        (
            "simulate funnel.fmu --coupling-tolerance 1e-3",
            "--coupling-tolerance: found another coupling, expected `--coupling iterated`",
        ),
        (
            "simulate funnel.fmu --coupling iterated --max-iterations 0",
            "at least 1 iteration",
        ),
        // Their names up to version 0.1.
        (
            "simulate funnel.fmu --tolerance 1e-3",
            "--coupling-tolerance: found another coupling",
        ),
        (
            "simulate funnel.fmu --go-on",
            "--accept-unconverged: found another coupling",
        ),
        (
            "simulate funnel.fmu --coupling iterated --iterations 0",
            "at least 1 iteration",
        ),
        ("run", "required arguments"),
        ("run funnel.toml", "--output"),
        ("run funnel.toml -o out --stop 0", "greater than 0"),
        ("run funnel.toml -o out --stop -1", "greater than 0"),
        ("run funnel.toml -o out --stop nan", "greater than 0"),
        ("run funnel.toml -o out --stop inf", "greater than 0"),
        ("run funnel.toml -o out --solver magic", "gauss-seidel"),
        (
            "run funnel.toml -o out --method none",
            "possible values: alm, penalty",
        ),
        (
            "run no_penalty.toml -o out --method penalty",
            "add it to [simulation]",
        ),
        ("run missing.toml -o out", "cannot read the file"),
        ("run folder -o out", "cannot read the file"),
        ("run bytes.toml -o out", "UTF-8"),
        ("run broken.toml -o out", "broken.toml"),
        ("run bad.toml -o out", "spheres[0].radius"),
        ("run funnel.toml -o file", "cannot create `file`"),
        ("run funnel.toml -o file/out", "cannot create `file/out`"),
        ("check", "required arguments"),
        ("check text.fmu", "text.fmu"),
        ("export bad.toml", "spheres[0].radius"),
        ("export missing.toml", "cannot read the file"),
        ("export funnel.toml", "exists already"),
        (
            "export funnel.toml -o funnel.toml --overwrite",
            "ends with .fmu",
        ),
        ("export funnel.toml -o folder", "ends with .fmu"),
        (
            "export funnel.toml -o no/such/folder/x.fmu",
            "no/such/folder",
        ),
        (
            "export funnel.toml -o x.fmu --library library.so",
            "library.so",
        ),
        (
            "export funnel.toml -o x.fmu --library missing.so",
            "missing.so",
        ),
        ("inspect missing.fmu", "missing.fmu"),
        ("inspect text.fmu", "text.fmu"),
        ("inspect folder", "folder"),
        ("simulate text.fmu", "text.fmu"),
        ("simulate funnel.fmu --step 0", "step 0 s"),
        ("simulate funnel.fmu --step -0.1", "step -0.1 s"),
        ("simulate funnel.fmu --stop nan", "stop NaN s"),
        (
            "simulate funnel.fmu --start 9 --stop 8",
            "stop not before start",
        ),
        ("simulate funnel.fmu --stop soon", "invalid"),
        ("simulate funnel.fmu --record nothing", "`nothing`"),
        (
            "simulate funnel.fmu --record nothing -o new.csv",
            "`nothing`",
        ),
        ("simulate funnel.fmu --set nothing=1", "`nothing`"),
        ("simulate funnel.fmu --set output.interval=often", "often"),
        ("simulate funnel.fmu --set output.interval", "NAME=VALUE"),
        ("simulate funnel.fmu --set mass=1", "mass"),
        ("simulate funnel.fmu --input missing.csv", "missing.csv"),
        ("simulate funnel.fmu --input drive.csv", "nothing"),
        ("simulate funnel.fmu -o folder", "exists already"),
        (
            "simulate funnel.fmu -o folder --overwrite",
            "cannot write `folder`",
        ),
        (
            "simulate funnel.fmu -o no/such/folder/o.csv",
            "cannot write",
        ),
        ("simulate funnel.fmu --overwrite", "--output"),
        ("view missing", "`missing` does not exist"),
        ("view folder", "`folder` is no result folder"),
        ("view folder", "run.json"),
        ("view file", "ends with .toml"),
        ("view funnel.toml -o page.txt", "ends with .html"),
        (
            "view funnel.toml -o no/such/folder/p.html",
            "cannot write `no/such/folder/p.html`",
        ),
        ("view funnel.toml --max-size much", "a size like 50MB"),
        ("view funnel.toml --max-size 1kB", "--max-size"),
        (
            "view funnel.toml --table missing.csv",
            "table `missing.csv`",
        ),
        ("view funnel.fmu --watch", "expected a scene file"),
        ("view text.fmu", "text.fmu"),
        ("simulate funnel.fmu --view p.txt", "ends with .html"),
        (
            "simulate funnel.fmu --view p.html --set output.directory=o",
            "expected one of them",
        ),
        ("movie funnel.toml -o film.avi", ".mp4, .gif or .png"),
        ("movie funnel.toml -o p.png --size 3x4", "WIDTHxHEIGHT"),
        ("demo -o file", "cannot use `file`"),
        ("demo extra", "unexpected argument"),
        ("demo --stop 0", "greater than 0"),
    ];
    for (line, part) in cases {
        let arguments: Vec<&str> = line.split_whitespace().collect();
        let said = said(folder, &arguments);
        assert_eq!(said.code, Some(2), "`{line}`: {}", said.error);
        assert!(
            said.error.contains(part),
            "`{line}` does not say `{part}`:\n{}",
            said.error
        );
        assert!(said.out.is_empty(), "`{line}` prints {}", said.out);
    }
    assert_eq!(names(folder), before);
}

#[test]
fn simulate_tells_all_that_it_cannot_set_or_record() {
    let folder = tempfile::tempdir().unwrap();
    prepare(folder.path());
    let said = said(
        folder.path(),
        &[
            "simulate",
            "funnel.fmu",
            "--set",
            "solver.tolerance.gap=-1",
            "--set",
            "solver.maxSweps=3",
            "--set",
            "solver.kind=Newton",
            "--set",
            "solver.step=0.001",
            "--set",
            "mass=1",
            "--set",
            "gravity[3]=down",
            "--record",
            "maxOverlp",
        ],
    );
    assert_eq!(said.code, Some(2), "{}", said.error);
    let told: Vec<&str> = said
        .error
        .lines()
        .map(|line| line.trim_matches(['×', '│', ' ']))
        .filter(|line| !line.is_empty())
        .collect();
    let expected = [
        "variable `solver.tolerance.gap`: found \"-1\", expected a number from 1e-12 to 0.1",
        "variable: found `solver.maxSweps`, expected a name in the model description: did you mean `solver.maxSweeps`",
        "variable `solver.kind`: found \"Newton\", expected an item of `Auto`, `Direct`, `GaussSeidel`",
        "variable `mass`: found a variable of causality Local and variability Continuous, expected a parameter",
        "variable `gravity[3]`: found \"down\", expected a finite number",
        "variable: found `maxOverlp`, expected a name in the model description: did you mean `maxOverlap`",
    ];
    assert_eq!(told.len(), expected.len(), "{}", said.error);
    for (told, expected) in told.iter().zip(expected) {
        assert!(told.starts_with(expected), "{told}");
    }
}

/// What lies in a folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}
