//! Terminals of a scene: one per boundary, with what belongs to its pose, twist, wrench and load.
//!
//! Members are the variables of either version, scalars or arrays, and keep their names without the boundary's, so that a driver that
//! names its variables alike connects by member name. Inputs and outputs of a boundary have different ones.

use sphere_dda::scene::Scene;
use sphere_dda_fmu::table::Entry;
use sphere_dda_model_description::terminals::{
    GraphicalRepresentation, Member, Terminal, TerminalsAndIcons,
};

/// Parts of a boundary's terminal: name, description, names of its variables without index.
const PARTS: [(&str, &str, &[&str]); 4] = [
    (
        "pose",
        "Where the boundary is, or shall be",
        &[
            "translation",
            "rotation",
            "displacement",
            "angle",
            "position",
            "orientation",
        ],
    ),
    (
        "twist",
        "How fast it moves, or shall move",
        &["velocity", "angularVelocity", "speed", "angularSpeed"],
    ),
    (
        "wrench",
        "Action of the spheres on it",
        &["force", "torque", "averageForce", "averageTorque"],
    ),
    (
        "load",
        "What acts on it from outside",
        &["appliedForce", "appliedTorque"],
    ),
];

/// Side of the icon \[mm\].
const ICON: f64 = 20.0;

/// The terminals of a scene, in its order, with its variables, and the place of `icon.png`, if there is one.
#[must_use]
pub(crate) fn terminals(scene: &Scene, variables: &[Entry], icon: bool) -> TerminalsAndIcons {
    let boundaries = scene.boundaries.iter();
    let all = boundaries.enumerate();
    let all = all.map(|(b, boundary)| terminal(b, &boundary.name, variables));
    let mut document = TerminalsAndIcons::new(all.collect());
    document.graphical_representation = icon.then(|| GraphicalRepresentation::square(ICON));
    document
}

fn terminal(b: usize, boundary: &str, variables: &[Entry]) -> Terminal {
    let mut whole = Terminal::bus(boundary, format!("Boundary {boundary}"));
    let mut parts = PARTS.map(|(name, text, _)| Terminal::bus(name, text));
    for entry in variables {
        let (Some((owner, field)), Some((_, name))) = (entry.variable.boundary, entry.member())
        else {
            continue;
        };
        if owner != b {
            continue;
        }
        let part = PARTS
            .iter()
            .position(|(_, _, fields)| fields.contains(&field));
        let members = match part {
            Some(part) => &mut parts[part].members,
            None => &mut whole.members,
        };
        members.push(Member::signal(entry.name(), name));
    }
    whole.terminals = parts.into();
    whole.terminals.retain(|part| !part.members.is_empty());
    whole
}
