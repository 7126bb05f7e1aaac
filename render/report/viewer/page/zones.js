// Zones of the density field: the surfaces round what is looser than one value and round what is denser than
// another, by surface nets (Gibson 1998) on the grid.

/** 1 in the zone, 0 elsewhere. `inZone` judges a solid fraction. */
function zoneMarks(grid, inZone) {
  const marks = new Int8Array(grid.words.length);
  for (let k = 0; k < marks.length; ++k) {
    const value = fractionOf(grid.words[k]);
    marks[k] = value === value && inZone(value) ? 1 : 0;
  }
  return marks;
}

/** Marks of the eight corners of a cell, the first coordinate fastest, their sum returned; 0 outside the grid. */
function cornerMarks(marks, counts, i, j, k, into) {
  const [nx, ny, nz] = counts;
  let sum = 0;
  for (let corner = 0; corner < 8; ++corner) {
    const x = i + (corner & 1), y = j + ((corner >> 1) & 1), z = k + (corner >> 2);
    const inside = x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
    into[corner] = inside ? marks[(z * ny + y) * nx + x] : 0;
    sum += into[corner];
  }
  return sum;
}

/** Mean place of the crossings on the twelve edges of a cell, in grid units from its first corner. */
function netPoint(corners) {
  const sum = [0, 0, 0];
  let crossings = 0;
  for (let corner = 0; corner < 8; ++corner)
    for (let axis = 0; axis < 3; ++axis) {
      if (corner & (1 << axis) || corners[corner] === corners[corner | (1 << axis)]) continue;
      for (let n = 0; n < 3; ++n) sum[n] += n === axis ? 0.5 : (corner >> n) & 1;
      ++crossings;
    }
  return sum.map((value) => value / crossings);
}

/** Triangles of the surface round the marked points, mm. */
function zoneTriangles(grid, marks) {
  const counts = grid.counts, [nx, ny, nz] = counts, places = [], corners = [], number = new Map();
  const around = new Int8Array(8);
  const cell = (i, j, k) => ((k + 1) * (ny + 1) + (j + 1)) * (nx + 1) + (i + 1);
  for (let k = -1; k < nz; ++k)
    for (let j = -1; j < ny; ++j)
      for (let i = -1; i < nx; ++i) {
        const sum = cornerMarks(marks, counts, i, j, k, around);
        if (sum === 0 || sum === 8) continue;
        const point = netPoint(around);
        number.set(cell(i, j, k), places.length / 3);
        [i, j, k].forEach((at, n) => places.push(grid.origin[n] + grid.spacing * (at + point[n])));
      }
  const marked = (p) => p.every((at, n) => at >= 0 && at < counts[n]) && marks[(p[2] * ny + p[1]) * nx + p[0]] === 1;
  const quad = (p, axis, outward) => {
    const [a, b] = axesAcross(axis);
    const round = [[-1, -1], [0, -1], [0, 0], [-1, 0]].map(([u, v]) => {
      const at = p.slice();
      at[a] += u; at[b] += v;
      return number.get(cell(...at));
    });
    if (outward === (axis === 1)) round.reverse();
    corners.push(round[0], round[1], round[2], round[0], round[2], round[3]);
  };
  for (let k = 0; k < nz; ++k)
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx; ++i) {
        if (!marked([i, j, k])) continue;
        for (let axis = 0; axis < 3; ++axis) {
          const next = [i, j, k], last = [i, j, k];
          ++next[axis]; --last[axis];
          if (!marked(next)) quad([i, j, k], axis, true);
          if (!marked(last)) quad(last, axis, false);
        }
      }
  return { places: new Float32Array(places), corners: corners };
}

/** One zone as a solid body in a scene. */
class Zone {
  constructor(grid, colour) {
    this.grid = grid;
    this.material = new THREE.MeshLambertMaterial({ color: colour, side: THREE.DoubleSide });
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  show(inZone) {
    const marks = zoneMarks(this.grid, inZone);
    const surface = zoneTriangles(this.grid, marks);
    this.mesh.geometry.dispose();
    const geometry = this.mesh.geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(surface.places, 3));
    geometry.setIndex(surface.corners);
    geometry.computeVertexNormals();
  }
}

/** Share of the powder on the grid that lies in the zone. */
function zoneShare(grid, inZone) {
  let all = 0, inside = 0;
  for (const word of grid.words) if (word > 0) { ++all; if (inZone(fractionOf(word))) ++inside; }
  return all ? inside / all : 0;
}

/** Solid fraction below which a share of the powder of all runs lies. */
function fractionAtShare(runs, share) {
  const values = [];
  for (const run of runs)
    if (run.density && run.density.words)
      for (const word of run.density.words) if (word > 0) values.push(fractionOf(word));
  return values.length ? percentile(Float64Array.from(values).sort(), share) : 0;
}
