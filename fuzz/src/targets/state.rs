//! Saved states of an FMU, their checksums made to fit: what lies behind them is reached too.

use std::sync::OnceLock;

use super::Target;
use super::calls::{Two, model};

/// Magic, format, length of the body, checksum.
const HEADER: usize = 8 + 4 + 8 + 4;
/// What a snapshot begins with, and the bytes up to its spheres: version, hash, two lengths.
const SNAPSHOT: &[u8] = b"SPHDDA\0\n";
const LENGTHS: usize = SNAPSHOT.len() + 4 + 64;

#[derive(Default)]
pub(super) struct States {
    sound: OnceLock<Vec<Vec<u8>>>,
}

impl Target for States {
    fn name(&self) -> &'static str {
        "state"
    }

    fn corpus(&self) -> Vec<Vec<u8>> {
        let make = || {
            let instance = Two::new(model());
            instance.initialize();
            let first = instance.saved();
            for k in 0..3 {
                instance.step(f64::from(k) * 0.01, 0.01);
            }
            vec![first, instance.saved()]
        };
        self.sound.get_or_init(make).clone()
    }

    fn attempt(&self, input: &[u8]) -> bool {
        let instance = Two::new(model());
        let taken = instance.load(&sealed(input.to_vec()));
        if taken {
            // A short step: states are as trusted as scenes, and may ask for any work.
            for time in [0.0, 0.03] {
                instance.step(time, 1e-9);
            }
            instance.read_all();
        }
        taken
    }
}

/// The state with the length and checksums that belong to its bytes.
fn sealed(mut state: Vec<u8>) -> Vec<u8> {
    if state.len() < HEADER {
        return state;
    }
    let body = state.split_off(HEADER);
    let at = body
        .windows(SNAPSHOT.len())
        .position(|part| part == SNAPSHOT);
    let body = match at {
        Some(at) => [&body[..at], &sealed_snapshot(body[at..].to_vec())].concat(),
        None => body,
    };
    state[12..20].copy_from_slice(&(body.len() as u64).to_le_bytes());
    state[20..24].copy_from_slice(&crc32fast::hash(&body).to_le_bytes());
    state.extend(body);
    state
}

/// The bytes with the checksum that belongs to the snapshot at their beginning.
pub(super) fn sealed_snapshot(mut bytes: Vec<u8>) -> Vec<u8> {
    let length = |at: usize| {
        let part = bytes.get(at..at + 8)?;
        usize::try_from(u64::from_le_bytes(part.try_into().ok()?)).ok()
    };
    let end = || {
        length(LENGTHS)?
            .checked_add(length(LENGTHS + 8)?)?
            .checked_add(LENGTHS + 16)
    };
    if let Some(end) = end()
        && end <= bytes.len().saturating_sub(4)
    {
        let checksum = crc32fast::hash(&bytes[..end]);
        bytes[end..end + 4].copy_from_slice(&checksum.to_le_bytes());
    }
    bytes
}
