//! What both versions define for their variables: units and enumerations.

use std::collections::BTreeMap;

use sphere_dda_fmu::table::Enumeration;
use sphere_dda_model_description::units::{BaseUnit, Unit};

/// What the model is, in one line; a scene's own description comes first.
pub(super) const DESCRIPTION: &str = "Spheres and moving boundaries by discontinuous deformation analysis. Outputs change by \
                                      steps only, not by a set; directional derivatives are those of the last step.";

/// The enumerations among the variables, each once.
pub(super) fn choices(
    used: impl Iterator<Item = Option<&'static Enumeration>>,
) -> BTreeMap<&'static str, &'static Enumeration> {
    used.flatten()
        .map(|choices| (choices.name, choices))
        .collect()
}

/// The unit in which people read values of `unit`.
pub(super) fn display_unit(unit: &str) -> Option<&'static str> {
    match unit {
        "m" => Some("mm"),
        "rad" => Some("deg"),
        "rad/s" => Some("rpm"),
        "kg/s" => Some("t/h"),
        "Pa" => Some("kPa"),
        _ => None,
    }
}

/// Every unit of the table, with SI exponents and display units; those that parameters of a scene alone have if they are `used`.
pub(super) fn units<'u>(used: impl Iterator<Item = &'u str>) -> Vec<Unit> {
    const ONE: BaseUnit = BaseUnit::DIMENSIONLESS;
    let degrees = 180.0 / std::f64::consts::PI;
    let si = |name: &str, kg: i32, m: i32, s: i32| Unit::new(name, BaseUnit { kg, m, s, ..ONE });
    let mut units = vec![
        si("s", 0, 0, 1).with_display_unit("ms", 1e3, 0.0),
        si("m", 0, 1, 0).with_display_unit("mm", 1e3, 0.0),
        si("m/s", 0, 1, -1),
        si("m/s2", 0, 1, -2),
        Unit::new("rad", BaseUnit { rad: 1, ..ONE }).with_display_unit("deg", degrees, 0.0),
        Unit::new(
            "rad/s",
            BaseUnit {
                rad: 1,
                s: -1,
                ..ONE
            },
        )
        .with_display_unit("deg/s", degrees, 0.0)
        .with_display_unit("rpm", degrees / 6.0, 0.0),
        si("kg", 1, 0, 0),
        si("kg/s", 1, 0, -1).with_display_unit("t/h", 3.6, 0.0),
        si("kg.m/s", 1, 1, -1),
        si("kg.m2/s", 1, 2, -1),
        si("N", 1, 1, -2).with_display_unit("kN", 1e-3, 0.0),
        si("N.m", 1, 2, -2),
        si("J", 1, 2, -2),
        si("W", 1, 2, -3),
        si("Pa", 1, -1, -2).with_display_unit("kPa", 1e-3, 0.0),
    ];
    let used: Vec<&str> = used.collect();
    let damping = BaseUnit {
        kg: 1,
        m: 2,
        s: -1,
        rad: -1,
        ..ONE
    };
    let degree = BaseUnit {
        rad: 1,
        factor: degrees.recip(),
        ..ONE
    };
    let of_parameters = [
        si("1/s", 0, 0, -1),
        si("Hz", 0, 0, -1),
        si("N/m", 1, 0, -2),
        si("J/m2", 1, 0, -2),
        si("N.s/m", 1, 0, -1),
        Unit::new("N.m.s/rad", damping),
        Unit::new("deg", degree),
        si("kg.m2", 1, 2, 0),
        si("kg/m3", 1, -3, 0).with_display_unit("t/m3", 1e-3, 0.0),
        si("m2", 0, 2, 0),
        si("m3", 0, 3, 0),
        si("1/Pa", -1, 1, 2),
    ];
    units.extend(
        of_parameters
            .into_iter()
            .filter(|unit| used.contains(&&*unit.name)),
    );
    units
}
