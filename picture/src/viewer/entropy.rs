//! Whole numbers by their odds: an adaptive binary range coder (G. N. N. Martin, 1979, carries as in LZMA). `entropy.js`
//! decodes.
//!
//! ```text
//! chance    P(0) 2^16 of a bit, mean of two that follow the bits seen: p += (2^16 - 1 - p) >> r or p -= p >> r, r = 4, 7
//! number v  as many bits 1 as |v| has digits, a 0; whether v < 0; the digits below the first, the lowest beyond the third at
//!           even odds. The odds depend on the number before of the same sphere: its sign and half octave
//! byte      eight bits from the highest; the odds depend on those before and on a context
//! file      length u32, the code
//! ```
//!
//! Deflate spends whole bits on a symbol and finds no strings in what moves at random: this is a tenth to a fifth shorter.

const RATES: [u32; 2] = [4, 7];
const BOTTOM: u32 = 1 << 24;

/// The odds of a bit.
#[derive(Debug, Clone, Copy)]
struct Chance([u16; 2]);

impl Chance {
    const EVEN: Self = Self([1 << 15; 2]);

    fn zero(self) -> u32 {
        (u32::from(self.0[0]) + u32::from(self.0[1])) >> 1
    }

    fn learn(&mut self, bit: bool) {
        for (p, rate) in self.0.iter_mut().zip(RATES) {
            match bit {
                true => *p -= *p >> rate,
                false => *p += (u16::MAX - *p) >> rate,
            }
        }
    }
}

/// Bits on the way to bytes.
pub(super) struct Encoder {
    low: u64,
    range: u32,
    /// The byte that a carry may still change, and how many 255 follow it.
    last: u8,
    full: usize,
    out: Vec<u8>,
}

impl Encoder {
    pub(super) fn new() -> Self {
        Self {
            low: 0,
            range: u32::MAX,
            last: 0,
            full: 0,
            out: Vec::new(),
        }
    }

    fn shift(&mut self) {
        if self.low < 0xff00_0000 || self.low > u64::from(u32::MAX) {
            let carry = (self.low >> 32) as u8;
            self.out.push(self.last.wrapping_add(carry));
            let rest = std::mem::take(&mut self.full);
            self.out
                .extend(std::iter::repeat_n(0xff_u8.wrapping_add(carry), rest));
            self.last = (self.low >> 24) as u8;
        } else {
            self.full += 1;
        }
        self.low = (self.low & 0x00ff_ffff) << 8;
    }

    fn narrow(&mut self) {
        while self.range < BOTTOM {
            self.range <<= 8;
            self.shift();
        }
    }

    fn bit(&mut self, chance: &mut Chance, bit: bool) {
        let bound = (self.range >> 16) * chance.zero();
        if bit {
            self.low += u64::from(bound);
            self.range -= bound;
        } else {
            self.range = bound;
        }
        chance.learn(bit);
        self.narrow();
    }

    fn even(&mut self, bit: bool) {
        self.range >>= 1;
        if bit {
            self.low += u64::from(self.range);
        }
        self.narrow();
    }

    /// Appends length and code.
    pub(super) fn finish(mut self, out: &mut Vec<u8>) {
        for _ in 0..5 {
            self.shift();
        }
        out.extend((self.out.len() as u32).to_le_bytes());
        out.extend(self.out);
    }
}

const CONTEXTS: usize = 33;
/// Digits that a number may have.
const DIGITS: usize = 64;

/// Sign and half octave of the number before.
fn context(last: i64) -> usize {
    let size = last.unsigned_abs();
    let octave = match size {
        0 | 1 => size,
        _ => {
            let digits = u64::from(64 - size.leading_zeros());
            2 * (digits - 1) + (size >> (digits - 2) & 1)
        }
    };
    (16 + octave.min(16) as i64 * last.signum()) as usize
}

/// The odds of numbers.
pub(super) struct Numbers {
    digits: Vec<[Chance; DIGITS]>,
    negative: [Chance; CONTEXTS],
    below: Vec<[Chance; 8]>,
}

impl Numbers {
    pub(super) fn new() -> Self {
        Self {
            digits: vec![[Chance::EVEN; DIGITS]; CONTEXTS],
            negative: [Chance::EVEN; CONTEXTS],
            below: vec![[Chance::EVEN; 8]; DIGITS],
        }
    }

    /// Tells a number; `last` is the one before of the same sphere.
    pub(super) fn put(&mut self, encoder: &mut Encoder, number: i64, last: i64) {
        let (context, size) = (context(last), number.unsigned_abs());
        let digits = (64 - size.leading_zeros()) as usize;
        for k in 0..=digits {
            encoder.bit(&mut self.digits[context][k], k < digits);
        }
        if digits == 0 {
            return;
        }
        encoder.bit(&mut self.negative[context], number < 0);
        let mut node = 1;
        for k in (0..digits - 1).rev() {
            let digit = size >> k & 1 == 1;
            if node < 8 {
                encoder.bit(&mut self.below[digits][node], digit);
                node = 2 * node + usize::from(digit);
            } else {
                encoder.even(digit);
            }
        }
    }
}

/// The odds of bytes, in a number of contexts.
pub(super) struct Bytes(Vec<[Chance; 256]>);

impl Bytes {
    pub(super) fn new(contexts: usize) -> Self {
        Self(vec![[Chance::EVEN; 256]; contexts])
    }

    pub(super) fn put(&mut self, encoder: &mut Encoder, byte: u8, context: usize) {
        let mut node = 1;
        for k in (0..8).rev() {
            let bit = byte >> k & 1 == 1;
            encoder.bit(&mut self.0[context][node], bit);
            node = 2 * node + usize::from(bit);
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use proptest::prelude::*;

    use super::*;

    /// What the page does, in `entropy.js`.
    pub(in super::super) struct Decoder<'a> {
        code: u32,
        range: u32,
        rest: &'a [u8],
    }

    impl<'a> Decoder<'a> {
        /// Takes a file off the front of `bytes`.
        pub(in super::super) fn new(bytes: &mut &'a [u8]) -> Self {
            let (length, rest) = bytes.split_at(4);
            let length = u32::from_le_bytes(length.try_into().unwrap()) as usize;
            let (own, rest) = rest.split_at(length);
            *bytes = rest;
            let code = u32::from_be_bytes(own[1..5].try_into().unwrap());
            Self {
                code,
                range: u32::MAX,
                rest: &own[5..],
            }
        }

        fn widen(&mut self) {
            while self.range < BOTTOM {
                self.range <<= 8;
                let (&byte, rest) = self.rest.split_first().unwrap_or((&0, &[]));
                self.code = self.code << 8 | u32::from(byte);
                self.rest = rest;
            }
        }

        fn bit(&mut self, chance: &mut Chance) -> bool {
            let bound = (self.range >> 16) * chance.zero();
            let bit = self.code >= bound;
            if bit {
                self.code -= bound;
                self.range -= bound;
            } else {
                self.range = bound;
            }
            chance.learn(bit);
            self.widen();
            bit
        }

        fn even(&mut self) -> bool {
            self.range >>= 1;
            let bit = self.code >= self.range;
            if bit {
                self.code -= self.range;
            }
            self.widen();
            bit
        }

        pub(in super::super) fn number(&mut self, numbers: &mut Numbers, last: i64) -> i64 {
            let context = context(last);
            let mut digits = 0;
            while self.bit(&mut numbers.digits[context][digits]) {
                digits += 1;
            }
            if digits == 0 {
                return 0;
            }
            let negative = self.bit(&mut numbers.negative[context]);
            let (mut size, mut node) = (1_i64, 1);
            for _ in 1..digits {
                let digit = match node < 8 {
                    true => self.bit(&mut numbers.below[digits][node]),
                    false => self.even(),
                };
                node = 2 * node + usize::from(digit);
                size = 2 * size + i64::from(digit);
            }
            if negative { -size } else { size }
        }

        fn byte(&mut self, bytes: &mut Bytes, context: usize) -> u8 {
            let mut node = 1;
            for _ in 0..8 {
                node = 2 * node + usize::from(self.bit(&mut bytes.0[context][node]));
            }
            node as u8
        }
    }

    proptest! {
        #[test]
        fn numbers_and_bytes_come_back(
            numbers in proptest::collection::vec((-40_i64..40, 0..46_u32), 0..600),
            bytes in proptest::collection::vec((any::<u8>(), 0..3_usize), 0..600),
        ) {
            let numbers: Vec<i64> = numbers.iter().map(|&(v, scale)| if v > 30 { v << scale } else { v }).collect();
            let mut file = Vec::new();
            let (mut encoder, mut odds, mut other) = (Encoder::new(), Numbers::new(), Bytes::new(3));
            let mut last = 0;
            for &number in &numbers {
                odds.put(&mut encoder, number, std::mem::replace(&mut last, number));
            }
            for &(byte, context) in &bytes {
                other.put(&mut encoder, byte, context);
            }
            encoder.finish(&mut file);
            file.push(7);
            let mut rest = &file[..];
            let (mut decoder, mut odds, mut other) = (Decoder::new(&mut rest), Numbers::new(), Bytes::new(3));
            prop_assert_eq!(rest, &[7]);
            let mut last = 0;
            for &number in &numbers {
                last = decoder.number(&mut odds, last);
                prop_assert_eq!(last, number);
            }
            for &(byte, context) in &bytes {
                prop_assert_eq!(decoder.byte(&mut other, context), byte);
            }
        }
    }

    /// Carries run through bytes of 255.
    #[test]
    fn what_hardly_ever_happens_costs_much_and_what_is_sure_nothing() {
        let length = |list: &[i64]| {
            let (mut encoder, mut odds, mut out) = (Encoder::new(), Numbers::new(), Vec::new());
            list.iter()
                .for_each(|&number| odds.put(&mut encoder, number, 0));
            encoder.finish(&mut out);
            out.len()
        };
        assert!(length(&[0; 100_000]) < 150);
        let mut rare = vec![0; 100_000];
        rare[50_000] = 1 << 40;
        assert!(length(&rare) < 170);
        // Fair coins take their bit.
        let fair: Vec<i64> = (0..80_000_u64)
            .map(|k| (k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 63) as i64)
            .collect();
        assert!((length(&fair) as f64 / 1e4 - 1.0).abs() < 0.05);
    }
}
