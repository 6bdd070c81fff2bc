//! Independent jobs on a few threads. Results come in the order of the jobs, whatever thread ran which.

use std::sync::Mutex;
use std::sync::PoisonError;

use crate::error::ReportError;

/// Runs `jobs` on at most `threads` threads, the first ones first; returns their results in order.
pub fn run<T: Send, J: FnOnce() -> T + Send>(threads: usize, jobs: Vec<J>) -> Vec<T> {
    let mut done: Vec<Option<T>> = jobs.iter().map(|_| None).collect();
    {
        let queue = Mutex::new(jobs.into_iter().zip(done.iter_mut()));
        // A panic in a job reaches the caller when the scope ends; the queue itself stays sound.
        let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
        std::thread::scope(|scope| {
            for _ in 0..threads.max(1) {
                scope.spawn(|| {
                    while let Some((job, slot)) = next() {
                        *slot = Some(job());
                    }
                });
            }
        });
    }
    done.into_iter().flatten().collect()
}

/// Runs `job` for each of `cases` on at most `threads` threads; its results in order, or its first error.
///
/// # Errors
/// What the first case that fails says.
pub fn all<C: Send, T: Send>(
    threads: usize,
    cases: Vec<C>,
    job: impl Fn(C) -> Result<T, ReportError> + Sync,
) -> Result<Vec<T>, ReportError> {
    let job = &job;
    let jobs = cases.into_iter().map(|case| move || job(case)).collect();
    run(threads, jobs).into_iter().collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn results_keep_the_order_of_the_jobs() {
        for threads in [0, 1, 2, 7] {
            let jobs: Vec<_> = (0..20u64)
                .map(|k| {
                    move || {
                        // Later jobs end first.
                        std::thread::sleep(std::time::Duration::from_millis((20 - k) / 4));
                        k * k
                    }
                })
                .collect();
            let expected: Vec<u64> = (0..20).map(|k| k * k).collect();
            assert_eq!(super::run(threads, jobs), expected);
        }
    }
}
