//! The model description and the archive.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

use sphere_dda_fmi_interface::archive::{self, ArchiveError};
use sphere_dda_fmi_interface::guid as fingerprint;
use sphere_dda_fmi_interface::log::Category;
use sphere_dda_fmi_interface::platform::Platform;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::fmi2::{
    CoSimulation, DefaultExperiment, Initial, LogCategory, ModelDescription, RealVariable,
    ScalarVariable,
};
use sphere_dda_model_description::units::{BaseUnit, Unit};
use thiserror::Error as ThisError;

use crate::variables::{ACCELERATION, FORCE, TABLE, Variable};

/// Name of the library in the archive.
const IDENTIFIER: &str = "shaker";

const LICENSE: &str = include_str!("../../../../LICENSE-MIT");

const ABOUT: &str = "<!DOCTYPE html><html><head><title>Shaker</title></head><body><h1>Shaker</h1>\
<p>m x'' + d x' + k (x - A sin(2 pi f t)) = F + S, the force F held over every communication step, S a constant support; exact for every step.</p>\
</body></html>\n";

/// Why there is no FMU.
#[derive(Debug, ThisError)]
#[non_exhaustive]
pub enum ExportError {
    /// The description cannot be written.
    #[error(transparent)]
    Description(#[from] Error),
    /// The library of this crate is not there.
    #[error("cannot read `{}`: {source}; run `cargo build --release -p sphere-dda-shaker`", path.display())]
    Library {
        /// Where it was looked for.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// The archive cannot be written.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
}

/// Writes the FMU with the library that was built with this program.
///
/// # Errors
/// [`ExportError`].
pub fn export(fmu: &Path) -> Result<(), ExportError> {
    let name = format!(
        "{}{IDENTIFIER}{}",
        env::consts::DLL_PREFIX,
        env::consts::DLL_SUFFIX
    );
    let folder = env::current_exe().ok();
    let folder = folder
        .as_deref()
        .and_then(Path::parent)
        .unwrap_or(Path::new("."));
    // Cargo always puts the new library into `deps`, and beside the program only when it is asked for it.
    let built = folder.join("deps").join(&name);
    let path = if built.is_file() {
        built
    } else {
        folder.join(&name)
    };
    let library = fs::read(&path).map_err(|source| ExportError::Library { path, source })?;
    let xml = description()?.to_xml()?;
    let files = [
        ("modelDescription.xml".to_owned(), xml.as_bytes()),
        (Platform::HERE.path_2(IDENTIFIER), &library),
        ("documentation/index.html".to_owned(), ABOUT.as_bytes()),
        (
            "documentation/licenses/license.txt".to_owned(),
            LICENSE.as_bytes(),
        ),
    ];
    Ok(archive::write(fmu, &files)?)
}

/// The model description.
///
/// # Errors
/// None but those of the writer.
pub fn description() -> Result<ModelDescription, Error> {
    let mut model = unsigned();
    model.guid = guid()?;
    Ok(model)
}

/// The guid: hash of the description. The library refuses another.
///
/// # Errors
/// As [`description`].
pub fn guid() -> Result<String, Error> {
    Ok(fingerprint::guid(&[unsigned().to_xml()?.as_bytes()]))
}

fn unsigned() -> ModelDescription {
    let version = env!("CARGO_PKG_VERSION");
    let interface = CoSimulation {
        can_handle_variable_communication_step_size: true,
        can_not_use_memory_management_functions: true,
        can_get_and_set_fmu_state: true,
        can_serialize_fmu_state: true,
        ..CoSimulation::new(IDENTIFIER)
    };
    let variables = TABLE.iter().zip(0..).map(scalar).collect();
    let mut model = ModelDescription::new("Shaker", "", interface).with_variables(variables);
    // Indices count from 1. Only the acceleration shows a force before it has acted over a step.
    let (force, acceleration) = (FORCE as u32 + 1, ACCELERATION as u32 + 1);
    for output in &mut model.model_structure.outputs {
        let direct = output.index == acceleration;
        output.dependencies = Some(if direct { vec![force] } else { Vec::new() });
    }
    model.description = Some("Mass, spring and damper on a shaken foot, with a force".to_owned());
    model.version = Some(version.to_owned());
    model.license = Some("MIT OR Apache-2.0".to_owned());
    model.generation_tool = Some(format!("sphere-dda-shaker {version}"));
    model.unit_definitions = units();
    model.log_categories = Category::ALL
        .iter()
        .map(|category| LogCategory::new(category.name(), category.description()))
        .collect();
    model.default_experiment = Some(DefaultExperiment {
        start_time: Some(0.0),
        stop_time: Some(1.0),
        tolerance: None,
        step_size: Some(1e-3),
    });
    model
}

fn units() -> Vec<Unit> {
    let si = |name: &str, kg: i32, m: i32, s: i32| {
        let exponents = BaseUnit {
            kg,
            m,
            s,
            ..BaseUnit::DIMENSIONLESS
        };
        Unit::new(name, exponents)
    };
    vec![
        si("m", 0, 1, 0),
        si("m/s", 0, 1, -1),
        si("m/s2", 0, 1, -2),
        si("kg", 1, 0, 0),
        si("kg.m/s", 1, 1, -1),
        si("N", 1, 1, -2),
        si("N/m", 1, 0, -2),
        si("N.s/m", 1, 0, -1),
        si("Hz", 0, 0, -1),
    ]
}

fn scalar((variable, reference): (&Variable, u32)) -> ScalarVariable {
    let mut real = RealVariable::with_unit(variable.unit);
    real.start = variable.start;
    real.min = variable.least.map(|(least, _)| least);
    let scalar = ScalarVariable::new(
        variable.name,
        reference,
        variable.causality,
        variable.variability(),
        real,
    );
    let initial = matches!(
        (variable.causality, variable.start),
        (
            sphere_dda_model_description::fmi2::Causality::Output,
            Some(_)
        )
    );
    let scalar = if initial {
        scalar.with_initial(Initial::Exact)
    } else {
        scalar
    };
    scalar.with_description(variable.description)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_description_keeps_to_the_standard() {
        assert_eq!(description().unwrap().validate(), []);
    }
}
