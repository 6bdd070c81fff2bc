// Undoes entropy.rs: numbers and bytes from an adaptive range coder.

const EVEN = 1 << 15;
const BOTTOM = 2 ** 24;
const CONTEXTS = 33;
const DIGITS = 64;

/** Odds of `count` bits, two numbers each. */
const odds = (count) => new Uint16Array(2 * count).fill(EVEN);

/** Odds of numbers. */
export class Numbers {
  digits = odds(CONTEXTS * DIGITS);
  negative = odds(CONTEXTS);
  below = odds(DIGITS * 8);
}

/** Odds of bytes, in a number of contexts. */
export class Bytes {
  constructor(contexts) {
    this.odds = odds(contexts * 256);
  }
}

function context(last) {
  const size = Math.abs(last);
  if (size < 2) return 16 + last;
  // Digits of a number of up to 53 bits.
  const digits = size < 2 ** 31 ? 32 - Math.clz32(size) : 64 - Math.clz32(size / 2 ** 32);
  const octave = Math.min(2 * (digits - 1) + (Math.floor(size / 2 ** (digits - 2)) % 2), 16);
  return last < 0 ? 16 - octave : 16 + octave;
}

export class Decoder {
  /** Takes a file from a reader. */
  constructor(reader) {
    const length = new DataView(reader.take(4).slice().buffer).getUint32(0, true);
    this.data = reader.take(length);
    this.range = 2 ** 32 - 1;
    this.code = new DataView(this.data.slice(1, 5).buffer).getUint32(0);
    this.at = 5;
  }

  bit(odds, k) {
    const [a, b] = [2 * k, 2 * k + 1];
    const bound = (this.range >>> 16) * ((odds[a] + odds[b]) >>> 1);
    let bit = 0;
    if (this.code < bound) {
      this.range = bound;
      odds[a] += (65535 - odds[a]) >>> 4;
      odds[b] += (65535 - odds[b]) >>> 7;
    } else {
      bit = 1;
      this.code -= bound;
      this.range -= bound;
      odds[a] -= odds[a] >>> 4;
      odds[b] -= odds[b] >>> 7;
    }
    while (this.range < BOTTOM) this.widen();
    return bit;
  }

  even() {
    this.range = Math.floor(this.range / 2);
    const bit = this.code < this.range ? 0 : 1;
    if (bit) this.code -= this.range;
    while (this.range < BOTTOM) this.widen();
    return bit;
  }

  widen() {
    this.range *= 256;
    this.code = this.code * 256 + (this.data[this.at++] ?? 0);
  }

  number(numbers, last) {
    const own = context(last);
    let digits = 0;
    while (this.bit(numbers.digits, own * DIGITS + digits)) digits++;
    if (!digits) return 0;
    const negative = this.bit(numbers.negative, own);
    let [size, node] = [1, 1];
    for (let k = 1; k < digits; k++) {
      const digit = node < 8 ? this.bit(numbers.below, digits * 8 + node) : this.even();
      node = 2 * node + digit;
      size = 2 * size + digit;
    }
    return negative ? -size : size;
  }

  byte(bytes, context) {
    let node = 1;
    for (let k = 0; k < 8; k++) node = 2 * node + this.bit(bytes.odds, context * 256 + node);
    return node & 255;
  }
}
