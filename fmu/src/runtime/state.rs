//! Saved states as bytes: the serialized form of an `fmi2FMUstate` or `fmi3FMUState`.
//!
//! ```text
//! bytes     what
//! 0..8      magic "SDDAFMU\0"
//! 8..12     format version, little endian as all numbers
//! 12..20    length of the body
//! 20..24    CRC-32 of the body
//! 24..      body (postcard): guid, life cycle, parameters, values, commands, snapshot of the simulation, start of its last step
//! ```
//!
//! The snapshot is [`sphere_dda::simulation::Simulation::snapshot`], the same blob as a checkpoint file. There are no
//! pointers inside, so a state works in another instance and in another process.

use serde::{Deserialize, Serialize};
use sphere_dda::Vec3;
use sphere_dda::scene::{Command, CommandDerivatives};
use sphere_dda::simulation::ReplayRecord;
use thiserror::Error;

use crate::runtime::life_cycle::LifeCycle;
use crate::table::Parameters;

const MAGIC: [u8; 8] = *b"SDDAFMU\0";
const FORMAT: u32 = 13;
const HEADER: usize = 24;

/// Everything an instance holds beside the simulation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InstanceState {
    /// Place in the life cycle.
    pub stage: LifeCycle,
    /// Time of the experiment's start \[s\]: the scene's t = 0.
    pub start: f64,
    /// Time at which the experiment ends \[s\], if it was told.
    pub stop: Option<f64>,
    /// Time of the last communication point \[s\].
    pub time: f64,
    /// Settings.
    pub parameters: Parameters,
    /// Values of the scene's parameters, as set; `[P]`.
    pub values: Vec<f64>,
    /// Those with which the scene was built.
    pub built: Vec<f64>,
    /// Those of the last step.
    pub stepped: Vec<f64>,
    /// Command of every boundary, zero where it is not driven; `[B]`.
    pub commands: Vec<Command>,
    /// Their derivatives by time, for the next step; `[B]`.
    pub rates: Vec<CommandDerivatives>,
    /// Forces applied at the centres of the spheres \[N\], `[N]`; empty unless the scene asks for the input.
    pub forces: Vec<Vec3>,
    /// Something was set since the simulation was prepared (initialization) or advanced (stepping).
    pub pending: bool,
    /// Length \[s\] of the step that could not be taken from here.
    pub failed: Option<f64>,
}

/// A saved state.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SavedState {
    /// Of the model it belongs to.
    pub guid: String,
    /// The instance's part.
    pub run: InstanceState,
    /// The simulation's part; `None` before there is one.
    pub snapshot: Option<Vec<u8>>,
    /// Where its last step came from: what derivatives need.
    pub replay: Option<ReplayRecord>,
}

/// Bytes that are no state of this model.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum StateError {
    /// Not written by an instance of this kind, cut short, or damaged.
    #[error("not a saved state: {what} is {found}, expected {expected}")]
    Format {
        /// Which part.
        what: &'static str,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// Of another scene or version.
    #[error("state of model {found}, expected {expected}: states belong to one export")]
    Model {
        /// Its guid.
        found: String,
        /// Guid of this instance.
        expected: String,
    },
}

impl SavedState {
    /// Whether the parts fit each other and an instance in the state `own`.
    ///
    /// # Errors
    /// [`StateError::Format`].
    pub fn check(&self, own: &InstanceState) -> Result<(), StateError> {
        let (run, boundaries, parameters) = (&self.run, own.commands.len(), own.values.len());
        let forces = own.forces.len();
        for (what, found, expected) in [
            ("number of commands", run.commands.len(), boundaries),
            ("number of derivatives", run.rates.len(), boundaries),
            ("number of forces", run.forces.len(), forces),
            ("number of values", run.values.len(), parameters),
            ("number of values at the start", run.built.len(), parameters),
            ("number of values in steps", run.stepped.len(), parameters),
        ] {
            expect(what, found as u64, expected as u64)?;
        }
        let stage = self.run.stage;
        check_stage(stage)?;
        let running = matches!(stage, LifeCycle::StepComplete | LifeCycle::StepFailed);
        if running && self.snapshot.is_none() {
            return Err(broken("simulation", "none".to_owned(), "one"));
        }
        Ok(())
    }

    /// The bytes.
    ///
    /// # Errors
    /// [`StateError::Format`] if the serializer fails.
    pub fn encode(&self) -> Result<Vec<u8>, StateError> {
        let body =
            postcard::to_stdvec(self).map_err(|e| broken("body", e.to_string(), "serializable"))?;
        let mut bytes = Vec::with_capacity(HEADER + body.len());
        bytes.extend_from_slice(&MAGIC);
        bytes.extend_from_slice(&FORMAT.to_le_bytes());
        bytes.extend_from_slice(&(body.len() as u64).to_le_bytes());
        bytes.extend_from_slice(&crc32fast::hash(&body).to_le_bytes());
        bytes.extend_from_slice(&body);
        Ok(bytes)
    }

    /// Reads a state of the model `guid`.
    ///
    /// # Errors
    /// [`StateError`]: anything but the exact bytes of [`Self::encode`] is refused.
    pub fn decode(bytes: &[u8], guid: &str) -> Result<Self, StateError> {
        let (magic, rest) = part::<8>(bytes)?;
        let (format, rest) = part::<4>(rest)?;
        let (length, rest) = part::<8>(rest)?;
        let (checksum, body) = part::<4>(rest)?;
        if magic != MAGIC {
            return Err(broken(
                "magic",
                format!("{:?}", magic.escape_ascii().to_string()),
                "SDDAFMU",
            ));
        }
        expect(
            "format version",
            u32::from_le_bytes(format).into(),
            FORMAT.into(),
        )?;
        expect(
            "length of the body",
            body.len() as u64,
            u64::from_le_bytes(length),
        )?;
        expect(
            "checksum",
            crc32fast::hash(body).into(),
            u32::from_le_bytes(checksum).into(),
        )?;
        let (saved, rest): (Self, _) = postcard::take_from_bytes(body)
            .map_err(|e| broken("body", e.to_string(), "the fields of a state"))?;
        expect("rest after the body", rest.len() as u64, 0)?;
        if saved.guid != guid {
            return Err(StateError::Model {
                found: saved.guid,
                expected: guid.to_owned(),
            });
        }
        Ok(saved)
    }
}

/// Whether an instance can go on from a state of this place in the life cycle.
pub(super) fn check_stage(stage: LifeCycle) -> Result<(), StateError> {
    if matches!(stage, LifeCycle::Error | LifeCycle::Intermediate) {
        let expected = "one in which a state can be saved";
        return Err(broken(
            "place in the life cycle",
            stage.to_string(),
            expected,
        ));
    }
    Ok(())
}

fn part<const N: usize>(bytes: &[u8]) -> Result<([u8; N], &[u8]), StateError> {
    let (head, rest) = bytes
        .split_first_chunk::<N>()
        .ok_or_else(|| broken("header", "cut short".to_owned(), "24 bytes"))?;
    Ok((*head, rest))
}

fn expect(what: &'static str, found: u64, expected: u64) -> Result<(), StateError> {
    if found == expected {
        Ok(())
    } else {
        Err(broken(what, found.to_string(), &expected.to_string()))
    }
}

fn broken(what: &'static str, found: String, expected: &str) -> StateError {
    StateError::Format {
        what,
        found,
        expected: expected.to_owned(),
    }
}
