//! Who follows a study, and how a case tells how far it is.

use std::cell::Cell;

/// How a study tells what it does, and is told to end.
pub trait Watch: Sync {
    /// Something has begun or ended.
    fn note(&self, text: &str);
    /// All cases together cost this much, in seconds of one core of the machine that recorded them: only shares count.
    fn plan(&self, cost: f64);
    /// So much of it is behind.
    fn spent(&self, cost: f64);
    /// Whether the study shall end now.
    fn stop(&self) -> bool;
}

/// Tells nobody, never stops.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn note(&self, _: &str) {}

    fn plan(&self, _: f64) {}

    fn spent(&self, _: f64) {}

    fn stop(&self) -> bool {
        false
    }
}

/// A case under way: it spends its cost as it gets on, and what is left of it when it ends, however early.
pub struct Part<'a> {
    /// Who watches.
    pub watch: &'a dyn Watch,
    cost: f64,
    /// Share of the case that is told.
    told: Cell<f64>,
}

impl<'a> Part<'a> {
    /// A case that begins and costs `cost`.
    #[must_use]
    pub fn new(watch: &'a dyn Watch, cost: f64) -> Self {
        Self {
            watch,
            cost,
            told: Cell::new(0.0),
        }
    }

    /// The share `done` of the case is behind, 0 to 1.
    pub fn reached(&self, done: f64) {
        let done = done.min(1.0).max(self.told.get());
        let before = self.told.replace(done);
        self.watch.spent(self.cost * (done - before));
    }
}

impl Drop for Part<'_> {
    fn drop(&mut self) {
        self.reached(1.0);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::{Part, Watch};

    struct Ledger(Mutex<Vec<f64>>);

    impl Watch for Ledger {
        fn note(&self, _: &str) {}

        fn plan(&self, _: f64) {}

        fn spent(&self, cost: f64) {
            self.0.lock().unwrap().push(cost);
        }

        fn stop(&self) -> bool {
            false
        }
    }

    #[test]
    fn a_case_spends_its_cost_and_no_more() {
        for told in [&[][..], &[0.5], &[0.5, 0.25, 1.0], &[0.25, 7.0]] {
            let ledger = Ledger(Mutex::default());
            let part = Part::new(&ledger, 8.0);
            told.iter().for_each(|&done| part.reached(done));
            drop(part);
            let spent = ledger.0.into_inner().unwrap();
            assert_eq!(spent.iter().sum::<f64>(), 8.0, "{told:?}: {spent:?}");
            assert!(spent.iter().all(|&cost| cost >= 0.0), "{told:?}: {spent:?}");
        }
    }
}
