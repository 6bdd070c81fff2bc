//! Settings of the run, and materials.

use std::f64::consts::PI;

use super::decode::SceneFile;
use super::document::Document;
use super::file;
use super::frame::{gravity, rotating_frame};
use super::resources::Resources;
use crate::integrator::Integrator;
use crate::scene::accuracy::round_time;
use crate::scene::materials::Material;
use crate::scene::particles::{Kinematics, Particles};
use crate::scene::{Boundary, Method, Motion, Settings};
use crate::solver::Tolerance;

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
    for (key, value) in [
        ("step", s.step),
        ("communication_step", s.communication_step),
    ] {
        if let Some(value) = value {
            document.demand(value > 0.0, at(key), value, "a time > 0 [s]");
        }
    }
    if let Some(smallest) = s.smallest_step {
        document.demand(
            smallest > 0.0 && s.step.is_none_or(|step| smallest <= step),
            at("smallest_step"),
            smallest,
            "0 < smallest_step <= step [s]",
        );
    }
    if s.fixed_step && s.step.is_none() {
        document.error(
            "simulation",
            "missing key `step`, which fixed_step = true needs",
            "add `step = ...` in s, or remove `fixed_step`",
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
    let own = s.accuracy.tolerance();
    let tolerance = Tolerance {
        gap: s.tolerance.gap.unwrap_or(own.gap),
        slip: s.tolerance.slip.unwrap_or(own.slip),
        force: s.tolerance.force.unwrap_or(own.force),
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
    let opening = s.tolerance.opening;
    let opening = opening.unwrap_or_else(|| (s.accuracy.opening() * tolerance.gap).min(0.1));
    document.demand(
        (0.0..=1e-1).contains(&opening),
        at("tolerance.opening"),
        format!("{opening:e}"),
        "0 to 1e-1 [-]",
    );
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
        // Where the file gives none, they follow from the spheres: `choose_steps`.
        step: s.step.unwrap_or(f64::INFINITY),
        smallest_step: s.smallest_step,
        accuracy: s.accuracy,
        rest_speed: s.rest_speed,
        sweeps: s.sweeps.map(|n| n as usize),
        communication_step: s.communication_step.unwrap_or(f64::INFINITY),
        method: s.method,
        integrator: s.integrator,
        solver: s.solver,
        penalty: s.penalty,
        adapt_penalty: s.adapt_penalty,
        tolerance,
        opening,
        strict: s.strict,
        max_initial_overlap: overlap,
        threshold_velocity: threshold,
        dynamic_coefficient: kept,
        max_iterations: s.max_iterations as usize,
        max_cuts: s.max_cuts,
        threads: s.threads as usize,
    })
}

/// Shortest time \[s\] in which gravity, the centrifugal force or the pressure of a servo wall moves a sphere by half its radius.
pub(super) fn fall(
    settings: &Settings,
    (particles, initial): (&Particles, &Kinematics),
    boundaries: &[Boundary],
) -> f64 {
    let pressure = boundaries
        .iter()
        .filter_map(|boundary| match &boundary.motion {
            Motion::Driven(body) => body.servo.as_ref(),
            _ => None,
        })
        .fold(0.0, |most: f64, servo| most.max(servo.pressure.abs()));
    let acceleration = |i: usize| {
        let frame = settings.rotating_frame.as_ref();
        let centrifugal = frame.map_or(0.0, |frame| frame.centrifugal(initial.position[i]).norm());
        let radius = particles.radius[i];
        let pressed = pressure * PI * radius * radius / particles.mass[i];
        (settings.gravity.norm() + centrifugal).max(pressed)
    };
    let times = (0..particles.radius.len()).map(|i| (particles.radius[i] / acceleration(i)).sqrt());
    times.fold(f64::INFINITY, f64::min)
}

/// Steps that the file leaves open, once it is known how fast spheres [`fall`].
pub(super) fn choose_steps(settings: &mut Settings, file: &file::Simulation, fall: f64) {
    let (longest, shortest) = settings.accuracy.step_range(fall, settings.duration);
    let scheme_of_its_own =
        settings.integrator == Integrator::Shi || settings.method == Method::Penalty;
    let fixed = file.fixed_step || (scheme_of_its_own && file.step.is_some());
    match (fixed, file.step) {
        (true, Some(step)) => {
            settings.step = step;
            settings.smallest_step = file.smallest_step;
        }
        (_, step) => {
            // Whoever names a smallest step means the range that is named.
            let step = match (step, file.smallest_step) {
                (Some(step), Some(_)) => step,
                (Some(step), None) => step.min(longest),
                (None, smallest) => smallest.map_or(longest, |least| least.max(longest)),
            };
            settings.step = step;
            settings.smallest_step = Some(file.smallest_step.unwrap_or(shortest.min(step)));
        }
    }
    if file.communication_step.is_none() {
        let natural = file.step.unwrap_or_else(|| round_time(settings.step));
        settings.communication_step = natural.min(settings.duration);
    }
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
