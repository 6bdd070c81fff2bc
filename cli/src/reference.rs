//! The reference of scene files: docs/scene.in.md with a table of keys in place of every `{{ Table }}`.

use std::collections::BTreeMap;

use serde_json::Value;

const TEMPLATE: &str = include_str!("../../docs/scene.in.md");

const GENERATED: &str = "<!-- Printed by `sphere-dda schema --markdown` from docs/scene.in.md and the types in src/scene_file/file: edit those. -->\n\n";

/// Fills the tables of `schema` into the template.
pub(crate) fn markdown(schema: &Value) -> String {
    let reference = Reference::new(schema);
    let mut text = GENERATED.to_owned();
    for line in TEMPLATE.lines() {
        match placeholder(line) {
            Some(name) => text.push_str(&reference.section(name)),
            None => text.push_str(line),
        }
        text.push('\n');
    }
    text
}

/// `Name` of a line `{{ Name }}`.
fn placeholder(line: &str) -> Option<&str> {
    Some(line.strip_prefix("{{")?.strip_suffix("}}")?.trim())
}

/// The types of the schema, and where the template describes them.
struct Reference<'s> {
    definitions: &'s Value,
    /// Link target of each type.
    anchors: BTreeMap<&'s str, String>,
}

impl<'s> Reference<'s> {
    fn new(schema: &'s Value) -> Self {
        let mut anchors = BTreeMap::new();
        let mut heading = "";
        for line in TEMPLATE.lines() {
            if line.starts_with('#') {
                heading = line.trim_start_matches('#').trim();
            }
            if let Some(name) = placeholder(line) {
                anchors.entry(name).or_insert_with(|| anchor(heading));
            }
        }
        Self {
            definitions: &schema["definitions"],
            anchors,
        }
    }

    /// What a type is, and its keys.
    fn section(&self, name: &str) -> String {
        let definition = &self.definitions[name];
        let description = definition["description"].as_str().unwrap_or_default();
        // Doc comments begin with the name of the table, the reference has it in the heading.
        let description = match description
            .strip_prefix('`')
            .and_then(|d| d.split_once('`'))
        {
            Some((_, rest)) => rest.trim_start_matches([':', '.']).trim_start(),
            None => description,
        };
        let mut text = capitalised(description);
        if !text.is_empty() {
            text.push_str("\n\n");
        }
        if definition["maxProperties"] == 1 {
            text.push_str("| key | type | unit | meaning |\n|---|---|---|---|");
            for key in keys(definition) {
                let property = &definition["properties"][key];
                let (unit, meaning) = meaning(property);
                let kind = self.kind(property);
                text.push_str(&format!("\n| `{key}` | {kind} | {unit} | {meaning} |"));
            }
        } else if let Some(options) = definition["oneOf"].as_array() {
            text.push_str("| value | meaning |\n|---|---|");
            for option in options {
                let meaning = option["description"].as_str().unwrap_or_default();
                text.push_str(&format!("\n| {} | {meaning} |", self.option(option)));
            }
        } else {
            text.push_str(
                "| key | type | unit | default | range | meaning |\n|---|---|---|---|---|---|",
            );
            for key in keys(definition) {
                text.push_str(&self.row(definition, key));
            }
        }
        text
    }

    fn row(&self, definition: &Value, key: &str) -> String {
        let property = &definition["properties"][key];
        let required = definition["required"].as_array();
        let default = if required.is_some_and(|keys| keys.iter().any(|k| k == key)) {
            "**required**".to_owned()
        } else if let Some(words) = property["x-default"].as_str() {
            words.to_owned()
        } else {
            match &property["default"] {
                Value::Null => String::new(),
                value => literal(value),
            }
        };
        let (unit, meaning) = meaning(property);
        format!(
            "\n| `{key}` | {} | {unit} | {default} | {} | {meaning} |",
            self.kind(property),
            range(property)
        )
    }

    /// One of several forms of a value, as it is written.
    fn option(&self, option: &Value) -> String {
        if let Some(word) = option["const"].as_str() {
            return format!("`\"{word}\"`");
        }
        let properties = option["properties"].as_object();
        let Some((key, inner)) = properties.and_then(|p| p.iter().next()) else {
            return self.kind(option);
        };
        format!("`{{ {key} = ... }}`: {}", self.kind(inner))
    }

    /// Type of a value, in words or as it is written.
    fn kind(&self, value: &Value) -> String {
        if let Some(name) = referred(value) {
            let options = self.definitions[name]["oneOf"].as_array();
            let words = options.map(|o| o.iter().map(|word| word["const"].as_str()).collect());
            let words: Option<Vec<&str>> = words.flatten();
            let (anchor, words) = (self.anchors.get(name), words.unwrap_or_default());
            return match (anchor, &words[..]) {
                (Some(anchor), []) => format!("[table](#{anchor})"),
                (Some(anchor), _) => format!("[word](#{anchor})"),
                (None, []) => "table".to_owned(),
                (None, words) => words
                    .iter()
                    .map(|word| format!("`\"{word}\"`"))
                    .collect::<Vec<_>>()
                    .join(", "),
            };
        }
        if let Some(options) = value["anyOf"].as_array() {
            let kinds: Vec<_> = options.iter().map(|o| self.kind(o)).collect();
            return kinds.join(" or ");
        }
        // Numbers in a unit may be texts as well, which the page says once.
        match value["type"].as_str().or(value["type"][0].as_str()) {
            Some("array") if value["minItems"] == 3 && value["maxItems"] == 3 => {
                let of = value["items"]["type"].as_str().unwrap_or_default();
                if of == "integer" {
                    "`[i, j, k]`".to_owned()
                } else {
                    "`[x, y, z]`".to_owned()
                }
            }
            Some("array") => format!("list of {}", plural(&self.kind(&value["items"]))),
            Some("boolean") => "`true`, `false`".to_owned(),
            Some(kind) => kind.to_owned(),
            None => String::new(),
        }
    }
}

/// The keys of a table in their order.
fn keys(definition: &Value) -> impl Iterator<Item = &str> {
    let keys = definition["x-order"].as_array().into_iter().flatten();
    keys.filter_map(Value::as_str)
}

/// Unit and meaning of a key.
fn meaning(property: &Value) -> (&str, String) {
    let unit = property["x-unit"].as_str().unwrap_or_default();
    let description = property["description"].as_str().unwrap_or_default();
    (unit, description.replacen(&format!(" [{unit}]"), "", 1))
}

/// Name of the type that a value refers to.
fn referred(value: &Value) -> Option<&str> {
    let reference = value["$ref"]
        .as_str()
        .or(value["allOf"][0]["$ref"].as_str())?;
    reference.strip_prefix("#/definitions/")
}

fn plural(kind: &str) -> String {
    match kind {
        "number" | "integer" | "string" | "table" => format!("{kind}s"),
        _ => kind
            .replacen("[table]", "[tables]", 1)
            .replacen("[word]", "[words]", 1),
    }
}

/// The limits of a number or of the length of a list.
fn range(property: &Value) -> String {
    let limits = [
        ("minimum", ">= "),
        ("exclusiveMinimum", "> "),
        ("maximum", "<= "),
        ("exclusiveMaximum", "< "),
    ];
    let mut found: Vec<String> = limits
        .iter()
        .filter(|(key, _)| property[key].is_number())
        .map(|(key, sign)| format!("{sign}{}", literal(&property[key]).trim_matches('`')))
        .collect();
    match (property["minItems"].as_u64(), property["maxItems"].as_u64()) {
        (Some(3), Some(3)) | (None, None) => {}
        (Some(low), Some(high)) if low == high => found.push(format!("{low} entries")),
        (Some(1), None) => found.push("not empty".to_owned()),
        (Some(low), Some(high)) => found.push(format!("{low} to {high} entries")),
        (Some(low), None) => found.push(format!("at least {low} entries")),
        (None, Some(high)) => found.push(format!("at most {high} entries")),
    }
    if property["pattern"].is_string() && property["type"] == "string" {
        found.push("letters, digits, `_`".to_owned());
    }
    found.join(", ")
}

/// A value as TOML, whole numbers without fraction.
fn literal(value: &Value) -> String {
    fn plain(value: &Value) -> String {
        match value {
            Value::Number(number) => match number.as_f64() {
                Some(x) if x != 0.0 && !(1e-3..1e6).contains(&x.abs()) => format!("{x:e}"),
                Some(x) => format!("{x}"),
                None => number.to_string(),
            },
            Value::Array(list) => {
                let entries: Vec<_> = list.iter().map(plain).collect();
                format!("[{}]", entries.join(", "))
            }
            other => other.to_string(),
        }
    }
    format!("`{}`", plain(value))
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// The link target that Markdown gives a heading.
fn anchor(heading: &str) -> String {
    let lower = heading.to_lowercase();
    let kept = lower
        .chars()
        .filter(|c| c.is_alphanumeric() || "-_ ".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}
