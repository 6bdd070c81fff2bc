//! Imports of a crate run in one direction: in every folder, files and subfolders have a topological order.
//!
//! A path leads to the file that defines what it names: what a `mod.rs` re-exports counts as its own file's.

use std::collections::{BTreeMap, BTreeSet};

use crate::{code, names, sources};

/// The crates whose imports are judged.
const CRATES: [&str; 9] = [
    "src",
    "fmu/src",
    "export/src",
    "master/src",
    "interface/src",
    "modelDescription/src",
    "picture/src",
    "studies/src",
    "cli/src",
];

/// Folders in which entries still import each other in a circle; the list may only shrink.
const TIED: &[&str] = &[];

/// A module path, from the crate's root.
type Module = Vec<String>;

/// A crate as its imports show it.
struct Graph {
    /// File of each module, from the crate's folder.
    files: BTreeMap<Module, String>,
    /// From module to module: the names that are imported.
    imports: BTreeMap<Module, BTreeMap<Module, BTreeSet<String>>>,
}

/// Leaves of a use tree: `a::{b, c::{d, self}}` is `a::b`, `a::c::d` and `a::c`, with the name that each gets.
fn leaves(tree: &str) -> Vec<(String, String)> {
    let tree = tree.trim();
    let Some((head, rest)) = tree.split_once('{') else {
        let (path, name) = tree.split_once(" as ").unwrap_or((tree, ""));
        let path = path.trim().trim_end_matches("::self");
        let own = path.rsplit("::").next().unwrap_or(path);
        let name = if name.is_empty() { own } else { name.trim() };
        return vec![(path.to_owned(), name.to_owned())];
    };
    let (mut depth, mut item, mut found) = (0, String::new(), Vec::new());
    for c in rest.chars() {
        match c {
            '}' if depth == 0 => break,
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if c == ',' && depth == 0 {
            found.extend(leaves(&format!("{head}{}", item.trim())));
            item.clear();
        } else {
            item.push(c);
        }
    }
    if !item.trim().is_empty() {
        found.extend(leaves(&format!("{head}{}", item.trim())));
    }
    found
}

/// Paths in code that is no use item: `a::b::C`.
fn paths(text: &str) -> Vec<String> {
    let part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let words = text.split(|c: char| !part(c));
    words
        .filter(|word| word.contains("::") && word.starts_with(|c: char| c.is_lowercase()))
        .map(|word| word.trim_matches(':').to_owned())
        .collect()
}

/// Module of a file of a crate's folder.
fn module_of(file: &str) -> Module {
    let mut parts: Module = file
        .trim_end_matches(".rs")
        .split('/')
        .map(str::to_owned)
        .collect();
    if matches!(
        parts.last().map(String::as_str),
        Some("mod" | "lib" | "main")
    ) {
        parts.pop();
    }
    parts
}

/// The use items of a file, each with whether it is re-exported, and all other code.
fn split_uses(text: &str) -> (Vec<(bool, String)>, String) {
    let (mut uses, mut rest, mut open) = (Vec::new(), String::new(), None::<(bool, String)>);
    for (_, line) in code(text) {
        let trimmed = line.trim();
        let item = trimmed.strip_prefix("pub").map_or(trimmed, |after| {
            let after = match after.strip_prefix('(') {
                Some(scope) => scope.split_once(')').map_or("", |(_, rest)| rest),
                None => after,
            };
            after.trim_start()
        });
        if let Some((_, tree)) = &mut open {
            tree.push_str(trimmed);
        } else if let Some(tree) = item.strip_prefix("use ") {
            open = Some((trimmed.starts_with("pub"), tree.to_owned()));
        } else {
            rest.push_str(line);
            rest.push('\n');
        }
        if let Some((exported, tree)) = open.take_if(|(_, tree)| tree.ends_with(';')) {
            uses.push((exported, tree.trim_end_matches(';').to_owned()));
        }
    }
    (uses, rest)
}

impl Graph {
    fn of(files: &[(String, String)], folder: &str) -> Self {
        let inside = |file: &str| {
            file.strip_prefix(folder)?
                .strip_prefix('/')
                .map(str::to_owned)
        };
        let texts: BTreeMap<Module, (String, &str)> = files
            .iter()
            .filter_map(|(file, text)| {
                let file = inside(file)?;
                Some((module_of(&file), (file, text.as_str())))
            })
            .collect();
        let known = |module: &Module| texts.contains_key(module);
        let absolute = |module: &Module, path: &str| -> Option<Module> {
            let mut segments: Module = path.split("::").map(str::to_owned).collect();
            let mut base = module.clone();
            match segments[0].as_str() {
                "crate" => base.clear(),
                "self" => {}
                "super" => {
                    while segments.first().is_some_and(|s| s == "super") {
                        base.pop();
                        segments.remove(0);
                    }
                    base.extend(segments);
                    return Some(base);
                }
                first => {
                    let mut child = base.clone();
                    child.push(first.to_owned());
                    return known(&child).then(|| [base, segments].concat());
                }
            }
            base.extend(segments.drain(1..));
            Some(base)
        };
        let mut exports: BTreeMap<Module, BTreeMap<String, Module>> = BTreeMap::new();
        let mut used: BTreeMap<Module, Vec<Module>> = BTreeMap::new();
        for (module, (_, text)) in &texts {
            let (uses, rest) = split_uses(text);
            for (exported, tree) in uses {
                for (path, name) in leaves(&tree) {
                    let Some(target) = absolute(module, &path) else {
                        continue;
                    };
                    if exported {
                        let known = exports.entry(module.clone()).or_default();
                        known.insert(name.clone(), target.clone());
                        // What a face only passes on it does not use.
                        if !names(&rest, &name) {
                            continue;
                        }
                    }
                    used.entry(module.clone()).or_default().push(target);
                }
            }
            let inline = paths(&rest);
            let targets = inline.iter().filter_map(|path| absolute(module, path));
            used.entry(module.clone()).or_default().extend(targets);
        }
        // The module that defines what a path names.
        let resolve = |target: &Module| -> Module {
            let mut target = target.clone();
            for _ in 0..8 {
                let deepest = (0..=target.len())
                    .rev()
                    .find(|&k| known(&target[..k].to_vec()))
                    .unwrap_or(0);
                let module = target[..deepest].to_vec();
                let next = target.get(deepest);
                let next = next.and_then(|name| exports.get(&module)?.get(name));
                match next {
                    Some(next) if *next != target => {
                        target = [next.clone(), target[deepest + 1..].to_vec()].concat();
                    }
                    _ => return module,
                }
            }
            target
        };
        let mut imports: BTreeMap<Module, BTreeMap<Module, BTreeSet<String>>> = BTreeMap::new();
        for (module, targets) in &used {
            for target in targets {
                let other = resolve(target);
                if other != *module && known(&other) {
                    let name = target.last().cloned().unwrap_or_default();
                    let names = imports.entry(module.clone()).or_default();
                    names.entry(other).or_default().insert(name);
                }
            }
        }
        let files = texts
            .into_iter()
            .map(|(module, (file, _))| (module, file))
            .collect();
        Self { files, imports }
    }

    /// All folders of the crate, from its own, which is empty.
    fn folders(&self) -> BTreeSet<Vec<&str>> {
        let folder = |file: &'_ String| file.matches('/').count();
        self.files
            .values()
            .flat_map(|file| {
                let parts: Vec<&str> = file.split('/').collect();
                (0..=folder(file)).map(move |k| parts[..k].to_vec())
            })
            .collect()
    }

    /// The entry of `folder` that holds a module: a file, or a subfolder with the file of its name. The crate's root
    /// names all modules.
    fn entry<'a>(&'a self, folder: &[&str], module: &Module) -> Option<&'a str> {
        let parts: Vec<&str> = self.files.get(module)?.split('/').collect();
        let inside = parts.len() > folder.len() && parts[..folder.len()] == *folder;
        let entry = inside.then(|| parts[folder.len()].trim_end_matches(".rs"))?;
        let root = folder.is_empty() && matches!(entry, "lib" | "main");
        (!root).then_some(entry)
    }

    /// The circles in a folder, told as file -> file: names.
    fn circles(&self, folder: &[&str]) -> Vec<String> {
        let mut edges: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        let mut told: Vec<(&str, &str, String)> = Vec::new();
        for (module, others) in &self.imports {
            for (other, names) in others {
                let ends = (self.entry(folder, module), self.entry(folder, other));
                let (Some(from), Some(to)) = ends else {
                    continue;
                };
                if from != to {
                    edges.entry(from).or_default().insert(to);
                    let names: Vec<&str> = names.iter().map(String::as_str).collect();
                    let files = [module, other].map(|m| self.files[m].as_str());
                    let line = format!("{} -> {}: {}", files[0], files[1], names.join(", "));
                    told.push((from, to, line));
                }
            }
        }
        let reached = |start: &str| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![start.to_owned()]);
            while let Some(next) = open.pop() {
                let to = edges.get(next.as_str()).into_iter().flatten();
                open.extend(
                    to.filter(|other| seen.insert((**other).to_owned()))
                        .map(|other| (*other).to_owned()),
                );
            }
            seen
        };
        let returns =
            |(from, to, line): (&str, &str, String)| reached(to).contains(from).then_some(line);
        told.into_iter().filter_map(returns).collect()
    }
}

#[test]
fn imports_run_in_one_direction() {
    let mut tied = BTreeSet::new();
    for crate_folder in CRATES {
        let graph = Graph::of(&sources(crate_folder), crate_folder);
        for folder in graph.folders() {
            let name = [&[crate_folder], &folder[..]].concat().join("/");
            let circles = graph.circles(&folder);
            if !circles.is_empty() {
                let known = TIED.contains(&name.as_str());
                assert!(known, "{name}: a circle of imports\n{}", circles.join("\n"));
                tied.insert(name);
            }
        }
    }
    for known in TIED.iter().copied() {
        assert!(
            tied.contains(known),
            "{known} is tied no more; take it from the list"
        );
    }
}

/// Circles of files, of folders, by re-export and by path; what only looks like one is none.
#[test]
fn a_circle_is_found_and_named() {
    let file = |name: &str, text: &str| (format!("src/{name}"), text.to_owned());
    let files = [
        file("lib.rs", "pub mod low;\nmod high;\n"),
        file("low.rs", "use crate::high::Other;\n"),
        file(
            "high/mod.rs",
            "mod inner;\nmod shape;\npub use inner::Other;\npub use shape::Shape;\n",
        ),
        file(
            "high/inner.rs",
            "use crate::{\n    ground::Floor,\n    low::{self, Thing},\n};\n",
        ),
        file("high/shape.rs", "use super::Other;\n"),
        file("ground.rs", "// use crate::high::Other;\n"),
        file(
            "top.rs",
            "use crate::high::Other;\n#[cfg(test)]\nuse crate::low;\n",
        ),
    ];
    let graph = Graph::of(&files, "src");
    assert_eq!(
        graph.circles(&[]),
        [
            "high/inner.rs -> low.rs: Thing, low",
            "low.rs -> high/inner.rs: Other"
        ]
    );
    assert!(graph.circles(&["high"]).is_empty());
    let mut files = files.to_vec();
    files[3].1 = "fn f() -> super::shape::Shape {}\n".to_owned();
    let graph = Graph::of(&files, "src");
    assert!(graph.circles(&[]).is_empty());
    assert_eq!(
        graph.circles(&["high"]),
        [
            "high/inner.rs -> high/shape.rs: Shape",
            "high/shape.rs -> high/inner.rs: Other"
        ]
    );
}
