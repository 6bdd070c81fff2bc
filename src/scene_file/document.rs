//! A TOML text with the place of every value, and the list of problems found in it.

use std::fmt::Display;
use std::ops::{Range, RangeBounds};
use std::path::{Path, PathBuf};

use miette::Severity;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::diagnostic::{Advice, Diagnostic};
use super::resources::{Attachment, Resources};
use super::source_text::pointed_at;

/// Largest magnitude of a number in a scene: beyond it products of a few of them stop being finite.
pub(super) const LARGEST: f64 = 1e30;

/// Most problems of a scene that are reported.
const SHOWN: usize = 200;

/// Most characters of a faulty value that a message repeats.
const ECHOED: usize = 60;

/// One step of a key path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Step {
    /// A key of a table.
    Key(String),
    /// An index of an array, counted from 0.
    Index(usize),
}

/// `boundary[1].faces[0]` for the steps of a path.
pub(super) fn join(path: &str, steps: &[Step]) -> String {
    let mut joined = path.to_owned();
    for step in steps {
        match step {
            Step::Key(key) if joined.is_empty() => joined.push_str(key),
            Step::Key(key) => {
                joined.push('.');
                joined.push_str(key);
            }
            Step::Index(index) => joined.push_str(&format!("[{index}]")),
        }
    }
    joined
}

/// The steps of a path.
pub(super) fn split(path: &str) -> Vec<Step> {
    let mut steps = Vec::new();
    for part in path.split('.').filter(|part| !part.is_empty()) {
        let (key, indices) = part.split_at(part.find('[').unwrap_or(part.len()));
        steps.push(Step::Key(key.to_owned()));
        let numbers = indices.split(['[', ']']).filter_map(|n| n.parse().ok());
        steps.extend(numbers.map(Step::Index));
    }
    steps
}

/// Where a value stands: its path, or that of its table and its key.
pub(super) trait Place {
    /// The path as messages show it.
    fn path(self) -> String;
}

impl Place for String {
    fn path(self) -> String {
        self
    }
}

impl Place for &String {
    fn path(self) -> String {
        self.clone()
    }
}

impl Place for &str {
    fn path(self) -> String {
        self.to_owned()
    }
}

impl<T: Display> Place for (T, &str) {
    fn path(self) -> String {
        format!("{}.{}", self.0, self.1)
    }
}

/// The text, its values, what is wrong with them, and the files that they name.
pub(super) struct Document<'t> {
    text: &'t str,
    root: Spanned<DeValue<'t>>,
    problems: Vec<Diagnostic>,
    /// Where the lines after the first begin.
    lines: Vec<usize>,
    resources: Resources<'t>,
    /// Keys that a parameter has set, and its name.
    marks: Vec<(String, String)>,
}

impl<'t> Document<'t> {
    /// Parses `text`, whose files lie in `folder`; syntax errors become problems, all of them.
    pub(super) fn parse(text: &'t str, folder: &'t Path) -> Self {
        let (table, errors) = DeTable::parse_recoverable(text);
        let span = table.span();
        let mut document = Self {
            text,
            root: Spanned::new(span, DeValue::Table(table.into_inner())),
            problems: Vec::new(),
            lines: text.match_indices('\n').map(|(at, _)| at + 1).collect(),
            resources: Resources::new(folder),
            marks: Vec::new(),
        };
        for error in errors {
            let span = error.span().unwrap_or(0..0);
            let (message, help) = document.syntax(error.message(), span.start);
            document.report(Severity::Error, String::new(), span, message, help);
        }
        // One slip of the pen may be reported twice.
        document
            .problems
            .dedup_by(|a, b| (a.line, &a.message) == (b.line, &b.message));
        document
    }

    /// What is wrong with the syntax at byte `at`, and how to mend it.
    fn syntax(&self, message: &str, at: usize) -> (String, String) {
        let at = self.text.floor_char_boundary(at);
        let start = self.text[..at].rfind('\n').map_or(0, |n| n + 1);
        let line = self.text[start..].lines().next().unwrap_or_default();
        let (key, value) = line.split_once('=').unwrap_or((line, ""));
        let (key, value) = (
            key.trim(),
            value.split('#').next().unwrap_or_default().trim(),
        );
        if line.contains('=') && value.is_empty() {
            return (
                format!("found nothing after `{key} =`, expected a value"),
                format!(
                    "write `{key} = ...`: a number, a string in quotes, a list `[...]` or a table `{{ ... }}`"
                ),
            );
        }
        if message.contains("must be quoted") {
            let value = value.chars().take(ECHOED).collect::<String>();
            return (
                format!("found `{value}` without quotes, expected a value"),
                format!("a string stands in quotes: `{key} = \"{value}\"`"),
            );
        }
        let help = "this is not TOML: see https://toml.io for its syntax";
        (
            message.replace("literal string", "a value"),
            help.to_owned(),
        )
    }

    /// Notes that the value at `steps` is that of a parameter: problems with it say so.
    pub(super) fn mark(&mut self, steps: &[Step], parameter: &str) {
        self.marks.push((join("", steps), parameter.to_owned()));
    }

    /// Whether an error (not only warnings) was reported.
    pub(super) fn refused(&self) -> bool {
        self.problems.iter().any(|p| p.severity == Severity::Error)
    }

    /// The errors and the warnings in the order of the file, and the files read.
    pub(super) fn into_parts(mut self) -> (Vec<Diagnostic>, Vec<Diagnostic>, Vec<Attachment>) {
        self.problems.sort_by_key(|p| p.span.offset());
        let problems = self.problems.into_iter();
        let (mut errors, warnings): (Vec<Diagnostic>, _) =
            problems.partition(|p| p.severity == Severity::Error);
        if let Some(more) = errors.len().checked_sub(SHOWN).filter(|more| *more > 0) {
            errors.truncate(SHOWN);
            errors.extend(errors.last().cloned().map(|last| Diagnostic {
                path: "scene".to_owned(),
                message: format!("{more} more problems from here on"),
                help: Some("mend those above first".to_owned()),
                ..last
            }));
        }
        (errors, warnings, self.resources.into_attachments())
    }

    /// Reads `file`, named at the key path `path`.
    pub(super) fn read(&mut self, path: &str, file: &str) -> Option<&[u8]> {
        match self.resources.load(file) {
            Ok(name) => self.resources.get(&name),
            Err((message, help)) => {
                self.error(path, message, help);
                None
            }
        }
    }

    /// Where `file` lies on disk, for readers that open it themselves; only of use after [`Self::read`].
    pub(super) fn place(&self, file: &str) -> PathBuf {
        self.resources.place(file)
    }

    /// The top-level table.
    pub(super) fn root(&self) -> &Spanned<DeValue<'t>> {
        &self.root
    }

    /// Refuses the scene because of the value at `path`. An empty `help` is none.
    pub(super) fn error(
        &mut self,
        path: impl Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        let path = path.path();
        let span = self.locate(&path);
        self.report(Severity::Error, path, span, message.into(), help.into());
    }

    /// Warns of the value at `path`.
    pub(super) fn warn(
        &mut self,
        path: impl Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        let path = path.path();
        let span = self.locate(&path);
        self.report(Severity::Warning, path, span, message.into(), help.into());
    }

    /// Adds a piece of advice to the warnings.
    pub(super) fn advise(&mut self, advice: Advice) {
        let span = self.locate(&advice.path);
        self.report(
            advice.severity,
            advice.path,
            span,
            advice.message,
            advice.help,
        );
    }

    /// Refuses a number outside its range: `found 0, expected > 0 [m]`. Returns whether it was in range.
    pub(super) fn demand(
        &mut self,
        in_range: bool,
        path: impl Place,
        found: impl Display,
        expected: &str,
    ) -> bool {
        if !in_range {
            self.error(path, format!("found {found}, expected {expected}"), "");
        }
        in_range
    }

    /// [`Self::error`] where the value is all that is wanted.
    pub(super) fn reject<T>(
        &mut self,
        path: impl Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Option<T> {
        self.error(path, message, help);
        None
    }

    /// Refuses what was found, whatever it is.
    pub(super) fn refuse<T>(
        &mut self,
        path: impl Place,
        found: impl Display,
        expected: &str,
    ) -> Option<T> {
        self.demand(false, path, found, expected);
        None
    }

    /// Refuses a number that is not above zero; an absent one is right.
    pub(super) fn positive(
        &mut self,
        path: impl Place,
        value: impl Into<Option<f64>>,
        expected: &str,
    ) -> bool {
        let value = value.into();
        value.is_none_or(|value| self.demand(value > 0.0, path, value, expected))
    }

    /// Refuses a number outside `range`; an absent one is right.
    pub(super) fn within<T: PartialOrd + Display>(
        &mut self,
        path: impl Place,
        value: impl Into<Option<T>>,
        range: impl RangeBounds<T>,
        expected: &str,
    ) -> bool {
        let value = value.into();
        value.is_none_or(|value| self.demand(range.contains(&value), path, value, expected))
    }

    /// Adds a problem at a known place.
    pub(super) fn report(
        &mut self,
        severity: Severity,
        path: String,
        span: Range<usize>,
        message: String,
        help: String,
    ) {
        let span = pointed_at(self.text, span.start, span.end);
        let start = span.offset();
        let help = match self.marks.iter().find(|(key, _)| *key == path) {
            Some((_, parameter)) if help.is_empty() => {
                format!("the parameter `{parameter}` has set it")
            }
            Some((_, parameter)) => format!("the parameter `{parameter}` has set it; {help}"),
            None => help,
        };
        self.problems.push(Diagnostic {
            path: if path.is_empty() {
                "scene".to_owned()
            } else {
                path
            },
            line: 1 + self.lines.partition_point(|&line| line <= start),
            span,
            message,
            help: Some(help).filter(|help| !help.is_empty()),
            severity,
        });
    }

    /// Place of the value at `path`, or of the closest table or array above it that exists.
    fn locate(&self, path: &str) -> Range<usize> {
        let mut place = &self.root;
        let mut span = 0..0;
        for step in split(path) {
            let Some(next) = child(place, &step) else {
                break;
            };
            place = next;
            span = place.span();
        }
        span
    }
}

/// The value one step below `value`.
pub(super) fn child<'a, 't>(
    value: &'a Spanned<DeValue<'t>>,
    step: &Step,
) -> Option<&'a Spanned<DeValue<'t>>> {
    match step {
        Step::Key(key) => value.get_ref().get(key.as_str()),
        Step::Index(index) => value.get_ref().get(*index),
    }
}

/// The closest of `names` to `name`, as ` Did you mean ...?`, or nothing.
pub(super) fn did_you_mean<'a>(name: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    let name = name.to_lowercase();
    names
        .into_iter()
        .map(|candidate| (strsim::jaro_winkler(&name, candidate), candidate))
        .filter(|(score, _)| *score > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map_or(String::new(), |(_, best)| {
            format!("did you mean `{best}`? ")
        })
}
