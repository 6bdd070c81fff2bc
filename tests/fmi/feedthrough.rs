//! Outputs after a set without a step, and what the model descriptions say of them.

use sphere_dda_export::description::{version2, version3};
use sphere_dda_fmu::version::Version;
use sphere_dda_model_description::fmi2::{Causality, Variability};
use sphere_dda_model_description::value::ScalarType;

use crate::c::OK;
use crate::{BOX, Scene};

/// The box with every kind of input: pose, twist, a belt, a flap under load.
pub(crate) fn driven() -> Scene {
    Scene::new(&driven_text())
}

pub(crate) fn driven_text() -> String {
    let more = r#"
[[boundary]]
name = "belt"
material = "stone"
surface_input = true
faces = [{ rectangle = { corner = [0.15, -0.3, 0.0], u = [0.3, 0.0, 0.05], v = [0.0, 0.6, 0.0] } }]
[[boundary]]
name = "flap"
material = "stone"
input = "load"
point_of_action = [0.6, 0.0, 0.0]
faces = [{ rectangle = { corner = [0.5, -0.1, 0.02], u = [0.2, 0.0, 0.0], v = [0.0, 0.2, 0.0] } }]
[boundary.body]
mass = 0.4
centre = [0.6, 0.0, 0.0]
inertia = [0.001, 0.001, 0.002]
joint = { hinge = [0.0, 1.0, 0.0] }
"#;
    format!("{BOX}{more}")
}

#[test]
fn a_set_without_a_step_changes_no_output() {
    let scene = driven();
    let entries = scene.model.table.entries(Version::Two);
    let outputs: Vec<u32> = entries
        .iter()
        .filter(|e| {
            matches!(e.variable.causality, Causality::Output | Causality::Local)
                && e.variable.scalar == ScalarType::Float64
        })
        .map(|e| e.reference)
        .collect();
    let settable: Vec<u32> = entries
        .iter()
        .filter(|e| {
            e.variable.causality == Causality::Input
                || e.variable.variability == Variability::Tunable
        })
        .map(|e| e.reference)
        .collect();
    assert!(settable.len() > 15, "{}", settable.len());
    let (one, two) = (scene.instance(), scene.instance());
    let values = |instance: &crate::c::Instance| {
        let mut values = vec![f64::NAN; outputs.len()];
        assert_eq!(
            instance.get(&outputs, &mut values),
            OK,
            "{:?}",
            instance.log()
        );
        values.iter().map(|v| v.to_bits()).collect::<Vec<_>>()
    };
    one.initialize();
    two.initialize();
    for k in 0..12 {
        let t = f64::from(k) * 1e-2;
        assert_eq!([one.step(t, 1e-2), two.step(t, 1e-2)], [OK; 2]);
    }
    // Before the first read, and after it.
    for &reference in &settable {
        assert_eq!(two.set(reference, 0.011), OK, "{:?}", two.log());
    }
    let before = values(&one);
    assert!(before == values(&two));
    for &reference in &settable {
        assert_eq!(two.set(reference, -0.013), OK, "{:?}", two.log());
    }
    assert!(before == values(&two));
    // What was set does act, in the step.
    assert_eq!([one.step(0.12, 1e-2), two.step(0.12, 1e-2)], [OK; 2]);
    assert!(values(&one) != values(&two));
}

#[test]
fn descriptions_list_no_feedthrough() {
    let model = driven().model;
    let two = version2::describe(&model.scene, &model.table, "box", &model.guid);
    assert!(two.model_structure.outputs.len() > 50);
    let none = Some(Vec::new());
    assert!(
        two.model_structure
            .outputs
            .iter()
            .all(|unknown| unknown.dependencies == none)
    );
    // Initialization computes all outputs from all that is set.
    let initial = &two.model_structure.initial_unknowns;
    assert!(!initial.is_empty() && initial.iter().all(|unknown| unknown.dependencies.is_none()));
    assert!(two.to_xml().unwrap().contains(r#"dependencies="""#));
    assert_eq!(two.validate(), []);

    let three = version3::describe(&model.scene, &model.table, "box", &model.guid);
    assert!(three.model_structure.outputs.len() > 30);
    assert!(
        three
            .model_structure
            .outputs
            .iter()
            .all(|unknown| unknown.dependencies == none)
    );
    let initial = &three.model_structure.initial_unknowns;
    assert!(initial.iter().any(|unknown| unknown.dependencies.is_none()));
    assert!(three.to_xml().unwrap().contains(r#"dependencies="""#));
    assert_eq!(three.validate(), []);
}
