//! The threads of a simulation: joined when it goes, so that a library that is unloaded leaves none behind.
//!
//! Work is cut by the data alone and every piece writes its own part, so that results are the same for any number of
//! threads. Workers look for work for some microseconds before they sleep, and a sleeping one takes a tenth of a millisecond to
//! wake: what is cut many times runs [`Pool::within`] the workers as a whole.

use std::fmt;
use std::sync::{Arc, OnceLock};
use std::thread::{Builder, JoinHandle};

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Blocks of contacts from which handing out, which takes as long as a hundred of them, costs less than it gains.
const WORTH: usize = 256;
/// Items of a piece where each is little work.
const PIECE: usize = 4096;

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
            // One that panicked has told so where its work was waited for.
            let _ = thread.join();
        }
    }
}

impl Pool {
    /// A pool of so many threads; one or none: the caller's alone.
    #[must_use]
    pub(crate) fn new(threads: usize) -> Self {
        Self(Arc::new(Threads {
            count: threads,
            workers: OnceLock::new(),
        }))
    }

    /// How many threads.
    #[must_use]
    pub(crate) fn threads(&self) -> usize {
        self.0.count
    }

    /// Does `work` where [`Self::each`] shares it out.
    pub(crate) fn within<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        if self.0.count < 2 {
            return work();
        }
        let workers = self.0.workers.get_or_init(|| Workers::new(self.0.count));
        match workers.as_ref().and_then(|workers| workers.pool.as_ref()) {
            Some(pool) => pool.install(work),
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
        items.par_iter_mut().with_max_len(1).for_each(work);
    }

    /// Does `work` with pieces of `items`, each with the index of its first, side by side where it may.
    pub(crate) fn pieces<T: Send>(
        &self,
        items: &mut [T],
        work: impl Fn(usize, &mut [T]) + Sync + Send,
    ) {
        let work = |(k, piece): (usize, &mut [T])| work(k * PIECE, piece);
        match self.shares() {
            true => items.par_chunks_mut(PIECE).enumerate().for_each(work),
            false => items.chunks_mut(PIECE).enumerate().for_each(work),
        }
    }

    /// Whether there are others to share with, and they are at hand.
    fn shares(&self) -> bool {
        self.0.count > 1 && rayon::current_thread_index().is_some()
    }
}
