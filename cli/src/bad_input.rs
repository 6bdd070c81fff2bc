//! Errors that the user can mend by changing what was handed in: exit code 2.

use std::error::Error;
use std::fmt;

use miette::{Diagnostic, Report};

/// An error of a library about what was handed in.
#[derive(Debug)]
pub(crate) struct BadInput(Box<dyn Error + Send + Sync>);

impl BadInput {
    /// The report of such an error.
    pub(crate) fn report(error: impl Error + Send + Sync + 'static) -> Report {
        Report::new(Self(Box::new(error)))
    }
}

impl fmt::Display for BadInput {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

// No source: the message of every error of the libraries already has that of its source.
impl Error for BadInput {}

impl Diagnostic for BadInput {}
