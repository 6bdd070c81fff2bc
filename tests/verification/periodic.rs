//! The periodic cell: nothing notices where its faces are.

use sphere_dda::Vec3;
use sphere_dda::contact::{Contact, Partner};
use sphere_dda::formats::vtu::Values;
use sphere_dda::geometry::region::Primitive;
use sphere_dda::observe::Observation;
use sphere_dda::observe::sensors::region::Reading;
use sphere_dda::results::frames;
use sphere_dda::scene::particles::Locks;
use sphere_dda::scene::{Measure, PointLoad, Sensor};
use sphere_dda::solver::SolverKind;
use sphere_dda::spatial::cell::{Cell, HERE};

use crate::support::{Case, G, Run, close};

/// A cell from 0 to these edges \[m\]; 0: not periodic.
fn cell(edges: [f64; 3]) -> Cell {
    Cell::new(edges.map(|edge| (edge > 0.0).then_some([0.0, edge])))
}

fn in_cell(mut case: Case, edges: [f64; 3]) -> Case {
    case.scene.cell = cell(edges);
    case
}

/// Two spheres meet obliquely, with friction and restitution: the same as in an open scene when they meet across a face, an
/// edge or a corner of the cell, wherever it is and however far away their unwrapped positions are.
#[test]
fn a_collision_across_a_face_is_a_collision() {
    let speed = Vec3::new(2.0, 1.5, 1.0);
    let places = [Vec3::repeat(-0.2), Vec3::new(0.01, 0.03, 0.0)];
    let run = |offset: [Vec3; 2], edges: [f64; 3]| {
        let case = Case::new(1e-3, 0.3, 0.6)
            .without_gravity()
            .tolerance(1e-13, 1e-13, 1e-13)
            .sphere(0.1, places[0] + offset[0], speed)
            .sphere(0.1, places[1] + offset[1], Vec3::zeros());
        let mut run = in_cell(case, edges).start();
        run.steps(300);
        let velocity = [0, 1].map(|i| (run.velocity(i), run.spin(i)));
        (
            velocity,
            run.position(0) - offset[0],
            run.position(1) - offset[1],
        )
    };
    let open = run([Vec3::zeros(); 2], [0.0; 3]);
    assert!(
        (open.0[1].0).norm() > 1.0 && open.0[1].1.norm() > 1.0,
        "they collide"
    );
    let edges = [1.0, 0.75, 1.25];
    for images in [
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [-3.0, 2.0, 0.0],
        [5.0, -4.0, 7.0],
    ] {
        let apart = Vec3::from(images).component_mul(&Vec3::from(edges));
        for at in [
            Vec3::new(0.0, 0.4, 0.5),
            Vec3::zeros(),
            Vec3::new(0.9, 0.7, 1.2),
        ] {
            let found = run([at, at + apart], edges);
            for i in 0..2 {
                assert!(
                    (found.0[i].0 - open.0[i].0).norm() < 1e-11,
                    "{images:?} {at:?}"
                );
                assert!(
                    (found.0[i].1 - open.0[i].1).norm() < 1e-10,
                    "{images:?} {at:?}"
                );
            }
            assert!((found.1 - open.1).norm() < 1e-12 && (found.2 - open.2).norm() < 1e-12);
        }
    }
}

/// A row of three spheres in a cell of 6 R and a little more, pushed by f on the last and -f on the first:
///
/// ```text
///      f -> (0) (1) (2) <- f |        contacts 0-1 and 1-2 carry f, the third is open
///      <- f (0) (1) (2) f -> | (0)    2 and the next copy of 0 carry f, the others are open
/// ```
#[test]
fn a_row_closes_on_itself() {
    let (radius, f, edge) = (0.1, 20.0, 0.6 + 1e-3);
    for (push, expected) in [(f, [f, 0.0, f]), (-f, [0.0, f, 0.0])] {
        for solver in [SolverKind::Auto, SolverKind::Direct] {
            let mut case = Case::new(1e-3, 0.3, 0.0)
                .without_gravity()
                .tolerance(1e-10, 1e-10, 1e-10)
                .settings(|s| s.solver = solver);
            for i in 0..3 {
                let gap = if push > 0.0 {
                    0.0
                } else {
                    0.5e-3 * f64::from(i)
                };
                case = case.sphere(
                    radius,
                    Vec3::x() * (0.2 * f64::from(i) + gap),
                    Vec3::zeros(),
                );
            }
            for (sphere, sign) in [(0, 1.0), (2, -1.0)] {
                case.scene.loads.push(PointLoad {
                    sphere,
                    arm: Vec3::zeros(),
                    force: Vec3::x() * (sign * push),
                });
            }
            let mut run = in_cell(case, [edge, 0.0, 0.0]).start();
            run.steps(20);
            // Keys 0-1, 0-2 through the face, 1-2.
            let force = |i: u32, j: u32, image: [i32; 3]| {
                let partner = Partner::Sphere { index: j, image };
                let contacts = run.simulation.contacts().into_iter();
                contacts
                    .filter(|c| c.key.sphere == i && c.key.partner == partner)
                    .map(|c| c.force.norm())
                    .sum::<f64>()
            };
            let found = [
                force(0, 1, [0; 3]),
                force(0, 2, [-1, 0, 0]),
                force(1, 2, [0; 3]),
            ];
            for k in 0..3 {
                close(found[k], expected[k], 1e-8, f);
            }
            assert!((0..3).all(|i| run.velocity(i).norm() < 1e-9));
        }
    }
}

/// A sphere rests in the saddle between a sphere on the floor and that sphere's next copy, an edge L away: it touches the same
/// sphere twice. `sin a = L / (4 R)`, `2 N cos a = m g`; the floor carries both weights.
///
/// ```text
///        (1)          N at an angle a from the vertical
///     (0)   (0')      at a distance L
/// ```
#[test]
fn a_sphere_touches_two_copies_of_its_neighbour() {
    let (radius, edge) = (0.1, 0.31);
    let sin: f64 = edge / (4.0 * radius);
    let cos = (1.0 - sin * sin).sqrt();
    for solver in [
        SolverKind::Auto,
        SolverKind::GaussSeidel,
        SolverKind::Direct,
    ] {
        let case = Case::new(1e-3, 0.0, 0.0)
            .tolerance(1e-9, 1e-9, 1e-9)
            .settings(|s| s.solver = solver)
            .floor()
            .sphere(radius, Vec3::new(0.0, 0.0, radius), Vec3::zeros())
            .sphere(
                radius,
                Vec3::new(0.5 * edge, 0.0, radius + 2.0 * radius * cos),
                Vec3::zeros(),
            );
        let mut run = in_cell(case, [edge, 0.0, 0.0]).start();
        run.steps(20);
        let weight = run.mass(0) * G;
        let forces: Vec<f64> = run.simulation.contacts()[..2]
            .iter()
            .map(|c| c.force.norm())
            .collect();
        for force in forces {
            close(force, weight / (2.0 * cos), 1e-7, weight);
        }
        close(-run.force_on_boundary(0).z, 2.0 * weight, 1e-8, weight);
    }
}

/// Three spheres that bounce on a floor, slide and collide through the faces: moved by any vector along the cell, they do
/// the same, to 1e-9 after half a second.
#[test]
fn a_scene_may_be_moved_in_its_cell() {
    let run = |by: Vec3, edges: [f64; 3]| {
        let mut case = Case::new(1e-3, 0.3, 0.4)
            .tolerance(1e-11, 1e-11, 1e-11)
            .floor();
        for (place, velocity) in [
            ([0.1, 0.1, 0.1], [1.5, 0.2, 0.0]),
            ([0.35, 0.12, 0.15], [0.0, 0.0, 0.0]),
            ([0.2, 0.33, 0.1], [0.0, -1.0, 0.0]),
        ] {
            case = case.sphere(0.1, Vec3::from(place) + by, Vec3::from(velocity));
        }
        let mut run = in_cell(case, edges).start();
        run.steps(500);
        [0, 1, 2].map(|i| run.position(i) - by)
    };
    let edges = [0.5, 0.45, 0.0];
    let still = run(Vec3::zeros(), edges);
    let open = run(Vec3::zeros(), [0.0; 3]);
    assert!(
        (0..3).any(|i| (open[i] - still[i]).norm() > 0.01),
        "they meet through faces"
    );
    for by in [[0.25, 0.0, 0.0], [-0.11, 3.77, 0.0], [0.49, -0.31, 0.0]] {
        let moved = run(Vec3::from(by), edges);
        for i in 0..3 {
            assert!(
                (moved[i] - still[i]).norm() < 1e-9,
                "{by:?} {i} {:e}",
                (moved[i] - still[i]).norm()
            );
        }
    }
}

/// Two layers of spheres that do not roll slide down a slope without end, through the faces, and come to rest, friction being
/// larger than the slope's. The momentum balance holds in every step (`Run::step`); at rest the floor carries the weight along
/// and across the slope.
#[test]
fn a_bed_on_a_slope_without_end() {
    let (slope, edges) = (0.2f64, [0.63, 0.42, 0.0]);
    let mut case = Case::new(2e-3, 0.6, 0.0)
        .tolerance(1e-6, 1e-6, 1e-5)
        .settings(|s| s.gravity = Vec3::new(slope.sin(), 0.0, -slope.cos()) * G)
        .floor();
    for k in 0..12 {
        let (i, j, layer) = (k % 3, k / 3 % 2, k / 6);
        let odd = f64::from(layer);
        let place = Vec3::new(
            0.21 * f64::from(i) + 0.05 * odd,
            0.21 * f64::from(j) + 0.04 * odd,
            0.1 + 0.2 * odd,
        );
        let (velocity, locks) = (Vec3::x() * 2.0, Locks::ROTATIONS);
        case = case.body(0.095, place, velocity, Vec3::zeros(), locks);
    }
    let mut run = in_cell(case, edges).start();
    let mut across = 0;
    for _ in 0..500 {
        run.step();
        let contacts = run.simulation.contacts().into_iter();
        across += contacts.filter(through_a_face).count();
        assert!(run.simulation.report().max_overlap <= 1e-6);
    }
    assert!(across > 100, "{across} contacts through faces");
    assert!(run.position(0).x > 0.3, "they slide: {}", run.position(0).x);
    assert!((0..12).all(|i| run.velocity(i).norm() < 1e-3), "they rest");
    let weight: f64 = (0..12).map(|i| run.mass(i) * G).sum();
    let floor = run.simulation.mean_wrench(0).force;
    close(floor.x, weight * slope.sin(), 1e-4, weight);
    close(floor.z, -weight * slope.cos(), 1e-4, weight);
}

fn through_a_face(contact: &Contact) -> bool {
    matches!(contact.key.partner, Partner::Sphere { image, .. } if image != HERE)
}

/// A box that stands in the cell is met by what comes through the faces, also after many turns: a sphere that flies round
/// and round rebounds from it like from the box itself, and a box that moves through a face is met where its copy is.
#[test]
fn obstacles_have_copies() {
    use sphere_dda::geometry::{Facets, Geometry, Shape};
    use sphere_dda::scene::Boundary;
    use sphere_dda::scene::Motion;
    use sphere_dda::spatial::Twist;
    let run = |start: f64, speed: f64, wall: f64, steps: usize| {
        let faces = Facets::cuboid(Vec3::new(0.4, -1.0, -1.0), Vec3::new(0.6, 1.0, 1.0)).unwrap();
        let mut case = Case::new(1e-3, 0.0, 1.0)
            .without_gravity()
            .tolerance(1e-12, 1e-12, 1e-12)
            .sphere(0.1, Vec3::x() * start, Vec3::x() * speed);
        case.scene.boundaries.push(Boundary {
            name: "box".into(),
            material: 1,
            geometry: Geometry::new(vec![Shape::Facets(faces)]).unwrap(),
            motion: Motion::Constant(Twist {
                linear: Vec3::x() * wall,
                angular: Vec3::zeros(),
            }),
            point_of_action: Vec3::zeros(),
            stiffness: None,
            belt: None,
            wall_fields: false,
        });
        let mut run = in_cell(case, [1.0, 0.0, 0.0]).start();
        run.steps(steps);
        run
    };
    // From 0.1 + k to the face of the box at 0.4 + k, 0.2 m at 1 m/s, and back; e = 1.
    for k in [0.0, 1.0, -7.0] {
        let found = run(0.1 + k, 1.0, 0.0, 600);
        close(found.velocity(0).x, -1.0, 1e-9, 1.0);
        assert!((found.position(0).x - (0.3 + k - 0.4)).abs() < 2.1e-3);
    }
    // The box runs at 2 m/s after a sphere at rest at 0.9: its face at 0.6 touches after 0.1 s, the sphere rebounds with 4 m/s. It
    // gains the 0.6 m to the back of the box's copy in another 0.3 s, and rebounds to rest.
    for k in [0.0, -3.0] {
        for (steps, speed) in [(99, 0.0), (300, 4.0), (500, 0.0)] {
            let found = run(0.9 + k, 0.0, 2.0, steps);
            close(found.velocity(0).x, speed, 1e-9, 1.0);
        }
    }
}

/// Frames show the spheres in the cell, with the image they are in; probes and states keep the unwrapped path.
#[test]
fn frames_are_wrapped() {
    let case = Case::new(0.01, 0.0, 0.0)
        .without_gravity()
        .body(
            0.1,
            Vec3::new(0.9, 0.3, 0.0),
            Vec3::new(3.0, -1.0, 2.0),
            Vec3::zeros(),
            Locks::default(),
        )
        .sphere(0.1, Vec3::new(0.5, 0.3, 9.0), Vec3::zeros());
    let mut run: Run = in_cell(case, [1.0, 0.5, 0.0]).start();
    run.steps(100);
    let place = run.position(0);
    assert!((place - Vec3::new(3.9, -0.7, 2.0)).norm() < 1e-12);
    let grid = frames::spheres(&Observation::of(&run.simulation));
    assert!((grid.points[0] - Vec3::new(0.9, 0.3, 2.0)).norm() < 1e-12);
    let image = grid
        .point_data
        .iter()
        .find(|array| array.name == "image")
        .expect("an array");
    assert_eq!(image.values, Values::Integer(vec![3, -2, 0, 0, 0, 0]));
}

/// What sensors see does not depend on where in the cell they look: in a row of three spheres with one contact, through the face,
/// of force f and branch 2 R, a region as wide as the cell holds three spheres, `f 2 R / V` of stress and two ends of contacts.
#[test]
fn regions_see_copies() {
    let (radius, f, edge) = (0.1, 20.0, 0.6 + 1e-3);
    let mut case = Case::new(1e-3, 0.0, 0.0)
        .without_gravity()
        .tolerance(1e-10, 1e-10, 1e-10);
    for i in 0..3 {
        case = case.sphere(radius, Vec3::x() * (0.2005 * f64::from(i)), Vec3::zeros());
    }
    for (sphere, sign) in [(0, -f), (2, f)] {
        case.scene.loads.push(PointLoad {
            sphere,
            arm: Vec3::zeros(),
            force: Vec3::x() * sign,
        });
    }
    let mut run = in_cell(case, [edge, 0.0, 0.0]).start();
    run.steps(20);
    let ball = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    for at in [0.0, -0.1, 0.25, 7.123] {
        let region = Primitive::Box {
            min: Vec3::new(at, -0.2, -0.2),
            max: Vec3::new(at + edge, 0.2, 0.2),
        };
        let reading = Reading::of(&region, &Observation::of(&run.simulation));
        let volume = 0.16 * edge;
        assert_eq!(reading.count, 3, "{at}");
        close(reading.solid_fraction, 3.0 * ball / volume, 1e-12, 1.0);
        close(reading.stress[0], f * 2.0 * radius / volume, 1e-7, 1.0);
        close(reading.coordination_number, 2.0 / 3.0, 1e-15, 1.0);
        close(reading.mean_normal_force, f, 1e-8, f);
    }
}

/// A sphere goes round the cell three times and a quarter: it passes a plane across its way and a polygon there three times, a
/// plane along its way never, and one beside it, whose copies it meets too, as often as itself.
#[test]
fn gates_have_copies() {
    let square =
        |x: f64| [[0.1, 0.1], [0.4, 0.1], [0.4, 0.4], [0.1, 0.4]].map(|[y, z]| Vec3::new(x, y, z));
    let flow = |point: Vec3, normal: Vec3, outline: Vec<Vec3>| Measure::MassFlow {
        point,
        normal,
        outline,
    };
    let mut case = Case::new(0.01, 0.0, 0.0).without_gravity().sphere(
        0.1,
        Vec3::new(0.5, 0.25, 0.25),
        Vec3::x() * 3.25,
    );
    let gates = [
        (flow(Vec3::x() * 0.2, Vec3::x(), vec![]), 3.0),
        (flow(Vec3::x() * 0.2, -Vec3::x(), vec![]), -3.0),
        (flow(Vec3::x() * 1000.2, Vec3::x(), vec![]), 3.0),
        (flow(Vec3::x() * 0.2, Vec3::x(), square(0.2).to_vec()), 3.0),
        (
            flow(
                Vec3::x() * 0.2,
                Vec3::x(),
                square(0.2).map(|x| x + Vec3::y() * 0.3).to_vec(),
            ),
            0.0,
        ),
        (flow(Vec3::y() * 0.3, Vec3::y(), vec![]), 0.0),
    ];
    for (k, (measure, _)) in gates.iter().enumerate() {
        case.scene.sensors.push(Sensor {
            name: format!("gate{k}"),
            measure: measure.clone(),
        });
    }
    let mut run = in_cell(case, [1.0, 0.0, 0.5]).start();
    run.steps(100);
    for (passed, (_, times)) in run.simulation.state().passed.iter().zip(&gates) {
        close(*passed, times * run.mass(0), 1e-14, 1.0);
    }
}
