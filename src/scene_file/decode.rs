//! TOML values to the types of [`super::file`], element by element, so that one pass reports every unknown
//! key and every wrong type.

use std::ops::Range;

use miette::Severity;
use serde::de::DeserializeOwned;
use serde_path_to_error::Segment;
use toml::Spanned;
use toml::de::{DeArray, DeValue, ValueDeserializer};

use super::document::{Document, LARGEST, Step, child, did_you_mean, join, split};
use super::file;
use super::keys::keys_of;
use super::wording::mismatch;
use crate::scene::About;

/// Most problems reported for one element: a mistyped list of a million numbers stays readable.
const PROBLEMS_PER_ELEMENT: usize = 20;

/// One element of a list: its name also if the rest of it is unusable, so that references to it are not
/// reported as unknown.
#[derive(Debug)]
pub(super) struct Entry<T> {
    /// `material[2]`.
    pub(super) path: String,
    /// Value of its key `name`.
    pub(super) name: Option<String>,
    /// The element, if its types are right.
    pub(super) value: Option<T>,
}

/// What an element declares to others.
pub(super) struct Declaration<'a> {
    /// Its place in the file.
    pub(super) path: &'a str,
    /// Its name.
    pub(super) name: Option<&'a String>,
    /// Whether its types are right.
    pub(super) usable: bool,
}

impl<T> Entry<T> {
    pub(super) fn declaration(&self) -> Declaration<'_> {
        Declaration {
            path: &self.path,
            name: self.name.as_ref(),
            usable: self.value.is_some(),
        }
    }
}

/// The scene file with right types.
pub(super) struct SceneFile {
    pub(super) title: String,
    pub(super) about: About,
    pub(super) simulation: Option<file::Simulation>,
    pub(super) materials: Vec<Entry<file::Material>>,
    pub(super) pairs: Vec<Entry<file::Pair>>,
    pub(super) pair_default: file::PairDefault,
    pub(super) clumps: Vec<Entry<file::Clump>>,
    pub(super) spheres: Vec<Entry<file::Spheres>>,
    pub(super) sources: Vec<Entry<file::Source>>,
    pub(super) sinks: Vec<Entry<file::Sink>>,
    pub(super) cell: file::Cell,
    pub(super) boundaries: Vec<Entry<file::Boundary>>,
    pub(super) loads: Vec<Entry<file::Load>>,
    pub(super) springs: Vec<Entry<file::Spring>>,
    pub(super) sensors: Vec<Entry<file::Sensor>>,
    pub(super) probes: Vec<Entry<file::Probe>>,
    pub(super) output: file::Output,
    pub(super) fmu: file::Exposed,
}

impl SceneFile {
    /// Decodes `root`, the document with what parameters set, but for the parameters themselves; what is wrong is added to its
    /// problems.
    pub(super) fn decode(document: &mut Document<'_>, root: &Spanned<DeValue<'_>>) -> Self {
        refuse_unknown_tables(document, root.get_ref());
        Self {
            title: optional(document, root, "title").unwrap_or_default(),
            about: about(document, root),
            simulation: simulation(document, root),
            materials: list(document, root, "material"),
            pairs: list(document, root, "pair"),
            pair_default: optional(document, root, "pair_default").unwrap_or_default(),
            clumps: list(document, root, "clump"),
            spheres: list(document, root, "spheres"),
            sources: list(document, root, "source"),
            sinks: list(document, root, "sink"),
            cell: optional(document, root, "cell").unwrap_or_default(),
            boundaries: list(document, root, "boundary"),
            loads: list(document, root, "load"),
            springs: list(document, root, "spring"),
            sensors: list(document, root, "sensor"),
            probes: list(document, root, "probe"),
            output: optional(document, root, "output").unwrap_or_default(),
            fmu: optional(document, root, "fmu").unwrap_or_default(),
        }
    }
}

/// The entries of `[[parameter]]`.
pub(super) fn parameters(document: &mut Document<'_>) -> Vec<Entry<file::Parameter>> {
    let root = document.root().clone();
    list(document, &root, "parameter")
}

/// What its author says of the scene; an empty text says nothing.
fn about(document: &mut Document<'_>, root: &Spanned<DeValue<'_>>) -> About {
    let mut text = |key| optional(document, root, key).filter(|text: &String| !text.is_empty());
    About {
        description: text("description"),
        author: text("author"),
        version: text("version"),
        copyright: text("copyright"),
        license: text("license"),
    }
}

fn refuse_unknown_tables(document: &mut Document<'_>, root: &DeValue<'_>) {
    let Some(table) = root.as_table() else { return };
    let tables = keys_of::<file::TopLevel>();
    for key in table.keys() {
        let name: &str = key.get_ref();
        if !tables.contains(&name) {
            let suggestion = did_you_mean(name, tables.iter().copied());
            let help = format!("{suggestion}known: {}", tables.join(", "));
            let message = format!("unknown key `{name}`");
            document.report(Severity::Error, name.to_owned(), key.span(), message, help);
        }
    }
}

fn simulation(
    document: &mut Document<'_>,
    root: &Spanned<DeValue<'_>>,
) -> Option<file::Simulation> {
    if child(root, &Step::Key("simulation".into())).is_none() {
        let help = "add `[simulation]` with `duration` in seconds";
        document.error("simulation", "missing table `[simulation]`", help);
    }
    optional(document, root, "simulation")
}

fn optional<T: DeserializeOwned>(
    document: &mut Document<'_>,
    root: &Spanned<DeValue<'_>>,
    key: &str,
) -> Option<T> {
    let value = child(root, &Step::Key(key.into()))?;
    element(document, value, key)
}

fn list<T: DeserializeOwned>(
    document: &mut Document<'_>,
    root: &Spanned<DeValue<'_>>,
    key: &str,
) -> Vec<Entry<T>> {
    let Some(value) = child(root, &Step::Key(key.into())) else {
        return Vec::new();
    };
    let Some(array) = value.get_ref().as_array() else {
        let found = value.get_ref().type_str();
        let help = format!("write `[[{key}]]` with double brackets, once per {key}");
        document.error(
            key,
            format!("found {found}, expected a table with double brackets"),
            help,
        );
        return Vec::new();
    };
    let elements = array.iter().enumerate().map(|(i, value)| {
        let path = format!("{key}[{i}]");
        let name = child(value, &Step::Key("name".into()));
        Entry {
            name: name.and_then(|n| n.get_ref().as_str()).map(str::to_owned),
            value: element(document, value, &path),
            path,
        }
    });
    elements.collect()
}

/// Decodes one value. After an error the faulty part is cut out and the rest is tried again, until nothing is
/// left to complain about.
fn element<T: DeserializeOwned>(
    document: &mut Document<'_>,
    value: &Spanned<DeValue<'_>>,
    path: &str,
) -> Option<T> {
    let mut sound = refuse_unfit(document, value, path);
    let mut rest = value.clone();
    let mut cut: Vec<Vec<Step>> = Vec::new();
    for _ in 0..PROBLEMS_PER_ELEMENT {
        let error = match serde_path_to_error::deserialize(ValueDeserializer::from(rest.clone())) {
            Ok(decoded) => return sound.then_some(decoded),
            Err(error) => error,
        };
        let mut steps = steps_of(error.path());
        let place = original(value, &rest, &steps);
        let message = error.inner().message();
        let unknown = between_ticks(message, "unknown field `");
        if let Some(key) = unknown {
            if steps.last() != Some(&Step::Key(key.to_owned())) {
                steps.push(Step::Key(key.to_owned()));
            }
            let place = original(value, &rest, &steps);
            let span = error.inner().span().unwrap_or(value.span());
            let help = alternatives(message, key);
            document.report(
                Severity::Error,
                join(path, &place),
                span,
                format!("unknown key `{key}`"),
                help,
            );
        } else {
            sound = false;
            let missing = between_ticks(message, "missing field `");
            let follows = cut.iter().any(|c| match missing {
                Some(key) => c.split_last() == Some((&Step::Key(key.to_owned()), place.as_slice())),
                None => c.len() > place.len() && c.starts_with(&place),
            });
            if !follows {
                let span = span_of(value, &place);
                let (mut message, help) = reword(message, missing);
                let mut shown = place.clone();
                if missing.is_none() && help.is_empty() {
                    (message, shown) = clean(&message, path, value, shown);
                }
                document.report(Severity::Error, join(path, &shown), span, message, help);
            }
            cut.push(place);
        }
        if !remove(&mut rest, &steps) {
            return None;
        }
    }
    None
}

fn reword(message: &str, missing: Option<&str>) -> (String, String) {
    if let Some(key) = missing {
        return (format!("missing key `{key}`"), format!("add `{key} = ...`"));
    }
    let found = between_ticks(message, "unknown variant `");
    let help = found.map_or(String::new(), |found| alternatives(message, found));
    match found {
        Some(found) => {
            let expected = message.split_once(", expected ").map_or("", |(_, e)| e);
            (format!("found `{found}`, expected {expected}"), help)
        }
        None => (
            message.replacen("invalid type: ", "found ", 1).replacen(
                "invalid value: ",
                "found ",
                1,
            ),
            help,
        ),
    }
}

/// A message without names of types, what was found and what the key takes, and the steps to the value it is about.
fn clean(
    message: &str,
    path: &str,
    value: &Spanned<DeValue<'_>>,
    mut steps: Vec<Step>,
) -> (String, Vec<Step>) {
    // Lists of a fixed length say themselves what they are.
    let length = message.strip_prefix("invalid length ");
    if let Some((n, expected)) = length.and_then(|rest| rest.split_once(", expected "))
        && !expected.starts_with("struct ")
    {
        return (format!("found {n} of them, expected {expected}"), steps);
    }
    // The named option of a choice may be no key of the file, or of the schema.
    loop {
        let (depth, found) = deepest(value, &steps);
        steps.truncate(depth);
        let whole = [split(path), steps.clone()].concat();
        if let Some(message) = mismatch(&whole, found) {
            return (message, steps);
        }
        if steps.pop().is_none() {
            return (message.to_owned(), steps);
        }
    }
}

/// How many of `steps` lead to a value that exists, and that value.
fn deepest<'v, 't>(value: &'v Spanned<DeValue<'t>>, steps: &[Step]) -> (usize, &'v DeValue<'t>) {
    let mut place = value;
    for (depth, step) in steps.iter().enumerate() {
        match child(place, step) {
            Some(next) => place = next,
            None => return (depth, place.get_ref()),
        }
    }
    (steps.len(), place.get_ref())
}

/// The names serde lists after `expected`, with a suggestion first.
fn alternatives(message: &str, found: &str) -> String {
    let expected = message.split_once(", expected ").map_or("", |(_, e)| e);
    let names: Vec<&str> = expected.split('`').skip(1).step_by(2).collect();
    if names.is_empty() {
        return "remove it".to_owned();
    }
    format!(
        "{}known: {}",
        did_you_mean(found, names.iter().copied()),
        names.join(", ")
    )
}

fn between_ticks<'m>(message: &'m str, before: &str) -> Option<&'m str> {
    message.strip_prefix(before)?.split('`').next()
}

fn steps_of(path: &serde_path_to_error::Path) -> Vec<Step> {
    let steps = path.iter().filter_map(|segment| match segment {
        Segment::Map { key } => Some(Step::Key(key.clone())),
        Segment::Enum { variant } => Some(Step::Key(variant.clone())),
        Segment::Seq { index } => Some(Step::Index(*index)),
        Segment::Unknown => None,
    });
    steps.collect()
}

/// The path in the file of a path in what is left of it: removed array elements shift the later ones.
fn original(file: &Spanned<DeValue<'_>>, rest: &Spanned<DeValue<'_>>, steps: &[Step]) -> Vec<Step> {
    let (mut file, mut rest) = (Some(file), Some(rest));
    let mut path = Vec::with_capacity(steps.len());
    for step in steps {
        rest = rest.and_then(|r| child(r, step));
        let mut here = step.clone();
        if let (Step::Index(_), Some(array), Some(rest)) =
            (step, file.and_then(|f| f.get_ref().as_array()), rest)
            && let Some(index) = array.iter().position(|v| v.span() == rest.span())
        {
            here = Step::Index(index);
        }
        file = file.and_then(|f| child(f, &here));
        path.push(here);
    }
    path
}

fn span_of(value: &Spanned<DeValue<'_>>, steps: &[Step]) -> Range<usize> {
    let mut place = value;
    for step in steps {
        let Some(next) = child(place, step) else {
            break;
        };
        place = next;
    }
    place.span()
}

/// Removes the value at `steps`, or the deepest one above it that exists; false if that is all of it.
fn remove(value: &mut Spanned<DeValue<'_>>, steps: &[Step]) -> bool {
    let Some((step, below)) = steps.split_first() else {
        return false;
    };
    match (value.get_mut(), step) {
        (DeValue::Table(table), Step::Key(key)) => match table.get_mut(key.as_str()) {
            Some(next) => remove(next, below) || table.remove(key.as_str()).is_some(),
            None => false,
        },
        (DeValue::Array(array), Step::Index(index)) => match array.get_mut(*index) {
            Some(next) => {
                if !remove(next, below) {
                    let entries = std::mem::replace(array, DeArray::new())
                        .into_iter()
                        .enumerate();
                    for (_, entry) in entries.filter(|(i, _)| i != index) {
                        array.push(entry);
                    }
                }
                true
            }
            None => false,
        },
        _ => false,
    }
}

/// Reports numbers that are not finite or too large, and texts with control characters, which a terminal would obey; whether
/// there are none.
fn refuse_unfit(document: &mut Document<'_>, value: &Spanned<DeValue<'_>>, path: &str) -> bool {
    let (message, help) = match value.get_ref() {
        DeValue::Float(number) if !is_finite(number.as_str()) => {
            let expected = format!("expected a finite number, at most {LARGEST:e}");
            (format!("found {number}, {expected}"), "")
        }
        DeValue::String(text) if text.contains(|c| is_control(c, path)) => {
            let message = format!("found {text:?}, expected a text without control characters");
            (
                message,
                "a `description` alone may have line breaks and tabs",
            )
        }
        DeValue::Array(array) => {
            let mut fit = true;
            for (i, entry) in array.iter().enumerate() {
                fit &= refuse_unfit(document, entry, &format!("{path}[{i}]"));
            }
            return fit;
        }
        DeValue::Table(table) => {
            let mut fit = true;
            for (key, entry) in table {
                fit &= refuse_unfit(document, entry, &format!("{path}.{}", key.get_ref()));
            }
            return fit;
        }
        _ => return true,
    };
    let (path, help) = (path.to_owned(), help.to_owned());
    document.report(Severity::Error, path, value.span(), message, help);
    false
}

fn is_finite(number: &str) -> bool {
    number.parse::<f64>().is_ok_and(|x| x.abs() <= LARGEST)
}

fn is_control(c: char, path: &str) -> bool {
    c.is_control() && !(path == "description" && matches!(c, '\n' | '\t'))
}
