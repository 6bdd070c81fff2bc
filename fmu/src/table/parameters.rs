//! The settings that an importer may change: [`PARAMETERS`] is the one list, an entry is all that a parameter needs.

use serde::{Deserialize, Serialize};
use sphere_dda::Vec3;
use sphere_dda::observe::quantities::XYZ;
use sphere_dda::scene::gravity::GravityMotion;
use sphere_dda::scene::{Scene, Settings};
use sphere_dda_model_description::fmi2::{Causality, Variability};
use sphere_dda_model_description::value::{ScalarType, Value};

use super::binding::Binding;
use super::enumeration::{Enumeration, solver_of, solver_value};
use super::variable::Variable;

/// What parameters set: the settings of the scene and where results go.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Parameters {
    /// Settings of the scene.
    pub settings: Settings,
    /// Where result files go; empty: nowhere.
    pub output_directory: String,
    /// Whether an earlier run may be replaced.
    pub output_overwrite: bool,
    /// Time between VTU frames \[s\].
    pub output_interval: f64,
}

/// A parameter: how it is described, read and set.
pub struct Parameter {
    name: &'static str,
    unit: Option<&'static str>,
    text: &'static str,
    min: Option<f64>,
    max: Option<f64>,
    /// Whether it may change between steps.
    is_tunable: bool,
    /// Whether a scene has it.
    present: fn(&Settings) -> bool,
    access: Access,
}

/// Type, getter and setter.
enum Access {
    Real(Get<f64>, Place<f64>),
    Vector(Get<Vec3>, Place<Vec3>),
    Boolean(Get<bool>, Place<bool>),
    String(fn(&Parameters) -> &str, Place<String>),
    /// Integers of 32 bits.
    Integer(Get<i64>, fn(&mut Parameters, i64)),
    Choice(&'static Enumeration, Get<i64>, fn(&mut Parameters, i64)),
}
type Get<T> = fn(&Parameters) -> T;
type Place<T> = fn(&mut Parameters) -> &mut T;

/// All parameters, in the order of the table of variables.
#[rustfmt::skip]
pub const PARAMETERS: &[Parameter] = &[
    Parameter {
        unit: Some("m/s2"),
        is_tunable: true,
        present: |settings| settings.gravity_motion == GravityMotion::Fixed,
        ..parameter("gravity", "Gravity, may change between steps", GRAVITY)
    },
    Parameter {
        unit: Some("m/s2"),
        is_tunable: true,
        present: |settings| matches!(settings.gravity_motion, GravityMotion::Rotation { .. }),
        ..parameter("gravity", "Gravity before it is turned, as at t = 0, may change between steps", GRAVITY)
    },
    parameter("output.directory", "Folder for result files, written to <directory>/<instance name>/; empty: none",
        Access::String(|p| &p.output_directory, |p| &mut p.output_directory)),
    parameter("output.overwrite", "Replace the files of an earlier run instead of refusing",
        Access::Boolean(|p| p.output_overwrite, |p| &mut p.output_overwrite)),
    Parameter {
        unit: Some("s"),
        min: Some(0.0),
        ..parameter("output.interval", "Time between VTU frames; 0: none",
            Access::Real(|p| p.output_interval, |p| &mut p.output_interval))
    },
    tolerance("solver.tolerance.gap", "Largest true overlap over radius",
        Access::Real(|p| p.settings.tolerance.gap, |p| &mut p.settings.tolerance.gap)),
    tolerance("solver.tolerance.slip", "Largest slip of a sticking contact over radius",
        Access::Real(|p| p.settings.tolerance.slip, |p| &mut p.settings.tolerance.slip)),
    tolerance("solver.tolerance.force", "Largest force residual over the contact's force scale",
        Access::Real(|p| p.settings.tolerance.force, |p| &mut p.settings.tolerance.force)),
    Parameter {
        unit: Some("s"),
        min: Some(f64::MIN_POSITIVE),
        ..parameter("solver.step", "Largest internal time step; a communication step takes equal ones",
            Access::Real(|p| p.settings.step, |p| &mut p.settings.step))
    },
    Parameter {
        min: Some(0.0),
        ..parameter("solver.maxSweeps", "Real-time mode: most Gauss-Seidel sweeps of an internal step, whose result is taken as it is; 0: as many as the tolerances need",
            Access::Integer(
                |p| i32::try_from(p.settings.sweeps.unwrap_or(0)).unwrap_or(i32::MAX).into(),
                |p, most| p.settings.sweeps = usize::try_from(most).ok().filter(|most| *most > 0)))
    },
    parameter("solver.kind", "Solver of every step",
        Access::Choice(&Enumeration::SOLVER,
            |p| solver_value(p.settings.solver),
            |p, value| p.settings.solver = solver_of(value).unwrap_or(p.settings.solver))),
];

const GRAVITY: Access = Access::Vector(|p| p.settings.gravity, |p| &mut p.settings.gravity);

const fn parameter(name: &'static str, text: &'static str, access: Access) -> Parameter {
    Parameter {
        name,
        unit: None,
        text,
        min: None,
        max: None,
        is_tunable: false,
        present: |_| true,
        access,
    }
}

const fn tolerance(name: &'static str, text: &'static str, access: Access) -> Parameter {
    Parameter {
        min: Some(1e-12),
        max: Some(1e-1),
        ..parameter(name, text, access)
    }
}

impl Parameters {
    /// The values of the scene file.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        Self {
            settings: scene.settings.clone(),
            output_directory: String::new(),
            output_overwrite: false,
            output_interval: scene.output.vtu_interval,
        }
    }

    /// The scene with these settings in the place of its own. Gravity, which may change during the run, is left to
    /// [`sphere_dda::simulation::Simulation::set_gravity`].
    #[must_use]
    pub fn apply(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.settings = self.settings_for(&scene);
        scene.output.vtu_interval = self.output_interval;
        scene
    }

    /// Whether [`Self::apply`] would not change a scene.
    #[must_use]
    pub fn fit(&self, scene: &Scene) -> bool {
        let same_frames = self.output_interval == scene.output.vtu_interval;
        same_frames && self.settings_for(scene) == scene.settings
    }

    fn settings_for(&self, scene: &Scene) -> Settings {
        let mut settings = self.settings.clone();
        settings.gravity = scene.settings.gravity;
        settings.smallest_step = settings.smallest_step.map(|least| least.min(settings.step));
        settings
    }

    /// Takes over what scene `new` sets otherwise than scene `old`: where both agree, what an importer has set stays.
    pub fn follow(&mut self, old: &Scene, new: &Scene) {
        let (old, mut fresh) = (Self::of(old), Self::of(new));
        for (rank, parameter) in PARAMETERS.iter().enumerate() {
            let elements = match parameter.access {
                Access::Vector(..) => XYZ.len(),
                _ => 1,
            };
            for element in 0..elements {
                if fresh.get(rank, element) == old.get(rank, element) {
                    fresh.set(rank, element, self.get(rank, element));
                }
            }
        }
        *self = fresh;
    }

    /// An element of a parameter, by its rank in [`PARAMETERS`].
    #[must_use]
    pub fn get(&self, rank: usize, element: usize) -> Value {
        match PARAMETERS[rank].access {
            Access::Real(of, _) => Value::Real(of(self)),
            Access::Vector(of, _) => Value::Real(of(self)[element]),
            Access::Boolean(of, _) => Value::Boolean(of(self)),
            Access::String(of, _) => Value::String(of(self).to_owned()),
            Access::Integer(of, _) | Access::Choice(_, of, _) => Value::Integer(of(self)),
        }
    }

    /// Sets an element of a parameter; a value of another type, which the table's check has excluded, changes nothing.
    pub fn set(&mut self, rank: usize, element: usize, value: Value) {
        match (&PARAMETERS[rank].access, value) {
            (Access::Real(_, place), Value::Real(value)) => *place(self) = value,
            (Access::Vector(_, place), Value::Real(value)) => place(self)[element] = value,
            (Access::Boolean(_, place), Value::Boolean(value)) => *place(self) = value,
            (Access::String(_, place), Value::String(value)) => *place(self) = value,
            (Access::Integer(_, set) | Access::Choice(_, _, set), Value::Integer(value)) => {
                set(self, value);
            }
            _ => {}
        }
    }
}

/// The parameters of a scene; they start with its values.
pub(super) fn parameters(scene: &Scene) -> Vec<Variable> {
    let start = Parameters::of(scene);
    let all = PARAMETERS.iter().enumerate();
    all.filter(|(_, parameter)| (parameter.present)(&scene.settings))
        .map(|(rank, parameter)| {
            let (scalar, components, choices) = match parameter.access {
                Access::Real(..) => (ScalarType::Float64, &[][..], None),
                Access::Vector(..) => (ScalarType::Float64, XYZ, None),
                Access::Boolean(..) => (ScalarType::Boolean, &[][..], None),
                Access::String(..) => (ScalarType::String, &[][..], None),
                Access::Integer(..) => (ScalarType::Int32, &[][..], None),
                Access::Choice(choices, ..) => (ScalarType::Enumeration, &[][..], Some(choices)),
            };
            let (role, binding) = (Causality::Parameter, Binding::Parameter(rank));
            let mut variable = Variable::new(parameter.name, scalar, role, binding, parameter.text)
                .vector(components);
            let elements = 0..variable.count();
            variable.start = elements.map(|element| start.get(rank, element)).collect();
            variable.unit = parameter.unit;
            (variable.min, variable.max) = (parameter.min, parameter.max);
            variable.choices = choices;
            if parameter.is_tunable {
                variable.variability = Variability::Tunable;
            }
            variable
        })
        .collect()
}
