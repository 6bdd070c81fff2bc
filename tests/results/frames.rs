//! The grids of a frame, and frames left behind for the Python readers.

use std::fs;

use sphere_dda::Vec3;
use sphere_dda::formats::vtu::{Array, Cell, Grid, Precision, Values, encode};
use sphere_dda::observe::loads::{BodyLoad, Loads};
use sphere_dda::results::Options;
use sphere_dda::results::frames::{Series, Surface, contacts, frame};
use sphere_dda::results::writer::Results;
use sphere_dda::scene::Scene;
use sphere_dda::scene::materials::Pair;

use crate::made::{Made, place, scene};
use crate::vtu::check_blocks;

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
    // Points without a cell would show arbitrary values where cell data become point data.
    assert_eq!(empty.points.len(), 1);
    let units = full.cell_data.iter().map(|a| (a.name, a.unit));
    assert!(units.clone().any(|unit| unit == ("force", "N")));
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
    let loads = Loads::new(&state, 0..4);
    let wrench = |i: usize| loads.spheres[i].wrench;
    // Sphere 0 is pushed by 1 and by the floor, 1 by 0 alone.
    assert_eq!(wrench(0).force, Vec3::new(1.0, 0.0, 5.0));
    assert_eq!(wrench(1).force, Vec3::new(-1.0, 0.0, -2.0));
    // -R n x f with n = z: f_x at the lowest point of 0 turns it about -y, and 1, pushed at its top, likewise.
    let radius = &scene.particles.radius;
    // The couple of their resistance acts on 0, its opposite on 1.
    let couple = Vec3::new(0.0, 0.25, 0.125);
    assert_eq!(wrench(0).torque, Vec3::new(0.0, -radius[0], 0.0) + couple);
    assert_eq!(wrench(1).torque, Vec3::new(0.0, -radius[1], 0.0) - couple);
    assert_eq!(wrench(2).torque, Vec3::new(0.5 * radius[2], 0.0, 0.0));
    // Normal forces 2 and 3 on sphere 0, 3 and 4 on the floor; the candidate on sphere 3 carries nothing.
    let counted = |load: &BodyLoad| (load.count, load.max_normal_force);
    assert_eq!(counted(&loads.spheres[0]), (2, 3.0));
    assert_eq!(counted(&loads.boundaries[0]), (2, 4.0));
    assert_eq!(counted(&loads.spheres[3]), (0, 0.0));
    assert_eq!(loads.contacts, 3);
}

#[test]
fn couples_are_shown_where_the_scene_has_them() {
    let mut scene = scene(4);
    let torque = |scene: &Scene| {
        let made = Made::new(scene, 0.0);
        let grid = contacts(&made.observe(scene, 0.0));
        let array = grid.cell_data.into_iter().find(|a| a.name == "torque");
        array.map(|array| array.values)
    };
    assert_eq!(torque(&scene), None);
    let pair = Pair {
        rolling_friction: 0.1,
        ..scene.pairs.get(0, 0)
    };
    scene.pairs.set(0, 0, pair);
    let expected = [0.0, 0.25, 0.125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(torque(&scene), Some(Values::Real(expected.to_vec())));
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
