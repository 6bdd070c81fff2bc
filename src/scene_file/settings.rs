//! Settings of the run, and materials.

use std::f64::consts::PI;

use super::decode::SceneFile;
use super::document::Document;
use super::file;
use super::frame::{gravity, rotating_frame};
use crate::integrator::Integrator;
use crate::scene::accuracy::round_time;
use crate::scene::clump::Clump;
use crate::scene::materials::{Material, PairTable};
use crate::scene::particles::{Kinematics, Particles};
use crate::scene::{Boundary, Method, Motion, PointLoad, Settings};
use crate::solver::Tolerance;

/// Path of the table.
const TABLE: &str = "simulation";

/// `[simulation]`, checked.
pub(super) fn settings(document: &mut Document<'_>, s: &file::Simulation) -> Option<Settings> {
    ranges(document, s);
    together(document, s);
    let (tolerance, opening) = tolerances(document, s);
    let gravity = gravity(document, s);
    let frame = s.rotating_frame.map(|f| rotating_frame(document, f));
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
        max_initial_overlap: s.max_initial_overlap,
        threshold_velocity: s.threshold_velocity,
        dynamic_coefficient: s.dynamic_coefficient,
        max_iterations: s.max_iterations as usize,
        max_cuts: s.max_cuts,
        threads: s.threads as usize,
        registers: s.registers,
    })
}

/// Numbers out of their range.
fn ranges(document: &mut Document<'_>, s: &file::Simulation) {
    let above = [
        ("duration", Some(s.duration), "a time > 0 [s]"),
        ("step", s.step, "a time > 0 [s]"),
        ("communication_step", s.communication_step, "a time > 0 [s]"),
        ("penalty", s.penalty, "a stiffness > 0 [N/m]"),
    ];
    for (key, value, expected) in above {
        document.positive((TABLE, key), value, expected);
    }
    let speeds = [
        ("rest_speed", s.rest_speed),
        ("threshold_velocity", s.threshold_velocity),
    ];
    for (key, value) in speeds {
        document.within((TABLE, key), value, 0.0.., "a speed >= 0 [m/s]");
    }
    let counts = [
        ("sweeps", s.sweeps, 1..=u32::MAX, "a whole number > 0"),
        (
            "max_iterations",
            Some(s.max_iterations),
            1..=u32::MAX,
            "a count >= 1",
        ),
        ("max_cuts", Some(s.max_cuts), 0..=20, "0 <= max_cuts <= 20"),
        ("threads", Some(s.threads), 1..=256, "1 <= threads <= 256"),
    ];
    for (key, value, range, expected) in counts {
        document.within((TABLE, key), value, range, expected);
    }
    if !s.registers.exist() {
        let help = "set `registers` to \"widest\" or \"plain\"";
        let message = "this processor has no AVX2, which registers = \"avx2\" needs";
        document.error((TABLE, "registers"), message, help);
    }
    let (key, expected) = ("max_initial_overlap", "0 <= max_initial_overlap <= 0.5 [-]");
    document.within((TABLE, key), s.max_initial_overlap, 0.0..=0.5, expected);
    let (key, expected) = ("dynamic_coefficient", "0 <= dynamic_coefficient <= 1 [-]");
    document.within((TABLE, key), s.dynamic_coefficient, 0.0..=1.0, expected);
}

/// Keys that need, or exclude, one another.
fn together(document: &mut Document<'_>, s: &file::Simulation) {
    if let Some(smallest) = s.smallest_step {
        let good = smallest > 0.0 && s.step.is_none_or(|step| smallest <= step);
        let expected = "0 < smallest_step <= step [s]";
        document.demand(good, (TABLE, "smallest_step"), smallest, expected);
    }
    if s.fixed_step && s.step.is_none() {
        let message = "missing key `step`, which fixed_step = true needs";
        let help = "add `step = ...` in s, or remove `fixed_step`";
        document.error(TABLE, message, help);
    }
    if s.method == Method::Penalty && s.penalty.is_none() {
        let message = "missing key `penalty`, which method = \"penalty\" needs";
        let help =
            "add `penalty = ...` in N/m; `sphere-dda check` suggests one, or use method = \"alm\"";
        document.error(TABLE, message, help);
    }
    if s.integrator == Integrator::Moreau && s.dynamic_coefficient != 1.0 {
        let message = "has no effect with integrator = \"moreau\"";
        let help = "remove it or use \"shi\"";
        document.warn((TABLE, "dynamic_coefficient"), message, help);
    }
}

/// Tolerances and opening \[-\]: as given, else those of the accuracy.
fn tolerances(document: &mut Document<'_>, s: &file::Simulation) -> (Tolerance, f64) {
    let own = s.accuracy.tolerance();
    let tolerance = Tolerance {
        gap: s.tolerance.gap.unwrap_or(own.gap),
        slip: s.tolerance.slip.unwrap_or(own.slip),
        force: s.tolerance.force.unwrap_or(own.force),
    };
    let opening = s.tolerance.opening;
    let opening = opening.unwrap_or_else(|| s.accuracy.opening_of(tolerance.gap));
    let keys = [
        ("gap", tolerance.gap, 1e-12, "1e-12 to 1e-1 [-]"),
        ("slip", tolerance.slip, 1e-12, "1e-12 to 1e-1 [-]"),
        ("force", tolerance.force, 1e-12, "1e-12 to 1e-1 [-]"),
        ("opening", opening, 0.0, "0 to 1e-1 [-]"),
    ];
    for (key, value, least, expected) in keys {
        let good = (least..=1e-1).contains(&value);
        let path = format!("{TABLE}.tolerance.{key}");
        document.demand(good, path, format!("{value:e}"), expected);
    }
    (tolerance, opening)
}

/// Slip that a step may leave of that of loose grains where bonds hold them \[-\]: what bonded bodies slip and turn by in each
/// step adds up, a bar bends by the sum.
const BONDED_SLIP: f64 = 1e-2;

/// Gives the steps of scenes with bonds a finer tolerance of slip, where the file has none.
pub(super) fn choose_slip(settings: &mut Settings, typed: &file::Simulation, pairs: &PairTable) {
    if typed.tolerance.slip.is_none() && pairs.has_bonds() {
        settings.tolerance.slip = (BONDED_SLIP * settings.tolerance.slip).max(1e-12);
    }
}

/// Shortest time \[s\] in which the largest gravity, the centrifugal force or the pressure of a servo boundary moves a sphere by half
/// its radius; without gravity also what a load gives its sphere or clump, and the force on a driven body this body.
pub(super) fn fall(
    settings: &Settings,
    (particles, initial, clumps): (&Particles, &Kinematics, &[Clump]),
    boundaries: &[Boundary],
    loads: &[PointLoad],
) -> f64 {
    let driven = boundaries
        .iter()
        .filter_map(|boundary| match &boundary.motion {
            Motion::Driven(body) => Some(body),
            _ => None,
        });
    let servos = driven.clone().filter_map(|body| body.servo.as_ref());
    let pressure = servos.fold(0.0, |most: f64, servo| most.max(servo.pressure.abs()));
    let gravity = settings.gravity_motion.largest(settings.gravity).norm();
    let pushed = driven.map(|body| body.force.norm() / body.mass);
    let loaded = loads.iter().map(|load| {
        let clump = particles.clump(load.sphere).map(|c| &clumps[c]);
        let mass = clump.map_or(particles.mass[load.sphere], |clump| clump.shape.mass);
        load.force.norm() / mass
    });
    let gravity = match gravity > 0.0 {
        true => gravity,
        false => pushed.chain(loaded).fold(0.0, f64::max),
    };
    let acceleration = |i: usize| {
        let frame = settings.rotating_frame.as_ref();
        let centrifugal = frame.map_or(0.0, |frame| frame.centrifugal(initial.position[i]).norm());
        let radius = particles.radius[i];
        let pressed = pressure * PI * radius * radius / particles.mass[i];
        (gravity + centrifugal).max(pressed)
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
        let expected = "a density > 0 [kg/m^3]";
        document.positive((&element.path, "density"), density, expected);
        // A material of boundaries only has no density; 1 keeps an unusable element's spheres finite until the
        // scene is refused.
        Material {
            name: element.name.clone().unwrap_or_default(),
            density: density.filter(|d| *d > 0.0).unwrap_or(1.0),
        }
    });
    materials.collect()
}
