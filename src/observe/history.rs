//! The history: one CSV row per output time, `history.csv`.
//!
//! The header names each column and its unit, `name [unit]`, `-` where there is none: first `time [s]`, the end of the
//! communication step, then all of [`super::quantities`]. Numbers carry as many digits as it takes to read the same f64
//! back.

use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::Observation;
use super::error::OutputError;
use super::quantities::{quantities, values};
use crate::scene::Scene;

/// Header of the history of `scene`.
#[must_use]
pub fn columns(scene: &Scene) -> Vec<String> {
    let columns = quantities(scene)
        .into_iter()
        .map(|quantity| format!("{} [{}]", quantity.name, quantity.unit.unwrap_or("-")));
    std::iter::once("time [s]".to_owned())
        .chain(columns)
        .collect()
}

/// The row of a state, in the order of [`columns`].
#[must_use]
pub fn row(state: &Observation) -> Vec<f64> {
    std::iter::once(state.time).chain(values(state)).collect()
}

/// A CSV file that can be taken back to an earlier time.
#[derive(Debug)]
pub struct History {
    path: PathBuf,
    file: File,
    columns: Vec<String>,
    /// Time \[s\] of each row, and where it ends in the file.
    rows: Vec<(f64, u64)>,
    /// End of the header.
    start: u64,
}

impl History {
    /// Creates the file and writes the header.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub fn create(path: &Path, columns: Vec<String>) -> Result<Self, OutputError> {
        let mut file = File::create(path).map_err(OutputError::io("create", path))?;
        let header = record(&columns).map_err(OutputError::io("write", path))?;
        file.write_all(&header)
            .map_err(OutputError::io("write", path))?;
        Ok(Self {
            path: path.to_path_buf(),
            file,
            columns,
            rows: Vec::new(),
            start: header.len() as u64,
        })
    }

    /// Appends a row; `values[0]` is the time \[s\]. Rows of this or a later time are dropped first.
    ///
    /// # Errors
    /// [`OutputError::Shape`], [`OutputError::NotFinite`], [`OutputError::Io`]; then no part of the row stays.
    pub fn push(&mut self, values: &[f64]) -> Result<(), OutputError> {
        if values.len() != self.columns.len() {
            return Err(OutputError::Shape {
                place: self.path.display().to_string(),
                array: "row".to_owned(),
                found: values.len(),
                expected: self.columns.len(),
            });
        }
        if let Some(index) = values.iter().position(|value| !value.is_finite()) {
            return Err(OutputError::NotFinite {
                place: self.path.display().to_string(),
                array: self.columns[index].clone(),
                index: self.rows.len(),
                value: values[index],
            });
        }
        let time = values[0];
        self.cut(|row| row < time)?;
        let bytes = record(values).map_err(OutputError::io("write", &self.path))?;
        if let Err(error) = self.file.write_all(&bytes) {
            self.cut(|_| true)?;
            return Err(OutputError::io("write", &self.path)(error));
        }
        self.rows.push((time, self.end() + bytes.len() as u64));
        Ok(())
    }

    /// Drops the rows later than `time` \[s\].
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub fn rollback(&mut self, time: f64) -> Result<(), OutputError> {
        self.cut(|row| row <= time)
    }

    /// Where the last row ends.
    fn end(&self) -> u64 {
        self.rows.last().map_or(self.start, |row| row.1)
    }

    /// Keeps the leading rows whose time satisfies `keep`, and cuts the file behind them.
    fn cut(&mut self, keep: impl Fn(f64) -> bool) -> Result<(), OutputError> {
        self.rows
            .truncate(self.rows.partition_point(|&(time, _)| keep(time)));
        let end = self.end();
        self.file
            .set_len(end)
            .and_then(|()| self.file.seek(SeekFrom::Start(end)))
            .map_err(OutputError::io("truncate", &self.path))?;
        Ok(())
    }
}

/// One line of CSV.
fn record<T: serde::Serialize>(fields: &[T]) -> Result<Vec<u8>, std::io::Error> {
    let mut writer = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(Vec::new());
    writer.serialize(fields).map_err(std::io::Error::other)?;
    writer.into_inner().map_err(|error| error.into_error())
}
