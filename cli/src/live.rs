//! `sphere-dda view SCENE|X.fmu --live`: a page in which the solver itself runs.

use std::sync::Arc;

use sphere_dda_export::{Version, core_module_of};
use sphere_dda_fmu::model::Model;
use sphere_dda_fmu::table::{Binding, Entry, Input, Variable};
use sphere_dda_model_description::fmi2::{Causality, Variability};
use sphere_dda_model_description::value::{ScalarType, Value};
use sphere_dda_picture::viewer::live::{
    About, BoundaryArrays, Control, Live, Output, SphereArrays,
};
use sphere_dda_picture::viewer::{Options, Recording, Table};

use crate::failure::Failure;
use crate::page;

/// What is plotted of every boundary, whether the scene asks for it or not.
const FELT: [&str; 2] = ["averageForce", "averageTorque"];

/// The scene of a model as it starts, with the solver.
///
/// # Errors
/// No module of WebAssembly beside this program, and as [`page::of_scene`].
pub(crate) fn of_model(model: Model) -> Result<(Recording, Options), Failure> {
    let module = core_module_of(&model).map_err(Failure::input)?;
    let (about, columns) = about(&model);
    let (recording, mut options) = page::of_scene(Arc::unwrap_or_clone(model.scene), &[])?;
    options.tables = vec![Table::empty("outputs", columns)];
    options.live = Some(Live { module, about });
    Ok((recording, options))
}

/// What the page has to know, and the columns of its table of outputs by name and unit.
fn about(model: &Model) -> (About, Vec<(String, String)>) {
    let (scene, table) = (&model.scene, &model.table);
    let entries = table.entries(Version::Three);
    let reference = |name: &str| {
        let found = entries.iter().find(|entry| entry.variable.name == name);
        found.map(|entry| entry.reference)
    };
    let spheres = || {
        Some(SphereArrays {
            radius: reference("spheres.radius")?,
            present: reference("spheres.present")?,
            position: reference("spheres.position")?,
            velocity: reference("spheres.velocity")?,
            angular_velocity: reference("spheres.angularVelocity")?,
            contacts: reference("contacts.document")?,
        })
    };
    let boundaries = || {
        Some(BoundaryArrays {
            position: reference("boundaries.position")?,
            orientation: reference("boundaries.orientation")?,
            force: reference("boundaries.force")?,
        })
    };
    let is_whole = |entry: &Entry<'_>| entry.variable.scalar == ScalarType::Int32;
    let mut shown: Vec<&Entry<'_>> = entries.iter().filter(|e| is_shown(e.variable)).collect();
    // The page reads whole numbers after the others.
    shown.sort_by_key(|entry| is_whole(entry));
    let output = |entry: &&Entry<'_>| Output {
        reference: entry.reference,
        whole: is_whole(entry),
    };
    let columns = shown.iter().flat_map(|entry| {
        let variable = entry.variable;
        let unit = variable.unit.unwrap_or_default();
        (0..variable.count()).map(move |k| (variable.element(k), unit.to_owned()))
    });
    // Gravity comes behind the inputs of the scene.
    let mut controls: Vec<Control> = entries.iter().flat_map(controls).collect();
    controls.sort_by_key(|control| !control.input);
    let about = About {
        token: model.guid.clone(),
        step: scene.settings.communication_step,
        mass: scene.particles.mass.iter().sum(),
        materials: scene.particles.material.iter().map(|&m| m.into()).collect(),
        spheres: spheres(),
        boundaries: boundaries(),
        controls,
        outputs: shown.iter().map(output).collect(),
    };
    (about, columns.collect())
}

/// Outputs, and the forces on all boundaries.
fn is_shown(variable: &Variable) -> bool {
    let is_number = matches!(variable.scalar, ScalarType::Float64 | ScalarType::Int32);
    let is_felt = variable
        .boundary
        .is_some_and(|(_, name)| FELT.contains(&name));
    let is_output = variable.causality == Causality::Output || is_felt;
    is_number && is_output && matches!(variable.binding, Binding::Output(_))
}

/// Sliders of a variable: of inputs of boundaries and tunable parameters. A quaternion has none, its numbers belong together.
fn controls(entry: &Entry<'_>) -> Vec<Control> {
    let variable = entry.variable;
    let input = match variable.binding {
        Binding::Input { input, .. } if input != Input::Orientation => true,
        Binding::Parameter(_) if variable.variability == Variability::Tunable => false,
        _ => return Vec::new(),
    };
    let control = |(k, start): (usize, &Value)| match start {
        Value::Real(start) => Some(Control {
            variable: variable.name.clone(),
            name: variable.element(k),
            text: entry.description(),
            unit: variable.unit,
            reference: entry.reference,
            input,
            start: *start,
            min: variable.min,
            max: variable.max,
        }),
        _ => None,
    };
    variable
        .start
        .iter()
        .enumerate()
        .filter_map(control)
        .collect()
}
