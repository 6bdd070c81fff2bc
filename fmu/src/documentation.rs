//! The pages inside an FMU: what the model is, its variables, its license.

use std::fmt::Write as _;

use crate::description::VERSION;
use crate::model::Model;
use crate::variables::{Value, Variable};

/// License of the library in the FMU.
pub const LICENSE: &str = "\
The shared library in this FMU is sphere-dda, licensed under either of
  - Apache License, Version 2.0 (https://www.apache.org/licenses/LICENSE-2.0)
  - MIT license (https://opensource.org/licenses/MIT)
at your option. It links Rust crates under the same or similarly permissive licenses.
The scene in resources/ belongs to its author.
";

/// `documentation/index.html`.
#[must_use]
pub fn page(model: &Model) -> String {
    let scene = &model.scene;
    let title = escaped(&scene.title);
    let rows: String = model.table.variables().iter().map(row).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\n\
         <style>body{{font-family:sans-serif;margin:2em;max-width:70em}}td,th{{text-align:left;padding:.1em .8em}}</style>\n\
         </head><body>\n<h1>{title}</h1>\n\
         <p>{spheres} rigid spheres and {boundaries} boundaries, solved by sphere-based three-dimensional discontinuous \
         deformation analysis; sphere-dda {VERSION}, guid {guid}.</p>\n\
         <h2>Use</h2>\n<ul>\n\
         <li>All values are in SI units. Inputs at their start values mean: as in the scene.</li>\n\
         <li>A pose, displacement or angle is the total from the scene; the boundary reaches it linearly at the end of the \
         communication step. A speed is held over the step.</li>\n\
         <li>Forces and torques are those of the spheres on the boundary, torques about its point of action. \
         <code>averageForce</code> is impulse over communication step and conserves momentum.</li>\n\
         <li>Time 0 of the scene is the start time of the experiment.</li>\n\
         <li>Set <code>output.directory</code> to get VTU, PVD and CSV files in &lt;directory&gt;/&lt;instance name&gt;/.</li>\n\
         </ul>\n<h2>Variables</h2>\n<table>\n\
         <tr><th>Name</th><th>Causality</th><th>Type</th><th>Unit</th><th>Start</th><th>Meaning</th></tr>\n\
         {rows}</table>\n</body></html>\n",
        spheres = scene.particles.len(),
        boundaries = scene.boundaries.len(),
        guid = model.guid,
    )
}

fn row(variable: &Variable) -> String {
    let start = match &variable.start {
        Some(Value::Real(value)) => value.to_string(),
        Some(Value::Integer(value)) => value.to_string(),
        Some(Value::Boolean(value)) => value.to_string(),
        Some(Value::String(value)) => format!("\"{value}\""),
        None => String::new(),
    };
    let causality = format!("{:?}", variable.causality).to_lowercase();
    let kind = format!("{:?}", variable.base);
    let cells = [
        &variable.name,
        &causality,
        &kind,
        variable.unit.unwrap_or("-"),
        &start,
        &variable.description,
    ];
    let mut html = String::from("<tr>");
    for cell in cells {
        // Writing to a String cannot fail.
        let _ = write!(html, "<td>{}</td>", escaped(cell));
    }
    html + "</tr>\n"
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
