//! The rows of the table that an importer sets: parameters and inputs; and how a row is made.

use sphere_dda::Vec3;
use sphere_dda::scene::InputKind;
use sphere_dda::scene::Scene;
use sphere_dda::scene::gravity::GravityMotion;
use sphere_dda_model_description::fmi2::{BaseType, Causality, Variability};

use super::enumeration::Enumeration;
use super::parameters::Parameters;
use super::variable::{Binding, Input, Parameter, Value, Variable};

/// A variable about to be added, without causality and meaning.
pub(super) struct Row {
    name: String,
    base: BaseType,
    unit: Option<&'static str>,
    start: Option<Value>,
    min: Option<f64>,
    max: Option<f64>,
    choices: Option<&'static Enumeration>,
    description: String,
}

impl Row {
    pub(super) fn real(
        name: impl Into<String>,
        unit: Option<&'static str>,
        description: impl Into<String>,
    ) -> Self {
        Self {
            name: name.into(),
            base: BaseType::Real,
            unit,
            start: None,
            min: None,
            max: None,
            choices: None,
            description: description.into(),
        }
    }

    pub(super) fn count(name: impl Into<String>, description: impl Into<String>) -> Self {
        let mut row = Self::real(name, None, description);
        row.base = BaseType::Integer;
        row.min(0.0)
    }

    pub(super) fn start(mut self, value: Value) -> Self {
        self.base = value.base();
        self.start = Some(value);
        self
    }

    pub(super) fn min(mut self, min: f64) -> Self {
        self.min = Some(min);
        self
    }

    pub(super) fn max(mut self, max: f64) -> Self {
        self.max = Some(max);
        self
    }

    pub(super) fn choices(mut self, choices: &'static Enumeration) -> Self {
        self.choices = Some(choices);
        self
    }
}

#[derive(Default)]
pub(super) struct Rows {
    pub(super) variables: Vec<Variable>,
}

impl Rows {
    pub(super) fn push(&mut self, row: Row, causality: Causality, binding: Binding) {
        let variability = match (causality, row.base) {
            (Causality::Parameter, _)
                if matches!(binding, Binding::Parameter(Parameter::Gravity(_))) =>
            {
                Variability::Tunable
            }
            (Causality::Parameter, _) => Variability::Fixed,
            (_, BaseType::Real) => Variability::Continuous,
            _ => Variability::Discrete,
        };
        self.variables.push(Variable {
            name: row.name,
            reference: u32::try_from(self.variables.len()).unwrap_or(u32::MAX),
            base: row.base,
            causality,
            variability,
            unit: row.unit,
            start: row.start,
            min: row.min,
            max: row.max,
            choices: row.choices,
            description: row.description,
            binding,
        });
    }

    /// The three components of an input, `name[1]` to `name[3]`.
    fn vector(
        &mut self,
        name: &str,
        unit: &'static str,
        text: &str,
        (boundary, input): (usize, Input),
        start: Vec3,
    ) {
        for (axis, letter) in ["x", "y", "z"].iter().enumerate() {
            let row = Row::real(
                format!("{name}[{}]", axis + 1),
                Some(unit),
                format!("{text}; {letter}"),
            );
            let binding = Binding::Input {
                boundary,
                input,
                axis,
            };
            let row = row.start(Value::Real(start[axis]));
            self.push(row, Causality::Input, binding);
        }
    }

    /// The surface velocity of a driven belt.
    pub(super) fn belt(&mut self, prefix: &str, boundary: usize, start: Vec3) {
        let name = format!("{prefix}.surfaceVelocity");
        let text = "Velocity of the surface along the faces, the boundary's own axes, held over the communication step";
        let binding = (boundary, Input::SurfaceVelocity);
        self.vector(&name, "m/s", text, binding, start);
    }

    /// The pressure of a servo wall.
    pub(super) fn servo(&mut self, prefix: &str, boundary: usize, start: f64) {
        let text = "Pressure of the servo wall, held over the communication step";
        let row = Row::real(format!("{prefix}.pressure"), Some("Pa"), text);
        let binding = Binding::Input {
            boundary,
            input: Input::Pressure,
            axis: 0,
        };
        self.push(row.start(Value::Real(start)), Causality::Input, binding);
    }

    pub(super) fn parameters(&mut self, scene: &Scene) {
        let parameters = Parameters::of(scene);
        let mut add = |row: Row, parameter: Parameter| {
            let row = row.start(parameters.get(parameter));
            self.push(row, Causality::Parameter, Binding::Parameter(parameter));
        };
        let (axes, what) = match scene.settings.gravity_motion {
            GravityMotion::Fixed => (3, "Gravity"),
            GravityMotion::Rotation { .. } => (3, "Gravity before it is turned, as at t = 0"),
            // The scene gives it: nothing is left to set.
            GravityMotion::Table { .. } => (0, ""),
        };
        for (axis, letter) in ["x", "y", "z"].iter().enumerate().take(axes) {
            let name = format!("gravity[{}]", axis + 1);
            let text = format!("{what}, may change between steps; {letter}");
            add(
                Row::real(name, Some("m/s2"), text),
                Parameter::Gravity(axis),
            );
        }
        let text = "Folder for result files, written to <directory>/<instance name>/; empty: none";
        add(
            Row::real("output.directory", None, text),
            Parameter::OutputDirectory,
        );
        let text = "Replace the files of an earlier run instead of refusing";
        add(
            Row::real("output.overwrite", None, text),
            Parameter::OutputOverwrite,
        );
        let text = "Time between VTU frames; 0: none";
        add(
            Row::real("output.interval", Some("s"), text).min(0.0),
            Parameter::OutputInterval,
        );
        let tolerances = [
            (
                "gap",
                "Largest true overlap over radius",
                Parameter::ToleranceGap,
            ),
            (
                "slip",
                "Largest slip of a sticking contact over radius",
                Parameter::ToleranceSlip,
            ),
            (
                "force",
                "Largest force residual over the contact's force scale",
                Parameter::ToleranceForce,
            ),
        ];
        for (name, text, parameter) in tolerances {
            let row = Row::real(format!("solver.tolerance.{name}"), None, text);
            add(row.min(1e-12).max(1e-1), parameter);
        }
        let text = "Largest internal time step; a communication step takes equal ones";
        add(
            Row::real("solver.step", Some("s"), text).min(f64::MIN_POSITIVE),
            Parameter::Step,
        );
        let text = "Real-time mode: most Gauss-Seidel sweeps of an internal step, whose result is taken as it is; 0: as many as the tolerances need";
        add(Row::count("solver.maxSweeps", text), Parameter::Sweeps);
        let row = Row::real("solver.kind", None, "Solver of every step");
        add(row.choices(&Enumeration::SOLVER), Parameter::Solver);
    }

    pub(super) fn inputs(&mut self, prefix: &str, boundary: usize, kind: InputKind) {
        const HELD: &str = "held over the communication step";
        const REACHED: &str =
            "from the scene; reached linearly at the end of the communication step";
        const ADVANCED: &str =
            "from the scene; pose + twist x h is reached at the end of the communication step";
        let pose = if kind == InputKind::Motion {
            ADVANCED
        } else {
            REACHED
        };
        if matches!(kind, InputKind::Pose | InputKind::Motion) {
            let vectors = [
                ("translation", "m", "Total translation", Input::Translation),
                (
                    "rotation",
                    "rad",
                    "Total rotation vector about the point of action",
                    Input::Rotation,
                ),
            ];
            for (name, unit, what, input) in vectors {
                let (name, text) = (format!("{prefix}.{name}"), format!("{what}, {pose}"));
                self.vector(&name, unit, &text, (boundary, input), Vec3::zeros());
            }
        }
        if matches!(kind, InputKind::Twist | InputKind::Motion) {
            let vectors = [
                (
                    "velocity",
                    "m/s",
                    "Velocity of the point of action",
                    Input::Velocity,
                ),
                (
                    "angularVelocity",
                    "rad/s",
                    "Angular velocity",
                    Input::AngularVelocity,
                ),
            ];
            for (name, unit, what, input) in vectors {
                let (name, text) = (format!("{prefix}.{name}"), format!("{what}, {HELD}"));
                self.vector(&name, unit, &text, (boundary, input), Vec3::zeros());
            }
        }
        if kind == InputKind::Load {
            let vectors = [
                (
                    "appliedForce",
                    "N",
                    "Force at the point of action, world axes",
                    Input::Force,
                ),
                ("appliedTorque", "N.m", "Torque, world axes", Input::Torque),
            ];
            for (name, unit, what, input) in vectors {
                let (name, text) = (format!("{prefix}.{name}"), format!("{what}, {HELD}"));
                self.vector(&name, unit, &text, (boundary, input), Vec3::zeros());
            }
        }
        let (name, unit, text) = match kind {
            InputKind::Slide { .. } => (
                "displacement",
                "m",
                format!("Displacement along the slide, {REACHED}"),
            ),
            InputKind::SlideSpeed { .. } => {
                ("speed", "m/s", format!("Speed along the slide, {HELD}"))
            }
            InputKind::Hinge { .. } => {
                ("angle", "rad", format!("Angle about the hinge, {REACHED}"))
            }
            InputKind::HingeSpeed { .. } => (
                "angularSpeed",
                "rad/s",
                format!("Angular speed about the hinge, {HELD}"),
            ),
            InputKind::SlideForce { .. } => (
                "appliedForce",
                "N",
                format!("Force along the slide, {HELD}"),
            ),
            InputKind::HingeTorque { .. } => (
                "appliedTorque",
                "N.m",
                format!("Torque about the hinge, {HELD}"),
            ),
            InputKind::Pose | InputKind::Motion | InputKind::Twist | InputKind::Load => return,
        };
        let row = Row::real(format!("{prefix}.{name}"), Some(unit), text).start(Value::Real(0.0));
        let binding = Binding::Input {
            boundary,
            input: Input::Scalar,
            axis: 0,
        };
        self.push(row, Causality::Input, binding);
    }
}
