//! A report under construction: its document and, in a folder of its own name, drawings and tables.

use sphere_dda_picture::plot::Plot;

use crate::document::Document;
use crate::error::ReportError;
use crate::folder::Folder;
use crate::table::Table;

/// A report under construction.
#[derive(Debug, Clone)]
pub struct Report {
    /// The document.
    pub document: Document,
    folder: Folder,
    name: String,
}

impl Report {
    /// An empty report: `NAME.md` with `title`, its files in `NAME/`.
    #[must_use]
    pub fn new(name: &str, title: &str) -> Self {
        Self {
            document: Document::new(title),
            folder: Folder::default(),
            name: name.to_owned(),
        }
    }

    /// A table in the document, and beside it as CSV.
    ///
    /// # Errors
    /// [`ReportError::Table`].
    pub fn table(&mut self, name: &str, table: &Table) -> Result<(), ReportError> {
        let file = format!("{}/{name}.csv", self.name);
        self.folder.add(&file, table.csv(name)?);
        self.document.table(table);
        self.document.text(&format!("[{name}.csv]({file})"));
        Ok(())
    }

    /// A plot; one without points that its axes can show is left out: a trial may be too short for it.
    ///
    /// # Errors
    /// [`ReportError::Drawing`].
    pub fn plot(&mut self, name: &str, plot: &Plot, caption: &str) -> Result<(), ReportError> {
        if plot.shows() {
            self.picture(name, plot.svg()?, caption);
        }
        Ok(())
    }

    /// A drawing.
    pub fn picture(&mut self, name: &str, svg: String, caption: &str) {
        let file = format!("{}/{name}.svg", self.name);
        self.folder.add(&file, svg);
        self.document.figure(&file, caption);
    }

    /// The files.
    #[must_use]
    pub fn finish(mut self) -> Folder {
        let document = self.document.markdown();
        self.folder.add(format!("{}.md", self.name), document);
        self.folder
    }
}
