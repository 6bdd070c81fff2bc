//! Radii \[m\]: one for all, or drawn from a distribution.
//!
//! | key | density of the numbers of spheres over `R` |
//! |---|---|
//! | `uniform` | constant on `min..=max` |
//! | `normal` | `exp(-(R - mean)^2 / (2 deviation^2))` on `min..=max` |
//! | `log_normal` | `exp(-ln(R/median)^2 / (2 sigma^2)) / R` on `min..=max` |
//! | `table` | class `k` with probability `(w_k / R_k^3) / sum_j (w_j / R_j^3)`, so that its share of the mass is `w_k` |
//!
//! The same seed draws the same radii, bit for bit, on every machine.

use rand_chacha::ChaCha8Rng;

use super::document::Document;
use super::file;
use crate::random::{normal, unit};

/// Bounds nearer than this many deviations are refused: draws would be thrown away for ever.
const NARROWEST: f64 = 0.1;

/// Where radii come from; checked, so that drawing cannot fail.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Sizes {
    /// The same for all \[m\].
    One(f64),
    /// Uniform between two bounds \[m\].
    Uniform { min: f64, max: f64 },
    /// Normal, drawn again outside the bounds; all \[m\].
    Normal {
        mean: f64,
        deviation: f64,
        min: f64,
        max: f64,
    },
    /// Log-normal, drawn again outside the bounds; lengths in \[m\].
    LogNormal {
        median: f64,
        sigma: f64,
        min: f64,
        max: f64,
    },
    /// Radius of each class \[m\], and the probability that a sphere is of this class or an earlier one.
    Classes(Vec<(f64, f64)>),
}

impl Sizes {
    /// The radii of the element at `path`, which gives exactly one of `radius` and `size`.
    pub(super) fn new(
        document: &mut Document<'_>,
        path: &str,
        radius: Option<f64>,
        size: Option<&file::Size>,
    ) -> Option<Self> {
        match (radius, size) {
            (Some(radius), None) => {
                positive(document, format!("{path}.radius"), radius).then_some(Self::One(radius))
            }
            (None, Some(size)) => Self::drawn(document, &format!("{path}.size"), size),
            (None, None) => {
                let help = "add `radius = ...` in metres, or `size = { ... }`";
                document.reject(path, "missing key `radius`", help)
            }
            (Some(_), Some(_)) => {
                let help = "keep `radius` for equal spheres, `size` for a distribution";
                let message = "found both `radius` and `size`, expected one of them";
                document.reject((path, "size"), message, help)
            }
        }
    }

    fn drawn(document: &mut Document<'_>, path: &str, size: &file::Size) -> Option<Self> {
        match size {
            file::Size::Uniform(given) => {
                let path = format!("{path}.uniform");
                let (min, max) = (given.min, given.max);
                let good = positive(document, format!("{path}.min"), min)
                    && ordered(document, format!("{path}.max"), max, "min", min);
                good.then_some(Self::Uniform { min, max })
            }
            file::Size::Normal(given) => {
                let path = format!("{path}.normal");
                let (mean, deviation) = (given.mean, given.deviation);
                let good = positive(document, format!("{path}.mean"), mean)
                    & document.positive((&path, "deviation"), deviation, "a length > 0 [m]");
                let min = given
                    .min
                    .unwrap_or((mean - 3.0 * deviation).max(0.1 * mean));
                let max = given.max.unwrap_or(mean + 3.0 * deviation);
                let wide = max - min >= NARROWEST * deviation;
                let good = good && bounds(document, &path, ("mean", mean), (min, max), wide);
                good.then_some(Self::Normal {
                    mean,
                    deviation,
                    min,
                    max,
                })
            }
            file::Size::LogNormal(given) => {
                let path = format!("{path}.log_normal");
                let (median, sigma) = (given.median, given.sigma);
                let in_range = sigma > 0.0 && sigma <= 10.0;
                let good = positive(document, format!("{path}.median"), median)
                    & document.demand(in_range, (&path, "sigma"), sigma, "0 < sigma <= 10 [-]");
                let min = given.min.unwrap_or(median * libm::exp(-3.0 * sigma));
                let max = given.max.unwrap_or(median * libm::exp(3.0 * sigma));
                let wide = libm::log(max / min) >= NARROWEST * sigma;
                let good = good && bounds(document, &path, ("median", median), (min, max), wide);
                good.then_some(Self::LogNormal {
                    median,
                    sigma,
                    min,
                    max,
                })
            }
            file::Size::Table(given) => Self::classes(document, &format!("{path}.table"), given),
        }
    }

    fn classes(document: &mut Document<'_>, path: &str, given: &file::MassTable) -> Option<Self> {
        let (radius, mass) = (&given.radius, &given.mass);
        let mut good = document.demand(
            !radius.is_empty(),
            (path, "radius"),
            "an empty list",
            "at least one radius > 0 [m]",
        );
        let expected = format!("one share for each of the {} radii", radius.len());
        good &= document.demand(
            mass.len() == radius.len(),
            (path, "mass"),
            format!("{} shares", mass.len()),
            &expected,
        );
        for (k, r) in radius.iter().enumerate() {
            good &= positive(document, format!("{path}.radius[{k}]"), *r);
        }
        for (k, m) in mass.iter().enumerate() {
            let key = format!("{path}.mass[{k}]");
            good &= document.demand(*m >= 0.0, key, m, "a share of the mass >= 0");
        }
        let some = mass.is_empty() || mass.iter().any(|m| *m > 0.0);
        good &= document.demand(some, (path, "mass"), "only zeros", "a share > 0");
        if !good {
            return None;
        }
        // Over the smallest radius, so that no power overflows.
        let smallest = radius.iter().copied().fold(f64::INFINITY, f64::min);
        let number = |(r, m): (&f64, &f64)| m * (smallest / r).powi(3);
        let total: f64 = radius.iter().zip(mass).map(number).sum();
        let mut sum = 0.0;
        let classes = radius.iter().zip(mass).map(|(r, m)| {
            sum += number((r, m));
            (*r, sum / total)
        });
        Some(Self::Classes(classes.collect()))
    }

    /// One radius \[m\].
    pub(super) fn draw(&self, random: &mut ChaCha8Rng) -> f64 {
        match *self {
            Self::One(radius) => radius,
            Self::Uniform { min, max } => min + (max - min) * unit(random),
            Self::Normal {
                mean,
                deviation,
                min,
                max,
            } => within(min, max, || mean + deviation * normal(random)),
            Self::LogNormal {
                median,
                sigma,
                min,
                max,
            } => within(min, max, || median * libm::exp(sigma * normal(random))),
            Self::Classes(ref classes) => {
                let u = unit(random);
                let drawn = classes.iter().find(|(_, up_to)| u < *up_to);
                // Only rounding of the sum gets past the last class.
                drawn.or(classes.last()).map_or(0.0, |(radius, _)| *radius)
            }
        }
    }
}

/// Draws until a value lies within the bounds.
fn within(min: f64, max: f64, mut draw: impl FnMut() -> f64) -> f64 {
    loop {
        let radius = draw();
        if (min..=max).contains(&radius) {
            return radius;
        }
    }
}

fn positive(document: &mut Document<'_>, path: String, value: f64) -> bool {
    document.positive(path, value, "a radius > 0 [m]")
}

fn ordered(document: &mut Document<'_>, path: String, max: f64, of: &str, min: f64) -> bool {
    document.demand(max >= min, path, max, &format!("at least {of} = {min} [m]"))
}

/// `0 < min <= centre <= max`, and wide enough for draws to fall within.
fn bounds(
    document: &mut Document<'_>,
    path: &str,
    (name, centre): (&str, f64),
    (min, max): (f64, f64),
    wide: bool,
) -> bool {
    let low = min > 0.0 && min <= centre;
    let expected = format!("0 < min <= {name} = {centre} [m]");
    document.demand(low, (path, "min"), min, &expected)
        & ordered(document, format!("{path}.max"), max, name, centre)
        && document.demand(
            wide,
            (path, "max"),
            max,
            "bounds at least a tenth of a deviation apart; use `radius` for equal spheres",
        )
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::rand_core::SeedableRng;

    const DRAWS: usize = 200_000;

    fn drawn(sizes: &Sizes, seed: u64) -> Vec<f64> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        (0..DRAWS).map(|_| sizes.draw(&mut random)).collect()
    }

    /// Mean and standard deviation of the draws agree with the closed forms within four standard errors.
    fn agree(draws: &[f64], mean: f64, deviation: f64) {
        let n = draws.len() as f64;
        let found = draws.iter().sum::<f64>() / n;
        let square = draws.iter().map(|r| (r - found).powi(2)).sum::<f64>() / n;
        assert!(
            (found - mean).abs() < 4.0 * deviation / n.sqrt(),
            "mean {found}, expected {mean}"
        );
        // The fourth moment of these distributions is at most three variances squared.
        assert!(
            (square.sqrt() / deviation - 1.0).abs() < 4.0 / (2.0 * n).sqrt(),
            "deviation {}, expected {deviation}",
            square.sqrt()
        );
    }

    /// Standard normal density and distribution function.
    fn density(x: f64) -> f64 {
        (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt()
    }
    fn below(x: f64) -> f64 {
        0.5 * (1.0 + libm::erf(x / std::f64::consts::SQRT_2))
    }

    #[test]
    fn uniform_moments_are_those_of_the_closed_form() {
        let (min, max) = (0.01, 0.03);
        let draws = drawn(&Sizes::Uniform { min, max }, 1);
        assert!(draws.iter().all(|r| (min..=max).contains(r)));
        agree(&draws, 0.5 * (min + max), (max - min) / 12_f64.sqrt());
    }

    #[test]
    fn normal_moments_are_those_of_the_truncated_distribution() {
        let (mean, deviation, min, max) = (0.01, 0.002, 0.009, 0.014);
        let draws = drawn(
            &Sizes::Normal {
                mean,
                deviation,
                min,
                max,
            },
            2,
        );
        assert!(draws.iter().all(|r| (min..=max).contains(r)));
        let (a, b) = ((min - mean) / deviation, (max - mean) / deviation);
        let kept = below(b) - below(a);
        let shift = (density(a) - density(b)) / kept;
        let variance = 1.0 + (a * density(a) - b * density(b)) / kept - shift * shift;
        agree(
            &draws,
            mean + deviation * shift,
            deviation * variance.sqrt(),
        );
    }

    #[test]
    fn log_normal_moments_are_those_of_the_truncated_distribution() {
        let (median, sigma, min, max) = (0.01, 0.4, 0.006, 0.025);
        let draws = drawn(
            &Sizes::LogNormal {
                median,
                sigma,
                min,
                max,
            },
            3,
        );
        assert!(draws.iter().all(|r| (min..=max).contains(r)));
        let (a, b) = ((min / median).ln() / sigma, (max / median).ln() / sigma);
        // E[R^k] = median^k exp(k^2 sigma^2 / 2) times the share kept of the distribution shifted by k sigma.
        let moment = |k: f64| {
            let share = (below(b - k * sigma) - below(a - k * sigma)) / (below(b) - below(a));
            median.powf(k) * (0.5 * k * k * sigma * sigma).exp() * share
        };
        let mean = moment(1.0);
        agree(&draws, mean, (moment(2.0) - mean * mean).sqrt());
    }

    #[test]
    fn classes_share_the_mass_as_the_table_says() {
        let (radius, mass) = (vec![0.01, 0.02, 0.04, 0.03], vec![20.0, 50.0, 30.0, 0.0]);
        let mut document = Document::parse("", std::path::Path::new(""));
        let table = file::Size::Table(file::MassTable {
            radius: radius.clone(),
            mass: mass.clone(),
        });
        let sizes = Sizes::new(&mut document, "spheres[0]", None, Some(&table)).unwrap();
        let draws = drawn(&sizes, 4);
        let number = |k: usize| mass[k] / radius[k].powi(3);
        let total: f64 = (0..4).map(number).sum();
        // Pearson's sum over the three classes with mass: 99.9 % of samples lie below 13.8 for two degrees of freedom.
        let pearson: f64 = (0..3)
            .map(|k| {
                let expected = number(k) / total * DRAWS as f64;
                let found = draws.iter().filter(|r| **r == radius[k]).count() as f64;
                (found - expected).powi(2) / expected
            })
            .sum();
        assert!(pearson < 13.8, "{pearson}");
        assert!(draws.iter().all(|r| radius[..3].contains(r)));
        let volume: f64 = draws.iter().map(|r| r.powi(3)).sum();
        for k in 0..3 {
            let own = draws.iter().filter(|r| **r == radius[k]).count() as f64 * radius[k].powi(3);
            assert!((own / volume - mass[k] / 100.0).abs() < 0.01, "class {k}");
        }
    }

    /// Re-mint only for a change that is meant to give every seeded scene other spheres.
    #[test]
    fn a_seed_means_the_same_radii_for_ever() {
        let bits = |sizes: Sizes| {
            let mut random = ChaCha8Rng::seed_from_u64(7);
            [(); 3].map(|()| sizes.draw(&mut random).to_bits())
        };
        let (min, max) = (0.5, 1.5);
        let normal = Sizes::Normal {
            mean: 1.0,
            deviation: 0.3,
            min,
            max,
        };
        let log_normal = Sizes::LogNormal {
            median: 1.0,
            sigma: 0.3,
            min,
            max,
        };
        let found = [
            bits(Sizes::Uniform { min, max }),
            bits(normal),
            bits(log_normal),
        ];
        let expected = [
            [
                4604100120060132072,
                4604191932835812197,
                4608102396694123081,
            ],
            [
                4606336892571839216,
                4608453229958992992,
                4608807689734140250,
            ],
            [
                4606375365111750089,
                4608650651220024900,
                4609139661087439521,
            ],
        ];
        assert_eq!(found, expected);
    }
}
