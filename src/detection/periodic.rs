//! Pairs of spheres in a periodic cell: the grid of the broad phase over the cell and a rim of copies around it.

use super::grid::pairs_up_to;
use crate::Vec3;
use crate::parallel::Pool;
use crate::spatial::cell::{Cell, HERE, Image};

/// All pairs `i < j` of present spheres and the image `k` of `j` (copy `x_j + k L`) whose distance is below the sum
/// of their `size` \[m\], `[N]`, ascending.
/// A sphere and its own copies are no pair: they never move against each other.
pub(crate) fn periodic_pairs(
    cell: &Cell,
    position: &[Vec3],
    present: &[bool],
    size: &[f64],
    pool: &Pool,
) -> Vec<(u32, u32, Image)> {
    periodic_pairs_up_to(usize::MAX, cell, position, present, size, pool)
}

/// As [`periodic_pairs`]; the search ends where there are more than `most` pairs.
pub(crate) fn periodic_pairs_up_to(
    most: usize,
    cell: &Cell,
    position: &[Vec3],
    present: &[bool],
    size: &[f64],
    pool: &Pool,
) -> Vec<(u32, u32, Image)> {
    let largest = size.iter().copied().fold(0.0, f64::max);
    let face = |side: usize| Vec3::from_fn(|k, _| cell.faces(k).map_or(0.0, |faces| faces[side]));
    let inside = (face(0), face(1));
    // The spheres, put back into the cell, then their copies in reach of it.
    let (mut place, mut size_of) = (Vec::with_capacity(position.len()), size.to_vec());
    let (mut copies, mut owner) = (Vec::new(), Vec::new());
    for (i, &x) in position.iter().enumerate() {
        let back = cell.wrapped(x);
        place.push(back);
        if present[i] {
            let images = cell.copies(back, inside, size[i] + largest);
            for image in images.filter(|image| *image != HERE) {
                copies.push(back + cell.shift(image));
                owner.push((i as u32, image));
                size_of.push(size[i]);
            }
        }
    }
    place.extend(copies);
    let mut there = present.to_vec();
    there.resize(place.len(), true);

    let home: Vec<Image> = position.iter().map(|&x| cell.image(x)).collect();
    let mut pairs = Vec::new();
    for (i, j) in pairs_up_to(most, &place, &there, &size_of, pool) {
        let (j, rim) = match (j as usize).checked_sub(position.len()) {
            Some(copy) => owner[copy],
            None => (j, HERE),
        };
        // Each pair through a face is found twice, from either side; pairs of two copies are a pair in the cell.
        if i < j {
            let [a, b] = [i, j].map(|i| home[i as usize]);
            let image = std::array::from_fn(|k| a[k] - b[k] + rim[k]);
            pairs.push((i, j, image));
        }
    }
    pairs.sort_unstable();
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

        /// All images against all pairs, for one to three periodic axes, spheres far outside of the cell, and skins larger
        /// than the cell.
        #[test]
        fn the_rim_finds_what_all_images_find(
            spheres in prop::collection::vec((prop::array::uniform3(-9.0..9.0_f64), 0.05..0.5_f64), 0..25),
            axes in 1_usize..8,
            edges in prop::array::uniform3(1.0..4.0_f64),
            skin in 0.0..1.5_f64,
        ) {
            let range = |k: usize| (axes >> k & 1 == 1).then(|| [-0.7, edges[k] - 0.7]);
            let cell = Cell::new([range(0), range(1), range(2)]);
            let position: Vec<Vec3> = spheres.iter().map(|(p, _)| Vec3::from(*p)).collect();
            let radius: Vec<f64> = spheres.iter().map(|(_, r)| *r).collect();
            let present: Vec<bool> = (0..position.len()).map(|i| i % 7 != 3).collect();
            let size: Vec<f64> = radius.iter().map(|r| r + 0.5 * skin).collect();
            let mut expected = Vec::new();
            for i in 0..position.len() {
                for j in i + 1..position.len() {
                    if !(present[i] && present[j]) {
                        continue;
                    }
                    let reach = size[i] + size[j];
                    let around = (position[i], position[i]);
                    for image in cell.copies(position[j], around, reach) {
                        let arm = position[i] - position[j] - cell.shift(image);
                        if arm.norm() < reach {
                            expected.push((i as u32, j as u32, image));
                        }
                    }
                }
            }
            expected.sort_unstable();
            prop_assert_eq!(periodic_pairs(&cell, &position, &present, &size, &Pool::default()), expected);
        }
    }
}
