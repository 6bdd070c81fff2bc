//! Snapshots: the state of a simulation as bytes. A checkpoint file is one, an FMU's saved state contains one.
//!
//! ```text
//! bytes      what
//! 0..8       magic "SPHDDA\0\n"
//! 8..12      format version, little endian as all numbers
//! 12..76     scene hash, hexadecimal
//! 76..84     length of the spheres
//! 84..92     length of the state
//! 92..       spheres: radii and kinematics (postcard)
//!            state: crate::state::State (postcard)
//!            CRC-32 of all before
//! ```
//!
//! There are no pointers inside, so a snapshot means the same in any process. What is not in it (neighbour list,
//! symbolic analysis) never shows in results. The spheres stand apart so that scenes can take them from any snapshot,
//! whatever its scene and whatever else its state holds.

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::SnapshotError;
use crate::scene::particles::Kinematics;

const MAGIC: &[u8; 8] = b"SPHDDA\0\n";
/// Counts up with every change of `State`.
pub(crate) const VERSION: u32 = 21;
/// The first version that holds the spheres as they are read here.
const SPHERES_SINCE: u32 = 2;
const HASH: usize = 64;
const HEADER: usize = MAGIC.len() + 4 + HASH + 8 + 8;
/// Digits of a hash that distinguish scenes in messages.
const SHOWN: usize = 12;

/// Writes the snapshot of a scene with the given hash (hexadecimal, 64 characters; shorter ones are padded).
/// `radius` \[m\], `[N]`; `kinematics` of that moment, with the velocities reported for it; `state` is what
/// `restore` gives back.
#[must_use]
pub fn take(
    scene_hash: &str,
    radius: &[f64],
    kinematics: &Kinematics,
    state: &impl Serialize,
) -> Vec<u8> {
    // Postcard fails only when its buffer is too small; a Vec grows.
    let spheres = postcard::to_allocvec(&(radius, kinematics)).unwrap_or_default();
    let state = postcard::to_allocvec(state).unwrap_or_default();
    let mut blob = Vec::with_capacity(HEADER + spheres.len() + state.len() + 4);
    blob.extend_from_slice(MAGIC);
    blob.extend_from_slice(&VERSION.to_le_bytes());
    blob.extend_from_slice(&padded(scene_hash));
    blob.extend_from_slice(&(spheres.len() as u64).to_le_bytes());
    blob.extend_from_slice(&(state.len() as u64).to_le_bytes());
    blob.extend_from_slice(&spheres);
    blob.extend_from_slice(&state);
    let checksum = crc32fast::hash(&blob);
    blob.extend_from_slice(&checksum.to_le_bytes());
    blob
}

/// The state in a snapshot of the scene with the given hash.
///
/// # Errors
/// [`SnapshotError`] for anything that is not a whole, undamaged snapshot of this scene and version.
pub(crate) fn restore<S: DeserializeOwned>(
    blob: &[u8],
    scene_hash: &str,
) -> Result<S, SnapshotError> {
    let parts = Parts::of(blob)?;
    if parts.version != VERSION {
        return Err(version(parts.version));
    }
    if *parts.scene != padded(scene_hash) {
        return Err(SnapshotError::Scene {
            found: shown(parts.scene),
            expected: shown(scene_hash.as_bytes()),
        });
    }
    parse(parts.state)
}

/// Radii \[m\], `[N]`, and kinematics of the spheres in a snapshot of any scene, absent spheres included; the
/// velocities are those at its time, with which another run can start.
///
/// # Errors
/// [`SnapshotError::Format`] if it is damaged, [`SnapshotError::Version`] if it is of another format.
pub fn spheres(blob: &[u8]) -> Result<(Vec<f64>, Kinematics), SnapshotError> {
    let parts = Parts::of(blob)?;
    if !(SPHERES_SINCE..=VERSION).contains(&parts.version) {
        return Err(version(parts.version));
    }
    let (radius, moving): (Vec<f64>, Kinematics) = parse(parts.spheres)?;
    match moving.fits(radius.len()) {
        true => Ok((radius, moving)),
        false => Err(SnapshotError::Format(
            "its radii, places and velocities differ in number",
        )),
    }
}

/// An undamaged snapshot.
struct Parts<'a> {
    version: u32,
    scene: &'a [u8; HASH],
    spheres: &'a [u8],
    state: &'a [u8],
}

impl<'a> Parts<'a> {
    fn of(blob: &'a [u8]) -> Result<Self, SnapshotError> {
        let cut = || SnapshotError::Format("it is cut short");
        let rest = blob.strip_prefix(MAGIC).ok_or(SnapshotError::Format(
            "it does not begin as every snapshot does",
        ))?;
        let (version, rest) = rest.split_first_chunk().ok_or_else(cut)?;
        let version = u32::from_le_bytes(*version);
        if version < SPHERES_SINCE {
            // Its header had other lengths.
            return Err(self::version(version));
        }
        let (scene, rest) = rest.split_first_chunk().ok_or_else(cut)?;
        let (spheres, rest) = rest.split_first_chunk().ok_or_else(cut)?;
        let (state, body) = rest.split_first_chunk().ok_or_else(cut)?;
        let length = |bytes: &[u8; 8]| usize::try_from(u64::from_le_bytes(*bytes)).ok();
        let (spheres, rest) = length(spheres)
            .and_then(|length| body.split_at_checked(length))
            .ok_or_else(cut)?;
        let (state, checksum) = length(state)
            .and_then(|length| rest.split_at_checked(length))
            .ok_or_else(cut)?;
        let sum = crc32fast::hash(&blob[..HEADER + spheres.len() + state.len()]);
        if checksum != sum.to_le_bytes() {
            return Err(SnapshotError::Format("its checksum does not match"));
        }
        Ok(Self {
            version,
            scene,
            spheres,
            state,
        })
    }
}

fn parse<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, SnapshotError> {
    match postcard::take_from_bytes(bytes) {
        Ok((value, [])) => Ok(value),
        _ => Err(SnapshotError::Format("its content does not parse")),
    }
}

fn version(found: u32) -> SnapshotError {
    SnapshotError::Version {
        found,
        expected: VERSION,
    }
}

fn padded(hash: &str) -> [u8; HASH] {
    let mut field = [b' '; HASH];
    for (to, from) in field.iter_mut().zip(hash.bytes()) {
        *to = from;
    }
    field
}

fn shown(hash: &[u8]) -> String {
    String::from_utf8_lossy(&hash[..hash.len().min(SHOWN)])
        .trim()
        .to_owned()
}
