//! Variables and aliases.

use super::*;

pub(crate) const CASES: &[Case] = &[
    // One variable.
    case(
        "blank in an index",
        Error,
        Rule::Name,
        "ScalarVariable 9",
        |m| variable(m, MASS).name = "m[1, 2]".into(),
    ),
    case(
        "no name",
        Error,
        Rule::RequiredAttribute,
        "ScalarVariable 9",
        |m| variable(m, MASS).name.clear(),
    ),
    case(
        "a name twice",
        Error,
        Rule::NameUnique,
        "ScalarVariable 9 `time`",
        |m| {
            variable(m, MASS).name = "time".into();
        },
    ),
    case(
        "a continuous parameter",
        Error,
        Rule::Combination,
        "gravity",
        |m| {
            variable(m, GRAVITY).variability = Variability::Continuous;
        },
    ),
    case(
        "an input with initial",
        Error,
        Rule::Initial,
        "velocity[1]`/@initial",
        |m| {
            variable(m, VELOCITY).initial = Some(Initial::Exact);
        },
    ),
    case(
        "a calculated parameter that is exact",
        Error,
        Rule::Initial,
        "mass",
        |m| {
            variable(m, MASS).initial = Some(Initial::Exact);
            real(m, MASS).start = Some(1.0);
        },
    ),
    case(
        "a continuous integer",
        Error,
        Rule::Variability,
        "contactCount",
        |m| {
            variable(m, COUNT).variability = Variability::Continuous;
        },
    ),
    case(
        "an input without start",
        Error,
        Rule::StartMissing,
        "velocity",
        |m| real(m, VELOCITY).start = None,
    ),
    case(
        "a parameter without start",
        Error,
        Rule::StartMissing,
        "gravity",
        |m| real(m, GRAVITY).start = None,
    ),
    case(
        "a constant without start",
        Error,
        Rule::StartMissing,
        "limit",
        |m| integer(m, LIMIT).start = None,
    ),
    case(
        "a guess without start",
        Error,
        Rule::StartMissing,
        "force",
        |m| {
            variable(m, FORCE).initial = Some(Initial::Approx);
        },
    ),
    case(
        "a calculated output with start",
        Error,
        Rule::StartForbidden,
        "force[1]`/@start",
        |m| {
            real(m, FORCE).start = Some(0.0);
        },
    ),
    case(
        "time with start",
        Error,
        Rule::StartForbidden,
        "time",
        |m| real(m, TIME).start = Some(0.0),
    ),
    case(
        "an infinite start",
        Warning,
        Rule::StartFinite,
        "velocity",
        |m| {
            real(m, VELOCITY).start = Some(f64::INFINITY);
        },
    ),
    case(
        "start below the minimum",
        Error,
        Rule::StartRange,
        "gravity",
        |m| real(m, GRAVITY).start = Some(-101.0),
    ),
    case(
        "start above the maximum",
        Error,
        Rule::StartRange,
        "gravity",
        |m| real(m, GRAVITY).start = Some(101.0),
    ),
    case(
        "an integer start above the maximum",
        Error,
        Rule::StartRange,
        "limit",
        |m| integer(m, LIMIT).max = Some(199),
    ),
    case(
        "a start that is no item",
        Error,
        Rule::StartRange,
        "preconditioner",
        |m| {
            items(m)[0].value = 3;
        },
    ),
    case("crossed bounds", Error, Rule::Range, "gravity", |m| {
        real(m, GRAVITY).min = Some(101.0)
    }),
    case("a bound NaN", Error, Rule::Range, "@max", |m| {
        real(m, GRAVITY).max = Some(f64::NAN)
    }),
    case("a negative nominal", Error, Rule::Nominal, "force", |m| {
        real(m, FORCE).nominal = Some(-1.0)
    }),
    case(
        "an unknown unit",
        Error,
        Rule::UnitDefined,
        "mass`/@unit",
        |m| real(m, MASS).unit = Some("g".into()),
    ),
    case(
        "an empty unit that is not defined",
        Error,
        Rule::UnitDefined,
        "mass`/@unit",
        |m| {
            real(m, MASS).unit = Some(String::new());
        },
    ),
    case(
        "an unknown display unit",
        Warning,
        Rule::DisplayUnitDefined,
        "force",
        |m| {
            real(m, FORCE).display_unit = Some("MN".into());
        },
    ),
    case(
        "a display unit without unit",
        Error,
        Rule::DisplayUnitDefined,
        "force",
        |m| real(m, FORCE).unit = None,
    ),
    case(
        "an unknown type",
        Error,
        Rule::DeclaredType,
        "mass`/@declaredType",
        |m| {
            real(m, MASS).declared_type = Some("Mass".into());
        },
    ),
    case(
        "a type of another base",
        Error,
        Rule::DeclaredType,
        "contactCount",
        |m| {
            integer(m, COUNT).declared_type = Some("Preconditioner".into());
        },
    ),
    case("two times", Error, Rule::Independent, "`clock`", |m| {
        add(
            m,
            ScalarVariable::new(
                "clock",
                9,
                Causality::Independent,
                Variability::Continuous,
                RealVariable::new(),
            ),
        );
    }),
];
