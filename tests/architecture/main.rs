//! What a script can check of the layout: who may use whom, file size, and what library code must not contain.
//!
//! Every rule is a function from source text to findings, and is shown to find a breach before it is asked
//! about the project.

mod modules;

use std::fs;
use std::path::{Path, PathBuf};

/// Longest source file, in lines.
const LONGEST: usize = 520;

/// Crates and the ones of ours that they must not name.
const CRATES: [(&str, &[&str]); 9] = [
    (
        "interface/src",
        &[
            "sphere_dda_export",
            "sphere_dda_fmu",
            "sphere_dda_master",
            "sphere_dda_model_description",
            "sphere_dda::",
        ],
    ),
    (
        "examples/two_fmus/shaker/src",
        &[
            "sphere_dda_export",
            "sphere_dda_fmu",
            "sphere_dda_master",
            "sphere_dda::",
        ],
    ),
    (
        "src",
        &[
            "sphere_dda_export",
            "sphere_dda_fmu",
            "sphere_dda_master",
            "sphere_dda_model_description",
            "sphere_dda_picture",
            "sphere_dda_studies",
        ],
    ),
    (
        "modelDescription/src",
        &[
            "sphere_dda_export",
            "sphere_dda_fmu",
            "sphere_dda_master",
            "sphere_dda::",
        ],
    ),
    (
        "fmu/src",
        &[
            "sphere_dda_cli",
            "sphere_dda_export",
            "sphere_dda_master",
            "sphere_dda_picture",
            "sphere_dda_studies",
        ],
    ),
    (
        "export/src",
        &["sphere_dda_cli", "sphere_dda_master", "sphere_dda_studies"],
    ),
    (
        "master/src",
        &[
            "sphere_dda_cli",
            "sphere_dda_export",
            "sphere_dda_fmu",
            "sphere_dda_picture",
            "sphere_dda_studies",
            "sphere_dda::",
        ],
    ),
    (
        "picture/src",
        &[
            "sphere_dda_export",
            "sphere_dda_fmu",
            "sphere_dda_master",
            "sphere_dda_model_description",
            "sphere_dda_studies",
            "sphere_dda_cli",
        ],
    ),
    (
        "studies/src",
        &[
            "sphere_dda_export",
            "sphere_dda_fmu",
            "sphere_dda_master",
            "sphere_dda_model_description",
            "sphere_dda_cli",
        ],
    ),
];

/// What library code must not contain: it returns errors and leaves the terminal to the command.
const FORBIDDEN: [&str; 9] = [
    "println!",
    "print!",
    "dbg!",
    ".unwrap()",
    ".expect(",
    "panic!",
    "todo!",
    "unimplemented!",
    "unreachable!",
];

/// Where `unsafe` may stand: the C interface, and the loader of other people's libraries.
const UNSAFE: [&str; 7] = [
    "interface/src/abi2.rs",
    "interface/src/abi3.rs",
    "interface/src/handle.rs",
    "interface/src/pointers.rs",
    "fmu/src/ffi/",
    "master/src/calls/",
    "examples/two_fmus/shaker/src/ffi.rs",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All Rust files below a folder of the project, sorted, with their text.
fn sources(folder: &str) -> Vec<(String, String)> {
    let mut folders = vec![root().join(folder)];
    let mut files: Vec<PathBuf> = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder of the project") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    assert!(!files.is_empty(), "{folder} has no sources");
    let relative = |path: &Path| {
        let path = path.strip_prefix(root()).expect("a path below the root");
        path.to_string_lossy().replace('\\', "/")
    };
    files
        .iter()
        .map(|f| (relative(f), fs::read_to_string(f).expect("UTF-8 source")))
        .collect()
}

/// The lines that are compiled into the library: no comments, nothing from the unit tests on (they come last).
fn code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines()
        .take_while(|line| !["#[cfg(test)]", "#![cfg(test)]"].contains(&line.trim()))
        .map(|line| line.split("//").next().unwrap_or(""))
        .enumerate()
        .map(|(k, line)| (k + 1, line))
}

/// Whether `word` stands in `line` with no identifier character before or after it.
fn names(line: &str, word: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(word).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        let after = line[at + word.len()..].chars().next();
        let starts = word.starts_with(|c: char| !part(c)) || !before.is_some_and(part);
        let ends = word.ends_with(|c: char| !part(c)) || !after.is_some_and(part);
        starts && ends
    })
}

fn breaches_of_crates(file: &str, text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (place, others) in CRATES {
        if file.starts_with(&format!("{place}/")) {
            for (k, line) in code(text) {
                for other in others.iter().filter(|o| names(line, o)) {
                    found.push(format!("{file}:{k} uses {other}"));
                }
            }
        }
    }
    found
}

fn forbidden(file: &str, text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (k, line) in code(text) {
        for word in FORBIDDEN.iter().filter(|w| names(line, w)) {
            found.push(format!(
                "{file}:{k} contains {word}; return an error instead"
            ));
        }
    }
    found
}

fn unordered(file: &str, text: &str) -> Vec<String> {
    code(text)
        .filter(|(_, line)| names(line, "HashMap") || names(line, "HashSet"))
        .map(|(k, _)| format!("{file}:{k}: the order of a hash map differs between runs; use BTreeMap or a sorted Vec"))
        .collect()
}

fn unsafe_outside_the_wall(file: &str, text: &str) -> Vec<String> {
    if UNSAFE.iter().any(|place| file.starts_with(place)) {
        return Vec::new();
    }
    code(text)
        .filter(|(_, line)| {
            names(&line.replace("unsafe-", ""), "unsafe") || line.contains("no_mangle")
        })
        .map(|(k, _)| format!("{file}:{k}: unsafe code belongs into {}", UNSAFE.join(", ")))
        .collect()
}

fn too_long(file: &str, text: &str) -> Vec<String> {
    let lines = text.lines().count();
    if lines <= LONGEST {
        return Vec::new();
    }
    vec![format!(
        "{file} has {lines} lines, at most {LONGEST}: split it by stage"
    )]
}

fn nameless(file: &str, _: &str) -> Vec<String> {
    let vague = ["utils", "util", "common", "misc", "helpers"];
    let found = file.split(['/', '.']).any(|part| vague.contains(&part));
    found
        .then(|| format!("{file}: name it after what it does"))
        .into_iter()
        .collect()
}

type Rule = fn(&str, &str) -> Vec<String>;

/// Applies a rule to folders of the project.
fn hold(rule: Rule, folders: &[&str]) {
    let found: Vec<String> = folders
        .iter()
        .flat_map(|folder| sources(folder))
        .flat_map(|(file, text)| rule(&file, &text))
        .collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

const LIBRARIES: [&str; 8] = [
    "src",
    "modelDescription/src",
    "interface/src",
    "picture/src",
    "studies/src",
    "fmu/src",
    "export/src",
    "master/src",
];
const ALL: [&str; 10] = [
    "src",
    "modelDescription/src",
    "interface/src",
    "picture/src",
    "studies/src",
    "fmu/src",
    "export/src",
    "master/src",
    "cli/src",
    "examples/two_fmus/shaker/src",
];

#[test]
fn crates_point_one_way() {
    hold(breaches_of_crates, &LIBRARIES);
}

#[test]
fn library_code_neither_prints_nor_panics() {
    hold(forbidden, &LIBRARIES);
}

#[test]
fn numerics_iterate_in_a_fixed_order() {
    hold(unordered, &["src"]);
}

#[test]
fn unsafe_stays_at_the_c_boundary() {
    hold(unsafe_outside_the_wall, &ALL);
}

#[test]
fn files_are_short_and_named() {
    hold(too_long, &ALL);
    hold(nameless, &ALL);
}

/// Each rule finds a breach, and passes what only looks like one.
#[test]
fn every_rule_can_fail() {
    let breaches: [(Rule, &str, &str); 12] = [
        (
            breaches_of_crates,
            "src/step.rs",
            "use sphere_dda_fmu::instance;",
        ),
        (
            breaches_of_crates,
            "modelDescription/src/lib.rs",
            "use sphere_dda::scene;",
        ),
        (
            breaches_of_crates,
            "master/src/run/drive.rs",
            "use sphere_dda_fmu::model::Model;",
        ),
        (
            breaches_of_crates,
            "fmu/src/model.rs",
            "use sphere_dda_export::Version;",
        ),
        (
            breaches_of_crates,
            "picture/src/panel.rs",
            "use sphere_dda_studies::table::Table;",
        ),
        (
            unsafe_outside_the_wall,
            "master/src/run/drive.rs",
            "unsafe { *p }",
        ),
        (forbidden, "src/step.rs", "let x = y.unwrap();"),
        (forbidden, "src/step.rs", "    println!(\"{x}\");"),
        (unordered, "src/step.rs", "use std::collections::HashMap;"),
        (unsafe_outside_the_wall, "src/step.rs", "unsafe { *p }"),
        (too_long, "src/step.rs", &"\n".repeat(LONGEST + 1)),
        (nameless, "src/contacts/utils.rs", ""),
    ];
    for (rule, file, text) in breaches {
        assert!(!rule(file, text).is_empty(), "{file}: {text}");
    }
    let clean: [(Rule, &str, &str); 6] = [
        (
            unsafe_outside_the_wall,
            "cli/src/page.rs",
            "let policy = \"script-src 'unsafe-inline'\";",
        ),
        (forbidden, "src/step.rs", "// .unwrap() is for tests"),
        (forbidden, "src/step.rs", "let x = y.unwrap_or(0);"),
        (
            forbidden,
            "src/step.rs",
            "#[cfg(test)]\nmod tests { fn f() { panic!() } }",
        ),
        (
            unsafe_outside_the_wall,
            "fmu/src/ffi/fmi2/mod.rs",
            "unsafe { *p }",
        ),
        (
            unsafe_outside_the_wall,
            "fmu/src/lib.rs",
            "#![deny(unsafe_op_in_unsafe_fn)]",
        ),
    ];
    for (rule, file, text) in clean {
        assert_eq!(rule(file, text), Vec::<String>::new(), "{file}: {text}");
    }
}
