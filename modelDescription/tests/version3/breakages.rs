//! A small description of FMI 3.0 and a breakage of it for every rule.

use sphere_dda_model_description::Rule;
use sphere_dda_model_description::fmi3::{
    Alias, Causality, CoSimulation, EnumerationType, ModelDescription, OtherInterface, StartValue,
    Variability, Variable,
};
use sphere_dda_model_description::units::{BaseUnit, Unit};
use sphere_dda_model_description::value::ScalarType;

use Causality::{CalculatedParameter, Independent, Input, Output, Parameter};
use Variability::{Continuous, Discrete, Fixed};

/// A description with a variable of every kind of use, without findings.
pub(crate) fn small() -> ModelDescription {
    let mut time = Variable::new(ScalarType::Float64, "time", 0, Independent, Continuous);
    time.unit = Some("s".to_owned());
    let mut velocity = Variable::new(ScalarType::Float64, "gate.velocity", 1, Input, Continuous)
        .with_dimensions(&[3])
        .with_reals(&[0.0, -0.5, 1e-9]);
    velocity.unit = Some("m/s".to_owned());
    velocity.min = Some("-10.0".to_owned());
    velocity.max = Some("10.0".to_owned());
    velocity.intermediate_update = true;
    velocity.aliases = vec![Alias {
        name: "v".to_owned(),
        description: None,
        display_unit: Some("mm/s".to_owned()),
    }];
    let places = Variable::new(
        ScalarType::Float64,
        "spheres.position",
        2,
        Output,
        Continuous,
    )
    .with_dimensions(&[100, 3]);
    let mut folder = Variable::new(ScalarType::String, "folder", 3, Parameter, Fixed);
    folder.starts = vec![StartValue {
        value: "a <b> & \"c\"".to_owned(),
    }];
    let mut bytes = Variable::new(ScalarType::Binary, "spheres.document", 4, Output, Discrete);
    bytes.mime_type = Some("application/x-spheres".to_owned());
    let count = Variable::new(ScalarType::Int32, "count", 5, Output, Discrete);
    let radius = Variable::new(ScalarType::Float64, "radius", 6, CalculatedParameter, Fixed)
        .with_dimensions(&[2]);
    let mut interface = CoSimulation::new("gate");
    interface.provides_intermediate_update = true;
    interface.can_return_early_after_intermediate_update = true;
    let mut choice = Variable::new(ScalarType::Enumeration, "choice", 7, Parameter, Fixed);
    choice.declared_type = Some("Choice".to_owned());
    choice.start = Some("2".to_owned());
    let variables = vec![time, velocity, places, folder, bytes, count, radius, choice];
    let mut model = ModelDescription::new("Gate", "{1c}", interface).with_variables(variables);
    let items = [("one", 1, "The first"), ("two", 2, "The second")];
    model.type_definitions = vec![EnumerationType::new("Choice", items)];
    let metre = BaseUnit {
        m: 1,
        s: -1,
        ..BaseUnit::DIMENSIONLESS
    };
    let second = BaseUnit {
        s: 1,
        ..BaseUnit::DIMENSIONLESS
    };
    model.unit_definitions = vec![
        Unit::new("s", second),
        Unit::new("m/s", metre).with_display_unit("mm/s", 1e3, 0.0),
    ];
    model.model_structure.initial_unknowns[3].dependencies = Some(vec![]);
    model
}

type Break = fn(&mut ModelDescription);
fn at(model: &mut ModelDescription, k: usize) -> &mut Variable {
    &mut model.model_variables[k]
}
fn cases() -> [(Rule, Break); 34] {
    [
        (Rule::FmiVersion, |m| m.fmi_version = "3.1".to_owned()),
        (Rule::RequiredAttribute, |m| m.instantiation_token.clear()),
        (Rule::GenerationDateAndTime, |m| {
            m.generation_date_and_time = Some("today".to_owned());
        }),
        (Rule::Interface, |m| m.co_simulation = None),
        (Rule::ModelIdentifier, |m| {
            m.model_exchange = Some(OtherInterface {
                model_identifier: "a b".to_owned(),
            });
        }),
        (Rule::StateFlags, |m| {
            m.co_simulation.as_mut().unwrap().can_serialize_fmu_state = true;
        }),
        (Rule::StepFlags, |m| {
            m.co_simulation
                .as_mut()
                .unwrap()
                .provides_intermediate_update = false;
        }),
        (Rule::NameUnique, |m| at(m, 5).name = "v".to_owned()),
        (Rule::Name, |m| at(m, 5).name = "a b".to_owned()),
        (Rule::Independent, |m| at(m, 0).dimensions = vec![2.into()]),
        (Rule::Dimension, |m| at(m, 2).dimensions[0] = 0.into()),
        (Rule::Dimension, |m| {
            at(m, 2).dimensions[0].start = None;
            at(m, 2).dimensions[0].value_reference = Some(1);
        }),
        (Rule::Clocks, |m| at(m, 2).clocks = Some(vec![1])),
        (Rule::UnitDefined, |m| {
            at(m, 2).unit = Some("ell".to_owned())
        }),
        (Rule::DisplayUnitDefined, |m| {
            at(m, 1).aliases[0].display_unit = Some("km/h".to_owned());
        }),
        (Rule::Variability, |m| {
            at(m, 5).variability = Some(Continuous);
        }),
        (Rule::Combination, |m| at(m, 1).variability = Some(Fixed)),
        (Rule::Initial, |m| {
            at(m, 3).initial = Some(sphere_dda_model_description::fmi3::Initial::Approx);
        }),
        (Rule::IntermediateUpdate, |m| {
            at(m, 3).intermediate_update = true;
        }),
        (Rule::ValueType, |m| at(m, 5).max = Some("4e9".to_owned())),
        (Rule::Range, |m| {
            at(m, 5).min = Some("4".to_owned());
            at(m, 5).max = Some("3".to_owned());
        }),
        (Rule::StartRange, |m| {
            at(m, 1).start = Some("0 0 11".to_owned());
        }),
        (Rule::StartCount, |m| {
            at(m, 1).start = Some("0 0".to_owned())
        }),
        (Rule::StartMissing, |m| at(m, 3).starts.clear()),
        (Rule::StartForbidden, |m| {
            at(m, 5).start = Some("1".to_owned());
        }),
        (Rule::Outputs, |m| {
            m.model_structure.outputs.pop();
        }),
        (Rule::Dependencies, |m| {
            m.model_structure.outputs[0].dependencies = Some(vec![77]);
        }),
        (Rule::TypeNameUnique, |m| {
            m.type_definitions.push(m.type_definitions[0].clone());
        }),
        (Rule::EnumerationItems, |m| {
            m.type_definitions.push(EnumerationType::new("Empty", []));
        }),
        (Rule::EnumerationUnique, |m| {
            m.type_definitions[0].items[0].value = 2;
        }),
        (Rule::EnumerationUnique, |m| {
            m.type_definitions[0].items[0].name = "two".to_owned();
        }),
        (Rule::DeclaredType, |m| at(m, 7).declared_type = None),
        (Rule::StartRange, |m| at(m, 7).start = Some("3".to_owned())),
        (Rule::ReferenceUnique, |m| at(m, 3).value_reference = 1),
    ]
}

/// The small description broken once for every rule of version 3.
pub(crate) fn broken() -> impl Iterator<Item = (Rule, ModelDescription)> {
    cases().into_iter().map(|(rule, breakage)| {
        let mut model = small();
        breakage(&mut model);
        (rule, model)
    })
}
