//! Wrong types in the words of the scene file: what was found, as typed, and what the key takes, from the JSON schema.

use std::fmt::Write as _;

use serde_json::Value;
use toml::de::DeValue;

use super::document::Step;
use super::schema::plain_schema;
use super::units;

/// Longest text of a value that is quoted in a message \[characters\].
const LONGEST: usize = 40;

/// `found "1 ms", expected a number (in s)` for the value at the steps of a key path; `None` if the schema does not know it.
pub(super) fn mismatch(steps: &[Step], found: &DeValue<'_>) -> Option<String> {
    let root = plain_schema();
    let mut place = Place::top(&root);
    for step in steps {
        place = place.below(step)?;
    }
    let text = matches!(found, DeValue::String(_));
    let quantity = place.quantity().filter(|_| text).and_then(units::expected);
    let expected = match (named_option(&place, found), quantity) {
        (Some(expected), _) => expected,
        (None, Some(quantity)) => format!("{quantity}, or {}", place.form()),
        (None, None) => place.form(),
    };
    Some(format!("found {}, expected {expected}", typed(found)))
}

/// A value as a person would call it.
fn typed(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) if text.chars().count() > LONGEST => "a long string".to_owned(),
        DeValue::String(text) => format!("\"{text}\""),
        DeValue::Integer(number) => number.to_string(),
        DeValue::Float(number) => number.to_string(),
        DeValue::Boolean(truth) => truth.to_string(),
        DeValue::Datetime(date) => format!("the date {date}"),
        DeValue::Array(list) => match list.len() {
            0 => "an empty list".to_owned(),
            1 => "a list of 1 entry".to_owned(),
            n => format!("a list of {n} entries"),
        },
        DeValue::Table(table) => {
            let keys: Vec<&str> = table.keys().map(|key| &**key.get_ref()).collect();
            match &keys[..] {
                [] => "an empty table".to_owned(),
                [key] => format!("a table with the key `{key}`"),
                keys => format!("a table with the keys `{}`", keys.join("`, `")),
            }
        }
    }
}

/// What to write where a choice was named without its value, or with one that it does not take.
fn named_option(place: &Place<'_>, found: &DeValue<'_>) -> Option<String> {
    match found {
        DeValue::String(name) => {
            let value = place.below(&Step::Key(name.clone().into_owned()))?;
            Some(format!("`{{ {name} = {} }}`", value.example()))
        }
        DeValue::Table(table) => {
            let named = |key: &&str| place.words().iter().any(|word| word == key);
            let mut keys = table.keys().map(|key| &**key.get_ref());
            keys.find(named).map(|key| format!("`\"{key}\"` alone"))
        }
        _ => None,
    }
}

/// A place in the schema.
#[derive(Clone, Copy)]
pub(super) struct Place<'s> {
    root: &'s Value,
    node: &'s Value,
    /// Unit of the numbers in it.
    unit: Option<&'s str>,
}

impl<'s> Place<'s> {
    /// The top level of the schema `root`.
    pub(super) fn top(root: &'s Value) -> Self {
        Self {
            root,
            node: root,
            unit: None,
        }
    }

    /// Unit of the numbers in it.
    pub(super) fn unit(self) -> Option<&'s str> {
        self.unit
    }

    /// The unit of the numbers in it, unless they have another one on a hinge than on a slide.
    pub(super) fn quantity(self) -> Option<&'s str> {
        let numbers = self.kinds().contains(&"number");
        let text = self.node["description"].as_str().unwrap_or_default();
        self.unit
            .filter(|_| numbers && !text.contains("of a hinge"))
    }

    /// The types of what may stand here.
    pub(super) fn kinds(self) -> Vec<&'s str> {
        self.options().into_iter().map(Self::kind).collect()
    }

    /// Whether tables stand here, one after the other.
    pub(super) fn is_list(self) -> bool {
        let entry = self.below(&Step::Index(0));
        entry.is_some_and(|entry| entry.kinds().contains(&"object"))
    }

    /// The keys that may stand here, in whatever form.
    pub(super) fn keys_of_all(self) -> Vec<&'s str> {
        self.options().into_iter().flat_map(Self::keys).collect()
    }

    /// Those of them that hold a number.
    pub(super) fn number_keys(self) -> Vec<&'s str> {
        let mut keys = self.keys_of_all();
        keys.retain(|key| {
            let place = self.below(&Step::Key((*key).to_owned()));
            let kinds = place.map_or(Vec::new(), Self::kinds);
            kinds.contains(&"number") || kinds.contains(&"integer")
        });
        keys
    }

    fn at(self, node: &'s Value) -> Self {
        let unit = node["x-unit"].as_str().or(self.unit);
        let target = node["$ref"].as_str().or(node["allOf"][0]["$ref"].as_str());
        let defined = target
            .and_then(|target| target.strip_prefix("#/definitions/"))
            .and_then(|name| self.root["definitions"].get(name));
        Self {
            unit,
            node: defined.unwrap_or(node),
            ..self
        }
    }

    /// The forms that may stand here.
    fn options(self) -> Vec<Self> {
        let several = self.node["oneOf"]
            .as_array()
            .or(self.node["anyOf"].as_array());
        match several {
            Some(list) => list.iter().flat_map(|n| self.at(n).options()).collect(),
            None => vec![self],
        }
    }

    /// The place one step below.
    pub(super) fn below(self, step: &Step) -> Option<Self> {
        self.options().into_iter().find_map(|option| {
            let next = match step {
                Step::Key(key) => option.node["properties"].get(key)?,
                Step::Index(_) => option.node.get("items")?,
            };
            Some(option.at(next))
        })
    }

    fn kind(self) -> &'s str {
        self.node["type"].as_str().unwrap_or_default()
    }

    /// The words that may stand here, without quotes.
    fn words(self) -> Vec<&'s str> {
        let words = self.options().into_iter().flat_map(|option| {
            let listed = option.node["enum"].as_array().into_iter().flatten();
            listed
                .chain(option.node.get("const"))
                .filter_map(Value::as_str)
        });
        words.collect()
    }

    /// What may stand here, in words.
    fn form(self) -> String {
        let words: Vec<String> = self.words().iter().map(|w| format!("\"{w}\"")).collect();
        let mut forms = Vec::new();
        if !words.is_empty() {
            forms.push(words.join(", "));
        }
        for option in self.options() {
            let form = option.own_form();
            if !form.is_empty() && !forms.contains(&form) {
                forms.push(form);
            }
        }
        forms.join(", or ")
    }

    fn own_form(self) -> String {
        let unit = match self.unit {
            Some(unit) if unit != "-" => format!(" (in {unit})"),
            _ => String::new(),
        };
        match self.kind() {
            "number" => format!("a number{}{unit}", self.range()),
            "integer" => format!("a whole number{}{unit}", self.range()),
            "boolean" => "true or false".to_owned(),
            "string" if self.node.get("enum").or(self.node.get("const")).is_some() => String::new(),
            "string" => "a string in quotes".to_owned(),
            "array" => match self.node["minItems"] == 3 && self.node["maxItems"] == 3 {
                true if self.node["items"]["type"] == "integer" => {
                    "three whole numbers [x, y, z]".to_owned()
                }
                true => format!("three numbers [x, y, z]{unit}"),
                false => format!("a list `[{}, ...]`{unit}", self.entry()),
            },
            "object" if self.node["maxProperties"] == 1 || self.keys().len() == 1 => {
                let keys = self.keys();
                let one = if keys.len() == 1 {
                    "the key"
                } else {
                    "one of the keys"
                };
                format!("a table with {one} `{}`", keys.join("`, `"))
            }
            "object" => format!("a table `{}`", self.example()),
            _ => String::new(),
        }
    }

    fn entry(self) -> String {
        self.node
            .get("items")
            .map_or("...".to_owned(), |items| self.at(items).example())
    }

    fn range(self) -> String {
        let mut text = String::new();
        let bounds = [
            ("minimum", ">="),
            ("exclusiveMinimum", ">"),
            ("maximum", "<="),
            ("exclusiveMaximum", "<"),
        ];
        for (key, sign) in bounds {
            if let Some(bound) = self.node[key].as_f64() {
                let and = if text.is_empty() { " " } else { " and " };
                // Writing to a string cannot fail.
                let _ = write!(text, "{and}{sign} {bound}");
            }
        }
        text
    }

    fn keys(self) -> Vec<&'s str> {
        let order = self.node["x-order"].as_array();
        match (order, self.node["properties"].as_object()) {
            (Some(order), _) => order.iter().filter_map(Value::as_str).collect(),
            (None, Some(properties)) => properties.keys().map(String::as_str).collect(),
            (None, None) => Vec::new(),
        }
    }

    /// How a value here is written.
    fn example(self) -> String {
        let Some(option) = self.options().into_iter().next() else {
            return "...".to_owned();
        };
        match option.kind() {
            "number" => "0.1".to_owned(),
            "integer" => "1".to_owned(),
            "boolean" => "true".to_owned(),
            "string" => match option.words().first() {
                Some(word) => format!("\"{word}\""),
                None => "\"...\"".to_owned(),
            },
            "array" if option.node["minItems"] == 3 => "[x, y, z]".to_owned(),
            "array" => format!("[{}, ...]", option.entry()),
            "object" => {
                let needed = option.node["required"].as_array().into_iter().flatten();
                let needed: Vec<&str> = needed.filter_map(Value::as_str).collect();
                let all = option.keys();
                let keys = match needed.is_empty() {
                    true => all.first().copied().into_iter().collect(),
                    false => needed,
                };
                let keys: Vec<String> = keys.iter().map(|key| format!("{key} = ...")).collect();
                format!("{{ {} }}", keys.join(", "))
            }
            _ => "...".to_owned(),
        }
    }
}
