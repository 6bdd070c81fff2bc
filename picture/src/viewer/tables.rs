//! Tables over time for the plots: `history.csv` of a run, outputs of an FMU.

use std::path::Path;

use super::error::ViewError;

/// Most rows that are kept; more than a plot has pixels.
const ROWS: usize = 4000;

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Column {
    pub(super) name: String,
    /// Empty where the header has none.
    pub(super) unit: String,
    /// NaN where the table has no number.
    pub(super) values: Vec<f32>,
}

/// A table over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// What the page calls it.
    pub(super) name: String,
    /// Times \[s\].
    pub(super) time: Vec<f64>,
    pub(super) columns: Vec<Column>,
    /// Rows of the file for each that is kept.
    pub(super) thinned: usize,
}

impl Table {
    /// A table that the page itself fills: `columns` by name and unit.
    #[must_use]
    pub fn empty(name: &str, columns: impl IntoIterator<Item = (String, String)>) -> Self {
        let column = |(name, unit)| Column {
            name,
            unit,
            values: Vec::new(),
        };
        Self {
            name: name.to_owned(),
            time: Vec::new(),
            columns: columns.into_iter().map(column).collect(),
            thinned: 1,
        }
    }

    /// Reads a CSV file whose first column is the time; columns without any number are left out.
    ///
    /// # Errors
    /// [`ViewError::Table`].
    pub fn from_csv(path: &Path) -> Result<Self, ViewError> {
        let refuse = |found: String, expected| ViewError::Table {
            path: path.display().to_string(),
            found,
            expected,
        };
        let mut reader =
            csv::Reader::from_path(path).map_err(|e| refuse(e.to_string(), "a CSV file"))?;
        let header = reader.headers().cloned();
        let header = header.map_err(|e| refuse(e.to_string(), "a header"))?;
        let names: Vec<(String, String)> = header.iter().map(named).collect();
        if names.first().is_none_or(|(name, _)| name != "time") {
            let found = header.get(0).unwrap_or("none").to_owned();
            return Err(refuse(format!("the first column `{found}`"), "`time`"));
        }
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for record in reader.records() {
            // The last row of a run that goes on may be half written.
            let Ok(record) = record else { break };
            let number = |text: &str| text.trim().parse().unwrap_or(f64::NAN);
            rows.push(record.iter().map(number).collect());
        }
        rows.retain(|row| row[0].is_finite());
        let thinned = rows.len().div_ceil(ROWS).max(1);
        let last = rows.len().saturating_sub(1);
        let kept = |k: &usize| k.is_multiple_of(thinned) || *k == last;
        let kept: Vec<&Vec<f64>> = (0..rows.len()).filter(kept).map(|k| &rows[k]).collect();
        let column = |(k, (name, unit)): (usize, &(String, String))| Column {
            name: name.clone(),
            unit: unit.clone(),
            values: kept.iter().map(|row| row[k] as f32).collect(),
        };
        let columns = names.iter().enumerate().skip(1).map(column);
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        Ok(Self {
            name: name.into_owned(),
            time: kept.iter().map(|row| row[0]).collect(),
            columns: columns
                .filter(|column| column.values.iter().any(|v| v.is_finite()))
                .collect(),
            thinned,
        })
    }
}

/// `name [unit]` as both; `-` is no unit.
fn named(text: &str) -> (String, String) {
    let split = text.strip_suffix(']').and_then(|t| t.rsplit_once(" ["));
    match split {
        Some((name, "-")) => (name.to_owned(), String::new()),
        Some((name, unit)) => (name.to_owned(), unit.to_owned()),
        None => (text.to_owned(), String::new()),
    }
}
