//! Log lines: categories, which of them are on, and the printf form that FMI loggers expect.

use std::fmt;

/// How serious a line is: the status an FMI logger is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// For information.
    Ok,
    /// Something is not quite right, the computation goes on.
    Warning,
    /// A step was not taken, the state is as before it.
    Discard,
    /// A call failed.
    Error,
}

/// Categories of lines, as the model description lists them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Category {
    /// Life cycle: initialization, result files, restored states.
    Events,
    /// Lines of level [`Level::Warning`].
    Warning,
    /// Lines of level [`Level::Discard`].
    Discard,
    /// Lines of level [`Level::Error`].
    Error,
}

impl Category {
    /// All categories.
    pub const ALL: [Self; 4] = [Self::Events, Self::Warning, Self::Discard, Self::Error];

    /// Name in the model description and to the logger; the standard's own.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Events => "logEvents",
            Self::Warning => "logStatusWarning",
            Self::Discard => "logStatusDiscard",
            Self::Error => "logStatusError",
        }
    }

    /// One line for people.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::Events => "Initialization, result files, restored states",
            Self::Warning => "Calls that are answered but hint at a mistake",
            Self::Discard => "Steps that were not taken, with the evidence",
            Self::Error => "Calls that were refused: where, what was found, what is expected",
        }
    }

    fn of(level: Level) -> Self {
        match level {
            Level::Ok => Self::Events,
            Level::Warning => Self::Warning,
            Level::Discard => Self::Discard,
            Level::Error => Self::Error,
        }
    }
}

/// Where lines go: level, category and text, not yet in printf form.
pub type Sink = Box<dyn Fn(Level, Category, &str)>;

/// The log of one instance.
///
/// Warnings, discarded steps and errors are on from the start, as the standard's status codes promise a message;
/// events belong to debug logging. [`Log::select`] chooses exactly.
pub struct Log {
    sink: Option<Sink>,
    enabled: [bool; Category::ALL.len()],
}

impl Log {
    /// A log that writes to `sink`; `debug` turns the events on.
    #[must_use]
    pub fn new(sink: Option<Sink>, debug: bool) -> Self {
        Self {
            sink,
            enabled: [debug, true, true, true],
        }
    }

    /// Debug logging off: only lines that explain a status. On without names: everything; on with names: exactly
    /// those, `logAll` meaning everything. Returns the names that are not known.
    pub fn select<'a>(&mut self, on: bool, names: &[&'a str]) -> Vec<&'a str> {
        if !on {
            self.enabled = [false, true, true, true];
            return Vec::new();
        }
        let all = names.is_empty() || names.contains(&"logAll");
        self.enabled = Category::ALL.map(|category| all || names.contains(&category.name()));
        let known = |name: &str| name == "logAll" || Category::ALL.iter().any(|c| c.name() == name);
        names.iter().copied().filter(|name| !known(name)).collect()
    }

    /// Writes a line if its category is on.
    pub fn write(&self, level: Level, message: impl fmt::Display) {
        let category = Category::of(level);
        if let Some(sink) = &self.sink
            && self.enabled[category as usize]
        {
            sink(level, category, &message.to_string());
        }
    }
}

impl fmt::Debug for Log {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Log")
            .field("enabled", &self.enabled)
            .finish_non_exhaustive()
    }
}

/// A text as a printf format without arguments: FMI loggers take `%` as printf does and `#r12#` as a variable, so both
/// are doubled; NUL, which would end a C string, becomes a blank.
#[must_use]
pub fn printf(message: &str) -> String {
    message
        .replace('%', "%%")
        .replace('#', "##")
        .replace('\0', " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;
    use std::rc::Rc;

    fn log(debug: bool) -> (Log, Rc<RefCell<Vec<String>>>) {
        let lines = Rc::new(RefCell::new(Vec::new()));
        let copy = Rc::clone(&lines);
        let sink: Sink = Box::new(move |_, category, text| {
            copy.borrow_mut()
                .push(format!("{}: {text}", category.name()))
        });
        (Log::new(Some(sink), debug), lines)
    }

    #[test]
    fn printf_marks_are_doubled() {
        assert_eq!(printf("50 % of #r1#"), "50 %% of ##r1##");
    }

    #[test]
    fn status_lines_are_on_and_events_are_not() {
        let (log, lines) = log(false);
        log.write(Level::Ok, "event");
        log.write(Level::Error, "error");
        assert_eq!(*lines.borrow(), ["logStatusError: error"]);
    }

    #[test]
    fn a_selection_is_exact() {
        let (mut log, lines) = log(false);
        assert_eq!(log.select(true, &["logEvents", "logMagic"]), ["logMagic"]);
        log.write(Level::Ok, "event");
        log.write(Level::Error, "error");
        assert_eq!(*lines.borrow(), ["logEvents: event"]);
        assert!(log.select(true, &[]).is_empty());
        log.write(Level::Error, "error");
        assert_eq!(lines.borrow().len(), 2);
    }
}
