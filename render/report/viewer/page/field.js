// The averaged density field on a section that can be moved.

/** Value at a point (mm) between the grid's points; NaN where one of the eight has none. */
function densityAt(grid, x, y, z) {
  const [nx, ny, nz] = grid.counts, s = grid.spacing;
  const fx = (x - grid.origin[0]) / s, fy = (y - grid.origin[1]) / s, fz = (z - grid.origin[2]) / s;
  if (fx < -0.5 || fy < -0.5 || fz < -0.5 || fx > nx - 0.5 || fy > ny - 0.5 || fz > nz - 0.5) return NaN;
  const i = Math.max(0, Math.min(nx - 2, Math.floor(fx))), j = Math.max(0, Math.min(ny - 2, Math.floor(fy)));
  const k = Math.max(0, Math.min(nz - 2, Math.floor(fz)));
  let sum = 0, weights = 0;
  for (let corner = 0; corner < 8; ++corner) {
    const a = i + (corner & 1), b = j + ((corner >> 1) & 1), c = k + (corner >> 2);
    const word = a < nx && b < ny && c < nz ? grid.words[(c * ny + b) * nx + a] : 0;
    const weight = Math.max(0, 1 - Math.abs(fx - a)) * Math.max(0, 1 - Math.abs(fy - b)) * Math.max(0, 1 - Math.abs(fz - c));
    if (word > 0) { sum += weight * fractionOf(word); weights += weight; }
  }
  return weights > 0.5 ? sum / weights : NaN;
}

/** The two axes of a section across `axis` (0, 1, 2). */
function axesAcross(axis) {
  return [[1, 2], [0, 2], [0, 1]][axis];
}

/** A plane of the density field in a scene. */
class Section {
  constructor(grid) {
    this.grid = grid;
    const geometry = new THREE.BufferGeometry();
    this.corners = new Float32Array(12);
    geometry.setAttribute("position", new THREE.BufferAttribute(this.corners, 3));
    geometry.setAttribute("uv", new THREE.BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, alphaTest: 0.5 });
    this.mesh = new THREE.Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** Puts the plane at `place` (mm) along `axis` and colours it; `bands`: in steps instead of evenly. */
  draw(axis, place, scale, bands) {
    const grid = this.grid, [a, b] = axesAcross(axis), fine = 4;
    const width = (grid.counts[a] - 1) * fine, height = (grid.counts[b] - 1) * fine;
    const pixels = new Uint8Array(4 * width * height), point = [0, 0, 0];
    point[axis] = place;
    for (let v = 0; v < height; ++v)
      for (let u = 0; u < width; ++u) {
        point[a] = grid.origin[a] + grid.spacing * (u + 0.5) / fine;
        point[b] = grid.origin[b] + grid.spacing * (v + 0.5) / fine;
        let value = densityAt(grid, point[0], point[1], point[2]);
        const at = 4 * (v * width + u);
        if (!(value === value)) continue;
        if (bands) value = bands * (Math.floor(value / bands) + 0.5);
        scale.colour(value, pixels, at);
        pixels[at + 3] = 255;
      }
    if (this.material.map) this.material.map.dispose();
    this.material.map = new THREE.DataTexture(pixels, width, height, THREE.RGBAFormat);
    this.material.map.magFilter = this.material.map.minFilter = THREE.LinearFilter;
    this.material.map.needsUpdate = true;
    this.material.needsUpdate = true;
    this.place(axis, place);
  }

  place(axis, place) {
    const grid = this.grid, [a, b] = axesAcross(axis);
    const low = grid.origin, high = low.map((value, n) => value + grid.spacing * (grid.counts[n] - 1));
    [[0, 0], [1, 0], [1, 1], [0, 1]].forEach(([u, v], n) => {
      this.corners[3 * n + axis] = place;
      this.corners[3 * n + a] = u ? high[a] : low[a];
      this.corners[3 * n + b] = v ? high[b] : low[b];
    });
    this.mesh.geometry.attributes.position.needsUpdate = true;
  }
}
