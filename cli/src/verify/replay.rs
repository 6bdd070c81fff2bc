//! `sphere-dda verify X.fmu`: the smoke tests that an FMU brings along, through the importer.

use std::path::Path;

use miette::miette;
use sphere_dda_master::{Fmu, InputTable, Options, References, SmokeTest, System};

use crate::failure::Failure;
use crate::progress::{Interrupt, count, print};
use crate::simulate::drive;

/// Replays all of them and compares.
///
/// # Errors
/// An FMU without smoke tests, files that were changed, a run that fails, results that are not those expected.
pub(super) fn run(path: &Path, interrupt: &Interrupt) -> Result<(), Failure> {
    let fmu = Fmu::open(path)?;
    let references = References::of(&fmu)?;
    let sums = match references.checked {
        Some(files) => format!("{} as exported", count(files as u64, "file")),
        None => "none, files are not checked".to_owned(),
    };
    print(|out| writeln!(out, "checksums       {sums}"))?;
    let mut faults = Vec::new();
    for test in &references.tests {
        let found = replay(&fmu, test, interrupt)?;
        faults.extend(
            found
                .into_iter()
                .map(|fault| format!("{}: {fault}", test.name)),
        );
    }
    match faults.is_empty() {
        true => Ok(()),
        false => Err(Failure::Run(miette!(
            "{}: {}",
            path.display(),
            faults.join("\n")
        ))),
    }
}

/// Runs one of them; what is not as expected.
fn replay(fmu: &Fmu, test: &SmokeTest, interrupt: &Interrupt) -> Result<Vec<String>, Failure> {
    let system = System::of(fmu);
    let inputs = test.inputs.as_deref();
    let inputs = inputs.map(|path| InputTable::from_csv(path, &system));
    let options = Options {
        start: test.times.start,
        stop: test.times.stop,
        step: test.times.step,
        inputs: inputs.transpose()?,
        outputs: test
            .expected
            .as_ref()
            .map(|expected| expected.names.clone()),
        ..Options::default()
    };
    let driven = drive(&system, &options, interrupt, |_| Ok(()));
    driven.end?;
    let (Some(expected), Some(table)) = (&test.expected, driven.table) else {
        print(|out| writeln!(out, "{:15} ran, no results to compare with", test.name))?;
        return Ok(Vec::new());
    };
    let compared = expected.compare(&table, test.tolerances);
    if compared.faults.is_empty() {
        print(|out| {
            writeln!(
                out,
                "{:15} {} of {} as expected: largest deviation {:.1e} of what is allowed",
                test.name,
                count(expected.len() as u64, "row"),
                count(expected.names.len() as u64, "variable"),
                compared.worst
            )
        })?;
    }
    Ok(compared.faults)
}
