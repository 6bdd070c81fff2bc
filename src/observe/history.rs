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

use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::Observation;
use super::energy::{Energy, Momentum};
use super::error::OutputError;
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

/// A CSV file that can be taken back to an earlier time.
#[derive(Debug)]
pub struct History {
    path: PathBuf,
    file: File,
    columns: Vec<String>,
    /// Time \[s\] of each row, and where it ends in the file.
    rows: Vec<(f64, u64)>,
    /// End of the header.
    start: u64,
}

impl History {
    /// Creates the file and writes the header.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub fn create(path: &Path, columns: Vec<String>) -> Result<Self, OutputError> {
        let mut file = File::create(path).map_err(OutputError::io("create", path))?;
        let header = record(&columns).map_err(OutputError::io("write", path))?;
        file.write_all(&header)
            .map_err(OutputError::io("write", path))?;
        Ok(Self {
            path: path.to_path_buf(),
            file,
            columns,
            rows: Vec::new(),
            start: header.len() as u64,
        })
    }

    /// Appends a row; `values[0]` is the time \[s\]. Rows of this or a later time are dropped first.
    ///
    /// # Errors
    /// [`OutputError::Shape`], [`OutputError::NotFinite`], [`OutputError::Io`]; then no part of the row stays.
    pub fn push(&mut self, values: &[f64]) -> Result<(), OutputError> {
        if values.len() != self.columns.len() {
            return Err(OutputError::Shape {
                place: self.path.display().to_string(),
                array: "row".to_owned(),
                found: values.len(),
                expected: self.columns.len(),
            });
        }
        if let Some(index) = values.iter().position(|value| !value.is_finite()) {
            return Err(OutputError::NotFinite {
                place: self.path.display().to_string(),
                array: self.columns[index].clone(),
                index: self.rows.len(),
                value: values[index],
            });
        }
        let time = values[0];
        self.cut(|row| row < time)?;
        let bytes = record(values).map_err(OutputError::io("write", &self.path))?;
        if let Err(error) = self.file.write_all(&bytes) {
            self.cut(|_| true)?;
            return Err(OutputError::io("write", &self.path)(error));
        }
        self.rows.push((time, self.end() + bytes.len() as u64));
        Ok(())
    }

    /// Drops the rows later than `time` \[s\].
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub fn rollback(&mut self, time: f64) -> Result<(), OutputError> {
        self.cut(|row| row <= time)
    }

    /// Where the last row ends.
    fn end(&self) -> u64 {
        self.rows.last().map_or(self.start, |row| row.1)
    }

    /// Keeps the leading rows whose time satisfies `keep`, and cuts the file behind them.
    fn cut(&mut self, keep: impl Fn(f64) -> bool) -> Result<(), OutputError> {
        self.rows
            .truncate(self.rows.partition_point(|&(time, _)| keep(time)));
        let end = self.end();
        self.file
            .set_len(end)
            .and_then(|()| self.file.seek(SeekFrom::Start(end)))
            .map_err(OutputError::io("truncate", &self.path))?;
        Ok(())
    }
}

/// One line of CSV.
fn record<T: serde::Serialize>(fields: &[T]) -> Result<Vec<u8>, std::io::Error> {
    let mut writer = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(Vec::new());
    writer.serialize(fields).map_err(std::io::Error::other)?;
    writer.into_inner().map_err(|error| error.into_error())
}
