//! The result files of an instance: `<output.directory>/<instance name>/`, following the instance through time.

use std::path::{Path, PathBuf};

use sphere_dda::observe::Observation;
use sphere_dda::observe::error::OutputError;
use sphere_dda::observe::writer::{Options, Results};
use sphere_dda::simulation::Simulation;

use crate::variables::Parameters;
use sphere_dda_fmi_interface::log::{Level, Log};

/// Writes result files, or nothing while `output.directory` is empty.
#[derive(Default)]
pub struct Recorder {
    results: Option<Results>,
    /// Where this instance has written before: its own earlier run may be replaced.
    own: Option<PathBuf>,
    failures: u64,
}

impl Recorder {
    /// Opens the directory that the parameters name and records the present state.
    ///
    /// # Errors
    /// [`OutputError::Exists`] where the run of another instance lies, unless `output.overwrite` is set;
    /// [`OutputError::Io`].
    pub fn open(
        &mut self,
        name: &str,
        parameters: &Parameters,
        simulation: &Simulation,
        log: &Log,
    ) -> Result<(), OutputError> {
        self.close(log);
        if parameters.output_directory.is_empty() {
            return Ok(());
        }
        let directory = Path::new(&parameters.output_directory).join(folder(name));
        let mut options = Options::new(&directory, simulation.scene());
        options.overwrite = parameters.output_overwrite || self.own.as_ref() == Some(&directory);
        options.frame_interval = parameters.output_interval;
        options.hold = true;
        self.results = Some(Results::create(simulation.scene(), options)?);
        log.write(
            Level::Ok,
            format_args!("results go to `{}`", directory.display()),
        );
        self.own = Some(directory);
        self.failures = 0;
        self.record(simulation, log);
        Ok(())
    }

    /// Takes what is due; files that could not be written are told in the log.
    pub fn record(&mut self, simulation: &Simulation, log: &Log) {
        let Some(results) = &mut self.results else {
            return;
        };
        results.record(&Observation::of(simulation));
        let status = results.status();
        if status.failures > self.failures {
            self.failures = status.failures;
            let why = status.first_failure.unwrap_or_default();
            let text = format_args!(
                "{} results were not written; the first: {why}",
                status.failures
            );
            log.write(Level::Warning, text);
        }
    }

    /// The importer will not go back before `time` \[s\] of the scene.
    pub fn commit(&mut self, time: f64) {
        if let Some(results) = &mut self.results {
            results.commit(time);
        }
    }

    /// A state was restored: what was recorded later is dropped, or, in a new instance, recording begins.
    pub fn follow(
        &mut self,
        name: &str,
        parameters: &Parameters,
        simulation: &Simulation,
        log: &Log,
    ) {
        if let Some(results) = &mut self.results {
            results.rollback(simulation.time());
        } else if let Err(error) = self.open(name, parameters, simulation, log) {
            log.write(
                Level::Warning,
                format_args!("no results are written: {error}"),
            );
        }
    }

    /// Writes everything and says how it went.
    pub fn close(&mut self, log: &Log) {
        if let Some(results) = self.results.take() {
            let status = results.finish();
            let text = format_args!("{} frames, {} rows written", status.frames, status.rows);
            log.write(Level::Ok, text);
        }
    }
}

/// An instance name, which comes from the importer, as the name of one folder.
fn folder(name: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_ ".contains(c);
    name.chars()
        .map(|c| if plain(c) { c } else { '_' })
        .collect()
}
