//! Terminals of a scene: one per boundary, with what belongs to its pose, twist, wrench and load.
//!
//! Members of two terminals of the same name match where an output of one is what an input of the other asks for, so that a
//! body of one FMU and the boundary that follows it in another connect by member name: its pose goes one way, the average
//! force of the spheres back as its load. All other members have the variables' names without the boundary's.

use sphere_dda::scene::Scene;
use sphere_dda_fmu::table::Entry;
use sphere_dda_model_description::terminals::{
    GraphicalRepresentation, Member, Terminal, TerminalsAndIcons,
};

/// Parts of a boundary's terminal: name, description, and its members with the names of the variables that may be each,
/// without index; the first that the boundary has is the member.
type Part = (
    &'static str,
    &'static str,
    &'static [(&'static str, &'static [&'static str])],
);

const PARTS: [Part; 4] = [
    (
        "pose",
        "Where the boundary is, or shall be",
        &[
            ("translation", &["translation"]),
            ("rotation", &["rotation"]),
            ("position", &["targetPosition", "position"]),
            ("orientation", &["targetOrientation", "orientation"]),
        ],
    ),
    (
        "twist",
        "How fast it moves, or shall move",
        &[
            ("velocity", &["velocity"]),
            ("angularVelocity", &["angularVelocity"]),
        ],
    ),
    (
        "wrench",
        "Load on the boundary: that of the spheres, or what a body takes from outside",
        &[
            ("force", &["appliedForce", "averageForce"]),
            ("torque", &["appliedTorque", "averageTorque"]),
        ],
    ),
    (
        "joint",
        "The same along its slide or about its hinge",
        &[
            (
                "position",
                &["displacement", "angle", "jointTravel", "jointAngle"],
            ),
            ("speed", &["speed", "angularSpeed", "jointSpeed"]),
            (
                "effort",
                &["appliedForce", "appliedTorque", "slideForce", "hingeTorque"],
            ),
        ],
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
    let own: Vec<(&Entry, &str, String)> = variables
        .iter()
        .filter_map(|entry| {
            let ((owner, field), (_, name)) = (entry.variable.boundary?, entry.member()?);
            (owner == b).then_some((entry, field, name))
        })
        .collect();
    let mut whole = Terminal::bus(boundary, format!("Boundary {boundary}"));
    let mut taken = Vec::new();
    for (part, text, members) in PARTS {
        let mut part = Terminal::bus(part, text);
        // Only what goes along a slide or about a hinge is a single number.
        let fits = |entry: &Entry| entry.variable.components.is_empty() == (part.name == "joint");
        for (member, fields) in members {
            let has = |field: &&&str| own.iter().any(|(entry, of, _)| of == *field && fits(entry));
            let Some(field) = fields.iter().find(has) else {
                continue;
            };
            for (entry, _, name) in own.iter().filter(|(_, of, _)| of == field) {
                part.members.push(Member::signal(
                    entry.name(),
                    name.replacen(field, member, 1),
                ));
            }
            taken.push(*field);
        }
        if !part.members.is_empty() {
            whole.terminals.push(part);
        }
    }
    let others = own
        .into_iter()
        .filter(|(_, field, _)| !taken.contains(field));
    let signal = |(entry, _, name): (&Entry, &str, String)| Member::signal(entry.name(), name);
    whole.members = others.map(signal).collect();
    whole
}
