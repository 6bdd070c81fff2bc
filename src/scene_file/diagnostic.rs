//! What is wrong with a scene file: place, value found, value allowed, how to mend it.

use std::fmt;

use miette::{LabeledSpan, Severity, SourceSpan};
use thiserror::Error;

use super::source_text::SourceText;

/// One finding about a scene file.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{path}: {message}")]
pub struct Diagnostic {
    /// Key path, counted from 0: `boundary[1].faces[0].plane.normal`.
    pub path: String,
    /// Line in the scene file, counted from 1.
    pub line: usize,
    /// Bytes of the scene file to point at.
    pub span: SourceSpan,
    /// What was found and what is expected, with units.
    pub message: String,
    /// How to mend it.
    pub help: Option<String>,
    /// `Error`: the scene is refused. `Warning`: it runs, but probably not as meant. `Advice`: it runs as meant, and could be
    /// simpler.
    pub(crate) severity: Severity,
}

impl miette::Diagnostic for Diagnostic {
    fn severity(&self) -> Option<Severity> {
        Some(self.severity)
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help
            .as_ref()
            .map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let label = LabeledSpan::new_with_span(Some("here".to_owned()), self.span);
        Some(Box::new(std::iter::once(label)))
    }
}

/// A scene that was refused, with all its problems in the order of the file. `{:?}`, which a `main` that fails prints, is
/// [`SceneError::plain`].
#[derive(Error)]
#[error("scene `{}`: {}", source_code.name(), count(problems.len()))]
pub struct SceneError {
    /// Name and text of the scene file.
    pub(crate) source_code: SourceText,
    /// Every problem found; never empty.
    pub problems: Vec<Diagnostic>,
}

impl SceneError {
    /// A scene file that cannot be read at all.
    pub(super) fn unreadable(name: &str, reason: &str, help: &str) -> Self {
        Self {
            source_code: SourceText::new(name, String::new()),
            problems: vec![Diagnostic {
                path: "scene".to_owned(),
                line: 1,
                span: (0..0).into(),
                message: format!("cannot read the file: {reason}"),
                help: Some(help.to_owned()),
                severity: Severity::Error,
            }],
        }
    }

    /// Plain text, one paragraph per problem: `funnel.toml:12: spheres[0].radius: found 0, ...`.
    #[must_use]
    pub fn plain(&self) -> String {
        let name = self.source_code.name();
        let paragraphs: Vec<String> = self.problems.iter().map(|p| p.plain(name)).collect();
        paragraphs.join("\n")
    }
}

impl fmt::Debug for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.plain())
    }
}

impl Diagnostic {
    /// Whether the scene runs, but probably not as meant.
    #[must_use]
    pub fn is_warning(&self) -> bool {
        self.severity == Severity::Warning
    }

    /// Plain text for logs, with the name of the scene file.
    #[must_use]
    pub fn plain(&self, name: &str) -> String {
        let help = self
            .help
            .as_deref()
            .map_or(String::new(), |help| format!("\n  help: {help}"));
        format!("{name}:{}: {self}{help}", self.line)
    }
}

impl miette::Diagnostic for SceneError {
    fn source_code(&self) -> Option<&dyn miette::SourceCode> {
        Some(&self.source_code)
    }

    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn miette::Diagnostic> + 'a>> {
        Some(Box::new(
            self.problems.iter().map(|p| p as &dyn miette::Diagnostic),
        ))
    }
}

fn count(n: usize) -> String {
    match n {
        1 => "1 problem".to_owned(),
        n => format!("{n} problems"),
    }
}

/// One piece of advice.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Advice {
    /// Key path.
    pub(super) path: String,
    /// What was found.
    pub(super) message: String,
    /// How to mend it.
    pub(super) help: String,
    /// `Warning`, or `Advice` for what is harmless.
    pub(super) severity: Severity,
}

impl Advice {
    pub(super) fn warning(
        path: impl Into<String>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        Self {
            path: path.into(),
            message: message.into(),
            help: help.into(),
            severity: Severity::Warning,
        }
    }

    /// What only costs the reader time.
    pub(super) fn harmless(self) -> Self {
        Self {
            severity: Severity::Advice,
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::error::StepError;
    use crate::scene::Scene;
    use std::path::Path;

    /// Fault: `Box<dyn Error>` printed the fields of the error, and `miette::Result` took it alone of all errors.
    #[test]
    fn errors_are_of_use_in_a_main() {
        let scene = |text| Scene::from_toml("x", text, Path::new(""));
        let boxed = || -> Result<(), Box<dyn std::error::Error>> {
            scene("[simulaton]")?;
            Ok(())
        };
        let text = format!("{:?}", boxed().expect_err("a typo"));
        assert!(text.contains("x:1: ") && text.contains("help"), "{text}");
        let report = || -> miette::Result<()> {
            Err(StepError::Argument {
                what: "step",
                found: "-1 s".to_owned(),
                expected: "more",
            })?;
            Ok(())
        };
        assert!(report().is_err());
    }
}
