//! The threads of a simulation: joined when it goes, so that a library that is unloaded leaves none behind.
//!
//! Work is cut by the data alone and every piece writes its own part, so that results are the same for any number of
//! threads. A sleeping worker takes a tenth of a millisecond to wake, longer than a sweep: what is cut many times runs
//! [`Pool::within`] workers that stay awake.

use std::collections::LinkedList;
use std::fmt;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread::{Builder, JoinHandle};

use rayon::slice::ParallelSliceMut;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::memory::make_room;

/// Blocks of contacts from which handing out, which takes as long as a dozen of them, costs less than it gains.
const WORTH: usize = 24;
/// Items of a piece where each is little work.
const PIECE: usize = 512;
/// How often a worker looks for work in vain before it lets others have its core each time.
const PATIENCE: usize = 1000;

/// Threads, made with the first work for them.
#[derive(Clone, Default)]
pub(crate) struct Pool(Arc<Threads>);

#[derive(Default)]
struct Threads {
    count: usize,
    /// Nothing if the system refuses to give them: then the caller's thread does all.
    workers: OnceLock<Option<Workers>>,
}

struct Workers {
    pool: Option<ThreadPool>,
    threads: Vec<JoinHandle<()>>,
}

impl fmt::Debug for Pool {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Pool({})", self.0.count)
    }
}

impl Workers {
    fn new(count: usize) -> Option<Self> {
        let mut threads = Vec::new();
        let pool = ThreadPoolBuilder::new()
            .num_threads(count)
            .spawn_handler(|thread| {
                let name = format!("sphere-dda {}", thread.index());
                threads.push(Builder::new().name(name).spawn(|| thread.run())?);
                Ok(())
            })
            .build();
        Some(Self {
            pool: Some(pool.ok()?),
            threads,
        })
    }
}

impl Drop for Workers {
    fn drop(&mut self) {
        // Workers end when their pool goes.
        drop(self.pool.take());
        for thread in self.threads.drain(..) {
            // A panic was reported where its work was waited for.
            let _ = thread.join();
        }
    }
}

impl Pool {
    /// A pool of so many threads; one or none: the caller's alone.
    pub(crate) fn new(threads: usize) -> Self {
        Self(Arc::new(Threads {
            count: threads,
            workers: OnceLock::new(),
        }))
    }

    /// How many threads.
    pub(crate) fn threads(&self) -> usize {
        self.0.count
    }

    /// Does `work` where [`Self::each`] and [`Self::pieces`] share it out, to workers that are awake until it ends.
    pub(crate) fn within<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        if self.0.count < 2 {
            return work();
        }
        let workers = self.0.workers.get_or_init(|| Workers::new(self.0.count));
        match workers.as_ref().and_then(|workers| workers.pool.as_ref()) {
            Some(pool) => pool.install(|| awake(work)),
            None => work(),
        }
    }

    /// Does `work` with each of `items`, side by side if they are worth as much as [`WORTH`] blocks of contacts (`size`).
    pub(crate) fn each<T: Send>(
        &self,
        size: usize,
        items: &mut [T],
        work: impl Fn(&mut T) + Sync + Send,
    ) {
        if !self.shares() || items.len() < 2 || size < WORTH {
            return items.iter_mut().for_each(work);
        }
        each_of(items, &work);
    }

    /// Does `work` with pieces of `items`, each with the index of its first, side by side where it may, and joins what it finds:
    /// in an order that depends on the number of items alone.
    pub(crate) fn pieces<P: Pieces, R: Send>(
        &self,
        items: P,
        work: impl Fn(usize, P) -> R + Sync,
        join: impl Fn(R, R) -> R + Sync,
    ) -> R {
        share(self.shares(), 0, items, &work, &join)
    }

    /// Lets each of `items` be the value of its index, side by side where it may.
    pub(crate) fn fill<T: Send>(&self, items: &mut [T], value: impl Fn(usize) -> T + Sync) {
        let work = |first, items: &mut [T]| {
            for (k, item) in (first..).zip(items) {
                *item = value(k);
            }
        };
        self.pieces(items, work, |(), ()| ());
    }

    /// Sorts `items`, of which equal ones are the same, side by side where it may.
    pub(crate) fn sort<T: Ord + Send>(&self, items: &mut [T]) {
        match self.shares() && items.len() > PIECE {
            true => items.par_sort_unstable(),
            false => items.sort_unstable(),
        }
    }

    /// Appends to `found` what `work` finds in pieces of `0..count`, in their order.
    pub(crate) fn collect<T: Send>(
        &self,
        count: usize,
        work: impl Fn(Range<usize>, &mut Vec<T>) + Sync,
        found: &mut Vec<T>,
    ) {
        if !self.shares() || count <= PIECE {
            return work(0..count, found);
        }
        let here = |_, range| {
            let mut own = Vec::new();
            work(range, &mut own);
            LinkedList::from([own])
        };
        let all = self.pieces(0..count, here, chained);
        let count = found.len() + all.iter().map(Vec::len).sum::<usize>();
        make_room(found, count);
        found.extend(all.into_iter().flatten());
    }

    /// Whether there are others to share with, and they are at hand.
    fn shares(&self) -> bool {
        self.0.count > 1 && rayon::current_thread_index().is_some()
    }
}

/// Does `work` while all other workers look for what it shares.
fn awake<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    let done = AtomicBool::new(false);
    let this = rayon::current_thread_index();
    rayon::scope(|scope| {
        scope.spawn_broadcast(|_, worker| {
            if Some(worker.index()) != this {
                look_for_work(&done);
            }
        });
        // Even if it panics.
        let _end = SetOnDrop(&done);
        work()
    })
}

/// Does `work` with each of `items`, side by side.
fn each_of<T: Send>(items: &mut [T], work: &(impl Fn(&mut T) + Sync)) {
    match items {
        [] => {}
        [item] => work(item),
        _ => {
            let (low, high) = items.split_at_mut(items.len() / 2);
            join_awake(|| each_of(low, work), || each_of(high, work));
        }
    }
}

/// Does both, side by side where another thread is free. While another does `high` this one stays awake: one that sleeps takes long to
/// wake.
fn join_awake<A: Send, B: Send>(
    low: impl FnOnce() -> A + Send,
    high: impl FnOnce() -> B + Send,
) -> (A, B) {
    let (begun, done) = (AtomicBool::new(false), AtomicBool::new(false));
    let low = || {
        let found = low();
        if begun.load(Ordering::Acquire) {
            look_for_work(&done);
        }
        found
    };
    let high = || {
        begun.store(true, Ordering::Release);
        let _end = SetOnDrop(&done);
        high()
    };
    rayon::join(low, high)
}

/// Does what others share until all is `done`.
fn look_for_work(done: &AtomicBool) {
    let mut in_vain = 0;
    while !done.load(Ordering::Acquire) {
        match rayon::yield_now() {
            Some(rayon::Yield::Executed) => in_vain = 0,
            _ if in_vain < PATIENCE => {
                in_vain += 1;
                std::hint::spin_loop();
            }
            _ => std::thread::yield_now(),
        }
    }
}

struct SetOnDrop<'a>(&'a AtomicBool);

impl Drop for SetOnDrop<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Release);
    }
}

/// What can be cut in two: slices of the same length side by side, or indices.
pub(crate) trait Pieces: Sized + Send {
    /// How many items there are.
    fn count(&self) -> usize;
    /// The first `at`, and the others.
    fn cut(self, at: usize) -> (Self, Self);
}

impl Pieces for Range<usize> {
    fn count(&self) -> usize {
        self.len()
    }
    fn cut(self, at: usize) -> (Self, Self) {
        let middle = self.start + at;
        (self.start..middle, middle..self.end)
    }
}

impl<T: Send> Pieces for &mut [T] {
    fn count(&self) -> usize {
        self.len()
    }
    fn cut(self, at: usize) -> (Self, Self) {
        self.split_at_mut(at)
    }
}

impl<A: Pieces, B: Pieces> Pieces for (A, B) {
    fn count(&self) -> usize {
        self.0.count()
    }
    fn cut(self, at: usize) -> (Self, Self) {
        let ((a, c), (b, d)) = (self.0.cut(at), self.1.cut(at));
        ((a, b), (c, d))
    }
}

/// One list after the other: to join what pieces find.
pub(crate) fn chained<T>(
    mut all: LinkedList<Vec<T>>,
    mut more: LinkedList<Vec<T>>,
) -> LinkedList<Vec<T>> {
    all.append(&mut more);
    all
}

/// [`Pool::pieces`], halved until a piece is left.
fn share<P: Pieces, R: Send>(
    shared: bool,
    first: usize,
    items: P,
    work: &(impl Fn(usize, P) -> R + Sync),
    join: &(impl Fn(R, R) -> R + Sync),
) -> R {
    let pieces = items.count().div_ceil(PIECE);
    if pieces < 2 {
        return work(first, items);
    }
    let half = pieces / 2 * PIECE;
    let (low, high) = items.cut(half);
    let low = || share(shared, first, low, work, join);
    let high = || share(shared, first + half, high, work, join);
    let (low, high) = match shared {
        true => join_awake(low, high),
        false => (low(), high()),
    };
    join(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Workers that stayed awake would never be joined.
    #[test]
    fn a_panic_ends_the_workers() {
        let pool = Pool::new(2);
        let panic = std::panic::AssertUnwindSafe(|| pool.within(|| panic!("as it should")));
        assert!(std::panic::catch_unwind(panic).is_err());
        assert_eq!(pool.within(|| 7), 7);
    }

    #[test]
    fn what_pieces_find_is_gathered_in_their_order() {
        let count = 5 * PIECE + 7;
        let odd = |range: Range<usize>, found: &mut Vec<usize>| {
            found.extend(range.filter(|k| k % 2 == 1))
        };
        for threads in [1, 2, 3] {
            let pool = Pool::new(threads);
            let mut found = vec![0];
            pool.within(|| pool.collect(count, odd, &mut found));
            assert!(
                found
                    .into_iter()
                    .eq([0].into_iter().chain((1..count).step_by(2)))
            );
        }
    }

    #[test]
    fn pieces_cover_all_and_join_alike_on_any_number_of_threads() {
        let count = 5 * PIECE + 7;
        let sums = [1, 2, 3].map(|threads| {
            let pool = Pool::new(threads);
            let (mut seen, mut share) = (vec![0_usize; count], vec![0.0; count]);
            let sum = pool.within(|| {
                let both = (&mut seen[..], &mut share[..]);
                let work = |first, (seen, share): (&mut [usize], &mut [f64])| {
                    assert!(seen.len() <= PIECE);
                    for (k, (seen, share)) in (first..).zip(seen.iter_mut().zip(&mut *share)) {
                        (*seen, *share) = (k, 1.0 / (1.0 + k as f64));
                    }
                    share.iter().sum::<f64>()
                };
                pool.pieces(both, work, |a, b| a + b)
            });
            assert!(seen.into_iter().eq(0..count));
            sum
        });
        assert!(sums.iter().all(|sum| *sum == sums[0]));
        let pool = Pool::default();
        let found = pool.pieces(3..count, |_, range| vec![range], |a, b| [a, b].concat());
        assert_eq!((found[0].start, found[found.len() - 1].end), (3, count));
        assert!(found.windows(2).all(|pair| pair[0].end == pair[1].start));
    }
}
