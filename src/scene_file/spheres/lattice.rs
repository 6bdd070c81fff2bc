//! Regular lattices, shaken or not.

use nalgebra::Vector3;
use rand_chacha::ChaCha8Rng;

use super::initial_motion::{InitialMotion, MOST_SPHERES};
use crate::Vec3;
use crate::random::symmetric;
use crate::scene_file::document::Document;
use crate::scene_file::file;
use crate::scene_file::file::OneOrMany;

/// The nodes of a lattice, the first axis fastest.
pub(super) fn fill(
    document: &mut Document<'_>,
    path: &str,
    lattice: &file::Lattice,
    random: &mut ChaCha8Rng,
) -> Option<Vec<InitialMotion>> {
    let counts = lattice.count.0;
    let number = counts
        .iter()
        .try_fold(1_usize, |n, &c| n.checked_mul(c as usize));
    let number = number.filter(|n| (1..=MOST_SPHERES).contains(n));
    let expected = format!("each >= 1 and at most {MOST_SPHERES} spheres");
    document.demand(
        number.is_some(),
        (path, "count"),
        format!("{counts:?}"),
        &expected,
    );
    let jitter_in_range = (0.0..=0.5).contains(&lattice.jitter);
    document.demand(
        jitter_in_range,
        (path, "jitter"),
        lattice.jitter,
        "0 <= jitter <= 0.5 [-]",
    );
    let spacing = match &lattice.spacing {
        OneOrMany::One(s) => Some(Vec3::repeat(*s)),
        OneOrMany::Many(s) => <[f64; 3]>::try_from(s.as_slice()).ok().map(Vec3::from),
    };
    let spacing = spacing.filter(|s| s.iter().all(|&s| s > 0.0));
    let found = match &lattice.spacing {
        OneOrMany::One(s) => s.to_string(),
        OneOrMany::Many(s) => format!("{s:?}"),
    };
    document.demand(
        spacing.is_some(),
        (path, "spacing"),
        found,
        "one or three lengths > 0 [m]",
    );
    let axes = axes(document, &format!("{path}.axes"), lattice.axes.as_deref());
    let (number, spacing, axes) = (number?, spacing?, axes?);
    if !jitter_in_range {
        return None;
    }
    let mut placed = Vec::with_capacity(number);
    for k in 0..counts[2] {
        for j in 0..counts[1] {
            for i in 0..counts[0] {
                let node = Vector3::new(i, j, k).map(f64::from);
                let shift = Vec3::from_fn(|_, _| symmetric(random)) * lattice.jitter;
                let local = (node + shift).component_mul(&spacing);
                let position = Vec3::from(lattice.origin)
                    + axes[0] * local.x
                    + axes[1] * local.y
                    + axes[2] * local.z;
                placed.push(InitialMotion::at(position));
            }
        }
    }
    Some(placed)
}

/// Gram-Schmidt on the two given directions, the third by their cross product.
fn axes(
    document: &mut Document<'_>,
    path: &str,
    given: Option<&[file::Vector]>,
) -> Option<[Vec3; 3]> {
    let Some(given) = given else {
        return Some([Vec3::x(), Vec3::y(), Vec3::z()]);
    };
    let expected = "two directions that are not parallel, as [[1, 0, 0], [0, 1, 0]]";
    let pair = match *given {
        [x, y] => {
            let x = Vec3::from(x).try_normalize(0.0);
            let y = Vec3::from(y).try_normalize(0.0);
            x.zip(y)
                .and_then(|(x, y)| Some((x, (y - x * x.dot(&y)).try_normalize(1e-9)?)))
        }
        _ => None,
    };
    document.demand(
        pair.is_some(),
        path,
        format!("{} directions", given.len()),
        expected,
    );
    pair.map(|(x, y)| [x, y, x.cross(&y)])
}
