// Spheres as impostors: two triangles each, on which every fragment casts its ray at the sphere and tells its depth.

import * as THREE from "three";

const VERTEX = `
attribute vec4 sphere;
attribute float shade;
varying vec3 at;
varying vec3 centre;
varying float radius;
varying float value;
void main() {
  radius = sphere.w;
  value = shade;
  centre = (modelViewMatrix * vec4(sphere.xyz, 1.0)).xyz;
  // A square across the line to the centre that just covers the cone of rays that meet the sphere.
  float d2 = max(dot(centre, centre), 1.0001 * radius * radius);
  vec3 front = centre * inversesqrt(d2);
  vec3 u = normalize(cross(front, abs(front.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 v = cross(u, front);
  float size = radius * sqrt(d2 / (d2 - radius * radius));
  at = centre + (position.x * u + position.y * v) * size;
  gl_Position = projectionMatrix * vec4(at, 1.0);
  if (radius <= 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

const FRAGMENT = `
uniform sampler2D colours;
uniform vec4 clip;
uniform vec3 paper;
uniform float pale;
uniform mat4 projection;
varying vec3 at;
varying vec3 centre;
varying float radius;
varying float value;
void main() {
  vec3 ray = normalize(at);
  float along = dot(ray, centre);
  float under = along * along - dot(centre, centre) + radius * radius;
  if (under < 0.0) discard;
  float half_chord = sqrt(under);
  vec3 hit = ray * (along - half_chord);
  vec3 normal = (hit - centre) / radius;
  float flatness = 0.0;
  if (dot(clip.xyz, hit) + clip.w < 0.0) {
    // The near side is cut away: the cut face shows, where the ray meets it inside the sphere.
    float t = -clip.w / dot(clip.xyz, ray);
    hit = ray * t;
    if (t <= along - half_chord || t >= along + half_chord) discard;
    normal = -clip.xyz * sign(dot(clip.xyz, ray));
    flatness = 1.0;
  }
  // Pale spheres are of no colour: their legend is not shown.
  vec3 base = pale > 0.0 ? vec3(0.66) : texture2D(colours, vec2(value, 0.5)).rgb;
  float key = max(dot(normal, normalize(vec3(-0.35, 0.55, 0.75))), 0.0);
  float sky = 0.5 + 0.5 * normal.y;
  float rim = 1.0 - max(-dot(normal, ray), 0.0);
  vec3 colour = base * (0.42 + 0.14 * sky + 0.52 * key) * (1.0 - 0.35 * rim * rim * rim);
  vec3 mirrored = reflect(ray, normal);
  colour += 0.10 * pow(max(dot(mirrored, normalize(vec3(-0.35, 0.55, 0.75))), 0.0), 24.0);
  colour = mix(colour, base * 0.75, flatness);
  colour = mix(colour, paper, pale);
  gl_FragColor = vec4(colour, 1.0);
  vec4 seen = projection * vec4(hit, 1.0);
  gl_FragDepth = 0.5 + 0.5 * seen.z / seen.w;
}`;

export class Spheres {
  constructor(count, colours) {
    this.count = count;
    this.geometry = new THREE.InstancedBufferGeometry();
    const corners = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]);
    this.geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    this.geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.places = new THREE.InstancedBufferAttribute(new Float32Array(4 * count), 4).setUsage(THREE.DynamicDrawUsage);
    this.shades = new THREE.InstancedBufferAttribute(new Float32Array(count), 1).setUsage(THREE.DynamicDrawUsage);
    this.geometry.setAttribute("sphere", this.places);
    this.geometry.setAttribute("shade", this.shades);
    this.geometry.instanceCount = count;
    this.material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: THREE.DoubleSide,
      uniforms: {
        colours: { value: colours },
        clip: { value: new THREE.Vector4(0, 0, 0, 1) },
        paper: { value: new THREE.Color(1, 1, 1) },
        pale: { value: 0 },
        projection: { value: new THREE.Matrix4() },
      },
    });
    this.mesh = new THREE.Mesh(this.geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.onBeforeRender = (_renderer, _scene, camera) => {
      this.material.uniforms.projection.value.copy(camera.projectionMatrix);
    };
  }

  /** Centres [m] against `origin`; spheres that are not there have no radius. */
  place(centres, present, radius, origin) {
    const out = this.places.array;
    for (let s = 0; s < this.count; s++) {
      out[4 * s] = centres[3 * s] - origin[0];
      out[4 * s + 1] = centres[3 * s + 1] - origin[1];
      out[4 * s + 2] = centres[3 * s + 2] - origin[2];
      out[4 * s + 3] = present[s] ? radius[s] : 0;
    }
    this.places.needsUpdate = true;
  }

  /** Places on the scale of colours, 0 to 1. */
  shade(values) {
    this.shades.array.set(values);
    this.shades.needsUpdate = true;
  }
}
