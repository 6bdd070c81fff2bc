//! Quantities with a unit, `"8 mm"`, `"30 deg"`, `"1.2 t/h"`, as numbers in the unit of their key.
//!
//! ```text
//! quantity = number unit
//! unit     = product ( "/" product )*        product = atom ( ( " " | "*" ) atom )*        atom = name [ "^" n ]
//! ```
//!
//! A power of ten goes into the exponent of the number, so that `"0.3 mm"` has the bits of 0.0003.

use std::f64::consts::PI;

/// Exponents of metre, kilogram, second and radian.
type Dimension = [i32; 4];

/// A unit: `10^tens over / under` of the SI unit of its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Unit {
    dimension: Dimension,
    tens: i32,
    over: f64,
    under: f64,
}

/// Names, and what they are.
#[rustfmt::skip]
const NAMES: [(&str, Dimension, i32, f64, f64); 38] = [
    ("m", [1, 0, 0, 0], 0, 1.0, 1.0),
    ("dm", [1, 0, 0, 0], -1, 1.0, 1.0),
    ("cm", [1, 0, 0, 0], -2, 1.0, 1.0),
    ("mm", [1, 0, 0, 0], -3, 1.0, 1.0),
    ("um", [1, 0, 0, 0], -6, 1.0, 1.0),
    ("µm", [1, 0, 0, 0], -6, 1.0, 1.0),
    ("km", [1, 0, 0, 0], 3, 1.0, 1.0),
    ("in", [1, 0, 0, 0], -4, 254.0, 1.0),
    ("ft", [1, 0, 0, 0], -4, 3048.0, 1.0),
    ("kg", [0, 1, 0, 0], 0, 1.0, 1.0),
    ("g", [0, 1, 0, 0], -3, 1.0, 1.0),
    ("mg", [0, 1, 0, 0], -6, 1.0, 1.0),
    ("t", [0, 1, 0, 0], 3, 1.0, 1.0),
    ("s", [0, 0, 1, 0], 0, 1.0, 1.0),
    ("ms", [0, 0, 1, 0], -3, 1.0, 1.0),
    ("us", [0, 0, 1, 0], -6, 1.0, 1.0),
    ("min", [0, 0, 1, 0], 0, 60.0, 1.0),
    ("h", [0, 0, 1, 0], 0, 3600.0, 1.0),
    ("rad", [0, 0, 0, 1], 0, 1.0, 1.0),
    ("mrad", [0, 0, 0, 1], -3, 1.0, 1.0),
    ("deg", [0, 0, 0, 1], 0, PI, 180.0),
    ("°", [0, 0, 0, 1], 0, PI, 180.0),
    ("rev", [0, 0, 0, 1], 0, 2.0 * PI, 1.0),
    ("rpm", [0, 0, -1, 1], 0, 2.0 * PI, 60.0),
    ("Hz", [0, 0, -1, 0], 0, 1.0, 1.0),
    ("kHz", [0, 0, -1, 0], 3, 1.0, 1.0),
    ("N", [1, 1, -2, 0], 0, 1.0, 1.0),
    ("mN", [1, 1, -2, 0], -3, 1.0, 1.0),
    ("kN", [1, 1, -2, 0], 3, 1.0, 1.0),
    ("MN", [1, 1, -2, 0], 6, 1.0, 1.0),
    ("J", [2, 1, -2, 0], 0, 1.0, 1.0),
    ("mJ", [2, 1, -2, 0], -3, 1.0, 1.0),
    ("Pa", [-1, 1, -2, 0], 0, 1.0, 1.0),
    ("kPa", [-1, 1, -2, 0], 3, 1.0, 1.0),
    ("MPa", [-1, 1, -2, 0], 6, 1.0, 1.0),
    ("GPa", [-1, 1, -2, 0], 9, 1.0, 1.0),
    ("bar", [-1, 1, -2, 0], 5, 1.0, 1.0),
    ("1", [0, 0, 0, 0], 0, 1.0, 1.0),
];

/// Units of keys, what a quantity of each is called, and how one may be written.
const KINDS: [(&str, &str, &str); 21] = [
    ("m", "a length", "8 mm"),
    ("m^2", "an area", "20 cm^2"),
    ("kg", "a mass", "250 g"),
    ("s", "a time", "5 ms"),
    ("rad", "an angle", "30 deg"),
    ("deg", "an angle", "30 deg"),
    ("m/s", "a speed", "20 mm/s"),
    ("m/s^2", "an acceleration", "9.81 m/s^2"),
    ("rad/s", "an angular speed", "12 rpm"),
    ("Hz", "a frequency", "50 Hz"),
    ("1/s", "a rate", "30 1/min"),
    ("kg/s", "a mass flow", "1.2 t/h"),
    ("kg/m^3", "a density", "2.5 g/cm^3"),
    ("kg m^2", "a moment of inertia", "40 kg cm^2"),
    ("N", "a force", "2 kN"),
    ("N m", "a torque", "5 N m"),
    ("N/m", "a stiffness", "3 kN/m"),
    ("N s/m", "a damping", "20 N s/m"),
    ("Pa", "a pressure", "100 kPa"),
    ("J/m^2", "a surface energy", "50 mJ/m^2"),
    ("1/Pa", "a wear coefficient", "0.02 1/GPa"),
];

/// What a key in `unit` takes as text: `a length like "8 mm"`; `None`: numbers only.
pub(super) fn expected(unit: &str) -> Option<String> {
    let kind = KINDS.iter().find(|(own, ..)| *own == unit)?;
    Some(format!("{} like \"{}\"", kind.1, kind.2))
}

/// The number, as TOML, of a quantity for a key in `unit`; `None` if it is none of this kind.
pub(super) fn number(text: &str, unit: &str) -> Option<String> {
    expected(unit)?;
    let (number, typed) = split(text)?;
    let (own, key) = (parse(typed)?, parse(unit)?);
    if own.dimension != key.dimension {
        return None;
    }
    let (mantissa, exponent) = match number.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (number, 0),
    };
    let tens = exponent.checked_add(own.tens - key.tens)?;
    let value = format!("{mantissa}e{tens}").parse::<f64>().ok()?;
    // Equal factors leave the number alone.
    let value = value * (own.over / key.over) * (key.under / own.under);
    value.is_finite().then(|| format!("{value:?}"))
}

/// The factor of a unit of length to metres.
pub(super) fn metres(unit: &str) -> Option<f64> {
    number(&format!("1 {unit}"), "m")?.parse().ok()
}

/// The number and the unit.
fn split(text: &str) -> Option<(&str, &str)> {
    let text = text.trim();
    let digit = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+');
    let mut end = text.find(|c| !digit(c))?;
    // An exponent has digits behind its letter.
    if let Some(rest) = text[end..].strip_prefix(['e', 'E'])
        && rest.starts_with(|c: char| digit(c) && c != '.')
    {
        end += 1 + rest.find(|c| !digit(c))?;
    }
    let (number, unit) = text.split_at(end);
    number.parse::<f64>().ok()?;
    Some((number, unit.trim()))
}

fn parse(text: &str) -> Option<Unit> {
    let mut unit = Unit {
        dimension: [0; 4],
        tens: 0,
        over: 1.0,
        under: 1.0,
    };
    for (k, product) in text.split('/').enumerate() {
        let side = if k == 0 { 1 } else { -1 };
        let mut atoms = product.split([' ', '*']).filter(|atom| !atom.is_empty());
        let first = atoms.next()?;
        for atom in std::iter::once(first).chain(atoms) {
            let (name, power) = match atom.split_once('^') {
                Some((name, power)) => (name, power.parse::<i32>().ok()?),
                None => (atom, 1),
            };
            let known = NAMES.iter().find(|(own, ..)| *own == name)?;
            let power = side * Some(power).filter(|n| (1..=4).contains(n))?;
            for (sum, own) in unit.dimension.iter_mut().zip(known.1) {
                *sum += power * own;
            }
            unit.tens += power * known.2;
            let (over, under) = match power > 0 {
                true => (known.3, known.4),
                false => (known.4, known.3),
            };
            unit.over *= over.powi(power.abs());
            unit.under *= under.powi(power.abs());
        }
    }
    Some(unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_have_the_bits_of_their_numbers() {
        for (text, unit, value) in [
            ("8 mm", "m", 0.008),
            ("0.3mm", "m", 0.0003),
            ("7e-1 mm", "m", 0.0007),
            ("-2 cm", "m", -0.02),
            ("30 deg", "deg", 30.0),
            ("30 deg", "rad", 30.0 * (PI / 180.0)),
            ("180 deg", "rad", PI),
            ("1 rad", "deg", 180.0 / PI),
            ("1.2 t/h", "kg/s", 1.2e3 / 3600.0),
            ("2.5 g/cm^3", "kg/m^3", 2500.0),
            ("60 rpm", "rad/s", 2.0 * PI),
            ("30 1/min", "1/s", 0.5),
            ("50 Hz", "1/s", 50.0),
            ("5 N m", "N m", 5.0),
            ("3 kN/m", "N/m", 3000.0),
            ("1.5 MPa", "Pa", 1.5e6),
            ("20 kg cm^2", "kg m^2", 0.002),
            ("9.81 m/s^2", "m/s^2", 9.81),
            ("2 in", "m", 0.0508),
            ("1 kg/m/s^2", "Pa", 1.0),
        ] {
            let found: f64 = number(text, unit).expect(text).parse().unwrap();
            let close = (found - value).abs() <= 2.0 * f64::EPSILON * value.abs();
            let exact = !["rad", "deg", "rad/s", "kg/s"].contains(&unit) && !text.contains("in");
            assert!(
                close && (!exact || found == value),
                "{text}: {found:?} {value:?}"
            );
        }
        assert_eq!(metres("mm"), Some(0.001));
        assert_eq!(metres("kg"), None);
    }

    #[test]
    fn other_texts_are_none() {
        for (text, unit) in [
            ("3 kg", "m"),
            ("3", "m"),
            ("mm", "m"),
            ("3 foo", "m"),
            ("3 mm^0", "m"),
            ("3 mm^99999999999", "m"),
            ("3 m/", "m"),
            ("1e999999999999 m", "m"),
            ("1e400 m", "m"),
            ("nan m", "m"),
            ("--3 m", "m"),
            ("", "m"),
            ("3 m", "-"),
            ("3 deg", "1/s"),
            ("50 Hz", "rad/s"),
        ] {
            assert_eq!(number(text, unit), None, "{text} for {unit}");
        }
    }

    #[test]
    fn every_kind_is_a_unit_and_its_example_a_quantity_of_it() {
        for (unit, _, example) in KINDS {
            assert!(
                parse(unit).is_some() && number(example, unit).is_some(),
                "{unit}"
            );
        }
    }
}
