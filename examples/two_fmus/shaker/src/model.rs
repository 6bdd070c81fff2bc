//! The equation of motion and its exact step.
//!
//! With the force F held and the foot at u = A sin(w t), w = 2 pi f, the state z = (x, v, F, sin w t, cos w t) obeys
//! z' = M z with a constant M, so that z(t + h) = exp(M h) z(t): exact for every h, for every damping, without
//! spring and in resonance.

use std::f64::consts::TAU;

use nalgebra::{SMatrix, SVector};

/// What does not change during a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// m \[kg\], > 0.
    pub mass: f64,
    /// k \[N/m\], >= 0.
    pub stiffness: f64,
    /// d \[N.s/m\], >= 0.
    pub damping: f64,
    /// A \[m\], >= 0.
    pub amplitude: f64,
    /// f \[Hz\], >= 0.
    pub frequency: f64,
}

/// Where the mass is and how fast it moves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// x \[m\].
    pub position: f64,
    /// v \[m/s\].
    pub velocity: f64,
}

impl Parameters {
    /// The motion at `time + h` \[s\] from that at `time`, under `force` \[N\].
    #[must_use]
    pub fn advance(&self, motion: Motion, time: f64, h: f64, force: f64) -> Motion {
        let (m, k, w) = (self.mass, self.stiffness, TAU * self.frequency);
        let mut rate = SMatrix::<f64, 5, 5>::zeros();
        rate[(0, 1)] = 1.0;
        rate[(1, 0)] = -k / m;
        rate[(1, 1)] = -self.damping / m;
        rate[(1, 2)] = 1.0 / m;
        rate[(1, 3)] = k * self.amplitude / m;
        rate[(3, 4)] = w;
        rate[(4, 3)] = -w;
        // The foot's place from the time itself: it does not drift.
        let (sin, cos) = (w * time).sin_cos();
        let now = SVector::from([motion.position, motion.velocity, force, sin, cos]);
        let next = (rate * h).exp() * now;
        Motion {
            position: next[0],
            velocity: next[1],
        }
    }

    /// x'' \[m/s^2\].
    #[must_use]
    pub fn acceleration(&self, motion: Motion, time: f64, force: f64) -> f64 {
        let foot = self.amplitude * (TAU * self.frequency * time).sin();
        let spring = self.stiffness * (foot - motion.position);
        (force + spring - self.damping * motion.velocity) / self.mass
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BASE: Parameters = Parameters {
        mass: 2.0,
        stiffness: 800.0,
        damping: 6.0,
        amplitude: 0.0,
        frequency: 0.0,
    };

    /// Largest difference over a second of steps `h` from the closed form `x(t)`.
    fn worst(
        parameters: Parameters,
        start: Motion,
        force: f64,
        h: f64,
        x: impl Fn(f64) -> f64,
    ) -> f64 {
        let (mut motion, mut worst) = (start, 0.0_f64);
        for k in 0..(1.0 / h).round() as u32 {
            motion = parameters.advance(motion, f64::from(k) * h, h, force);
            worst = worst.max((motion.position - x(f64::from(k + 1) * h)).abs());
        }
        worst
    }

    #[test]
    fn every_damping_equals_its_closed_form() {
        let (m, k, force, x0, v0) = (2.0_f64, 800.0_f64, 5.0, 0.01, -0.3);
        let start = Motion {
            position: x0,
            velocity: v0,
        };
        let critical = 2.0 * (k * m).sqrt();
        for damping in [0.0, 6.0, critical, 3.0 * critical] {
            let parameters = Parameters { damping, ..BASE };
            let (decay, rest) = (damping / (2.0 * m), force / k);
            let (a, square) = (x0 - rest, k / m - decay * decay);
            let b = v0 + decay * a;
            let form = |t: f64| {
                let shape = if square.abs() < 1e-9 {
                    a + b * t
                } else if square > 0.0 {
                    let w = square.sqrt();
                    a * (w * t).cos() + b / w * (w * t).sin()
                } else {
                    let w = (-square).sqrt();
                    a * (w * t).cosh() + b / w * (w * t).sinh()
                };
                rest + (-decay * t).exp() * shape
            };
            for h in [1e-3, 0.02, 0.5] {
                let error = worst(parameters, start, force, h, form);
                assert!(error < 1e-13, "damping {damping}, h {h}: {error:e}");
            }
        }
    }

    #[test]
    fn the_shaken_foot_equals_its_closed_form_also_in_resonance() {
        let (m, k, amplitude) = (BASE.mass, BASE.stiffness, 2e-3);
        // Undamped from rest: x = A r (r sin w t - ... ) with w0 of the spring; in resonance A/2 (sin w t - w t cos w t).
        let w0 = (k / m).sqrt();
        for ratio in [0.3, 1.0, 2.5] {
            let w = ratio * w0;
            let parameters = Parameters {
                damping: 0.0,
                amplitude,
                frequency: w / TAU,
                ..BASE
            };
            let form = |t: f64| {
                if ratio == 1.0 {
                    amplitude / 2.0 * ((w * t).sin() - w * t * (w * t).cos())
                } else {
                    amplitude / (1.0 - ratio * ratio) * ((w * t).sin() - ratio * (w0 * t).sin())
                }
            };
            for h in [1e-3, 0.05] {
                let error = worst(parameters, Motion::default(), 0.0, h, form);
                assert!(error < 1e-13, "ratio {ratio}, h {h}: {error:e}");
            }
        }
    }

    #[test]
    fn a_mass_without_spring_is_thrown() {
        let free = Parameters {
            stiffness: 0.0,
            damping: 0.0,
            ..BASE
        };
        let start = Motion {
            position: 0.1,
            velocity: 0.4,
        };
        let error = worst(free, start, 3.0, 0.01, |t| 0.1 + 0.4 * t + 0.75 * t * t);
        assert!(error < 1e-13, "{error:e}");
        assert_eq!(free.acceleration(start, 0.0, 3.0), 1.5);
    }
}
