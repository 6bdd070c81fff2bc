//! Strategies for descriptions of any content, sensible or not.

use proptest::prelude::*;
use sphere_dda_model_description::fmi2::{
    BooleanVariable, Causality, CoSimulation, DefaultExperiment, DependencyKind, EnumerationItem,
    EnumerationType, EnumerationVariable, Initial, IntegerType, IntegerVariable, LogCategory,
    ModelDescription, ModelExchange, ModelStructure, NamingConvention, RealType, RealVariable,
    ScalarVariable, SimpleType, StringVariable, TypeDefinition, Unknown, Variability, VariableType,
};
use sphere_dda_model_description::units::{BaseUnit, DisplayUnit, Unit};

/// Any text that XML can carry.
pub(crate) fn text() -> impl Strategy<Value = String> {
    let carried = |character| match character {
        '\t' | '\n' | '\r' | ' '..'\u{fffe}' | '\u{10000}'.. => character,
        _ => '?',
    };
    proptest::collection::vec(any::<char>().prop_map(carried), 0..12).prop_map(String::from_iter)
}

fn maybe_text() -> impl Strategy<Value = Option<String>> {
    proptest::option::of(text())
}

/// Any number but NaN, which is not equal to itself.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>().prop_filter("comparable", |x| !x.is_nan()),
        Just(0.0),
        Just(f64::INFINITY),
    ]
}

fn maybe_number() -> impl Strategy<Value = Option<f64>> {
    proptest::option::of(number())
}

fn unit() -> impl Strategy<Value = Unit> {
    let exponents = proptest::array::uniform8(-4..5_i32);
    let base = (exponents, number(), number()).prop_map(
        |([kg, m, s, a, k, mol, cd, rad], factor, offset)| BaseUnit {
            kg,
            m,
            s,
            a,
            k,
            mol,
            cd,
            rad,
            factor,
            offset,
        },
    );
    let display = (text(), number(), number()).prop_map(|(name, factor, offset)| DisplayUnit {
        name,
        factor,
        offset,
    });
    (
        text(),
        proptest::option::of(base),
        proptest::collection::vec(display, 0..3),
    )
        .prop_map(|(name, base_unit, display_units)| Unit {
            name,
            base_unit,
            display_units,
        })
}

fn simple_type() -> impl Strategy<Value = SimpleType> {
    let real = (
        maybe_text(),
        maybe_text(),
        maybe_number(),
        proptest::option::of(any::<bool>()),
    )
        .prop_map(|(quantity, unit, min, unbounded)| {
            TypeDefinition::Real(RealType {
                quantity,
                display_unit: unit.clone(),
                unit,
                relative_quantity: unbounded,
                min,
                max: min,
                nominal: min,
                unbounded,
            })
        });
    let integer = (maybe_text(), any::<Option<i32>>(), any::<Option<i32>>()).prop_map(
        |(quantity, min, max)| TypeDefinition::Integer(IntegerType { quantity, min, max }),
    );
    let item = (text(), any::<i32>(), maybe_text()).prop_map(|(name, value, description)| {
        EnumerationItem {
            name,
            value,
            description,
        }
    });
    let enumeration =
        (maybe_text(), proptest::collection::vec(item, 0..3)).prop_map(|(quantity, items)| {
            TypeDefinition::Enumeration(EnumerationType { quantity, items })
        });
    let definition = prop_oneof![
        real,
        integer,
        enumeration,
        Just(TypeDefinition::Boolean),
        Just(TypeDefinition::String),
    ];
    (text(), maybe_text(), definition).prop_map(|(name, description, definition)| SimpleType {
        name,
        description,
        definition,
    })
}

fn variable_type() -> impl Strategy<Value = VariableType> {
    let real = (
        (maybe_text(), maybe_text(), maybe_text(), maybe_text()),
        (
            any::<Option<bool>>(),
            any::<Option<bool>>(),
            any::<Option<bool>>(),
        ),
        (
            maybe_number(),
            maybe_number(),
            maybe_number(),
            maybe_number(),
        ),
        any::<Option<u32>>(),
    )
        .prop_map(|(texts, flags, numbers, derivative)| {
            VariableType::Real(RealVariable {
                declared_type: texts.0,
                quantity: texts.1,
                unit: texts.2,
                display_unit: texts.3,
                relative_quantity: flags.0,
                min: numbers.0,
                max: numbers.1,
                nominal: numbers.2,
                unbounded: flags.1,
                start: numbers.3,
                derivative,
                reinit: flags.2,
            })
        });
    let numbers = any::<[Option<i32>; 3]>();
    let integer = (maybe_text(), maybe_text(), numbers).prop_map(
        |(declared_type, quantity, [min, max, start])| {
            VariableType::Integer(IntegerVariable {
                declared_type,
                quantity,
                min,
                max,
                start,
            })
        },
    );
    let enumeration = (text(), maybe_text(), any::<[Option<i32>; 3]>()).prop_map(
        |(declared_type, quantity, [min, max, start])| {
            VariableType::Enumeration(EnumerationVariable {
                declared_type,
                quantity,
                min,
                max,
                start,
            })
        },
    );
    let boolean = (maybe_text(), any::<Option<bool>>()).prop_map(|(declared_type, start)| {
        VariableType::Boolean(BooleanVariable {
            declared_type,
            start,
        })
    });
    let string = (maybe_text(), maybe_text()).prop_map(|(declared_type, start)| {
        VariableType::String(StringVariable {
            declared_type,
            start,
        })
    });
    prop_oneof![real, integer, enumeration, boolean, string]
}

fn variable() -> impl Strategy<Value = ScalarVariable> {
    let causality = proptest::sample::select(vec![
        Causality::Parameter,
        Causality::CalculatedParameter,
        Causality::Input,
        Causality::Output,
        Causality::Local,
        Causality::Independent,
    ]);
    let variability = proptest::sample::select(vec![
        Variability::Constant,
        Variability::Fixed,
        Variability::Tunable,
        Variability::Discrete,
        Variability::Continuous,
    ]);
    let initial = proptest::option::of(proptest::sample::select(vec![
        Initial::Exact,
        Initial::Approx,
        Initial::Calculated,
    ]));
    (
        (text(), any::<u32>(), maybe_text()),
        (causality, variability, initial),
        variable_type(),
    )
        .prop_map(|(naming, attributes, variable_type)| ScalarVariable {
            name: naming.0,
            value_reference: naming.1,
            description: naming.2,
            causality: attributes.0,
            variability: attributes.1,
            initial: attributes.2,
            variable_type,
        })
}

fn unknowns() -> impl Strategy<Value = Vec<Unknown>> {
    let kinds = proptest::collection::vec(
        proptest::sample::select(vec![
            DependencyKind::Dependent,
            DependencyKind::Constant,
            DependencyKind::Fixed,
            DependencyKind::Tunable,
            DependencyKind::Discrete,
        ]),
        0..4,
    );
    let unknown = (
        any::<u32>(),
        proptest::option::of(proptest::collection::vec(any::<u32>(), 0..4)),
        proptest::option::of(kinds),
    )
        .prop_map(|(index, dependencies, dependencies_kind)| Unknown {
            index,
            dependencies,
            dependencies_kind,
        });
    proptest::collection::vec(unknown, 0..4)
}

pub(crate) fn description() -> impl Strategy<Value = ModelDescription> {
    let exchange = text().prop_map(|model_identifier| ModelExchange { model_identifier });
    let co_simulation = (text(), any::<[bool; 9]>(), any::<u32>()).prop_map(
        |(model_identifier, flags, max_output_derivative_order)| CoSimulation {
            model_identifier,
            needs_execution_tool: flags[0],
            can_handle_variable_communication_step_size: flags[1],
            can_interpolate_inputs: flags[2],
            max_output_derivative_order,
            can_run_asynchronuously: flags[3],
            can_be_instantiated_only_once_per_process: flags[4],
            can_not_use_memory_management_functions: flags[5],
            can_get_and_set_fmu_state: flags[6],
            can_serialize_fmu_state: flags[7],
            provides_directional_derivative: flags[8],
        },
    );
    let header = (
        text(),
        text(),
        proptest::array::uniform7(maybe_text()),
        any::<bool>(),
    );
    let experiment = proptest::array::uniform4(maybe_number()).prop_map(
        |[start_time, stop_time, tolerance, step_size]| DefaultExperiment {
            start_time,
            stop_time,
            tolerance,
            step_size,
        },
    );
    let categories = proptest::collection::vec(
        (text(), maybe_text()).prop_map(|(name, description)| LogCategory { name, description }),
        0..3,
    );
    let structure = (unknowns(), unknowns(), unknowns()).prop_map(
        |(outputs, derivatives, initial_unknowns)| ModelStructure {
            outputs,
            derivatives,
            initial_unknowns,
        },
    );
    (
        header,
        proptest::option::of(exchange),
        proptest::option::of(co_simulation),
        proptest::collection::vec(unit(), 0..3),
        proptest::collection::vec(simple_type(), 0..3),
        categories,
        proptest::option::of(experiment),
        proptest::collection::vec(variable(), 0..6),
        structure,
    )
        .prop_map(
            |(
                header,
                exchange,
                co_simulation,
                units,
                types,
                categories,
                experiment,
                variables,
                structure,
            )| {
                let (model_name, guid, texts, structured) = header;
                let [description, author, version, copyright, license, tool, date] = texts;
                ModelDescription {
                    fmi_version: "2.0".to_owned(),
                    model_name,
                    guid,
                    description,
                    author,
                    version,
                    copyright,
                    license,
                    generation_tool: tool,
                    generation_date_and_time: date,
                    variable_naming_convention: if structured {
                        NamingConvention::Structured
                    } else {
                        NamingConvention::Flat
                    },
                    model_exchange: exchange,
                    co_simulation,
                    unit_definitions: units,
                    type_definitions: types,
                    log_categories: categories,
                    default_experiment: experiment,
                    model_variables: variables,
                    model_structure: structure,
                }
            },
        )
}
