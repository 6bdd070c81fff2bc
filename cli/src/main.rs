//! The `sphere-dda` command: scenes in, results and FMUs out. Each subcommand is a file.

mod check;
mod export;
mod inspect;
mod simulate;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use miette::Report;
use sphere_dda::scene::SceneError;

/// Sphere-based 3-D discontinuous deformation analysis with augmented-Lagrangian contact.
#[derive(Debug, Parser)]
#[command(version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Check a scene: all its problems at once, or its counts, mass, extent, suggested step and penalty.
    Check(check::Check),
    /// Pack a scene into an FMU (FMI 2.0 co-simulation).
    Export(export::Export),
    /// Show what an FMU is and its variables.
    Inspect(inspect::Inspect),
    /// Run an FMU: any of FMI 2.0 for co-simulation.
    Simulate(simulate::Simulate),
}

/// 0: done; 1: the run failed; 2: bad input, as clap's own.
fn main() -> ExitCode {
    let done = match Arguments::parse().command {
        Command::Check(arguments) => check::run(&arguments),
        Command::Export(arguments) => export::run(&arguments),
        Command::Inspect(arguments) => inspect::run(&arguments),
        Command::Simulate(arguments) => simulate::run(&arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(report) => {
            let bad_input = bad_input(&report);
            eprintln!("{report:?}");
            ExitCode::from(if bad_input { 2 } else { 1 })
        }
    }
}

/// Whether the user can mend it by changing what was handed in.
fn bad_input(report: &Report) -> bool {
    report.is::<SceneError>()
}
