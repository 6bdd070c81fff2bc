//! The result files of an instance: `<output.directory>/<instance name>/`, following the instance through time.

use std::path::{Path, PathBuf};

use sphere_dda::formats::error::OutputError;
use sphere_dda::observe::Observation;
use sphere_dda::results::Options;
use sphere_dda::results::writer::{Results, Status};
use sphere_dda::simulation::Simulation;

use crate::table::Parameters;
use sphere_dda_fmi_interface::log::{Level, Log};

/// Writes result files, or nothing while `output.directory` is empty.
#[derive(Default)]
pub struct Recorder {
    results: Option<Results>,
    /// Where this instance has written before: its own earlier run may be replaced.
    own: Option<PathBuf>,
    failures: u64,
    /// Whether a folder that another instance writes to was reported.
    busy: bool,
}

impl Recorder {
    /// Begins in the directory that the parameters name, with the present state.
    ///
    /// # Errors
    /// [`OutputError::Exists`] where the run of another instance lies, unless `output.overwrite` is set;
    /// [`OutputError::Busy`] where one is being written, [`OutputError::Io`].
    pub fn open(
        &mut self,
        name: &str,
        parameters: &Parameters,
        simulation: &Simulation,
        log: &Log,
    ) -> Result<(), OutputError> {
        self.close(log);
        let Some(options) = self.options(name, parameters, simulation) else {
            return Ok(());
        };
        let directory = options.directory.clone();
        let results = Results::create(simulation.scene(), options)?;
        self.begin(results, directory, simulation, log);
        Ok(())
    }

    /// What to write where; `None`: nothing.
    fn options(
        &self,
        name: &str,
        parameters: &Parameters,
        simulation: &Simulation,
    ) -> Option<Options> {
        if parameters.output_directory.is_empty() {
            return None;
        }
        let directory = Path::new(&parameters.output_directory).join(folder(name));
        let mut options = Options::new(&directory, simulation.scene());
        options.overwrite = parameters.output_overwrite || self.own.as_ref() == Some(&directory);
        options.frame_interval = parameters.output_interval;
        options.hold = true;
        Some(options)
    }

    fn begin(&mut self, results: Results, directory: PathBuf, simulation: &Simulation, log: &Log) {
        log.write(
            Level::Ok,
            format_args!("results go to `{}`", directory.display()),
        );
        self.results = Some(results);
        self.own = Some(directory);
        self.failures = 0;
        self.record(simulation, log);
    }

    /// Takes what is due; files that could not be written are told in the log.
    pub fn record(&mut self, simulation: &Simulation, log: &Log) {
        let Some(results) = &mut self.results else {
            return;
        };
        results.record(&Observation::of(simulation));
        let status = results.status();
        self.report(status, log);
    }

    /// Tells of files that could not be written since the last time; whether there are none in all.
    fn report(&mut self, status: Status, log: &Log) -> bool {
        if status.failures > self.failures {
            self.failures = status.failures;
            let why = status.first_failure.unwrap_or_default();
            let text = format_args!(
                "{} results were not written; the first: {why}",
                status.failures
            );
            log.write(Level::Warning, text);
        }
        status.failures == 0
    }

    /// The importer will not go back before `time` \[s\] of the scene.
    pub fn commit(&mut self, time: f64) {
        if let Some(results) = &mut self.results {
            results.commit(time);
        }
    }

    /// A state was restored: what was recorded later is dropped. A new instance goes on with the files that the one
    /// which saved the state has left, or begins where there are none; it may drop what was recorded later only with
    /// `output.overwrite`.
    pub fn follow(
        &mut self,
        name: &str,
        parameters: &Parameters,
        simulation: &Simulation,
        log: &Log,
    ) {
        if let Some(results) = &mut self.results {
            return results.rollback(simulation.time());
        }
        let Some(options) = self.options(name, parameters, simulation) else {
            return;
        };
        let directory = options.directory.clone();
        match Results::follow(simulation.scene(), options, simulation.time()) {
            Ok(results) => self.begin(results, directory, simulation, log),
            // States that are exchanged between instances say so each time.
            Err(OutputError::Busy { .. }) if self.busy => {}
            Err(error) => {
                self.busy = matches!(error, OutputError::Busy { .. });
                let text = format_args!("no results are written: {error}");
                log.write(Level::Warning, text);
            }
        }
    }

    /// Writes everything and tells how it went. Whether all of this run was written; most of it is only now.
    pub fn close(&mut self, log: &Log) -> bool {
        let Some(results) = self.results.take() else {
            return true;
        };
        let status = results.finish();
        let text = format_args!("{} frames, {} rows written", status.frames, status.rows);
        log.write(Level::Ok, text);
        self.report(status, log)
    }
}

/// An instance name, which comes from the importer, as the name of one folder of any system.
fn folder(name: &str) -> String {
    let refused = |c: char| c.is_control() || "/\\:*?\"<>|".contains(c);
    // Windows drops dots and blanks at the end, and `..` leads elsewhere.
    let end = name.trim_end_matches(['.', ' ']).len();
    let place = |(k, c)| if refused(c) || k >= end { '_' } else { c };
    name.char_indices().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::folder;

    #[test]
    fn an_instance_name_is_one_folder_below() {
        for (name, expected) in [
            ("mill-1_a b", "mill-1_a b"),
            ("friction=0.4", "friction=0.4"),
            ("a/b\\c:d", "a_b_c_d"),
            ("..", "__"),
            ("a. ", "a__"),
            ("", ""),
        ] {
            assert_eq!(folder(name), expected);
        }
    }
}
