//! What a simulation recorded.

use std::io::Write;

use sphere_dda_model_description::fmi2::{ModelDescription, ScalarVariable};

use super::values::{Values, find};
use super::{ImportError, Instance, VariableError};

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
        description: &ModelDescription,
        names: Option<&[String]>,
    ) -> Result<Self, VariableError> {
        use sphere_dda_model_description::fmi2::Causality;
        let column = |variable: &ScalarVariable| Column {
            name: variable.name.clone(),
            reference: variable.value_reference,
            values: Values::none(variable.variable_type.base()),
        };
        let columns = match names {
            Some(names) => names
                .iter()
                .map(|name| find(description, name).map(column))
                .collect::<Result<_, _>>()?,
            None => description
                .model_variables
                .iter()
                .filter(|variable| variable.causality == Causality::Output)
                .map(column)
                .collect(),
        };
        Ok(Self {
            time: Vec::new(),
            columns,
            end: End::Interrupted,
        })
    }

    /// Appends the values that the instance has now, with one call for each type.
    pub(super) fn record(&mut self, time: f64, instance: &mut Instance) -> Result<(), ImportError> {
        let references = |wanted: fn(&Values) -> bool| -> Vec<u32> {
            let columns = self.columns.iter().filter(|column| wanted(&column.values));
            columns.map(|column| column.reference).collect()
        };
        let real = references(|values| matches!(values, Values::Real(_)));
        let integer = references(|values| matches!(values, Values::Integer(_)));
        let boolean = references(|values| matches!(values, Values::Boolean(_)));
        let string = references(|values| matches!(values, Values::String(_)));
        let mut real = instance.get_real(&real)?.into_iter();
        let mut integer = instance.get_integer(&integer)?.into_iter();
        let mut boolean = instance.get_boolean(&boolean)?.into_iter();
        let mut string = instance.get_string(&string)?.into_iter();
        for column in &mut self.columns {
            match &mut column.values {
                Values::Real(list) => list.extend(real.next()),
                Values::Integer(list) => list.extend(integer.next()),
                Values::Boolean(list) => list.extend(boolean.next()),
                Values::String(list) => list.extend(string.next()),
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
