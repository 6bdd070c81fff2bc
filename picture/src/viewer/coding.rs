//! How numbers become few bytes: whole numbers, their change from frame to frame, their odds ([`super::entropy`]).
//!
//! ```text
//! position  n = round((x - origin) / q)       |x - x'| <= q/2 along each axis
//! field     n = round(K asinh(v / s))         |v - v'| <= sqrt(v^2 + s^2) / (2 K)
//! change    d = n, n - n1 or n - (2 n1 - n2), whichever is shortest (n1, n2: the frames before, same sphere)
//! planes    zigzag(d) = 2 d or -2 d - 1, all lowest bytes, then all second bytes ...; deflated
//! ```
//!
//! What rests becomes zeros, which cost nothing.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::DeflateEncoder;

use super::entropy::{Encoder, Numbers};

/// Largest value of a field over the `s` of its coding: what is smaller by that much reads as zero within `s/(2 K)`.
pub(super) const RANGE: f64 = 1e4;
/// Largest whole number that the page holds exactly, with room for second differences.
pub(super) const LARGEST: f64 = (1_i64 << 46) as f64;

/// `K` and `s` of a field up to `largest`: 0.5 % of a value.
pub(super) fn coding(largest: f64) -> (f64, f64) {
    (100.0, largest / RANGE)
}

/// The whole number of a field's component in `steps` `K` per unit of its logarithm; `scale` is `s`, zero for a field
/// that is zero everywhere.
pub(super) fn compressed(value: f64, scale: f64, steps: f64) -> i64 {
    if scale == 0.0 {
        return 0;
    }
    (steps * (value / scale).asinh()).round() as i64
}

/// 0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4 ...
fn zigzag(d: i64) -> u64 {
    ((d << 1) ^ (d >> 63)) as u64
}

/// Appends whole numbers as byte planes: the number of planes (at most 6), then each.
pub(super) fn put_planes(out: &mut Vec<u8>, values: &[i64]) {
    let largest = values.iter().map(|&d| zigzag(d)).max().unwrap_or(0);
    let count = (64 - largest.leading_zeros()).div_ceil(8);
    out.push(count as u8);
    for plane in 0..count {
        out.extend(values.iter().map(|&d| (zigzag(d) >> (8 * plane)) as u8));
    }
}

/// Appends one bit for each of `bits`, lowest first.
pub(super) fn put_bits(out: &mut Vec<u8>, bits: impl Iterator<Item = bool>) {
    let (mut byte, mut count) = (0_u8, 0_u32);
    for bit in bits {
        byte |= u8::from(bit) << count;
        count += 1;
        if count == 8 {
            out.push(byte);
            (byte, count) = (0, 0);
        }
    }
    if count > 0 {
        out.push(byte);
    }
}

/// Slots of a stream that the choice of its way looks at.
const SAMPLE: usize = 500;

/// What a whole number of a sphere is told against.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Against {
    /// Zero.
    Nothing,
    /// The one in the frame before.
    Last,
    /// What comes if the last change goes on.
    Motion,
}

/// Appends whole numbers over the frames of a block: frame by frame, in each those slots that are `present`. The first time
/// a slot is there it is told against the slot before it, or against nothing. A byte says which way is taken: the shortest for
/// every n-th slot, with at least [`SAMPLE`] of them.
pub(super) fn put_stream(out: &mut Vec<u8>, frames: &[Vec<i64>], present: &[Vec<bool>]) {
    let ways = [Against::Nothing, Against::Last, Against::Motion];
    let slots = frames.first().map_or(0, Vec::len);
    let stride = (slots / SAMPLE).max(1);
    let tried = ways.map(|against| told(frames, present, against, stride));
    let shortest = (0..ways.len()).min_by_key(|&k| tried[k].len()).unwrap_or(0);
    out.push(shortest as u8);
    match stride {
        1 => out.extend(&tried[shortest]),
        _ => out.extend(told(frames, present, ways[shortest], 1)),
    }
}

/// The code of every `stride`-th slot.
fn told(frames: &[Vec<i64>], present: &[Vec<bool>], against: Against, stride: usize) -> Vec<u8> {
    let slots = frames.first().map_or(0, Vec::len);
    let mut last = vec![0_i64; slots];
    let mut before = vec![0_i64; slots];
    let mut change = vec![0_i64; slots];
    let mut known = vec![0_u8; slots];
    let (mut encoder, mut odds) = (Encoder::new(), Numbers::new());
    for (values, here) in frames.iter().zip(present) {
        let mut neighbour = 0;
        for slot in (0..slots).step_by(stride).filter(|&slot| here[slot]) {
            let expected = match (against, known[slot]) {
                (Against::Nothing, _) => 0,
                (_, 0) => neighbour,
                (Against::Motion, 2) => 2 * last[slot] - before[slot],
                _ => last[slot],
            };
            let told = values[slot] - expected;
            odds.put(&mut encoder, told, change[slot]);
            // How a slot begins says nothing of how it changes.
            if known[slot] > 0 || against == Against::Nothing {
                change[slot] = told;
            }
            before[slot] = last[slot];
            last[slot] = values[slot];
            known[slot] = (known[slot] + 1).min(2);
            neighbour = values[slot];
        }
    }
    let mut out = Vec::new();
    encoder.finish(&mut out);
    out
}

/// Deflates bytes (RFC 1951, without a header).
pub(super) fn deflated(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::new(6));
    // Writing to memory cannot fail; if it did, the page would say that a block is cut short.
    let written = encoder.write_all(bytes);
    let out = encoder.finish().unwrap_or_default();
    written.map(|()| out).unwrap_or_default()
}

/// The bytes of numbers in single precision, little endian, deflated by byte planes.
pub(super) fn singles(values: &[f32]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(4 * values.len());
    for plane in 0..4 {
        bytes.extend(values.iter().map(|v| v.to_le_bytes()[plane]));
    }
    deflated(&bytes)
}

/// As [`singles`], in double precision.
pub(super) fn doubles(values: &[f64]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(8 * values.len());
    for plane in 0..8 {
        bytes.extend(values.iter().map(|v| v.to_le_bytes()[plane]));
    }
    deflated(&bytes)
}

/// Whole numbers, each told against the one before, as byte planes, deflated.
pub(super) fn wholes(values: impl Iterator<Item = i64>) -> Vec<u8> {
    let mut last = 0;
    let changes: Vec<i64> = values
        .map(|v| v - std::mem::replace(&mut last, v))
        .collect();
    let mut bytes = Vec::new();
    put_planes(&mut bytes, &changes);
    deflated(&bytes)
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use flate2::read::DeflateDecoder;
    use proptest::prelude::*;

    use super::super::entropy::tests::Decoder;
    use super::*;

    fn inflated(bytes: &[u8]) -> Vec<u8> {
        let mut out = Vec::new();
        DeflateDecoder::new(bytes).read_to_end(&mut out).unwrap();
        out
    }

    /// What the page does, in `data.js`: the codes of the slots that are present, frame by frame.
    fn undone(stream: &[u8], present: &[Vec<bool>]) -> Vec<Vec<i64>> {
        let (&against, mut rest) = stream.split_first().unwrap();
        let (mut decoder, mut odds) = (Decoder::new(&mut rest), Numbers::new());
        assert!(rest.is_empty());
        let slots = present.first().map_or(0, Vec::len);
        let (mut known, mut changes) = (vec![Vec::new(); slots], vec![0; slots]);
        let mut out = Vec::new();
        for here in present {
            let mut neighbour = 0;
            let mut row = Vec::new();
            for (slot, _) in here.iter().enumerate().filter(|(_, is)| **is) {
                let own: &mut Vec<i64> = &mut known[slot];
                let expected = match own[..] {
                    _ if against == 0 => 0,
                    [] => neighbour,
                    [.., before, last] if against == 2 => 2 * last - before,
                    [.., last] => last,
                };
                let change = decoder.number(&mut odds, changes[slot]);
                if !own.is_empty() || against == 0 {
                    changes[slot] = change;
                }
                own.push(expected + change);
                row.push(expected + change);
                neighbour = expected + change;
            }
            out.push(row);
        }
        out
    }

    /// Frames of codes, and which slots are there.
    fn block() -> impl Strategy<Value = (Vec<Vec<i64>>, Vec<Vec<bool>>)> {
        (1..9_usize, 1..8_usize).prop_flat_map(|(frames, slots)| {
            let code = -(1_i64 << 45)..(1_i64 << 45);
            let row = proptest::collection::vec(code, slots);
            let here = proptest::collection::vec(any::<bool>(), slots);
            let all = |row| proptest::collection::vec(row, frames);
            (all(row), proptest::collection::vec(here, frames))
        })
    }

    proptest! {
        #[test]
        fn a_block_comes_back((frames, present) in block()) {
            let mut stream = Vec::new();
            put_stream(&mut stream, &frames, &present);
            let expected: Vec<Vec<i64>> = frames.iter().zip(&present)
                .map(|(row, here)| row.iter().zip(here).filter(|(_, is)| **is).map(|(&v, _)| v).collect())
                .collect();
            prop_assert_eq!(undone(&stream, &present), expected);
        }

        /// The stated error: half a step of the logarithm, near zero that of the smallest value.
        #[test]
        fn a_field_is_as_exact_as_stated(value in -1e6..1e6_f64, scale in 1e-3..1e5_f64, steps in 20.0..200.0_f64) {
            let back = scale * (compressed(value, scale, steps) as f64 / steps).sinh();
            // Half a step, its second order included.
            let bound = value.hypot(scale) * (0.5 / steps) * (1.0 + 1.0 / steps);
            prop_assert!((back - value).abs() <= bound, "{} came back as {}", value, back);
        }

        #[test]
        fn planes_and_bits_come_back(values in proptest::collection::vec(-(1_i64 << 40)..1 << 40, 1..50),
            bits in proptest::collection::vec(any::<bool>(), 0..40))
        {
            let bytes = inflated(&wholes(values.iter().copied()));
            let (planes, rest) = bytes.split_first().unwrap();
            let number = |k: usize| {
                let plane = |p: usize| u64::from(rest[p * values.len() + k]) << (8 * p);
                let z: u64 = (0..usize::from(*planes)).map(plane).sum();
                (z >> 1) as i64 ^ -((z & 1) as i64)
            };
            let mut last = 0;
            for (k, &value) in values.iter().enumerate() {
                last += number(k);
                prop_assert_eq!(last, value);
            }
            let mut bytes = Vec::new();
            put_bits(&mut bytes, bits.iter().copied());
            let back: Vec<bool> = (0..bits.len()).map(|k| bytes[k / 8] >> (k % 8) & 1 == 1).collect();
            prop_assert_eq!(back, bits);
        }
    }

    #[test]
    fn motion_that_goes_on_costs_nothing() {
        let present = vec![vec![true; 100]; 16];
        let stream = |code: &dyn Fn(i64, i64) -> i64| {
            let frames: Vec<Vec<i64>> = (0..16)
                .map(|frame| (0..100).map(|slot| code(frame, slot)).collect())
                .collect();
            let mut out = Vec::new();
            put_stream(&mut out, &frames, &present);
            assert_eq!(undone(&out, &present), frames);
            (out[0], out.len())
        };
        let rests = stream(&|_, slot| 1000 * slot).1;
        let (against, moves) = stream(&|frame, slot| 1000 * slot + 700 * frame);
        assert_eq!(against, 2);
        assert!(moves < rests + 200, "{moves} {rests}");
        // Noise has nothing to do with the frame before.
        let noise = |frame: i64, slot: i64| {
            let seed = (100 * frame + slot) as u64;
            let mixed = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
            let mixed = (mixed ^ (mixed >> 31)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            (mixed >> 40) as i64 % 64
        };
        assert_eq!(stream(&noise).0, 0);
        assert_eq!(compressed(0.0, 0.0, 100.0), 0);
    }
}
