//! Regions and the closed meshes among them, against closed forms.

use nalgebra::UnitQuaternion;
use proptest::prelude::*;
use sphere_dda::Vec3;
use sphere_dda::geometry::region::{Primitive, Region};
use sphere_dda::geometry::{Facets, GeometryError, Solid};

/// A cube of side 2 around the origin, its triangles' vertices in the order given by bits.
fn cube(flips: u32) -> Facets {
    let mut cube = Facets::cuboid(Vec3::repeat(-1.0), Vec3::repeat(1.0)).unwrap();
    for (k, triangle) in cube.triangles.iter_mut().enumerate() {
        if flips >> k & 1 == 1 {
            triangle.swap(0, 1);
        }
    }
    cube
}

fn joined(parts: &[&Facets]) -> Facets {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for part in parts {
        let first = vertices.len() as u32;
        vertices.extend(&part.vertices);
        triangles.extend(part.triangles.iter().map(|t| t.map(|v| v + first)));
    }
    Facets::mesh("joined", vertices, triangles)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn a_turned_cube_is_what_its_six_planes_say(
        flips in any::<u32>(),
        turn in prop::array::uniform3(-3.0..3.0_f64),
        at in prop::array::uniform3(-1.6..1.6_f64),
        shift in prop::array::uniform3(-50.0..50.0_f64),
    ) {
        let rotation = UnitQuaternion::from_scaled_axis(Vec3::from(turn));
        let solid = Solid::new(cube(flips).placed(0.5, rotation, shift.into())).unwrap();
        prop_assert!((solid.volume() - 1.0).abs() < 1e-9);
        let local = Vec3::from(at) * 0.5;
        let x = rotation * local + Vec3::from(shift);
        let room = 0.5 - local.amax();
        prop_assume!(room.abs() > 1e-9);
        prop_assert_eq!(solid.contains(x), room > 0.0);
        // Inside, the closest point of a cube's surface lies on the nearest of its planes.
        if room > 0.0 {
            prop_assert!(solid.holds(x, 0.999 * room));
            prop_assert!(!solid.holds(x, 1.001 * room));
        }
    }

    #[test]
    fn a_confined_sphere_is_held(
        which in 0..2,
        at in prop::array::uniform3(-0.9..0.9_f64),
        radius in 0.05..0.4_f64,
    ) {
        let axis = Vec3::new(1.0, 2.0, -2.0) / 3.0;
        let region: Region = match which {
            0 => Primitive::Box { min: Vec3::repeat(-1.0), max: Vec3::repeat(1.0) }.into(),
            _ => Primitive::Cylinder { base: -axis, axis, radius: 1.0, height: 2.0 }.into(),
        };
        let x = Vec3::from(at);
        let place = region.confine(x, radius, &mut Vec::new());
        prop_assert!(region.holds(place, radius));
        if region.holds(x, radius) {
            prop_assert!((place - x).norm() <= 1e-9);
        }
        prop_assert!(region.contains(place) && !region.holds(place, 1.01));
        let (low, high) = region.bounds().unwrap();
        prop_assert!((0..3).all(|k| low[k] <= place[k] - radius && place[k] + radius <= high[k]));
    }
}

/// Rays through vertices, along edges and in facets: all points of a lattice that shares its planes with the mesh.
#[test]
fn rays_through_edges_and_corners_count_once() {
    let octahedron = {
        let axis = |k: usize, s: f64| Vec3::from_fn(|i, _| if i == k { s } else { 0.0 });
        let vertices: Vec<Vec3> = (0..6)
            .map(|v| axis(v / 2, 1.0 - 2.0 * (v % 2) as f64))
            .collect();
        let triangles = (0..8_u32)
            .map(|k| [k & 1, 2 + (k >> 1 & 1), 4 + (k >> 2 & 1)])
            .collect();
        Facets::mesh("octahedron", vertices, triangles)
    };
    type Room = fn(Vec3) -> f64;
    let diamond: Room = |x| 1.0 - x.abs().sum();
    let box_of_two: Room = |x| 1.0 - x.amax();
    for (facets, room) in [(octahedron, diamond), (cube(0), box_of_two)] {
        let name = facets.name.clone();
        let solid = Solid::new(facets).unwrap();
        for k in 0..13_i32.pow(3) {
            let x = Vec3::new((k % 13) as f64, (k / 13 % 13) as f64, (k / 169) as f64) * 0.25;
            let x = x.add_scalar(-1.5);
            if room(x) != 0.0 {
                assert_eq!(solid.contains(x), room(x) > 0.0, "{name} {x}");
            }
        }
    }
}

#[test]
fn volumes_are_the_closed_forms() {
    // A regular tetrahedron of side sqrt(8) has 8/3 m^3.
    let corners = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    let corners = corners.map(Vec3::from).to_vec();
    let triangles = vec![[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
    let tetrahedron = Solid::new(Facets::mesh("t", corners, triangles)).unwrap();
    assert!((tetrahedron.volume() - 8.0 / 3.0).abs() < 1e-12);

    // A cavity is taken away, a body in the cavity and one beside it are added.
    let at =
        |scale: f64, x: f64| cube(0b1010).placed(scale, UnitQuaternion::identity(), Vec3::x() * x);
    let (hole, core, beside) = (at(0.5, 0.0), at(0.25, 0.0), at(0.5, 3.0));
    let solid = Solid::new(joined(&[&cube(0), &hole, &core, &beside])).unwrap();
    assert!((solid.volume() - (8.0 - 1.0 + 0.125 + 1.0)).abs() < 1e-12);
    let inside = [0.0, 0.3, 0.7, 1.2, 3.0].map(|x| solid.contains(Vec3::new(x, 0.0, 0.0)));
    assert_eq!(inside, [true, false, true, false, true]);
    assert_eq!(
        solid.bounds(),
        (Vec3::repeat(-1.0), Vec3::new(3.5, 1.0, 1.0))
    );
}

#[test]
fn random_places_fill_a_mesh_evenly() {
    use rand_chacha::rand_core::SeedableRng;
    let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(1);
    let region = Region::Mesh(Solid::new(cube(0)).unwrap().into());
    let mut octants = [0_i32; 8];
    for _ in 0..8000 {
        let place = region.random_centre(0.3, &mut random).unwrap();
        assert!(region.holds(place, 0.3));
        octants[(0..3)
            .map(|k| usize::from(place[k] > 0.0) << k)
            .sum::<usize>()] += 1;
    }
    // Four standard deviations of a binomial count.
    assert!(
        octants.iter().all(|n| (n - 1000).abs() < 4 * 30),
        "{octants:?}"
    );
    assert_eq!(region.random_centre(1.01, &mut random), None);
}

#[test]
fn an_open_mesh_names_an_edge() {
    let mut open = cube(0);
    open.triangles.pop();
    let Err(GeometryError::Open { edges, edge, .. }) = Solid::new(open.clone()) else {
        panic!("an open mesh was accepted");
    };
    assert_eq!(edges, 3);
    let removed = [1, 7, 5].map(|v| open.vertices[v]);
    assert!(edge.iter().all(|end| removed.contains(end)), "{edge:?}");
}

#[test]
fn a_solid_survives_its_text() {
    let region = Region::Mesh(Solid::new(cube(0)).unwrap().into());
    let text = serde_json::to_string(&region).unwrap();
    assert_eq!(serde_json::from_str::<Region>(&text).unwrap(), region);
}
