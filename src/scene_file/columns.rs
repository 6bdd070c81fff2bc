//! CSV files with named columns of numbers.

use super::document::{Document, LARGEST, did_you_mean};

/// Most findings reported from one file.
const MOST_FINDINGS: usize = 10;

/// What other programs put between columns.
const OTHER_SEPARATORS: [char; 3] = [';', '\t', '|'];

/// A CSV table of numbers with named columns.
pub(super) struct Columns<const N: usize> {
    /// One entry per row and wanted column; `None` where the file has no such column.
    pub(super) rows: Vec<[Option<f64>; N]>,
    /// Line of each row.
    pub(super) lines: Vec<u64>,
}

impl<const N: usize> Columns<N> {
    /// Reads the columns `names`, of which the first `required` must be there; others are refused.
    pub(super) fn read(
        document: &mut Document<'_>,
        path: &str,
        file: &str,
        content: &[u8],
        names: &[&str; N],
        required: usize,
    ) -> Option<Self> {
        let mut reader = csv::ReaderBuilder::new()
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .from_reader(content);
        let header = match reader.headers() {
            Ok(header) => header.clone(),
            Err(error) => {
                return document.reject(path, format!("`{file}` is not a CSV file: {error}"), "");
            }
        };
        // A single column is no list of columns: it is one of another separator.
        if let Some(other) = OTHER_SEPARATORS
            .iter()
            .find(|other| header.len() == 1 && header[0].contains(**other))
        {
            return document.reject(
                path,
                format!("the columns of `{file}` are separated by {other:?}, expected `,`"),
                "write it with commas between the columns and points in the numbers",
            );
        }
        let mut good = true;
        for (k, column) in header.iter().enumerate() {
            let twice = header.iter().take(k).any(|c| c == column);
            if !names.contains(&column) || twice {
                let what = if twice { "repeated" } else { "unknown" };
                let help = format!(
                    "{}known: {}",
                    did_you_mean(column, *names),
                    names.join(", ")
                );
                document.error(
                    path,
                    format!("`{file}` has the {what} column `{column}`"),
                    help,
                );
                good = false;
            }
        }
        let place = names.map(|name| header.iter().position(|c| c == name));
        for (name, _) in names
            .iter()
            .zip(&place)
            .take(required)
            .filter(|(_, p)| p.is_none())
        {
            let help = format!("the first line names the columns: {}", names.join(","));
            document.error(path, format!("`{file}` lacks the column `{name}`"), help);
            good = false;
        }
        if !good {
            return None;
        }
        let mut table = Self {
            rows: Vec::new(),
            lines: Vec::new(),
        };
        let mut findings = Vec::new();
        for record in reader.records() {
            match record {
                Ok(record) => table.push(&record, &place, names, file, &mut findings),
                Err(error) => findings.push(format!("`{file}` is not a CSV file: {error}")),
            }
        }
        if table.rows.is_empty() && findings.is_empty() {
            findings.push(format!("`{file}` has no rows, expected at least one"));
        }
        for finding in findings.iter().take(MOST_FINDINGS) {
            document.error(path, finding.as_str(), "");
        }
        if findings.len() > MOST_FINDINGS {
            document.error(
                path,
                format!(
                    "`{file}` has {} more such lines",
                    findings.len() - MOST_FINDINGS
                ),
                "",
            );
        }
        findings.is_empty().then_some(table)
    }

    fn push(
        &mut self,
        record: &csv::StringRecord,
        place: &[Option<usize>; N],
        names: &[&str; N],
        file: &str,
        findings: &mut Vec<String>,
    ) {
        let line = record.position().map_or(0, csv::Position::line);
        let mut row = [None; N];
        for ((value, place), name) in row.iter_mut().zip(place).zip(names) {
            let Some(cell) = place.and_then(|k| record.get(k)) else {
                continue;
            };
            match cell.parse::<f64>() {
                Ok(number) if number.abs() <= LARGEST => *value = Some(number),
                _ => findings.push(format!("found `{cell}` in `{file}` line {line}, column `{name}`, expected a finite number")),
            }
        }
        self.rows.push(row);
        self.lines.push(line);
    }
}
