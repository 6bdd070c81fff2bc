// What is written over the picture: title, time, legends, names, the mark of what was picked.

import { amount, css, heat, kind } from "./colours.js";

const INK = "#2b333b";
const LABELS = { boundary: "#3f5d7d", input: "#1f4fa3", sensor: "#7a3fa0", source: "#1f7a48", sink: "#9c4420", probe: "#333" };

/** A number in few characters. */
export function brief(value) {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  return size >= 1e4 || size < 1e-3 ? value.toExponential(1).replace("e+", "e") : String(Number(value.toPrecision(3)));
}

/** Ends of about `count` equal steps of 1, 2 or 5 in a range. */
function ticks(low, high, count) {
  const raw = (high - low) / count;
  if (!(raw > 0)) return [low];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw);
  const out = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) out.push(k * step);
  return out;
}

/** A scale; with `root` its colours go by the root of the amount. */
function bar(ctx, x, y, { title, low, high, colour, capped, note, root }) {
  const [wide, tall] = [14, 150];
  const gradient = ctx.createLinearGradient(0, y + tall, 0, y);
  for (let k = 0; k <= 10; k++) gradient.addColorStop(k / 10, css(colour(k / 10)));
  ctx.fillStyle = INK;
  ctx.textAlign = "right";
  ctx.fillText(title, x + wide, y - 14);
  if (note) ctx.fillText(note, x + wide, y + tall + 20);
  ctx.fillStyle = gradient;
  ctx.fillRect(x, y, wide, tall);
  ctx.strokeStyle = "#8b959e";
  ctx.strokeRect(x, y, wide, tall);
  ctx.fillStyle = INK;
  if (capped) ctx.fillText(`≥ ${brief(high)}`, x - 7, y + 4);
  for (const value of ticks(low, high, 5)) {
    const share = (value - low) / (high - low || 1);
    const at = y + tall * (1 - (root ? Math.sqrt(share) : share));
    if (capped && at < y + 12) continue;
    ctx.fillRect(x - 4, at - 0.5, 4, 1);
    ctx.fillText(brief(value), x - 7, at + 4);
  }
}

function swatches(ctx, x, y, names) {
  ctx.textAlign = "right";
  names.forEach((name, k) => {
    ctx.fillStyle = css(kind(k));
    ctx.beginPath();
    ctx.arc(x, y + 20 * k, 7, 0, 2 * Math.PI);
    ctx.fill();
    ctx.fillStyle = INK;
    ctx.fillText(name, x - 13, y + 4 + 20 * k);
  });
}

/** Names with a halo, lower where they would cover each other. */
function names(ctx, labels, width, height) {
  const taken = [];
  for (const { text, kind: of, at } of labels) {
    if (!at) continue;
    let [x, y] = [at[0] * width, at[1] * height];
    const [wide, tall] = [ctx.measureText(text).width, 15];
    const covered = () => taken.some(([a, b, w]) => Math.abs(x - a) < (w + wide) / 2 + 6 && Math.abs(y - b) < tall);
    for (let tries = 0; covered() && tries < 40; tries++) y += tall;
    taken.push([x, y, wide]);
    ctx.textAlign = "center";
    ctx.lineWidth = 4;
    ctx.lineJoin = "round";
    ctx.strokeStyle = "rgba(255,255,255,0.9)";
    ctx.strokeText(text, x, y + 4);
    ctx.fillStyle = LABELS[of];
    ctx.fillText(text, x, y + 4);
  }
}

/** Writes over a picture of `width` x `height` units of `ratio` pixels. */
export function write(ctx, width, height, ratio, { title, clock, scales, labels, mark }) {
  ctx.save();
  ctx.scale(ratio, ratio);
  ctx.font = "600 14px system-ui, 'DejaVu Sans', sans-serif";
  ctx.textAlign = "left";
  ctx.fillStyle = INK;
  ctx.fillText(title, 16, 26);
  ctx.font = "13px system-ui, 'DejaVu Sans', sans-serif";
  if (clock) ctx.fillText(clock, 16, 46);
  let y = 40;
  for (const scale of scales) {
    if (scale.names) {
      swatches(ctx, width - 26, y, scale.names);
      y += 20 * scale.names.length + 30;
    } else {
      bar(ctx, width - 36, y, { ...scale, colour: scale.heat ? heat : amount });
      y += 215;
    }
  }
  names(ctx, labels, width, height);
  if (mark) {
    ctx.strokeStyle = "#d6336c";
    ctx.lineWidth = 2;
    ctx.beginPath();
    ctx.arc(mark.at[0] * width, mark.at[1] * height, mark.radius * height, 0, 2 * Math.PI);
    ctx.stroke();
  }
  ctx.restore();
}
