//! Terminals of a scene: one per boundary, with what belongs to its pose, twist, wrench and load.
//!
//! Members are the variables of either version, scalars or arrays, and keep their names without the boundary's, so that two FMUs of this kind, or a
//! driver that names its variables alike, connect by member name.

use sphere_dda::scene::Scene;
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

/// The terminals of a scene, in its order, with its `variables` by name, and the place of `icon.png`, if there is one.
#[must_use]
pub(crate) fn terminals(scene: &Scene, variables: &[&str], icon: bool) -> TerminalsAndIcons {
    let boundaries = scene.boundaries.iter();
    let mut document =
        TerminalsAndIcons::new(boundaries.map(|b| terminal(&b.name, variables)).collect());
    document.graphical_representation = icon.then(|| GraphicalRepresentation::square(ICON));
    document
}

fn terminal(boundary: &str, variables: &[&str]) -> Terminal {
    let mut whole = Terminal::bus(boundary, format!("Boundary {boundary}"));
    let mut parts = PARTS.map(|(name, text, _)| Terminal::bus(name, text));
    let prefix = format!("boundary.{boundary}.");
    for variable in variables {
        let Some(name) = variable.strip_prefix(&prefix) else {
            continue;
        };
        let stem = name.split('[').next().unwrap_or(name);
        let part = PARTS.iter().position(|(_, _, stems)| stems.contains(&stem));
        let members = match part {
            Some(part) => &mut parts[part].members,
            None => &mut whole.members,
        };
        members.push(Member::signal(*variable, name));
    }
    whole.terminals = parts.into();
    whole.terminals.retain(|part| !part.members.is_empty());
    whole
}
