//! Bounds of a row's Delassus operator along its normal and across it, one row or one in each lane.

use super::law::Number;
use nalgebra::Matrix3;

use crate::Vec3;

/// Coupling of normal and tangent over `sqrt(w_n w_t)` that is rounding.
const UNCOUPLED: f64 = 1e-12;

/// Which elements of a symmetric matrix say all of it: xx, yy, zz, yz, zx, xy.
pub(crate) const ELEMENTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)];

/// Constants of [`bounds`], to be given as numbers of its kind.
pub(crate) const CONSTANTS: [f64; 5] = [0.0, 0.5, 1.0, UNCOUPLED, f64::MIN_POSITIVE];

/// `(w_n, w_t)` such that `operator` is at most `w_n n n^T + w_t (1 - n n^T)` \[1/kg\].
pub(crate) fn bounding_scale(operator: &Matrix3<f64>, n: Vec3) -> (f64, f64) {
    bounds(ELEMENTS.map(|at| operator[at]), n.into(), CONSTANTS)
}

/// [`bounding_scale`] of the operators of these [`ELEMENTS`]. Without closures, which would not be compiled for wide registers.
#[inline(always)]
pub(crate) fn bounds<N: Number>(operator: [N; 6], n: [N; 3], constants: [N; 5]) -> (N, N) {
    let [zero, half, one, uncoupled, tiny] = constants;
    let [xx, yy, zz, yz, zx, xy] = operator;
    let of_n = [
        dot([xx, xy, zx], n),
        dot([xy, yy, yz], n),
        dot([zx, yz, zz], n),
    ];
    let w_n = dot(of_n, n);
    let mut across = of_n;
    for i in 0..3 {
        across[i] = of_n[i] - n[i] * w_n;
    }
    // The larger of the two eigenvalues across the normal: their mean, and by what the operator there differs from it.
    let mean = half * (xx + yy + zz - w_n);
    let mut off = operator;
    for (k, (i, j)) in ELEMENTS.into_iter().enumerate() {
        let normal = across[i] * n[j] + n[i] * across[j] + n[i] * n[j] * (w_n - mean);
        off[k] = off[k] - normal;
        if i == j {
            off[k] = off[k] - mean;
        }
    }
    let [a, b, c, d, e, f] = off;
    let w_t = mean + (half * dot([a, b, c], [a, b, c]) + dot([d, e, f], [d, e, f])).root();
    // The update of a row treats normal and tangent side by side: a bound keeps it from overshooting where they couple.
    let coupling = dot(across, across).root();
    let share = coupling.over((w_n * w_t).root().or_larger(tiny));
    // Where a joint leaves nothing but the normal, all across it is rounding.
    let share = coupling.within(uncoupled * w_n, zero, share.within(uncoupled, zero, share));
    // `coupling <= sqrt(w_n w_t)`: a larger share is the rounding of a small `w_t`.
    let share = share.within(one, share, one);
    (w_n * (one + share), w_t * (one + share))
}

#[inline(always)]
fn dot<N: Number>(a: [N; 3], b: [N; 3]) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// What bounds may leave out over the operator: rounding, and almost along the normal also coupling of up to `UNCOUPLED`.
    const ROUNDING: f64 = 1e-12;
    const ALMOST: f64 = 1.01 * UNCOUPLED;

    /// `w_n n n^T + w_t (1 - n n^T)` less the operator has no negative eigenvalue but for what is `left_out`, and the bounds are no larger
    /// than they must be.
    fn judge(root: [f64; 9], n: [f64; 3], rank: usize, left_out: f64) -> Result<(), TestCaseError> {
        let n = Vec3::from(n).normalize();
        let mut root = Matrix3::from_row_slice(&root);
        root.columns_mut(rank.min(2), 3 - rank.min(2)).fill(0.0);
        let operator = root * root.transpose() + Matrix3::identity() * (rank == 3) as u8 as f64;
        let (w_n, w_t) = bounding_scale(&operator, n);
        let normal = n * n.transpose();
        let bound = normal * w_n + (Matrix3::identity() - normal) * w_t;
        let room = (bound - operator).symmetric_eigenvalues();
        let size = operator.norm();
        prop_assert!(room.min() >= -left_out * size, "{room} of {size}");
        let along = n.dot(&(operator * n));
        prop_assert!(w_n >= along, "{w_n:e} {along:e}");
        prop_assert!(w_n <= 2.0 * along + 1e-12 * size, "{w_n:e} {along:e}");
        // Along a normal that does not couple they are exact.
        let axes = operator.symmetric_eigen();
        let (w_n, w_t) = bounding_scale(&operator, axes.eigenvectors.column(0).into());
        let others = axes.eigenvalues[1].max(axes.eigenvalues[2]);
        prop_assert!(
            (w_n - axes.eigenvalues[0]).abs() <= 1e-7 * size,
            "{w_n} {}",
            axes.eigenvalues
        );
        prop_assert!(
            (w_t - others).abs() <= 1e-7 * size,
            "{w_t} {}",
            axes.eigenvalues
        );
        Ok(())
    }

    fn one_column([x, y, z]: [f64; 3]) -> [f64; 9] {
        [x, 0.0, 0.0, y, 0.0, 0.0, z, 0.0, 0.0]
    }

    /// One column couples normal and tangent wholly: rounding of the small `w_t` made the share more than 1, `w_n` too large.
    #[test]
    fn a_small_bound_across_the_normal_leaves_the_one_along_it() {
        // Too large by 1.6e-12, and 3e298 of 0.57.
        let root = [0.5218620846464591, 0.8013639619442328, -0.7208471879127485];
        let n = [-0.3981493020476773, -0.6069038203282322, 0.5390970563732708];
        judge(one_column(root), n, 1, ROUNDING).unwrap();
        let root = [0.19999998000000002, 0.19999998000000002, -0.69999994];
        judge(one_column(root), [0.2, 0.2, -0.7], 1, ALMOST).unwrap();
    }

    proptest! {
        #[test]
        fn bounds_are_bounds(
            root in prop::array::uniform9(-1.0..1.0_f64),
            n in prop::array::uniform3(-1.0..1.0_f64),
            rank in 0_usize..4,
        ) {
            judge(root, n, rank, ROUNDING)?;
        }

        /// What moves along one direction alone, almost the normal, has a `w_t` of rounding, zero too: `w_n` was 1e300 there.
        #[test]
        fn a_direction_almost_along_the_normal_is_bounded(
            n in prop::array::uniform3(-1.0..1.0_f64),
            aside in prop::array::uniform3(-1.0..1.0_f64),
            tilt in 0.0..16.0_f64,
        ) {
            let column = Vec3::from(n).normalize() + Vec3::from(aside) * 10.0_f64.powf(-tilt);
            judge(one_column(column.into()), n, 1, ALMOST)?;
        }
    }
}
