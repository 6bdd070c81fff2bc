// Reads the parts of the page: head, tables, blocks of frames. The layout is told in coding.rs, blocks.rs, contacts.rs and text.rs.

import { Bytes, Decoder, Numbers } from "./entropy.js";

/** Bytes of decoded blocks that are kept. */
const CACHE = 384e6;

export function element(name) {
  const found = document.getElementById(name);
  if (!found) throw new Error(`the page has no part "${name}": it was cut short, write it again`);
  return found;
}

/** Undoes text.rs: bytes of seven bits for each character. */
function bytes(text) {
  const barred = [0, 13, 60];
  const sevens = new Uint8Array(2 * text.length);
  let count = 0;
  for (let k = 0; k < text.length; k++) {
    const code = text.charCodeAt(k);
    if (code < 128) sevens[count++] = code;
    else {
      const place = (code >> 7) - 1;
      sevens[count++] = barred[place % 3];
      if (place < 3) sevens[count++] = code & 127;
    }
  }
  const out = new Uint8Array(Math.floor((7 * count) / 8));
  let [held, bits, at] = [0, 0, 0];
  for (let k = 0; k < count; k++) {
    held = ((held << 7) | sevens[k]) & 0xffff;
    bits += 7;
    if (bits >= 8) {
      bits -= 8;
      out[at++] = held >> bits;
    }
  }
  return out;
}

/** The bytes of a part. */
export async function part(name) {
  const packed = bytes(element(name).textContent);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Little-endian numbers that were stored by byte planes. */
function gathered(planes, size, Kind) {
  const count = planes.length / size;
  const out = new Uint8Array(planes.length);
  for (let plane = 0; plane < size; plane++) {
    for (let k = 0; k < count; k++) out[k * size + plane] = planes[plane * count + k];
  }
  return new Kind(out.buffer);
}

const singles = async (name) => gathered(await part(name), 4, Float32Array);
const doubles = async (name) => gathered(await part(name), 8, Float64Array);

/** Signed numbers from byte planes of their zigzag. */
function planes(reader, count) {
  const out = new Float64Array(count);
  let factor = 1;
  for (let left = reader.byte(); left > 0; left--) {
    const plane = reader.take(count);
    for (let k = 0; k < count; k++) out[k] += factor * plane[k];
    factor *= 256;
  }
  for (let k = 0; k < count; k++) {
    const z = out[k];
    out[k] = z % 2 === 0 ? z / 2 : -(z + 1) / 2;
  }
  return out;
}

async function wholes(name, count) {
  const out = planes(new Reader(await part(name)), count);
  for (let k = 1; k < count; k++) out[k] += out[k - 1];
  return out;
}

class Reader {
  constructor(data) {
    this.data = data;
    this.at = 0;
  }
  byte() {
    return this.take(1)[0];
  }
  take(count) {
    const end = this.at + count;
    if (end > this.data.length) throw new Error("a block of the page is cut short: write it again");
    const out = this.data.subarray(this.at, end);
    this.at = end;
    return out;
  }
  bits(count) {
    const packed = this.take(Math.ceil(count / 8));
    const out = new Uint8Array(count);
    for (let k = 0; k < count; k++) out[k] = (packed[k >> 3] >> (k & 7)) & 1;
    return out;
  }
}

/** Undoes `put_stream` of coding.rs: whole numbers by frame and slot. */
function stream(reader, present) {
  const slots = present[0].length;
  const [nothing, motion] = ((against) => [against === 0, against === 2])(reader.byte());
  const [decoder, numbers] = [new Decoder(reader), new Numbers()];
  const last = new Float64Array(slots);
  const before = new Float64Array(slots);
  const change = new Float64Array(slots);
  const known = new Uint8Array(slots);
  return present.map((here) => {
    let neighbour = 0;
    for (let s = 0; s < slots; s++) {
      if (!here[s]) continue;
      let expected = last[s];
      if (nothing) expected = 0;
      else if (known[s] === 0) expected = neighbour;
      else if (known[s] === 2 && motion) expected = 2 * last[s] - before[s];
      const told = decoder.number(numbers, change[s]);
      if (known[s] > 0 || nothing) change[s] = told;
      before[s] = last[s];
      neighbour = last[s] = expected + told;
      if (known[s] < 2) known[s]++;
    }
    return last.slice();
  });
}

/** The data of the page. */
export class Data {
  static async open() {
    const data = new Data();
    data.head = JSON.parse(element("head").textContent);
    const { head } = data;
    const count = head.spheres;
    [data.id, data.material, data.radius, data.motion, data.force] = await Promise.all([
      wholes("sphere-id", count),
      wholes("sphere-material", count),
      doubles("sphere-radius"),
      singles("boundary-motion"),
      singles("boundary-force"),
    ]);
    data.surfaces = await Promise.all(
      head.boundaries.map(async (boundary, k) => ({
        points: await singles(`boundary${k}-points`),
        triangles: Uint32Array.from(await wholes(`boundary${k}-triangles`, 3 * boundary.triangles)),
      })),
    );
    return data;
  }

  constructor() {
    this.blocks = new Map();
    this.held = 0;
    this.columns = new Map();
  }

  blockOf(frame) {
    return Math.floor(frame / this.head.framesPerBlock);
  }

  /** A part of a block, decoded once; the oldest are forgotten where there are too many. */
  decoded(name, size, decode) {
    let entry = this.blocks.get(name);
    if (entry) this.blocks.delete(name);
    else {
      entry = { size, value: decode() };
      this.held += size;
      entry.value.catch(() => {});
    }
    this.blocks.set(name, entry);
    for (const [oldest, { size }] of this.blocks) {
      if (this.held <= CACHE || oldest === name) break;
      this.blocks.delete(oldest);
      this.held -= size;
    }
    return entry.value;
  }

  framesIn(block) {
    const { framesPerBlock, times } = this.head;
    return Math.min(framesPerBlock, times.length - block * framesPerBlock);
  }

  /** Presence, jumps and centres [m] of a block's frames. */
  movement(block) {
    const { spheres: slots, origin, step } = this.head;
    const frames = this.framesIn(block);
    return this.decoded(`motion-${block}`, frames * slots * 26, async () => {
      const reader = new Reader(await part(`motion-${block}`));
      const present = [];
      for (let f = 0; f < frames; f++) {
        const how = reader.byte();
        if (how === 0) present.push(present[f - 1]);
        else present.push(how === 1 ? new Uint8Array(slots).fill(1) : reader.bits(slots));
      }
      const jumps = present.map(() => (reader.byte() ? reader.bits(slots) : null));
      const codes = [0, 1, 2].map(() => stream(reader, present));
      return present.map((here, f) => {
        const centres = new Float64Array(3 * slots);
        for (let axis = 0; axis < 3; axis++) {
          const own = codes[axis][f];
          for (let s = 0; s < slots; s++) centres[3 * s + axis] = origin[axis] + step * own[s];
        }
        return { present: here, jumps: jumps[f], centres };
      });
    });
  }

  /** Values of field `k` by frame of a block, components of a sphere one after the other. */
  field(k, block) {
    const { spheres: slots, fields } = this.head;
    const { components, scale, steps } = fields[k];
    const frames = this.framesIn(block);
    return this.decoded(`field${k}-${block}`, frames * slots * components * 4, async () => {
      const moments = await this.movement(block);
      const reader = new Reader(await part(`field${k}-${block}`));
      const present = moments.map((moment) => moment.present);
      const out = present.map(() => new Float32Array(slots * components));
      for (let c = 0; c < components; c++) {
        stream(reader, present).forEach((codes, f) => {
          for (let s = 0; s < slots; s++) out[f][s * components + c] = scale * Math.sinh(codes[s] / steps);
        });
      }
      return out;
    });
  }

  /** Numbers of the first triangle of each boundary among those that keep what they feel. */
  get firstFelt() {
    let first = 0;
    return this.head.boundaries.map(({ felt, triangles }) => (felt ? (first += triangles) - triangles : null));
  }

  /** What all these triangles feel, quantity `k` by frame of a block. */
  wall(k, block) {
    const { boundaries, walls } = this.head;
    const { scale, steps } = walls[k];
    const count = boundaries.reduce((sum, { felt, triangles }) => sum + (felt ? triangles : 0), 0);
    const frames = this.framesIn(block);
    return this.decoded(`wall${k}-${block}`, frames * count * 4, async () => {
      const present = Array(frames).fill(new Uint8Array(count).fill(1));
      const codes = stream(new Reader(await part(`wall${k}-${block}`)), present);
      return codes.map((own) => Float32Array.from(own, (code) => scale * Math.sinh(code / steps)));
    });
  }

  /** Contacts by frame of a block: ranks of the spheres, partner, form, force [N], branch [m]. */
  contacts(block) {
    const frames = this.framesIn(block);
    return this.decoded(`contacts-${block}`, frames * this.head.spheres * 60, async () => {
      const decoder = new Decoder(new Reader(await part(`contacts-${block}`)));
      const [counts, ranks, partners] = [new Numbers(), new Numbers(), new Numbers()];
      const [forms, forces, branches] = [new Bytes(1), new Bytes(64), new Bytes(1)];
      const { largest, decades, levels } = this.head.forces;
      const pairs = [];
      const press = (one) => {
        one.code = decoder.byte(forces, one.code >> 2);
        if (one.code && one.form) one.bytes = one.bytes.map((b) => (b + decoder.byte(branches, 0)) & 255);
      };
      return Array.from({ length: frames }, () => {
        pairs.forEach(press);
        for (let left = decoder.number(counts, 0), rank = 0; left > 0; left--) {
          rank += decoder.number(ranks, 0);
          const one = { rank, partner: decoder.number(partners, 0), form: decoder.byte(forms, 0), code: 0, bytes: [0, 0, 0] };
          press(one);
          pairs.push(one);
        }
        const now = pairs.filter((one) => one.code);
        const count = now.length;
        const out = {
          count,
          rank: new Int32Array(count),
          partner: new Int32Array(count),
          form: new Uint8Array(count),
          force: new Float32Array(count),
          branch: new Float32Array(3 * count),
        };
        now.forEach((one, k) => {
          out.rank[k] = one.rank;
          out.partner[k] = one.partner;
          out.form[k] = one.form;
          out.force[k] = largest * 10 ** ((decades * (one.code - levels)) / (levels - 1));
          const other = one.form === 2 ? this.radius[one.partner] : 0;
          const length = 1.05 * (this.radius[one.rank] + other);
          one.bytes.forEach((b, axis) => {
            out.branch[3 * k + axis] = ((b > 127 ? b - 256 : b) * length) / 127;
          });
        });
        return out;
      });
    });
  }

  /** Times [s] of a table, or a column of it. */
  column(table, column) {
    const name = column === null ? `table${table}-time` : `table${table}-${column}`;
    if (!this.columns.has(name)) this.columns.set(name, column === null ? doubles(name) : singles(name));
    return this.columns.get(name);
  }

  /** The value of a column at the last time up to `t` [s]. */
  at(time, values, t) {
    let [low, high] = [0, time.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (time[middle] <= t + 1e-12) low = middle;
      else high = middle - 1;
    }
    return values[low];
  }

  /** Column of a name in any table, or null. */
  find(name) {
    for (const [t, table] of this.head.tables.entries()) {
      const c = table.columns.findIndex((column) => column[0] === name);
      if (c >= 0) return [t, c];
    }
    return null;
  }
}
