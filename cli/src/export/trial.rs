//! The smoke test of an FMU: it is exported, run through the importer, and exported again with what came out.

use std::path::{Path, PathBuf};

use clap::Args;
use sphere_dda_export::{Exported, Library, SmokeTest, Version};
use sphere_dda_master::{Fmu, InputTable, Options, System};

use super::{Given, write};
use crate::arguments::positive;
use crate::failure::Failure;
use crate::progress::Interrupt;
use crate::simulate::drive;

/// Communication steps of an experiment without a step of its own.
const STEPS: f64 = 500.0;

/// What the FMU is to prove itself with.
#[derive(Debug, Args)]
pub(crate) struct Trial {
    /// Run the FMU for this time [s] and pack the outputs with it, for `sphere-dda verify` and other importers (FMI-LS-REF). One
    /// of the platforms must be this one.
    #[arg(long, value_name = "SECONDS", value_parser = positive, conflicts_with = "ssp")]
    smoke_test: Option<f64>,
    /// Inputs over time in the smoke test: CSV, as for `simulate`.
    #[arg(long, value_name = "CSV", requires = "smoke_test")]
    smoke_input: Option<PathBuf>,
}

impl Trial {
    /// Exports `scene`, with the smoke test if one is asked for.
    ///
    /// # Errors
    /// As `write`; an FMU that cannot be run, inputs that it does not have, Ctrl-C.
    pub(super) fn write(
        &self,
        scene: Given<'_>,
        start: Option<Vec<u8>>,
        fmu: &Path,
        (libraries, version): (&[Library], Version),
        interrupt: &Interrupt,
    ) -> Result<Exported, Failure> {
        let Some(stop) = self.smoke_test else {
            return write(scene, start, fmu, (libraries, version), None);
        };
        let folder = tempfile::tempdir().map_err(Failure::run)?;
        let bare = folder.path().join(fmu.file_name().unwrap_or_default());
        write(scene, start.clone(), &bare, (libraries, version), None)?;
        let test = self.run(&Fmu::open(&bare)?, stop, interrupt)?;
        write(scene, start, fmu, (libraries, version), Some(&test))
    }

    fn run(&self, fmu: &Fmu, stop: f64, interrupt: &Interrupt) -> Result<SmokeTest, Failure> {
        let system = System::of(fmu);
        let input = self.smoke_input.as_deref();
        let table = input.map(|path| InputTable::from_csv(path, &system));
        let step = system.experiment().step_size.unwrap_or(stop / STEPS);
        let options = Options {
            start: Some(0.0),
            stop: Some(stop),
            step: Some(step),
            inputs: table.transpose()?,
            ..Options::default()
        };
        let driven = drive(&system, &options, interrupt, |_| Ok(()));
        driven.end?;
        let mut results = Vec::new();
        if let Some(table) = driven.table {
            table.write_csv(&mut results).map_err(Failure::run)?;
        }
        let inputs = input.map(std::fs::read).transpose();
        Ok(SmokeTest {
            stop,
            step,
            inputs: inputs.map_err(Failure::input)?,
            results,
        })
    }
}
