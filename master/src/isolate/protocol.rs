//! What a simulation and the process of an FMU say to each other: messages in postcard's format, each after its length.

use std::borrow::Cow;
use std::io::{self, Read, Write};
use std::path::PathBuf;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::calls::{CallEvent, Step};
use crate::value::Value;
use crate::variable::Place;

/// A call of an instance, as [`Participant`](crate::calls::Participant) has it.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum Request<'a> {
    /// Make the instance; always the first.
    Start {
        /// Where the FMU was read from, for messages.
        path: PathBuf,
        /// Where it is unpacked.
        folder: PathBuf,
        /// Name of the instance.
        name: Cow<'a, str>,
        logging: bool,
    },
    SetUp {
        tolerance: Option<f64>,
        start: f64,
        stop: f64,
        values: Cow<'a, [(Place, Value)]>,
    },
    EnterInitialization,
    ExitInitialization,
    Get(Cow<'a, [Place]>),
    Set(Cow<'a, [(Place, Value)]>),
    Step {
        time: f64,
        step: f64,
        no_rollback: bool,
    },
    Save,
    /// To the state of this number.
    Restore(u64),
    /// The state of this number.
    Free(u64),
    Finish,
    /// Free the instance and end; always the last.
    Close,
}

/// What a request answers if it does not fail.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum Answer {
    Done,
    Values(Vec<Value>),
    Step(Step),
    /// Number of a saved state.
    State(u64),
}

/// What the process of an FMU reports.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum Report {
    /// Something happens within a request.
    Event(CallEvent),
    /// The request is done, or failed with this message.
    Answers(Result<Answer, String>),
}

pub(super) fn send(out: &mut impl Write, message: &impl Serialize) -> io::Result<()> {
    let mut bytes = vec![0; size_of::<u64>()];
    bytes = postcard::to_extend(message, bytes).map_err(io::Error::other)?;
    let length = (bytes.len() - size_of::<u64>()) as u64;
    for (to, from) in bytes.iter_mut().zip(length.to_le_bytes()) {
        *to = from;
    }
    out.write_all(&bytes)
}

pub(super) fn receive<T: DeserializeOwned>(input: &mut impl Read) -> io::Result<T> {
    let mut length = [0; size_of::<u64>()];
    input.read_exact(&mut length)?;
    // A library that writes where it must not can send any length: memory grows with what comes.
    let mut bytes = Vec::new();
    input
        .take(u64::from_le_bytes(length))
        .read_to_end(&mut bytes)?;
    postcard::from_bytes(&bytes).map_err(io::Error::other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::value::ScalarType;

    #[test]
    fn messages_arrive_bit_for_bit() {
        let place = Place {
            reference: 7,
            element: 3,
            scalar: ScalarType::Float32,
        };
        let values = [f64::NAN, -0.0, f64::MIN_POSITIVE / 3.0, 0.1].map(Value::Real);
        let load: Vec<(Place, Value)> = values.map(|value| (place, value)).into();
        let mut wire = Vec::new();
        send(&mut wire, &Request::Set(Cow::Borrowed(&load))).unwrap();
        send(&mut wire, &Request::Save).unwrap();
        let mut read = &*wire;
        let Request::Set(found) = receive(&mut read).unwrap() else {
            panic!("another request");
        };
        let bits = |load: &[(Place, Value)]| -> Vec<(Place, u64)> {
            let bits = |value: &Value| match value {
                Value::Real(value) => value.to_bits(),
                _ => 0,
            };
            load.iter()
                .map(|(place, value)| (*place, bits(value)))
                .collect()
        };
        assert_eq!(bits(&found), bits(&load));
        assert!(matches!(receive(&mut read), Ok(Request::Save)));
        // What ends early, or is no message, is an error at once.
        for broken in [&wire[..wire.len() - 1], &[255; 64], &[]] {
            let mut read = broken;
            let all: io::Result<Vec<Request<'_>>> = std::iter::repeat_with(|| receive(&mut read))
                .take(3)
                .collect();
            assert!(all.is_err(), "{all:?}");
        }
    }
}
