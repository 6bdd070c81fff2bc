//! Why a command ends without having done its work, and what it tells the shell.

use std::error::Error;
use std::process::ExitCode;

use miette::Report;
use sphere_dda::error::StepError;
use sphere_dda::formats::error::OutputError;
use sphere_dda::results::start_file::StartFileError;
use sphere_dda::scene_file::SceneError;
use sphere_dda::simulation::SettleError;
use sphere_dda_export::ExportError;
use sphere_dda_fmu::model::ModelError;
use sphere_dda_master::{
    ImportError, InputTableError, PackageError, ReferencesError, SimulateError, SspError,
    SystemError,
};

/// Why a command has not done its work.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Another scene, file or argument would do: exit code 2, as clap's own.
    Input(Report),
    /// Bad input whose problems were printed as the result: exit code 2.
    Told,
    /// The run itself failed: exit code 1.
    Run(Report),
    /// Ctrl-C, SIGTERM or SIGHUP, all files being complete: exit code 130, as shells have it.
    Interrupted,
}

impl Failure {
    /// Bad input, for the reason `error`.
    pub(crate) fn input(error: impl Error + Send + Sync + 'static) -> Self {
        Self::Input(told_once(error))
    }

    /// A failed run, for the reason `error`.
    pub(crate) fn run(error: impl Error + Send + Sync + 'static) -> Self {
        Self::Run(told_once(error))
    }

    /// Exit codes.
    pub(crate) fn code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::Run(_) => 1,
            Self::Input(_) | Self::Told => 2,
            Self::Interrupted => 130,
        })
    }
}

/// A report of an error whose message may already contain those of its causes: these are then not repeated.
fn told_once(error: impl Error + Send + Sync + 'static) -> Report {
    let text = error.to_string();
    let mut causes = std::iter::successors(error.source(), |&cause| cause.source());
    if causes.all(|cause| text.contains(&cause.to_string())) {
        return Report::msg(text);
    }
    Report::from_err(error)
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self::Input(error.into())
    }
}

impl From<ExportError> for Failure {
    fn from(error: ExportError) -> Self {
        match error {
            // As a diagnostic it shows the places in the text.
            ExportError::Model(ModelError::Scene(scene)) => (*scene).into(),
            other => Self::input(other),
        }
    }
}

impl From<StepError> for Failure {
    fn from(error: StepError) -> Self {
        Self::run(error)
    }
}

impl From<SettleError> for Failure {
    fn from(error: SettleError) -> Self {
        Self::run(error)
    }
}

impl From<StartFileError> for Failure {
    fn from(error: StartFileError) -> Self {
        Self::input(error)
    }
}

impl From<OutputError> for Failure {
    fn from(error: OutputError) -> Self {
        Self::input(error)
    }
}

impl From<ImportError> for Failure {
    fn from(error: ImportError) -> Self {
        Self::input(error)
    }
}

impl From<SspError> for Failure {
    fn from(error: SspError) -> Self {
        Self::input(error)
    }
}

impl From<SystemError> for Failure {
    fn from(error: SystemError) -> Self {
        Self::input(error)
    }
}

impl From<PackageError> for Failure {
    fn from(error: PackageError) -> Self {
        Self::input(error)
    }
}

impl From<InputTableError> for Failure {
    fn from(error: InputTableError) -> Self {
        Self::input(error)
    }
}

impl From<ReferencesError> for Failure {
    fn from(error: ReferencesError) -> Self {
        Self::input(error)
    }
}

impl From<SimulateError> for Failure {
    /// What happens after the start, and so leaves something recorded, is a failed run, and so is an FMU that does not come
    /// back from a call.
    fn from(error: SimulateError) -> Self {
        let lost = |error: &ImportError| {
            use ImportError::{Ended, TimedOut};
            matches!(error, Ended { .. } | TimedOut { .. })
        };
        let lost = matches!(&error, SimulateError::Import { source, .. } if lost(source));
        if lost || error.table().is_some() {
            Self::run(error)
        } else {
            Self::input(error)
        }
    }
}
