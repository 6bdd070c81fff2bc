//! One instance: life cycle, values, states.

use std::fmt;

use sphere_dda_fmi_interface::pointers::BadArgument;
use sphere_dda_model_description::fmi2::Causality;
use thiserror::Error;

use crate::model::{Motion, Parameters};
use crate::variables::{
    ACCELERATION, AMPLITUDE, COUNT, DAMPING, FORCE, FREQUENCY, IMPULSE, MASS, POSITION, STIFFNESS,
    SUPPORT, TABLE, VELOCITY,
};

/// Difference of two communication points that counts as none, relative to the step and to the time.
const TIME_TOLERANCE: f64 = 1e-9;

/// First bytes of a serialized state.
const MAGIC: &[u8; 8] = b"SHAKER01";
/// Length of a serialized state.
const LENGTH: usize = MAGIC.len() + 1 + 8 * (1 + COUNT) + 4;

/// Part of the life cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LifeCycle {
    /// Made; parameters can be set.
    Instantiated,
    /// In initialization mode; parameters can still be set.
    Initialization,
    /// At a communication point.
    Stepping,
    /// Terminated.
    Terminated,
    /// A fault of this library: reset, an earlier state, or the end.
    Broken,
}

const STAGES: [LifeCycle; 5] = [
    LifeCycle::Instantiated,
    LifeCycle::Initialization,
    LifeCycle::Stepping,
    LifeCycle::Terminated,
    LifeCycle::Broken,
];

impl fmt::Display for LifeCycle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Instantiated => "instantiated",
            Self::Initialization => "initialization mode",
            Self::Stepping => "step complete",
            Self::Terminated => "terminated",
            Self::Broken => "error",
        })
    }
}

/// Why a call was refused; nothing has changed then.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Refusal {
    /// A null pointer, or a value that an argument cannot have.
    #[error(transparent)]
    Argument(#[from] BadArgument),
    /// Not now.
    #[error("not allowed in state {0}")]
    LifeCycle(LifeCycle),
    /// No such variable.
    #[error("value reference {0}, expected one below {COUNT}, of a real")]
    Reference(u32),
    /// The variable cannot be set, or not now.
    #[error("`{name}` cannot be set in state {stage}")]
    NotSettable {
        /// Its name.
        name: &'static str,
        /// Present state.
        stage: LifeCycle,
    },
    /// A value out of bounds.
    #[error("`{name}` = {found}, expected a finite number{}", if *.bounded { " of at least 0, a mass above" } else { "" })]
    Range {
        /// Its name.
        name: &'static str,
        /// The value.
        found: f64,
        /// It has a lower bound.
        bounded: bool,
    },
    /// A step that begins elsewhere or leads nowhere.
    #[error("step from {found} s by {step} s, expected one from {expected} s by more than 0")]
    Step {
        /// Communication point of the call \[s\].
        found: f64,
        /// Step \[s\].
        step: f64,
        /// Where the instance is \[s\].
        expected: f64,
    },
    /// Bytes that are no state.
    #[error(
        "{found} bytes that are no state of a shaker, expected {LENGTH} with a fitting checksum"
    )]
    State {
        /// Their number.
        found: usize,
    },
    /// Not offered.
    #[error("not offered: {0} is false or 0 in the model description")]
    NotOffered(&'static str),
}

/// A shaker. The whole of it is its state.
#[derive(Debug, Clone, PartialEq)]
pub struct Instance {
    stage: LifeCycle,
    /// Where it is \[s\].
    time: f64,
    /// By value reference.
    values: [f64; COUNT],
}

impl Default for Instance {
    fn default() -> Self {
        let mut instance = Self {
            stage: LifeCycle::Instantiated,
            time: 0.0,
            values: TABLE.map(|variable| variable.start.unwrap_or(0.0)),
        };
        instance.compute();
        instance
    }
}

impl Instance {
    /// Where it is in its life.
    #[must_use]
    pub fn stage(&self) -> LifeCycle {
        self.stage
    }

    /// Where it is in time \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// After a fault of this library nothing can be trusted.
    pub fn fail(&mut self) {
        self.stage = LifeCycle::Broken;
    }

    /// Start of the experiment \[s\].
    ///
    /// # Errors
    /// In another state, or a time that is not finite.
    pub fn set_up(&mut self, start: f64) -> Result<(), Refusal> {
        self.require(&[LifeCycle::Instantiated])?;
        if !start.is_finite() {
            return Err(BadArgument {
                argument: "startTime",
                found: start.to_string(),
                expected: "a finite time",
            }
            .into());
        }
        self.time = start;
        self.compute();
        Ok(())
    }

    /// Goes from one of the stages `from` to `to`.
    ///
    /// # Errors
    /// In another state.
    pub fn enter(&mut self, from: &[LifeCycle], to: LifeCycle) -> Result<(), Refusal> {
        self.require(from)?;
        self.stage = to;
        Ok(())
    }

    /// The value of a variable.
    ///
    /// # Errors
    /// No such variable.
    pub fn get(&self, reference: u32) -> Result<f64, Refusal> {
        let value = self.values.get(reference as usize);
        value.copied().ok_or(Refusal::Reference(reference))
    }

    /// Sets variables: all or none.
    ///
    /// # Errors
    /// No such variable, one that cannot be set now, a value out of bounds.
    pub fn set(&mut self, pairs: impl Iterator<Item = (u32, f64)>) -> Result<(), Refusal> {
        let mut values = self.values;
        for (reference, value) in pairs {
            let unknown = Refusal::Reference(reference);
            let Some(variable) = TABLE.get(reference as usize) else {
                return Err(unknown);
            };
            let allowed: &[LifeCycle] = match (variable.causality, variable.start) {
                (Causality::Input, _) => &[
                    LifeCycle::Instantiated,
                    LifeCycle::Initialization,
                    LifeCycle::Stepping,
                ],
                (Causality::Parameter, _) => &[LifeCycle::Instantiated, LifeCycle::Initialization],
                // The initial motion.
                (_, Some(_)) => &[LifeCycle::Instantiated, LifeCycle::Initialization],
                (_, None) => &[],
            };
            if !allowed.contains(&self.stage) {
                return Err(Refusal::NotSettable {
                    name: variable.name,
                    stage: self.stage,
                });
            }
            let within = match variable.least {
                None => true,
                Some((least, true)) => value >= least,
                Some((least, false)) => value > least,
            };
            if !value.is_finite() || !within {
                return Err(Refusal::Range {
                    name: variable.name,
                    found: value,
                    bounded: variable.least.is_some(),
                });
            }
            values[reference as usize] = value;
        }
        self.values = values;
        self.compute();
        Ok(())
    }

    /// A step from `point` by `h` \[s\] under the force that is set.
    ///
    /// # Errors
    /// In another state, from another time, of no positive length.
    pub fn step(&mut self, point: f64, h: f64) -> Result<(), Refusal> {
        self.require(&[LifeCycle::Stepping])?;
        let slack = TIME_TOLERANCE * h.max(self.time.abs() * f64::EPSILON / TIME_TOLERANCE);
        let fits = (point - self.time).abs() <= slack.max(16.0 * f64::EPSILON * self.time.abs());
        if !(h > 0.0 && h.is_finite() && fits) {
            return Err(Refusal::Step {
                found: point,
                step: h,
                expected: self.time,
            });
        }
        let force = self.values[FORCE];
        let next = self
            .parameters()
            .advance(self.motion(), self.time, h, self.total_force());
        self.time = point + h;
        self.values[POSITION] = next.position;
        self.values[VELOCITY] = next.velocity;
        self.values[IMPULSE] += force * h;
        self.compute();
        Ok(())
    }

    /// The state as bytes.
    #[must_use]
    pub fn save(&self) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        let stage = STAGES.iter().position(|stage| *stage == self.stage);
        bytes.push(stage.unwrap_or_default() as u8);
        for number in [self.time].iter().chain(&self.values) {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
        bytes
    }

    /// The instance that was saved as `bytes`.
    ///
    /// # Errors
    /// Anything else.
    pub fn load(bytes: &[u8]) -> Result<Self, Refusal> {
        let refused = || Refusal::State { found: bytes.len() };
        let (body, sum) = bytes.split_last_chunk::<4>().ok_or_else(refused)?;
        let whole = bytes.len() == LENGTH
            && body.starts_with(MAGIC)
            && crc32fast::hash(body) == u32::from_le_bytes(*sum);
        let stage = body
            .get(MAGIC.len())
            .and_then(|k| STAGES.get(usize::from(*k)));
        let (true, Some(&stage)) = (whole, stage) else {
            return Err(refused());
        };
        let (numbers, _) = body[MAGIC.len() + 1..].as_chunks::<8>();
        let mut numbers = numbers.iter().map(|bytes| f64::from_le_bytes(*bytes));
        let time = numbers.next().ok_or_else(refused)?;
        let mut values = [0.0; COUNT];
        for value in &mut values {
            *value = numbers.next().ok_or_else(refused)?;
        }
        Ok(Self {
            stage,
            time,
            values,
        })
    }

    fn require(&self, allowed: &[LifeCycle]) -> Result<(), Refusal> {
        if allowed.contains(&self.stage) {
            return Ok(());
        }
        Err(Refusal::LifeCycle(self.stage))
    }

    fn motion(&self) -> Motion {
        Motion {
            position: self.values[POSITION],
            velocity: self.values[VELOCITY],
        }
    }

    fn parameters(&self) -> Parameters {
        Parameters {
            mass: self.values[MASS],
            stiffness: self.values[STIFFNESS],
            damping: self.values[DAMPING],
            amplitude: self.values[AMPLITUDE],
            frequency: self.values[FREQUENCY],
        }
    }

    /// What acts on the mass beside spring and damper \[N\].
    fn total_force(&self) -> f64 {
        self.values[FORCE] + self.values[SUPPORT]
    }

    /// What follows from the rest.
    fn compute(&mut self) {
        let force = self.total_force();
        self.values[ACCELERATION] = self
            .parameters()
            .acceleration(self.motion(), self.time, force);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stepping() -> Instance {
        let mut instance = Instance::default();
        instance
            .enter(&[LifeCycle::Instantiated], LifeCycle::Initialization)
            .unwrap();
        instance
            .enter(&[LifeCycle::Initialization], LifeCycle::Stepping)
            .unwrap();
        instance
    }

    #[test]
    fn steps_begin_where_the_last_ended() {
        let mut instance = stepping();
        let h = 1.0 / 60.0;
        for k in 0..216_000 {
            instance.step(f64::from(k) * h, h).unwrap();
        }
        for (point, h) in [
            (0.0, h),
            (3600.0, 0.0),
            (3600.0, -h),
            (3600.0, f64::NAN),
            (3600.0 + 0.1 * h, h),
        ] {
            let before = instance.clone();
            assert!(instance.step(point, h).is_err(), "{point} {h}");
            assert_eq!(instance, before);
        }
        instance.step(3600.0 + 1e-12, h).unwrap();
    }

    #[test]
    fn a_state_continues_with_the_same_bits_and_a_damaged_one_is_refused() {
        let mut instance = stepping();
        instance.set([(0, 3.0)].into_iter()).unwrap();
        instance.step(0.0, 0.01).unwrap();
        let bytes = instance.save();
        let mut copy = Instance::load(&bytes).unwrap();
        assert_eq!(copy, instance);
        instance.step(0.01, 0.02).unwrap();
        copy.step(0.01, 0.02).unwrap();
        assert_eq!(copy.save(), instance.save());
        for k in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[k] ^= 4;
            assert!(Instance::load(&damaged).is_err(), "byte {k}");
            assert!(Instance::load(&bytes[..k]).is_err(), "{k} bytes");
        }
    }

    #[test]
    fn what_cannot_be_set_is_refused_and_changes_nothing() {
        let mut fresh = Instance::default();
        let before = fresh.clone();
        for (reference, value) in [
            (5, 0.0),
            (5, -1.0),
            (6, -1.0),
            (0, f64::NAN),
            (3, 1.0),
            (4, 1.0),
            (11, 1.0),
        ] {
            let pairs = [(0, 7.0), (reference, value)];
            assert!(fresh.set(pairs.into_iter()).is_err(), "{reference} {value}");
            assert_eq!(fresh, before);
        }
        fresh.set([(5, 3.0), (1, 0.1)].into_iter()).unwrap();
        let mut stepping = stepping();
        for reference in [1, 5] {
            assert!(
                stepping.set([(reference, 1.0)].into_iter()).is_err(),
                "{reference}"
            );
        }
        stepping.set([(0, 4.0)].into_iter()).unwrap();
        assert_eq!(stepping.get(3), Ok(2.0));
    }
}
