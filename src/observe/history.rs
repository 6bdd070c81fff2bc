//! The history: one CSV row per output time, `history.csv`.
//!
//! The header names each column and its unit, `name [unit]`; names are those of the FMU's outputs. Numbers carry as
//! many digits as it takes to read the same f64 back.
//!
//! | column | meaning |
//! |---|---|
//! | `time [s]` | end of the communication step |
//! | `sensor.NAME [kg]` | mass in the box |
//! | `sensor.NAME.force[1..3] [N]`, `sensor.NAME.torque[1..3] [N.m]` | wrench on the sensor's boundary, mean over the communication step |
//! | `sensor.NAME.mass [kg]`, `sensor.NAME.rate [kg/s]` | cumulated mass, mean flow over the communication step |
//! | `boundary.NAME.averageForce[k] [N]`, `.averageTorque[k] [N m]` | contact wrench on the boundary about its point of action, mean over the communication step; k = 1, 2, 3 |
//! | `kineticEnergy [J]`, `potentialEnergy [J]` | see [`super::energy`] |
//! | `dissipatedEnergy [J]`, `boundaryWork [J]`, `loadWork [J]`, `springWork [J]` | since t = 0, see [`crate::state::Work`] |
//! | `momentum[k] [N s]`, `angularMomentum[k] [N m s]` | half-step velocities, about the origin |
//! | `contactCount [-]` | contacts that carry a force or overlap |
//! | `maxOverlap [-]` | largest overlap over the smaller radius at the end of any internal step of the communication step |
//! | `solver.internalSteps`, `.cuts`, `.sweeps`, `.augmentations`, `.factorizations` `[-]` | cost of the communication step |
//! | `solver.gapResidual [-]`, `solver.slipResidual [-]`, `solver.forceResidual [-]` | largest residuals |

use super::Observation;
use super::energy::{Energy, Momentum};
use super::sensors::mass_inside;
use crate::Vec3;
use crate::scene::{Measure, Scene};

/// Header of the history of `scene`.
#[must_use]
pub fn columns(scene: &Scene) -> Vec<String> {
    let mut names = vec!["time [s]".to_owned()];
    let vector = |names: &mut Vec<String>, name: &str, unit: &str| {
        names.extend((1..=3).map(|k| format!("{name}[{k}] [{unit}]")));
    };
    for sensor in &scene.sensors {
        let name = &sensor.name;
        match sensor.measure {
            Measure::Region(_) => names.push(format!("sensor.{name}.mass [kg]")),
            Measure::Wrench { .. } => {
                vector(&mut names, &format!("sensor.{name}.force"), "N");
                vector(&mut names, &format!("sensor.{name}.torque"), "N.m");
            }
            Measure::MassFlow { .. } => {
                names.push(format!("sensor.{name}.mass [kg]"));
                names.push(format!("sensor.{name}.rate [kg/s]"));
            }
        }
    }
    for boundary in &scene.boundaries {
        let name = &boundary.name;
        vector(&mut names, &format!("boundary.{name}.averageForce"), "N");
        vector(&mut names, &format!("boundary.{name}.averageTorque"), "N m");
    }
    let energies = [
        "kineticEnergy",
        "potentialEnergy",
        "dissipatedEnergy",
        "boundaryWork",
        "loadWork",
        "springWork",
    ];
    names.extend(energies.map(|name| format!("{name} [J]")));
    vector(&mut names, "momentum", "N s");
    vector(&mut names, "angularMomentum", "N m s");
    names.extend(
        [
            "contactCount",
            "maxOverlap",
            "solver.internalSteps",
            "solver.cuts",
            "solver.sweeps",
            "solver.augmentations",
            "solver.factorizations",
            "solver.gapResidual",
            "solver.slipResidual",
            "solver.forceResidual",
        ]
        .map(|name| format!("{name} [-]")),
    );
    names
}

/// The row of a state, in the order of [`columns`].
#[must_use]
pub fn row(state: &Observation) -> Vec<f64> {
    let mut values = vec![state.time];
    let vector = |values: &mut Vec<f64>, v: Vec3| values.extend_from_slice(v.as_slice());
    for (s, sensor) in state.scene.sensors.iter().enumerate() {
        match &sensor.measure {
            Measure::Region(region) => {
                let centre = &state.kinematics.position;
                values.push(mass_inside(&state.scene.particles, centre, region));
            }
            Measure::Wrench { boundary } => {
                let wrench = &state.boundaries[*boundary].mean_wrench;
                vector(&mut values, wrench.force);
                vector(&mut values, wrench.torque);
            }
            Measure::MassFlow { .. } => values.extend([state.passed[s], state.flow[s]]),
        }
    }
    for boundary in &state.boundaries {
        vector(&mut values, boundary.mean_wrench.force);
        vector(&mut values, boundary.mean_wrench.torque);
    }
    let energy = Energy::of(state);
    let work = &state.work;
    values.extend([energy.kinetic(), energy.potential()]);
    values.extend([work.dissipated, work.boundaries, work.loads, work.springs]);
    let momentum = Momentum::of(state);
    vector(&mut values, momentum.linear);
    vector(&mut values, momentum.angular);
    let report = &state.report;
    values.extend([
        state.active_contacts().count() as f64,
        report.max_overlap.max(state.max_overlap()),
        report.internal_steps as f64,
        report.cuts as f64,
        report.sweeps as f64,
        report.augmentations as f64,
        report.factorizations as f64,
        report.gap_residual,
        report.slip_residual,
        report.force_residual,
    ]);
    values
}
