//! Random numbers that a seed determines for ever, on every machine.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// Uniform in \[0, 1), from the upper 53 bits of one word.
#[must_use]
pub fn unit(random: &mut ChaCha8Rng) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// Uniform in \[-1, 1), likewise.
#[must_use]
pub fn symmetric(random: &mut ChaCha8Rng) -> f64 {
    2.0 * unit(random) - 1.0
}
