// The picture: camera, spheres, boundaries, forces, outlines, cut, and what lies under the pointer.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { amountTexture, heat, heatTexture, kindTexture } from "./colours.js";
import { Forces } from "./forces.js";
import { Spheres } from "./spheres.js";

const PAPER = 0xffffff;
const SHEET = 0x8fb0d0;
/** Of triangles that nothing has touched. */
const UNTOUCHED = [0.9, 0.91, 0.92];
const OUTLINES = { input: 0x3a5a8c, sensor: 0x8a4fb0, source: 0x2e8b57, sink: 0xb0562e, probe: 0x444444 };
/** From what is looked at to the camera. */
export const PRESETS = {
  oblique: [0.52, -0.78, 0.35],
  front: [0, -1, 0],
  right: [1, 0, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  top: [0, -1e-4, 1],
};

export class Stage {
  constructor(canvas, data) {
    const { head } = data;
    this.data = data;
    const [low, high] = head.extent;
    this.origin = low.map((l, axis) => 0.5 * (l + high[axis]));
    this.size = Math.hypot(...low.map((l, axis) => high[axis] - l)) || 1;
    this.low = low;
    this.high = high;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.setClearColor(PAPER);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.1, 10);
    this.camera.up.set(0, 0, 1);
    this.scene.add(this.camera, new THREE.HemisphereLight(0xffffff, 0xb8c0c8, 2.4));
    const lamp = new THREE.DirectionalLight(0xffffff, 1.1);
    lamp.position.set(-0.35, 0.55, 0.75);
    this.camera.add(lamp);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.amount = amountTexture();
    this.kinds = kindTexture();
    this.spheres = new Spheres(head.spheres, this.amount);
    this.forces = new Forces(heatTexture());
    this.scene.add(this.spheres.mesh, this.forces.mesh);
    this.addBoundaries();
    this.addOutlines();
    this.cut = null;
    this.opacity = 0.25;
    this.preset("oblique");
  }

  local(point) {
    return new THREE.Vector3(...point.map((x, axis) => x - this.origin[axis]));
  }

  addBoundaries() {
    this.boundaries = this.data.head.boundaries.map((boundary, k) => {
      const { points, triangles } = this.data.surfaces[k];
      let geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
      geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
      const outline = new THREE.EdgesGeometry(geometry, 40);
      if (boundary.felt) {
        // Each triangle has a colour of its own.
        geometry = geometry.toNonIndexed();
        geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(9 * boundary.triangles).fill(1), 3));
      }
      const group = new THREE.Group();
      const skin = new THREE.MeshLambertMaterial({
        color: SHEET,
        transparent: true,
        side: THREE.DoubleSide,
        flatShading: true,
        depthWrite: false,
      });
      // Colours of what is felt are read against the legend: light changes them by little.
      skin.onBeforeCompile = (shader) => {
        const shaded = "outgoingLight = mix(outgoingLight, diffuseColor.rgb, painted);\n#include <opaque_fragment>";
        shader.uniforms.painted = skin.userData.painted;
        shader.fragmentShader = `uniform float painted;\n${shader.fragmentShader.replace("#include <opaque_fragment>", shaded)}`;
      };
      skin.userData.painted = { value: 0 };
      const sheet = new THREE.Mesh(geometry, skin);
      sheet.renderOrder = 2;
      const ink = new THREE.LineBasicMaterial({ color: 0x7f96ab });
      const edges = new THREE.LineSegments(outline, ink);
      edges.renderOrder = 1;
      group.add(sheet, edges);
      group.userData = { boundary: k, sheet, edges, centre: this.local(boundary.centre) };
      this.scene.add(group);
      return group;
    });
  }

  addOutlines() {
    this.outlines = new THREE.Group();
    for (const label of this.data.head.labels) {
      if (!label.lines.length) continue;
      const points = label.lines.flat().map((point) => this.local(point));
      const material = new THREE.LineBasicMaterial({ color: OUTLINES[label.kind] });
      this.outlines.add(new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points), material));
    }
    this.scene.add(this.outlines);
  }

  /** Looks at all from a side, as near as all of it is seen. */
  preset(name) {
    this.fit(PRESETS[name], this.low, this.high);
  }

  /** Looks at a box from a direction. */
  fit(direction, low, high) {
    const middle = this.local(low.map((l, axis) => 0.5 * (l + high[axis])));
    const away = new THREE.Vector3(...direction).normalize();
    const right = new THREE.Vector3(0, 0, 1).cross(away).normalize();
    const up = away.clone().cross(right);
    const tall = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
    const wide = tall * this.camera.aspect;
    let distance = 0;
    for (let k = 0; k < 8; k++) {
      const corner = this.local([0, 1, 2].map((axis) => ((k >> axis) & 1 ? high : low)[axis])).sub(middle);
      const near = corner.dot(away);
      distance = Math.max(distance, near + Math.abs(corner.dot(right)) / wide, near + Math.abs(corner.dot(up)) / tall);
    }
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).addScaledVector(away, 1.08 * distance);
    this.controls.update();
  }

  /** Camera and target [m], to be kept. */
  get viewpoint() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  set viewpoint(numbers) {
    this.camera.position.fromArray(numbers);
    this.controls.target.fromArray(numbers, 3);
    this.controls.update();
  }

  resize(width, height, ratio) {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.forces.material.uniforms.pixel.value =
      (2 * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2))) / (height * ratio);
  }

  /** Moves the boundaries to a frame, or between it and the next. */
  moveBoundaries(frame, next, share) {
    const count = this.boundaries.length;
    const { motion } = this.data;
    const pose = (f, k) => motion.subarray(7 * (f * count + k), 7 * (f * count + k) + 7);
    const turn = ([, , , w, x, y, z]) => new THREE.Quaternion(x, y, z, w);
    this.boundaries.forEach((group, k) => {
      const [a, b] = [pose(frame, k), pose(next, k)];
      for (let axis = 0; axis < 3; axis++) {
        const own = a[axis] + share * (b[axis] - a[axis]);
        group.position.setComponent(axis, group.userData.centre.getComponent(axis) + own);
      }
      group.quaternion.copy(turn(a)).slerp(turn(b), share);
    });
  }

  /** Colours the triangles that keep what they feel by `values` up to `high`, from the `first` of each boundary on; null: not. */
  paint(values, high, first) {
    for (const { userData } of this.boundaries) {
      const { boundary: k, sheet } = userData;
      const start = first[k];
      if (start === null) continue;
      const { material, geometry } = sheet;
      if (material.vertexColors !== Boolean(values)) {
        material.vertexColors = Boolean(values);
        material.color.set(values ? 0xffffff : SHEET);
        material.userData.painted.value = values ? 0.75 : 0;
        this.cover(userData);
        material.needsUpdate = true;
      }
      if (!values) continue;
      const colours = geometry.attributes.color;
      for (let t = 0; t < colours.count / 3; t++) {
        const value = values[start + t];
        const own = value > 0 ? heat(value / (high || 1)).map((c) => c / 255) : UNTOUCHED;
        for (let corner = 0; corner < 3; corner++) colours.setXYZ(3 * t + corner, ...own);
      }
      colours.needsUpdate = true;
    }
  }

  /** Opacity of the boundaries, of painted ones four times as much; at zero they vanish, edges too. */
  set opacity(value) {
    this.covering = value;
    for (const { userData } of this.boundaries) this.cover(userData);
  }

  cover({ sheet, edges }) {
    const { material } = sheet;
    material.opacity = Math.min(1, this.covering * (material.vertexColors ? 4 : 1));
    sheet.visible = edges.visible = material.opacity > 0;
    material.depthWrite = material.opacity >= 1;
  }

  /** Cuts away what lies beyond a plane: unit normal towards what stays, and share of the way through; null: nothing. */
  clip(normal, share) {
    this.cut = null;
    if (normal) {
      const plane = new THREE.Plane(new THREE.Vector3(...normal), 0);
      const half = 0.5 * normal.reduce((sum, n, axis) => sum + Math.abs(n) * (this.high[axis] - this.low[axis]), 0);
      plane.constant = half * 1.02 * (1 - 2 * share);
      this.cut = plane;
    }
    this.renderer.clippingPlanes = this.cut ? [this.cut] : [];
  }

  render() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const reach = 3 * this.size + this.camera.position.length();
    this.camera.near = Math.max(2e-3 * distance, 1e-4 * reach);
    this.camera.far = Math.max(reach, 2 * distance);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    const plane = this.cut?.clone().applyMatrix4(this.camera.matrixWorldInverse);
    for (const one of [this.spheres, this.forces]) {
      const { value } = one.material.uniforms.clip;
      if (plane) value.set(...plane.normal.toArray(), plane.constant);
      else value.set(0, 0, 0, 1);
    }
    this.renderer.render(this.scene, this.camera);
  }

  /** Where a point [m] is on the picture, in shares of its width and height from the upper left; null behind the camera. */
  project(point) {
    const seen = this.local(point).project(this.camera);
    return Math.abs(seen.z) > 1 ? null : [0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y];
  }

  /** What lies at a place of the picture (shares of width and height): the first sphere, or else the first boundary. */
  pick(x, y) {
    const caster = new THREE.Raycaster();
    caster.setFromCamera(new THREE.Vector2(2 * x - 1, 1 - 2 * y), this.camera);
    const { origin: o, direction: d } = caster.ray;
    const kept = (t) => !this.cut || this.cut.distanceToPoint(o.clone().addScaledVector(d, t)) >= 0;
    const crossing = this.cut ? -this.cut.distanceToPoint(o) / this.cut.normal.dot(d) : NaN;
    const places = this.spheres.places.array;
    let [best, rank] = [Infinity, -1];
    if (this.spheres.mesh.visible) {
      for (let s = 0; s < this.spheres.count; s++) {
        const r = places[4 * s + 3];
        if (r <= 0) continue;
        const [cx, cy, cz] = [places[4 * s] - o.x, places[4 * s + 1] - o.y, places[4 * s + 2] - o.z];
        const along = cx * d.x + cy * d.y + cz * d.z;
        const under = along * along - (cx * cx + cy * cy + cz * cz) + r * r;
        if (under < 0) continue;
        const chord = Math.sqrt(under);
        let t = along - chord;
        if (!kept(t)) t = crossing > t && crossing < along + chord ? crossing : Infinity;
        if (t > 0 && t < best) [best, rank] = [t, s];
      }
    }
    if (rank >= 0) return { sphere: rank };
    const sheets = this.boundaries.filter((g) => g.userData.sheet.visible).map((g) => g.userData.sheet);
    const hit = caster.intersectObjects(sheets, false).find(({ distance }) => kept(distance));
    return hit ? { boundary: hit.object.parent.userData.boundary, triangle: hit.faceIndex } : null;
  }
}
