//! Fixed points by quasi-Newton iterations.
//!
//! Sought is x = G(x), where each G(x) costs a step of the FMUs. Quasi-Newton steps with an approximation of the inverse Jacobian from least squares
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

/// Most columns that are kept.
const COLUMNS: usize = 24;

/// Iterations of a step after which the columns of earlier steps are dropped: they may tell of contacts that are no more.
const STALE_AFTER: u32 = 10;

/// A column says nothing new if what is left of it, beside those before it, is a smaller part of it.
const NEW: f64 = 1e-4;

/// What is known from one iteration to the next, and from one step to the next.
#[derive(Debug, Default)]
pub(super) struct QuasiNewton {
    /// Differences of residuals and of G; the newest last.
    columns: Vec<(Vec<f64>, Vec<f64>)>,
    /// Greatest magnitude of each value.
    scales: Vec<f64>,
    /// The values that were handed on at the last communication point.
    last: Option<Vec<f64>>,
}

/// How far values are from agreeing.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    /// Greatest change of a value, as a part of its greatest magnitude.
    pub(super) size: f64,
    /// Which value that is; `None` if there are none.
    pub(super) worst: Option<usize>,
}

/// The search for the values of one step.
pub(super) struct Search<'m> {
    memory: &'m mut QuasiNewton,
    /// The values at the start of the step.
    now: Vec<f64>,
    /// Greatest magnitudes, those of this step included.
    scales: Vec<f64>,
    /// Residual and G of the iteration before.
    before: Option<(Vec<f64>, Vec<f64>)>,
    iterations: u32,
}

impl<'m> Search<'m> {
    /// Begins with the values of the communication point.
    pub(super) fn new(memory: &'m mut QuasiNewton, now: Vec<f64>) -> Self {
        Self {
            scales: memory.scales.clone(),
            memory,
            now,
            before: None,
            iterations: 0,
        }
    }

    /// The first guess: what the last two communication points lead to, if there are two.
    pub(super) fn first(&mut self) -> Vec<f64> {
        match self.memory.last.take() {
            Some(last) => {
                let pairs = self.now.iter().zip(last);
                pairs.map(|(now, last)| 2.0 * now - last).collect()
            }
            None => self.now.clone(),
        }
    }

    /// How far g = G(x) is from x.
    pub(super) fn change(&mut self, x: &[f64], g: &[f64]) -> Change {
        self.iterations += 1;
        self.scales = self.memory.scales_with(g);
        let changes = over(&minus(g, x), &self.scales);
        let worst =
            (0..changes.len()).max_by(|&a, &b| size(&changes, a).total_cmp(&size(&changes, b)));
        Change {
            size: worst.map_or(0.0, |worst| size(&changes, worst)),
            worst,
        }
    }

    /// The next guess, when x has led to g.
    pub(super) fn next(&mut self, x: &[f64], g: &[f64], relaxation: f64) -> Vec<f64> {
        let residual = minus(g, x);
        if let Some((residual_before, g_before)) =
            self.before.replace((residual.clone(), g.to_vec()))
        {
            let changes = (minus(&residual, &residual_before), minus(g, &g_before));
            self.memory.learn(changes);
        }
        if self.iterations == STALE_AFTER {
            self.memory.keep_last(STALE_AFTER as usize - 1);
        }
        self.memory.next(&residual, g, &self.scales, relaxation)
    }

    /// The step is done: its values are the last from now on.
    pub(super) fn end(self) {
        self.memory.scales = self.scales;
        self.memory.last = Some(self.now);
    }
}

impl QuasiNewton {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// x = A x + b with a spectral radius of 3: without the differences it diverges, with them an affine map of n values
    /// is solved in n + 2 iterations.
    #[test]
    fn affine_maps_are_solved_in_as_many_iterations_as_values() {
        let a = [[-3.0, 0.4, 0.1], [0.2, 2.0, -0.3], [0.0, 0.5, -1.5]];
        let b = [1.0, -2.0, 0.5];
        let g = |x: &[f64]| -> Vec<f64> { (0..3).map(|k| dot(&a[k], x) + b[k]).collect() };
        let mut memory = QuasiNewton::default();
        let scales = [3.0, 0.5, 1.0];
        let mut x = vec![0.0; 3];
        let mut before: Option<(Vec<f64>, Vec<f64>)> = None;
        let mut iterations = 0;
        loop {
            iterations += 1;
            let found = g(&x);
            let r = minus(&found, &x);
            if norm(&r) < 1e-10 {
                break;
            }
            assert!(iterations < 6, "{r:?}");
            if let Some((r0, g0)) = before.replace((r.clone(), found.clone())) {
                memory.learn((minus(&r, &r0), minus(&found, &g0)));
            }
            x = memory.next(&r, &found, &scales, 0.5);
        }
        assert_eq!(iterations, 5);
        // The next step of the same map with another b needs two.
        let shifted = minus(&g(&x), &[0.3, -0.1, 0.2]);
        let x1 = memory.next(&minus(&shifted, &x), &shifted, &scales, 0.5);
        let r = minus(&minus(&g(&x1), &[0.3, -0.1, 0.2]), &x1);
        assert!(norm(&r) < 1e-9, "{r:?}");
    }
}
