//! Names in a scene and what refers to them.

use std::ops::Range;

use super::decode::{Declaration, Entry};
use super::document::{Document, did_you_mean};

/// The names declared by one kind of element. An element that is unusable for another reason still declares its
/// name, so that references to it are not reported.
pub(super) struct Names {
    kind: &'static str,
    names: Vec<Option<String>>,
    usable: Vec<bool>,
}

impl Names {
    pub(super) fn declare<T>(
        document: &mut Document<'_>,
        kind: &'static str,
        elements: &[Entry<T>],
    ) -> Self {
        Self::declare_all(document, kind, elements.iter().map(Entry::declaration))
    }

    /// The same for elements of several lists that share their names.
    pub(super) fn declare_all<'a>(
        document: &mut Document<'_>,
        kind: &'static str,
        elements: impl Iterator<Item = Declaration<'a>>,
    ) -> Self {
        let elements: Vec<_> = elements.collect();
        let names: Vec<_> = elements.iter().map(|e| e.name.cloned()).collect();
        for (i, element) in elements.iter().enumerate() {
            let Some(name) = element.name else { continue };
            let path = format!("{}.name", element.path);
            let mut letters = name.chars();
            let starts = letters
                .next()
                .is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
            let valid = starts && letters.all(|c| c.is_ascii_alphanumeric() || c == '_');
            let found = format!("`{name}`");
            document.demand(
                valid,
                path.as_str(),
                found,
                "a name of letters, digits and `_` that does not start with a digit",
            );
            if let Some(first) = names[..i].iter().position(|n| n.as_ref() == Some(name)) {
                let help = format!(
                    "`{}` has this name already; names are unique per kind",
                    elements[first].path
                );
                document.error(path, format!("{kind} `{name}` appears twice"), help);
            }
        }
        Self::of(kind, elements.into_iter())
    }

    /// Names that are judged elsewhere.
    pub(super) fn of<'a>(
        kind: &'static str,
        elements: impl Iterator<Item = Declaration<'a>>,
    ) -> Self {
        let (names, usable) = elements.map(|e| (e.name.cloned(), e.usable)).unzip();
        Self {
            kind,
            names,
            usable,
        }
    }

    /// The index of `name`; reports an unknown one at `path`.
    pub(super) fn resolve(
        &self,
        document: &mut Document<'_>,
        path: &str,
        name: &str,
    ) -> Option<usize> {
        let known = || self.names.iter().flatten().map(String::as_str);
        let Some(index) = self.names.iter().position(|n| n.as_deref() == Some(name)) else {
            let list: Vec<&str> = known().collect();
            let list = if list.is_empty() {
                "none".to_owned()
            } else {
                list.join(", ")
            };
            let help = format!("{}known: {list}", did_you_mean(name, known()));
            return document.reject(path, format!("unknown {} `{name}`", self.kind), help);
        };
        self.usable[index].then_some(index)
    }
}

/// Names that elements of the scene refer to.
pub(super) struct Context {
    pub(super) materials: Names,
    pub(super) clumps: Names,
    pub(super) groups: Names,
    pub(super) ranges: Vec<Option<Range<usize>>>,
}

impl Context {
    /// The sphere called `"group[k]"`, or `"group"` where that is a single one.
    pub(super) fn sphere(
        &self,
        document: &mut Document<'_>,
        path: &str,
        text: &str,
    ) -> Option<usize> {
        let (group, index) = match text.split_once('[') {
            None => (text, None),
            Some((group, rest)) => {
                let Some(index) = rest.strip_suffix(']').and_then(|k| k.parse::<usize>().ok())
                else {
                    return document.reject(
                        path,
                        format!("found `{text}`, expected `group[k]`"),
                        "k counts the spheres of the group from 0",
                    );
                };
                (group, Some(index))
            }
        };
        let rank = self.groups.resolve(document, path, group)?;
        let range = self.ranges.get(rank)?.clone()?;
        match index {
            None if range.len() == 1 => Some(range.start),
            None => {
                let help = format!("write `{group}[k]` with k from 0 to {}", range.len() - 1);
                document.reject(
                    path,
                    format!(
                        "`{group}` has {} spheres, expected one of them",
                        range.len()
                    ),
                    help,
                )
            }
            Some(k) => {
                let expected = format!(
                    "an index below {}, the number of spheres of `{group}`",
                    range.len()
                );
                document
                    .demand(k < range.len(), path, k, &expected)
                    .then(|| range.start + k)
            }
        }
    }
}
