//! `sphere-dda serve-fmu`: one FMU of a `simulate --isolate`, in this process.

use clap::Args;
use miette::miette;
use sphere_dda_master::serve;

use crate::failure::Failure;

/// Name of the subcommand.
pub(crate) const NAME: &str = "serve-fmu";

/// Arguments of `serve-fmu`: all that it needs comes from `simulate`.
#[derive(Debug, Args)]
pub(crate) struct ServeFmu {}

/// Serves until `simulate` closes the FMU or ends.
///
/// # Errors
/// It was not started by `simulate --isolate`.
pub(crate) fn run(_: &ServeFmu) -> Result<(), Failure> {
    // Ctrl-C and SIGTERM may come to all processes of a terminal or job: `simulate` ends this one.
    ctrlc::set_handler(|| ()).map_err(Failure::run)?;
    serve().map_err(|error| {
        Failure::Input(miette!(
            "{NAME}: {error}; it is started by `simulate --isolate` alone"
        ))
    })
}
