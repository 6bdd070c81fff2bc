//! `--dump-failed DIR`: contact problems of steps that miss their tolerances, as files.

use std::io;
use std::path::{Path, PathBuf};

use miette::miette;
use sphere_dda::formats::problem;
use sphere_dda::problem::reduction::Reduction;
use sphere_dda::simulation::Simulation;
use sphere_dda::step::FailedStep;

use crate::failure::Failure;
use crate::progress::{count, note};

/// Most files of a run.
const MOST: usize = 100;

/// Writes the steps of a run that missed their tolerances.
pub(crate) struct Dump {
    folder: PathBuf,
    scene: String,
    /// Number of the next file.
    next: usize,
    /// Whether a step missed its tolerances.
    missed: bool,
    written: usize,
    omitted: u64,
}

impl Dump {
    /// Has `simulation` keep such steps for `folder`; files of earlier runs stay.
    ///
    /// # Errors
    /// A folder that cannot be made.
    pub(crate) fn begin(
        folder: &Path,
        scene: &Path,
        simulation: &mut Simulation,
    ) -> Result<Self, Failure> {
        std::fs::create_dir_all(folder).map_err(|error| {
            let place = folder.display();
            Failure::Input(miette!(
                "--dump-failed: cannot make `{place}`: {error}; choose another folder"
            ))
        })?;
        simulation.keep_failed_steps(MOST);
        let last = last_number(folder).map_err(|error| {
            let place = folder.display();
            Failure::Input(miette!(
                "--dump-failed: cannot read `{place}`: {error}; choose another folder"
            ))
        })?;
        Ok(Self {
            folder: folder.to_path_buf(),
            scene: scene.display().to_string(),
            next: last + 1,
            missed: false,
            written: 0,
            omitted: 0,
        })
    }

    /// Writes what has come up since the last call.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(crate) fn write(&mut self, simulation: &mut Simulation) -> Result<(), Failure> {
        let (steps, omitted) = simulation.take_failed_steps();
        self.omitted = omitted;
        for step in steps {
            self.missed = true;
            let reduction = Reduction::of(&step.problem, &step.impulses);
            let path = self.folder.join(file(self.next));
            problem::write(&path, &reduction.problem, &self.notes(&step, &reduction))?;
            self.next += 1;
            self.written += 1;
        }
        Ok(())
    }

    fn notes(&self, step: &FailedStep, reduction: &Reduction) -> Vec<String> {
        let rows = step.problem.rows.len();
        let FailedStep {
            time, step, why, ..
        } = step;
        vec![
            format!("scene {}", self.scene),
            format!("internal step of {step:e} s from {time} s"),
            why.clone(),
            format!(
                "{rows} rows: {} contacts; {} eliminated (joints, springs); {} held at the impulses they had (resistances, \
                 and joints and springs beyond 300)",
                reduction.rows.len(),
                reduction.eliminated,
                reduction.held
            ),
        ]
    }

    /// Says how many there are.
    pub(crate) fn tell(&self) {
        let place = self.folder.display();
        match (self.written, self.omitted) {
            (0, _) if !self.missed => note(format_args!(
                "no step missed its tolerances: `{place}` got no file"
            )),
            (written, 0) => note(format_args!(
                "{} written to `{place}`",
                count(written as u64, "failed step")
            )),
            (written, omitted) => note(format_args!(
                "the first {written} of {} failed steps written to `{place}`",
                written as u64 + omitted
            )),
        }
    }
}

fn file(number: usize) -> String {
    format!("step-{number:04}.dat")
}

/// The largest number of a [`file`] in `folder`; 0 without one.
fn last_number(folder: &Path) -> io::Result<usize> {
    let mut last = 0;
    for entry in std::fs::read_dir(folder)? {
        let name = entry?.file_name();
        let digits = name.to_str().and_then(|name| {
            let name = name.strip_prefix("step-")?;
            name.strip_suffix(".dat")
        });
        let number = digits.and_then(|digits| digits.parse().ok());
        last = last.max(number.unwrap_or(0));
    }
    Ok(last)
}
