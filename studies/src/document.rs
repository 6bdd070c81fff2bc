//! A Markdown document, built from the top.

use crate::table::Table;

/// Markdown under construction.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Document {
    text: String,
}

impl Document {
    /// A document with its title.
    #[must_use]
    pub fn new(title: &str) -> Self {
        Self {
            text: format!("# {title}\n"),
        }
    }

    /// A heading; level 2 is a section.
    pub fn heading(&mut self, level: usize, text: &str) {
        self.block(&format!("{} {text}", "#".repeat(level)));
    }

    /// Text as it is: a paragraph, a list, a table made elsewhere.
    pub fn text(&mut self, text: &str) {
        self.block(text.trim());
    }

    /// A table.
    pub fn table(&mut self, table: &Table) {
        self.block(table.markdown().trim_end());
    }

    /// A figure from a file beside the document.
    pub fn figure(&mut self, file: &str, caption: &str) {
        self.block(&format!("![{caption}]({file})\n\n*{caption}*"));
    }

    /// A fenced block; `language` may be `mermaid`, `sh`, `text` ...
    pub fn code(&mut self, language: &str, text: &str) {
        self.block(&format!("```{language}\n{}\n```", text.trim()));
    }

    /// The Markdown.
    #[must_use]
    pub fn markdown(&self) -> &str {
        &self.text
    }

    fn block(&mut self, text: &str) {
        self.text.push('\n');
        self.text.push_str(text);
        self.text.push('\n');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_parted_by_one_empty_line() {
        let mut document = Document::new("Title");
        document.heading(2, "Section");
        document.text("\nA paragraph.\n");
        let mut table = Table::new(&["a"]);
        table.row(["1"]);
        document.table(&table);
        document.figure("a.svg", "What it shows");
        document.code("sh", "ls\n");
        assert_eq!(
            document.markdown(),
            "# Title\n\n## Section\n\nA paragraph.\n\n| a |\n| ---: |\n| 1 |\n\n![What it shows](a.svg)\n\n*What it shows*\n\n```sh\nls\n```\n"
        );
    }
}
