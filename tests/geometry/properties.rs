use nalgebra::UnitQuaternion;
use proptest::prelude::*;
use sphere_dda::Vec3;
use sphere_dda::geometry::{ClosestPoint, Facets, Geometry, HalfSpace, Revolution, Shape};

use super::{closest_points, v};

/// One of each, turned and moved.
fn zoo(rotation: UnitQuaternion<f64>, translation: Vec3) -> Geometry {
    let axis = rotation * Vec3::z();
    let at = |x, y, z| rotation * v(x, y, z) + translation;
    let place = |f: Facets| Shape::from(f.placed(1.0, rotation, translation));
    Geometry::new(vec![
        place(Facets::cuboid(v(0.0, 0.0, 0.0), v(1.0, 1.0, 0.5)).unwrap()),
        place(Facets::triangle(v(1.0, 0.0, 0.5), v(1.0, 1.0, 0.5), v(1.8, 0.4, 0.2)).unwrap()),
        Revolution::frustum(at(0.5, 0.5, 0.8), axis, 0.2, 0.9, 0.8)
            .unwrap()
            .into(),
        Revolution::new(
            at(-1.0, 0.0, 0.0),
            axis,
            &[[0.0, 0.0], [0.4, 0.0], [0.4, 1.0]],
        )
        .unwrap()
        .into(),
        HalfSpace::new(at(0.0, 0.0, -0.5), axis).unwrap().into(),
    ])
    .unwrap()
}

fn point() -> impl Strategy<Value = Vec3> {
    (-1.8..2.2f64, -0.8..1.8f64, -0.6..2.0f64).prop_map(|(x, y, z)| v(x, y, z))
}

/// Largest principal curvature of the surface of constant gap: of all tangent directions, the largest second
/// derivative of the gap (its gradient has length 1). Central differences of step `h`.
fn measured_curvature(
    geometry: &Geometry,
    touch: &ClosestPoint,
    c: Vec3,
    radius: f64,
    h: f64,
) -> f64 {
    let e1 = touch
        .normal
        .cross(&Vec3::ith(touch.normal.iamin(), 1.0))
        .normalize();
    let e2 = touch.normal.cross(&e1);
    let gap = |arm: Vec3| {
        geometry
            .follow(touch.feature, touch.normal, c + arm, radius)
            .gap
    };
    (0..180)
        .map(|k| f64::from(k).to_radians())
        .map(|a| (e1 * a.cos() + e2 * a.sin()) * h)
        .map(|arm| ((gap(arm) - 2.0 * gap(Vec3::zeros()) + gap(-arm)) / (h * h)).abs())
        .fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn every_touch_keeps_its_promises(c in point(), radius in 0.05..0.5f64, reach in 0.0..0.3f64) {
        let zoo = zoo(UnitQuaternion::identity(), Vec3::zeros());
        let found = closest_points(&zoo, c, radius, reach);
        prop_assert!(found.windows(2).all(|w| w[0].feature < w[1].feature));
        for touch in &found {
            let signed = (c - touch.point).dot(&touch.normal);
            prop_assert!((touch.normal.norm() - 1.0).abs() < 1e-12);
            prop_assert!((signed.abs() - (c - touch.point).norm()).abs() < 1e-12, "not parallel: {touch:?}");
            prop_assert!((signed - radius - touch.gap).abs() < 1e-12);
            prop_assert!(touch.gap <= reach);
            let followed = zoo.follow(touch.feature, touch.normal, c, radius);
            prop_assert!((followed.point - touch.point).norm() < 1e-12, "{touch:?} {followed:?}");
            prop_assert!((followed.gap - touch.gap).abs() < 1e-12);
            prop_assert!((followed.normal - touch.normal).norm() < 1e-9);
        }
    }

    /// The gap's gradient is the normal, so the step may be linearised with it.
    #[test]
    fn the_normal_is_the_gradient_of_the_gap(c in point(), radius in 0.1..0.4f64) {
        let zoo = zoo(UnitQuaternion::identity(), Vec3::zeros());
        for touch in closest_points(&zoo, c, radius, 0.1) {
            prop_assume!(touch.curvature < 20.0);
            let h = 1e-6;
            let slope = Vec3::from_fn(|k, _| {
                let gap = |s: f64| zoo.follow(touch.feature, touch.normal, c + Vec3::ith(k, s), radius).gap;
                (gap(h) - gap(-h)) / (2.0 * h)
            });
            prop_assert!((slope - touch.normal).norm() < 1e-6, "{touch:?} {slope:?}");
        }
    }

    #[test]
    fn curvature_is_that_of_the_constant_gap_surface(c in point(), radius in 0.1..0.4f64) {
        let zoo = zoo(UnitQuaternion::identity(), Vec3::zeros());
        for touch in closest_points(&zoo, c, radius, 0.1) {
            // A sector ends within any step near the axis.
            prop_assume!(touch.curvature < 20.0 && !is_sector(touch.feature));
            let errors = [1e-3, 5e-4].map(|h| (measured_curvature(&zoo, &touch, c, radius, h) - touch.curvature).abs());
            // Kinks where a face ends are not smooth: there the closest point is within h of a border.
            let smooth = errors[1] < 2e-3 * (1.0 + touch.curvature.powi(3));
            let near_border = {
                let e = |s: f64| {
                    let e1 = touch.normal.cross(&Vec3::ith(touch.normal.iamin(), 1.0)).normalize();
                    let e2 = touch.normal.cross(&e1);
                    (0..8).any(|k| {
                        let a = f64::from(k) * std::f64::consts::FRAC_PI_4;
                        let moved = c + (e1 * a.cos() + e2 * a.sin()) * s;
                        closest_points(&zoo, moved, radius, 0.2).iter().all(|t| t.feature != touch.feature)
                    })
                };
                e(2e-3)
            };
            prop_assert!(smooth || near_border, "{touch:?}: {errors:?}");
        }
    }

    /// Near its axis too, where the far side is as near: its foot is no nearer to the axis than the centre but by rounding.
    #[test]
    fn a_sphere_over_a_disc_touches_it_once(
        turn in prop::array::uniform3(-3.0..3.0f64),
        shift in prop::array::uniform3(-100.0..100.0f64),
        (x, y) in (-0.3..0.3f64, -0.3..0.3f64),
    ) {
        let (rotation, shift) = (UnitQuaternion::from_scaled_axis(Vec3::from(turn)), Vec3::from(shift));
        let disc = Revolution::disc(shift, rotation * Vec3::z(), 0.0, 0.7).unwrap();
        let disc = Geometry::new(vec![disc.into()]).unwrap();
        let touching = closest_points(&disc, rotation * v(x, y, 0.2) + shift, 0.3, 0.1);
        prop_assert_eq!(touching.len(), 1);
        prop_assert!((touching[0].gap + 0.1).abs() < 1e-10);
    }

    #[test]
    fn turning_everything_changes_nothing(
        c in point(),
        turn in prop::array::uniform3(-3.0..3.0f64),
        shift in prop::array::uniform3(-100.0..100.0f64),
    ) {
        let rotation = UnitQuaternion::from_scaled_axis(Vec3::from(turn));
        let shift = Vec3::from(shift);
        let still = closest_points(&zoo(UnitQuaternion::identity(), Vec3::zeros()), c, 0.3, 0.1);
        let turned = closest_points(&zoo(rotation, shift), rotation * c + shift, 0.3, 0.1);
        // Sectors start at another azimuth where the turned frame differs; the closest point of all is the same.
        let least = |t: &[ClosestPoint]| t.iter().map(|t| t.gap).fold(1.0, f64::min);
        prop_assert!((least(&still) - least(&turned)).abs() < 1e-10);
        let single = |t: &[ClosestPoint]| t.iter().filter(|t| !is_sector(t.feature)).copied().collect::<Vec<_>>();
        let (still, turned) = (single(&still), single(&turned));
        prop_assert_eq!(still.len(), turned.len());
        for (s, t) in still.iter().zip(&turned) {
            prop_assert_eq!(s.feature, t.feature);
            prop_assert!((s.gap - t.gap).abs() < 1e-10);
            prop_assert!((rotation * s.normal - t.normal).norm() < 1e-8);
        }
    }
}

/// Whether a feature of [`zoo`] is the closest point of a sector.
fn is_sector(feature: u32) -> bool {
    // Mesh: 7 faces, 12 edges of the box and 2 of the flap, 9 corners; frustum: 1 piece, 2 corners, both by 8 sectors; cup: 2
    // pieces, 3 corners, both by sectors.
    let frustum = 7 + 14 + 9;
    let cup = frustum + 3 * 9;
    (frustum + 3..cup).contains(&feature) || (cup + 5..cup + 5 * 9).contains(&feature)
}
