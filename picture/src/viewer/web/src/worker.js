// Runs the solver beside the page, so that the page answers while a step takes its time.

import { Fmu } from "./component.js";

let module, about, fmu, count, values, changes;

const elements = (ofName) => about.controls.filter(({ variable }) => variable === ofName);

/** A new instance at the start of the scene. */
function begin() {
  fmu = new Fmu(module, about.title || "live", about.token);
  fmu.start();
  count = 0;
  values = about.controls.map(({ start }) => start);
  changes = [];
}

/** Sets the inputs that are not yet where they are wanted; those with a `rate` [1/s] go there no faster. */
function steer(goals) {
  const moved = new Set();
  about.controls.forEach(({ variable, rate }, k) => {
    const way = goals[k] - values[k];
    if (way === 0) return;
    const most = rate === null ? Infinity : rate * about.step;
    values[k] = Math.abs(way) <= most ? goals[k] : values[k] + Math.sign(way) * most;
    moved.add(variable);
  });
  if (!moved.size) return;
  const all = [...moved].map(elements);
  const now = (one) => values[about.controls.indexOf(one)];
  fmu.setFloat64(all.map(([first]) => first.reference), all.flat().map(now));
  changes.push([count * about.step, ...values]);
}

/** What is to be seen now. */
function frame(contacts) {
  const { spheres, boundaries, outputs } = about;
  const own = { time: count * about.step, values, warnings: fmu.warnings.splice(0), present: new Uint8Array() };
  if (spheres) {
    own.present = fmu.getBoolean([spheres.present]);
    for (const name of ["position", "velocity", "angularVelocity"]) own[name] = fmu.getFloat64([spheres[name]]);
    if (contacts) own.contacts = fmu.getBinary(spheres.contacts);
  }
  if (boundaries) {
    for (const name of ["position", "orientation", "force"]) own[`boundary-${name}`] = fmu.getFloat64([boundaries[name]]);
  }
  const some = (whole) => outputs.filter((one) => one.whole === whole).map(({ reference }) => reference);
  own.outputs = [...fmu.getFloat64(some(false)), ...fmu.getInt32(some(true))];
  return own;
}

const tasks = {
  async open(given) {
    about = given.about;
    module = await WebAssembly.compile(given.module);
    begin();
    return { ...frame(false), radius: about.spheres ? fmu.getFloat64([about.spheres.radius]) : new Float64Array() };
  },

  reset({ contacts }) {
    begin();
    return frame(contacts);
  },

  /** Steps until `until` [s], `most` times at most, or until `budget` [ms] is spent. */
  advance({ goals, until, most, budget, contacts }) {
    const began = performance.now();
    let [steps, ends] = [0, false];
    while (!ends && steps < most && (count + 1) * about.step <= until + 1e-9 * about.step) {
      steer(goals);
      ends = fmu.doStep(count * about.step, about.step);
      count++;
      steps++;
      if (performance.now() - began > budget) break;
    }
    const spent = performance.now() - began;
    return { ...frame(contacts), steps, spent, ends };
  },

  changes: () => changes,
};

self.onmessage = async ({ data }) => {
  const answer = { ticket: data.ticket };
  try {
    answer.value = await tasks[data.task](data);
  } catch (error) {
    const trapped = error instanceof WebAssembly.RuntimeError;
    answer.error = trapped ? `the solver ended with a defect (${error.message}); "reset" begins anew` : (error.message ?? String(error));
  }
  self.postMessage(answer);
};
