//! The threads of a simulation: joined when it goes, so that a library that is unloaded leaves none behind.
//!
//! Work is cut by the data alone and every piece writes its own part, so that results are the same for any number of
//! threads.

use std::fmt;
use std::num::NonZeroUsize;

use paralight::prelude::*;

/// Blocks of contacts, or bodies, from which handing out costs less than it gains: it takes some 50 us, as much as 500 blocks.
const WORTH: usize = 2000;

/// Threads, made with the first work that is worth them.
#[derive(Default)]
pub(crate) struct Pool {
    threads: usize,
    workers: Option<ThreadPool>,
}

impl fmt::Debug for Pool {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Pool({})", self.threads)
    }
}

impl Pool {
    /// A pool of so many threads; one or none: the caller's alone.
    #[must_use]
    pub(crate) fn new(threads: usize) -> Self {
        Self {
            threads,
            workers: None,
        }
    }

    /// How many threads.
    #[must_use]
    pub(crate) fn threads(&self) -> usize {
        self.threads
    }

    /// Does `work` with each of `items`, side by side if they hold at least [`WORTH`] blocks or bodies (`size`).
    pub(crate) fn each<T: Send>(
        &mut self,
        size: usize,
        items: &mut [T],
        work: impl Fn(&mut T) + Sync,
    ) {
        let Some(count) = NonZeroUsize::new(self.threads).filter(|n| n.get() > 1) else {
            return items.iter_mut().for_each(work);
        };
        if items.len() < 2 || size < WORTH {
            return items.iter_mut().for_each(work);
        }
        let workers = self.workers.get_or_insert_with(|| {
            ThreadPoolBuilder {
                num_threads: ThreadCount::Count(count),
                range_strategy: RangeStrategy::WorkStealing,
                cpu_pinning: CpuPinningPolicy::No,
            }
            .build()
        });
        items
            .par_iter_mut()
            .with_thread_pool(workers)
            .for_each(work);
    }
}
