//! The volume that a sphere shares with a region: what a solid fraction is made of.
//!
//! # Box: closed form
//!
//! Inclusion and exclusion over the eight corners, `V = sum (-1)^k O(corner)`, leaves the part `O(a, b, c)` of the unit
//! ball with `x > a, y > b, z > c`. Each negative bound is turned round by `O(-a, b, c) = W(b, c) - O(a, b, c)`, W being
//! the part with two bounds. For a corner within the ball and `a, b, c >= 0` the divergence theorem and that of
//! Gauss and Bonnet on the spherical triangle give
//!
//! ```text
//! O = (S - a A_a - b A_b - c A_c) / 3
//! S = t_ab + t_bc + t_ca - pi - a f_a - b f_b - c f_c          t_ab = atan2(sqrt(1 - a^2 - b^2), a b)
//! A_a = ((1 - a^2) f_a - b (h_ab - c) - c (h_ac - b)) / 2      h_ab = sqrt(1 - a^2 - b^2)
//! f_a = atan2(h_ab, b) - atan2(c, h_ac)
//! ```
//!
//! with `t` the angles at the corners of the triangle, `f` the angles and `A` the areas of the discs' parts in the planes.
//! Error: some 1e-15 of the sphere's volume.
//!
//! # Cylinder: slices
//!
//! `V = integral of L(rho(z), R_c, d) dz` along the axis: the disc of the sphere at `z`, `rho^2 = R^2 - z^2`, and that of the
//! cylinder, `d` apart, share the lens `L`, which is a closed form. Where one disc begins or ceases to hold the other the
//! integrand goes as a power 3/2; between these places `z = m + h sin s` makes it smooth and Gauss-Legendre
//! converges fast. Error: below 1e-10 of the sphere's volume.

use std::f64::consts::{FRAC_PI_2, PI};
use std::num::NonZeroUsize;
use std::sync::LazyLock;

use gauss_quad::GaussLegendre;

use crate::Vec3;
use crate::geometry::region::Primitive;

/// Volume of the unit ball.
const BALL: f64 = 4.0 / 3.0 * PI;
/// Points of the rule between two breaks, 24: see the test of its error.
const POINTS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(23);
static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(POINTS));

/// Volume \[m^3\] of the part of a sphere (`centre`, `radius` \[m\]) that lies in a box or a cylinder.
pub(crate) fn volume_inside(region: &Primitive, centre: Vec3, radius: f64) -> f64 {
    let share = match region {
        Primitive::Box { min, max } => in_box((min - centre) / radius, (max - centre) / radius),
        Primitive::Cylinder {
            base,
            axis,
            radius: of_cylinder,
            height,
        } => {
            let from = base - centre;
            let start = from.dot(axis);
            let apart = (from - axis * start).norm();
            in_cylinder(
                (start / radius, (start + height) / radius),
                of_cylinder / radius,
                apart / radius,
            )
        }
    };
    share * radius * radius * radius
}

/// Of the unit ball the part in a box with the corners `low` and `high`.
fn in_box(low: Vec3, high: Vec3) -> f64 {
    let zero = Vec3::zeros();
    if zero.sup(&low).inf(&high).norm_squared() >= 1.0 {
        return 0.0;
    }
    if low.max() <= -1.0 && high.min() >= 1.0 {
        return BALL;
    }
    if low.abs().sup(&high.abs()).norm_squared() <= 1.0 {
        return (high - low).product();
    }
    let mut sum = 0.0;
    for (x, sx) in [(low.x, 1.0), (high.x, -1.0)] {
        for (y, sy) in [(low.y, 1.0), (high.y, -1.0)] {
            for (z, sz) in [(low.z, 1.0), (high.z, -1.0)] {
                sum += sx * sy * sz * corner(x, y, z);
            }
        }
    }
    sum.max(0.0)
}

/// Of the unit ball the part `x > a`.
fn cap(a: f64) -> f64 {
    let a = a.clamp(-1.0, 1.0);
    PI / 3.0 * (1.0 - a) * (1.0 - a) * (2.0 + a)
}

/// Of the unit ball the part `x > a, y > b`.
fn wedge(a: f64, b: f64) -> f64 {
    if a < 0.0 {
        return cap(b) - wedge(-a, b);
    }
    if b < 0.0 {
        return cap(a) - wedge(a, -b);
    }
    let h = 1.0 - a * a - b * b;
    if h <= 0.0 {
        return 0.0;
    }
    let h = h.sqrt();
    let (fa, fb) = (2.0 * h.atan2(b), 2.0 * h.atan2(a));
    let surface = 2.0 * h.atan2(a * b) - a * fa - b * fb;
    let area = |a: f64, b: f64, f: f64| 0.5 * (1.0 - a * a) * f - b * h;
    (surface - a * area(a, b, fa) - b * area(b, a, fb)) / 3.0
}

/// Of the unit ball the part `x > a, y > b, z > c`.
fn corner(a: f64, b: f64, c: f64) -> f64 {
    if a < 0.0 {
        return wedge(b, c) - corner(-a, b, c);
    }
    if b < 0.0 {
        return wedge(a, c) - corner(a, -b, c);
    }
    if c < 0.0 {
        return wedge(a, b) - corner(a, b, -c);
    }
    if a * a + b * b + c * c >= 1.0 {
        return 0.0;
    }
    let reach = |a: f64, b: f64| (1.0 - a * a - b * b).sqrt();
    let (ab, bc, ca) = (reach(a, b), reach(b, c), reach(c, a));
    let arc = |b: f64, ab: f64, c: f64, ca: f64| ab.atan2(b) - c.atan2(ca);
    let (fa, fb, fc) = (arc(b, ab, c, ca), arc(c, bc, a, ab), arc(a, ca, b, bc));
    let angles = ab.atan2(a * b) + bc.atan2(b * c) + ca.atan2(c * a);
    let surface = angles - PI - a * fa - b * fb - c * fc;
    let area = |a: f64, f: f64, b: f64, ab: f64, c: f64, ca: f64| {
        0.5 * ((1.0 - a * a) * f - b * (ab - c) - c * (ca - b))
    };
    let faces = a * area(a, fa, b, ab, c, ca)
        + b * area(b, fb, c, bc, a, ab)
        + c * area(c, fc, a, ca, b, bc);
    (surface - faces) / 3.0
}

/// Of the unit ball the part in a cylinder along z between `ends`, its axis `apart` from the centre.
fn in_cylinder(ends: (f64, f64), radius: f64, apart: f64) -> f64 {
    let (low, high) = (ends.0.max(-1.0), ends.1.min(1.0));
    if low >= high || apart >= radius + 1.0 {
        return 0.0;
    }
    if apart + 1.0 <= radius {
        return cap(low) - cap(high);
    }
    let mut breaks = vec![low, high];
    for rho in [(radius - apart).abs(), radius + apart] {
        // Where the greatest disc of the sphere just fails to reach, the middle is nearly such a place.
        let z = ((1.0 - rho) * (1.0 + rho)).max(0.0).sqrt();
        breaks.extend([-z, z].into_iter().filter(|z| low < *z && *z < high));
    }
    breaks.sort_by(f64::total_cmp);
    let area = |z: f64| lens(((1.0 - z) * (1.0 + z)).max(0.0).sqrt(), radius, apart);
    breaks
        .windows(2)
        .map(|w| smoothed(&RULE, w[0], w[1], area))
        .sum()
}

/// Integral of `f` from `a` to `b`, where it may go as a half power at both ends.
fn smoothed(rule: &GaussLegendre, a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    rule.integrate(-FRAC_PI_2, FRAC_PI_2, |s| {
        half * s.cos() * f(middle + half * s.sin())
    })
}

/// Area that two discs of radii `r` and `q` share, their centres `d` apart.
fn lens(r: f64, q: f64, d: f64) -> f64 {
    if d >= r + q {
        return 0.0;
    }
    let small = r.min(q);
    if d <= (r - q).abs() {
        return PI * small * small;
    }
    // Four times the triangle of r, q and d (Heron), and its angles at the two centres.
    let k = ((d + r + q) * (r + q - d) * (d + r - q) * (d + q - r))
        .max(0.0)
        .sqrt();
    let (at_r, at_q) = (
        k.atan2((d - q) * (d + q) + r * r),
        k.atan2((d - r) * (d + r) + q * q),
    );
    r * r * at_r + q * q * at_q - 0.5 * k
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Error over the volume of the sphere.
    #[track_caller]
    fn close(found: f64, expected: f64, error: f64) {
        assert!(
            (found - expected).abs() <= error * BALL,
            "{found} {expected}"
        );
    }

    fn boxed(low: [f64; 3], high: [f64; 3]) -> f64 {
        in_box(low.into(), high.into())
    }

    const FAR: f64 = 7.0;

    #[test]
    fn caps_halves_and_octants() {
        let far = [FAR; 3];
        close(boxed([-FAR, -FAR, 0.0], far), BALL / 2.0, 1e-15);
        close(boxed([-FAR, 0.0, 0.0], far), BALL / 4.0, 1e-15);
        close(boxed([0.0; 3], far), BALL / 8.0, 1e-15);
        close(boxed([-FAR; 3], far), BALL, 0.0);
        close(boxed([1.0, -1.0, -1.0], far), 0.0, 0.0);
        close(boxed([-0.1; 3], [0.2; 3]), 0.027, 1e-15);
        // A cap of height h: pi h^2 (3 - h) / 3; a slice between two caps; also turned into the other axes.
        for h in [1e-3f64, 0.2, 1.0, 1.7] {
            let cap = PI * h * h * (3.0 - h) / 3.0;
            for axis in 0..3 {
                let mut low = [-FAR; 3];
                low[axis] = 1.0 - h;
                close(boxed(low, far), cap, 1e-15);
            }
        }
        // The cube inscribed in a sphere cuts off six caps of it, which do not overlap.
        let half = 1.0 / 2f64.sqrt();
        let caps = 6.0 * PI / 3.0 * (1.0 - half).powi(2) * (2.0 + half);
        close(boxed([-half; 3], [half; 3]), BALL - caps, 2e-15);
    }

    proptest! {
        /// The parts on both sides of any three planes are the ball; each is the integral of its slices.
        #[test]
        fn corners_against_slices(at in prop::array::uniform3(-1.1..1.1_f64)) {
            let [a, b, c] = at;
            let mut sum = 0.0;
            for k in 0..8 {
                let (mut low, mut high) = ([-FAR; 3], [FAR; 3]);
                for axis in 0..3 {
                    if k >> axis & 1 == 0 { high[axis] = at[axis] } else { low[axis] = at[axis] }
                }
                sum += boxed(low, high);
            }
            prop_assert!((sum - BALL).abs() < 1e-14);
            let expected = slices(a, b, c);
            prop_assert!((corner(a, b, c) - expected).abs() < 1e-10, "{} {}", corner(a, b, c), expected);
        }
    }

    /// The part `x > a, y > b, z > c` of the unit ball as an integral over x of one over y of lengths in z.
    fn slices(a: f64, b: f64, c: f64) -> f64 {
        let fine = GaussLegendre::new(NonZeroUsize::new(80).unwrap());
        let pieces = |low: f64, high: f64, breaks: &[f64], f: &dyn Fn(f64) -> f64| -> f64 {
            let mut all = vec![low, high];
            all.extend(breaks.iter().filter(|x| low < **x && **x < high));
            all.sort_by(f64::total_cmp);
            all.windows(2).map(|w| smoothed(&fine, w[0], w[1], f)).sum()
        };
        let root = |x: f64| x.max(0.0).sqrt();
        let slice = |x: f64| {
            let r = root(1.0 - x * x);
            let flat = root(r * r - c * c);
            let edge = if c >= 0.0 { flat } else { r };
            if b >= edge || (c >= r) {
                return 0.0;
            }
            pieces(b.max(-edge), edge, &[-flat, flat], &|y| {
                let z = root(r * r - y * y);
                z - c.clamp(-z, z)
            })
        };
        if a >= 1.0 {
            return 0.0;
        }
        let [p, q, s] = [b, c, b.hypot(c)].map(|d| root(1.0 - d * d));
        pieces(a.max(-1.0), 1.0, &[-p, p, -q, q, -s, s], &slice)
    }

    #[test]
    fn a_cylinder_through_the_centre_is_a_napkin_ring() {
        // A hole of radius q through the middle leaves 4/3 pi (1 - q^2)^(3/2).
        for q in [1e-3, 0.3, 0.8, 0.999, 0.999_999] {
            let ring = BALL * (1.0 - q * q) * f64::sqrt(1.0 - q * q);
            close(in_cylinder((-FAR, FAR), q, 0.0), BALL - ring, 1e-13);
        }
        // Half of it by height, and a piece that lies within the sphere whole.
        close(
            in_cylinder((0.0, FAR), 0.3, 0.0),
            in_cylinder((-FAR, FAR), 0.3, 0.0) / 2.0,
            1e-13,
        );
        close(in_cylinder((-0.1, 0.2), 0.3, 0.1), 0.3 * PI * 0.09, 1e-13);
        close(
            in_cylinder((-0.1, 0.2), FAR, 1.0),
            cap(-0.1) - cap(0.2),
            1e-13,
        );
        assert_eq!(in_cylinder((-FAR, FAR), FAR, 8.0), 0.0);
    }

    #[test]
    fn vivianis_cylinder() {
        // Diameter = radius of the sphere, through its centre (Viviani 1692): (2 pi / 3 - 8 / 9) for both halves.
        let viviani = 2.0 * (PI / 3.0 - 4.0 / 9.0);
        close(in_cylinder((-FAR, FAR), 0.5, 0.5), viviani, 1e-12);
    }

    #[test]
    fn a_wide_cylinder_is_a_plane() {
        // The surface of a cylinder of radius q bends away from the plane by less than 1 / (2 q).
        for distance in [-0.9, -0.2, 0.0, 0.5, 0.99] {
            let q = 1e7;
            close(
                in_cylinder((-FAR, FAR), q, q + distance),
                cap(distance),
                1e-7,
            );
        }
    }

    /// The rule against itself with many times the points, on bad cases: breaks that nearly coincide.
    #[test]
    fn the_rule_is_accurate() {
        let fine = |ends: (f64, f64), q: f64, d: f64| {
            let (low, high) = (ends.0.max(-1.0), ends.1.min(1.0));
            let mut breaks = vec![low, high];
            for rho in [(q - d).abs(), q + d] {
                let z = (1.0 - rho * rho).max(0.0).sqrt();
                breaks.extend([-z, z].into_iter().filter(|z| low < *z && *z < high));
            }
            breaks.sort_by(f64::total_cmp);
            let area = |z: f64| lens((1.0 - z * z).max(0.0).sqrt(), q, d);
            // Tanh-sinh: the trapezoidal rule after z = m + h tanh(pi/2 sinh t).
            let step = 1.0 / 256.0;
            let pieces = breaks.windows(2).map(|w| {
                let (m, h) = (0.5 * (w[0] + w[1]), 0.5 * (w[1] - w[0]));
                let points = (-1024..=1024).map(|k| {
                    let t = f64::from(k) * step;
                    let u = FRAC_PI_2 * t.sinh();
                    let weight = FRAC_PI_2 * t.cosh() / (u.cosh() * u.cosh());
                    step * h * weight * area(m + h * u.tanh())
                });
                points.sum::<f64>()
            });
            pieces.sum::<f64>()
        };
        let mut worst = (0.0, (0.0, 0.0, (0.0, 0.0)));
        for q in [0.01, 0.3, 0.7, 0.999, 1.0, 1.3, 3.0, 40.0] {
            for d in [
                1e-9,
                1e-4,
                0.01,
                0.1,
                0.5,
                0.999 * q,
                q,
                1.001 * q,
                q + 0.5,
                q + 0.99,
            ] {
                for ends in [(-2.0, 2.0), (-0.3, 0.6), (0.5, 2.0), (-1.0, -0.99)] {
                    let error = (in_cylinder(ends, q, d) - fine(ends, q, d)).abs() / BALL;
                    if error > worst.0 {
                        worst = (error, (q, d, ends));
                    }
                }
            }
        }
        assert!(worst.0 < 1e-10, "{worst:?}");
    }
}
