//! The `sphere-dda` command: scenes in, results and FMUs out. Each subcommand is a file.

#![allow(
    rustdoc::broken_intra_doc_links,
    reason = "`[s]` is a unit in the help that clap prints from these docs"
)]

mod arguments;
mod browser;
mod check;
mod corpus;
mod demo;
mod draft;
mod dump;
mod export;
mod failure;
mod inspect;
mod live;
mod movie;
mod new;
mod page;
mod progress;
mod recorded;
mod reference;
mod reproduce_paper;
mod run;
mod schema;
mod serve_fmu;
mod settle;
mod simulate;
mod study;
mod verify;
mod view;
mod walls;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use miette::MietteHandlerOpts;

use failure::Failure;
use progress::{Interrupt, note};

/// Sphere-based 3-D discontinuous deformation analysis with augmented-Lagrangian contact.
#[derive(Debug, Parser)]
#[command(
    name = "sphere-dda",
    version,
    arg_required_else_help = true,
    after_help = "\
Examples:
  sphere-dda demo
  sphere-dda new hopper silo
  sphere-dda run scene.toml -o results && sphere-dda view results --open
  sphere-dda view scene.toml --watch --open
  sphere-dda export scene.toml && sphere-dda simulate scene.fmu -o outputs.csv

Research: `sphere-dda reproduce-paper` and `sphere-dda verify` write the reports of docs/,
`sphere-dda corpus` solves contact problems in Siconos' format; see their --help.

Exit codes: 0 done; 1 the run failed; 2 invalid scene, file or argument; 130 ended by Ctrl-C, SIGTERM
or SIGHUP, all files are complete."
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Run the funnel example as an FMU and report how to look at it.
    Demo(demo::Demo),
    /// Begin a scene: a folder with a scene of a hopper, a drum ..., a Python driver and a README.
    New(new::New),
    /// Check a scene: report all its problems, or its counts, mass, extent and suggested step.
    Check(check::Check),
    /// Run a scene and write VTU, PVD and CSV files.
    Run(run::Run),
    /// Show results, a scene or an FMU in the browser: writes one HTML file.
    View(view::View),
    /// Draw results as a film (MP4, GIF) or a picture (PNG).
    Movie(movie::Movie),
    /// Print what the triangles of boundaries feel as CSV: pressure, shear, energies, wear.
    Walls(walls::Walls),
    /// Pack a scene into a co-simulation FMU of FMI 2.0 or 3.0.
    Export(export::Export),
    /// Show the capabilities and variables of an FMU.
    Inspect(inspect::Inspect),
    /// Simulate one or more coupled co-simulation FMUs (FMI 2.0 or 3.0) or an SSP; write outputs as CSV.
    Simulate(simulate::Simulate),
    /// Print the JSON schema of scene files, for editors, or their reference.
    Schema(schema::Schema),
    /// Run the paper's examples and write what it claims, as numbers, plots and pictures.
    #[command(hide = true)]
    ReproducePaper(reproduce_paper::ReproducePaper),
    /// One FMU of `simulate --isolate`, in a process of its own.
    #[command(name = serve_fmu::NAME, hide = true)]
    ServeFmu(serve_fmu::ServeFmu),
    /// Solve contact problems of others, or steps dumped by `run --dump-failed`, by every solver.
    #[command(hide = true)]
    Corpus(corpus::Corpus),
    /// Measure laws of granular matter (silo, outflow, collapse, repose) and write them as a report.
    #[command(hide = true)]
    Verify(verify::Verify),
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    // Messages stay on one line, so that they can be searched and copied. Set once, so it cannot fail.
    let _ = miette::set_hook(Box::new(|_| {
        Box::new(MietteHandlerOpts::new().wrap_lines(false).build())
    }));
    match dispatch(&arguments.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if let Failure::Input(report) | Failure::Run(report) = &failure {
                note(format_args!("{report:?}"));
            }
            failure.code()
        }
    }
}

fn dispatch(command: &Command) -> Result<(), Failure> {
    match command {
        Command::Demo(arguments) => demo::run(arguments, &Interrupt::listen()?),
        Command::New(arguments) => new::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        Command::View(arguments) => view::run(arguments, &Interrupt::listen()?),
        Command::Walls(arguments) => walls::run(arguments),
        Command::Movie(arguments) => movie::run(arguments, &Interrupt::listen()?),
        Command::Schema(arguments) => schema::run(arguments),
        Command::Run(arguments) => run::run(arguments, &Interrupt::listen()?),
        Command::ReproducePaper(arguments) => {
            reproduce_paper::run(arguments, &Interrupt::listen()?)
        }
        Command::Corpus(arguments) => corpus::run(arguments, &Interrupt::listen()?),
        Command::Verify(arguments) => verify::run(arguments, &Interrupt::listen()?),
        Command::Export(arguments) => export::run(arguments, &Interrupt::listen()?),
        Command::Inspect(arguments) => inspect::run(arguments),
        Command::ServeFmu(arguments) => serve_fmu::run(arguments),
        Command::Simulate(arguments) => simulate::run(arguments, &Interrupt::listen()?),
    }
}
