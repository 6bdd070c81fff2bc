//! One table behind both versions: what FMI 2.0 has is the elements of what FMI 3.0 has.

use sphere_dda_fmu::table::{Binding, Parameters, Table, Variable};
use sphere_dda_fmu::version::Version;
use sphere_dda_model_description::names::is_c_identifier;
use sphere_dda_model_description::value::Value;

use crate::box_scene;

fn row<'t>(table: &'t Table, name: &str) -> &'t Variable {
    let found = table.variables().iter().find(|v| v.name == name);
    found.unwrap_or_else(|| panic!("no variable `{name}`"))
}

#[test]
fn elements_of_a_vector_are_scalars_with_an_index_and_a_letter() {
    let table = box_scene().model.table;
    assert_eq!(row(&table, "gravity").dims, [3]);
    let scalars = table.entries(Version::Two);
    let told: Vec<String> = scalars
        .iter()
        .filter(|entry| entry.variable.name == "gravity")
        .map(|entry| format!("{}: {}", entry.name(), entry.description()))
        .collect();
    let text = "Gravity, may change between steps";
    let expected = [("1", "x"), ("2", "y"), ("3", "z")];
    assert_eq!(
        told,
        expected.map(|(k, letter)| format!("gravity[{k}]: {text}; {letter}"))
    );
    // Start values go with their elements.
    let down = scalars.iter().find(|entry| entry.name() == "gravity[3]");
    assert_eq!(down.unwrap().start(), [Value::Real(-9.81)]);
    assert_eq!(scalars.iter().filter(|e| e.name() == "mass").count(), 1);
    assert!(!scalars.iter().any(|e| e.name().starts_with("spheres.")));
}

#[test]
fn arrays_over_boundaries_hold_the_outputs_of_each() {
    let model = box_scene().model;
    let (table, boundaries) = (&model.table, &model.scene.boundaries);
    for (field, width) in [("force", 3), ("orientation", 4), ("contactCount", 1)] {
        let whole = row(table, &format!("boundaries.{field}"));
        assert_eq!(whole.dims[0], boundaries.len());
        assert_eq!(whole.count(), width * boundaries.len());
        for (b, boundary) in boundaries.iter().enumerate() {
            let own = row(table, &format!("boundary.{}.{field}", boundary.name));
            for k in 0..width {
                assert_eq!(whole.rank(width * b + k), own.rank(k), "{field} {b} {k}");
                assert!(own.rank(k).is_some());
            }
        }
    }
}

/// Tools make items of C or Modelica of them.
#[test]
fn names_of_enumerations_and_their_items_are_identifiers() {
    let table = box_scene().model.table;
    let choices = table.variables().iter().filter_map(|v| v.choices);
    let names = choices.flat_map(|c| c.items.iter().map(|item| item.0).chain([c.name]));
    let names: Vec<&str> = names.collect();
    assert_eq!(names.len(), 4);
    for name in names {
        assert!(is_c_identifier(name), "{name}");
        // Keywords of both languages are lower case.
        assert!(name.starts_with(char::is_uppercase), "{name}");
    }
}

/// A getter, a setter and a place of its own for every parameter.
#[test]
fn a_parameter_reads_back_what_was_set_and_leaves_the_others() {
    let model = box_scene().model;
    let elements: Vec<(usize, usize, &Variable)> = model
        .table
        .variables()
        .iter()
        .filter_map(|variable| match variable.binding {
            Binding::Parameter(rank) => Some((rank, variable)),
            _ => None,
        })
        .flat_map(|(rank, v)| (0..v.count()).map(move |k| (rank, k, v)))
        .collect();
    assert_eq!(elements.len(), 12);
    let scene = Parameters::of(&model.scene);
    for &(rank, k, variable) in &elements {
        let value = match &variable.start[k] {
            Value::Real(start) => Value::Real(if *start == 0.0625 { 0.03125 } else { 0.0625 }),
            Value::Integer(start) => Value::Integer(start + 1),
            Value::Boolean(start) => Value::Boolean(!start),
            _ => Value::String("elsewhere".to_owned()),
        };
        let mut set = scene.clone();
        set.set(rank, k, value.clone());
        for &(other, j, _) in &elements {
            let expected = match (other, j) == (rank, k) {
                true => value.clone(),
                false => scene.get(other, j),
            };
            assert_eq!(set.get(other, j), expected, "{}[{k}]", variable.name);
        }
    }
}
