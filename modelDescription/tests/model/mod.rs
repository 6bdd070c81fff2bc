//! A small valid description that has one of everything the unit of this project
//! writes.

use sphere_dda_model_description::fmi2::{
    BooleanVariable, Causality, CoSimulation, DefaultExperiment, EnumerationVariable, Initial,
    IntegerVariable, LogCategory, ModelDescription, RealVariable, ScalarVariable, SimpleType,
    StringVariable, Variability,
};
use sphere_dda_model_description::units::{BaseUnit, Unit};

/// Indices, from 1, of the variables of [`small`].
#[allow(dead_code)] // Not every test needs every one.
pub(crate) mod index {
    pub(crate) const TIME: usize = 1;
    pub(crate) const VELOCITY: usize = 2;
    pub(crate) const FORCE: usize = 3;
    pub(crate) const COUNT: usize = 4;
    pub(crate) const GRAVITY: usize = 5;
    pub(crate) const WRITE: usize = 6;
    pub(crate) const DIRECTORY: usize = 7;
    pub(crate) const SOLVER: usize = 8;
    pub(crate) const MASS: usize = 9;
    pub(crate) const LIMIT: usize = 10;
}

pub(crate) fn small() -> ModelDescription {
    let si = BaseUnit::DIMENSIONLESS;
    let mut interface = CoSimulation::new("sphere_dda");
    interface.can_handle_variable_communication_step_size = true;
    interface.can_interpolate_inputs = true;
    interface.max_output_derivative_order = 1;
    interface.can_get_and_set_fmu_state = true;
    interface.can_serialize_fmu_state = true;

    let mut model = ModelDescription::new("Hopper", "{5f3a}", interface).with_variables(vec![
        ScalarVariable::new(
            "time",
            0,
            Causality::Independent,
            Variability::Continuous,
            RealVariable::with_unit("s"),
        ),
        ScalarVariable::new(
            "boundary.gate.velocity[1]",
            1,
            Causality::Input,
            Variability::Continuous,
            RealVariable::with_unit("m/s").with_start(0.0),
        )
        .with_description("speed of the gate, held over the step"),
        ScalarVariable::new(
            "boundary.gate.force[1]",
            2,
            Causality::Output,
            Variability::Continuous,
            RealVariable::with_unit("N")
                .with_display_unit("kN")
                .with_quantity("Force")
                .with_nominal(1e-3),
        ),
        ScalarVariable::new(
            "contactCount",
            0,
            Causality::Output,
            Variability::Discrete,
            IntegerVariable::new().with_min(0),
        ),
        ScalarVariable::new(
            "gravity[3]",
            3,
            Causality::Parameter,
            Variability::Tunable,
            RealVariable::with_unit("m/s2")
                .with_start(-9.81)
                .with_min(-100.0)
                .with_max(100.0),
        ),
        ScalarVariable::new(
            "output.overwrite",
            0,
            Causality::Parameter,
            Variability::Fixed,
            BooleanVariable::new().with_start(false),
        ),
        ScalarVariable::new(
            "output.directory",
            0,
            Causality::Parameter,
            Variability::Fixed,
            StringVariable::new().with_start(""),
        ),
        ScalarVariable::new(
            "solver.preconditioner",
            1,
            Causality::Parameter,
            Variability::Fixed,
            EnumerationVariable::new("Preconditioner").with_start(1),
        ),
        ScalarVariable::new(
            "mass",
            4,
            Causality::CalculatedParameter,
            Variability::Fixed,
            RealVariable::with_unit("kg"),
        ),
        ScalarVariable::new(
            "solver.'iteration limit'",
            2,
            Causality::Local,
            Variability::Constant,
            IntegerVariable::new().with_start(200),
        )
        .with_initial(Initial::Exact),
    ]);
    model.description = Some("spheres < 5 mm & a \"gate\"".to_owned());
    model.generation_date_and_time = Some("2026-01-01T00:00:00Z".to_owned());
    model.unit_definitions = vec![
        Unit::new("s", BaseUnit { s: 1, ..si }),
        Unit::new("kg", BaseUnit { kg: 1, ..si }),
        Unit::new("m/s", BaseUnit { m: 1, s: -1, ..si }),
        Unit::new("m/s2", BaseUnit { m: 1, s: -2, ..si }),
        Unit::new(
            "N",
            BaseUnit {
                kg: 1,
                m: 1,
                s: -2,
                ..si
            },
        )
        .with_display_unit("kN", 1e-3, 0.0),
    ];
    model.type_definitions = vec![SimpleType::enumeration(
        "Preconditioner",
        [
            ("jacobi", 1, "diagonal blocks"),
            ("cholesky", 2, "incomplete Cholesky factor"),
        ],
    )];
    model.log_categories = vec![LogCategory::new("logStatusError", "errors")];
    model.default_experiment = Some(DefaultExperiment {
        start_time: Some(0.0),
        stop_time: Some(2.0),
        tolerance: None,
        step_size: Some(0.01),
    });
    model
}
