// The elements of a page in which the solver runs: sliders, what it runs, how fast.

import { brief } from "./overlay.js";

const make = (tag, own, ...inside) => {
  const element = Object.assign(document.createElement(tag), own);
  element.append(...inside);
  return element;
};

export class Panel {
  constructor(place, live, generator, save) {
    this.live = live;
    const text = `The solver of ${generator} runs in this page.`;
    place.append(make("p", { textContent: text }));
    this.sliders = live.controls.map((one, k) => {
      const { name, unit, low, high, start, text } = one;
      const range = make("input", { type: "range", min: low, max: high, step: "any", value: start });
      const number = make("input", { type: "number", step: "any", value: brief(start) });
      range.addEventListener("input", () => this.set(k, Number(range.value)));
      number.addEventListener("change", () => this.set(k, Number(number.value)));
      const title = unit ? `${name.replace(/^boundary\./, "")} [${unit}]` : name;
      const caption = make("span", { textContent: title, title: `${name}: ${text}` });
      place.append(make("div", { className: "control" }, caption, make("div", { className: "row" }, range, number)));
      return { range, number };
    });
    if (!live.controls.length) {
      place.append(make("p", { textContent: "This scene has no inputs: give a boundary `input = ...`." }));
    }
    this.warned = make("p", { className: "warned" });
    const button = make("button", { textContent: "save inputs", title: "a table for `sphere-dda simulate X.fmu --input`" });
    button.addEventListener("click", async () => save("inputs.csv", await live.drive()));
    if (live.controls.some(({ input }) => input)) place.append(button);
    place.append(this.warned);
  }

  /** Where input `k` is to go. */
  set(k, value) {
    if (!Number.isFinite(value)) return;
    this.live.goals[k] = value;
    this.show();
  }

  /** Sliders and numbers stand where their inputs are to go. */
  show() {
    this.sliders.forEach(({ range, number }, k) => {
      const goal = this.live.goals[k];
      range.value = goal;
      if (document.activeElement !== number) number.value = brief(goal);
    });
  }

  /** The last warning of the solver stays until it begins anew. */
  warn(text) {
    this.warned.textContent = text;
  }

  /** How fast it runs, in words. */
  get pace() {
    const { solver, draw, whole, factor, frames } = this.live.pace;
    if (!frames) return "";
    const parts = `solver ${solver.toFixed(1)}, picture ${draw.toFixed(1)}`;
    return `${whole.toFixed(0)} ms a frame (${parts}), ${factor.toFixed(2)} of real time`;
  }
}
