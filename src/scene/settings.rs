//! Settings of the run, and materials.

use super::decode::SceneFile;
use super::document::Document;
use super::frame::{gravity, rotating_frame};
use super::resources::Resources;
use super::{Integrator, Method, Settings, Tolerance, file};
use crate::materials::Material;

/// `[simulation]`, checked.
pub(super) fn settings(
    document: &mut Document<'_>,
    resources: &mut Resources<'_>,
    s: &file::Simulation,
) -> Option<Settings> {
    let at = |key: &str| format!("simulation.{key}");
    document.demand(
        s.duration > 0.0,
        at("duration"),
        s.duration,
        "a time > 0 [s]",
    );
    document.demand(s.step > 0.0, at("step"), s.step, "a time > 0 [s]");
    let communication_step = s.communication_step.unwrap_or(s.step);
    if s.communication_step.is_some() {
        document.demand(
            communication_step > 0.0,
            at("communication_step"),
            communication_step,
            "a time > 0 [s]",
        );
    }
    if let Some(smallest) = s.smallest_step {
        document.demand(
            smallest > 0.0 && smallest <= s.step,
            at("smallest_step"),
            smallest,
            "0 < smallest_step <= step [s]",
        );
    }
    document.demand(
        s.rest_speed >= 0.0 && s.rest_speed.is_finite(),
        at("rest_speed"),
        s.rest_speed,
        "a speed >= 0 [m/s]",
    );
    if let Some(sweeps) = s.sweeps {
        document.demand(sweeps > 0, at("sweeps"), sweeps, "a whole number > 0");
    }
    if let Some(penalty) = s.penalty {
        document.demand(
            penalty > 0.0,
            at("penalty"),
            penalty,
            "a stiffness > 0 [N/m]",
        );
    } else if s.method == Method::Penalty {
        let help =
            "add `penalty = ...` in N/m; `sphere-dda check` suggests one, or use method = \"alm\"";
        document.error(
            "simulation",
            "missing key `penalty`, which method = \"penalty\" needs",
            help,
        );
    }
    let overlap = s.max_initial_overlap;
    document.demand(
        (0.0..=0.5).contains(&overlap),
        at("max_initial_overlap"),
        overlap,
        "0 <= max_initial_overlap <= 0.5 [-]",
    );
    let threshold = s.threshold_velocity;
    document.demand(
        threshold >= 0.0,
        at("threshold_velocity"),
        threshold,
        "a speed >= 0 [m/s]",
    );
    let kept = s.dynamic_coefficient;
    document.demand(
        (0.0..=1.0).contains(&kept),
        at("dynamic_coefficient"),
        kept,
        "0 <= dynamic_coefficient <= 1 [-]",
    );
    if s.integrator == Integrator::Moreau && kept != 1.0 {
        document.warn(
            at("dynamic_coefficient"),
            "has no effect with integrator = \"moreau\"",
            "remove it or use \"shi\"",
        );
    }
    document.demand(
        s.max_iterations >= 1,
        at("max_iterations"),
        s.max_iterations,
        "a count >= 1",
    );
    document.demand(
        s.max_cuts <= 20,
        at("max_cuts"),
        s.max_cuts,
        "0 <= max_cuts <= 20",
    );
    document.demand(
        (1..=256).contains(&s.threads),
        at("threads"),
        s.threads,
        "1 <= threads <= 256",
    );
    let tolerance = Tolerance {
        gap: s.tolerance.gap,
        slip: s.tolerance.slip,
        force: s.tolerance.force,
    };
    for (key, value) in [
        ("gap", tolerance.gap),
        ("slip", tolerance.slip),
        ("force", tolerance.force),
    ] {
        let path = format!("simulation.tolerance.{key}");
        document.demand(
            (1e-12..=1e-1).contains(&value),
            path,
            format!("{value:e}"),
            "1e-12 to 1e-1 [-]",
        );
    }
    let gravity = gravity(document, resources, s);
    let frame = s
        .rotating_frame
        .map(|frame| rotating_frame(document, frame));
    let (gravity, gravity_motion) = gravity?;
    Some(Settings {
        gravity,
        gravity_motion,
        rotating_frame: match frame {
            Some(checked) => Some(checked?),
            None => None,
        },
        duration: s.duration,
        step: s.step,
        smallest_step: s.smallest_step,
        rest_speed: s.rest_speed,
        sweeps: s.sweeps.map(|n| n as usize),
        communication_step,
        method: s.method,
        integrator: s.integrator,
        solver: s.solver,
        penalty: s.penalty,
        adapt_penalty: s.adapt_penalty,
        tolerance,
        max_initial_overlap: overlap,
        threshold_velocity: threshold,
        dynamic_coefficient: kept,
        max_iterations: s.max_iterations as usize,
        max_cuts: s.max_cuts,
        threads: s.threads as usize,
    })
}

/// `[[material]]`, checked.
pub(super) fn materials(document: &mut Document<'_>, file: &SceneFile) -> Vec<Material> {
    let materials = file.materials.iter().map(|element| {
        let density = element.value.as_ref().and_then(|m| m.density);
        if let Some(density) = density {
            document.demand(
                density > 0.0,
                format!("{}.density", element.path),
                density,
                "a density > 0 [kg/m^3]",
            );
        }
        // A material of boundaries only has no density; 1 keeps an unusable element's spheres finite until the
        // scene is refused.
        Material {
            name: element.name.clone().unwrap_or_default(),
            density: density.filter(|d| *d > 0.0).unwrap_or(1.0),
        }
    });
    materials.collect()
}
