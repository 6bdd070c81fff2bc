//! Model structure.

use super::*;

pub(crate) const CASES: &[Case] = &[
    case(
        "no variables",
        Error,
        Rule::VariablesMissing,
        "ModelVariables",
        |m| {
            *m = m.clone().with_variables(vec![]);
        },
    ),
    case(
        "index 0",
        Error,
        Rule::StructureIndex,
        "Outputs/Unknown 1, index 0",
        |m| {
            m.model_structure.outputs.insert(0, Unknown::new(0));
        },
    ),
    case(
        "index too large",
        Error,
        Rule::StructureIndex,
        "InitialUnknowns/Unknown 4, index 11",
        |m| {
            m.model_structure.initial_unknowns.push(Unknown::new(11));
        },
    ),
    case(
        "a dependency that is not there",
        Error,
        Rule::StructureIndex,
        "@dependencies",
        |m| {
            m.model_structure.outputs[0].dependencies = Some(vec![2, 99]);
        },
    ),
    case(
        "an output is not listed",
        Error,
        Rule::Outputs,
        "ModelStructure/Outputs",
        |m| drop(m.model_structure.outputs.pop()),
    ),
    case(
        "an output twice",
        Error,
        Rule::Outputs,
        "Unknown 3, index 4 `contactCount`",
        |m| {
            m.model_structure.outputs.push(Unknown::new(4));
        },
    ),
    case(
        "an output that is none",
        Error,
        Rule::Outputs,
        "Unknown 3, index 9 `mass`",
        |m| {
            m.model_structure.outputs.push(Unknown::new(9));
        },
    ),
    case(
        "outputs in disorder",
        Warning,
        Rule::OutputsOrder,
        "Outputs",
        |m| m.model_structure.outputs.reverse(),
    ),
    case(
        "a calculated state is missing",
        Error,
        Rule::InitialUnknowns,
        "InitialUnknowns",
        |m| {
            expose_a_state(
                m,
                local("x", 20, RealVariable::new()),
                RealVariable::new().with_derivative(11),
            );
        },
    ),
    case(
        "a calculated parameter is missing",
        Error,
        Rule::InitialUnknowns,
        "InitialUnknowns",
        |m| {
            drop(m.model_structure.initial_unknowns.pop());
        },
    ),
    case(
        "an exact output is listed",
        Error,
        Rule::InitialUnknowns,
        "index 3",
        |m| {
            variable(m, FORCE).initial = Some(Initial::Exact);
            real(m, FORCE).start = Some(0.0);
        },
    ),
    case(
        "an initial unknown twice",
        Error,
        Rule::InitialUnknowns,
        "Unknown 4, index 9",
        |m| {
            m.model_structure.initial_unknowns.push(Unknown::new(9));
        },
    ),
    case(
        "initial unknowns in disorder",
        Error,
        Rule::InitialUnknownsOrder,
        "InitialUnknowns",
        |m| {
            m.model_structure.initial_unknowns.swap(0, 1);
        },
    ),
    case(
        "dependencies that do not ascend",
        Error,
        Rule::Dependencies,
        "Unknown 1, index 3",
        |m| {
            m.model_structure.outputs[0].dependencies = Some(vec![2, 1]);
        },
    ),
    case(
        "an output that depends on a parameter",
        Warning,
        Rule::Dependencies,
        "Outputs",
        |m| {
            m.model_structure.outputs[0].dependencies = Some(vec![2, 5]);
        },
    ),
    case(
        "an unknown on another",
        Warning,
        Rule::Dependencies,
        "InitialUnknowns",
        |m| {
            m.model_structure.initial_unknowns[0].dependencies = Some(vec![9]);
        },
    ),
    case(
        "too few kinds",
        Error,
        Rule::DependenciesKind,
        "@dependenciesKind",
        |m| {
            m.model_structure.outputs[0].dependencies = Some(vec![1, 2]);
            m.model_structure.outputs[0].dependencies_kind = Some(vec![DependencyKind::Dependent]);
        },
    ),
    case(
        "kinds of nothing",
        Error,
        Rule::DependenciesKind,
        "@dependenciesKind",
        |m| {
            m.model_structure.outputs[0].dependencies_kind = Some(vec![]);
        },
    ),
    case(
        "a kind only for running",
        Warning,
        Rule::DependenciesKind,
        "InitialUnknowns",
        |m| {
            m.model_structure.initial_unknowns[0].dependencies = Some(vec![5]);
            m.model_structure.initial_unknowns[0].dependencies_kind =
                Some(vec![DependencyKind::Tunable]);
        },
    ),
    case(
        "a factor of an integer",
        Warning,
        Rule::DependenciesKind,
        "index 4 `contactCount`",
        |m| {
            m.model_structure.outputs[1].dependencies = Some(vec![2]);
            m.model_structure.outputs[1].dependencies_kind = Some(vec![DependencyKind::Constant]);
        },
    ),
];
