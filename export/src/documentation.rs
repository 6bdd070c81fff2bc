//! The pages inside an FMU: what the model is, its variables, settings and limits; licences.

use maud::{DOCTYPE, Markup, html};
use sphere_dda::integrator::Integrator;
use sphere_dda::scene::{About, Method};

use sphere_dda_fmu::model::Model;
use sphere_dda_fmu::table::{Entry, Enumeration, solver_value};
use sphere_dda_fmu::version::{VERSION, Version};
use sphere_dda_model_description::value::Value;

/// License of the library in the FMU.
pub const LICENSE: &str = "\
The shared library in this FMU is sphere-dda, licensed under either of
  - Apache License, Version 2.0 (https://www.apache.org/licenses/LICENSE-2.0)
  - MIT license (https://opensource.org/licenses/MIT)
at your option. The Rust crates it links, and their licenses, are in third-party.txt.
The scene in resources/ belongs to its author.
";

/// Licences of all crates that the library links, collected by `fmu/licences/collect.py`.
pub const THIRD_PARTY: &str = include_str!("../../fmu/licences/third-party.txt");

/// Picture of the scene beside the page.
pub const PICTURE_FILE: &str = "diagram.png";

// Long names break, so that the table is never wider than the window.
const STYLE: &str = "body{font-family:sans-serif;margin:2em;max-width:70em}td,th{text-align:left;padding:.1em .8em}\
                     td:first-child,td:last-child{min-width:12em;overflow-wrap:anywhere}";

const USE: [&str; 6] = [
    "All values are in SI units. Inputs at their start values mean: as in the scene.",
    "A pose, displacement or angle is the total from the scene; the boundary reaches it linearly at the end of the \
     communication step. A speed is held over the step.",
    "Forces and torques are those of the spheres on the boundary, torques about its reference point. averageForce is \
     impulse over communication step and conserves momentum.",
    "Outputs change by steps only, never by a set: there is no direct feedthrough. Directional derivatives are those of the \
     last step: of the outputs at its end by the inputs held over it.",
    "Time 0 of the scene is the start time of the experiment.",
    "Set output.directory to get VTU, PVD and CSV files in <directory>/<instance name>/.",
];

const RIGID: &str = "Spheres and boundaries are rigid; overlaps stay below the gap tolerance. Elastic waves, dents and breakage are not modelled.";

const ELASTIC: &str = "Contacts overlap under load as their materials say (maxCompression); what misses that stays below the gap tolerance. Waves and breakage are not modelled.";

const SPRINGS: &str = "Contacts are springs of the penalty number: overlaps grow with the load and with the inverse of that number.";

const LIMITS: [&str; 4] = [
    "Contacts are unilateral with Coulomb friction and Newton's restitution: no cohesion, no fluid.",
    "Steps that end before an impact do not see it: solver.step bounds the error in the time of an impact.",
    "A boundary that jumps by more than the smallest radius in one internal step is refused.",
    "With loose coupling a force fed back as motion is one communication step late; a mass moved by it must stay below a \
     share of the mass that carries it.",
];

const SOURCES: [&str; 3] = [
    "S. A. R. Beyabanaki, A. C. Bagtzoglou: Modified contact constraints in sphere-based 3-D DDA, American Journal of \
     Engineering Research 9(4), 2020, 171-180.",
    "G.-H. Shi (1988): Discontinuous Deformation Analysis. PhD thesis, University of California, Berkeley.",
    "J. J. Moreau (1999): Numerical aspects of the sweeping process. Computer Methods in Applied Mechanics and Engineering 177.",
];

/// `documentation/index.html` with the variables of `version`; `picture`: whether [`PICTURE_FILE`] lies beside it.
#[must_use]
pub fn page(model: &Model, version: Version, picture: bool) -> String {
    let scene = &model.scene;
    let title = &scene.title;
    let boundaries = match scene.boundaries.len() {
        1 => " boundary",
        _ => " boundaries",
    };
    let contact = match scene.settings.method {
        Method::Alm if scene.pairs.gives_way() => ELASTIC,
        Method::Alm => RIGID,
        Method::Penalty => SPRINGS,
    };
    let limits = [&[contact], &LIMITS[..]].concat();
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                title { (title) }
                style { (STYLE) }
            }
            body {
                h1 { (title) }
                p {
                    (scene.particles.len()) " rigid spheres and " (scene.boundaries.len()) (boundaries) ", solved by \
                    sphere-based three-dimensional discontinuous deformation analysis; sphere-dda " (VERSION) ", guid "
                    (model.guid) "."
                }
                @for line in said(&scene.about) { p { (line) } }
                @if picture {
                    p { img src=(PICTURE_FILE) alt="The scene at t = 0"; }
                }
                h2 { "Use" }
                (list(&USE))
                h2 { "Settings" }
                (settings(model))
                h2 { "Variables" }
                table {
                    tr { @for head in ["Name", "Causality", "Type", "Unit", "Start", "Meaning"] { th { (head) } } }
                    @for row in rows(model, version) {
                        tr { @for cell in row { td { (cell) } } } "\n"
                    }
                }
                h2 { "Validity" }
                (list(&limits))
                h2 { "Sources" }
                (list(&SOURCES))
                p { "Licences of the library: licenses/license.txt." }
            }
        }
    }
    .into_string()
        + "\n"
}

/// What the author of the scene says of it.
fn said(about: &About) -> Vec<String> {
    let named = |name, text: &Option<String>| text.as_ref().map(|text| format!("{name}{text}"));
    [
        named("", &about.description),
        named("Author: ", &about.author),
        named("Version: ", &about.version),
        named("Copyright: ", &about.copyright),
        named("Licence of the model: ", &about.license),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn list(items: &[&str]) -> Markup {
    html! { ul { @for item in items { li { (item) } } } }
}

fn settings(model: &Model) -> Markup {
    let s = &model.scene.settings;
    let penalty = s.penalty.map_or("chosen".into(), |p| format!("{p} N/m"));
    let method = match s.method {
        Method::Alm => "augmented Lagrangian",
        Method::Penalty => "contact springs",
    };
    let solver = Enumeration::SOLVER.item(solver_value(s.solver));
    let integrator = match s.integrator {
        Integrator::Moreau => "Moreau-Jean, velocity level",
        Integrator::Shi => "constant acceleration over the step",
    };
    let rows = [
        ("Largest internal step", format!("{} s", s.step)),
        ("Communication step", format!("{} s", s.communication_step)),
        ("Duration", format!("{} s", s.duration)),
        ("Contact enforcement", method.to_owned()),
        ("Integrator", integrator.to_owned()),
        ("Solver", solver.unwrap_or_default().to_owned()),
        ("Penalty number", penalty),
        (
            "Tolerances of gap, slip, force",
            format!(
                "{:e}, {:e}, {:e}",
                s.tolerance.gap, s.tolerance.slip, s.tolerance.force
            ),
        ),
    ];
    // Only spheres have a mass.
    let used = &model.scene.particles.material;
    let materials = model.scene.materials.iter().enumerate();
    let materials = materials.filter(|(k, _)| used.iter().any(|m| usize::from(*m) == *k));
    let starts = match &model.start {
        Some(_) => "with settled spheres, resources/start.state",
        None => "as placed by the scene",
    };
    html! {
        table {
            @for (name, value) in rows { tr { td { (name) } td { (value) } } }
            @for (_, m) in materials { tr { td { "Density of " (m.name) } td { (m.density) " kg/m3" } } }
            tr { td { "Start" } td { (starts) } }
        }
    }
}

/// Name, causality, type, unit, start and meaning of every variable.
fn rows(model: &Model, version: Version) -> Vec<[String; 6]> {
    let row = |entry: Entry| {
        let variable = entry.variable;
        let start = entry.start().iter().map(|s| named(s, variable.choices));
        let extents = variable.dims.iter().map(|n| format!("[{n}]"));
        [
            entry.name(),
            format!("{:?}", variable.causality).to_lowercase(),
            match version {
                Version::Two => variable.scalar.name_2(),
                Version::Three => format!("{}{}", variable.scalar, extents.collect::<String>()),
            },
            variable.unit.unwrap_or("-").to_owned(),
            start.collect::<Vec<_>>().join(" "),
            entry.description(),
        ]
    };
    let entries = model.table.entries(version);
    entries.into_iter().map(row).collect()
}

/// A value as people read it; one of an enumeration by its name.
fn named(value: &Value, choices: Option<&Enumeration>) -> String {
    match value {
        Value::Integer(value) if let Some(name) = choices.and_then(|c| c.item(*value)) => {
            name.to_owned()
        }
        Value::Real(value) => value.to_string(),
        Value::String(value) => format!("\"{value}\""),
        other => other.to_string(),
    }
}
