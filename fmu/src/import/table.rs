//! What a simulation recorded.

use std::io::Write;

use sphere_dda_model_description::fmi2::{BaseType, Causality};

use super::exchange::Broken;
use super::system::{System, Variable};
use super::values::{self, Value, Values};
use super::{Instance, VariableError};

const BASES: [BaseType; 4] = [
    BaseType::Real,
    BaseType::Integer,
    BaseType::Boolean,
    BaseType::String,
];

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
    /// Its value reference.
    pub reference: u32,
    /// One value for each time.
    pub values: Values,
}

/// Variables over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Times \[s\]: the start and every communication point.
    pub time: Vec<f64>,
    /// The recorded variables.
    pub columns: Vec<Column>,
    /// Why it ends where it does.
    pub end: End,
}

impl Table {
    /// An empty table for the variables of these names, or for all outputs.
    pub(super) fn for_outputs(
        system: &System<'_>,
        names: Option<&[String]>,
    ) -> Result<Self, VariableError> {
        let column = |variable: Variable<'_>| Column {
            reference: variable.scalar.value_reference,
            values: Values::none(variable.scalar.variable_type.base()),
            component: variable.component,
            name: variable.name,
        };
        let columns = match names {
            Some(names) => names
                .iter()
                .map(|name| system.find(name).map(column))
                .collect::<Result<_, _>>()?,
            None => system
                .variables()
                .filter(|variable| variable.scalar.causality == Causality::Output)
                .map(column)
                .collect(),
        };
        Ok(Self {
            time: Vec::new(),
            columns,
            end: End::Interrupted,
        })
    }

    /// Appends the values that the instances have now, with one call for each type; no row if one fails.
    pub(super) fn record(&mut self, time: f64, instances: &mut [Instance]) -> Result<(), Broken> {
        let mut row: Vec<(usize, Option<Value>)> = Vec::new();
        for (component, instance) in instances.iter_mut().enumerate() {
            for base in BASES {
                let wanted = |(_, column): &(usize, &Column)| {
                    column.component == component && column.values.base() == base
                };
                let columns = self.columns.iter().enumerate().filter(wanted);
                let (places, references): (Vec<usize>, Vec<u32>) = columns
                    .map(|(place, column)| (place, column.reference))
                    .unzip();
                let found =
                    values::get(instance, base, &references).map_err(Broken::at(component))?;
                row.extend(
                    places
                        .into_iter()
                        .enumerate()
                        .map(|(k, place)| (place, found.get(k))),
                );
            }
        }
        for (place, value) in row {
            if let Some(column) = self.columns.get_mut(place) {
                column.values.extend(value);
            }
        }
        self.time.push(time);
        Ok(())
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

    /// Writes the table as CSV: header `time` and the names, one line for each time, numbers as the shortest text
    /// that reads back to the same bits.
    ///
    /// # Errors
    ///
    /// What the writer says.
    pub fn write_csv(&self, out: impl Write) -> Result<(), csv::Error> {
        let mut writer = csv::Writer::from_writer(out);
        let names = self.columns.iter().map(|column| column.name.as_str());
        writer.write_record(std::iter::once("time").chain(names))?;
        for (row, time) in self.time.iter().enumerate() {
            writer.write_field(format!("{time:?}"))?;
            for column in &self.columns {
                let text = column.values.get(row).map(|value| value.to_string());
                writer.write_field(text.unwrap_or_default())?;
            }
            writer.write_record(None::<&[u8]>)?;
        }
        writer.flush()?;
        Ok(())
    }
}
