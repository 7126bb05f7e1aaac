// What the page holds of a run, unpacked: see render/report/viewer/packed_run.h. Lengths in mm.

const ABSENT = 65535;

function bytesOf(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** One array of the block by its name. */
function arrayOf(block, table, name) {
  const entry = table[name];
  if (!entry) return null;
  if (entry.type === "u8") return new Uint8Array(block, entry.offset, entry.count);
  if (entry.type === "u32") return new Uint32Array(block, entry.offset, entry.count);
  if (entry.type === "f32") return new Float32Array(block, entry.offset, entry.count);
  const bytes = new Uint8Array(block, entry.offset, 2 * entry.count), words = new Uint16Array(entry.count);
  for (let k = 0; k < entry.count; ++k) words[k] = bytes[k] | (bytes[entry.count + k] << 8);
  return words;
}

/** Adds what has changed to the frame before; numbers wrap around. */
function sumOf(change, before) {
  if (before) for (let k = 0; k < change.length; ++k) change[k] += before[k];
  return change;
}

/** The frames of a run: of each its time, poses of tools, and words as they are packed. */
function unpackFrames(run, block, table) {
  let before = {};
  return run.frames.map((frame, n) => {
    const words = {
      time: frame.time, poses: frame.poses,
      position: sumOf(arrayOf(block, table, "position" + n), before.position),
      turn: sumOf(Uint8Array.from(arrayOf(block, table, "turn" + n)), before.turn),
      speed: arrayOf(block, table, "speed" + n),
      fraction: arrayOf(block, table, "fraction" + n)
    };
    before = words;
    return words;
  });
}

/** Where the spheres of each grain begin, in the order of grains; at the end their number. */
function firstSpheres(run, kind) {
  const first = new Uint32Array(run.grains + 1);
  for (let g = 0; g < run.grains; ++g) first[g + 1] = first[g] + run.shapes[kind[g]].spheres.length;
  return first;
}

async function unpackRun(run, base64) {
  const block = await inflated(bytesOf(base64)), table = run.arrays;
  run.id = arrayOf(block, table, "id");
  run.kind = arrayOf(block, table, "kind");
  run.inside = arrayOf(block, table, "inside");
  run.largest = Math.max(...run.shapes.map((shape) => Math.max(...shape.spheres.map((sphere) => sphere[3]))));
  run.first = firstSpheres(run, run.kind);
  run.at = unpackFrames(run, block, table);
  run.tools.forEach((tool, n) => {
    tool.vertices = arrayOf(block, table, "vertices" + n);
    tool.corners = arrayOf(block, table, "corners" + n);
  });
  if (run.density && run.density.counts) run.density.words = arrayOf(block, table, "density");
  return run;
}

/** Centre of a grain in a frame, mm; null where it is not there. */
function centreOf(run, frame, grain) {
  const p = frame.position, n = run.grains, step = run.box.step, low = run.box.lower;
  if (p[grain] === ABSENT) return null;
  return [low[0] + step * p[grain], low[1] + step * p[n + grain], low[2] + step * p[2 * n + grain]];
}

/** m/s */
function speedOf(frame, grain) {
  const word = frame.speed[grain];
  return word === 0 ? 0 : 1e-5 * Math.exp(1e-2 * (word - 1));
}

/** NaN where it has none. */
function fractionOf(word) {
  return word === 0 ? NaN : (word - 1) / 5000;
}
