//! The variable table: names, references, types, units, start values and what each variable means.
//!
//! One table is built from a [`Scene`]. The XML of the model description and the dispatch of every get and set
//! come from it, so they cannot disagree. Names of the scene are identifiers, so they need no quotes. The value reference of a variable is its rank in the table, from 0.
//!
//! # When a command holds
//!
//! Pose, slide and hinge inputs are total displacements from the scene's placement: the boundary moves linearly
//! (a rotation by its logarithm) from where it is to the commanded pose and reaches it at the end of the
//! communication step. Speeds are held over the step. Zero always means "as in the scene".

use sphere_dda::Vec3;
use sphere_dda::motion::{Command, InputKind, Motion};
use sphere_dda::scene::{Measure, Scene, Tolerance};
use sphere_dda_model_description::fmi2::{BaseType, Causality, Variability};

/// Length of every vector quantity; orientations have four components.
const XYZ: usize = 3;

/// A value of one of the four types of the C interface.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A real number, in the variable's unit.
    Real(f64),
    /// An integer.
    Integer(i32),
    /// A truth value.
    Boolean(bool),
    /// A text.
    String(String),
}

impl Value {
    /// The type in the C interface.
    #[must_use]
    pub fn base(&self) -> BaseType {
        match self {
            Self::Real(_) => BaseType::Real,
            Self::Integer(_) => BaseType::Integer,
            Self::Boolean(_) => BaseType::Boolean,
            Self::String(_) => BaseType::String,
        }
    }
}

/// What a variable stands for: the getter, and for inputs and parameters the setter.
/// `axis` counts components from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Time at the last communication point \[s\].
    Time,
    /// A setting of the run.
    Parameter(Parameter),
    /// A component of the command of a driven boundary.
    Input {
        /// Index of the boundary.
        boundary: usize,
        /// Which part of the command.
        input: Input,
        /// Component.
        axis: usize,
    },
    /// A quantity of a boundary.
    Boundary {
        /// Index of the boundary.
        boundary: usize,
        /// Which one.
        output: BoundaryOutput,
        /// Component.
        axis: usize,
    },
    /// A quantity of a probed sphere.
    Probe {
        /// Index of the probe.
        probe: usize,
        /// Which one.
        output: ProbeOutput,
        /// Component.
        axis: usize,
    },
    /// A reading of a sensor.
    Sensor {
        /// Index of the sensor.
        sensor: usize,
        /// Which one.
        output: SensorOutput,
    },
    /// A quantity of the whole scene.
    Global {
        /// Which one.
        output: GlobalOutput,
        /// Component.
        axis: usize,
    },
}

/// Settings that an importer may change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// A component of gravity \[m/s^2\]; tunable.
    Gravity(usize),
    /// Where result files go; empty: nowhere.
    OutputDirectory,
    /// Whether an earlier run in that place may be replaced.
    OutputOverwrite,
    /// Time between VTU frames \[s\].
    OutputInterval,
    /// Tolerance of the gap \[-\].
    ToleranceGap,
    /// Tolerance of the slip \[-\].
    ToleranceSlip,
    /// Tolerance of the force \[-\].
    ToleranceForce,
    /// Largest internal time step \[s\].
    Step,
}

/// Parts of a [`Command`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// Total translation \[m\].
    Translation,
    /// Total rotation vector \[rad\].
    Rotation,
    /// Velocity \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\].
    AngularVelocity,
    /// Displacement, speed, angle or angular speed of a slide or hinge.
    Scalar,
}

/// Outputs of a boundary; the sign of a wrench is that of the spheres acting on the boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundaryOutput {
    /// Force over the last internal step \[N\].
    Force,
    /// Torque about the point of action over the last internal step \[N m\].
    Torque,
    /// Force averaged over the communication step \[N\].
    AverageForce,
    /// Torque averaged over the communication step \[N m\].
    AverageTorque,
    /// Point of action \[m\].
    Position,
    /// Orientation, quaternion w, x, y, z.
    Orientation,
    /// Number of loaded contacts.
    ContactCount,
    /// Largest normal force of one contact \[N\].
    MaxNormalForce,
    /// Power of the spheres on the boundary \[W\].
    Power,
}

/// Outputs of a probed sphere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProbeOutput {
    /// Centre \[m\].
    Position,
    /// Orientation, quaternion w, x, y, z.
    Orientation,
    /// Velocity \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\].
    AngularVelocity,
    /// Sum of the contact forces on it \[N\].
    ContactForce,
    /// Torque of the contact forces about its centre \[N m\].
    ContactTorque,
    /// Number of loaded contacts.
    ContactCount,
    /// Largest normal force of one contact \[N\].
    MaxNormalForce,
}

/// Outputs of a sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SensorOutput {
    /// Mass in a box, or cumulated mass through a plane \[kg\].
    Mass,
    /// Mass flow through a plane, mean over the communication step \[kg/s\].
    Rate,
}

/// Outputs of the whole scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GlobalOutput {
    /// Total mass of the spheres \[kg\].
    Mass,
    /// Momentum of the spheres, half-step velocities \[kg m/s\].
    Momentum,
    /// Angular momentum about the origin, half-step velocities \[kg m^2/s\].
    AngularMomentum,
    /// Kinetic energy \[J\].
    KineticEnergy,
    /// Potential energy of gravity and springs \[J\].
    PotentialEnergy,
    /// Energy lost in contacts since the start \[J\].
    DissipatedEnergy,
    /// Work of moving boundaries on the spheres since the start \[J\].
    BoundaryWork,
    /// Work of point loads since the start \[J\].
    LoadWork,
    /// Work of constrained springs since the start \[J\].
    SpringWork,
    /// Number of loaded contacts.
    ContactCount,
    /// Largest true overlap over radius of the communication step \[-\].
    MaxOverlap,
    /// Internal steps of the communication step.
    InternalSteps,
    /// Of those, how many came from halving.
    Cuts,
    /// Gauss-Seidel sweeps of the communication step.
    Sweeps,
    /// Augmented-Lagrangian iterations of the communication step.
    Augmentations,
    /// Factorizations of the communication step.
    Factorizations,
    /// Gap residual \[-\].
    GapResidual,
    /// Slip residual \[-\].
    SlipResidual,
    /// Force residual \[-\].
    ForceResidual,
    /// Internal step that is advised at the present speeds \[s\].
    RecommendedStep,
}

/// One variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Structured name, unique.
    pub name: String,
    /// Value reference: rank in the table.
    pub reference: u32,
    /// Type in the C interface.
    pub base: BaseType,
    /// Who provides the value.
    pub causality: Causality,
    /// When it may change.
    pub variability: Variability,
    /// Unit, a name of [`crate::description::units`]; `None`: a number without unit.
    pub unit: Option<&'static str>,
    /// Start value: of inputs and parameters.
    pub start: Option<Value>,
    /// Smallest allowed value.
    pub min: Option<f64>,
    /// Largest allowed value.
    pub max: Option<f64>,
    /// One line for people.
    pub description: String,
    /// What it stands for.
    pub quantity: Quantity,
}

/// The variables of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    variables: Vec<Variable>,
}

impl Table {
    /// Builds the table: time, parameters, then inputs and outputs of boundaries, probes, sensors and the whole.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut rows = Rows::default();
        rows.push(
            Row::real("time", Some("s"), "Simulated time"),
            Causality::Independent,
            Quantity::Time,
        );
        rows.parameters(scene);
        for (b, boundary) in scene.boundaries.iter().enumerate() {
            let prefix = format!("boundary.{}", boundary.name);
            if let Motion::Input(kind) = boundary.motion {
                rows.inputs(&prefix, b, kind);
            }
            rows.boundary(&prefix, b);
        }
        for (p, probe) in scene.probes.iter().enumerate() {
            rows.probe(&format!("probe.{}", probe.name), p);
        }
        for (s, sensor) in scene.sensors.iter().enumerate() {
            rows.sensor(&format!("sensor.{}", sensor.name), s, &sensor.measure);
        }
        rows.globals();
        Self {
            variables: rows.variables,
        }
    }

    /// All variables, by reference.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The variable with a value reference.
    #[must_use]
    pub fn get(&self, reference: u32) -> Option<&Variable> {
        self.variables.get(usize::try_from(reference).ok()?)
    }
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
        }
    }

    /// The scene with these tolerances and this step in the place of its own. Gravity, which may change during the
    /// run, is left to [`sphere_dda::simulation::Simulation::set_gravity`].
    #[must_use]
    pub fn apply(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.settings.tolerance = self.tolerance;
        scene.settings.step = self.step;
        scene
    }

    /// Whether [`Self::apply`] would not change a scene.
    #[must_use]
    pub fn fit(&self, scene: &Scene) -> bool {
        self.tolerance == scene.settings.tolerance && self.step == scene.settings.step
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
            _ => {}
        }
    }
}

/// The component of a command that an input drives.
#[must_use]
pub fn component(command: &mut Command, input: Input, axis: usize) -> &mut f64 {
    match input {
        Input::Translation => &mut command.translation[axis],
        Input::Rotation => &mut command.rotation[axis],
        Input::Velocity => &mut command.velocity[axis],
        Input::AngularVelocity => &mut command.angular_velocity[axis],
        Input::Scalar => &mut command.scalar,
    }
}

/// A variable about to be added, without causality and meaning.
struct Row {
    name: String,
    base: BaseType,
    unit: Option<&'static str>,
    start: Option<Value>,
    min: Option<f64>,
    max: Option<f64>,
    description: String,
}

impl Row {
    fn real(
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
            description: description.into(),
        }
    }

    fn count(name: impl Into<String>, description: &str) -> Self {
        let mut row = Self::real(name, None, description);
        row.base = BaseType::Integer;
        row.min(0.0)
    }

    fn start(mut self, value: Value) -> Self {
        self.base = value.base();
        self.start = Some(value);
        self
    }

    fn min(mut self, min: f64) -> Self {
        self.min = Some(min);
        self
    }

    fn max(mut self, max: f64) -> Self {
        self.max = Some(max);
        self
    }
}

#[derive(Default)]
struct Rows {
    variables: Vec<Variable>,
}

impl Rows {
    fn push(&mut self, row: Row, causality: Causality, quantity: Quantity) {
        let variability = match (causality, row.base) {
            (Causality::Parameter, _)
                if matches!(quantity, Quantity::Parameter(Parameter::Gravity(_))) =>
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
            description: row.description,
            quantity,
        });
    }

    /// `size` real variables `name[1]`, `name[2]` ...
    fn vector(
        &mut self,
        (name, size): (String, usize),
        unit: Option<&'static str>,
        description: &str,
        causality: Causality,
        quantity: impl Fn(usize) -> Quantity,
    ) {
        let letters = if size == XYZ {
            ["x", "y", "z", ""]
        } else {
            ["w", "x", "y", "z"]
        };
        for (axis, letter) in letters.iter().enumerate().take(size) {
            let mut row = Row::real(
                format!("{name}[{}]", axis + 1),
                unit,
                format!("{description}; {letter}"),
            );
            if causality == Causality::Input {
                row = row.start(Value::Real(0.0));
            }
            self.push(row, causality, quantity(axis));
        }
    }

    fn parameters(&mut self, scene: &Scene) {
        let parameters = Parameters::of(scene);
        let mut add = |row: Row, parameter: Parameter| {
            let row = row.start(parameters.get(parameter));
            self.push(row, Causality::Parameter, Quantity::Parameter(parameter));
        };
        for (axis, letter) in ["x", "y", "z"].iter().enumerate() {
            let name = format!("gravity[{}]", axis + 1);
            let text = format!("Gravity; {letter}; may change between steps");
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
    }

    fn inputs(&mut self, prefix: &str, boundary: usize, kind: InputKind) {
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
                let name = (format!("{prefix}.{name}"), XYZ);
                self.vector(
                    name,
                    Some(unit),
                    &format!("{what}, {pose}"),
                    Causality::Input,
                    |axis| Quantity::Input {
                        boundary,
                        input,
                        axis,
                    },
                );
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
                let name = (format!("{prefix}.{name}"), XYZ);
                self.vector(
                    name,
                    Some(unit),
                    &format!("{what}, {HELD}"),
                    Causality::Input,
                    |axis| Quantity::Input {
                        boundary,
                        input,
                        axis,
                    },
                );
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
            InputKind::Pose | InputKind::Motion | InputKind::Twist => return,
        };
        let row = Row::real(format!("{prefix}.{name}"), Some(unit), text).start(Value::Real(0.0));
        let quantity = Quantity::Input {
            boundary,
            input: Input::Scalar,
            axis: 0,
        };
        self.push(row, Causality::Input, quantity);
    }

    fn boundary(&mut self, prefix: &str, boundary: usize) {
        use BoundaryOutput as B;
        let vectors = [
            (
                "force",
                XYZ,
                Some("N"),
                "Force of the spheres on the boundary, last internal step",
                B::Force,
            ),
            (
                "torque",
                XYZ,
                Some("N.m"),
                "Its torque about the point of action",
                B::Torque,
            ),
            (
                "averageForce",
                XYZ,
                Some("N"),
                "Force averaged over the communication step, impulse / h",
                B::AverageForce,
            ),
            (
                "averageTorque",
                XYZ,
                Some("N.m"),
                "Torque averaged over the communication step",
                B::AverageTorque,
            ),
            ("position", XYZ, Some("m"), "Point of action", B::Position),
            (
                "orientation",
                4,
                None,
                "Orientation from the scene's, unit quaternion",
                B::Orientation,
            ),
        ];
        for (name, size, unit, text, output) in vectors {
            self.vector(
                (format!("{prefix}.{name}"), size),
                unit,
                text,
                Causality::Output,
                |axis| Quantity::Boundary {
                    boundary,
                    output,
                    axis,
                },
            );
        }
        let of = |output| Quantity::Boundary {
            boundary,
            output,
            axis: 0,
        };
        let row = Row::count(
            format!("{prefix}.contactCount"),
            "Number of loaded contacts",
        );
        self.push(row, Causality::Output, of(B::ContactCount));
        let row = Row::real(
            format!("{prefix}.maxNormalForce"),
            Some("N"),
            "Largest normal force of one contact",
        );
        self.push(row, Causality::Output, of(B::MaxNormalForce));
        let row = Row::real(
            format!("{prefix}.power"),
            Some("W"),
            "Power of the spheres on the boundary",
        );
        self.push(row, Causality::Output, of(B::Power));
    }

    fn probe(&mut self, prefix: &str, probe: usize) {
        use ProbeOutput as P;
        let vectors = [
            (
                "position",
                XYZ,
                Some("m"),
                "Centre of the sphere",
                P::Position,
            ),
            (
                "orientation",
                4,
                None,
                "Orientation, unit quaternion",
                P::Orientation,
            ),
            (
                "velocity",
                XYZ,
                Some("m/s"),
                "Velocity of the centre",
                P::Velocity,
            ),
            (
                "angularVelocity",
                XYZ,
                Some("rad/s"),
                "Angular velocity, world axes",
                P::AngularVelocity,
            ),
            (
                "contactForce",
                XYZ,
                Some("N"),
                "Sum of the contact forces on the sphere",
                P::ContactForce,
            ),
            (
                "contactTorque",
                XYZ,
                Some("N.m"),
                "Torque of the contact forces about the centre",
                P::ContactTorque,
            ),
        ];
        for (name, size, unit, text, output) in vectors {
            self.vector(
                (format!("{prefix}.{name}"), size),
                unit,
                text,
                Causality::Output,
                |axis| Quantity::Probe {
                    probe,
                    output,
                    axis,
                },
            );
        }
        let of = |output| Quantity::Probe {
            probe,
            output,
            axis: 0,
        };
        let row = Row::count(
            format!("{prefix}.contactCount"),
            "Number of loaded contacts",
        );
        self.push(row, Causality::Output, of(P::ContactCount));
        let row = Row::real(
            format!("{prefix}.maxNormalForce"),
            Some("N"),
            "Largest normal force of one contact",
        );
        self.push(row, Causality::Output, of(P::MaxNormalForce));
    }

    fn sensor(&mut self, prefix: &str, sensor: usize, measure: &Measure) {
        let of = |output| Quantity::Sensor { sensor, output };
        let mass = |name: String, text: &str| Row::real(name, Some("kg"), text);
        match measure {
            Measure::MassInBox { .. } => {
                let row = mass(
                    prefix.to_owned(),
                    "Mass of the spheres whose centre is in the box",
                );
                self.push(row, Causality::Output, of(SensorOutput::Mass));
            }
            Measure::MassFlow { .. } => {
                let text = "Mass that has crossed the plane along its normal since the start";
                let row = mass(format!("{prefix}.mass"), text);
                self.push(row, Causality::Output, of(SensorOutput::Mass));
                let text = "Mass flow through the plane, mean over the communication step";
                let row = Row::real(format!("{prefix}.rate"), Some("kg/s"), text);
                self.push(row, Causality::Output, of(SensorOutput::Rate));
            }
        }
    }

    fn globals(&mut self) {
        use GlobalOutput as G;
        let of = |output| move |axis| Quantity::Global { output, axis };
        let text = "Momentum of the spheres, half-step velocities: averaged wrench x time + weight = its change";
        self.vector(
            ("momentum".into(), XYZ),
            Some("kg.m/s"),
            text,
            Causality::Output,
            of(G::Momentum),
        );
        let text = "Angular momentum about the origin, half-step velocities";
        self.vector(
            ("angularMomentum".into(), XYZ),
            Some("kg.m2/s"),
            text,
            Causality::Output,
            of(G::AngularMomentum),
        );
        let reals = [
            ("mass", Some("kg"), "Mass of all spheres", G::Mass),
            (
                "kineticEnergy",
                Some("J"),
                "Kinetic energy",
                G::KineticEnergy,
            ),
            (
                "potentialEnergy",
                Some("J"),
                "Potential energy of gravity and springs",
                G::PotentialEnergy,
            ),
            (
                "dissipatedEnergy",
                Some("J"),
                "Energy lost in contacts since the start",
                G::DissipatedEnergy,
            ),
            (
                "boundaryWork",
                Some("J"),
                "Work of moving boundaries on the spheres since the start",
                G::BoundaryWork,
            ),
            (
                "loadWork",
                Some("J"),
                "Work of point loads since the start",
                G::LoadWork,
            ),
            (
                "springWork",
                Some("J"),
                "Work of constrained springs since the start",
                G::SpringWork,
            ),
            (
                "maxOverlap",
                None,
                "Largest true overlap over radius in the communication step",
                G::MaxOverlap,
            ),
            (
                "solver.gapResidual",
                None,
                "Largest gap residual in the communication step",
                G::GapResidual,
            ),
            (
                "solver.slipResidual",
                None,
                "Largest slip residual in the communication step",
                G::SlipResidual,
            ),
            (
                "solver.forceResidual",
                None,
                "Largest force residual in the communication step",
                G::ForceResidual,
            ),
            (
                "recommendedStep",
                Some("s"),
                "Internal step advised at the present speeds",
                G::RecommendedStep,
            ),
        ];
        for (name, unit, text, output) in reals {
            self.push(
                Row::real(name, unit, text),
                Causality::Output,
                of(output)(0),
            );
        }
        let counts = [
            ("contactCount", "Number of loaded contacts", G::ContactCount),
            (
                "solver.internalSteps",
                "Internal steps of the communication step",
                G::InternalSteps,
            ),
            ("solver.cuts", "How many of them came from halving", G::Cuts),
            (
                "solver.sweeps",
                "Gauss-Seidel sweeps of the communication step",
                G::Sweeps,
            ),
            (
                "solver.augmentations",
                "Augmented-Lagrangian iterations of the communication step",
                G::Augmentations,
            ),
            (
                "solver.factorizations",
                "Factorizations of the communication step",
                G::Factorizations,
            ),
        ];
        for (name, text, output) in counts {
            self.push(Row::count(name, text), Causality::Output, of(output)(0));
        }
    }
}
