//! What happens in a foreign library, and who hears of it at once: a library that crashes says nothing afterwards.

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
pub(crate) enum Happening {
    /// The call of the function of this name begins.
    Calling(String),
    /// It logs a message.
    Logged(Message),
}

/// Who hears of it at once; by default nobody.
#[derive(Clone, Default)]
pub(crate) struct Watch(Option<Arc<dyn Fn(Happening) + Send + Sync>>);

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
    pub(crate) fn new(hear: impl Fn(Happening) + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(hear)))
    }

    pub(super) fn calling(&self, function: &str) {
        self.tell(|| Happening::Calling(function.to_owned()));
    }

    pub(super) fn tell(&self, happening: impl FnOnce() -> Happening) {
        if let Some(hear) = &self.0 {
            hear(happening());
        }
    }
}
