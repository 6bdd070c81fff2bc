//! Events in a foreign library, reported when they come: a library that crashes reports nothing afterwards.

use std::fmt;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::status::Status;

/// One message of a foreign library.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Message {
    /// Name of the instance that it is about.
    pub instance: String,
    /// How serious it is; `None` for a number that the standard does not know.
    pub status: Option<Status>,
    /// Category, one of those in the model description if the library keeps to the standard.
    pub category: String,
    /// The text; directives whose arguments could not be read stand as in the format.
    pub text: String,
}

impl fmt::Display for Message {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            instance,
            category,
            text,
            ..
        } = self;
        match self.status {
            Some(status) => write!(formatter, "{instance}: {status} [{category}] {text}"),
            None => write!(formatter, "{instance}: [{category}] {text}"),
        }
    }
}

/// What happens in a library.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum CallEvent {
    /// The call of the function of this name begins.
    Calling(String),
    /// It logs a message.
    Logged(Message),
}

/// Who gets these events; by default nobody.
#[derive(Clone, Default)]
pub(crate) struct Watch(Option<Arc<dyn Fn(CallEvent) + Send + Sync>>);

impl fmt::Debug for Watch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = if self.0.is_some() {
            "Watched"
        } else {
            "Unwatched"
        };
        formatter.write_str(name)
    }
}

impl Watch {
    pub(crate) fn new(observe: impl Fn(CallEvent) + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(observe)))
    }

    pub(super) fn calling(&self, function: &str) {
        self.report(|| CallEvent::Calling(function.to_owned()));
    }

    pub(super) fn report(&self, event: impl FnOnce() -> CallEvent) {
        if let Some(observe) = &self.0 {
            observe(event());
        }
    }
}
