//! Spheres from the results of another run: what was written is what starts.

use std::sync::Arc;

use nalgebra::UnitQuaternion;
use proptest::prelude::*;
use sphere_dda::formats::vtu;
use sphere_dda::formats::vtu::Precision;
use sphere_dda::observe::Observation;
use sphere_dda::results::frames;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

use super::{good, group, scene};

/// Spheres that fall, roll and spin on a floor, some of them waiting in a source.
fn run() -> Simulation {
    let walls = "[[boundary]]\nname = \"floor\"\nmaterial = \"rock\"\n\
                 faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]\n";
    let source = "[[source]]\nname = \"feed\"\nmaterial = \"rock\"\nradius = 0.05\ncapacity = 9\nrate = 100\n\
                  region = { box = { min = [4, 4, 4], max = [5, 5, 5] } }\n";
    let grains = "size = { uniform = { min = 0.05, max = 0.1 } }\nvelocity = [1, 0.5, -3]\nspin = [3, 2, 1]\n\
                  packing = { region = { box = { min = [0, 0, 0], max = [1, 1, 1] } }, solid_fraction = 0.3 }";
    let friction = "[pair_default]\nfriction = 0.4\n";
    let scene = good(&format!(
        "{friction}{walls}{}{source}",
        group("grains", grains)
    ));
    let mut simulation = Simulation::new(Arc::new(scene)).unwrap();
    simulation.advance_to(0.05).unwrap();
    simulation
}

/// A frame of the spheres.
fn frame(simulation: &Simulation, precision: Precision) -> Vec<u8> {
    let grid = frames::spheres(&Observation::of(simulation));
    vtu::encode(&grid, simulation.time(), precision, "spheres").unwrap()
}

/// The scene that starts from `content` in a file called by `key`.
fn from_file(key: &str, content: &[u8]) -> Result<Scene, String> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("start"), content).unwrap();
    let loaded = scene(
        &group("grains", &format!("{key} = \"./start\"")),
        folder.path(),
    );
    let loaded = loaded.map_err(|error| error.plain())?;
    // The file is part of the scene: it travels in packages and counts in the hash.
    assert_eq!(loaded.attachments[0].path, "start");
    assert_eq!(loaded.attachments[0].content, content);
    Ok(loaded.scene)
}

/// The spheres present in `simulation` are those of `scene`, numbers within `off` of their size.
fn assert_continues(simulation: &Simulation, scene: &Scene, off: f64) {
    let present: Vec<usize> = Observation::of(simulation).present().collect();
    assert_eq!(scene.particles.len(), present.len());
    assert!(present.len() < simulation.kinematics().len());
    let old = simulation.kinematics();
    let turned = |q: &UnitQuaternion<f64>| q.angle() > 0.01;
    assert!(present.iter().any(|&i| turned(&old.orientation[i])));
    for (k, &i) in present.iter().enumerate() {
        let twist = simulation.velocity(i);
        let close = |a: f64, b: f64| (a - b).abs() <= off * b.abs();
        let start = &scene.initial;
        assert!(close(
            scene.particles.radius[k],
            simulation.scene().particles.radius[i]
        ));
        for axis in 0..3 {
            assert!(close(start.position[k][axis], old.position[i][axis]));
            assert!(close(start.velocity[k][axis], twist.linear[axis]));
            assert!(close(start.spin[k][axis], twist.angular[axis]));
        }
        // Components of a unit quaternion, renormalised.
        let (a, b) = (start.orientation[k].coords, old.orientation[i].coords);
        assert!((a - b).amax() <= 2.0 * off.max(f64::EPSILON));
    }
}

#[test]
fn a_frame_of_doubles_starts_where_the_run_was() {
    let simulation = run();
    let started = from_file("vtu", &frame(&simulation, Precision::Double)).unwrap();
    assert_continues(&simulation, &started, 0.0);
}

#[test]
fn a_frame_of_singles_starts_where_the_run_was_to_seven_digits() {
    let simulation = run();
    let started = from_file("vtu", &frame(&simulation, Precision::Single)).unwrap();
    assert_continues(&simulation, &started, f64::from(f32::EPSILON) / 2.0);
    // The frame did hold singles.
    assert_ne!(
        started.initial.position[0],
        simulation.kinematics().position[0]
    );
}

#[test]
fn a_checkpoint_starts_where_the_run_was() {
    let simulation = run();
    let started = from_file("checkpoint", &simulation.snapshot()).unwrap();
    assert_continues(&simulation, &started, 0.0);
}

#[test]
fn a_damaged_checkpoint_is_refused() {
    let mut content = run().snapshot();
    let middle = content.len() / 2;
    content[middle] ^= 1;
    for (content, text) in [
        (&content[..], "its checksum does not match"),
        (&content[..middle], "it is cut short"),
        (
            b"x,y,z\n0,0,0\n",
            "it does not begin as every snapshot does",
        ),
    ] {
        let error = from_file("checkpoint", content).unwrap_err();
        assert!(
            error.contains("spheres[0].checkpoint: cannot read `./start`"),
            "{error}"
        );
        assert!(error.contains(text), "{error}");
    }
}

#[test]
fn a_file_of_another_kind_is_named() {
    let simulation = run();
    let whole = frame(&simulation, Precision::Single);
    let swap = |from: &str, to: &str| {
        let at = whole
            .windows(from.len())
            .position(|w| w == from.as_bytes())
            .unwrap();
        [&whole[..at], to.as_bytes(), &whole[at + from.len()..]].concat()
    };
    for (content, text) in [
        (
            b"x,y,z\n0,0,0\n".to_vec(),
            "the data is elsewhere, expected `<AppendedData encoding=\"raw\">`",
        ),
        (whole[..whole.len() / 2].to_vec(), "cut short"),
        (
            swap("UInt64", "UInt32"),
            "`header_type` of the file is `UInt32`, expected `UInt64`",
        ),
        (
            swap(
                "LittleEndian\"",
                "LittleEndian\" compressor=\"vtkZLibDataCompressor\"",
            ),
            "the compressor is `vtkZLibDataCompressor`",
        ),
        (
            swap("\"radius\"", "\"size\""),
            "array `radius` over the points is missing",
        ),
        (
            swap(
                "Name=\"velocity\" NumberOfComponents=\"3\"",
                "Name=\"velocity\"",
            ),
            "array `velocity` is",
        ),
        (swap("<PointData>", "<PointData"), "the header is no XML"),
        (
            swap(
                "Name=\"Points\" NumberOfComponents=\"3\"",
                "Name=\"Points\" NumberOfComponents=\"three\"",
            ),
            "`NumberOfComponents` of a tag is `three`",
        ),
    ] {
        let error = from_file("vtu", &content)
            .err()
            .unwrap_or_else(|| panic!("no `{text}`"));
        assert!(
            error.contains("spheres[0].vtu: cannot read `./start`") && error.contains(text),
            "{error}"
        );
        assert!(error.contains("spheres_NNNNNN.vtu"), "{error}");
    }
}

#[test]
fn radii_in_a_file_stand_alone() {
    let content = frame(&run(), Precision::Single);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("start.vtu"), content).unwrap();
    for (keys, path) in [
        ("radius = 0.1", "spheres[0].radius"),
        (
            "size = { uniform = { min = 0.1, max = 0.2 } }",
            "spheres[0].size",
        ),
    ] {
        let keys = format!("vtu = \"start.vtu\"\n{keys}");
        let error = scene(&group("grains", &keys), folder.path()).unwrap_err();
        assert_eq!(error.problems[0].path, path);
        assert!(error.problems[0].message.contains("radii in the file"));
    }
    let keys = "vtu = \"start.vtu\"\nvelocity = [0, 0, 7]";
    let started = scene(&group("grains", keys), folder.path()).unwrap().scene;
    assert!(started.initial.velocity.iter().all(|v| v.z == 7.0));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    /// Whatever becomes of a file, it is read or refused.
    #[test]
    fn no_damaged_frame_panics(at in 0.0..1.0_f64, byte in any::<u8>(), cut in any::<bool>(), header in any::<bool>()) {
        static WHOLE: std::sync::LazyLock<Vec<u8>> = std::sync::LazyLock::new(|| frame(&run(), Precision::Single));
        let mut content = WHOLE.clone();
        let end = if header { 2000 } else { content.len() };
        let at = (at * end as f64) as usize;
        if cut {
            content.truncate(at);
        } else {
            content[at] = byte;
        }
        match vtu::decode(&content) {
            Ok(cloud) => prop_assert!(!cloud.points.is_empty()),
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
    }
}
