//! The shared library through its C interface: life cycle, refusals, saved states, threads, and what it computes.

mod about;
mod c;
mod extremes;
mod feedthrough;
mod intermediate;
mod licences;
mod parameters;
mod refusals;
mod rollback;
mod states;
mod table;
mod world_pose;

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use c::{DISCARD, ERROR, Fmi, Instance, OK};
use sphere_dda::Vec3;
use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::values;
use sphere_dda::results::history::columns;
use sphere_dda::simulation::Simulation;
use sphere_dda_export::description::version2::describe;
use sphere_dda_fmu::model::Model;
use sphere_dda_fmu::version::Version;
use sphere_dda_model_description::fmi2::Causality;
use sphere_dda_model_description::value::ScalarType;

/// 18 balls fall on a floor that can be driven, beside a wall that can be pushed.
pub(crate) const BOX: &str = r#"
title = "Box"
[simulation]
duration = 0.2
step = 1e-3
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
communication_step = 1e-2
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.3
[[boundary]]
name = "floor"
material = "stone"
input = "pose"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
[[boundary]]
name = "wall"
material = "stone"
input = "twist"
faces = [{ plane = { point = [-0.3, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }]
[[spheres]]
name = "balls"
material = "stone"
radius = 0.05
seed = 4
lattice = { origin = [-0.2, -0.2, 0.06], count = [3, 3, 2], spacing = 0.11, jitter = 0.02 }
[[sensor]]
name = "fall"
mass_flow = { plane = { point = [0.0, 0.0, 0.15], normal = [0.0, 0.0, -1.0] } }
[[sensor]]
name = "low"
region = { box = { min = [-0.3, -0.3, 0.0], max = [0.3, 0.3, 0.12] } }
"#;

/// A scene in a folder of its own, as `resources/` has it.
pub(crate) struct Scene {
    folder: tempfile::TempDir,
    pub(crate) model: Model,
}

impl Scene {
    pub(crate) fn new(text: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("scene.toml"), text).unwrap();
        let model =
            Model::read(&folder.path().join("scene.toml"), None).unwrap_or_else(|e| panic!("{e}"));
        Self { folder, model }
    }

    pub(crate) fn resources(&self) -> &Path {
        self.folder.path()
    }

    /// Value reference of a name.
    pub(crate) fn reference(&self, name: &str) -> u32 {
        let variables = self.model.table.entries(Version::Two);
        variables
            .iter()
            .find(|v| v.name() == name)
            .unwrap_or_else(|| panic!("no variable `{name}`"))
            .reference
    }

    pub(crate) fn instance(&self) -> Instance<'static> {
        let instance = fmi().instantiate("box", &self.model.guid, self.resources());
        assert!(!instance.handle.is_null(), "{:?}", instance.log());
        instance
    }

    fn vector(&self, instance: &Instance, name: &str) -> [f64; 3] {
        [1, 2, 3].map(|k| instance.real(self.reference(&format!("{name}[{k}]"))))
    }
}

pub(crate) fn box_scene() -> Scene {
    Scene::new(BOX)
}

pub(crate) fn fmi() -> &'static Fmi {
    static FMI: OnceLock<Fmi> = OnceLock::new();
    FMI.get_or_init(Fmi::load)
}

fn examples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    ["feeder", "funnel", "slopes"]
        .map(|name| folder.join(name).join(format!("{name}.toml")))
        .into()
}

#[test]
fn the_table_is_the_description() {
    let mut models: Vec<Model> = examples()
        .iter()
        .map(|path| Model::read(path, None).unwrap())
        .collect();
    models.push(box_scene().model);
    for model in models {
        let description = describe(&model.scene, &model.table, "box", &model.guid);
        assert_eq!(description.validate(), []);
        assert_eq!(description.guid, model.guid);
        let variables = model.table.entries(Version::Two);
        for (rank, (own, written)) in variables
            .iter()
            .zip(&description.model_variables)
            .enumerate()
        {
            assert_eq!((own.reference as usize, &own.name()), (rank, &written.name));
            assert_eq!(own.variable.scalar, written.variable_type.scalar());
            let causality = own.variable.causality;
            let settable = matches!(causality, Causality::Input | Causality::Parameter);
            assert_eq!(own.start().len(), usize::from(settable), "{}", own.name());
        }
    }
}

/// One list behind both: what the FMU measures are the columns of the history, in the same order.
#[test]
fn the_history_and_the_fmu_name_the_same_quantities() {
    let model = box_scene().model;
    let measured = model.table.entries(Version::Two).into_iter();
    let measured = measured.filter(|entry| {
        matches!(
            entry.variable.causality,
            Causality::Output | Causality::Local
        )
    });
    let names: Vec<String> = measured
        .map(|entry| format!("{} [{}]", entry.name(), entry.variable.unit.unwrap_or("-")))
        .collect();
    assert_eq!(columns(&model.scene)[1..], names);
    let of_sensor: Vec<&str> = names
        .iter()
        .filter_map(|name| name.strip_prefix("sensor.low."))
        .collect();
    let expected = "mass [kg], count [-], solidFraction [-], centreOfMass[1] [m], centreOfMass[2] [m], \
        centreOfMass[3] [m], coordinationNumber [-], stress[1] [Pa], stress[2] [Pa], stress[3] [Pa], stress[4] [Pa], \
        stress[5] [Pa], stress[6] [Pa], maxNormalForce [N], meanNormalForce [N]";
    assert_eq!(of_sensor.join(", "), expected);
}

/// At t = 0, and an integer through its own function.
#[test]
fn a_region_is_measured_from_the_start() {
    let scene = box_scene();
    let instance = scene.instance();
    assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
    // The lower layer of nine; the jitter moves no centre across z = 0.12.
    let count = scene.reference("sensor.low.count");
    assert_eq!(instance.integer(count), 9);
    let mass = instance.real(scene.reference("sensor.low.mass"));
    let all = instance.real(scene.reference("mass"));
    assert!((mass - 0.5 * all).abs() < 1e-12 * all);
    assert_eq!(instance.integer(scene.reference("sphereCount")), 18);
    let solid = instance.real(scene.reference("sensor.low.solidFraction"));
    let volume = mass / 2500.0 / (0.6 * 0.6 * 0.12);
    assert!(
        solid > 0.9 * volume && solid < 1.3 * volume,
        "{solid} {volume}"
    );
    assert_eq!(instance.exit(), OK);
}

#[test]
fn the_guid_is_that_of_the_content() {
    let (one, same) = (box_scene().model, box_scene().model);
    assert_eq!(one.guid, same.guid);
    let other = Scene::new(&BOX.replace("friction = 0.3", "friction = 0.4")).model;
    assert_ne!(one.guid, other.guid);
}

#[test]
fn all_functions_exist() {
    assert_eq!(c::NAMES.len(), 34);
    let text = |pointer| {
        // SAFETY: the library hands out NUL-terminated static texts.
        unsafe { std::ffi::CStr::from_ptr(pointer) }
            .to_str()
            .unwrap()
    };
    // SAFETY: no arguments; constant texts.
    unsafe {
        assert_eq!(text((fmi().f.fmi2GetVersion)()), "2.0");
        assert_eq!(text((fmi().f.fmi2GetTypesPlatform)()), "default");
    }
}

/// Every real output of the instance equals the library's, bit for bit.
fn assert_same_outputs(scene: &Scene, instance: &Instance, simulation: &Simulation) {
    let outputs = values(&Observation::of(simulation));
    for entry in scene.model.table.entries(Version::Two) {
        let rank = entry.variable.rank(entry.index.unwrap_or(0));
        if let (Some(rank), ScalarType::Float64) = (rank, entry.variable.scalar) {
            let expected = outputs[rank];
            let found = instance.real(entry.reference);
            assert_eq!(
                found.to_bits(),
                expected.to_bits(),
                "{}: {found} {expected}",
                entry.name()
            );
        }
    }
}

#[test]
fn fmu_and_library_give_the_same_bytes() {
    let scene = box_scene();
    let instance = scene.instance();
    instance.initialize();
    let mut simulation = Simulation::new(scene.model.scene.clone()).unwrap();
    assert_same_outputs(&scene, &instance, &simulation);
    for k in 0..10 {
        let t = f64::from(k) * 0.01;
        assert_eq!(instance.step(t, 0.01), OK, "{:?}", instance.log());
        simulation.advance_to(t + 0.01).unwrap();
        assert_same_outputs(&scene, &instance, &simulation);
    }
}

#[test]
fn averaged_wrench_and_weight_change_the_momentum() {
    let scene = box_scene();
    let instance = scene.instance();
    instance.initialize();
    let (lift, push) = (
        scene.reference("boundary.floor.translation[3]"),
        scene.reference("boundary.wall.velocity[1]"),
    );
    let (h, mass) = (0.01, instance.real(scene.reference("mass")));
    assert_eq!(instance.step(0.0, h), OK);
    let mut momentum = scene.vector(&instance, "momentum");
    for k in 1..20 {
        let t = f64::from(k) * h;
        instance.set(lift, 2e-3 * (40.0 * t).sin());
        instance.set(push, 0.2);
        assert_eq!(instance.step(t, h), OK, "{:?}", instance.log());
        let (floor, wall) = (
            scene.vector(&instance, "boundary.floor.averageForce"),
            scene.vector(&instance, "boundary.wall.averageForce"),
        );
        let after = scene.vector(&instance, "momentum");
        for axis in 0..3 {
            let weight = if axis == 2 { -9.81 * mass } else { 0.0 };
            let impulse = h * (weight - floor[axis] - wall[axis]);
            let error = (after[axis] - momentum[axis] - impulse).abs();
            assert!(
                error < 1e-9 * mass * 9.81 * h,
                "t = {t}, axis {axis}: {error:e}"
            );
        }
        momentum = after;
    }
}

#[test]
fn a_step_lands_exactly_and_accepts_rounded_points() {
    let scene = box_scene();
    let instance = scene.instance();
    assert_eq!(instance.set_up(1.0, Some(1.2)), OK);
    assert_eq!([instance.enter(), instance.exit()], [OK; 2]);
    let time = scene.reference("time");
    assert_eq!(instance.real(time), 1.0);
    // A master that adds up, whose last step ends behind the stop time by rounding.
    let (mut t, h) = (1.0, 0.010_000_000_000_000_009);
    for _ in 0..20 {
        assert_eq!(instance.step(t, h), OK, "{:?}", instance.log());
        t += h;
        assert_eq!(instance.real(time), t);
    }
    assert_eq!(instance.step(t, h), ERROR);
    assert!(instance.log()[0].contains("stop time"));
    // A master that multiplies: its points differ from the last step's end by rounding, and count.
    assert_eq!(instance.reset(), OK);
    instance.initialize();
    for k in 0..20 {
        let t = f64::from(k) * 0.01;
        assert_eq!(instance.step(t, 0.01), OK, "{:?}", instance.log());
        assert_eq!(instance.real(time), t + 0.01);
    }
}

/// A ball on a floor that slides to and fro, for an hour of steps of 1/60 s: no point is refused, times are those of the master to the
/// bit, and the ball stays where the period puts it.
#[test]
fn one_sixtieth_of_a_second_for_an_hour() {
    let scene = Scene::new(
        &BOX.replace("duration = 0.2", "duration = 3600.0")
            .replace("step = 1e-3", "step = 2e-2")
            .replace("count = [3, 3, 2]", "count = [1, 1, 1]")
            .replace("-0.2, -0.2, 0.06], count", "0.0, 0.0, 0.05], count")
            .replace(", jitter = 0.02", ""),
    );
    let instance = scene.instance();
    instance.initialize();
    let floor = scene.reference("boundary.floor.translation[2]");
    let position = scene.reference("boundary.floor.position[2]");
    let time = scene.reference("time");
    let momentum = scene.reference("momentum[3]");
    let h = 1.0 / 60.0;
    // Forth and back once a second.
    let place = |k: u32| 1e-3 * f64::from((k % 60).min(60 - k % 60)) / 30.0;
    for k in 0..216_000 {
        let t = f64::from(k) / 60.0;
        assert_eq!(instance.set(floor, place(k + 1)), OK);
        assert_eq!(instance.step(t, h), OK, "{:?}", instance.log());
        assert_eq!(instance.real(time), t + h);
    }
    assert_eq!(instance.real(time), f64::from(215_999) / 60.0 + h);
    assert_eq!(instance.real(position), 0.0);
    assert!(instance.real(momentum).abs() < 1e-9);
    assert_eq!(instance.integer(scene.reference("solver.internalSteps")), 1);
}

#[test]
fn inputs_set_before_the_start_place_the_boundary() {
    let scene = box_scene();
    let instance = scene.instance();
    let lift = scene.reference("boundary.floor.translation[3]");
    assert_eq!(instance.set(lift, -0.5), OK);
    assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
    let position = scene.reference("boundary.floor.position[3]");
    assert_eq!(instance.real(position), -0.5);
    // And again in initialization mode, after a read.
    assert_eq!(instance.set(lift, -0.25), OK);
    assert_eq!(instance.real(position), -0.25);
    assert_eq!(instance.exit(), OK);
    assert_eq!(instance.step(0.0, 0.01), OK);
    assert_eq!(instance.real(position), -0.25);
    assert_eq!(
        instance.real(scene.reference("boundary.floor.averageForce[3]")),
        0.0
    );
}

/// The momentum changes by the mean body force less the mean forces on the boundaries, times the step, while the importer shakes
/// gravity, the scene turns it, and steps are no whole number of internal ones.
#[test]
fn momentum_balances_while_gravity_changes() {
    let turning = "step = 1e-3\ngravity_motion = { rotation = { axis = [0, 1, 0], speed = 3 } }";
    let scene = Scene::new(&BOX.replacen("step = 1e-3", turning, 1));
    let instance = scene.instance();
    instance.initialize();
    let vector = |name: &str| Vec3::from(scene.vector(&instance, name));
    let (mut time, mut momentum) = (0.0, vector("momentum"));
    for k in 0..15_u32 {
        let h = 0.0104 + 1e-4 * f64::from(k % 3);
        let shaken = 4.0 * f64::from(k).sin();
        assert_eq!(instance.set(scene.reference("gravity[1]"), shaken), OK);
        assert_eq!(instance.step(time, h), OK, "{:?}", instance.log());
        time += h;
        let walls = ["floor", "wall"].map(|b| vector(&format!("boundary.{b}.averageForce")));
        let force = vector("averageBodyForce") - walls[0] - walls[1];
        let weight = instance.real(scene.reference("mass")) * 9.81;
        let change = vector("momentum") - momentum;
        assert!((change - force * h).norm() < 1e-9 * weight * h, "{k}");
        momentum = vector("momentum");
    }
    assert!(momentum.x.abs() > 0.01);
}

#[test]
fn gravity_from_a_table_cannot_be_set() {
    let table = "gravity_motion = { table = { time = [0, 1], gravity = [[0, 0, -9], [0, 0, 0]] } }";
    let scene = Scene::new(&BOX.replacen("step = 1e-3", &format!("step = 1e-3\n{table}"), 1));
    let variables = scene.model.table.variables();
    assert!(!variables.iter().any(|v| v.name == "gravity"));
}

#[test]
fn gravity_may_change_between_steps() {
    let scene = box_scene();
    let instance = scene.instance();
    instance.initialize();
    assert_eq!(instance.set(scene.reference("gravity[3]"), 0.0), OK);
    assert_eq!(instance.set(scene.reference("gravity[1]"), 2.0), OK);
    let before = scene.vector(&instance, "momentum");
    assert_eq!(instance.step(0.0, 0.01), OK);
    let mass = instance.real(scene.reference("mass"));
    let gained = scene.vector(&instance, "momentum")[0] - before[0];
    // The first half step starts half a step earlier: the staggered velocity.
    assert!(
        (gained / (mass * 2.0 * 0.01) - 1.0).abs() < 0.06,
        "{gained}"
    );
}

#[test]
fn an_output_read_after_a_set_is_the_last_steps() {
    let scene = box_scene();
    let instance = scene.instance();
    instance.initialize();
    assert_eq!(instance.step(0.0, 0.01), OK);
    let force = scene.reference("boundary.floor.force[3]");
    let before = instance.real(force);
    instance.set(scene.reference("boundary.floor.translation[3]"), 1e-3);
    assert_eq!(instance.real(force), before);
    assert_eq!(instance.real(force), before);
    // It is information, for those who ask for it.
    let lines = instance.log();
    assert!(lines.is_empty(), "{lines:?}");
}

#[test]
fn an_experiment_of_no_length_has_a_start() {
    let scene = box_scene();
    let instance = scene.instance();
    assert_eq!(instance.set_up(1.0, Some(1.0)), OK, "{:?}", instance.log());
    assert_eq!([instance.enter(), instance.exit()], [OK; 2]);
    assert_eq!(instance.integer(scene.reference("sphereCount")), 18);
    assert_eq!(instance.step(1.0, 0.01), ERROR);
    assert!(instance.log()[0].contains("at most the stop time 1 s"));
    assert_eq!(instance.terminate(), OK);
}

/// The solver may not iterate at all: no step with contacts converges.
fn hopeless() -> Scene {
    let text = BOX.replace(
        "duration = 0.2",
        "duration = 0.2\nmax_iterations = 1\nmax_cuts = 0",
    );
    Scene::new(&text.replace("0.06]", "0.5]"))
}

#[test]
fn a_hopeless_step_is_discarded_then_an_error() {
    let scene = hopeless();
    let instance = scene.instance();
    instance.initialize();
    let (mut t, h) = (0.0, 0.01);
    let status = loop {
        let before = instance.bytes();
        let status = instance.step(t, h);
        if status != OK {
            break (status, before);
        }
        t = instance.real(scene.reference("time"));
        assert!(t < 1.0, "nothing failed");
    };
    let lines = instance.log();
    assert_eq!(status.0, DISCARD, "{lines:?}");
    assert!(
        lines[0].starts_with("2 logStatusDiscard fmi2DoStep: step from t ="),
        "{lines:?}"
    );
    assert_eq!(instance.last_time(), t);
    // A shorter step may do: the instance does not ask for the end.
    assert!(!instance.terminated());
    assert_eq!(instance.real(scene.reference("time")), t);
    // The same step again is an error, and leaves reading, reset and restoring.
    assert_eq!(instance.step(t, h), ERROR);
    assert!(instance.terminated());
    assert_eq!(instance.step(t, h / 2.0), ERROR);
    assert_eq!(instance.load(&status.1), OK, "{:?}", instance.log());
    assert_eq!(instance.bytes(), status.1);
    assert_eq!(instance.step(t, h), DISCARD);
    assert_eq!(instance.reset(), OK);
    instance.initialize();
}
