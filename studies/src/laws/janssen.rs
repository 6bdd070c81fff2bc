//! Janssen's silo: walls that rub carry the weight.
//!
//! ```text
//! sigma = s_inf (1 - exp(-s / s_inf)),   s_inf = rho_b g D / (4 mu_w K)
//! ```
//!
//! `s` is the weight above a level over the cross-section, `sigma` the vertical stress that is left after wall friction,
//! both \[Pa\]; `K` the ratio of horizontal to vertical stress. Source: H. A. Janssen, *Versuche über Getreidedruck in
//! Silozellen*, Zeitschrift des VDI 39 (1895). The floor sinks slowly, so that all wall friction points up.

use sphere_dda::contact::Partner;
use sphere_dda::scene::Command;
use sphere_dda::simulation::Simulation;

use super::bed::{self, Cost, Friction, G, GRAIN, Run};
use super::fit;
use crate::Watch;
use crate::error::ReportError;

/// Diameter of the silo \[m\].
const DIAMETER: f64 = 0.1;
/// Friction coefficient of the wall: below that of the grains, so that they slide along it and do not roll.
const WALL: f64 = 0.3;
/// Friction coefficient between grains.
const INNER: f64 = 0.5;
/// Number of grains.
const COUNT: usize = 2600;
/// Filling, then sinking \[s\]; the second half of the sinking is averaged.
const TIMES: [f64; 2] = [0.8, 0.6];
/// Speed of the floor \[m/s\].
const SINKING: f64 = 0.01;
/// Levels at which the stress is read.
const LEVELS: usize = 24;

/// What the silo costs.
pub(super) const COST: Cost = Cost {
    cases: 1,
    seconds: 1.1,
    simulated: 1.4,
};

/// What was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Janssen {
    /// Weight above over cross-section and stress \[Pa\], from the top down.
    pub profile: Vec<(f64, f64)>,
    /// Bulk density \[kg/m^3\].
    pub bulk_density: f64,
    /// Asymptotic stress \[Pa\].
    pub limit: f64,
    /// Stress ratio of the fit.
    pub ratio: f64,
    /// Coefficient of determination.
    pub r2: f64,
}

impl Janssen {
    /// The law with the fitted limit \[Pa\].
    #[must_use]
    pub fn law(&self, s: f64) -> f64 {
        law(self.limit, s)
    }
}

fn law(limit: f64, s: f64) -> f64 {
    limit * (1.0 - (-s / limit).exp())
}

/// Fills the silo, sinks its floor and reads the stress.
///
/// # Errors
/// What the run says.
pub fn run(share: f64, watch: &dyn Watch) -> Result<Janssen, ReportError> {
    let run = Run::new("Janssen silo", watch, COST);
    let radius = 0.5 * DIAMETER;
    let count = (share * COUNT as f64) as usize;
    let text = bed::head(
        "Janssen silo",
        bed::G,
        Friction::sliding(INNER),
        Friction::sliding(WALL),
    ) + &bed::grains(
        &format!("{{ cylinder = {{ base = [0.0, 0.0, 0.0], radius = {radius}, height = 0.46 }} }}"),
        count,
        1,
    ) + &bed::boundary(
        "wall",
        &format!(
            "{{ cylinder = {{ base = [0.0, 0.0, -0.05], radius = {radius}, height = 0.55 }} }}"
        ),
        "",
    ) + &bed::boundary(
        "floor",
        "{ rectangle = { corner = [-0.06, -0.06, 0.0], u = [0.12, 0.0, 0.0], v = [0.0, 0.12, 0.0] } }",
        "input = { slide_speed = [0.0, 0.0, -1.0] }",
    );
    let mut silo = run.begin(bed::scene("janssen.toml", &text)?)?;
    run.wait(&mut silo, TIMES[0])?;
    let floor = Command {
        scalar: SINKING,
        ..Command::default()
    };
    silo.command(1, floor).map_err(|error| run.failed(error))?;
    let (mut profile, mut density, mut looks) = (vec![(0.0, 0.0); LEVELS], 0.0, 0.0);
    let from = TIMES[0] + 0.5 * TIMES[1];
    run.advance(&mut silo, TIMES[0] + TIMES[1], |silo| {
        if silo.time() > from {
            looks += 1.0;
            let now = stress(silo);
            for (sum, (s, sigma)) in profile.iter_mut().zip(now.profile) {
                sum.0 += s;
                sum.1 += sigma;
            }
            density += now.density;
        }
        Ok(true)
    })?;
    for level in &mut profile {
        *level = (level.0 / looks, level.1 / looks);
    }
    let bulk_density = density / looks;
    let deepest = profile.last().map_or(1.0, |p| p.0);
    let limit = fit::parameter(&profile, [1e-3 * deepest, 1e2 * deepest], law);
    Ok(Janssen {
        r2: fit::determination(&profile, |s| law(limit, s)),
        ratio: bulk_density * G * DIAMETER / (4.0 * WALL * limit),
        profile,
        bulk_density,
        limit,
    })
}

struct Stress {
    profile: Vec<(f64, f64)>,
    density: f64,
}

/// Stress by the balance of all that lies above a level: its weight less what the wall carries.
fn stress(silo: &Simulation) -> Stress {
    let area = 0.25 * std::f64::consts::PI * DIAMETER * DIAMETER;
    let bottom = silo.boundary_pose(1).translation.z;
    let top = bed::places(silo)
        .map(|(x, _)| x.z)
        .fold(f64::NEG_INFINITY, f64::max)
        + 0.5 * GRAIN;
    let above = |z: f64| -> f64 {
        let mass: f64 = bed::places(silo)
            .filter(|(x, _)| x.z > z)
            .map(|(_, m)| m)
            .sum();
        mass
    };
    let carried = |z: f64| -> f64 {
        let wall = |partner| matches!(partner, Partner::Boundary { boundary: 0, .. });
        let contacts = silo.contacts().into_iter();
        contacts
            .filter(|c| wall(c.key.partner) && c.point.z > z)
            .map(|c| c.force.z)
            .sum()
    };
    let profile = (1..=LEVELS)
        .map(|k| {
            let z = top - (top - bottom) * k as f64 / LEVELS as f64;
            (above(z) * G / area, (above(z) * G - carried(z)) / area)
        })
        .collect();
    let (low, high) = (
        bottom + 0.25 * (top - bottom),
        bottom + 0.75 * (top - bottom),
    );
    Stress {
        profile,
        density: (above(low) - above(high)) / (area * (high - low)),
    }
}
