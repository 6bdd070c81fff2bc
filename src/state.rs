//! The complete state of a simulation, and its blob.
//!
//! A blob is `magic, version, scene hash, length, postcard body, CRC-32`: no pointers, the same bytes in any
//! process. What is not in it (neighbour list, symbolic analysis) never shows in results.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::contacts::Contact;
use crate::error::SnapshotError;
use crate::motion::{Command, Pose, Twist};
use crate::particles::Kinematics;
use crate::problem::Dof6;
use crate::simulation::{StepReport, Wrench};

/// Work done since t = 0 \[J\].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Work {
    /// Energy lost in contacts: friction, impact, and what the scheme takes.
    pub dissipated: f64,
    /// Work of moving boundaries on the spheres.
    pub boundaries: f64,
    /// Work of point loads on the spheres.
    pub loads: f64,
    /// Work of constrained springs on the spheres.
    pub springs: f64,
}

/// What a source has yet to emit.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Reserve {
    /// Spheres outside the scene, in the order they will be emitted.
    pub waiting: VecDeque<u32>,
    /// How much of what is due since the source's start has been emitted or forgone: spheres, or mass \[kg\].
    pub spent: f64,
    /// Number of the next draw of a place.
    pub draws: u64,
}

/// Everything that decides the future of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Time \[s\].
    pub time: f64,
    /// Last internal step \[s\]; 0 before the first.
    pub last_step: f64,
    /// Gravity \[m/s^2\].
    pub gravity: Vec3,
    /// Spheres; velocities are the integrator's own.
    pub kinematics: Kinematics,
    /// Acceleration by external and persisting contact forces in the last step, `[N]`.
    pub persisting: Vec<Dof6>,
    /// Loaded contacts of the last step, canonical order.
    pub contacts: Vec<Contact>,
    /// Force of each constrained spring on its sphere \[N\], `[S]`.
    pub springs: Vec<Vec3>,
    /// Boundary poses, `[B]`.
    pub poses: Vec<Pose>,
    /// Boundary twists over the last internal step, `[B]`.
    pub twists: Vec<Twist>,
    /// Commands in force, `[B]`.
    pub commands: Vec<Command>,
    /// Wrench on each boundary over the last internal step, `[B]`.
    pub wrenches: Vec<Wrench>,
    /// Wrench on each boundary by contacts that were no impacts in the last internal step, `[B]`.
    pub persisting_wrenches: Vec<Wrench>,
    /// Wrench on each boundary averaged over the last communication step, `[B]`.
    pub mean_wrenches: Vec<Wrench>,
    /// Work since t = 0.
    pub work: Work,
    /// Spheres of each source that wait outside the scene, `[sources]`.
    pub reserves: Vec<Reserve>,
    /// Mass each source has emitted \[kg\], `[sources]`.
    pub emitted: Vec<f64>,
    /// Mass each sink has removed \[kg\], `[sinks]`.
    pub removed: Vec<f64>,
    /// Cumulated mass of each sensor \[kg\], `[sensors]`; zero for those that do not cumulate.
    pub passed: Vec<f64>,
    /// Mean flow of each sensor over the last communication step \[kg/s\], `[sensors]`.
    pub flow: Vec<f64>,
    /// Largest overlap over radius removed by displacement before t = 0 \[-\].
    pub initial_overlap: f64,
    /// Penalty number in use \[N/m\].
    pub penalty: f64,
    /// Report of the last communication step.
    pub report: StepReport,
}

const MAGIC: &[u8; 8] = b"SPHDDA\0\n";
const VERSION: u32 = 1;
const HASH: usize = 64;
const HEADER: usize = MAGIC.len() + 4 + HASH + 8;

/// Writes `state` of the scene with the given hash (hexadecimal, 64 characters; shorter ones are padded).
#[must_use]
pub fn to_blob(state: &State, scene_hash: &str) -> Vec<u8> {
    // Postcard fails only when its buffer is too small; a Vec grows.
    let body = postcard::to_allocvec(state).unwrap_or_default();
    let mut blob = Vec::with_capacity(HEADER + body.len() + 4);
    blob.extend_from_slice(MAGIC);
    blob.extend_from_slice(&VERSION.to_le_bytes());
    blob.extend_from_slice(&padded(scene_hash));
    blob.extend_from_slice(&(body.len() as u64).to_le_bytes());
    blob.extend_from_slice(&body);
    let checksum = crc32fast::hash(&blob);
    blob.extend_from_slice(&checksum.to_le_bytes());
    blob
}

/// Reads a blob written for the scene with the given hash.
///
/// # Errors
/// [`SnapshotError`] for anything that is not a whole, undamaged blob of this scene and version.
pub fn from_blob(blob: &[u8], scene_hash: &str) -> Result<State, SnapshotError> {
    let format = SnapshotError::Format;
    let rest = blob.strip_prefix(MAGIC).ok_or(format("wrong magic"))?;
    let (version, rest) = rest.split_first_chunk().ok_or(format("cut short"))?;
    let version = u32::from_le_bytes(*version);
    if version != VERSION {
        return Err(SnapshotError::Mismatch {
            found: format!("state format {version}"),
            expected: format!("state format {VERSION}"),
        });
    }
    let (hash, rest) = rest
        .split_first_chunk::<HASH>()
        .ok_or(format("cut short"))?;
    let (length, rest) = rest.split_first_chunk().ok_or(format("cut short"))?;
    let (body, checksum) = rest
        .split_at_checked(u64::from_le_bytes(*length) as usize)
        .ok_or(format("cut short"))?;
    let sum = crc32fast::hash(&blob[..HEADER + body.len()]);
    if checksum != sum.to_le_bytes() {
        return Err(format("checksum does not match, the blob is damaged"));
    }
    if *hash != padded(scene_hash) {
        return Err(SnapshotError::Mismatch {
            found: format!("scene {}", String::from_utf8_lossy(hash)),
            expected: format!("scene {scene_hash}"),
        });
    }
    postcard::from_bytes(body).map_err(|_| format("body does not parse"))
}

fn padded(hash: &str) -> [u8; HASH] {
    let mut field = [b' '; HASH];
    for (to, from) in field.iter_mut().zip(hash.bytes()) {
        *to = from;
    }
    field
}
