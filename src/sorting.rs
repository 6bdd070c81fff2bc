//! Counting sort: items whose keys are small whole numbers, in time that grows with both.

use crate::memory::{make_room, resize};

/// Into `first` where the items of each key begin when they are sorted by their `keys`, and the end of the last; keys are below
/// `count`.
pub(crate) fn first_places(keys: impl Iterator<Item = u32>, count: usize, first: &mut Vec<u32>) {
    first.clear();
    first.resize(count + 1, 0);
    for key in keys {
        first[key as usize + 1] += 1;
    }
    for k in 1..first.len() {
        first[k] += first[k - 1];
    }
}

/// Puts `new` items into a list: each before that which is at its place in `places`, which ascend.
pub(crate) fn insert_all<T>(items: &mut Vec<T>, places: &[usize], new: Vec<T>) {
    let mut end = items.len();
    make_room(items, end + new.len());
    items.extend(new);
    for (before, &place) in places.iter().enumerate().rev() {
        items[place..end + before + 1].rotate_right(before + 1);
        end = place;
    }
}

/// Into `sorted` the `items` by ascending key; of equal keys in the order they come in. Keys are below `count`. `ends` then has
/// where each key's items end.
pub(crate) fn counting_sort<T: Copy + Default>(
    items: impl Iterator<Item = T> + Clone,
    (key, count): (impl Fn(&T) -> u32, usize),
    ends: &mut Vec<u32>,
    sorted: &mut Vec<T>,
) {
    let keys = items.clone().map(|item| key(&item));
    first_places(keys, count, ends);
    sorted.clear();
    let count = ends.last().map_or(0, |&all| all as usize);
    resize(sorted, count, T::default());
    for item in items {
        let next = &mut ends[key(&item) as usize];
        sorted[*next as usize] = item;
        *next += 1;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// As one after the other.
        #[test]
        fn all_are_inserted_before_their_places(
            items in prop::collection::vec(0..100_u32, 0..20),
            places in prop::collection::vec(0..21_usize, 0..10),
        ) {
            let last = items.len();
            let mut places: Vec<usize> = places.iter().map(|place| last.min(*place)).collect();
            places.sort_unstable();
            let new: Vec<u32> = (100..).take(places.len()).collect();
            let (mut all, mut expected) = (items.clone(), items);
            insert_all(&mut all, &places, new.clone());
            for (k, (place, new)) in places.iter().zip(new).enumerate() {
                expected.insert(place + k, new);
            }
            prop_assert_eq!(all, expected);
        }
    }
}
