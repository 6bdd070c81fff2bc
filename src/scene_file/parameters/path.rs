//! Paths to a number of a scene file: `material.grain.density`, `pair[grain,glass].friction`, `simulation.gravity[3]`.
//!
//! Keys are joined by points. An element of a list goes by its name where it has one, as a key does, a pair by its two
//! materials in either order, any other entry by its number from 1, as the elements of FMU variables do.

use toml::Spanned;
use toml::de::DeValue;

use super::super::document::{Step, child, did_you_mean};
use super::super::wording::Place;

/// Coefficients of a contact, which a run takes between steps.
const CONTACT: [&str; 9] = [
    "friction",
    "friction_angle",
    "restitution",
    "rolling_friction",
    "twisting_friction",
    "wear",
    "cohesion",
    "surface_energy",
    "rupture_distance",
];

/// A number that a path leads to.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Target {
    /// The way to it.
    pub(super) steps: Vec<Step>,
    /// Unit of the key, `-` if it has none.
    pub(super) unit: String,
    /// Whether the key takes whole numbers only.
    pub(super) is_integer: bool,
    /// Whether a run takes another value between two steps.
    pub(super) is_tunable: bool,
    /// What stands there in the file.
    pub(super) value: Option<f64>,
}

/// A part of a path.
enum Part<'p> {
    /// `.name`.
    Key(&'p str),
    /// `[3]`, `[grain,glass]`.
    Entry(&'p str),
}

/// What is wrong with a path, and how to mend it.
type Wrong = (String, String);

/// Where a walk along a path stands.
struct Walk<'a, 't> {
    place: Place<'a>,
    value: Option<&'a Spanned<DeValue<'t>>>,
    steps: Vec<Step>,
    /// The way so far, as typed.
    typed: String,
}

/// The number that `path` leads to from the top level of a scene file.
pub(super) fn resolve(root: &Spanned<DeValue<'_>>, path: &str) -> Result<Target, Wrong> {
    let schema = super::super::schema::plain_schema();
    let mut walk = Walk {
        place: Place::top(&schema),
        value: Some(root),
        steps: Vec::new(),
        typed: String::new(),
    };
    for part in parts(path)? {
        match part {
            Part::Key(key) if walk.place.is_list() => walk.named(key)?,
            Part::Key(key) => walk.key(key)?,
            Part::Entry(entry) => walk.entry(entry)?,
        }
    }
    walk.end()
}

fn parts(path: &str) -> Result<Vec<Part<'_>>, Wrong> {
    let wrong = || {
        let help = "like `material.grain.friction`, `pair[grain,glass].friction` or `simulation.gravity[3]`";
        let message = format!("found `{path}`, expected keys joined by points");
        (message, help.to_owned())
    };
    let mut parts = Vec::new();
    for piece in path.split('.') {
        let (key, entries) = piece.split_at(piece.find('[').unwrap_or(piece.len()));
        if key.is_empty() {
            return Err(wrong());
        }
        parts.push(Part::Key(key.trim()));
        let Some(entries) = entries.strip_prefix('[') else {
            continue;
        };
        let entries = entries.strip_suffix(']').ok_or_else(wrong)?;
        parts.extend(entries.split("][").map(|entry| Part::Entry(entry.trim())));
    }
    Ok(parts)
}

impl<'a> Walk<'a, '_> {
    fn step(&mut self, step: Step, place: Place<'a>, typed: &str) {
        self.value = self.value.and_then(|value| child(value, &step));
        self.place = place;
        self.steps.push(step);
        self.typed.push_str(typed);
    }

    fn key(&mut self, key: &str) -> Result<(), Wrong> {
        let Some(place) = self.place.below(&Step::Key(key.to_owned())) else {
            let known = self.place.keys_of_all();
            let of = match &*self.typed {
                "" => "a scene".to_owned(),
                typed => format!("`{typed}`"),
            };
            return Err(match known.is_empty() {
                true => (
                    format!("found `{key}` below {of}, which has no keys"),
                    String::new(),
                ),
                false => (
                    format!("unknown key `{key}` of {of}"),
                    format!(
                        "{}known: {}",
                        did_you_mean(key, known.iter().copied()),
                        known.join(", ")
                    ),
                ),
            });
        };
        let point = if self.typed.is_empty() { "" } else { "." };
        self.step(Step::Key(key.to_owned()), place, &format!("{point}{key}"));
        Ok(())
    }

    /// The entries of the list that the walk stands at.
    fn entries(&self) -> usize {
        let list = self.value.and_then(|value| value.get_ref().as_array());
        list.map_or(0, |list| list.len())
    }

    /// Text at `key` of the entry `index`.
    fn text(&self, index: usize, key: &str) -> Option<&'a str> {
        let entry = child(self.value?, &Step::Index(index))?;
        child(entry, &Step::Key(key.to_owned()))?.get_ref().as_str()
    }

    fn named(&mut self, name: &str) -> Result<(), Wrong> {
        let list = self.typed.clone();
        let index = Step::Index(0);
        let inner = self.place.below(&index);
        let Some(inner) =
            inner.filter(|inner| inner.below(&Step::Key("name".to_owned())).is_some())
        else {
            let help = format!("number them from 1: `{list}[1]`");
            return Err((
                format!("found `{list}.{name}`, but entries of `{list}` have no names"),
                help,
            ));
        };
        let names: Vec<&str> = (0..self.entries())
            .filter_map(|k| self.text(k, "name"))
            .collect();
        let Some(k) = (0..self.entries()).find(|&k| self.text(k, "name") == Some(name)) else {
            let known = match names.is_empty() {
                true => "none".to_owned(),
                false => names.join(", "),
            };
            let help = format!(
                "{}known: {known}",
                did_you_mean(name, names.iter().copied())
            );
            return Err((format!("unknown {list} `{name}`"), help));
        };
        self.step(Step::Index(k), inner, &format!(".{name}"));
        Ok(())
    }

    fn entry(&mut self, entry: &str) -> Result<(), Wrong> {
        let list = self.typed.clone();
        let Some(inner) = self.place.below(&Step::Index(0)) else {
            return Err((
                format!("found `[{entry}]` after `{list}`, which is no list"),
                String::new(),
            ));
        };
        let n = self.entries();
        let index = match entry.split_once(',') {
            Some((a, b)) => self.pair(a.trim(), b.trim())?,
            None => match entry.parse::<usize>() {
                Ok(k) if (1..=n).contains(&k) => k - 1,
                Ok(k) => {
                    let expected = match n {
                        0 => format!("found `[{k}]`, but the scene has no `{list}`"),
                        n => format!(
                            "found `[{k}]`, expected a number from 1 to {n}, which `{list}` has"
                        ),
                    };
                    return Err((
                        expected,
                        "a parameter can set an entry that the scene has".to_owned(),
                    ));
                }
                Err(_) if self.place.is_list() => return self.named(entry),
                Err(_) => {
                    return Err((
                        format!("found `[{entry}]`, expected the number of an entry, from 1"),
                        String::new(),
                    ));
                }
            },
        };
        self.step(Step::Index(index), inner, &format!("[{entry}]"));
        Ok(())
    }

    /// The `[[pair]]` of two materials, in either order.
    fn pair(&self, a: &str, b: &str) -> Result<usize, Wrong> {
        let materials = |k: usize| -> Vec<&str> {
            let entry = self.value.and_then(|list| child(list, &Step::Index(k)));
            let listed = entry.and_then(|entry| child(entry, &Step::Key("materials".into())));
            let listed = listed.and_then(|list| list.get_ref().as_array());
            let listed = listed.into_iter().flat_map(|list| list.iter());
            listed.filter_map(|name| name.get_ref().as_str()).collect()
        };
        let found = (0..self.entries()).find(|&k| {
            let given = materials(k);
            given == [a, b] || given == [b, a]
        });
        found.ok_or_else(|| {
            let known = (0..self.entries()).map(materials);
            let known: Vec<String> = known.map(|m| format!("[{}]", m.join(","))).collect();
            let known = match known.is_empty() {
                true => "none".to_owned(),
                false => known.join(", "),
            };
            (
                format!("found no {} of `{a}` and `{b}`", self.typed),
                format!("known: {known}"),
            )
        })
    }

    fn end(self) -> Result<Target, Wrong> {
        let typed = &self.typed;
        let value = self.value.map(Spanned::get_ref);
        if let Some(list) = value.and_then(DeValue::as_array) {
            let message = format!("`{typed}` is a list of {}, expected one number", list.len());
            return Err((message, format!("name an entry, from `{typed}[1]` on")));
        }
        let kinds = self.place.kinds();
        if !kinds
            .iter()
            .any(|kind| ["number", "integer"].contains(kind))
        {
            let numbers = self.place.number_keys();
            let help = match numbers.is_empty() {
                true => String::new(),
                false => format!("numbers below it: {}", numbers.join(", ")),
            };
            return Err((
                format!("`{typed}` is no number, expected the path of one"),
                help,
            ));
        }
        Ok(Target {
            is_integer: !kinds.contains(&"number"),
            is_tunable: is_tunable(&self.steps),
            unit: self.place.unit().unwrap_or("-").to_owned(),
            value: value.and_then(number),
            steps: self.steps,
        })
    }
}

/// A number as typed.
pub(super) fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(text) => text.as_str().parse().ok(),
        DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix())
            .ok()
            .map(|whole| whole as f64),
        _ => None,
    }
}

/// Whether [`crate::scene::Scene::tuned`] takes what the path leads to.
fn is_tunable(steps: &[Step]) -> bool {
    let keys = steps.iter().filter_map(|step| match step {
        Step::Key(key) => Some(key.as_str()),
        Step::Index(_) => None,
    });
    match keys.collect::<Vec<_>>()[..] {
        ["material" | "pair" | "pair_default", key] => CONTACT.contains(&key),
        ["simulation", "gravity"] | ["load", "force"] => true,
        ["source", "rate" | "mass_rate" | "velocity" | "spin"] => true,
        [
            "boundary",
            "body",
            "force" | "torque" | "damping" | "angular_damping",
        ] => true,
        ["boundary", "body", "servo", "pressure"] => true,
        _ => false,
    }
}
