//! The JSON schema of scene files, for editors and for the reference.
//!
//! It comes from the types of [`super::file`]: keys, types, which are required and defaults from serde; meanings from the
//! doc comments; ranges from attributes. Draft 7, which TOML editors (Taplo) read. Keys that are not of the draft:
//!
//! | key | of | holds |
//! |---|---|---|
//! | `x-unit` | a key that holds numbers | SI unit, from the brackets in its doc comment |
//! | `x-default` | a key without a constant default | what happens without it, in words |
//! | `x-order` | a table | its keys in the order of the type |

use schemars::generate::SchemaSettings;
use serde_json::{Map, Value};

use super::file;
use super::keys::keys_of;
use super::units;

/// A number and a unit.
const QUANTITY: &str = "^ *[-+]?[0-9.]+([eE][-+]?[0-9]+)? *(1/)?[A-Za-z°µ]";

/// Keywords of a range of numbers.
const RANGE: [&str; 4] = ["minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum"];

/// The JSON schema (draft 7) of a scene file.
#[must_use]
pub fn json_schema() -> Value {
    let mut schema = plain_schema();
    allow_quantities(&mut schema, false);
    schema
}

/// Numbers in a unit may be written as a text with a unit.
fn allow_quantities(value: &mut Value, within: bool) {
    match value {
        Value::Array(list) => list.iter_mut().for_each(|v| allow_quantities(v, within)),
        Value::Object(object) => {
            let text = object.get("description").and_then(Value::as_str);
            let on_hinge = text.is_some_and(|text| text.contains("of a hinge"));
            let unit = object.get("x-unit").and_then(Value::as_str);
            let within = match unit {
                Some(unit) => units::expected(unit).is_some() && !on_hinge,
                None => within && !object.contains_key("properties"),
            };
            if within && object.get("type").is_some_and(|kind| kind == "number") {
                object.insert("type".into(), vec!["number", "string"].into());
                object.insert("pattern".into(), QUANTITY.into());
            }
            for value in object.values_mut() {
                allow_quantities(value, within);
            }
        }
        _ => {}
    }
}

/// The same with all quantities as numbers.
pub(super) fn plain_schema() -> Value {
    let generator = SchemaSettings::draft07().into_generator();
    let mut schema = generator
        .into_root_schema_for::<file::TopLevel>()
        .to_value();
    simplify(&mut schema);
    if let Some(definitions) = schema["definitions"].as_object_mut() {
        definitions.values_mut().for_each(join_choice);
    }
    schema["title"] = "sphere-dda scene".into();
    order(&mut schema);
    schema
}

/// Takes out what TOML does not have (null) and what restates a type (format), and makes units and ranges explicit.
fn simplify(value: &mut Value) {
    match value {
        Value::Array(list) => list.iter_mut().for_each(simplify),
        Value::Object(object) => {
            object.remove("format");
            // The defaults of a table are those of its keys.
            let default = object.get("default");
            if default.is_some_and(|d| d.is_null() || d.is_object()) {
                object.remove("default");
            }
            if let Some(Value::Array(types)) = object.get("type") {
                let real = types.iter().find(|t| *t != "null").cloned();
                object.insert("type".into(), real.unwrap_or_default());
            }
            if let Some(Value::Array(mut options)) = object.remove("anyOf") {
                options.retain(|o| o.get("type").is_none_or(|t| t != "null"));
                match &options[..] {
                    // `$ref` may not have neighbours in draft 7, so `allOf` holds it.
                    [only] if only.get("$ref").is_some() => {
                        object.insert("allOf".into(), options.into());
                    }
                    [Value::Object(only)] => {
                        for (key, value) in only {
                            object.entry(key).or_insert_with(|| value.clone());
                        }
                    }
                    _ => {
                        object.insert("anyOf".into(), options.into());
                    }
                }
            }
            if let Some(Value::String(text)) = object.get_mut("description") {
                *text = text
                    .replace("\\[", "[")
                    .replace("\\]", "]")
                    .replace('\n', " ");
            }
            for (key, value) in object.iter_mut() {
                match value {
                    // Names of keys, which may be those of keywords.
                    Value::Object(own) if key == "properties" => {
                        own.values_mut().for_each(simplify);
                    }
                    value => simplify(value),
                }
            }
            if let Some(Value::Object(properties)) = object.get_mut("properties") {
                for property in properties.values_mut().filter_map(Value::as_object_mut) {
                    spread_range(property);
                    name_unit(property);
                }
            }
        }
        _ => {}
    }
}

/// A choice of tables with one key each becomes one table of which one key is given: an editor then names the key that
/// is wrong instead of refusing the whole table.
fn join_choice(definition: &mut Value) {
    let Some(options) = definition["oneOf"].as_array() else {
        return;
    };
    let mut keys = Vec::new();
    let mut properties = Map::new();
    for option in options {
        let Some((key, inner)) = option["properties"]
            .as_object()
            .and_then(|p| p.iter().next())
        else {
            return;
        };
        let mut property = match inner.get("$ref") {
            Some(_) => Map::from_iter([("allOf".to_owned(), vec![inner.clone()].into())]),
            None => inner.as_object().cloned().unwrap_or_default(),
        };
        property.insert("description".into(), option["description"].clone());
        name_unit(&mut property);
        keys.push(key.clone());
        properties.insert(key.clone(), property.into());
    }
    let description = definition["description"].take();
    *definition = serde_json::json!({
        "description": description,
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
        "minProperties": 1,
        "maxProperties": 1,
        "x-order": keys,
    });
}

/// A range given for a key holds for every number of a list as well.
fn spread_range(property: &mut Map<String, Value>) {
    let range: Vec<_> = RANGE
        .iter()
        .filter_map(|key| Some(((*key).to_owned(), property.get(*key)?.clone())))
        .collect();
    let is_number = property
        .get("type")
        .is_some_and(|t| t == "number" || t == "integer");
    if is_number || range.is_empty() {
        return;
    }
    let items = property.entry("items").or_insert_with(|| Map::new().into());
    if let Value::Object(items) = items {
        items.extend(range);
    }
}

/// `[m]` in the description of numbers is their unit.
fn name_unit(property: &mut Map<String, Value>) {
    let description = property.get("description").and_then(Value::as_str);
    let unit = description
        .and_then(|text| text.split_once('['))
        .and_then(|(_, rest)| rest.split_once(']'))
        .map(|(unit, _)| unit.to_owned());
    if let Some(unit) = unit.filter(|_| holds_numbers(property)) {
        property.insert("x-unit".into(), unit.into());
    }
}

fn holds_numbers(schema: &Map<String, Value>) -> bool {
    let below = |v: &Value| v.as_object().is_some_and(holds_numbers);
    match schema.get("type").and_then(Value::as_str) {
        Some("number" | "integer") => true,
        Some("array") => schema.get("items").is_some_and(below),
        _ => {
            let options = schema.get("anyOf").and_then(Value::as_array);
            options.is_some_and(|options| options.iter().any(below))
        }
    }
}

/// Notes the order of the keys, which JSON objects do not keep.
fn order(schema: &mut Value) {
    macro_rules! tables {
        ($($table:ident)*) => { [$((stringify!($table), keys_of::<file::$table>())),*] };
    }
    let tables = tables! {
        Simulation Turning GravityTable RotatingFrame Cell Tolerance Material PairDefault Pair BondStrengths Load Spring Output Exposed
        Clump Member Spheres Lattice Uniform Normal LogNormal MassTable Packing Source Sink
        Boundary Body Limits JointSpring Servo Plane Rectangle Cuboid Cone Cylinder Stl Terrain Constant Sinusoid Table
        Tube Sensor Probe Parameter
    };
    schema["x-order"] = keys_of::<file::TopLevel>().into();
    for (table, keys) in tables {
        if let Some(definition) = schema["definitions"].get_mut(table) {
            definition["x-order"] = keys.into();
        }
    }
}
