// What is shown at a time: frames, and what lies between them, on the stage.

import { kindPlace } from "./colours.js";

/** What spheres can be coloured by: name, unit, range, and the values at a moment. */
export function colourings(data) {
  const { head } = data;
  const list = [];
  const field = (k, label, pick, low) => {
    const { unit, top } = head.fields[k];
    list.push({ key: label, label, unit, low: low * top, high: top, field: k, pick, capped: true });
  };
  head.fields.forEach(({ name, components, magnitude }, k) => {
    if (magnitude) {
      field(k, name === "velocity" ? "speed" : name, (v, s) => v[s], 0);
      return;
    }
    if (components !== 3) {
      for (let c = 0; c < components; c++) {
        field(k, components > 1 ? `${name}[${c + 1}]` : name, (v, s) => v[s * components + c], -1);
      }
      return;
    }
    const label = name === "velocity" ? "speed" : name;
    field(k, label, (v, s) => Math.hypot(v[3 * s], v[3 * s + 1], v[3 * s + 2]), 0);
  });
  const range = (values) => [values.reduce((a, b) => Math.min(a, b), Infinity), values.reduce((a, b) => Math.max(a, b), -Infinity)];
  const fixed = (label, unit, values) => {
    const [low, high] = values.length ? range(values) : [0, 1];
    list.push({ key: label, label, unit, low, high, values });
  };
  fixed("id", "", data.id);
  fixed("radius", "m", data.radius);
  list.push({ key: "material", label: "material", unit: "", low: 0, high: 1, values: data.material, kinds: head.materials });
  list.push({ key: "height", label: "height z", unit: "m", low: head.height[0], high: head.height[1], height: true });
  head.fields.forEach(({ name, components }, k) => {
    if (components === 3) ["x", "y", "z"].forEach((axis, c) => field(k, `${name} ${axis}`, (v, s) => v[3 * s + c], -1));
  });
  return list;
}

export class Player {
  constructor(data, stage, settings) {
    Object.assign(this, { data, stage, settings });
    this.time = data.head.times[0];
    this.asked = 0;
    this.centres = new Float64Array(3 * data.head.spheres);
    this.present = new Uint8Array(data.head.spheres);
    this.shades = new Float32Array(data.head.spheres);
  }

  /** Frame at or before a time, and how far the time is on the way to the next. */
  find(time) {
    const { times } = this.data.head;
    let [low, high] = [0, times.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time) low = middle;
      else high = middle - 1;
    }
    const next = Math.min(low + 1, times.length - 1);
    const share = next > low ? Math.max((time - times[low]) / (times[next] - times[low]), 0) : 0;
    return { frame: low, next, share };
  }

  async moment(frame) {
    const block = this.data.blockOf(frame);
    return (await this.data.movement(block))[frame - block * this.data.head.framesPerBlock];
  }

  /** Values of field `k` at a frame, or between it and the next. */
  async values(k, { frame, next, share }) {
    const { framesPerBlock } = this.data.head;
    const of = async (f) => {
      const block = this.data.blockOf(f);
      return (await this.data.field(k, block))[f - block * framesPerBlock];
    };
    const a = await of(frame);
    if (share === 0) return a;
    const b = await of(next);
    return a.map((v, i) => v + share * (b[i] - v));
  }

  async contacts(frame) {
    const block = this.data.blockOf(frame);
    return (await this.data.contacts(block))[frame - block * this.data.head.framesPerBlock];
  }

  /** What triangles feel at a frame, quantity `k`. */
  async wall(k, frame) {
    const block = this.data.blockOf(frame);
    return (await this.data.wall(k, block))[frame - block * this.data.head.framesPerBlock];
  }

  /** Puts a time [s] on the stage. Answers whether it was drawn: a later call makes an earlier one void. */
  async show(time) {
    const { times } = this.data.head;
    const ticket = ++this.asked;
    const goal = Math.min(Math.max(time, times[0]), times[times.length - 1]);
    const place = this.find(goal);
    const { settings, data, stage } = this;
    const colouring = settings.colouring;
    const [a, b, values, contacts, felt] = await Promise.all([
      this.moment(place.frame),
      place.share > 0 ? this.moment(place.next) : null,
      colouring.field === undefined ? null : this.values(colouring.field, place),
      settings.forces ? this.contacts(place.frame) : null,
      settings.wall === null ? null : this.wall(settings.wall, place.frame),
    ]);
    if (ticket !== this.asked) return false;
    this.time = goal;
    this.place = place;
    this.centres.set(a.centres);
    this.present.set(a.present);
    if (b) {
      for (let s = 0; s < this.present.length; s++) {
        if (!a.present[s] || !b.present[s] || b.jumps?.[s]) continue;
        for (let i = 3 * s; i < 3 * s + 3; i++) this.centres[i] += place.share * (b.centres[i] - a.centres[i]);
      }
    }
    stage.spheres.place(this.centres, this.present, data.radius, stage.origin);
    this.shade(colouring, values);
    stage.moveBoundaries(place.frame, place.next, place.share);
    stage.paint(felt, settings.wallTop, data.firstFelt);
    stage.forces.mesh.visible = Boolean(contacts);
    if (contacts) {
      const radius = data.radius.length ? [...data.radius].sort((x, y) => x - y)[data.radius.length >> 1] : 1;
      stage.forces.place(contacts, this.centres, this.present, stage.origin, data.head.forces.top || 1, 0.7 * radius);
    }
    this.fetchAhead(place.frame);
    return true;
  }

  shade(colouring, values) {
    const { low, high } = this.settings.range;
    const span = high - low || 1;
    const { shades, centres } = this;
    for (let s = 0; s < shades.length; s++) {
      const value = values
        ? colouring.pick(values, s)
        : colouring.height
          ? centres[3 * s + 2]
          : colouring.values[s];
      shades[s] = colouring.kinds ? kindPlace(value) : Math.min(Math.max((value - low) / span, 0), 1);
    }
    this.stage.spheres.shade(shades);
    this.stage.spheres.material.uniforms.colours.value = colouring.kinds ? this.stage.kinds : this.stage.amount;
  }

  /** Unpacks the next block before it is needed. */
  fetchAhead(frame) {
    const next = this.data.blockOf(frame) + 1;
    if (next * this.data.head.framesPerBlock >= this.data.head.times.length) return;
    const { colouring, forces, wall } = this.settings;
    const wanted = [this.data.movement(next)];
    if (colouring.field !== undefined) wanted.push(this.data.field(colouring.field, next));
    if (forces) wanted.push(this.data.contacts(next));
    if (wall !== null) wanted.push(this.data.wall(wall, next));
    // What is wrong with a block is told when it is shown.
    for (const one of wanted) one.catch(() => {});
  }
}
