// A page in which the solver runs: it takes the place of the page's frames, its inputs follow sliders.

import * as THREE from "three";
import { element, part } from "./data.js";

/** Rows that plots keep. */
const ROWS = 3000;
/** Time [ms] that steps may take before the picture is drawn anew: as long as drawing takes, between these. */
const BUDGET = [30, 250];
/** Time [ms] between two looks of the plots. */
const LOOK = 120;
/** Share of the spheres whose speed lies within the colours. */
const MOST = 0.98;
const HEADER = 28;
const RECORD = 120;

/** The next of 1, 2, 5, 10 ... */
function rounded(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((one) => value <= one * power * (1 + 1e-9));
}

/** Ends of a slider, and how fast [1/s] its input follows: a boundary that is dragged does not jump. */
function ends({ unit, start, min, max, input }, head) {
  const size = Math.hypot(...head.extent[0].map((low, axis) => head.extent[1][axis] - low));
  const gravity = 9.81;
  const weight = rounded(Math.max(head.live.mass * gravity, 1e-9));
  const reach = {
    m: rounded(size / 4), rad: Math.PI, "m/s": rounded(size), "rad/s": 10, "m/s2": 1.5 * gravity,
    N: 10 * weight, "N.m": weight * rounded(size), Pa: rounded((4 * weight) / size ** 2),
  }[unit] ?? 1;
  const [low, high] = [min ?? Math.min(-reach, start), max ?? Math.max(reach, start)];
  return { low, high, rate: input && ["m", "rad"].includes(unit) ? (high - low) / 2 : null };
}

export class Live {
  /** Starts the solver and puts its first frame in the place of the page's own. */
  static async open(data) {
    const live = new Live();
    const { head } = data;
    live.data = data;
    live.about = head.live;
    live.controls = head.live.controls.map((one) => ({ ...one, ...ends(one, head) }));
    live.goals = live.controls.map(({ start }) => start);
    live.tickets = new Map();
    live.asked = 0;
    live.playing = false;
    live.running = null;
    live.speed = 1;
    live.pace = { frames: 0 };
    const code = element("worker").textContent;
    live.worker = new Worker(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
    live.worker.onmessage = ({ data: { ticket, value, error } }) => {
      const { resolve, reject } = live.tickets.get(ticket);
      live.tickets.delete(ticket);
      if (error === undefined) resolve(value);
      else reject(new Error(error));
    };
    const about = { ...live.about, title: head.title, controls: live.controls };
    const first = await live.ask({ task: "open", module: await part("module"), about });
    const count = first.present.length;
    Object.assign(head, { still: false, spheres: count, framesPerBlock: 1, walls: [] });
    head.fields = [["velocity", "m/s"], ["angularVelocity", "rad/s"]].map(([name, unit]) => ({ name, unit, components: 3, top: 0 }));
    data.id = Float64Array.from({ length: count }, (_, k) => k);
    data.radius = first.radius;
    data.material = Float64Array.from(live.about.materials);
    live.rows = [[], ...head.tables[0].columns.map(() => [])];
    live.rows.forEach((row, k) => data.columns.set(k ? `table0-${k - 1}` : "table0-time", Promise.resolve(row)));
    const at = first["boundary-position"];
    const turned = first["boundary-orientation"];
    live.placed = head.boundaries.map(({ index }) => ({ at: at.slice(3 * index, 3 * index + 3), back: live.turn(turned, index).invert() }));
    live.take(first);
    return live;
  }

  ask(task) {
    return new Promise((resolve, reject) => {
      const ticket = this.asked++;
      this.tickets.set(ticket, { resolve, reject });
      this.worker.postMessage({ ...task, ticket });
    });
  }

  turn(all, index) {
    const [w, x, y, z] = all.subarray(4 * index, 4 * index + 4);
    return new THREE.Quaternion(x, y, z, w);
  }

  /** Puts a frame in the place of the page's one. */
  take(frame) {
    const { data } = this;
    const { head } = data;
    this.frame = frame;
    head.times[0] = frame.time;
    const put = (name, value) => data.blocks.set(name, { size: 0, value: Promise.resolve([value]) });
    put("motion-0", { present: frame.present, jumps: null, centres: frame.position ?? new Float64Array() });
    put("field0-0", frame.velocity ?? new Float64Array());
    put("field1-0", frame.angularVelocity ?? new Float64Array());
    const contacts = this.contacts(frame);
    put("contacts-0", contacts);
    const [at, force] = [frame["boundary-position"], frame["boundary-force"]];
    head.boundaries.forEach(({ index, centre }, k) => {
      // x = p + Q (x_0 - p_0): the body's own centre moves by the same law.
      const turn = this.turn(frame["boundary-orientation"], index).multiply(this.placed[k].back);
      const arm = new THREE.Vector3(...centre.map((c, axis) => c - this.placed[k].at[axis])).applyQuaternion(turn).toArray();
      const shift = arm.map((a, axis) => at[3 * index + axis] + a - centre[axis]);
      data.motion.set([...shift, turn.w, turn.x, turn.y, turn.z], 7 * k);
      data.force.set(force.subarray(3 * index, 3 * index + 3), 3 * k);
    });
    [frame.time, ...frame.outputs].forEach((value, k) => this.rows[k].push(value));
    if (this.rows[0].length > ROWS) for (const row of this.rows) row.splice(0, row.length - ROWS);
    this.widen(frame, contacts);
  }

  /** Colours and lines of forces reach as far as most values have so far. */
  widen(frame, contacts) {
    const { fields, forces } = this.data.head;
    const most = (sizes) => sizes.sort((a, b) => a - b)[Math.floor(MOST * (sizes.length - 1))] ?? 0;
    [frame.velocity, frame.angularVelocity].forEach((values, k) => {
      const rows = frame.present.length && values ? frame.present.length : 0;
      const size = (s) => (frame.present[s] ? Math.hypot(values[3 * s], values[3 * s + 1], values[3 * s + 2]) : 0);
      const top = most(Float64Array.from({ length: rows }, (_, s) => size(s)));
      if (top > fields[k].top) fields[k].top = rounded(top);
    });
    const strongest = contacts.force.reduce((a, force) => Math.max(a, force), 0);
    forces.largest = Math.max(forces.largest, strongest);
    const pressing = most(contacts.force.filter((force) => force > 0));
    if (pressing > forces.top) forces.top = rounded(pressing);
  }

  /** What `contacts.document` says, as the page has it. */
  contacts({ contacts, position }) {
    if (!contacts) return { count: 0, force: new Float32Array() };
    const view = new DataView(contacts.buffer);
    const count = Number(view.getBigUint64(12, true));
    const own = {
      count, rank: new Int32Array(count), partner: new Int32Array(count), form: new Uint8Array(count),
      force: new Float32Array(count), branch: new Float32Array(3 * count),
    };
    for (let k = 0; k < count; k++) {
      const at = HEADER + RECORD * k;
      const [a, b] = [0, 8].map((more) => Number(view.getBigInt64(at + more, true)));
      const number = (rank) => view.getFloat64(at + 16 + 8 * rank, true);
      const radius = b < 0 ? 0 : this.data.radius[a] + this.data.radius[b];
      const apart = b < 0 ? 0 : Math.hypot(...[0, 1, 2].map((axis) => position[3 * b + axis] - position[3 * a + axis]));
      own.rank[k] = a;
      own.partner[k] = b < 0 ? -1 - b : b;
      own.form[k] = b < 0 ? 1 : apart > 1.5 * radius ? 2 : 0;
      for (let axis = 0; axis < 3; axis++) {
        own.force[k] += number(6 + axis) * number(3 + axis);
        own.branch[3 * k + axis] = b < 0 ? number(axis) - position[3 * a + axis] : -radius * number(3 + axis);
      }
    }
    return own;
  }

  /** Goes on until `until` [s], or by `most` steps, or as long as `budget` [ms] lasts. */
  advance({ until = Infinity, most = Infinity, budget = Infinity }) {
    return this.ask({ task: "advance", goals: [...this.goals], until, most, budget, contacts: this.page.contacts() });
  }

  step(steps = 1) {
    return this.guarded(async () => {
      this.take(await this.advance({ most: steps }));
      await this.page.show();
    });
  }

  /** A new start; what is wrong with the solver goes with it. */
  reset() {
    return this.guarded(async () => {
      const frame = await this.ask({ task: "reset", contacts: this.page.contacts() });
      this.goals = this.controls.map(({ start }) => start);
      for (const row of this.rows) row.length = 0;
      this.take(frame);
      this.page.tell("");
      await this.page.show();
    });
  }

  /** Steps with the clock, or as fast as the solver can, until `stop`. */
  play() {
    const begun = this.guarded(() => this.run());
    this.playing = true;
    return begun;
  }

  stop() {
    this.playing = false;
    return this.running;
  }

  async run() {
    const { pace, page, about } = this;
    Object.assign(pace, { solver: 0, draw: 0, whole: 0, factor: 0, steps: 0, frames: 0 });
    let [last, looked, goal] = [performance.now(), 0, this.frame.time];
    let budget = BUDGET[0];
    let coming = this.advance({ until: goal, budget });
    while (coming) {
      const before = this.frame.time;
      const frame = await coming;
      const now = performance.now();
      const passed = (now - last) * 1e-3;
      // What the solver could not do in time is let go.
      goal = Math.min(goal + passed * this.speed, frame.time + Math.max(0.1 * this.speed, 2 * about.step));
      if (frame.ends) this.playing = false;
      // The solver goes on while this frame is drawn.
      coming = this.playing ? this.advance({ until: goal, budget }) : null;
      this.take(frame);
      const drawn = await page.show();
      const share = 1 / Math.min(++pace.frames, 30);
      const factor = (frame.time - before) / Math.max(passed, 1e-6);
      const own = { solver: frame.spent, draw: drawn, whole: 1e3 * passed, steps: frame.steps, factor };
      for (const [name, value] of Object.entries(own)) pace[name] += share * (value - pace[name]);
      last = now;
      if (now - looked > LOOK) {
        looked = now;
        page.look();
      }
      if (coming) await new Promise(requestAnimationFrame);
      budget = Math.min(Math.max(performance.now() - now, BUDGET[0]), BUDGET[1]);
    }
  }

  /** Does a task when the one before is done, and tells what is wrong in the words of the component. */
  guarded(task) {
    const before = this.stop();
    this.running = (async () => {
      await before;
      try {
        await task();
      } catch (error) {
        this.playing = false;
        this.page.tell(`The solver has stopped. It says: ${error.message}`);
      }
      this.page.look();
    })();
    return this.running;
  }

  /** The inputs as they were set, a table that `sphere-dda simulate --input` drives the FMU by. */
  async drive() {
    const { step } = this.about;
    const kept = this.controls.flatMap(({ input }, k) => (input ? [k] : []));
    const start = this.controls.map((one) => one.start);
    const rows = [[0, ...start]];
    for (const row of await this.ask({ task: "changes" })) {
      // Values are held up to the step before: rows between are interpolated.
      const number = Math.round(row[0] / step) - 1;
      const held = rows[rows.length - 1];
      if (number > Math.round(held[0] / step)) rows.push([number * step, ...held.slice(1)]);
      if (row[0] === held[0]) rows.pop();
      rows.push(row);
    }
    const lines = rows.map(([time, ...values]) => [time, ...kept.map((k) => values[k])].join(","));
    return `${["time", ...kept.map((k) => this.controls[k].name)].join(",")}\n${lines.join("\n")}\n`;
  }
}
