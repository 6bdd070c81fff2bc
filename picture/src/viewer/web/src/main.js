// The page of `sphere-dda view`: puts data, stage, plots and the elements together.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import { Data } from "./data.js";
import { LAYOUT } from "./layout.js";
import { Live } from "./live.js";
import { brief, write } from "./overlay.js";
import { Panel } from "./panel.js";
import { Player, colourings } from "./player.js";
import { Plots } from "./plots.js";
import { PRESETS, Stage } from "./stage.js";
import { watch } from "./watch.js";

const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];
const $ = (id) => document.getElementById(id);
const spoken = (name) => name.replaceAll("_", " ");

document.body.insertAdjacentHTML("afterbegin", LAYOUT);
const hook = { ready: start(), error: null };
window.sphereDda = hook;
hook.ready.catch((error) => {
  hook.error = String(error);
  const text = `This page cannot be shown: ${error.message ?? error}`;
  Object.assign($("notice"), { textContent: text, hidden: false });
  console.error(error);
});

async function start() {
  const data = await Data.open();
  const { head } = data;
  const live = head.live && (await Live.open(data));
  const [first, last] = [head.times[0], head.times[head.times.length - 1]];
  document.title = head.title || "sphere-dda";
  if (head.notice) Object.assign($("notice"), { textContent: head.notice, hidden: false });
  let stage;
  try {
    stage = new Stage($("canvas"), data);
  } catch (error) {
    throw new Error(`this browser offers no WebGL 2 (${error.message}): switch on hardware acceleration, or use another`);
  }
  let all = colourings(data);
  const initial = head.still ? "material" : "speed";
  const settings = {
    colouring: all.find(({ key }) => key === initial) ?? all[0],
    range: null,
    forces: false,
    wall: null,
    wallTop: 0,
    names: head.still,
    cut: "",
    place: 0.5,
  };
  settings.range = { low: settings.colouring.low, high: settings.colouring.high };
  const player = new Player(data, stage, settings);
  const overlay = $("overlay").getContext("2d");
  const stats = { firstPicture: null, frames: 0, slowest: 0, spent: 0 };
  let picked = null;
  let size = [1, 1, 1];

  // --- drawing ---

  function resize() {
    const { clientWidth: width, clientHeight: height } = $("picture");
    size = [Math.max(width, 1), Math.max(height, 1), devicePixelRatio];
    stage.resize(...size);
    $("overlay").width = size[0] * size[2];
    $("overlay").height = size[1] * size[2];
  }

  function legends() {
    const { colouring, range } = settings;
    const scales = [];
    if (head.spheres && stage.spheres.mesh.visible && !settings.forces && !(live && range.high <= range.low)) {
      const title = colouring.unit ? `${colouring.label} [${colouring.unit}]` : colouring.label;
      scales.push(colouring.kinds ? { names: colouring.kinds } : { title, ...range, capped: colouring.capped });
    }
    if (settings.wall !== null) {
      const { name, unit } = head.walls[settings.wall];
      scales.push({ title: `${spoken(name)} [${unit}]`, low: 0, high: settings.wallTop, heat: true, capped: true });
    }
    if (settings.forces && head.forces.largest) scales.push({ title: "normal force [N]", low: 0, high: head.forces.top, heat: true, capped: true, root: true, note: `largest ${brief(head.forces.largest)}` });
    return scales;
  }

  function labels() {
    if (!settings.names) return [];
    const boundary = new Map(head.boundaries.map((one, k) => [one.index, k]));
    const moved = (k) => stage.boundaries[k].position.toArray().map((x, axis) => x + stage.origin[axis]);
    const list = head.boundaries.map((one, k) => ({ text: one.name, kind: "boundary", at: stage.project(moved(k)) }));
    for (const one of head.labels) {
      const own = boundary.get(one.boundary);
      list.push({ text: one.text, kind: one.kind, at: stage.project(own === undefined ? one.at : moved(own)) });
    }
    return list;
  }

  function mark() {
    if (picked?.sphere === undefined || !player.present[picked.sphere]) return null;
    const centre = [0, 1, 2].map((axis) => player.centres[3 * picked.sphere + axis]);
    const at = stage.project(centre);
    const distance = stage.camera.position.distanceTo(stage.local(centre));
    const tall = 2 * Math.tan((stage.camera.fov * Math.PI) / 360) * distance;
    return at && { at, radius: Math.max((1.15 * data.radius[picked.sphere]) / tall, 0.008) };
  }

  function draw(ctx = overlay, [width, height, ratio] = size) {
    const began = performance.now();
    stage.render();
    ctx.clearRect(0, 0, ctx.canvas.width, ctx.canvas.height);
    if (ctx !== overlay) ctx.drawImage($("canvas"), 0, 0);
    const clock = head.still ? "before the run" : `t = ${player.time.toFixed(digits)} s`;
    const thinned = head.thinned > 1 && ctx === overlay ? `, one frame in ${head.thinned}` : "";
    const shown = { title: head.title, clock: clock + thinned, scales: legends(), labels: labels(), mark: mark() };
    write(ctx, width, height, ratio, shown);
    stats.frames++;
    stats.firstPicture ??= performance.now();
    const spent = performance.now() - began;
    stats.spent += spent;
    stats.slowest = Math.max(stats.slowest, spent);
  }

  const interval = live ? 10 * head.live.step : (last - first) / Math.max(head.times.length - 1, 1) || 1;
  const digits = Math.max(0, Math.min(7, 1 - Math.floor(Math.log10(interval) + 1e-9)));
  let waiting = false;
  function redraw() {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      draw();
    });
  }

  async function setTime(time) {
    const done = await player.show(Number(time));
    if (!done) return false;
    draw();
    $("slider").value = player.time;
    const end = live ? "" : ` of ${last.toFixed(digits)}`;
    $("time").textContent = `${player.time.toFixed(digits)}${end} s`;
    if (!live) plots.now = player.time;
    await tell();
    return true;
  }
  const again = () => setTime(live ? head.times[0] : player.time);

  // --- what was picked ---

  async function about() {
    if (!picked) return null;
    const number = (v, unit) => `${brief(v)}${unit ? ` ${unit}` : ""}`;
    const list = (v, unit) => `${number(Math.hypot(...v), unit)}  (${v.map(brief).join(", ")})`;
    if (picked.sphere !== undefined) {
      const s = picked.sphere;
      if (!player.present[s]) return null;
      const out = { kind: "sphere", name: `sphere ${data.id[s]}`, id: data.id[s], values: {} };
      out.values.radius = number(data.radius[s], "m");
      out.values.material = head.materials[data.material[s]] ?? String(data.material[s]);
      out.values.centre = `(${[0, 1, 2].map((axis) => brief(player.centres[3 * s + axis])).join(", ")}) m`;
      for (const [k, { name, unit, components }] of head.fields.entries()) {
        const values = await player.values(k, player.place);
        const own = Array.from(values.subarray(s * components, (s + 1) * components));
        out.values[name] = components > 1 ? list(own, unit) : number(own[0], unit);
      }
      return out;
    }
    const b = picked.boundary;
    const { name } = head.boundaries[b];
    const at = 3 * (player.place.frame * head.boundaries.length + b);
    const out = { kind: "boundary", name, values: { force: list(Array.from(data.force.subarray(at, at + 3)), "N") } };
    if (head.boundaries[b].felt && picked.triangle !== undefined) {
      for (const [k, { name: what, unit }] of head.walls.entries()) {
        const values = await player.wall(k, player.place.frame);
        out.values[`${spoken(what)} here`] = number(values[data.firstFelt[b] + picked.triangle], unit);
      }
    }
    for (const [what, unit] of [["torque", "N m"], ["averageForce", "N"], ["averageTorque", "N m"]]) {
      const columns = [1, 2, 3].map((k) => data.find(`boundary.${name}.${what}[${k}]`));
      if (columns.includes(null)) continue;
      const values = columns.map(async ([t, c]) => data.at(await data.column(t, null), await data.column(t, c), player.time));
      out.values[what] = list(await Promise.all(values), unit);
    }
    return out;
  }

  async function tell() {
    const text = await about();
    $("told").hidden = !text;
    if (!text) return;
    const rows = Object.entries(text.values).map(([name, value]) => {
      const row = document.createElement("tr");
      row.append(...[name, value].map((cell) => Object.assign(document.createElement("td"), { textContent: cell })));
      return row;
    });
    const table = document.createElement("table");
    table.append(...rows);
    $("told").replaceChildren(Object.assign(document.createElement("h2"), { textContent: text.name }), table);
  }

  async function pick(x, y) {
    picked = stage.pick(x, y);
    await tell();
    draw();
    return about();
  }

  /** Looks at the spheres, from where it looks now. */
  function closeUp() {
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (let s = 0; s < player.present.length; s++) {
      for (let axis = 0; player.present[s] && axis < 3; axis++) {
        low[axis] = Math.min(low[axis], player.centres[3 * s + axis] - data.radius[s]);
        high[axis] = Math.max(high[axis], player.centres[3 * s + axis] + data.radius[s]);
      }
    }
    const from = stage.viewpoint;
    if (low[0] < high[0]) stage.fit([0, 1, 2].map((k) => from[k] - from[k + 3]), low, high);
  }

  // --- settings ---

  const setters = {
    colour: (key) => {
      const found = all.find((one) => one.key === key);
      if (!found) throw new Error(`no colouring "${key}", expected one of ${all.map((one) => one.key).join(", ")}`);
      settings.colouring = found;
      settings.range = { low: found.low, high: found.high };
      $("colour").value = key;
      $("range").hidden = Boolean(found.kinds);
      [$("low").value, $("high").value] = [brief(found.low), brief(found.high)];
    },
    low: (value) => (settings.range.low = Number(value)),
    high: (value) => (settings.range.high = Number(value)),
    spheres: (on) => (stage.spheres.mesh.visible = $("spheres").checked = on),
    forces: (on) => {
      settings.forces = $("forces").checked = on;
      stage.spheres.material.uniforms.pale.value = on ? 0.72 : 0;
    },
    width: (power) => (stage.forces.material.uniforms.factor.value = 10 ** ($("width").value = power)),
    wall: (name) => {
      const k = head.walls.findIndex((one) => one.name === name);
      if (name && k < 0) throw new Error(`no quantity "${name}" of boundaries, expected one of ${head.walls.map((one) => one.name).join(", ")}`);
      settings.wall = name ? k : null;
      settings.wallTop = name ? head.walls[k].top : 0;
      $("wall").value = name;
    },
    opacity: (value) => (stage.opacity = $("opacity").value = Number(value)),
    names: (on) => (settings.names = stage.outlines.visible = $("names").checked = on),
    cut: (axis) => (settings.cut = $("cut").value = axis),
    place: (share) => (settings.place = $("place").value = Number(share)),
    view: (name) => (name === "spheres" ? closeUp() : stage.preset(name)),
    viewpoint: (numbers) => (stage.viewpoint = numbers),
  };
  async function set(wanted) {
    for (const [name, value] of Object.entries(wanted)) {
      if (!setters[name]) throw new Error(`no setting "${name}", expected one of ${Object.keys(setters).join(", ")}`);
      setters[name](value);
    }
    const axis = "xyz".indexOf(settings.cut.slice(-1));
    const sign = settings.cut.startsWith("-") ? -1 : 1;
    stage.clip(settings.cut ? [0, 1, 2].map((k) => (k === axis ? sign : 0)) : null, settings.place);
    await again();
  }

  function picture(width, height, type = "image/png") {
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    const before = size;
    // Written as large as in a window of 960 units.
    const ratio = Math.max(height / 720, 0.5);
    stage.resize(width / ratio, height / ratio, ratio);
    draw(canvas.getContext("2d"), [width / ratio, height / ratio, ratio]);
    stage.resize(...before);
    draw();
    return canvas.toDataURL(type, 0.92);
  }

  // --- elements ---

  for (const { key, label, unit } of all) $("colour").add(new Option(unit ? `${label} [${unit}]` : label, key));
  for (const { name, unit } of head.walls) $("wall").add(new Option(`${spoken(name)} [${unit}]`, name));
  $("felt").hidden = !head.walls.length;
  for (const name of [...Object.keys(PRESETS), "spheres"]) {
    const button = Object.assign(document.createElement("button"), { textContent: name });
    button.addEventListener("click", () => set({ view: name }));
    $("presets").append(button);
  }
  const own = live ? 1 : (SPEEDS.find((one) => (last - first) / one <= 12) ?? 1);
  for (const one of SPEEDS) $("speed").add(new Option(`${one} ×`, one, one === own, one === own));
  Object.assign($("slider"), { min: first, max: last, value: first });
  $("slider").addEventListener("input", () => setTime($("slider").value));
  for (const id of ["colour", "cut", "wall"]) $(id).addEventListener("change", () => set({ [id]: $(id).value }));
  for (const id of ["low", "high", "width", "opacity", "place"]) {
    $(id).addEventListener("input", () => set({ [id]: Number($(id).value) }));
  }
  for (const id of ["spheres", "forces", "names"]) $(id).addEventListener("change", () => set({ [id]: $(id).checked }));
  $("auto").addEventListener("click", () => set({ colour: settings.colouring.key }));
  const save = (name, href) => Object.assign(document.createElement("a"), { download: name, href }).click();
  $("save").addEventListener("click", () => {
    const name = `${(head.title || "picture").replace(/\W+/g, "-")}.png`;
    save(name, picture(...size.slice(0, 2).map((n) => Math.round(n * size[2]))));
  });

  let playing = false;
  function play(on = !(live ?? { playing }).playing) {
    if (live) {
      on ? live.play() : live.stop();
      $("play").textContent = on ? "pause" : "play";
      return;
    }
    playing = on && last > first;
    $("play").textContent = playing ? "pause" : "play";
    if (!playing) return;
    if (player.time >= last) player.time = first;
    let before = performance.now();
    const step = async (now) => {
      if (!playing) return;
      const next = player.time + (Math.max(now - before, 0) / 1000) * Number($("speed").value);
      before = now;
      await setTime(next);
      if (next >= last) play(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
  const hop = (by) => {
    if (live) return by > 0 ? live.step() : null;
    const { frame, share } = player.place;
    const goal = by < 0 && share > 0 ? frame : frame + by;
    return setTime(head.times[Math.min(Math.max(goal, 0), head.times.length - 1)]);
  };
  $("play").addEventListener("click", () => play());
  $("back").addEventListener("click", () => hop(-1));
  $("on").addEventListener("click", () => hop(1));
  document.addEventListener("keydown", (event) => {
    if (/^(INPUT|SELECT|BUTTON)$/.test(event.target.tagName) && event.target.type !== "range") return;
    if (event.key === " ") play();
    else if (event.key === "ArrowLeft") hop(-1);
    else if (event.key === "ArrowRight") hop(1);
    else return;
    event.preventDefault();
  });
  let pressed = null;
  $("canvas").addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
  $("canvas").addEventListener("pointerup", (event) => {
    if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const box = $("canvas").getBoundingClientRect();
    pick((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
  });
  stage.controls.addEventListener("change", redraw);
  $("forces").disabled = head.forces.largest === 0 && !live;
  document.querySelector("footer").hidden = head.times.length < 2 && !live;

  /** Elements and colours of a page in which the solver runs. */
  function enliven() {
    for (const id of ["live", "reset"]) $(id).hidden = false;
    for (const id of ["back", "slider"]) $(id).hidden = true;
    $("on").title = "arrow right: one step";
    $("live").after($("history"));
    const panel = new Panel($("live"), live, head.generator, (name, text) => save(name, URL.createObjectURL(new Blob([text]))));
    $("reset").addEventListener("click", () => live.reset());
    $("speed").addEventListener("change", () => (live.speed = Number($("speed").value)));
    const follow = () => {
      const { colouring, range } = settings;
      const own = range.high === colouring.high && range.low === colouring.low;
      all = colourings(data);
      settings.colouring = all.find(({ key }) => key === colouring.key);
      if (own) setters.colour(colouring.key);
    };
    live.page = {
      contacts: () => settings.forces,
      tell: (text) => Object.assign($("notice"), { textContent: text, hidden: !text }),
      show: async () => {
        const began = performance.now();
        if (live.frame.time === 0) panel.warn("");
        if (live.frame.warnings.length) panel.warn(live.frame.warnings.at(-1));
        if (head.fields.some(({ top }, k) => all.find(({ field }) => field === k).high !== top)) follow();
        await again();
        return performance.now() - began;
      },
      look: () => {
        panel.show();
        plots.grow(player.time);
        $("play").textContent = live.playing ? "pause" : "play";
        $("pace").textContent = panel.pace;
      },
    };
    hook.live = {
      controls: live.controls,
      set: (name, value) => panel.set(live.controls.findIndex((one) => one.name === name), value),
      step: (count) => live.step(count),
      play: () => play(true),
      stop: () => live.stop(),
      reset: () => live.reset(),
      drive: () => live.drive(),
      /** Time [s], centres [m] of all rows, values of the inputs and outputs as the solver has them. */
      frame: () => {
        const { time, position, present, values, outputs } = live.frame;
        const names = head.tables[0].columns.map(([name]) => name);
        return { time, position: Array.from(position ?? []), present: Array.from(present), values, outputs: Object.fromEntries(names.map((name, k) => [name, outputs[k]])) };
      },
      pace: () => ({ ...live.pace }),
    };
  }

  // --- beginning ---

  const plots = new Plots($("history"), data, (time) => setTime(time));
  if (live) enliven();
  resize();
  stage.preset("oblique");
  new ResizeObserver(() => {
    resize();
    redraw();
  }).observe($("picture"));
  const kept = watch(head.watched, () => ({
    viewpoint: stage.viewpoint,
    colour: settings.colouring.key,
    names: settings.names,
    cut: settings.cut,
    place: settings.place,
    wall: $("wall").value,
    opacity: Number($("opacity").value),
  }));
  await set({ colour: settings.colouring.key, names: settings.names, ...kept });
  await plots.start();
  plots.now = player.time;

  Object.defineProperty(hook, "time", { get: () => player.time });
  Object.assign(hook, {
    head,
    setTime,
    set,
    pick,
    picture,
    play,
    /** Ids and centres [m] of the spheres that are shown. */
    positions: () => {
      const ranks = Array.from(data.id.keys()).filter((s) => player.present[s]);
      return { id: ranks.map((s) => data.id[s]), centre: ranks.map((s) => Array.from(player.centres.subarray(3 * s, 3 * s + 3))) };
    },
    /** What is told of the sphere with an id. */
    describe: (id) => {
      picked = { sphere: data.id.indexOf(id) };
      return about();
    },
    /** Where a point [m] is on the picture, in shares of its width and height. */
    project: (point) => stage.project(point),
    /** Poses [m, quaternion] of the boundaries at the present frame, by name. */
    boundaries: () =>
      Object.fromEntries(stage.boundaries.map((g, k) => [head.boundaries[k].name, [...g.position.toArray().map((x, a) => x + stage.origin[a]), ...g.quaternion.toArray()]])),
    plots: () => plots.names,
    add: (name) => plots.add(name),
    /** What triangle `t` of the boundary `name` feels at the present frame, by quantity. */
    felt: async (name, t) => {
      const b = head.boundaries.findIndex((one) => one.name === name);
      const all = await Promise.all(head.walls.map((_, k) => player.wall(k, player.place.frame)));
      return Object.fromEntries(all.map((values, k) => [head.walls[k].name, values[data.firstFelt[b] + t]]));
    },
    lines: () => (stage.forces.mesh.visible ? stage.forces.lines : 0),
    stats: () => ({ ...stats, mean: stats.spent / Math.max(stats.frames, 1), held: data.held, heap: performance.memory?.usedJSHeapSize ?? null }),
  });
}
