//! Strong coupling: a step is repeated until what the FMUs hand each other at its end is what they were given for it.
//!
//! Let x be the values that go back to FMUs which stepped before their source, and G(x) what the sources hold after a
//! step with x. Sought is x = G(x). Quasi-Newton steps with an approximation of the inverse Jacobian from least squares
//! (IQN-ILS: Degroote, Bathe and Vierendeels 2009; the same as Anderson acceleration): with the differences of residuals
//! r = G(x) - x in the columns of V, and those of G in the columns of W,
//!
//! ```text
//! x' = G(x) + W c,   c = argmin |V c + r|
//! ```
//!
//! For one value that is the secant method, Aitken's relaxation. The columns of earlier steps are kept, the newest
//! first, as far as they say something new; while there are none, x' = x + relaxation r. All values are divided by their
//! greatest magnitude so far, so that metres and newtons weigh alike; of the least squares that means V and r.

use super::exchange::{Broken, Exchange, Load};
use super::participant::Participant;
use super::run::{Halt, Run};
use super::values::Value;
use super::{ImportError, SavedState};

/// Most columns that are kept.
const COLUMNS: usize = 24;

/// Tries of a step after which the columns of earlier steps are dropped: they may tell of contacts that are no more.
const PATIENCE: u32 = 10;

/// A column says nothing new if what is left of it, beside those before it, is a smaller part of it.
const NEW: f64 = 1e-4;

/// When exchanged values agree, and how they are sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Iteration {
    /// Greatest change of a value from one try of a step to the next that counts as none, as a part of the greatest
    /// magnitude that the value has had; dimensionless, greater than 0.
    pub tolerance: f64,
    /// Most tries of one step, at least 1.
    pub limit: u32,
    /// Part of the difference by which the second try of the first step goes, in (0, 1].
    pub relaxation: f64,
    /// After the most tries, go on with the one whose values changed least instead of ending with an error. Where a
    /// contact opens or closes within a step, what an FMU answers can jump past every value that would agree.
    pub go_on: bool,
}

impl Default for Iteration {
    /// Tolerance 1e-6, 30 tries, relaxation 0.5, an error if they do not do.
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            limit: 30,
            relaxation: 0.5,
            go_on: false,
        }
    }
}

/// A step that was kept although the values did not agree.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Unsettled {
    /// Its start \[s\].
    pub time: f64,
    /// The change that was left, as a part of the greatest magnitude of the value.
    pub change: f64,
}

/// What is known from one try to the next, and from one step to the next.
#[derive(Debug, Default)]
pub(super) struct Memory {
    /// Differences of residuals and of G; the newest last.
    columns: Vec<(Vec<f64>, Vec<f64>)>,
    /// Greatest magnitude of each value.
    scales: Vec<f64>,
    /// The values that were handed on at the last communication point.
    last: Option<Vec<f64>>,
}

impl Run<'_> {
    /// All components from point `k` to the next. The time that one came to, if it wants to end before.
    pub(super) fn iterate(&mut self, k: u64) -> Result<Option<f64>, Halt> {
        let settings = self.options.iteration;
        let mut guess = self.returned()?;
        let now = reals(&guess);
        if let Some(last) = self.memory.last.take() {
            let ahead: Vec<f64> = now
                .iter()
                .zip(last)
                .map(|(now, last)| 2.0 * now - last)
                .collect();
            put(&mut guess, &ahead);
        }
        let loops = guess.iter().any(|load| !load.is_empty());
        let states = if loops { self.save()? } else { Vec::new() };
        let mut before: Option<(Vec<f64>, Vec<f64>)> = None;
        let mut best: Option<(f64, Vec<Load>)> = None;
        for attempt in 1..=settings.limit {
            let ended = self.sweep(k, &guess, !loops)?;
            if ended.is_some() {
                return Ok(ended);
            }
            let found = self.returned()?;
            let (x, g) = (reals(&guess), reals(&found));
            let scales = self.memory.scales_with(&g);
            let pairs = guess.iter().flatten().zip(found.iter().flatten());
            let others_agree = pairs
                .filter(|((_, value), _)| !matches!(value, Value::Real(_)))
                .all(|((_, a), (_, b))| a == b);
            let changes = over(&minus(&g, &x), &scales);
            let worst =
                (0..changes.len()).max_by(|&a, &b| size(&changes, a).total_cmp(&size(&changes, b)));
            let change = worst.map_or(0.0, |worst| size(&changes, worst));
            if others_agree && change <= settings.tolerance {
                self.release(states)?;
                self.memory.scales = scales;
                self.memory.last = Some(now);
                self.table.iterations.push(attempt);
                return Ok(None);
            }
            if best.as_ref().is_none_or(|(least, _)| change < *least) {
                best = Some((change, guess.clone()));
            }
            if attempt == settings.limit
                && settings.go_on
                && let Some((change, guess)) = best
            {
                for (component, state) in states.iter().enumerate() {
                    self.at(component, |instance| instance.restore(state))?;
                }
                let ended = self.sweep(k, &guess, false)?;
                self.release(states)?;
                self.memory.scales = scales;
                self.memory.last = Some(now);
                self.table.iterations.push(attempt + 1);
                let time = self.grid.time(k);
                self.table.unsettled.push(Unsettled { time, change });
                return Ok(ended);
            }
            if attempt == settings.limit {
                let names = self.returned_names();
                return Err(Halt::Apart {
                    variable: worst.and_then(|worst| names.get(worst).cloned()),
                    change,
                });
            }
            let residual = minus(&g, &x);
            if let Some((residual_before, g_before)) = before.replace((residual.clone(), g.clone()))
            {
                let changes = (minus(&residual, &residual_before), minus(&g, &g_before));
                self.memory.learn(changes);
            }
            if attempt == PATIENCE {
                self.memory.keep_last(PATIENCE as usize - 1);
            }
            let next = self
                .memory
                .next(&residual, &g, &scales, settings.relaxation);
            guess = found;
            put(&mut guess, &next);
            for (component, state) in states.iter().enumerate() {
                self.at(component, |instance| instance.restore(state))?;
            }
        }
        Ok(None)
    }

    /// Every component one step, in their order: with values of t + h from those before it, guessed ones from the others.
    fn sweep(&mut self, k: u64, guess: &[Load], last: bool) -> Result<Option<f64>, Halt> {
        for (component, guessed) in guess.iter().enumerate() {
            let mut load = self
                .exchange
                .read_from(component, &mut self.instances, |source| source < component)?;
            load.extend(guessed.iter().cloned());
            Exchange::write(component, &load, &mut self.instances)?;
            let ended = self.step(component, k, last)?;
            if ended.is_some() {
                return Ok(ended);
            }
        }
        Ok(None)
    }

    /// What now goes back to each component from itself and those behind it.
    fn returned(&mut self) -> Result<Vec<Load>, Broken> {
        (0..self.instances.len())
            .map(|target| {
                self.exchange
                    .read_from(target, &mut self.instances, |source| source >= target)
            })
            .collect()
    }

    /// Names of the real ones among the values of [`returned`](Self::returned).
    fn returned_names(&mut self) -> Vec<String> {
        let targets = 0..self.instances.len();
        targets
            .flat_map(|target| self.exchange.real_names(target, |source| source >= target))
            .collect()
    }

    fn at<T>(
        &mut self,
        component: usize,
        call: impl FnOnce(&mut dyn Participant) -> Result<T, ImportError>,
    ) -> Result<Option<T>, Halt> {
        let Some(instance) = self.instances.get_mut(component) else {
            return Ok(None);
        };
        Ok(Some(call(&mut **instance).map_err(Broken::at(component))?))
    }

    fn save(&mut self) -> Result<Vec<SavedState>, Halt> {
        let mut states = Vec::new();
        for component in 0..self.instances.len() {
            states.extend(self.at(component, |instance| instance.save())?);
        }
        Ok(states)
    }

    fn release(&mut self, states: Vec<SavedState>) -> Result<(), Halt> {
        for (component, state) in states.into_iter().enumerate() {
            self.at(component, |instance| instance.free(state))?;
        }
        Ok(())
    }
}

impl Memory {
    /// The greatest magnitudes, `now` included; 1 for what has always been 0.
    fn scales_with(&self, now: &[f64]) -> Vec<f64> {
        let known = |k: usize| self.scales.get(k).copied().unwrap_or(0.0);
        now.iter()
            .enumerate()
            .map(|(k, value)| known(k).max(value.abs()))
            .map(|scale| if scale > 0.0 { scale } else { 1.0 })
            .collect()
    }

    /// Keeps the differences of residuals and of G between two tries.
    fn learn(&mut self, differences: (Vec<f64>, Vec<f64>)) {
        if self.columns.len() == COLUMNS {
            self.columns.remove(0);
        }
        self.columns.push(differences);
    }

    fn keep_last(&mut self, count: usize) {
        let old = self.columns.len().saturating_sub(count);
        self.columns.drain(..old);
    }

    /// x' for the residual r and G(x).
    fn next(&self, residual: &[f64], g: &[f64], scales: &[f64], relaxation: f64) -> Vec<f64> {
        // Gram and Schmidt: each column without what those before it say already; W is changed along with V.
        let mut basis: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
        for (v, w) in self.columns.iter().rev() {
            let (mut v, mut w) = (over(v, scales), w.clone());
            let whole = norm(&v);
            for (q, p) in &basis {
                let part = dot(q, &v);
                subtract(&mut v, part, q);
                subtract(&mut w, part, p);
            }
            let left = norm(&v);
            if left > NEW * whole && left.is_finite() {
                v.iter_mut().chain(&mut w).for_each(|value| *value /= left);
                basis.push((v, w));
            }
        }
        if basis.is_empty() {
            // x + relaxation r, and x = G - r.
            let pairs = g.iter().zip(residual);
            return pairs.map(|(g, r)| g - (1.0 - relaxation) * r).collect();
        }
        let mut next = g.to_vec();
        let residual = over(residual, scales);
        for (q, p) in &basis {
            subtract(&mut next, dot(q, &residual), p);
        }
        next
    }
}

fn size(values: &[f64], k: usize) -> f64 {
    values.get(k).map_or(0.0, |value| value.abs())
}

fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn over(values: &[f64], scales: &[f64]) -> Vec<f64> {
    values
        .iter()
        .zip(scales)
        .map(|(a, scale)| a / scale)
        .collect()
}

fn subtract(from: &mut [f64], factor: f64, what: &[f64]) {
    for (from, what) in from.iter_mut().zip(what) {
        *from -= factor * what;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// The real values of loads, one after another.
fn reals(loads: &[Load]) -> Vec<f64> {
    let values = loads.iter().flatten().map(|(_, value)| value);
    values
        .filter_map(|value| match value {
            Value::Real(value) => Some(*value),
            _ => None,
        })
        .collect()
}

/// Replaces the real values of loads.
fn put(loads: &mut [Load], values: &[f64]) {
    let mut values = values.iter();
    for (_, value) in loads.iter_mut().flatten() {
        if let Value::Real(old) = value
            && let Some(new) = values.next()
        {
            *old = *new;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x = A x + b with a spectral radius of 3: without the differences it diverges, with them an affine map of n values
    /// is solved in n + 2 tries.
    #[test]
    fn affine_maps_are_solved_in_as_many_tries_as_values() {
        let a = [[-3.0, 0.4, 0.1], [0.2, 2.0, -0.3], [0.0, 0.5, -1.5]];
        let b = [1.0, -2.0, 0.5];
        let g = |x: &[f64]| -> Vec<f64> { (0..3).map(|k| dot(&a[k], x) + b[k]).collect() };
        let mut memory = Memory::default();
        let scales = [3.0, 0.5, 1.0];
        let mut x = vec![0.0; 3];
        let mut before: Option<(Vec<f64>, Vec<f64>)> = None;
        let mut tries = 0;
        loop {
            tries += 1;
            let found = g(&x);
            let r = minus(&found, &x);
            if norm(&r) < 1e-10 {
                break;
            }
            assert!(tries < 6, "{r:?}");
            if let Some((r0, g0)) = before.replace((r.clone(), found.clone())) {
                memory.learn((minus(&r, &r0), minus(&found, &g0)));
            }
            x = memory.next(&r, &found, &scales, 0.5);
        }
        assert_eq!(tries, 5);
        // The next step of the same map with another b needs two.
        let shifted = minus(&g(&x), &[0.3, -0.1, 0.2]);
        let x1 = memory.next(&minus(&shifted, &x), &shifted, &scales, 0.5);
        let r = minus(&minus(&g(&x1), &[0.3, -0.1, 0.2]), &x1);
        assert!(norm(&r) < 1e-9, "{r:?}");
    }
}
