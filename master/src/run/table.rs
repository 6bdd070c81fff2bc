//! What a simulation recorded.

use std::io::Write;

use sphere_dda_model_description::fmi3::Causality;
use wildmatch::WildMatch;

use crate::calls::Participant;
use crate::system::{System, SystemVariable, VariableError};
use crate::value::{Value, ValueType, Values};
use crate::variable::Place;

use super::halt::Halt;

/// Elements of an array up to which it is recorded without being asked for.
const SMALL_ARRAY: usize = 100;

/// Why a simulation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// It reached its stop time.
    Stop,
    /// The FMU discarded a step and wanted to end.
    Terminated,
    /// The observer asked to end.
    Interrupted,
}

/// The values of one variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name of the variable.
    pub name: String,
    /// Number of its FMU, from 0.
    pub component: usize,
    pub(crate) place: Place,
    /// One value for each time.
    pub values: Values,
}

/// A step that was kept although the values did not agree.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NotConverged {
    /// Its start \[s\].
    pub time: f64,
    /// The change that was left, as a part of the greatest magnitude of the value.
    pub change: f64,
}

/// Variables over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Times \[s\]: the start and every communication point, or the last alone where [`super::Options::keep_last`] asks for it.
    pub time: Vec<f64>,
    /// Rows that were recorded, those that are not kept included.
    pub recorded: u64,
    /// The recorded variables.
    pub columns: Vec<Column>,
    /// Why it ends where it does.
    pub end: End,
    /// Iterations of each step until the exchanged values agreed; empty if the coupling does not iterate.
    pub iterations: Vec<u32>,
    /// Steps of an iterated coupling that were kept although the values did not agree.
    pub not_converged: Vec<NotConverged>,
}

impl Table {
    /// An empty table for the variables of these names, `*` and `?` for any text or letter, or for all outputs. Without a name of
    /// their own, large arrays and binary variables are left out. Or all names that are of no variable.
    pub(super) fn for_outputs(
        system: &System<'_>,
        names: Option<&[String]>,
    ) -> Result<Self, Vec<VariableError>> {
        let small = || {
            system.variables().filter(|variable| {
                variable.declared.elements() <= SMALL_ARRAY
                    && variable.declared.scalar.value_type() != ValueType::Binary
            })
        };
        let is_output =
            |variable: &SystemVariable<'_>| variable.declared.causality == Causality::Output;
        let variables: Vec<SystemVariable<'_>> = match names {
            Some(names) => {
                let (mut listed, mut faults) = (Vec::new(), Vec::new());
                for name in names {
                    let pattern = WildMatch::new(name);
                    let before = listed.len();
                    if name.contains(['*', '?']) {
                        listed.extend(small().filter(|variable| pattern.matches(&variable.name)));
                    }
                    if listed.len() == before {
                        match system.find(name) {
                            Ok(variable) => listed.push(variable),
                            Err(fault) => faults.push(fault),
                        }
                    }
                }
                if !faults.is_empty() {
                    return Err(faults);
                }
                listed
            }
            None => small().filter(is_output).collect(),
        };
        let columns = |variable: &SystemVariable<'_>| {
            let elements = variable.elements();
            elements
                .into_iter()
                .map(|(name, place)| Column {
                    values: Values::none(place.scalar.value_type()),
                    component: variable.component,
                    name,
                    place,
                })
                .collect::<Vec<_>>()
        };
        Ok(Self {
            time: Vec::new(),
            recorded: 0,
            columns: variables.iter().flat_map(columns).collect(),
            end: End::Interrupted,
            iterations: Vec::new(),
            not_converged: Vec::new(),
        })
    }

    /// Appends the values that the instances have now, with one call for each type; no row if one fails.
    pub(super) fn record(
        &mut self,
        time: f64,
        instances: &mut [Box<dyn Participant>],
    ) -> Result<(), Halt> {
        let mut row: Vec<(usize, Value)> = Vec::new();
        for (component, instance) in instances.iter_mut().enumerate() {
            let columns = self.columns.iter().enumerate();
            let (columns, places): (Vec<usize>, Vec<Place>) = columns
                .filter(|(_, column)| column.component == component)
                .map(|(number, column)| (number, column.place))
                .unzip();
            let found = instance.get(&places).map_err(Halt::at(component))?;
            row.extend(columns.into_iter().zip(found));
        }
        for (number, value) in row {
            if let Some(column) = self.columns.get_mut(number) {
                column.values.extend(Some(value));
            }
        }
        self.time.push(time);
        self.recorded += 1;
        Ok(())
    }

    /// Forgets all rows, which the observer has seen.
    pub(super) fn forget(&mut self) {
        self.time.clear();
        for column in &mut self.columns {
            column.values.clear();
        }
    }

    /// Name of the first variable whose last value is NaN.
    pub(super) fn nan_in_last_row(&self) -> Option<&str> {
        let nan = |values: &Values| match values {
            Values::Real(list) => list.last().is_some_and(|value| value.is_nan()),
            _ => false,
        };
        let column = self.columns.iter().find(|column| nan(&column.values))?;
        Some(&column.name)
    }

    /// The values of the real variable of this name.
    pub fn real(&self, name: &str) -> Option<&[f64]> {
        let column = self.columns.iter().find(|column| column.name == name)?;
        match &column.values {
            Values::Real(list) => Some(list),
            _ => None,
        }
    }

    /// Writes the table as CSV, as [`CsvWriter`] does.
    ///
    /// # Errors
    ///
    /// What the writer says.
    pub fn write_csv(&self, out: impl Write) -> Result<(), csv::Error> {
        CsvWriter::new(out).write(self)
    }
}

/// Writes a table that grows as CSV: header `time` and the names, one line for each time, numbers as the shortest text that reads
/// back to the same bits.
pub struct CsvWriter<W: Write> {
    writer: csv::Writer<W>,
    written: u64,
}

impl<W: Write> CsvWriter<W> {
    /// A writer that has written nothing yet.
    pub fn new(out: W) -> Self {
        Self {
            writer: csv::Writer::from_writer(out),
            written: 0,
        }
    }

    /// Writes the rows of the table that are new since the last call, all the way to `out`.
    ///
    /// # Errors
    ///
    /// What the writer says.
    pub fn write(&mut self, table: &Table) -> Result<(), csv::Error> {
        if self.written == 0 {
            let names = table.columns.iter().map(|column| column.name.as_str());
            self.writer
                .write_record(std::iter::once("time").chain(names))?;
        }
        let forgotten = table.recorded - table.time.len() as u64;
        let new = self.written.saturating_sub(forgotten) as usize;
        for (row, time) in table.time.iter().enumerate().skip(new) {
            self.writer.write_field(format!("{time:?}"))?;
            for column in &table.columns {
                let text = column.values.get(row).map(|value| value.to_string());
                self.writer.write_field(text.unwrap_or_default())?;
            }
            self.writer.write_record(None::<&[u8]>)?;
        }
        self.written = table.recorded;
        self.writer.flush()?;
        Ok(())
    }
}
