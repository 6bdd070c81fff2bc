//! What an FMU of sphere-dda writes in a simulation that ends with a page.

use std::fs;
use std::path::{Path, PathBuf};

use miette::miette;
use sphere_dda_fmu::model::SCENE_FILE;
use sphere_dda_master::Fmu;
use tempfile::TempDir;

use crate::arguments::free;
use crate::failure::Failure;
use crate::page;
use crate::progress::note;

/// The parameter that says where an FMU writes its frames.
const DIRECTORY: &str = "output.directory";

/// A page that is to be written, and the folder for the frames until then.
pub(crate) struct Recorded<'a> {
    page: &'a Path,
    folder: TempDir,
    /// Full name of the parameter.
    parameter: String,
}

impl<'a> Recorded<'a> {
    /// Prepares for the one FMU of sphere-dda among `fmus`; `set` is what the command line sets.
    ///
    /// # Errors
    /// None or several of them, frames that go elsewhere, a page that cannot be written.
    pub(crate) fn prepare(
        page: &'a Path,
        overwrite: bool,
        fmus: &[Fmu],
        set: &[(String, String)],
    ) -> Result<Self, Failure> {
        free("--view", page, "html", overwrite)?;
        let own = |fmu: &&Fmu| fmu.folder().join("resources").join(SCENE_FILE).exists();
        let own: Vec<&Fmu> = fmus.iter().filter(own).collect();
        let [fmu] = own[..] else {
            return Err(Failure::Input(miette!(
                "--view: found {} FMUs of sphere-dda, expected one, given as a file that ends with .fmu",
                own.len()
            )));
        };
        let name = fmu.path().file_stem().unwrap_or_default();
        let parameter = match fmus {
            [_] => DIRECTORY.to_owned(),
            _ => format!("{}.{DIRECTORY}", name.to_string_lossy()),
        };
        if set.iter().any(|(name, _)| *name == parameter) {
            return Err(Failure::Input(miette!(
                "--view: found `--set {parameter}=...` too, expected one of them: `sphere-dda view` shows what lies there"
            )));
        }
        // Beside the page: there must be room for the frames as well.
        let place = page.parent().filter(|place| *place != Path::new(""));
        let place = place.unwrap_or(Path::new("."));
        let folder = tempfile::tempdir_in(place).map_err(|error| {
            Failure::Input(miette!(
                "--view: cannot write into `{}`: {error}",
                place.display()
            ))
        })?;
        Ok(Self {
            page,
            folder,
            parameter,
        })
    }

    /// The start value that makes the FMU write its frames.
    pub(crate) fn setting(&self) -> (String, String) {
        let path = std::path::absolute(self.folder.path());
        let path = path.unwrap_or_else(|_| self.folder.path().to_path_buf());
        (self.parameter.clone(), path.display().to_string())
    }

    /// Where the outputs are kept for the plots.
    pub(crate) fn table(&self) -> PathBuf {
        self.folder.path().join("outputs.csv")
    }

    /// Writes the page.
    ///
    /// # Errors
    /// As [`page::end_with`]; an FMU that wrote nothing.
    pub(crate) fn show(&self) -> Result<(), Failure> {
        let below = fs::read_dir(self.folder.path()).map_err(Failure::run)?;
        let mut results = below.flatten().map(|entry| entry.path());
        let Some(results) = results.find(|path| path.join("run.json").exists()) else {
            return Err(Failure::Run(miette!(
                "--view: the FMU wrote no frames, expected `vtu_interval` greater than 0 in its scene: see what it logged"
            )));
        };
        let told = page::end_with(&results, &[self.table()], self.page)?;
        // The outputs may be on standard output.
        note(told);
        Ok(())
    }
}
