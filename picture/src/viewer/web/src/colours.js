// Scales of colours: a sequence for amounts, another for forces, distinct colours for kinds.

import * as THREE from "three";

/** From slow to fast, as in `view.py`: bright enough at its lower end for grains at rest. */
const AMOUNT = [[64, 140, 204], [120, 201, 166], [250, 240, 153], [245, 128, 69], [184, 23, 56]];
/** From weak to strong, seen on white and over pale spheres. */
const HEAT = [[255, 214, 120], [250, 170, 80], [235, 115, 55], [205, 60, 45], [150, 15, 40], [80, 0, 30]];
/** Okabe and Ito: told apart by all eyes. */
const KINDS = [[230, 159, 0], [86, 180, 233], [0, 158, 115], [0, 114, 178], [213, 94, 0], [204, 121, 167], [240, 228, 66], [120, 120, 120]];

const WIDTH = 256;

function texture(colour) {
  const data = new Uint8Array(4 * WIDTH);
  for (let k = 0; k < WIDTH; k++) data.set([...colour(k / (WIDTH - 1)), 255], 4 * k);
  const out = new THREE.DataTexture(data, WIDTH, 1);
  out.magFilter = out.minFilter = THREE.LinearFilter;
  out.needsUpdate = true;
  return out;
}

function between(list, x) {
  const place = Math.min(Math.max(x, 0), 1) * (list.length - 1);
  const k = Math.min(Math.floor(place), list.length - 2);
  return list[k].map((c, axis) => Math.round(c + (place - k) * (list[k + 1][axis] - c)));
}

export const amount = (x) => between(AMOUNT, x);
export const heat = (x) => between(HEAT, x);
export const kind = (k) => KINDS[((k % KINDS.length) + KINDS.length) % KINDS.length];
/** Where kind `k` stands on its scale. */
export const kindPlace = (k) => ((((k % KINDS.length) + KINDS.length) % KINDS.length) + 0.5) / KINDS.length;

export const amountTexture = () => texture(amount);
export const heatTexture = () => texture(heat);
export function kindTexture() {
  const out = texture((x) => KINDS[Math.min(Math.floor(x * KINDS.length), KINDS.length - 1)]);
  out.magFilter = out.minFilter = THREE.NearestFilter;
  return out;
}
export const css = ([r, g, b]) => `rgb(${r},${g},${b})`;
