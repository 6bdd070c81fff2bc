//! Modules of a crate import each other in one direction: their graph has a topological order.

use std::collections::{BTreeMap, BTreeSet};

use crate::{items, sources, uses};

/// Modules of each crate that still import each other in a circle; the lists may only shrink.
const TIED: [(&str, &[&str]); 7] = [
    (
        "src",
        &[
            "boundaries",
            "contacts",
            "drive",
            "driven",
            "gravity",
            "integrate",
            "motion",
            "observe",
            "problem",
            "region",
            "scene",
            "simulation",
            "solver",
            "state",
            "step",
        ],
    ),
    ("export/src", &[]),
    ("fmu/src", &[]),
    ("interface/src", &[]),
    ("master/src", &[]),
    ("modelDescription/src", &[]),
    ("report/src", &[]),
];

/// Module -> module it imports -> the files that do.
type Imports = BTreeMap<String, BTreeMap<String, Vec<String>>>;

/// The top-level modules of a crate and what they import. What the crate's root re-exports counts as its module.
fn imports(files: &[(String, String)], folder: &str) -> Imports {
    let inside = |file: &str| {
        let path = file.strip_prefix(folder).and_then(|f| f.strip_prefix('/'));
        path.map(|path| {
            path.split('/')
                .next()
                .unwrap_or(path)
                .trim_end_matches(".rs")
                .to_owned()
        })
    };
    let modules: BTreeSet<String> = files.iter().filter_map(|(file, _)| inside(file)).collect();
    let mut exported = BTreeMap::new();
    for (_, text) in files
        .iter()
        .filter(|(file, _)| file.ends_with("src/lib.rs"))
    {
        for (_, line) in items(text) {
            let Some((module, names)) = line
                .strip_prefix("pub use ")
                .and_then(|u| u.split_once("::"))
            else {
                continue;
            };
            for name in names.split(|c: char| !(c.is_alphanumeric() || c == '_')) {
                exported.insert(name.to_owned(), module.to_owned());
            }
        }
    }
    let mut found = Imports::new();
    for (file, text) in files {
        let Some(module) = inside(file).filter(|module| module != "lib") else {
            continue;
        };
        for used in items(text).iter().flat_map(|(_, line)| uses(line)) {
            let first = used.split("::").next().unwrap_or_default();
            let other = exported.get(first).map_or(first, String::as_str);
            if other != module && modules.contains(other) {
                let places = found.entry(module.clone()).or_default();
                let places = places.entry(other.to_owned()).or_default();
                if places.last() != Some(file) {
                    places.push(file.clone());
                }
            }
        }
    }
    found
}

/// The modules that import themselves by way of others.
fn tied(imports: &Imports) -> BTreeSet<String> {
    let returns = |module: &&String| {
        let mut reached: BTreeSet<&String> = BTreeSet::new();
        let mut open = vec![*module];
        while let Some(next) = open.pop() {
            let to = imports.get(next).into_iter().flat_map(BTreeMap::keys);
            open.extend(to.filter(|other| reached.insert(other)));
        }
        reached.contains(module)
    };
    imports.keys().filter(returns).cloned().collect()
}

/// The imports among `tied` modules, one a line.
fn ties(imports: &Imports, tied: &BTreeSet<String>) -> String {
    let mut lines = Vec::new();
    for (module, to) in imports.iter().filter(|(module, _)| tied.contains(*module)) {
        for (other, files) in to.iter().filter(|(other, _)| tied.contains(*other)) {
            lines.push(format!("{module} -> {other} ({})", files.join(", ")));
        }
    }
    lines.join("\n")
}

#[test]
fn modules_import_in_one_direction() {
    for (folder, known) in TIED {
        let imports = imports(&sources(folder), folder);
        let found = tied(&imports);
        let known: BTreeSet<String> = known.iter().map(|&module| module.to_owned()).collect();
        assert!(
            found.is_subset(&known),
            "{folder}: {:?} import each other in a circle:\n{}",
            &found - &known,
            ties(&imports, &found)
        );
        assert!(
            known.is_subset(&found),
            "{folder}: {:?} are tied no more; take them from the list",
            &known - &found
        );
    }
}

/// A circle of two and what hangs on it; what lies between two circles, or beside one, is in none.
#[test]
fn a_circle_is_found_and_named() {
    let file = |name: &str, text: &str| (format!("src/{name}"), text.to_owned());
    let files = [
        file("lib.rs", "pub use low::Thing;\npub mod low;\n"),
        file("low.rs", "use crate::high::Other;\n"),
        file("high/mod.rs", "use crate::{Thing,\n    ground::Floor};\n"),
        file("ground.rs", "// use crate::high::Other;\n"),
        file(
            "top.rs",
            "use crate::high::Other;\n#[cfg(test)]\nuse crate::low;\n",
        ),
    ];
    let imports = imports(&files, "src");
    let found = tied(&imports);
    assert_eq!(Vec::from_iter(&found), ["high", "low"]);
    assert_eq!(
        ties(&imports, &found),
        "high -> low (src/high/mod.rs)\nlow -> high (src/low.rs)"
    );
}
