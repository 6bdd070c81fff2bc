//! Values of options that several verbs share.

use std::path::Path;

use clap::Args;
use miette::miette;

use crate::failure::Failure;

/// A time in seconds that a run can end at.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if value > 0.0 && f64::is_finite(value) => Ok(value),
        _ => Err("expected a finite number of seconds greater than 0".to_owned()),
    }
}

pub(crate) fn interval(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if value >= 0.0 && f64::is_finite(value) => Ok(value),
        _ => Err("expected a finite number of seconds, at least 0".to_owned()),
    }
}

/// `name=value`, split at the first `=` that is not in single quotes, as names may have.
pub(crate) fn assignment(text: &str) -> Result<(String, String), String> {
    let mut quoted = false;
    let mut escaped = false;
    for (at, character) in text.char_indices() {
        match character {
            _ if escaped => escaped = false,
            '\\' if quoted => escaped = true,
            '\'' => quoted = !quoted,
            '=' if !quoted => {
                let (name, value) = text.split_at(at);
                let value = value.strip_prefix('=').unwrap_or(value);
                return Ok((name.trim().to_owned(), value.to_owned()));
            }
            _ => {}
        }
    }
    Err(format!("found `{text}`, expected NAME=VALUE"))
}

/// `name=number`, of a scene's parameter.
pub(crate) fn parameter(text: &str) -> Result<(String, f64), String> {
    let (name, value) = assignment(text)?;
    match value.trim().parse() {
        Ok(number) if f64::is_finite(number) => Ok((name, number)),
        _ => Err(format!("found `{value}`, expected NAME=NUMBER")),
    }
}

/// Values of the parameters of a scene.
#[derive(Debug, Args)]
pub(crate) struct Values {
    /// Value of a parameter of the scene, one of its `[[parameter]]`; can be repeated.
    #[arg(long = "set", value_name = "NAME=NUMBER", value_parser = parameter)]
    pub(crate) set: Vec<(String, f64)>,
}

/// The file if it can be written: an ending that importers want also keeps a slip of the hand from replacing the scene.
pub(crate) fn free<'p>(
    option: &str,
    path: &'p Path,
    ending: &str,
    overwrite: bool,
) -> Result<&'p Path, Failure> {
    if path.extension().is_none_or(|found| found != ending) {
        return Err(Failure::Input(miette!(
            "{option}: found `{}`, expected a name that ends with .{ending}",
            path.display()
        )));
    }
    vacant(path, overwrite)?;
    Ok(path)
}

/// Whether nothing lies at `path`, or may be replaced.
pub(crate) fn vacant(path: &Path, overwrite: bool) -> Result<(), Failure> {
    if path.exists() && !overwrite {
        return Err(Failure::Input(miette!(
            "`{}` exists already: choose another name, or use --overwrite",
            path.display()
        )));
    }
    Ok(())
}
