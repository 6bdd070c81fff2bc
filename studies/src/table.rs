//! Tables: the same cells as Markdown and as CSV.

use crate::error::ReportError;

/// A table of text cells under headings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    headings: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    #[must_use]
    pub fn new(headings: &[&str]) -> Self {
        Self {
            headings: headings.iter().map(|&h| h.to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row; missing cells stay empty.
    pub fn row<C: Into<String>>(&mut self, cells: impl IntoIterator<Item = C>) {
        let mut cells: Vec<String> = cells.into_iter().map(Into::into).collect();
        cells.resize(self.headings.len(), String::new());
        self.rows.push(cells);
    }

    /// The rows.
    #[must_use]
    pub fn rows(&self) -> &[Vec<String>] {
        &self.rows
    }

    /// As a Markdown table; columns of numbers are set to the right.
    #[must_use]
    pub fn markdown(&self) -> String {
        let line = |cells: &[String]| {
            let cells: Vec<String> = cells.iter().map(|c| c.replace('|', "\\|")).collect();
            format!("| {} |\n", cells.join(" | "))
        };
        let rules: Vec<&str> = (0..self.headings.len())
            .map(|k| if self.numeric(k) { "---:" } else { "---" })
            .collect();
        let mut text = line(&self.headings) + &format!("| {} |\n", rules.join(" | "));
        for row in &self.rows {
            text += &line(row);
        }
        text
    }

    /// As CSV with a heading line.
    ///
    /// # Errors
    /// [`ReportError::Table`]; `name` is what it calls the table.
    pub fn csv(&self, name: &str) -> Result<String, ReportError> {
        let refuse = |reason: String| ReportError::Table {
            name: name.to_owned(),
            reason,
        };
        let mut writer = csv::Writer::from_writer(Vec::new());
        for record in std::iter::once(&self.headings).chain(&self.rows) {
            writer
                .write_record(record)
                .map_err(|e| refuse(e.to_string()))?;
        }
        let bytes = writer.into_inner().map_err(|e| refuse(e.to_string()))?;
        String::from_utf8(bytes).map_err(|e| refuse(e.to_string()))
    }

    /// Whether column `k` holds numbers, dashes aside.
    fn numeric(&self, k: usize) -> bool {
        let number = |cell: &str| cell.starts_with(|c: char| c.is_ascii_digit() || c == '-');
        self.rows
            .iter()
            .map(|row| row[k].as_str())
            .all(|cell| cell.is_empty() || number(cell))
            && !self.rows.is_empty()
    }
}

/// A number with three digits: plain where that is short, with an exponent elsewhere.
#[must_use]
pub fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if !value.is_finite() {
        "-".to_owned()
    } else if !(1e-2..1e4).contains(&size) {
        format!("{value:.2e}")
    } else if size < 10.0 {
        format!("{value:.2}")
    } else if size < 100.0 {
        format!("{value:.1}")
    } else {
        format!("{value:.0}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_the_same_in_markdown_and_csv() {
        let mut table = Table::new(&["case", "overlap | R", "n"]);
        table.row(["a, \"b\"", "1e-6", "12"]);
        table.row(["c"]);
        assert_eq!(
            table.markdown(),
            "| case | overlap \\| R | n |\n| --- | ---: | ---: |\n| a, \"b\" | 1e-6 | 12 |\n| c |  |  |\n"
        );
        assert_eq!(
            table.csv("t").expect("CSV"),
            "case,overlap | R,n\n\"a, \"\"b\"\"\",1e-6,12\nc,,\n"
        );
    }

    #[test]
    fn numbers_have_three_digits() {
        let cases = [
            (0.0, "0"),
            (9.97e-7, "9.97e-7"),
            (0.25, "0.25"),
            (3.25, "3.25"),
            (41.06, "41.1"),
            (861.0, "861"),
            (1.25e7, "1.25e7"),
            (-0.5, "-0.50"),
            (f64::NAN, "-"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
