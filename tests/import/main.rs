//! The importer against an FMU that is not of this project: `tests/foreign_fmu`, built with `cc` here.

mod at_once;
mod coupling;
mod events;
#[path = "../foreign_fmu/mod.rs"]
mod foreign_fmu;
mod instance;
mod iterated;
mod reference;
mod refusals;
mod simulation;
mod ssp;

use std::ops::ControlFlow;

use foreign_fmu::{Build, pack};
use sphere_dda_master::{Fmu, Options, SimulateError, System, Table, simulate};

fn open(build: Build) -> (tempfile::TempDir, Fmu) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("oscillator.fmu");
    pack(&path, build, |_| ());
    let fmu = Fmu::open(&path).unwrap();
    (folder, fmu)
}

fn drive(system: &System<'_>, options: &Options) -> Result<Table, SimulateError> {
    simulate(system, options, |_| ControlFlow::Continue(()))
}

fn run(fmu: &Fmu, options: &Options) -> Result<Table, SimulateError> {
    drive(&System::of(fmu), options)
}

fn with(set: &[(&str, &str)]) -> Options {
    Options {
        set: set
            .iter()
            .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()))
            .collect(),
        ..Options::default()
    }
}

fn trace(fmu: &Fmu) -> Vec<String> {
    let text = std::fs::read_to_string(fmu.folder().join("resources/trace.txt")).unwrap();
    text.lines().map(str::to_owned).collect()
}

/// Displacement [m] at `t` [s] of m x'' + c x' + k x = F from x0 at rest.
fn closed_form(t: f64, x0: f64, force: f64) -> f64 {
    let (m, c, k) = (2.0_f64, 0.4, 8.0);
    let (decay, rest) = (c / (2.0 * m), force / k);
    let omega = (k / m - decay * decay).sqrt();
    let a = x0 - rest;
    rest + (-decay * t).exp() * (a * (omega * t).cos() + a * decay / omega * (omega * t).sin())
}
