use sphere_dda::geometry::{Facets, Geometry, HalfSpace, Revolution, Shape};

use super::{close, closest_points, geometry, same, v};

#[test]
fn a_half_space_is_one_sided() {
    let floor = geometry([HalfSpace::new(v(0.0, 0.0, 1.0), v(0.0, 0.0, 2.0)).unwrap()]);
    for (z, gap) in [(1.6, 0.1), (1.4, -0.1), (0.5, -1.0)] {
        let [touch] = closest_points(&floor, v(3.0, 4.0, z), 0.5, 0.2)[..] else {
            panic!()
        };
        close(touch.gap, gap);
        same(touch.normal, v(0.0, 0.0, 1.0));
        same(touch.point, v(3.0, 4.0, 1.0));
    }
    assert!(closest_points(&floor, v(0.0, 0.0, 1.8), 0.5, 0.2).is_empty());
}

#[test]
fn a_box_from_outside_gives_one_touch_on_face_edge_or_corner() {
    let cube = geometry([Facets::cuboid(v(0.0, 0.0, 0.0), v(1.0, 1.0, 1.0)).unwrap()]);
    let reach = 0.2;
    for (centre, point) in [
        (v(0.3, 0.6, 1.5), v(0.3, 0.6, 1.0)),
        (v(1.3, 0.6, 1.4), v(1.0, 0.6, 1.0)),
        (v(1.2, 1.3, 1.2), v(1.0, 1.0, 1.0)),
        (v(-0.3, -0.3, 0.5), v(0.0, 0.0, 0.5)),
        // Above the diagonal that splits the face, and above the border itself.
        (v(0.5, 0.5, 1.5), v(0.5, 0.5, 1.0)),
        (v(1.0, 0.5, 1.5), v(1.0, 0.5, 1.0)),
        (v(1.0, 1.0, 1.5), v(1.0, 1.0, 1.0)),
    ] {
        let found = closest_points(&cube, centre, 0.5, reach);
        let [touch] = found[..] else {
            panic!("{centre:?}: {found:?}")
        };
        same(touch.point, point);
        close(touch.gap, (centre - point).norm() - 0.5);
        same(touch.normal, (centre - point).normalize());
    }
}

#[test]
fn a_box_from_inside_gives_a_touch_for_every_wall_in_reach() {
    let cube = geometry([Facets::cuboid(v(0.0, 0.0, 0.0), v(1.0, 1.0, 1.0)).unwrap()]);
    let in_corner = closest_points(&cube, v(0.21, 0.2, 0.22), 0.2, 0.1);
    assert_eq!(in_corner.len(), 3);
    for (touch, normal) in
        in_corner
            .iter()
            .zip([v(0.0, 0.0, 1.0), v(0.0, 1.0, 0.0), v(1.0, 0.0, 0.0)])
    {
        same(touch.normal, normal);
        assert_eq!(touch.curvature, 0.0);
    }
    assert_eq!(closest_points(&cube, v(0.5, 0.2, 0.2), 0.2, 0.1).len(), 2);
    assert_eq!(closest_points(&cube, v(0.5, 0.5, 0.5), 0.5, 0.1).len(), 6);
    assert!(in_corner.windows(2).all(|w| w[0].feature < w[1].feature));
}

#[test]
fn a_free_border_works_from_all_around() {
    let plate = geometry([
        Facets::rectangle(v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)).unwrap(),
    ]);
    for angle in [-1.5f64, -0.7, 0.0, 0.7, 1.5] {
        let centre = v(1.0 + 0.3 * angle.cos(), 0.4, 0.3 * angle.sin());
        let [touch] = closest_points(&plate, centre, 0.3, 0.1)[..] else {
            panic!("{angle}")
        };
        same(touch.point, v(1.0, 0.4, 0.0));
        close(touch.gap, 0.0);
        close(touch.curvature, 1.0 / 0.3);
    }
    // The sheet has two sides, and a face keeps its own when the centre goes through.
    let [below] = closest_points(&plate, v(0.5, 0.5, -0.1), 0.3, 0.1)[..] else {
        panic!()
    };
    same(below.normal, v(0.0, 0.0, -1.0));
    let through = plate.follow(below.feature, below.normal, v(0.5, 0.5, 0.05), 0.3);
    close(through.gap, -0.35);
    same(through.normal, v(0.0, 0.0, -1.0));
    // Beyond its border the face ends at the nearest point of it.
    let beyond = plate.follow(below.feature, below.normal, v(1.3, 1.4, 0.0), 0.3);
    close(beyond.gap, 0.2);
    same(beyond.point, v(1.0, 1.0, 0.0));
}

#[test]
fn a_centre_on_the_sheet_has_a_normal() {
    let plate = geometry([
        Facets::rectangle(v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)).unwrap(),
    ]);
    for (x, y) in [(0.3, 0.4), (1.0, 0.5), (0.0, 0.0), (0.5, 0.5)] {
        let [touch] = closest_points(&plate, v(x, y, 0.0), 0.2, 0.1)[..] else {
            panic!()
        };
        close(touch.normal.z.abs(), 1.0);
        close(touch.gap, -0.2);
        let followed = plate.follow(touch.feature, touch.normal, v(x, y, 0.0), 0.2);
        assert_eq!(followed.normal, touch.normal);
    }
    for feature in 0..12 {
        let touch = plate.follow(feature, v(0.0, 0.0, 1.0), v(0.0, 0.0, 0.0), 0.2);
        assert!(touch.normal.norm() > 0.99 && !touch.gap.is_nan() && touch.curvature.is_finite());
    }
}

#[test]
fn a_cylinder_from_inside_and_outside() {
    let tube =
        geometry([Revolution::cylinder(v(1.0, 0.0, 0.0), v(0.0, 0.0, 1.0), 1.0, 2.0).unwrap()]);
    let [inside] = closest_points(&tube, v(1.75, 0.0, 1.0), 0.2, 0.1)[..] else {
        panic!()
    };
    close(inside.gap, 0.05);
    same(inside.normal, v(-1.0, 0.0, 0.0));
    close(inside.curvature, 1.0 / 0.75);
    let [outside] = closest_points(&tube, v(1.0, 1.25, 1.0), 0.2, 0.1)[..] else {
        panic!()
    };
    close(outside.gap, 0.05);
    same(outside.normal, v(0.0, 1.0, 0.0));
    close(outside.curvature, 1.0 / 1.25);
    // The rim: a torus of tube radius |c - P0|.
    let [rim] = closest_points(&tube, v(2.0, 0.0, 2.2), 0.2, 0.1)[..] else {
        panic!()
    };
    same(rim.normal, v(0.0, 0.0, 1.0));
    close(rim.gap, 0.0);
    // Through the wall the side stays, past the axis too.
    let through = tube.follow(inside.feature, inside.normal, v(2.05, 0.0, 1.0), 0.2);
    close(through.gap, -0.25);
    let past = tube.follow(inside.feature, inside.normal, v(0.5, 0.0, 1.0), 0.2);
    close(past.gap, 0.3);
    same(past.normal, v(1.0, 0.0, 0.0));
}

#[test]
fn a_cone_inside_outside_and_its_apex() {
    // Half-angle 45 degrees, apex at the origin, opening upwards.
    let cone =
        geometry([Revolution::frustum(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0), 0.0, 2.0, 2.0).unwrap()]);
    let s = 0.5f64.sqrt();
    let [inside] = closest_points(&cone, v(0.4, 0.0, 1.4), 0.6, 0.2)[..] else {
        panic!()
    };
    close(inside.gap, s - 0.6);
    same(inside.normal, v(-s, 0.0, s));
    close(inside.curvature, s / 0.4);
    let [outside] = closest_points(&cone, v(0.0, 1.4, 0.4), 0.6, 0.2)[..] else {
        panic!()
    };
    same(outside.normal, v(0.0, s, -s));
    let [apex] = closest_points(&cone, v(0.1, 0.0, -0.7), 0.6, 0.2)[..] else {
        panic!()
    };
    same(apex.point, v(0.0, 0.0, 0.0));
    close(apex.gap, 0.5f64.sqrt() - 0.6);
}

#[test]
fn a_ball_on_the_axis_is_held_by_a_ring() {
    let cone =
        geometry([Revolution::frustum(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0), 0.5, 2.5, 2.0).unwrap()]);
    let s = 0.5f64.sqrt();
    let ring = closest_points(&cone, v(0.0, 0.0, 0.9), 1.4 * s, 0.05);
    // Eight sectors, two of which meet at the azimuth that the axis itself is given.
    assert_eq!(ring.len(), 7);
    for k in 0..72 {
        let angle = f64::from(5 * k).to_radians();
        let towards = v(angle.cos(), angle.sin(), 0.0);
        assert!(ring.iter().any(|t| t.normal.dot(&towards) < -0.7 * s));
    }
    for touch in &ring {
        close(touch.gap, 0.0);
        close(touch.normal.z, s);
        assert_eq!(
            cone.follow(touch.feature, touch.normal, v(0.0, 0.0, 0.9), 1.4 * s)
                .gap,
            touch.gap
        );
    }
    // Off the axis by more than the reach one touch is left.
    assert_eq!(
        closest_points(&cone, v(0.1, 0.0, 0.9), 1.3 * s, 0.05).len(),
        1
    );
}

#[test]
fn a_hopper_of_one_profile_has_no_ghost_edges() {
    // Cylinder on a cone; the middle corner of the cylinder is in line and goes.
    let profile = [[0.5, 0.0], [2.0, 1.5], [2.0, 2.0], [2.0, 4.0]];
    let hopper = Revolution::new(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0), &profile).unwrap();
    assert_eq!(hopper.profile.len(), 3);
    let hopper = geometry([hopper]);
    // Concave joint: two faces. Seen from outside: the joint itself.
    assert_eq!(
        closest_points(&hopper, v(1.69, 0.0, 1.69), 0.3, 0.1).len(),
        2
    );
    let [outer] = closest_points(&hopper, v(2.2, 0.0, 1.4), 0.2, 0.1)[..] else {
        panic!()
    };
    same(outer.point, v(2.0, 0.0, 1.5));
    // Beside the wall the joint is in reach too, but the wall is nearer.
    let [beside] = closest_points(&hopper, v(2.2, 0.0, 1.7), 0.2, 0.1)[..] else {
        panic!()
    };
    same(beside.point, v(2.0, 0.0, 1.7));
    for z in [1.9, 1.95, 2.0, 2.05] {
        let [wall] = closest_points(&hopper, v(1.8, 0.0, z), 0.2, 0.01)[..] else {
            panic!("{z}")
        };
        same(wall.normal, v(-1.0, 0.0, 0.0));
    }
}

#[test]
fn a_disc_and_an_annulus() {
    let disc = geometry([Revolution::disc(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0), 0.0, 1.0).unwrap()]);
    for centre in [v(0.0, 0.0, 0.2), v(0.5, 0.1, 0.2), v(0.0, 1.0, 0.2)] {
        let [touch] = closest_points(&disc, centre, 0.2, 0.1)[..] else {
            panic!()
        };
        close(touch.gap, 0.0);
        same(touch.normal, v(0.0, 0.0, 1.0));
    }
    let ring = geometry([Revolution::disc(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0), 0.5, 1.0).unwrap()]);
    let [inner] = closest_points(&ring, v(0.2, 0.0, 0.4), 0.5, 0.02)[..] else {
        panic!()
    };
    same(inner.point, v(0.5, 0.0, 0.0));
    close(inner.gap, 0.0);
}

#[test]
fn a_cone_and_its_facets_agree() {
    let (segments, r0, r1, h) = (720, 0.4, 1.2, 1.0);
    let ring = |k: usize, r: f64, z: f64| {
        let a = std::f64::consts::TAU * (k % segments) as f64 / segments as f64;
        v(r * a.cos(), r * a.sin(), z)
    };
    let quads = (0..segments).map(|k| {
        let corners = [
            ring(k, r0, 0.0),
            ring(k + 1, r0, 0.0),
            ring(k + 1, r1, h),
            ring(k, r1, h),
        ];
        Facets::polygon(&corners).unwrap()
    });
    let faceted = geometry(quads);
    let analytic =
        geometry([Revolution::frustum(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0), r0, r1, h).unwrap()]);
    for centre in [
        v(0.3, 0.35, 0.5),
        v(0.9, 0.3, 0.2),
        v(0.1, -1.3, 1.1),
        v(0.25, 0.0, -0.2),
    ] {
        let least = |g: &Geometry| {
            let found = closest_points(g, centre, 0.2, 0.5);
            found
                .into_iter()
                .min_by(|a, b| a.gap.total_cmp(&b.gap))
                .unwrap()
        };
        let (f, a) = (least(&faceted), least(&analytic));
        // A chord's sagitta is r (pi/n)^2/2.
        assert!((f.gap - a.gap).abs() < 2e-5, "{f:?} {a:?}");
        assert!((f.normal - a.normal).norm() < 0.01);
    }
}

#[test]
fn features_count_on_from_shape_to_shape() {
    let scene = Geometry::new(vec![
        Shape::from(Revolution::cylinder(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0), 1.0, 1.0).unwrap()),
        HalfSpace::new(v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0))
            .unwrap()
            .into(),
        Facets::rectangle(v(0.0, 0.0, 0.0), v(0.9, 0.0, 0.0), v(0.0, 0.0, 1.0))
            .unwrap()
            .into(),
    ])
    .unwrap();
    let found = closest_points(&scene, v(0.8, 0.2, 0.2), 0.2, 0.1);
    assert_eq!(found.len(), 3, "{found:?}");
    assert!(found.windows(2).all(|w| w[0].feature < w[1].feature));
    for touch in &found {
        assert_eq!(
            scene.follow(touch.feature, touch.normal, v(0.8, 0.2, 0.2), 0.2),
            *touch
        );
    }
    assert_eq!(scene.bounds(), None);
    assert_eq!(
        scene
            .follow(999, v(0.0, 0.0, 1.0), v(0.0, 0.0, 0.0), 1.0)
            .gap,
        f64::INFINITY
    );
}

#[test]
fn tessellations_cover_the_surface() {
    let area = |geometry: &Geometry| -> f64 {
        let t = geometry.tessellate((v(-1.0, -1.0, -1.0), v(1.0, 1.0, 1.0)));
        t.triangles
            .iter()
            .map(|tri| tri.map(|i| t.points[i as usize]))
            .map(|[a, b, c]| (b - a).cross(&(c - a)).norm() / 2.0)
            .sum()
    };
    let cube = geometry([Facets::cuboid(v(0.0, 0.0, 0.0), v(1.0, 2.0, 3.0)).unwrap()]);
    close(area(&cube), 22.0);
    assert_eq!(cube.bounds(), Some((v(0.0, 0.0, 0.0), v(1.0, 2.0, 3.0))));
    let cone =
        geometry([Revolution::frustum(v(0.0, 0.0, 0.0), v(1.0, 1.0, 0.0), 0.0, 1.0, 1.0).unwrap()]);
    let exact = std::f64::consts::PI * 2.0f64.sqrt();
    assert!((area(&cone) / exact - 1.0).abs() < 2e-3);
    let (min, max) = cone.bounds().unwrap();
    for p in cone.tessellate((min, max)).points {
        assert!((0..3).all(|k| p[k] >= min[k] - 1e-12 && p[k] <= max[k] + 1e-12));
    }
    let floor = geometry([HalfSpace::new(v(0.0, 0.0, 0.0), v(1.0, 2.0, 3.0)).unwrap()]);
    close(area(&floor), 12.0);
}
