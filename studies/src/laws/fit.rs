//! Least squares.

/// A straight line `y = intercept + slope x`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Slope.
    pub slope: f64,
    /// Value at `x = 0`.
    pub intercept: f64,
    /// Coefficient of determination.
    pub r2: f64,
}

impl Line {
    /// Best line through `points`; needs two different `x`.
    #[must_use]
    pub fn through(points: &[(f64, f64)]) -> Self {
        let n = points.len() as f64;
        let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
        let (x, y) = (mean(|p| p.0), mean(|p| p.1));
        let sum = |f: &dyn Fn(f64, f64) -> f64| points.iter().map(|p| f(p.0 - x, p.1 - y)).sum();
        let (xx, xy): (f64, f64) = (sum(&|u, _| u * u), sum(&|u, v| u * v));
        let slope = xy / xx;
        let line = Self {
            slope,
            intercept: y - slope * x,
            r2: 0.0,
        };
        Self {
            r2: determination(points, |x| line.at(x)),
            ..line
        }
    }

    /// Best power law `y = exp(intercept) x^slope` through positive points.
    #[must_use]
    pub fn power(points: &[(f64, f64)]) -> Self {
        let logs: Vec<(f64, f64)> = points.iter().map(|p| (p.0.ln(), p.1.ln())).collect();
        Self::through(&logs)
    }

    /// The line's value.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        self.intercept + self.slope * x
    }
}

/// Mean and its standard error, which takes two values at least.
#[must_use]
pub fn mean(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let n = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / n;
    let squares: f64 = values.map(|x| (x - mean).powi(2)).sum();
    [mean, (squares / (n * (n - 1.0))).sqrt()]
}

/// Coefficient of determination `1 - sum (y - f)^2 / sum (y - mean)^2`.
#[must_use]
pub fn determination(points: &[(f64, f64)], model: impl Fn(f64) -> f64) -> f64 {
    let mean = points.iter().map(|p| p.1).sum::<f64>() / points.len() as f64;
    let left: f64 = points.iter().map(|p| (p.1 - model(p.0)).powi(2)).sum();
    let all: f64 = points.iter().map(|p| (p.1 - mean).powi(2)).sum();
    1.0 - left / all
}

/// The parameter in `low..high` for which `model(parameter, x)` fits `points` best: golden section on the sum of squares,
/// which must have one minimum there.
#[must_use]
pub fn parameter(
    points: &[(f64, f64)],
    [mut low, mut high]: [f64; 2],
    model: impl Fn(f64, f64) -> f64,
) -> f64 {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let cost = |p: f64| -> f64 { points.iter().map(|q| (q.1 - model(p, q.0)).powi(2)).sum() };
    for _ in 0..80 {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if cost(a) < cost(b) {
            high = b;
        } else {
            low = a;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_powers_and_parameters_are_found() {
        let line: Vec<(f64, f64)> = (0..5)
            .map(|k| (f64::from(k), 3.0 - 2.0 * f64::from(k)))
            .collect();
        let found = Line::through(&line);
        assert!((found.slope + 2.0).abs() < 1e-14 && (found.intercept - 3.0).abs() < 1e-14);
        assert!((found.r2 - 1.0).abs() < 1e-14);
        let power: Vec<(f64, f64)> = (1..6)
            .map(|k| (f64::from(k), 7.0 * f64::from(k).powf(2.5)))
            .collect();
        let found = Line::power(&power);
        assert!((found.slope - 2.5).abs() < 1e-13 && (found.intercept.exp() - 7.0).abs() < 1e-12);
        let curve: Vec<(f64, f64)> = (0..9)
            .map(|k| (f64::from(k), 1.0 - (-0.7 * f64::from(k)).exp()))
            .collect();
        let found = parameter(&curve, [0.01, 10.0], |p, x| 1.0 - (-p * x).exp());
        assert!((found - 0.7).abs() < 1e-6, "{found}");
    }

    /// Of 1, 2, 6: squares from the mean 3 are 4 + 1 + 9, over 3 values and 2 degrees of freedom.
    #[test]
    fn means_have_their_standard_errors() {
        let [mean, error] = mean([1.0, 2.0, 6.0].into_iter());
        assert!((mean - 3.0).abs() < 1e-15 && (error - (14.0 / 6.0_f64).sqrt()).abs() < 1e-15);
    }

    /// y = x with one point off by d: R^2 = 1 - residual over spread, by hand for (0,0), (1,2), (2,2).
    #[test]
    fn determination_counts_what_is_left() {
        let points = [(0.0, 0.0), (1.0, 2.0), (2.0, 2.0)];
        assert!((determination(&points, |x| x) - (1.0 - 1.0 / (8.0 / 3.0))).abs() < 1e-15);
    }
}
