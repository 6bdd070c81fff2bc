//! Closest points on a segment and a triangle.

use crate::Vec3;

/// The closest point of segment `a`-`b` to `p`.
pub(super) fn on_segment(a: Vec3, b: Vec3, p: Vec3) -> Vec3 {
    let ab = b - a;
    let t = (p - a).dot(&ab);
    let length2 = ab.norm_squared();
    if t <= 0.0 {
        a
    } else if t >= length2 {
        b
    } else {
        a + ab * (t / length2)
    }
}

/// Part of a triangle `(a, b, c)` that a closest point lies on: 0 its face; 1, 2, 3 the edges ab, bc, ca;
/// 4, 5, 6 the vertices a, b, c.
pub(super) type TriangleFeature = usize;

/// The closest point of a triangle to `p`, and the part it lies on.
///
/// Source: C. Ericson, *Real-Time Collision Detection*, 2005, section 5.1.5.
pub(super) fn on_triangle(&[a, b, c]: &[Vec3; 3], p: Vec3) -> (Vec3, TriangleFeature) {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (a, 4);
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return (b, 5);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (a + ab * (d1 / (d1 - d3)), 1);
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return (c, 6);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (a + ac * (d2 / (d2 - d6)), 3);
    }
    let va = d3 * d6 - d5 * d4;
    let (e, f) = (d4 - d3, d5 - d6);
    if va <= 0.0 && e >= 0.0 && f >= 0.0 {
        return (b + (c - b) * (e / (e + f)), 2);
    }
    let sum = va + vb + vc;
    (a + ab * (vb / sum) + ac * (vc / sum), 0)
}
