//! The results directory: structure of the VTU files, rollback, overwriting, failures, and a run killed while it
//! writes. The frames are synthetic: no solver takes part. They are left in the target directory with the values
//! they should hold, for `tests/python/test_vtk.py` to read with meshio and VTK.

use std::fs;
use std::path::{Path, PathBuf};

use nalgebra::UnitQuaternion;
use sphere_dda::Vec3;
use sphere_dda::boundaries::{Boundary, Geometry};
use sphere_dda::contacts::{Contact, Key, Partner};
use sphere_dda::materials::{Material, Pair, PairTable};
use sphere_dda::motion::{Motion, Pose, Twist};
use sphere_dda::observe::error::OutputError;
use sphere_dda::observe::frames::{Series, Surface, frame};
use sphere_dda::observe::sensors::Flow;
use sphere_dda::observe::vtu::{Array, Cell, Grid, Precision, Values, encode};
use sphere_dda::observe::writer::{Options, Results};
use sphere_dda::observe::{BoundaryState, Observation};
use sphere_dda::particles::{Kinematics, Locks, Particles};
use sphere_dda::scene::{
    Integrator, Measure, Method, Output, Scene, Sensor, Settings, SolverKind, Tolerance,
};
use sphere_dda::simulation::{StepReport, Wrench};

/// A row of `n` spheres above a floor and a box, with one sensor of each kind.
fn scene(n: usize) -> Scene {
    let mut particles = Particles::default();
    let mut initial = Kinematics::default();
    for i in 0..n {
        particles.push(0.1 + 0.01 * (i % 3) as f64, 2500.0, 0, Locks::default());
        initial.push(
            Vec3::new(0.2 * i as f64, 0.0, 0.1),
            Vec3::zeros(),
            Vec3::zeros(),
        );
    }
    let boundary = |name: &str, geometry| Boundary {
        name: name.to_owned(),
        material: 0,
        geometry,
        motion: Motion::Fixed,
        point_of_action: Vec3::new(0.5, 0.0, 0.0),
        stiffness: None,
    };
    Scene {
        title: "a row".to_owned(),
        settings: Settings {
            gravity: Vec3::new(0.0, 0.0, -9.81),
            duration: 1.0,
            step: 1e-3,
            communication_step: 0.01,
            method: Method::Alm,
            integrator: Integrator::Moreau,
            solver: SolverKind::Auto,
            penalty: None,
            adapt_penalty: true,
            tolerance: Tolerance {
                gap: 1e-6,
                slip: 1e-6,
                force: 1e-6,
            },
            max_initial_overlap: 0.05,
            threshold_velocity: 0.0,
            dynamic_coefficient: 1.0,
            max_iterations: 1000,
            max_cuts: 4,
        },
        materials: vec![Material {
            name: "glass".to_owned(),
            density: 2500.0,
        }],
        pairs: PairTable::new(1, Pair::default()),
        particles,
        initial,
        boundaries: vec![boundary("floor", floor()), boundary("crate", crate_box())],
        loads: Vec::new(),
        springs: Vec::new(),
        sensors: vec![
            Sensor {
                name: "hold".to_owned(),
                measure: Measure::MassInBox {
                    min: Vec3::repeat(-0.15),
                    max: Vec3::repeat(0.15),
                },
            },
            Sensor {
                name: "outflow".to_owned(),
                measure: Measure::MassFlow {
                    point: Vec3::zeros(),
                    normal: Vec3::z(),
                },
            },
        ],
        probes: Vec::new(),
        output: Output {
            vtu_interval: 0.1,
            csv_interval: 0.0,
            float64: false,
        },
    }
}

fn floor() -> Geometry {
    Geometry::default()
}

fn crate_box() -> Geometry {
    Geometry::default()
}

/// Positions and contacts of a state that no solver made.
struct Made {
    kinematics: Kinematics,
    contacts: Vec<Contact>,
}

impl Made {
    fn new(scene: &Scene, time: f64) -> Self {
        let mut kinematics = scene.initial.clone();
        for (i, position) in kinematics.position.iter_mut().enumerate() {
            position.y = (3.0 * time + i as f64).sin();
            kinematics.orientation[i] = UnitQuaternion::from_scaled_axis(Vec3::new(0.0, 0.0, time));
        }
        let contact = |sphere, partner, force| Contact {
            key: Key { sphere, partner },
            point: Vec3::new(0.2 * f64::from(sphere), 0.3, 0.0),
            normal: Vec3::z(),
            gap: -1e-7,
            force,
        };
        let floor = Partner::Boundary {
            boundary: 0,
            feature: 0,
        };
        let mut contacts = vec![
            contact(0, Partner::Sphere(1), Vec3::new(1.0, 0.0, 2.0 + time)),
            contact(0, floor, Vec3::new(0.0, 0.0, 3.0)),
            contact(2, floor, Vec3::new(0.0, 0.5, 4.0)),
        ];
        // A candidate that does not touch must not appear.
        contacts.push(Contact {
            gap: 0.01,
            ..contact(3, floor, Vec3::zeros())
        });
        Self {
            kinematics,
            contacts,
        }
    }

    fn observe<'a>(&'a self, scene: &'a Scene, time: f64) -> Observation<'a> {
        let twist = Twist {
            linear: Vec3::new(0.1, 0.2, 0.3),
            angular: Vec3::new(0.0, 0.0, 1.0),
        };
        Observation {
            scene,
            time,
            gravity: scene.settings.gravity,
            kinematics: &self.kinematics,
            velocity: vec![twist; scene.particles.len()],
            contacts: &self.contacts,
            boundaries: vec![
                BoundaryState {
                    pose: Pose {
                        translation: Vec3::new(0.0, 0.0, 0.1 * time),
                        rotation: UnitQuaternion::identity(),
                    },
                    twist,
                    wrench: Wrench {
                        force: Vec3::new(0.0, -0.5, -7.0),
                        torque: Vec3::zeros(),
                    },
                    mean_wrench: Wrench::default(),
                };
                scene.boundaries.len()
            ],
            flows: vec![Flow::default(); scene.sensors.len()],
            dissipated: 0.0,
            report: StepReport::default(),
        }
    }
}

fn record(results: &mut Results, scene: &Scene, time: f64) {
    results.record(&Made::new(scene, time).observe(scene, time));
}

/// A new directory below the target directory, kept after the test.
fn place(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if path.exists() {
        fs::remove_dir_all(&path).unwrap();
    }
    path
}

/// Times and files that a collection lists.
fn listed(pvd: &Path) -> Vec<(f64, String)> {
    let text = fs::read_to_string(pvd).unwrap();
    assert!(text.trim_end().ends_with("</VTKFile>"));
    let field = |line: &str, key: &str| {
        let start = line.find(&format!("{key}=\"")).unwrap() + key.len() + 2;
        line[start..].split('"').next().unwrap().to_owned()
    };
    text.lines()
        .filter(|line| line.starts_with("<DataSet"))
        .map(|line| {
            (
                field(line, "timestep").parse().unwrap(),
                field(line, "file"),
            )
        })
        .collect()
}

/// Walks the blocks of a VTU file as meshio does: no gaps, every offset a tag's, the newline at the end.
fn check_blocks(bytes: &[u8]) {
    let start = b"<AppendedData encoding=\"raw\">_";
    let end = b"\n</AppendedData>\n</VTKFile>\n";
    let from = bytes.windows(start.len()).position(|w| w == start).unwrap() + start.len();
    assert!(bytes.ends_with(end));
    let header = std::str::from_utf8(&bytes[..from]).unwrap();
    let offsets: Vec<usize> = header
        .split("offset=\"")
        .skip(1)
        .map(|rest| rest.split('"').next().unwrap().parse().unwrap())
        .collect();
    let data = &bytes[from..bytes.len() - end.len()];
    let (mut at, mut walked) = (0, Vec::new());
    while at < data.len() {
        walked.push(at);
        at += 8 + u64::from_le_bytes(data[at..at + 8].try_into().unwrap()) as usize;
    }
    assert_eq!(at, data.len());
    walked.reverse();
    assert_eq!(offsets, walked, "blocks in reverse order of the tags");
}

fn grid(points: usize) -> Grid {
    Grid {
        points: vec![Vec3::new(1.0, 2.0, 3.0); points],
        cell: Cell::Vertex,
        connectivity: (0..points as u32).collect(),
        point_data: vec![
            Array::scalar("a", (0..points).map(|i| i as f64)),
            Array::vector("b", vec![Vec3::x(); points]),
        ],
        cell_data: vec![Array::integer("c", 0..points as i32)],
    }
}

#[test]
fn blocks_follow_each_other_without_gaps() {
    for points in [1, 2, 7] {
        for precision in [Precision::Single, Precision::Double] {
            check_blocks(&encode(&grid(points), 0.25, precision, "x").unwrap());
        }
    }
}

#[test]
fn values_that_readers_would_swallow_are_refused() {
    for (value, precision) in [
        (f64::NAN, Precision::Single),
        (f64::NAN, Precision::Double),
        (f64::INFINITY, Precision::Double),
        (1e39, Precision::Single),
    ] {
        let mut broken = grid(3);
        broken.point_data[0] = Array::scalar("a", [0.0, value, 0.0]);
        let error = encode(&broken, 0.0, precision, "x.vtu").unwrap_err();
        assert!(
            matches!(error, OutputError::NotFinite { index: 1, .. }),
            "{error}"
        );
        assert!(error.to_string().contains("`a`"), "{error}");
    }
    let mut broken = grid(1);
    broken.points[0].y = f64::NAN;
    assert!(encode(&broken, 0.0, Precision::Single, "x").is_err());
    assert!(encode(&grid(1), f64::NAN, Precision::Single, "x").is_err());
}

#[test]
fn grids_that_do_not_fit_are_refused() {
    let refused = |grid: &Grid| encode(grid, 0.0, Precision::Single, "x").unwrap_err();
    assert!(matches!(refused(&grid(0)), OutputError::Empty { .. }));
    let mut short = grid(3);
    short.point_data[1] = Array::vector("b", vec![Vec3::x(); 2]);
    assert!(matches!(
        refused(&short),
        OutputError::Shape {
            found: 6,
            expected: 9,
            ..
        }
    ));
    let mut dangling = grid(3);
    dangling.connectivity[2] = 3;
    assert!(matches!(refused(&dangling), OutputError::Shape { .. }));
    let mut torn = grid(3);
    torn.cell = Cell::Line;
    assert!(matches!(refused(&torn), OutputError::Shape { .. }));
}

#[test]
fn a_frame_without_contacts_has_the_same_arrays() {
    let scene = scene(4);
    let full = Made::new(&scene, 0.0);
    let mut empty = Made::new(&scene, 0.0);
    empty.contacts.retain(|contact| contact.gap > 0.0);
    let surface = Surface::new(&scene);
    let contacts = |made: &Made| {
        let grids = frame(&made.observe(&scene, 0.0), &surface);
        grids
            .into_iter()
            .find(|(s, _)| *s == Series::Contacts)
            .unwrap()
            .1
    };
    let (full, empty) = (contacts(&full), contacts(&empty));
    assert_eq!((full.cell, full.cells()), (Cell::Line, 3));
    assert_eq!((empty.cell, empty.cells()), (Cell::Vertex, 1));
    assert_eq!(empty.points.len(), 4);
    for (a, b) in full.cell_data.iter().zip(&empty.cell_data) {
        assert_eq!((a.name, a.components), (b.name, b.components));
        match &b.values {
            Values::Real(values) => assert!(values.iter().all(|&v| v == 0.0)),
            Values::Integer(values) => assert_eq!(values, &[-1]),
        }
    }
    check_blocks(&encode(&empty, 0.0, Precision::Single, "x").unwrap());
}

#[test]
fn contact_loads_balance() {
    let scene = scene(4);
    let made = Made::new(&scene, 0.0);
    let state = made.observe(&scene, 0.0);
    let (force, torque) = sphere_dda::observe::frames::contact_loads(&state);
    // Sphere 0 is pushed by 1 and by the floor, 1 by 0 alone.
    assert_eq!(force[0], Vec3::new(1.0, 0.0, 5.0));
    assert_eq!(force[1], Vec3::new(-1.0, 0.0, -2.0));
    // -R n x f with n = z: f_x at the lowest point of 0 turns it about -y, and 1, pushed at its top, likewise.
    let radius = &scene.particles.radius;
    assert_eq!(torque[0], Vec3::new(0.0, -radius[0], 0.0));
    assert_eq!(torque[1], Vec3::new(0.0, -radius[1], 0.0));
    assert_eq!(torque[2], Vec3::new(0.5 * radius[2], 0.0, 0.0));
}

/// Frames with a value file beside each, in both precisions, for the Python readers.
#[test]
fn frames_for_the_python_readers() {
    // With six spheres meshio takes the wrong block if the blocks lie in the order of their tags.
    let mut scene = scene(6);
    for (name, float64) in [("vtk-single", false), ("vtk-double", true)] {
        scene.output.float64 = float64;
        let directory = place(name);
        let options = Options::new(&directory, &scene);
        let mut results = Results::create(&scene, options).unwrap();
        let surface = Surface::new(&scene);
        for step in 0..=40 {
            let time = 0.01 * f64::from(step);
            let mut made = Made::new(&scene, time);
            if step == 20 {
                made.contacts.clear();
            }
            let state = made.observe(&scene, time);
            results.record(&state);
            if step % 10 == 0 {
                let grids = frame(&state, &surface);
                let value = expected(time, &grids);
                let path = directory.join(format!("expected_{:06}.json", step / 10));
                fs::write(path, serde_json::to_vec(&value).unwrap()).unwrap();
            }
        }
        let status = results.finish();
        assert_eq!((status.frames, status.rows, status.failures), (5, 41, 0));
    }
}

fn expected(time: f64, grids: &[(Series, Grid)]) -> serde_json::Value {
    let arrays = |arrays: &[Array]| {
        let map = arrays.iter().map(|array| {
            let values = match &array.values {
                Values::Real(values) => serde_json::json!(values),
                Values::Integer(values) => serde_json::json!(values),
            };
            let value = serde_json::json!({"components": array.components, "values": values});
            (array.name.to_owned(), value)
        });
        serde_json::Value::Object(map.collect())
    };
    let series = grids.iter().map(|(series, grid)| {
        let value = serde_json::json!({
            "points": grid.points,
            "connectivity": grid.connectivity,
            "point_data": arrays(&grid.point_data),
            "cell_data": arrays(&grid.cell_data),
        });
        (series.name().to_owned(), value)
    });
    serde_json::json!({"time": time, "series": serde_json::Value::Object(series.collect())})
}

#[test]
fn collections_name_frames_by_time() {
    let scene = scene(4);
    let directory = place("numbering");
    let mut results = Results::create(&scene, Options::new(&directory, &scene)).unwrap();
    // Points that miss the interval of 0.1 s, and two intervals at once.
    for time in [0.0, 0.03, 0.12, 0.18, 0.41, 0.1 + 0.2 + 0.2] {
        record(&mut results, &scene, time);
    }
    assert_eq!(results.finish().failures, 0);
    let names = |n: [u32; 4]| n.map(|n| format!("spheres_{n:06}.vtu"));
    let frames = listed(&directory.join("spheres.pvd"));
    assert_eq!(
        frames.iter().map(|f| f.1.clone()).collect::<Vec<_>>(),
        names([0, 1, 4, 5])
    );
    let times: Vec<f64> = frames.iter().map(|f| f.0).collect();
    assert_eq!(times, [0.0, 0.12, 0.41, 0.1 + 0.2 + 0.2], "17 digits");
}

/// Times in `history.csv`.
fn rows(directory: &Path) -> Vec<f64> {
    let mut table = csv::Reader::from_path(directory.join("history.csv")).unwrap();
    let columns = table.headers().unwrap().len();
    table
        .records()
        .map(|row| {
            let row = row.unwrap();
            assert_eq!(row.len(), columns);
            row[0].parse().unwrap()
        })
        .collect()
}

#[test]
fn rolling_back_drops_later_frames_and_rows() {
    let scene = scene(4);
    for hold in [false, true] {
        for told in [false, true] {
            let directory = place(&format!("rollback-{hold}-{told}"));
            let mut options = Options::new(&directory, &scene);
            options.hold = hold;
            let mut results = Results::create(&scene, options).unwrap();
            for k in 0..=6 {
                record(&mut results, &scene, 0.1 * f64::from(k));
            }
            if told {
                results.rollback(0.35);
                results.flush();
                let count = listed_or_none(&directory.join("spheres.pvd")).len();
                assert_eq!(count, if hold { 0 } else { 4 });
                assert!(!directory.join("spheres_000006.vtu").exists());
            }
            // A master that restored 0.3 s and takes another step length from there.
            for time in [0.35, 0.45] {
                record(&mut results, &scene, time);
            }
            assert_eq!(results.finish().failures, 0);
            let expected = [0.0, 0.1, 0.2, 0.1 * 3.0];
            let frames: Vec<f64> = listed(&directory.join("spheres.pvd"))
                .iter()
                .map(|f| f.0)
                .collect();
            assert_eq!(frames[..4], expected);
            assert_eq!(frames[4..], [0.45]);
            assert!(!directory.join("contacts_000006.vtu").exists());
            let table = rows(&directory);
            assert_eq!(table[..4], expected);
            assert_eq!(table[4..], [0.35, 0.45]);
        }
    }
}

fn listed_or_none(pvd: &Path) -> Vec<(f64, String)> {
    if pvd.exists() {
        listed(pvd)
    } else {
        Vec::new()
    }
}

#[test]
fn held_frames_reach_the_disk_when_committed() {
    let scene = scene(4);
    let directory = place("held");
    let mut options = Options::new(&directory, &scene);
    options.hold = true;
    let mut results = Results::create(&scene, options).unwrap();
    let pvd = directory.join("spheres.pvd");
    for k in 0..=4 {
        record(&mut results, &scene, 0.1 * f64::from(k));
    }
    results.flush();
    assert!(!pvd.exists());
    results.commit(0.2);
    results.flush();
    assert_eq!(listed(&pvd).len(), 3);
    assert_eq!(rows(&directory).len(), 3);
    // Without a word from the master the memory stays bounded: the oldest go out.
    for k in 5..=40 {
        record(&mut results, &scene, 0.1 * f64::from(k));
    }
    results.flush();
    assert_eq!(listed(&pvd).len(), 41 - 16);
    // And come back out of the files when the master rolls back further than that.
    results.rollback(1.0);
    results.flush();
    assert_eq!(listed(&pvd).len(), 11);
    drop(results);
    assert_eq!(rows(&directory).len(), 11);
}

#[test]
fn an_existing_run_is_refused_unless_overwritten() {
    let scene = scene(4);
    let directory = place("existing");
    let options = Options::new(&directory, &scene);
    let mut results = Results::create(&scene, options.clone()).unwrap();
    for time in [0.0, 0.1, 0.2] {
        record(&mut results, &scene, time);
    }
    drop(results);
    fs::write(directory.join("notes.txt"), "mine").unwrap();
    let error = Results::create(&scene, options.clone()).err().unwrap();
    assert!(matches!(error, OutputError::Exists { .. }), "{error}");
    let overwrite = Options {
        overwrite: true,
        ..options
    };
    let mut results = Results::create(&scene, overwrite).unwrap();
    record(&mut results, &scene, 0.0);
    drop(results);
    assert!(directory.join("notes.txt").exists());
    assert!(!directory.join("spheres_000002.vtu").exists());
    assert_eq!(rows(&directory), [0.0]);
    let about: serde_json::Value =
        serde_json::from_slice(&fs::read(directory.join("run.json")).unwrap()).unwrap();
    assert_eq!(about["title"], "a row");
    assert_eq!(about["settings"]["step"], 1e-3);
    assert_eq!(about["scene_hash"].as_str().unwrap().len(), 8);
}

#[test]
fn a_failing_disk_is_counted_and_does_not_stop_the_run() {
    let scene = scene(4);
    let directory = place("failing");
    let mut results = Results::create(&scene, Options::new(&directory, &scene)).unwrap();
    record(&mut results, &scene, 0.0);
    results.flush();
    // A directory in the way of a frame: it can be neither written nor replaced.
    fs::create_dir_all(directory.join("spheres_000001.vtu/blocked")).unwrap();
    for time in [0.1, 0.2] {
        record(&mut results, &scene, time);
    }
    let status = results.finish();
    assert_eq!((status.frames, status.rows, status.failures), (2, 3, 1));
    assert!(status.first_failure.unwrap().contains("spheres_000001.vtu"));
    assert_eq!(listed(&directory.join("spheres.pvd")).len(), 2);
}

#[test]
fn a_broken_state_is_not_written() {
    let scene = scene(4);
    let directory = place("broken");
    let mut results = Results::create(&scene, Options::new(&directory, &scene)).unwrap();
    let mut made = Made::new(&scene, 0.0);
    made.kinematics.position[2].x = f64::NAN;
    results.record(&made.observe(&scene, 0.0));
    let status = results.finish();
    // The row holds the potential energy, the frame the position.
    assert_eq!((status.frames, status.rows, status.failures), (0, 0, 2));
    assert!(!directory.join("spheres.pvd").exists());
}

const KILLED: &str = "SPHERE_DDA_TEST_KILLED_RUN";

/// Writes frames, and goes back every now and then, until it is killed: the child of the test below.
#[test]
#[ignore = "runs for ever: started and killed by a_killed_run_stays_readable"]
fn write_until_killed() {
    let scene = scene(500);
    let mut options = Options::new(std::env::var(KILLED).unwrap(), &scene);
    options.overwrite = true;
    let mut results = Results::create(&scene, options).unwrap();
    let mut step = 0;
    for count in 1.. {
        record(&mut results, &scene, 0.1 * f64::from(step));
        step = if count % 17 == 0 { step - 5 } else { step + 1 };
    }
}

#[test]
fn a_killed_run_stays_readable() {
    let directory = place("vtk-killed");
    let mut frames = 0;
    for round in 0..20 {
        let mut child = std::process::Command::new(std::env::current_exe().unwrap())
            .args(["write_until_killed", "--exact", "--ignored"])
            .env(KILLED, &directory)
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_micros(30_000 + 7_300 * round));
        child.kill().unwrap();
        child.wait().unwrap();
        for series in Series::ALL {
            let pvd = directory.join(format!("{}.pvd", series.name()));
            for (_, file) in listed_or_none(&pvd) {
                check_blocks(&fs::read(directory.join(file)).unwrap());
                frames += 1;
            }
        }
    }
    assert!(frames > 100, "only {frames} frames: the child hardly ran");
}
