//! The settings that an importer may change.

use sphere_dda::Vec3;
use sphere_dda::scene::Scene;
use sphere_dda::solver::{SolverKind, Tolerance};

use super::enumeration::SOLVERS;
use super::variable::{Parameter, Value};

/// Most sweeps of an internal step of a scene, 0 if they are not bounded.
fn sweeps(scene: &Scene) -> i32 {
    let most = scene.settings.sweeps.unwrap_or(0);
    i32::try_from(most).unwrap_or(i32::MAX)
}

/// What an importer can set before the first step, with the scene's values as start.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Parameters {
    /// Gravity \[m/s^2\].
    pub gravity: Vec3,
    /// Where result files go; empty: nowhere.
    pub output_directory: String,
    /// Whether an earlier run may be replaced.
    pub output_overwrite: bool,
    /// Time between VTU frames \[s\].
    pub output_interval: f64,
    /// Tolerances of every step \[-\].
    pub tolerance: Tolerance,
    /// Largest internal time step \[s\].
    pub step: f64,
    /// Most sweeps of an internal step; 0: as many as the tolerances need.
    pub sweeps: i32,
    /// Which solver takes the step's problem.
    pub solver: SolverKind,
}

impl Parameters {
    /// The values of the scene file.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        Self {
            gravity: scene.settings.gravity,
            output_directory: String::new(),
            output_overwrite: false,
            output_interval: scene.output.vtu_interval,
            tolerance: scene.settings.tolerance,
            step: scene.settings.step,
            sweeps: sweeps(scene),
            solver: scene.settings.solver,
        }
    }

    /// The scene with these tolerances, this step and solver in the place of its own. Gravity, which may change during the
    /// run, is left to [`sphere_dda::simulation::Simulation::set_gravity`].
    #[must_use]
    pub fn apply(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.settings.tolerance = self.tolerance;
        let settings = &mut scene.settings;
        settings.step = self.step;
        settings.smallest_step = settings.smallest_step.map(|least| least.min(self.step));
        settings.sweeps = usize::try_from(self.sweeps).ok().filter(|n| *n > 0);
        scene.settings.solver = self.solver;
        scene
    }

    /// Whether [`Self::apply`] would not change a scene.
    #[must_use]
    pub fn fit(&self, scene: &Scene) -> bool {
        let settings = &scene.settings;
        (self.tolerance, self.step, self.solver, self.sweeps)
            == (
                settings.tolerance,
                settings.step,
                settings.solver,
                sweeps(scene),
            )
    }

    /// Value of a parameter.
    #[must_use]
    pub fn get(&self, parameter: Parameter) -> Value {
        match parameter {
            Parameter::Gravity(axis) => Value::Real(self.gravity[axis]),
            Parameter::OutputDirectory => Value::String(self.output_directory.clone()),
            Parameter::OutputOverwrite => Value::Boolean(self.output_overwrite),
            Parameter::OutputInterval => Value::Real(self.output_interval),
            Parameter::ToleranceGap => Value::Real(self.tolerance.gap),
            Parameter::ToleranceSlip => Value::Real(self.tolerance.slip),
            Parameter::ToleranceForce => Value::Real(self.tolerance.force),
            Parameter::Step => Value::Real(self.step),
            Parameter::Sweeps => Value::Integer(self.sweeps),
            Parameter::Solver => Value::Integer(
                (1..)
                    .zip(SOLVERS)
                    .find(|(_, solver)| *solver == self.solver)
                    .map_or(0, |(value, _)| value),
            ),
        }
    }

    /// Sets a parameter; a value of another type, which the table's check has excluded, changes nothing.
    pub fn set(&mut self, parameter: Parameter, value: Value) {
        match (parameter, value) {
            (Parameter::Gravity(axis), Value::Real(v)) => self.gravity[axis] = v,
            (Parameter::OutputDirectory, Value::String(v)) => self.output_directory = v,
            (Parameter::OutputOverwrite, Value::Boolean(v)) => self.output_overwrite = v,
            (Parameter::OutputInterval, Value::Real(v)) => self.output_interval = v,
            (Parameter::ToleranceGap, Value::Real(v)) => self.tolerance.gap = v,
            (Parameter::ToleranceSlip, Value::Real(v)) => self.tolerance.slip = v,
            (Parameter::ToleranceForce, Value::Real(v)) => self.tolerance.force = v,
            (Parameter::Step, Value::Real(v)) => self.step = v,
            (Parameter::Sweeps, Value::Integer(v)) => self.sweeps = v,
            (Parameter::Solver, Value::Integer(v)) => {
                let chosen = (1..).zip(SOLVERS).find(|(value, _)| *value == v);
                self.solver = chosen.map_or(self.solver, |(_, solver)| solver);
            }
            _ => {}
        }
    }
}
