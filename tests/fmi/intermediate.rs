//! Intermediate update mode of FMI 3.0: what is refused between internal steps.

use sphere_dda_fmi_interface::log::Log;
use sphere_dda_fmu::runtime::instance::{Call, Instance, Progress};
use sphere_dda_fmu::runtime::life_cycle::LifeCycle;
use sphere_dda_fmu::version::Version;
use sphere_dda_model_description::value::Value;

use super::{BOX, Scene};

const H: f64 = 0.01;

fn references(scene: &Scene, name: &str) -> Vec<u32> {
    let entries = scene.model.table.entries(Version::Three);
    let found = entries.iter().filter(|entry| entry.name() == name);
    found.map(|entry| entry.reference).collect()
}

/// An instance that has taken a step from 0 s.
fn started(scene: &Scene) -> Instance {
    let log = Log::new(None, false);
    let mut instance = Instance::new("box", &scene.model.guid, scene.resources(), log).unwrap();
    instance.set_up(0.0, None).unwrap();
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    instance.do_step(0.0, H, false).unwrap();
    instance
}

fn reals(instance: &mut Instance, scene: &Scene, name: &str, count: usize) -> Vec<f64> {
    let mut found = Vec::new();
    let references = references(scene, name);
    let mut give = |value| match value {
        Value::Real(value) => found.push(value),
        other => panic!("{other:?}"),
    };
    instance
        .get(Call::reals(Version::Three), &references, count, &mut give)
        .unwrap();
    found
}

/// Symptom: where an input was refused in intermediate update mode, spheres stayed where the internal steps had brought them and the
/// next step lacked their time. Cause: the inputs were given back, the simulation was not.
#[test]
fn a_refused_input_leads_back_to_the_beginning() {
    let scene = Scene::new(&BOX.replacen("input = \"pose\"", "input = \"world_pose\"", 1));
    let (mut instance, mut plain) = (started(&scene), started(&scene));
    let positions = |instance: &mut Instance| reals(instance, &scene, "spheres.position", 3 * 18);
    let before = positions(&mut instance);
    instance.begin_step(H, H).unwrap();
    for _ in 0..4 {
        let taken = instance.internal_step().unwrap();
        assert_eq!(taken, Progress::Taken { last: false });
    }
    assert_ne!(positions(&mut instance), before);
    let orientation = references(&scene, "boundary.floor.targetOrientation");
    let wrong = [2.0, 0.0, 0.0, 0.0].map(Value::Real).to_vec();
    instance
        .set(Call::reals(Version::Three), &orientation, wrong)
        .unwrap();
    let refusal = instance.internal_step().unwrap_err().to_string();
    assert!(refusal.contains("expected a unit quaternion"), "{refusal}");
    assert_eq!(instance.stage(), LifeCycle::StepComplete);
    assert_eq!((instance.time(), positions(&mut instance)), (H, before));
    for instance in [&mut instance, &mut plain] {
        instance.do_step(H, H, false).unwrap();
    }
    assert_eq!(positions(&mut instance), positions(&mut plain));
}
