//! The folder of a report: files by name, written together.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::error::ReportError;

/// Files of a report, by name.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Folder {
    files: BTreeMap<String, String>,
}

impl Folder {
    /// Adds a file; a name that is there already is replaced.
    pub fn add(&mut self, name: impl Into<String>, content: impl Into<String>) {
        self.files.insert(name.into(), content.into());
    }

    /// Names and contents, by name.
    pub fn files(&self) -> impl Iterator<Item = (&str, &str)> {
        self.files.iter().map(|(n, c)| (n.as_str(), c.as_str()))
    }

    /// Makes sure that a report can be written to `folder`: it is made if missing, and holds nothing unless `overwrite`.
    ///
    /// # Errors
    /// [`ReportError::Occupied`], or what the disk says.
    pub fn claim(folder: &Path, overwrite: bool) -> Result<(), ReportError> {
        let disk = |error| ReportError::Disk {
            path: folder.to_owned(),
            error,
        };
        fs::create_dir_all(folder).map_err(disk)?;
        let occupied = fs::read_dir(folder).map_err(disk)?.next().is_some();
        if occupied && !overwrite {
            return Err(ReportError::Occupied(folder.to_owned()));
        }
        Ok(())
    }

    /// Writes every file below `folder`, making sub-folders as names ask for them.
    ///
    /// # Errors
    /// What the disk says, with the file's path.
    pub fn write(&self, folder: &Path) -> Result<(), ReportError> {
        for (name, content) in &self.files {
            let path = folder.join(name);
            let parent = path.parent().unwrap_or(folder);
            fs::create_dir_all(parent)
                .and_then(|()| fs::write(&path, content))
                .map_err(|error| ReportError::Disk { path, error })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_with_something_in_it_is_claimed_only_to_overwrite() {
        let place = tempfile::tempdir().expect("a folder");
        let target = place.path().join("a/b");
        let mut folder = Folder::default();
        folder.add("x.md", "one");
        folder.add("x/y.svg", "two");
        Folder::claim(&target, false).expect("new");
        folder.write(&target).expect("written");
        assert_eq!(
            fs::read_to_string(target.join("x/y.svg")).expect("file"),
            "two"
        );
        let refused = Folder::claim(&target, false);
        assert!(matches!(refused, Err(ReportError::Occupied(_))));
        Folder::claim(&target, true).expect("overwritten");
    }
}
