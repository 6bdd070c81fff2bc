use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, Geometry};

use super::{close, closest_points, geometry, same, v};

/// A jittered grid over the unit square at the height `z(x, y)`, every cell split along a random diagonal, every
/// triangle turned a random way round.
fn random_sheet(n: usize, seed: u64, z: impl Fn(f64, f64) -> f64) -> Facets {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut vertices = Vec::new();
    for j in 0..=n {
        for i in 0..=n {
            let mut shift = |k: usize| {
                let inner = k > 0 && k < n;
                (k as f64
                    + if inner {
                        rng.random_range(-0.3..0.3)
                    } else {
                        0.0
                    })
                    / n as f64
            };
            let (x, y) = (shift(i), shift(j));
            vertices.push(v(x, y, z(x, y)));
        }
    }
    let mut triangles = Vec::new();
    let at = |i: usize, j: usize| (j * (n + 1) + i) as u32;
    for j in 0..n {
        for i in 0..n {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            let halves = if rng.random() {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            };
            for [p, q, r] in halves {
                triangles.push(if rng.random() { [p, q, r] } else { [q, p, r] });
            }
        }
    }
    Facets::mesh("sheet", vertices, triangles)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// A flat sheet is one face, wherever its joints are, also after rounding its vertices to single precision.
    #[test]
    fn rolling_over_a_triangulated_plane_meets_no_joint(
        seed in any::<u64>(),
        turn in prop::array::uniform3(-3.0..3.0f64),
        single in any::<bool>(),
    ) {
        let rotation = nalgebra::UnitQuaternion::from_scaled_axis(Vec3::from(turn));
        let mut sheet = random_sheet(6, seed, |_, _| 0.0).placed(1.0, rotation, v(0.3, 0.2, 0.1));
        let slack = if single {
            for p in &mut sheet.vertices {
                *p = p.map(|x| f64::from(x as f32));
            }
            sheet.rounding = 2e-7;
            1e-5
        } else {
            1e-12
        };
        let up = rotation * Vec3::z();
        let corners = sheet.vertices.clone();
        let edges: Vec<Vec3> = sheet.triangles.iter().map(|t| 0.5 * (corners[t[0] as usize] + corners[t[1] as usize])).collect();
        let plane = geometry([sheet]);
        let local = |p: &Vec3| rotation.inverse() * (p - v(0.3, 0.2, 0.1));
        let inner = |p: &&Vec3| local(p).x > 1e-3 && local(p).x < 0.999 && local(p).y > 1e-3 && local(p).y < 0.999;
        let line = (1..200).map(|k| rotation * v(0.005 * f64::from(k), 0.9 - 0.004 * f64::from(k), 0.0) + v(0.3, 0.2, 0.1));
        let feet: Vec<Vec3> = corners.iter().chain(&edges).filter(inner).copied().chain(line).collect();
        let first = closest_points(&plane, feet[0] + up * 0.2, 0.2, 0.05);
        for foot in feet {
            let found = closest_points(&plane, foot + up * 0.2, 0.2, 0.05);
            prop_assert_eq!(found.len(), 1, "{:?}: {:?}", local(&foot), found);
            prop_assert_eq!(found[0].feature, first[0].feature);
            prop_assert_eq!(found[0].normal, first[0].normal);
            prop_assert!(found[0].gap.abs() < slack, "{}", found[0].gap);
        }
    }

    /// On a rough sheet, against samples of it: the nearest touch is the nearest point, every touch is a local
    /// minimum of the distance, and every local minimum is a touch.
    #[test]
    fn touches_are_the_local_minima_of_the_sampled_distance(
        seed in any::<u64>(),
        centre in (0.1..0.9f64, 0.1..0.9f64, 0.25..0.5f64),
    ) {
        let sheet = random_sheet(5, seed, |x, y| 0.1 * (9.0 * x).sin() * (7.0 * y).cos());
        let c = v(centre.0, centre.1, centre.2);
        let triangles: Vec<[Vec3; 3]> =
            sheet.triangles.iter().map(|t| t.map(|k| sheet.vertices[k as usize])).collect();
        let n = 14;
        let share = |k: i32| f64::from(k) / f64::from(n);
        let samples: Vec<Vec3> = triangles.iter().flat_map(|&[a, b, c]| {
            (0..=n).flat_map(move |i| {
                (0..=n - i).map(move |j| a + (b - a) * share(i) + (c - a) * share(j))
            })
        }).collect();
        let longest = triangles.iter().map(|[a, b, c]| (b - a).norm().max((c - b).norm()).max((a - c).norm()));
        let h = longest.fold(0.0, f64::max) / f64::from(n);
        let found = closest_points(&geometry([sheet]), c, 0.1, 0.5);

        // The distance is convex in a triangle: between samples it drops by at most h^2/(2 d).
        let least = samples.iter().map(|s| (s - c).norm()).fold(f64::INFINITY, f64::min);
        let nearest = found.iter().map(|t| t.gap + 0.1).fold(f64::INFINITY, f64::min);
        prop_assert!(nearest <= least + 1e-12 && nearest >= least - h * h / nearest, "{nearest} {least}");

        for touch in &found {
            let x = touch.point;
            for [p, q, r] in &triangles {
                let area = |a: &Vec3, b: &Vec3, c: &Vec3| (b - a).cross(&(c - a)).norm();
                let through_x = area(&x, p, q) + area(&x, q, r) + area(&x, r, p) < area(p, q, r) + 1e-12;
                if through_x {
                    for aim in [*p, *q, *r, 0.5 * (p + q), 0.5 * (q + r), 0.5 * (r + p)] {
                        let beside = x + (aim - x) * 1e-3;
                        prop_assert!((beside - c).norm() >= (x - c).norm(), "{touch:?} {aim:?}");
                    }
                }
            }
        }

        // A sample so much nearer than the ring around it that the surface has a minimum within the ring.
        for s in samples.iter().filter(|s| (*s - c).norm() < 0.55) {
            let d = (s - c).norm();
            let enclosed = samples.iter().all(|o| {
                let away = (o - s).norm();
                let rim = h * h / d;
                away > 4.0 * h || (o - c).norm() >= if away < 2.5 * h { d } else { d + rim }
            });
            if enclosed {
                prop_assert!(found.iter().any(|t| (t.point - s).norm() < 4.0 * h), "{s:?} {found:?}");
            }
        }
    }
}

#[test]
fn facets_that_meet_without_sharing_vertices_leave_no_ghost_edge() {
    // Long and short sides of coplanar rectangles: T-junctions at y = 1.
    let rectangle = |x: f64, y: f64, w: f64, d: f64| {
        Facets::rectangle(v(x, y, 0.0), v(w, 0.0, 0.0), v(0.0, d, 0.0)).unwrap()
    };
    let floor = geometry([
        rectangle(0.0, 0.0, 3.0, 1.0),
        rectangle(0.0, 1.0, 1.3, 1.0),
        rectangle(1.3, 1.0, 1.7, 1.0),
    ]);
    for k in 0..=100 {
        for x in [0.7, 1.3, 1.3 + 1e-9, 2.0] {
            let y = 0.95 + 0.001 * f64::from(k);
            let found = closest_points(&floor, v(x, y, 0.25), 0.25, 0.1);
            let [touch] = found[..] else {
                panic!("{x} {y}: {found:?}")
            };
            same(touch.normal, v(0.0, 0.0, 1.0));
        }
    }
}

#[test]
fn a_partition_stands_on_a_floor() {
    // The wall's foot lies on a joint of the floor, whose edge then has three facets.
    let floor =
        |x: f64| Facets::rectangle(v(x, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)).unwrap();
    let wall = Facets::rectangle(v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0), v(0.0, 0.0, 1.0)).unwrap();
    let scene = geometry([floor(0.0), floor(1.0), wall]);
    let found = closest_points(&scene, v(1.2, 0.5, 0.2), 0.2, 0.05);
    assert_eq!(found.len(), 2, "{found:?}");
    let below = closest_points(&scene, v(1.0, 0.5, -0.2), 0.2, 0.05);
    assert_eq!(below.len(), 1, "{below:?}");
    assert_eq!(below[0].feature, found[0].feature);
}

#[test]
fn a_straight_edge_in_pieces_is_one_feature() {
    // A step of five pieces, split differently above and in front.
    let mut shapes = Vec::new();
    for k in 0..5 {
        let y = f64::from(k);
        shapes
            .push(Facets::rectangle(v(0.0, y, 0.0), v(-1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)).unwrap());
        shapes
            .push(Facets::rectangle(v(0.0, y, 0.0), v(0.0, 0.0, -1.0), v(0.0, 1.0, 0.0)).unwrap());
    }
    let step = geometry(shapes);
    let [first] = closest_points(&step, v(0.2, 0.5, 0.2), 0.3, 0.1)[..] else {
        panic!()
    };
    for k in 1..50 {
        let y = 0.1 * f64::from(k);
        let [touch] = closest_points(&step, v(0.2, y, 0.2), 0.3, 0.1)[..] else {
            panic!("{y}")
        };
        assert_eq!(touch.feature, first.feature, "{y}");
        same(touch.point, v(0.0, y, 0.0));
    }
}

#[test]
fn crossing_an_edge_changes_nothing_suddenly() {
    let cube = geometry([Facets::cuboid(v(-1.0, -1.0, -1.0), v(0.0, 1.0, 0.0)).unwrap()]);
    let mut last = None;
    for k in 0..=4000 {
        // Over the edge x = z = 0 on a circle and its tangents: the gap is 0 all along.
        let s = -0.2 + 1e-4 * f64::from(k);
        let centre = match s / 0.1 {
            a if a <= 0.0 => v(s, 0.0, 0.1),
            a if a < std::f64::consts::FRAC_PI_2 => v(0.1 * a.sin(), 0.0, 0.1 * a.cos()),
            a => v(0.1, 0.0, -0.1 * (a - std::f64::consts::FRAC_PI_2)),
        };
        let [touch] = closest_points(&cube, centre, 0.1, 0.05)[..] else {
            panic!("{s}")
        };
        close(touch.gap, 0.0);
        if let Some(normal) = last.replace(touch.normal) {
            assert!((touch.normal - normal).norm() < 1.1e-3);
        }
    }
}

#[test]
fn duplicate_vertices_slivers_and_flipped_facets_are_mended() {
    let mut vertices = vec![
        v(0.0, 0.0, 0.0),
        v(1.0, 0.0, 0.0),
        v(1.0, 1.0, 0.0),
        v(0.0, 1.0, 0.0),
    ];
    // The second triangle has its own copies, a little off; the third has no height; the fourth no extent.
    vertices.extend([v(1e-9, 0.0, 0.0), v(1.0, 1.0, -1e-9), v(0.5, 0.0, 1e-9)]);
    let triangles = vec![[0, 1, 2], [5, 4, 3], [0, 6, 1], [0, 4, 0]];
    let plate = geometry([Facets::mesh("plate", vertices, triangles)]);
    let repair = plate.repair().unwrap();
    assert_eq!(repair.welded_vertices, 2);
    assert_eq!(
        repair.dropped_facets,
        [("plate".to_string(), 2), ("plate".to_string(), 3)]
    );
    let feature = closest_points(&plate, v(0.5, 0.5, 0.2), 0.2, 0.1)[0].feature;
    for p in [v(0.2, 0.8, 0.2), v(0.8, 0.2, 0.2), v(0.5, 0.5, 0.2)] {
        let [touch] = closest_points(&plate, p, 0.2, 0.1)[..] else {
            panic!()
        };
        assert_eq!(touch.feature, feature);
    }
}

#[test]
fn a_serialized_geometry_answers_the_same() {
    let sheet = random_sheet(5, 7, |x, y| 0.1 * (9.0 * x).sin() * (7.0 * y).cos());
    let original = geometry([sheet]);
    let bytes = postcard::to_extend(&original, Vec::new()).unwrap();
    let copy: Geometry = postcard::from_bytes(&bytes).unwrap();
    assert_eq!(copy, original);
    for k in 0..50 {
        let centre = v(0.02 * f64::from(k), 0.4, 0.3);
        assert_eq!(
            closest_points(&copy, centre, 0.2, 0.2),
            closest_points(&original, centre, 0.2, 0.2)
        );
    }
}

#[test]
fn touches_append_and_an_empty_geometry_has_none() {
    let empty = geometry(Vec::<Facets>::new());
    assert_eq!(empty, Geometry::default());
    assert!(closest_points(&empty, Vec3::zeros(), 1.0, 1.0).is_empty());
    let plate = geometry([
        Facets::rectangle(v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)).unwrap(),
    ]);
    let mut out = Vec::new();
    plate.closest_points(v(0.5, 0.5, 0.1), 0.2, 0.1, &mut out);
    plate.closest_points(v(0.5, 0.5, 0.1), 0.2, 0.1, &mut out);
    assert_eq!(out.len(), 2);
}
