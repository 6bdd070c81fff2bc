// Plots of the tables beside the picture; their cursor is the time of the picture.

import uPlot from "uplot";
import { brief } from "./overlay.js";

const HEIGHT = 150;
const INK = "#2b6cb0";
/** Columns that say most about a run, first those of its own sensors and boundaries. */
const TELLING = [
  /^sensor\..*\.(rate|mass|solidFraction)$/, /^boundary\..*\.(slideForce|hingeTorque|jointAngle|jointTravel)$/,
  /averageForce\[3\]$/, /^kineticEnergy$/, /^maxOverlap$/, /^contactCount$/,
];

export class Plots {
  /** `jump(t)` is called where a plot is clicked. */
  constructor(place, data, jump) {
    this.data = data;
    this.jump = jump;
    this.time = 0;
    this.plots = [];
    this.list = place.querySelector("#plots");
    const input = place.querySelector("#column");
    const offered = place.querySelector("#columns");
    const { tables } = data.head;
    tables.forEach((table) => {
      for (const [name, unit] of table.columns) {
        const option = document.createElement("option");
        option.value = name;
        option.label = unit ? `${name} [${unit}] ${table.name}` : `${name} ${table.name}`;
        offered.append(option);
      }
    });
    place.hidden = tables.length === 0;
    input.addEventListener("change", () => {
      if (data.find(input.value)) {
        this.add(input.value);
        input.value = "";
      }
    });
    new ResizeObserver(() => this.fit()).observe(this.list);
  }

  /** Plots that tell something about most runs. */
  async start() {
    const names = this.data.head.tables.flatMap((table) => table.columns.map(([name]) => name));
    const chosen = TELLING.map((pattern) => names.find((name) => pattern.test(name))).filter(Boolean);
    for (const name of chosen.slice(0, 3)) await this.add(name);
  }

  get names() {
    return this.plots.map((plot) => plot.name);
  }

  async add(name) {
    const found = this.data.find(name);
    if (!found || this.names.includes(name)) return;
    const [t, c] = found;
    const entry = { name };
    this.plots.push(entry);
    const [time, values] = await Promise.all([this.data.column(t, null), this.data.column(t, c)]);
    const unit = this.data.head.tables[t].columns[c][1];
    const box = document.createElement("figure");
    const title = document.createElement("figcaption");
    const shown = document.createElement("output");
    const close = document.createElement("button");
    title.textContent = unit ? `${name} [${unit}]` : name;
    close.textContent = "×";
    close.title = "remove this plot";
    title.append(shown, close);
    box.append(title);
    this.list.append(box);
    const options = {
      width: Math.max(this.list.clientWidth, 120),
      height: HEIGHT,
      legend: { show: false },
      scales: { x: { time: false } },
      cursor: { drag: { x: true, y: false } },
      axes: [
        { size: 26, font: "11px system-ui", stroke: "#555" },
        { size: 52, font: "11px system-ui", stroke: "#555", values: (_plot, ticks) => ticks.map(brief) },
      ],
      series: [{}, { stroke: INK, width: 1.2, points: { show: false } }],
      hooks: { draw: [(plot) => this.line(plot)] },
    };
    const plot = new uPlot(options, [time, Float64Array.from(values)], box);
    plot.over.addEventListener("click", (event) => {
      this.jump(plot.posToVal(event.offsetX, "x"));
    });
    close.addEventListener("click", () => {
      plot.destroy();
      box.remove();
      this.plots = this.plots.filter((one) => one !== entry);
    });
    Object.assign(entry, { plot, time, values, shown });
    this.tell(entry);
  }

  fit() {
    for (const { plot } of this.plots) plot?.setSize({ width: Math.max(this.list.clientWidth, 120), height: HEIGHT });
  }

  line(plot) {
    const x = plot.valToPos(this.time, "x", true);
    const { left, top, width, height } = plot.bbox;
    if (!(x >= left && x <= left + width)) return;
    plot.ctx.save();
    plot.ctx.strokeStyle = "#d6336c";
    plot.ctx.lineWidth = devicePixelRatio;
    plot.ctx.beginPath();
    plot.ctx.moveTo(x, top);
    plot.ctx.lineTo(x, top + height);
    plot.ctx.stroke();
    plot.ctx.restore();
  }

  /** The value of a plot's column at the present time, beside its name. */
  tell(entry) {
    if (!entry.plot) return;
    entry.shown.textContent = Number(this.data.at(entry.time, entry.values, this.time).toPrecision(4)).toString();
  }

  /** Draws rows that have been added, up to a time. */
  grow(time) {
    this.time = time;
    for (const entry of this.plots) {
      entry.plot?.setData([entry.time, entry.values]);
      this.tell(entry);
    }
  }

  set now(time) {
    this.time = time;
    for (const entry of this.plots) {
      entry.plot?.redraw(false);
      this.tell(entry);
    }
  }
}
