//! Why a run does not go on.

use crate::error::ImportError;

/// Why a run does not go on.
pub(super) enum Halt {
    /// A call of the component of this number failed.
    Call(usize, Box<ImportError>),
    /// The output of this name is NaN.
    Nan(String),
    /// The exchanged values did not agree: the one that changed most, and by which part.
    NotConverged {
        variable: Option<String>,
        change: f64,
    },
    /// A step was discarded again and again.
    Discarded {
        component: usize,
        time: f64,
        step: f64,
        mend: &'static str,
    },
}

impl Halt {
    /// For the error of a call of this component.
    pub(super) fn at(component: usize) -> impl Fn(ImportError) -> Self {
        move |error| Self::Call(component, Box::new(error))
    }
}
