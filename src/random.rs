//! Random numbers that mean the same on every machine: ChaCha8 words, exact arithmetic, and `libm`'s logarithm
//! instead of the platform's.

use nalgebra::{Quaternion, UnitQuaternion};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// Uniform in \[0, 1), from the upper 53 bits of one word, so that a seed means the same spheres for ever.
#[must_use]
pub fn unit(random: &mut ChaCha8Rng) -> f64 {
    let bits = random.next_u64() >> 11;
    bits as f64 / (1_u64 << 53) as f64
}

/// Uniform in \[-1, 1).
#[must_use]
pub fn symmetric(random: &mut ChaCha8Rng) -> f64 {
    2.0 * unit(random) - 1.0
}

/// A rotation, all being alike (Marsaglia 1972).
#[must_use]
pub fn rotation(random: &mut ChaCha8Rng) -> UnitQuaternion<f64> {
    loop {
        let [w, i, j, k] = std::array::from_fn(|_| symmetric(random));
        let q = Quaternion::new(w, i, j, k);
        let square = q.norm_squared();
        if square > 1e-4 && square <= 1.0 {
            return UnitQuaternion::new_normalize(q);
        }
    }
}

/// Standard normal, by the polar method of Marsaglia and Bray (1964); its second deviate is not kept, so that
/// every draw stands for itself.
#[must_use]
pub fn normal(random: &mut ChaCha8Rng) -> f64 {
    loop {
        let (x, y) = (symmetric(random), symmetric(random));
        let s = x * x + y * y;
        if s > 0.0 && s < 1.0 {
            return x * (-2.0 * libm::log(s) / s).sqrt();
        }
    }
}
