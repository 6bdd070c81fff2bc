//! Header, units and types.

use super::*;

pub(crate) const CASES: &[Case] = &[
    // Header.
    case(
        "another version",
        Error,
        Rule::FmiVersion,
        "@fmiVersion",
        |m| m.fmi_version = "2.0.5".into(),
    ),
    case("no guid", Error, Rule::RequiredAttribute, "@guid", |m| {
        m.guid.clear()
    }),
    case(
        "no model name",
        Error,
        Rule::RequiredAttribute,
        "@modelName",
        |m| m.model_name.clear(),
    ),
    case(
        "a date only",
        Error,
        Rule::GenerationDateAndTime,
        "@generationDateAndTime",
        |m| {
            m.generation_date_and_time = Some("2026-01-01".into());
        },
    ),
    case(
        "no interface",
        Error,
        Rule::Interface,
        "fmiModelDescription",
        |m| m.co_simulation = None,
    ),
    case(
        "a dash in the identifier",
        Error,
        Rule::ModelIdentifier,
        "CoSimulation/@modelIdentifier",
        |m| {
            m.co_simulation.as_mut().unwrap().model_identifier = "sphere-dda".into();
        },
    ),
    case(
        "an empty identifier",
        Error,
        Rule::ModelIdentifier,
        "CoSimulation",
        |m| {
            m.co_simulation.as_mut().unwrap().model_identifier.clear();
        },
    ),
    case(
        "serializes what it cannot get",
        Error,
        Rule::StateFlags,
        "@canSerializeFMUstate",
        |m| {
            m.co_simulation.as_mut().unwrap().can_get_and_set_fmu_state = false;
        },
    ),
    case(
        "a category twice",
        Error,
        Rule::LogCategoryUnique,
        "`logStatusError`",
        |m| {
            m.log_categories.push(m.log_categories[0].clone());
        },
    ),
    case(
        "a category without name",
        Error,
        Rule::RequiredAttribute,
        "LogCategories",
        |m| {
            m.log_categories[0].name.clear();
        },
    ),
    case(
        "stop before start",
        Error,
        Rule::DefaultExperiment,
        "@stopTime",
        |m| {
            m.default_experiment.as_mut().unwrap().start_time = Some(2.0);
        },
    ),
    case(
        "stop at a start by default",
        Error,
        Rule::DefaultExperiment,
        "@stopTime",
        |m| {
            let experiment = m.default_experiment.as_mut().unwrap();
            (experiment.start_time, experiment.stop_time) = (None, Some(0.0));
        },
    ),
    case(
        "stop never",
        Error,
        Rule::DefaultExperiment,
        "@stopTime",
        |m| {
            m.default_experiment.as_mut().unwrap().stop_time = Some(f64::INFINITY);
        },
    ),
    case(
        "no tolerance",
        Error,
        Rule::DefaultExperiment,
        "@tolerance",
        |m| {
            m.default_experiment.as_mut().unwrap().tolerance = Some(0.0);
        },
    ),
    case(
        "a step back",
        Error,
        Rule::DefaultExperiment,
        "@stepSize",
        |m| {
            m.default_experiment.as_mut().unwrap().step_size = Some(-0.1);
        },
    ),
    // Units and types.
    case("a unit twice", Error, Rule::UnitUnique, "Unit `s`", |m| {
        m.unit_definitions.push(m.unit_definitions[0].clone());
    }),
    case(
        "a display unit twice",
        Error,
        Rule::DisplayUnitUnique,
        "DisplayUnit `kN`",
        |m| {
            let unit = m.unit_definitions.pop().unwrap();
            m.unit_definitions
                .push(unit.with_display_unit("kN", 1e-3, 0.0));
        },
    ),
    case(
        "factor 0",
        Error,
        Rule::UnitConversion,
        "DisplayUnit `kN`/@factor",
        |m| {
            m.unit_definitions[4].display_units[0].factor = 0.0;
        },
    ),
    case(
        "offset NaN",
        Error,
        Rule::UnitConversion,
        "BaseUnit/@offset",
        |m| {
            m.unit_definitions.push(Unit::new(
                "q",
                BaseUnit {
                    offset: f64::NAN,
                    ..BaseUnit::DIMENSIONLESS
                },
            ));
        },
    ),
    case(
        "a type twice",
        Error,
        Rule::TypeNameUnique,
        "SimpleType `Preconditioner`",
        |m| {
            m.type_definitions.push(m.type_definitions[0].clone());
        },
    ),
    case(
        "a type named as a variable",
        Error,
        Rule::TypeNameUnique,
        "SimpleType `mass`",
        |m| {
            real_type(m, "mass", RealType::default());
        },
    ),
    case(
        "no items",
        Error,
        Rule::EnumerationItems,
        "Enumeration",
        |m| {
            m.type_definitions
                .push(SimpleType::enumeration("Empty", []));
        },
    ),
    case(
        "an item value twice",
        Error,
        Rule::EnumerationUnique,
        "Item `cholesky`/@value",
        |m| {
            items(m)[1].value = 1;
        },
    ),
    case(
        "an item name twice",
        Error,
        Rule::EnumerationUnique,
        "Item `jacobi`",
        |m| {
            items(m)[1].name = "jacobi".into();
        },
    ),
    case(
        "a type of an unknown unit",
        Error,
        Rule::UnitDefined,
        "SimpleType `Angle`/Real/@unit",
        |m| {
            real_type(
                m,
                "Angle",
                RealType {
                    unit: Some("rad".into()),
                    ..RealType::default()
                },
            );
        },
    ),
    case(
        "a type with crossed bounds",
        Error,
        Rule::Range,
        "SimpleType `Angle`",
        |m| {
            real_type(
                m,
                "Angle",
                RealType {
                    min: Some(1.0),
                    max: Some(0.0),
                    ..RealType::default()
                },
            );
        },
    ),
    case(
        "a type with nominal 0",
        Error,
        Rule::Nominal,
        "SimpleType `Angle`/Real/@nominal",
        |m| {
            real_type(
                m,
                "Angle",
                RealType {
                    nominal: Some(0.0),
                    ..RealType::default()
                },
            );
        },
    ),
    case(
        "a type name of two words",
        Error,
        Rule::Name,
        "SimpleType `two words`",
        |m| {
            real_type(m, "two words", RealType::default());
        },
    ),
];
