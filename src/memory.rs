//! How lists that grow with a scene take memory: an eighth more than they need, where those that double take up to twice as much.

use std::ops::Range;

/// Lets `list` hold `count` items.
#[inline]
pub(crate) fn make_room<T>(list: &mut Vec<T>, count: usize) {
    if count > list.capacity() {
        list.reserve_exact(count + (count / 8).max(LEAST) - list.len());
    }
}

/// Lets `list` have `count` items, new ones being `value`.
pub(crate) fn resize<T: Clone>(list: &mut Vec<T>, count: usize, value: T) {
    make_room(list, count);
    list.resize(count, value);
}

/// Lets `list` have the items of `other`.
pub(crate) fn copy<T: Clone>(list: &mut Vec<T>, other: &[T]) {
    make_room(list, other.len());
    other.clone_into(list);
}

/// Appends an item.
#[inline]
pub(crate) fn push<T>(list: &mut Vec<T>, item: T) {
    make_room(list, list.len() + 1);
    list.push(item);
}

/// Appends the items of a `run` of `other`, if it has any.
pub(crate) fn append<T: Clone>(list: &mut Vec<T>, other: &[T], run: &Range<usize>) {
    if let Some(run) = other.get(run.clone()) {
        make_room(list, list.len() + run.len());
        list.extend_from_slice(run);
    }
}

/// Items to spare in a short list.
const LEAST: usize = 4;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_grow_by_an_eighth() {
        let mut list: Vec<usize> = Vec::new();
        let mut grown = 0;
        for k in 0..100_000 {
            let before = list.capacity();
            push(&mut list, k);
            grown += usize::from(list.capacity() != before);
            assert!(list.capacity() <= list.len() + (list.len() / 8).max(LEAST));
        }
        assert!(grown < 100 && list.into_iter().eq(0..100_000));
    }

    #[test]
    fn lists_that_are_long_enough_stay_where_they_are() {
        let mut list = vec![7_u8; 90];
        resize(&mut list, 100, 3);
        assert_eq!((list.capacity(), &list[89..92]), (112, &[7, 3, 3][..]));
        let place = list.as_ptr();
        resize(&mut list, 112, 1);
        copy(&mut list, &[5; 20]);
        assert_eq!((list.as_ptr(), &list[..]), (place, &[5; 20][..]));
    }
}
