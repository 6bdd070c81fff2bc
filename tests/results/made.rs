//! A synthetic scene and states of it that no solver made, and the directories they are written to.

use std::fs;
use std::path::{Path, PathBuf};

use nalgebra::UnitQuaternion;
use sphere_dda::Vec3;
use sphere_dda::contact::cohesion::Hold;
use sphere_dda::contact::{Contact, ContactId, Partner};
use sphere_dda::geometry::region::Primitive;
use sphere_dda::geometry::{Facets, Geometry, HalfSpace, Shape};
use sphere_dda::integrator::Integrator;
use sphere_dda::observe::{BoundaryState, Observation};
use sphere_dda::results::writer::Results;
use sphere_dda::scene::Boundary;
use sphere_dda::scene::Motion;
use sphere_dda::scene::materials::{Material, Pair, PairTable};
use sphere_dda::scene::particles::{Kinematics, Locks, Particles};
use sphere_dda::scene::{Measure, Method, Output, Scene, Sensor, Settings};
use sphere_dda::solver::{SolverKind, Tolerance};
use sphere_dda::spatial::SpatialVector;
use sphere_dda::spatial::Wrench;
use sphere_dda::spatial::cell::Cell;
use sphere_dda::spatial::{Pose, Twist};
use sphere_dda::state::EnergyLedger;
use sphere_dda::state::JointState;
use sphere_dda::state::StepReport;
use sphere_dda::state::Velocities;
use sphere_dda::state::Walls;

/// A row of `n` spheres above a floor and a box, with one sensor of each kind.
pub(crate) fn scene(n: usize) -> Scene {
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
        belt: None,
        wall_fields: false,
    };
    Scene {
        title: "a row".to_owned(),
        about: Default::default(),
        hash: "0".repeat(64),
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
            threads: 1,
            opening: 0.0,
            strict: true,
            ..Settings::default()
        },
        materials: vec![Material {
            name: "glass".to_owned(),
            density: 2500.0,
        }],
        pairs: PairTable::new(1, Pair::default()),
        particles,
        clumps: Vec::new(),
        initial,
        initial_contacts: Default::default(),
        parameters: Vec::new(),
        cell: Cell::default(),
        boundaries: vec![boundary("floor", floor()), boundary("crate", crate_box())],
        loads: Vec::new(),
        springs: Vec::new(),
        sources: Vec::new(),
        sinks: Vec::new(),
        sensors: vec![
            Sensor {
                name: "hold".to_owned(),
                measure: Measure::Region(Primitive::Box {
                    min: Vec3::repeat(-0.15),
                    max: Vec3::repeat(0.15),
                }),
            },
            Sensor {
                name: "outflow".to_owned(),
                measure: Measure::MassFlow {
                    point: Vec3::zeros(),
                    normal: Vec3::z(),
                    outline: Vec::new(),
                },
            },
        ],
        probes: Vec::new(),
        output: Output {
            vtu_interval: 0.1,
            csv_interval: 0.0,
            float64: false,
            checkpoint_interval: 0.0,
        },
        exposed: Default::default(),
    }
}

fn floor() -> Geometry {
    let up = HalfSpace::new(Vec3::zeros(), Vec3::z()).unwrap();
    Geometry::new(vec![Shape::HalfSpace(up)]).unwrap()
}

fn crate_box() -> Geometry {
    let walls = Facets::cuboid(Vec3::new(-0.2, -1.2, 0.0), Vec3::new(2.0, 1.2, 0.5)).unwrap();
    Geometry::new(vec![Shape::Facets(walls)]).unwrap()
}

/// Twist of all spheres and boundaries.
const TWIST: Twist = Twist {
    linear: Vec3::new(0.1, 0.2, 0.3),
    angular: Vec3::new(0.0, 0.0, 1.0),
};

/// Positions and contacts of a state that no solver made.
pub(crate) struct Made {
    pub(crate) kinematics: Kinematics,
    /// What makes the reported twist of each sphere [`TWIST`], if the kinematics' own is zero.
    pub(crate) persisting: Vec<SpatialVector>,
    pub(crate) contacts: Vec<Contact>,
    pub(crate) passed: Vec<f64>,
    pub(crate) emitted: Vec<f64>,
    pub(crate) removed: Vec<f64>,
    walls: Walls,
}

impl Made {
    pub(crate) fn new(scene: &Scene, time: f64) -> Self {
        let mut kinematics = scene.initial.clone();
        for (i, position) in kinematics.position.iter_mut().enumerate() {
            position.y = (3.0 * time + i as f64).sin();
            kinematics.orientation[i] = UnitQuaternion::from_scaled_axis(Vec3::new(0.0, 0.0, time));
        }
        let contact = |sphere, partner, force| Contact {
            key: ContactId { sphere, partner },
            point: Vec3::new(0.2 * f64::from(sphere), 0.3, 0.0),
            normal: Vec3::z(),
            gap: -1e-7,
            force,
            torque: Vec3::zeros(),
            hold: Hold::Loose,
        };
        let floor = Partner::Boundary {
            boundary: 0,
            feature: 0,
        };
        let mut contacts = vec![
            Contact {
                torque: Vec3::new(0.0, 0.25, 0.125),
                ..contact(0, Partner::sphere(1), Vec3::new(1.0, 0.0, 2.0 + time))
            },
            contact(0, floor, Vec3::new(0.0, 0.0, 3.0)),
            contact(2, floor, Vec3::new(0.0, 0.5, 4.0)),
        ];
        // A candidate that does not touch must not appear.
        contacts.push(Contact {
            gap: 0.01,
            ..contact(3, floor, Vec3::zeros())
        });
        let persisting = SpatialVector {
            linear: TWIST.linear,
            angular: TWIST.angular,
        };
        Self {
            kinematics,
            persisting: vec![persisting; scene.particles.len()],
            contacts,
            passed: vec![0.0; scene.sensors.len()],
            emitted: vec![0.0; scene.sources.len()],
            removed: vec![0.0; scene.sinks.len()],
            walls: Walls::default(),
        }
    }

    pub(crate) fn observe<'a>(&'a self, scene: &'a Scene, time: f64) -> Observation<'a> {
        Observation {
            scene,
            time,
            gravity: scene.settings.gravity,
            body_force: Vec3::zeros(),
            kinematics: &self.kinematics,
            velocities: Velocities {
                kinematics: &self.kinematics,
                smooth: &self.persisting,
                integrator: Integrator::Moreau,
                // As long as the scene's: the half-step velocity is then that of the kinematics.
                last: 2.0,
                step: 2.0,
            },
            contacts: self.contacts.clone(),
            boundaries: vec![
                BoundaryState {
                    pose: Pose {
                        translation: Vec3::new(0.0, 0.0, 0.1 * time),
                        rotation: UnitQuaternion::identity(),
                    },
                    twist: TWIST,
                    surface_velocity: Vec3::zeros(),
                    wrench: Wrench {
                        force: Vec3::new(0.0, -0.5, -7.0),
                        torque: Vec3::zeros(),
                    },
                    mean_wrench: Wrench::default(),
                    joint: JointState::default(),
                };
                scene.boundaries.len()
            ],
            passed: &self.passed,
            flow: &self.passed,
            emitted: &self.emitted,
            removed: &self.removed,
            walls: &self.walls,
            broken_bonds: 0,
            work: EnergyLedger::default(),
            report: StepReport::default(),
        }
    }
}

pub(crate) fn record(results: &mut Results, scene: &Scene, time: f64) {
    results.record(&Made::new(scene, time).observe(scene, time));
}

/// A new directory below the target directory, kept after the test.
pub(crate) fn place(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if path.exists() {
        fs::remove_dir_all(&path).unwrap();
    }
    path
}

/// Times and files that a collection lists.
pub(crate) fn listed(pvd: &Path) -> Vec<(f64, String)> {
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

pub(crate) fn listed_or_none(pvd: &Path) -> Vec<(f64, String)> {
    if pvd.exists() {
        listed(pvd)
    } else {
        Vec::new()
    }
}
