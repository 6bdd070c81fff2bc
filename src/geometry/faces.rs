//! The triangles of each face, along its longest side: of many only a few lie beside a point.

use rstar::{AABB, Envelope};

use crate::Vec3;
use crate::sorting::counting_sort;

/// Triangles by face.
#[derive(Debug, Clone)]
pub(super) struct Faces {
    /// Where those of each face end.
    ends: Vec<u32>,
    /// By where they begin along their face's axis.
    triangles: Vec<u32>,
    /// Where each begins there, and where those of its face up to it end at most \[m\].
    spans: Vec<[f64; 2]>,
    /// The axis along which each face is longest.
    axes: Vec<u8>,
}

impl Faces {
    /// Of triangles `[T]` whose faces and bounding boxes \[m\] are given.
    pub(super) fn new(face: &[u32], bounds: &[AABB<[f64; 3]>]) -> Self {
        let (mut ends, mut triangles) = (Vec::new(), Vec::new());
        let count = face.iter().max().map_or(0, |&last| last as usize + 1);
        let key = (|&t: &u32| face[t as usize], count);
        counting_sort(0..face.len() as u32, key, &mut ends, &mut triangles);
        let mut faces = Self {
            ends,
            triangles,
            spans: Vec::new(),
            axes: Vec::new(),
        };
        for face in 0..count {
            let own = faces.range(face);
            let all = own.clone().map(|k| bounds[faces.triangles[k] as usize]);
            let all = all.fold(AABB::new_empty(), |all, own| all.merged(&own));
            let longest = |a: &usize, b: &usize| {
                let length = |axis: usize| all.upper()[axis] - all.lower()[axis];
                length(*a).total_cmp(&length(*b))
            };
            let axis = (0..3).max_by(longest).unwrap_or(0);
            let begin = |&t: &u32| bounds[t as usize].lower()[axis];
            faces.triangles[own.clone()].sort_by(|s, t| begin(s).total_cmp(&begin(t)));
            let mut end = f64::NEG_INFINITY;
            for t in &faces.triangles[own] {
                end = end.max(bounds[*t as usize].upper()[axis]);
                faces.spans.push([begin(t), end]);
            }
            faces.axes.push(axis as u8);
        }
        faces
    }

    /// At least the triangles of a face whose boxes meet the cube of half-width `range` \[m\] around `x`.
    pub(super) fn beside(&self, face: u32, x: Vec3, range: f64) -> &[u32] {
        let own = self.range(face as usize);
        let place = x[usize::from(self.axes[face as usize])];
        let spans = &self.spans[own.clone()];
        let end = spans.partition_point(|[begin, _]| *begin <= place + range);
        let start = spans[..end].partition_point(|[_, end]| *end < place - range);
        &self.triangles[own][start..end]
    }

    fn range(&self, face: usize) -> std::ops::Range<usize> {
        let first = face.checked_sub(1).map_or(0, |before| self.ends[before]);
        first as usize..self.ends[face] as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Whatever the boxes, of which a few are long, and the face that they belong to.
        #[test]
        fn all_that_meet_a_cube_are_beside_it(
            boxes in prop::collection::vec((prop::array::uniform3(-1.0..1.0_f64), prop::array::uniform3(0.0..1.0_f64).prop_map(|size| size.map(|x| x.powi(4))), 0_u32..4), 1..60),
            x in prop::array::uniform3(-1.0..1.3_f64),
            range in 0.0..0.2_f64,
        ) {
            let around = |low: [f64; 3], size: [f64; 3]| {
                AABB::from_corners(low, (Vec3::from(low) + Vec3::from(size)).into())
            };
            let bounds: Vec<_> = boxes.iter().map(|&(low, size, _)| around(low, size)).collect();
            let face: Vec<u32> = boxes.iter().map(|&(_, _, face)| face).collect();
            let faces = Faces::new(&face, &bounds);
            let x = Vec3::from(x);
            let cube = AABB::from_corners(x.add_scalar(-range).into(), x.add_scalar(range).into());
            let last = face.iter().copied().fold(0, u32::max);
            for own in 0..=last {
                let beside = faces.beside(own, x, range);
                prop_assert!(beside.iter().all(|&t| face[t as usize] == own));
                for t in (0..face.len()).filter(|&t| face[t] == own && bounds[t].intersects(&cube)) {
                    prop_assert!(beside.contains(&(t as u32)), "{t} of face {own}");
                }
            }
        }
    }
}
