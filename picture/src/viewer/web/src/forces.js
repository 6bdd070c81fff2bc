// Contact forces: ribbons that face the camera, as wide as the force is large.

import * as THREE from "three";

const VERTEX = `
attribute vec3 from;
attribute vec3 to;
attribute float width;
attribute float shade;
uniform float pixel;
uniform float factor;
varying float value;
varying vec3 at;
varying float across;
void main() {
  value = shade;
  across = position.y;
  vec3 a = (modelViewMatrix * vec4(from, 1.0)).xyz;
  vec3 b = (modelViewMatrix * vec4(to, 1.0)).xyz;
  vec3 p = position.x < 0.5 ? a : b;
  vec3 side = cross(b - a, p);
  float l = length(side);
  side = l > 0.0 ? side / l : vec3(0.0);
  // Never thinner than a pixel.
  float half_width = max(0.5 * width * factor, 0.5 * pixel * -p.z);
  at = p + side * half_width * position.y;
  gl_Position = projectionMatrix * vec4(at, 1.0);
}`;

const FRAGMENT = `
uniform sampler2D colours;
uniform vec4 clip;
varying float value;
varying vec3 at;
varying float across;
void main() {
  if (dot(clip.xyz, at) + clip.w < 0.0) discard;
  vec3 colour = texture2D(colours, vec2(value, 0.5)).rgb;
  gl_FragColor = vec4(colour * (1.0 - 0.35 * across * across), 1.0);
}`;

export class Forces {
  constructor(colours) {
    this.material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: THREE.DoubleSide,
      depthTest: false,
      depthWrite: false,
      transparent: true,
      uniforms: {
        colours: { value: colours },
        clip: { value: new THREE.Vector4(0, 0, 0, 1) },
        pixel: { value: 0.001 },
        factor: { value: 1 },
      },
    });
    this.mesh = new THREE.Mesh(new THREE.InstancedBufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 5;
    this.mesh.visible = false;
    this.room = 0;
    this.lines = 0;
  }

  grow(count) {
    if (this.room > 0 && count <= this.room) return;
    this.room = Math.ceil(1.3 * count) + 16;
    this.mesh.geometry.dispose();
    const geometry = new THREE.InstancedBufferGeometry();
    const corners = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]);
    geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    for (const [name, size] of [["from", 3], ["to", 3], ["width", 1], ["shade", 1]]) {
      const attribute = new THREE.InstancedBufferAttribute(new Float32Array(size * this.room), size);
      geometry.setAttribute(name, attribute.setUsage(THREE.DynamicDrawUsage));
    }
    this.mesh.geometry = geometry;
  }

  /** Lines of a frame's contacts between the present places [m]; `top` [N] is as wide as `thickest` [m]. */
  place(contacts, centres, present, origin, top, thickest) {
    this.grow(contacts.count);
    const { geometry } = this.mesh;
    const [from, to, width, shade] = ["from", "to", "width", "shade"].map((name) => geometry.getAttribute(name).array);
    // The strongest are drawn last.
    const order = Array.from({ length: contacts.count }, (_, k) => k).filter((k) => contacts.force[k] > 0);
    order.sort((a, b) => contacts.force[a] - contacts.force[b]);
    let line = 0;
    for (const k of order) {
      const [a, b] = [contacts.rank[k], contacts.partner[k]];
      const between = contacts.form[k] === 0;
      if (!present[a] || (between && !present[b])) continue;
      for (let axis = 0; axis < 3; axis++) {
        const start = centres[3 * a + axis] - origin[axis];
        from[3 * line + axis] = start;
        to[3 * line + axis] = between ? centres[3 * b + axis] - origin[axis] : start + contacts.branch[3 * k + axis];
      }
      const share = contacts.force[k] / top;
      width[line] = thickest * Math.min(share, 1.2);
      // By the root: most forces are small against the largest, and their chains should be seen.
      shade[line] = Math.sqrt(Math.min(share, 1));
      line++;
    }
    geometry.instanceCount = line;
    this.lines = line;
    for (const name of ["from", "to", "width", "shade"]) geometry.getAttribute(name).needsUpdate = true;
  }
}
