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
    case(
        "derivative of nothing",
        Error,
        Rule::Derivative,
        "force[1]`/@derivative",
        |m| real(m, FORCE).derivative = Some(11),
    ),
    case(
        "derivative by index 0",
        Error,
        Rule::Derivative,
        "force",
        |m| real(m, FORCE).derivative = Some(0),
    ),
    case(
        "derivative of itself",
        Error,
        Rule::Derivative,
        "force",
        |m| real(m, FORCE).derivative = Some(3),
    ),
    case(
        "derivative of an integer",
        Error,
        Rule::Derivative,
        "force",
        |m| real(m, FORCE).derivative = Some(4),
    ),
    case(
        "reinit without model exchange",
        Error,
        Rule::ModelExchangeOnly,
        "@reinit",
        |m| real(m, FORCE).reinit = Some(false),
    ),
    case(
        "multiple set without model exchange",
        Error,
        Rule::ModelExchangeOnly,
        "@canHandleMultipleSet",
        |m| {
            variable(m, VELOCITY).can_handle_multiple_set_per_time_instant = Some(true);
        },
    ),
    // Aliases.
    case(
        "an input that is a parameter",
        Error,
        Rule::AliasStart,
        "ScalarVariable 11 `v`",
        |m| {
            add(
                m,
                ScalarVariable::new(
                    "v",
                    1,
                    Causality::Input,
                    Variability::Continuous,
                    RealVariable::with_unit("m/s").with_start(0.0),
                ),
            );
        },
    ),
    case(
        "an input that is time",
        Error,
        Rule::AliasStart,
        "`t`",
        |m| {
            add(
                m,
                ScalarVariable::new(
                    "t",
                    0,
                    Causality::Input,
                    Variability::Continuous,
                    RealVariable::with_unit("s").with_start(0.0),
                ),
            );
        },
    ),
    case(
        "a constant that moves",
        Error,
        Rule::AliasConstant,
        "`n`",
        |m| {
            add(
                m,
                ScalarVariable::new(
                    "n",
                    2,
                    Causality::Local,
                    Variability::Discrete,
                    IntegerVariable::new(),
                ),
            );
        },
    ),
    case(
        "a constant of two values",
        Error,
        Rule::AliasConstant,
        "`n`",
        |m| {
            add(
                m,
                ScalarVariable::new(
                    "n",
                    2,
                    Causality::Local,
                    Variability::Constant,
                    IntegerVariable::new().with_start(201),
                ),
            );
        },
    ),
    case(
        "an alias in another unit",
        Error,
        Rule::AliasUnit,
        "`f`",
        |m| add(m, local("f", 2, RealVariable::with_unit("kg"))),
    ),
    case(
        "an alias without unit",
        Warning,
        Rule::AliasUnit,
        "`f`",
        |m| add(m, local("f", 2, RealVariable::new())),
    ),
];
