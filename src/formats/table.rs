//! The history's file: a CSV table whose first column is the time, which can be taken back to an earlier one.

use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::error::OutputError;

/// A CSV file that can be taken back to an earlier time.
#[derive(Debug)]
pub(crate) struct Table {
    path: PathBuf,
    file: File,
    columns: Vec<String>,
    /// Time \[s\] of each row, and where it ends in the file.
    rows: Vec<(f64, u64)>,
    /// End of the header.
    start: u64,
}

impl Table {
    /// Creates the file and writes the header.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn create(path: &Path, columns: Vec<String>) -> Result<Self, OutputError> {
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

    /// Opens a file that an earlier process has written, up to its last whole row. Nothing is changed until the
    /// first [`Self::push`] or [`Self::rollback`], which cut off the rest.
    ///
    /// # Errors
    /// [`OutputError::Io`]; [`OutputError::Changed`] if it has another header.
    pub(crate) fn open(path: &Path, columns: Vec<String>) -> Result<Self, OutputError> {
        let refuse = OutputError::io("read", path);
        let file = OpenOptions::new().read(true).write(true).open(path);
        let file = file.map_err(OutputError::io("open", path))?;
        let header = record(&columns).map_err(OutputError::io("write", path))?;
        let mut reader = BufReader::new(&file);
        let mut line = Vec::new();
        let read = (&mut reader)
            .take(header.len() as u64)
            .read_to_end(&mut line);
        read.map_err(refuse)?;
        if line != header {
            return Err(OutputError::Changed {
                path: path.to_path_buf(),
                found: "another header".to_owned(),
                expected: format!("the {} columns of this scene", columns.len()),
            });
        }
        let start = header.len() as u64;
        let mut rows: Vec<(f64, u64)> = Vec::new();
        let mut end = start;
        loop {
            line.clear();
            let read = reader.read_until(b'\n', &mut line);
            end += read.map_err(OutputError::io("read", path))? as u64;
            match time(&line) {
                Some(time) if rows.last().is_none_or(|last| last.0 < time) => {
                    rows.push((time, end));
                }
                _ => break,
            }
        }
        Ok(Self {
            path: path.to_path_buf(),
            file,
            columns,
            rows,
            start,
        })
    }

    /// Times \[s\] of the rows.
    pub(crate) fn times(&self) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|row| row.0)
    }

    /// Appends a row; `values[0]` is the time \[s\]. Rows of this or a later time are dropped first.
    ///
    /// # Errors
    /// [`OutputError::Shape`], [`OutputError::NotFinite`], [`OutputError::Io`]; then no part of the row stays.
    pub(crate) fn push(&mut self, values: &[f64]) -> Result<(), OutputError> {
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
    pub(crate) fn rollback(&mut self, time: f64) -> Result<(), OutputError> {
        self.cut(|row| row <= time)
    }

    /// Waits until the rows have reached the disk.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn sync(&self) -> Result<(), OutputError> {
        self.file
            .sync_data()
            .map_err(OutputError::io("write", &self.path))
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

/// The time \[s\] of a row; `None` if the line is no whole row.
fn time(line: &[u8]) -> Option<f64> {
    let line = line.strip_suffix(b"\n")?;
    let field = line.split(|&byte| byte == b',').next()?;
    std::str::from_utf8(field).ok()?.parse().ok()
}

/// One line of CSV.
fn record<T: serde::Serialize>(fields: &[T]) -> Result<Vec<u8>, std::io::Error> {
    let mut writer = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(Vec::new());
    writer.serialize(fields).map_err(std::io::Error::other)?;
    writer.into_inner().map_err(|error| error.into_error())
}
