//! One table behind both versions: what FMI 2.0 has is the elements of what FMI 3.0 has.

use sphere_dda_fmu::model::Model;
use sphere_dda_fmu::table::{Binding, Parameters, Table, Variable};
use sphere_dda_fmu::version::Version;
use sphere_dda_model_description::fmi2::Causality;
use sphere_dda_model_description::names::is_c_identifier;
use sphere_dda_model_description::value::Value;

use crate::{BOX, box_scene};

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

/// Outputs of the scene with `more` at its end, whole vectors.
fn outputs(more: &str) -> Result<Vec<String>, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, format!("{BOX}{more}")).unwrap();
    let model = Model::read(&path, None).map_err(|error| error.to_string())?;
    let rows = model.table.variables().iter();
    let outputs = rows.filter(|row| row.causality == Causality::Output);
    Ok(outputs.map(|row| row.name.clone()).collect())
}

#[test]
fn what_a_scene_asks_for_is_an_output() {
    let fixed = "[[boundary]]\nname = 'bin'\nmaterial = 'stone'\n\
                 faces = [{ plane = { point = [0.3, 0.0, 0.0], normal = [-1.0, 0.0, 0.0] } }]\n";
    let of = |owner: &str, fields: &[&str]| -> Vec<String> {
        fields
            .iter()
            .map(|field| format!("{owner}.{field}"))
            .collect()
    };
    let moving = ["averageForce", "averageTorque", "position", "orientation"];
    let inside = [
        "mass",
        "count",
        "solidFraction",
        "centreOfMass",
        "coordinationNumber",
        "stress",
    ];
    let expected = [
        of("boundary.floor", &moving),
        of("boundary.wall", &moving),
        of("sensor.fall", &["mass", "rate"]),
        of("sensor.low", &inside),
        of("sensor.low", &["maxNormalForce", "meanNormalForce"]),
        vec![
            "maxOverlap".to_owned(),
            "solver.unconvergedSteps".to_owned(),
        ],
    ];
    assert_eq!(outputs(fixed).unwrap(), expected.concat());
    // Of a belt, and of a sphere that the scene names, too.
    let belt = format!("{fixed}surface_velocity = [0.0, 1.0, 0.0]\n");
    let probe = "[[probe]]\nname = 'one'\nsphere = 'balls[1]'\n";
    let more = outputs(&format!("{belt}{probe}")).unwrap();
    assert!(more.contains(&"boundary.bin.averageForce".to_owned()));
    assert!(more.contains(&"probe.one.velocity".to_owned()));
}

#[test]
fn a_scene_names_its_outputs_with_wildcards() {
    let named = outputs("[fmu]\noutputs = ['boundary.*.force', 'momentum[3]', 'spheres.positio?']");
    let expected = [
        "boundary.floor.force",
        "boundary.wall.force",
        "momentum",
        "spheres.position",
    ];
    assert_eq!(named.unwrap(), expected);
    let all = outputs("[fmu]\noutputs = ['*']").unwrap();
    assert!(all.contains(&"solver.sweeps".to_owned()) && !all.contains(&"gravity".to_owned()));
    let refused = outputs("[fmu]\noutputs = ['boundary.flor.force', 'mass', 'maxOverlp']");
    assert_eq!(
        refused.unwrap_err(),
        "`[fmu] outputs`: found `boundary.flor.force`, expected the name of a measured variable; did you mean \
         `boundary.floor.force`? `*` stands for any text; `[fmu] outputs`: found `maxOverlp`, expected the name of a \
         measured variable; did you mean `maxOverlap`? `*` stands for any text"
    );
}
