//! Inputs over time, from a table.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use csv::{ReaderBuilder, StringRecord, Trim};
use sphere_dda_model_description::fmi2::Variability;
use thiserror::Error;

use crate::system::{System, SystemVariable, VariableError, check_settable_in_steps, parse_one};
use crate::value::{Value, ValueType};
use crate::variable::Place;

/// Why a table of inputs cannot be used.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum InputTableError {
    /// The file cannot be opened.
    #[error("{path}: {source}", path = path.display())]
    Open {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// It is not a table of comma-separated values.
    #[error(
        "{place}: {source}; expected comma-separated values in UTF-8, as many in each line as in the first"
    )]
    Csv {
        /// The file.
        place: String,
        /// What is wrong.
        source: csv::Error,
    },
    /// The first column is not time.
    #[error("{place}, line 1: found first column {found:?}, expected `time`")]
    NoTime {
        /// The file.
        place: String,
        /// Name of the first column.
        found: String,
    },
    /// There is no line of values.
    #[error("{place}: found no line of values, expected at least one after the header")]
    Empty {
        /// The file.
        place: String,
    },
    /// Two columns have the same name.
    #[error("{place}, line 1: found column `{name}` twice, expected it once")]
    Twice {
        /// The file.
        place: String,
        /// Name of the column.
        name: String,
    },
    /// A time is not a number or lies before the one above.
    #[error(
        "{place}, line {line}: found time {found:?}, expected a finite number not less than the one above"
    )]
    Time {
        /// The file.
        place: String,
        /// The line, from 1.
        line: u64,
        /// What stands there.
        found: String,
    },
    /// A column is none of the FMU's inputs, or a value not one of its type.
    #[error("{place}, line {line}: {source}")]
    Variable {
        /// The file.
        place: String,
        /// The line, from 1.
        line: u64,
        /// What is wrong.
        source: VariableError,
    },
}

/// One input over time.
#[derive(Debug, Clone, PartialEq)]
struct InputColumn {
    component: usize,
    place: Place,
    /// Linear between two times; else the value of the earlier.
    linear: bool,
    values: Vec<Value>,
}

/// Inputs and tunable parameters over time.
///
/// Continuous reals are linear between the times of the table, all else keeps its value until the next time; before
/// the first and after the last time the nearest value holds. Two lines of the same time make a jump: the later
/// line holds at that time.
#[derive(Debug, Clone, PartialEq)]
pub struct InputTable {
    times: Vec<f64>,
    columns: Vec<InputColumn>,
}

impl InputTable {
    /// Reads the file at `path`: header `time,name,...`, times in seconds that do not decrease, names of inputs or
    /// tunable parameters of the model (in double quotes if they hold a comma), values in their units.
    ///
    /// # Errors
    ///
    /// Every variant of [`InputTableError`].
    pub fn from_csv(path: impl AsRef<Path>, system: &System<'_>) -> Result<Self, InputTableError> {
        let path = path.as_ref();
        let file = File::open(path).map_err(|source| InputTableError::Open {
            path: path.to_owned(),
            source,
        })?;
        Self::read(file, &path.display().to_string(), system)
    }

    /// Reads a table as [`from_csv`](Self::from_csv) does; `place` names it in errors.
    ///
    /// # Errors
    ///
    /// Every variant of [`InputTableError`] but [`Open`](InputTableError::Open).
    pub fn read(
        source: impl Read,
        place: &str,
        system: &System<'_>,
    ) -> Result<Self, InputTableError> {
        let csv = |source| InputTableError::Csv {
            place: place.to_owned(),
            source,
        };
        let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(source);
        let header = reader.headers().map_err(csv)?.clone();
        let variables = variables(&header, place, system)?;
        let mut result = Self {
            times: Vec::new(),
            columns: variables.iter().map(input_column).collect(),
        };
        for record in reader.records() {
            result.push(&record.map_err(csv)?, &variables, place)?;
        }
        if result.times.is_empty() {
            return Err(InputTableError::Empty {
                place: place.to_owned(),
            });
        }
        Ok(result)
    }

    fn push(
        &mut self,
        record: &StringRecord,
        variables: &[SystemVariable<'_>],
        place: &str,
    ) -> Result<(), InputTableError> {
        let line = record.position().map_or(0, csv::Position::line);
        let mut fields = record.iter();
        let found = fields.next().unwrap_or_default();
        let after = self.times.last().copied().unwrap_or(f64::NEG_INFINITY);
        let time = found.parse().ok();
        let Some(time) = time.filter(|time: &f64| time.is_finite() && *time >= after) else {
            return Err(InputTableError::Time {
                place: place.to_owned(),
                line,
                found: found.to_owned(),
            });
        };
        self.times.push(time);
        for ((column, variable), field) in self.columns.iter_mut().zip(variables).zip(fields) {
            let value = parse_one(variable, field);
            column
                .values
                .push(value.map_err(|source| InputTableError::Variable {
                    place: place.to_owned(),
                    line,
                    source,
                })?);
        }
        Ok(())
    }

    /// Places and values at `time` \[s\] of the inputs of one component, counted from 0.
    pub(crate) fn at(&self, time: f64, component: usize) -> Vec<(Place, Value)> {
        // A communication point that misses a time of the table by rounding is meant to be that time.
        let slack = 8.0 * f64::EPSILON * time.abs();
        let next = self.times.partition_point(|&known| known <= time + slack);
        let value = |column: &InputColumn| {
            let before = column.values.get(next.saturating_sub(1))?;
            let value = match (before, column.values.get(next)) {
                (Value::Real(a), Some(Value::Real(b))) if column.linear && next > 0 => {
                    let (from, to) = (self.times.get(next - 1)?, self.times.get(next)?);
                    Value::Real(a + (b - a) * (time - from) / (to - from))
                }
                _ => before.clone(),
            };
            Some((column.place, value))
        };
        let own = |column: &&InputColumn| column.component == component;
        self.columns.iter().filter(own).filter_map(value).collect()
    }
}

fn input_column(variable: &SystemVariable<'_>) -> InputColumn {
    InputColumn {
        component: variable.component,
        place: variable.place(),
        linear: variable.declared.variability == Variability::Continuous
            && variable.declared.scalar.value_type() == ValueType::Real,
        values: Vec::new(),
    }
}

/// The variables of the columns after the first, which must be time.
fn variables<'f>(
    header: &StringRecord,
    place: &str,
    system: &System<'f>,
) -> Result<Vec<SystemVariable<'f>>, InputTableError> {
    let mut names = header.iter();
    match names.next() {
        Some("time") => {}
        other => {
            return Err(InputTableError::NoTime {
                place: place.to_owned(),
                found: other.unwrap_or_default().to_owned(),
            });
        }
    }
    let mut variables: Vec<SystemVariable<'f>> = Vec::new();
    for name in names {
        let variable = column(system, name).map_err(|source| InputTableError::Variable {
            place: place.to_owned(),
            line: 1,
            source,
        })?;
        if variables.iter().any(|known| known.name == name) {
            return Err(InputTableError::Twice {
                place: place.to_owned(),
                name: name.to_owned(),
            });
        }
        variables.push(variable);
    }
    Ok(variables)
}

fn column<'f>(system: &System<'f>, name: &str) -> Result<SystemVariable<'f>, VariableError> {
    let variable = system.find(name)?;
    check_settable_in_steps(&variable)?;
    variable.check_single()?;
    system.check_free(&variable)?;
    Ok(variable)
}
