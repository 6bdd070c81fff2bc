//! Damage: an input is a sound one with a few changes, a function of its number alone.

use rand::seq::IndexedRandom;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Words that replace words of a text.
const WORDS: [&str; 24] = [
    "",
    "0",
    "-0.0",
    "-1",
    "1",
    "2",
    "1e-300",
    "1e308",
    "1e30",
    "1e-9",
    "nan",
    "inf",
    "999999999",
    "4294967296",
    "18446744073709551615",
    "\"",
    "[",
    "]",
    "{}",
    "true",
    "é",
    "\u{0}",
    "\u{1b}[2J",
    "..",
];
/// Most changes of one input.
const CHANGES: u32 = 4;

/// Input `number` of `target`: one of its `corpus`, changed.
pub(crate) fn input(target: &str, seed: u64, number: u64, corpus: &[Vec<u8>]) -> Vec<u8> {
    let tag = target.bytes().fold(seed, |tag, byte| {
        tag.wrapping_mul(257).wrapping_add(byte.into())
    });
    let mut random = ChaCha8Rng::seed_from_u64(tag);
    random.set_stream(number);
    let mut bytes = corpus.choose(&mut random).cloned().unwrap_or_default();
    for _ in 0..random.random_range(0..=CHANGES) {
        match std::str::from_utf8(&bytes) {
            Ok(text) if random.random_bool(0.7) => bytes = reworded(text, &mut random).into_bytes(),
            _ => damage(&mut bytes, &mut random),
        }
    }
    bytes
}

/// A place in something of this length.
fn place(length: usize, random: &mut impl Rng) -> usize {
    random.random_range(0..=length)
}

/// Bytes changed, cut, doubled or made longer.
fn damage(bytes: &mut Vec<u8>, random: &mut impl Rng) {
    let at = place(bytes.len(), random);
    let end = (at + random.random_range(1..=32)).min(bytes.len());
    match random.random_range(0..6) {
        0 => bytes.truncate(at),
        1 => drop(bytes.drain(at..end)),
        2 => {
            let twice = bytes[at..end].to_vec();
            bytes.splice(at..at, twice);
        }
        3 => bytes[at..end].fill(*[0, 0xff, 0x80].choose(random).unwrap_or(&0)),
        4 => bytes[at..end]
            .iter_mut()
            .for_each(|byte| *byte ^= 1 << random.random_range(0..8)),
        _ => {
            let number: u64 = random.random();
            let number = number >> random.random_range(0..64);
            let put = number.to_le_bytes();
            let fits = put.len().min(bytes.len() - at);
            bytes[at..at + fits].copy_from_slice(&put[..fits]);
        }
    }
}

/// A word of a text replaced, or lines of it moved, doubled or left out.
fn reworded(text: &str, random: &mut impl Rng) -> String {
    if random.random_bool(0.7) {
        let inside = |c: char| c.is_alphanumeric() || "._-+".contains(c);
        let mut words: Vec<(usize, usize)> = Vec::new();
        for (at, c) in text.char_indices().filter(|(_, c)| inside(*c)) {
            let end = at + c.len_utf8();
            match words.last_mut() {
                Some(last) if last.1 == at => last.1 = end,
                _ => words.push((at, end)),
            }
        }
        let word = words.choose(random).copied().unwrap_or_default();
        // Another word of the text is more often sound than a foreign one.
        let other = words.choose(random).copied().unwrap_or_default();
        let put = match random.random_bool(0.4) {
            true => &text[other.0..other.1],
            false => WORDS.choose(random).copied().unwrap_or_default(),
        };
        return format!("{}{put}{}", &text[..word.0], &text[word.1..]);
    }
    let mut lines: Vec<&str> = text.lines().collect();
    if lines.is_empty() {
        return String::new();
    }
    let from = random.random_range(0..lines.len());
    let to = random.random_range(0..lines.len());
    match random.random_range(0..3) {
        0 => drop(lines.remove(from)),
        1 => lines.insert(to, lines[from]),
        _ => lines.swap(from, to),
    }
    lines.join("\n") + "\n"
}
