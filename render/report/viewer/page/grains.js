// Powder as shaded spheres: every sphere is one point that a shader turns into a ball with its own depth.

const BALL_VERTEX = [
  "attribute float radius;", "attribute vec3 colour;",
  "uniform float pixels; uniform float span; uniform vec4 cut;",
  "varying vec3 tint; varying float thickness;",
  "void main() {",
  "  vec4 eye = modelViewMatrix * vec4(position, 1.0);",
  "  gl_Position = projectionMatrix * eye;",
  "  bool gone = radius <= 0.0 || dot(cut.xyz, position) > cut.w;",
  "  if (gone) gl_Position = vec4(0.0, 0.0, 9.0, 1.0);",
  "  gl_PointSize = gone ? 0.0 : max(1.0, 2.0 * radius * pixels);",
  "  tint = colour; thickness = radius / span;",
  "}"].join("\n");

const BALL_FRAGMENT = [
  "varying vec3 tint; varying float thickness;",
  "void main() {",
  "  vec2 at = 2.0 * gl_PointCoord - 1.0;",
  "  float square = dot(at, at);",
  "  if (square > 1.0) discard;",
  "  float front = sqrt(1.0 - square);",
  "  vec3 normal = vec3(at.x, -at.y, front);",
  "  float key = max(dot(normal, vec3(-0.40, 0.56, 0.72)), 0.0);",
  "  float fill = max(dot(normal, vec3(0.62, -0.10, 0.78)), 0.0);",
  "  float shine = pow(max(dot(normal, vec3(-0.216, 0.302, 0.928)), 0.0), 40.0);",
  "  vec3 shaded = tint * (0.34 + 0.66 * key + 0.16 * fill) * mix(0.58, 1.0, smoothstep(0.0, 0.5, front));",
  "  gl_FragColor = vec4(shaded + 0.10 * shine, 1.0);",
  "  gl_FragDepthEXT = gl_FragCoord.z - thickness * front;",
  "}"].join("\n");

/** The powder of one run in a scene. */
class Grains {
  constructor(run) {
    this.run = run;
    const spheres = run.first[run.grains];
    this.place = new Float32Array(3 * spheres);
    this.radius = new Float32Array(spheres);
    this.colour = new Uint8Array(3 * spheres);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(this.place, 3));
    geometry.setAttribute("radius", new THREE.BufferAttribute(this.radius, 1));
    geometry.setAttribute("colour", new THREE.BufferAttribute(this.colour, 3, true));
    this.material = new THREE.ShaderMaterial({
      vertexShader: BALL_VERTEX, fragmentShader: BALL_FRAGMENT, extensions: { fragDepth: true },
      uniforms: { pixels: { value: 1 }, span: { value: 1 }, cut: { value: new THREE.Vector4(0, 0, 0, 1) } }
    });
    this.points = new THREE.Points(geometry, this.material);
    this.points.frustumCulled = false;
    this.onlyInside = false;
  }

  /** Moves all spheres to where they are in the frame. */
  move(frame) {
    const run = this.run, n = run.grains, turn = frame.turn;
    for (let g = 0; g < n; ++g) {
      const centre = this.onlyInside && !run.inside[g] ? null : centreOf(run, frame, g);
      const shape = run.shapes[run.kind[g]].spheres;
      if (!centre) { this.radius.fill(0, run.first[g], run.first[g + 1]); continue; }
      const w = turn[g] / 127 - 1, x = turn[n + g] / 127 - 1, y = turn[2 * n + g] / 127 - 1, z = turn[3 * n + g] / 127 - 1;
      for (let s = 0, at = run.first[g]; s < shape.length; ++s, ++at) {
        const [px, py, pz, radius] = shape[s];
        const cx = 2 * (y * pz - z * py), cy = 2 * (z * px - x * pz), cz = 2 * (x * py - y * px);
        this.place[3 * at] = centre[0] + px + w * cx + y * cz - z * cy;
        this.place[3 * at + 1] = centre[1] + py + w * cy + z * cx - x * cz;
        this.place[3 * at + 2] = centre[2] + pz + w * cz + x * cy - y * cx;
        this.radius[at] = radius;
      }
    }
    this.points.geometry.attributes.position.needsUpdate = true;
    this.points.geometry.attributes.radius.needsUpdate = true;
  }

  /** Colours all spheres by a quantity. */
  paint(frame, quantity, scale) {
    const run = this.run, one = [0, 0, 0];
    for (let g = 0; g < run.grains; ++g) {
      scale.colour(quantity.of(run, frame, g), one, 0);
      for (let at = run.first[g]; at < run.first[g + 1]; ++at) {
        this.colour[3 * at] = one[0]; this.colour[3 * at + 1] = one[1]; this.colour[3 * at + 2] = one[2];
      }
    }
    this.points.geometry.attributes.colour.needsUpdate = true;
  }

  /** `plane`: normal and distance of what is taken away; null: nothing. */
  cut(plane) {
    this.material.uniforms.cut.value.copy(plane || new THREE.Vector4(0, 0, 0, 1));
  }

  /** The foremost grain along a ray whose direction has length 1, or -1; its sphere's depth along it too. */
  hit(origin, direction) {
    const cut = this.material.uniforms.cut.value, place = this.place;
    let nearest = Infinity, found = -1;
    for (let at = 0; at < this.radius.length; ++at) {
      const r = this.radius[at];
      if (r <= 0) continue;
      const x = place[3 * at], y = place[3 * at + 1], z = place[3 * at + 2];
      const dx = x - origin.x, dy = y - origin.y, dz = z - origin.z;
      const along = dx * direction.x + dy * direction.y + dz * direction.z;
      const aside = dx * dx + dy * dy + dz * dz - along * along;
      if (aside > r * r || along - r > nearest) continue;
      if (cut.x * x + cut.y * y + cut.z * z > cut.w) continue;
      const depth = along - Math.sqrt(r * r - aside);
      if (depth < nearest) { nearest = depth; found = at; }
    }
    return { depth: nearest, grain: found < 0 ? -1 : grainOfSphere(this.run.first, found) };
  }
}

/** The last grain whose spheres begin at or before this one. */
function grainOfSphere(first, sphere) {
  let low = 0, high = first.length - 1;
  while (high - low > 1) { const middle = (low + high) >> 1; if (first[middle] <= sphere) low = middle; else high = middle; }
  return low;
}
