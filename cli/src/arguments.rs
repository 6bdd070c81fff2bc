//! Values of options that several verbs share.

use std::path::Path;

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
    if path.exists() && !overwrite {
        return Err(Failure::Input(miette!(
            "`{}` exists already: choose another name, or use --overwrite",
            path.display()
        )));
    }
    Ok(path)
}
