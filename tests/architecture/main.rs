//! What a script can check of the layout: who may use whom, file size, and what library code must not contain.
//!
//! Every rule is a function from source text to findings, and is shown to find a breach before it is asked
//! about the project.

mod modules;

use std::fs;
use std::path::{Path, PathBuf};

/// Longest source file, in lines.
const LONGEST: usize = 520;

/// Modules of the solver crate that may not use certain others, and why.
const SEPARATE: [(&str, &[&str], &str); 6] = [
    (
        "contacts/law.rs",
        &[
            "boundaries",
            "contacts",
            "drive",
            "error",
            "integrate",
            "linalg",
            "materials",
            "motion",
            "observe",
            "particles",
            "problem",
            "scene",
            "simulation",
            "solver",
            "state",
            "step",
        ],
        "the contact law is pure: numbers in, numbers out",
    ),
    (
        "linalg",
        &[
            "boundaries",
            "contacts",
            "drive",
            "error",
            "integrate",
            "materials",
            "motion",
            "observe",
            "particles",
            "problem",
            "scene",
            "simulation",
            "solver",
            "state",
            "step",
        ],
        "linear algebra knows matrices only",
    ),
    (
        "solver",
        &[
            "particles",
            "boundaries",
            "materials",
            "motion",
            "drive",
            "observe",
            "simulation",
            "state",
            "step",
            "contacts::narrow_phase",
            "contacts::broad_phase",
            "contacts::history",
            "scene::Scene",
            "scene::Settings",
            "scene::file",
        ],
        "a solver sees the problem, not the spheres behind it",
    ),
    (
        "boundaries",
        &[
            "contacts",
            "observe",
            "problem",
            "simulation",
            "solver",
            "step",
        ],
        "geometry comes before contact",
    ),
    (
        "scene",
        &[
            "observe::Observation",
            "observe::energy",
            "observe::frames",
            "observe::history",
            "observe::sensors",
            "observe::writer",
            "problem",
            "simulation",
            "solver",
            "step",
        ],
        "a scene is data that a run reads; of results it knows the states and files a run may start from",
    ),
    (
        "problem",
        &["observe", "simulation", "state", "step"],
        "a problem is the algebra of one step",
    ),
];

/// Crates and the ones of ours that they must not name.
const CRATES: [(&str, &[&str]); 8] = [
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
            "sphere_dda_report",
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
            "sphere_dda_report",
        ],
    ),
    (
        "export/src",
        &["sphere_dda_cli", "sphere_dda_master", "sphere_dda_report"],
    ),
    (
        "master/src",
        &[
            "sphere_dda_cli",
            "sphere_dda_export",
            "sphere_dda_fmu",
            "sphere_dda_report",
            "sphere_dda::",
        ],
    ),
    (
        "report/src",
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
const UNSAFE: [&str; 6] = [
    "interface/src/abi2.rs",
    "interface/src/abi3.rs",
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

/// Modules `a::b` that a line reaches through `crate::`, groups such as `crate::{a, b::c}` included.
fn uses(line: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, start) in line.match_indices("crate::") {
        let rest = &line[at + start.len()..];
        let Some(group) = rest.strip_prefix('{') else {
            found.push(path_of(rest));
            continue;
        };
        let (mut depth, mut item) = (0, String::new());
        for c in group.chars() {
            match c {
                ',' | '}' if depth == 0 => found.push(path_of(&std::mem::take(&mut item))),
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            if !(depth == 0 && (c == ',' || c == '}')) {
                item.push(c);
            }
        }
    }
    // `use crate::scene::{A, B}` reaches `scene::A` and `scene::B`.
    let mut flat = Vec::new();
    for path in found {
        match path.split_once("::{") {
            Some((head, list)) => {
                let items = list.trim_end_matches('}').split(',');
                flat.extend(items.map(|i| format!("{head}::{}", i.trim())));
            }
            None => flat.push(path),
        }
    }
    flat
}

/// The path at the start of a text.
fn path_of(text: &str) -> String {
    let end = text
        .find(|c: char| !(c.is_alphanumeric() || "_:{, }".contains(c)))
        .unwrap_or(text.len());
    text[..end].trim().trim_end_matches("::").to_owned()
}

/// Its lines of code; `use` items that rustfmt has broken over several lines count as one line.
fn items(text: &str) -> Vec<(usize, String)> {
    let mut joined: Vec<(usize, String)> = Vec::new();
    let mut open = false;
    for (k, line) in code(text) {
        match joined.last_mut().filter(|_| open) {
            Some((_, item)) => item.push_str(line.trim()),
            None => joined.push((k, line.trim().to_owned())),
        }
        let item = joined.last().map_or("", |(_, item)| item);
        open = item.contains("use crate::") && !item.contains(';');
    }
    joined
}

fn breaches_of_separation(file: &str, text: &str) -> Vec<String> {
    let joined = items(text);
    let module = file.trim_start_matches("src/");
    let mut found = Vec::new();
    for (place, others, why) in SEPARATE {
        if module != place && !module.starts_with(&format!("{place}/")) {
            continue;
        }
        for (k, line) in &joined {
            for used in uses(line) {
                for other in others {
                    if used == *other || used.starts_with(&format!("{other}::")) {
                        found.push(format!("{file}:{k} uses {used}; {why}"));
                    }
                }
            }
        }
    }
    found
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
        .filter(|(_, line)| names(line, "unsafe") || line.contains("no_mangle"))
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

const LIBRARIES: [&str; 7] = [
    "src",
    "modelDescription/src",
    "interface/src",
    "report/src",
    "fmu/src",
    "export/src",
    "master/src",
];
const ALL: [&str; 9] = [
    "src",
    "modelDescription/src",
    "interface/src",
    "report/src",
    "fmu/src",
    "export/src",
    "master/src",
    "cli/src",
    "examples/two_fmus/shaker/src",
];

#[test]
fn modules_use_only_what_comes_before_them() {
    hold(breaches_of_separation, &["src"]);
}

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
    let breaches: [(Rule, &str, &str); 16] = [
        (
            breaches_of_separation,
            "src/contacts/law.rs",
            "use crate::scene::Scene;",
        ),
        (
            breaches_of_separation,
            "src/linalg/mod.rs",
            "use crate::problem::Row;",
        ),
        (
            breaches_of_separation,
            "src/solver/mod.rs",
            "use crate::{Vec3, particles::Particles};",
        ),
        (
            breaches_of_separation,
            "src/solver/mod.rs",
            "let x: crate::scene::Scene;",
        ),
        (
            breaches_of_separation,
            "src/solver/x.rs",
            "use crate::scene::{\n    Scene, Tolerance,\n};",
        ),
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
    let clean: [(Rule, &str, &str); 7] = [
        (
            breaches_of_separation,
            "src/solver/mod.rs",
            "use crate::scene::{SolverKind, Tolerance};",
        ),
        (
            breaches_of_separation,
            "src/contacts/law.rs",
            "use crate::Vec3;",
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
