//! How much of a straight line lies in a region: the weight of a branch vector in the mean stress.

use crate::Vec3;
use crate::geometry::region::Primitive;

/// An interval of the line's parameter; empty where the second is not above the first.
type Span = (f64, f64);

const NONE: Span = (1.0, 0.0);
const ALL: Span = (f64::NEG_INFINITY, f64::INFINITY);

/// Share \[-\] of the length from `start` to `end` \[m\] that lies in the region, 0..=1. A line of no length has share
/// 1 inside, 0 outside.
pub(crate) fn share_inside(region: &Primitive, start: Vec3, end: Vec3) -> f64 {
    let by = end - start;
    let (from, to) = match region {
        Primitive::Box { min, max } => (0..3)
            .map(|k| slab(start[k] - min[k], by[k], max[k] - min[k]))
            .fold((0.0, 1.0), common),
        Primitive::Cylinder {
            base,
            axis,
            radius,
            height,
        } => {
            let (from, along) = ((start - base).dot(axis), by.dot(axis));
            let across = round(start - base - axis * from, by - axis * along, *radius);
            common(common((0.0, 1.0), slab(from, along, *height)), across)
        }
    };
    (to - from).max(0.0)
}

fn common(a: Span, b: Span) -> Span {
    (a.0.max(b.0), a.1.min(b.1))
}

/// Where `0 <= from + t by < height`.
fn slab(from: f64, by: f64, height: f64) -> Span {
    if by == 0.0 {
        return if (0.0..height).contains(&from) {
            ALL
        } else {
            NONE
        };
    }
    let (a, b) = (-from / by, (height - from) / by);
    (a.min(b), a.max(b))
}

/// Where `|from + t by| < radius`.
fn round(from: Vec3, by: Vec3, radius: f64) -> Span {
    let (a, b, c) = (
        by.norm_squared(),
        from.dot(&by),
        from.norm_squared() - radius * radius,
    );
    let discriminant = b * b - a * c;
    if a == 0.0 {
        return if c < 0.0 { ALL } else { NONE };
    }
    if discriminant <= 0.0 {
        return NONE;
    }
    let half = discriminant.sqrt();
    ((-b - half) / a, (-b + half) / a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn regions() -> [Primitive; 2] {
        [
            Primitive::Box {
                min: Vec3::new(-0.5, -0.2, 0.1),
                max: Vec3::new(0.6, 0.9, 0.8),
            },
            Primitive::Cylinder {
                base: Vec3::new(0.1, 0.0, -0.4),
                axis: Vec3::new(0.6, 0.0, 0.8),
                radius: 0.5,
                height: 0.9,
            },
        ]
    }

    #[test]
    fn a_line_across_a_box_is_inside_by_its_middle() {
        let [cuboid, cylinder] = regions();
        let z = |z| Vec3::new(0.0, 0.0, z);
        // 0.7 of 1.4 m lie between the lids.
        assert!((share_inside(&cuboid, z(-0.3), z(1.1)) - 0.5).abs() < 1e-15);
        assert_eq!(share_inside(&cuboid, z(0.2), z(0.3)), 1.0);
        assert_eq!(share_inside(&cuboid, z(0.9), z(2.0)), 0.0);
        // A line across the axis: a chord of length 2 R.
        let (middle, across) = (
            Vec3::new(0.1, 0.0, -0.4) + Vec3::new(0.6, 0.0, 0.8) * 0.3,
            Vec3::y(),
        );
        assert!((share_inside(&cylinder, middle - across, middle + across) - 0.5).abs() < 1e-15);
    }

    proptest! {
        /// Points counted along the line.
        #[test]
        fn the_share_is_that_of_the_points_inside(
            ends in prop::array::uniform2(prop::array::uniform3(-1.5..1.5_f64)),
        ) {
            let [start, end] = ends.map(Vec3::from);
            for region in regions() {
                let inside = (0..2000).filter(|&k| {
                    let t = (f64::from(k) + 0.5) / 2000.0;
                    region.contains(start + (end - start) * t)
                });
                let counted = inside.count() as f64 / 2000.0;
                let share = share_inside(&region, start, end);
                prop_assert!((share - counted).abs() <= 1.0 / 2000.0 + 1e-12, "{} {}", share, counted);
            }
        }
    }
}
