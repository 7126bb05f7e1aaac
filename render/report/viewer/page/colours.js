// What grains can be coloured by, and the scale from value to colour.

const NO_VALUE = [200, 200, 200];

const QUANTITIES = [
  { key: "fraction", name: "solid fraction", unit: "", none: "open cell",
    of: (run, frame, grain) => fractionOf(frame.fraction[grain]) },
  { key: "speed", name: "speed", unit: "m/s", none: "",
    of: (run, frame, grain) => speedOf(frame, grain) },
  { key: "size", name: "grain size", unit: "mm", none: "",
    of: (run, frame, grain) => run.shapes[run.kind[grain]].diameter },
  { key: "layer", name: "height at the first instant", unit: "mm", none: "came later",
    of: (run, frame, grain) => {
      const centre = centreOf(run, run.at[0], grain);
      return centre ? centre[2] : NaN;
    } },
];

/** Colours by number: a table of bytes and the limits it spans. */
class Scale {
  constructor(palette) { this.palette = palette; this.lower = 0; this.upper = 1; }

  /** Place in the palette of a value. */
  colour(value, into, at) {
    if (!(value === value)) { into[at] = NO_VALUE[0]; into[at + 1] = NO_VALUE[1]; into[at + 2] = NO_VALUE[2]; return; }
    const share = (value - this.lower) / (this.upper - this.lower);
    const n = 3 * Math.max(0, Math.min(255, Math.round(255 * share)));
    into[at] = this.palette[n]; into[at + 1] = this.palette[n + 1]; into[at + 2] = this.palette[n + 2];
  }

  css(share) {
    const n = 3 * Math.max(0, Math.min(255, Math.round(255 * share)));
    return "rgb(" + this.palette[n] + "," + this.palette[n + 1] + "," + this.palette[n + 2] + ")";
  }
}

/** Limits that hold all runs and instants, but for the rarest values. */
function limitsOf(runs, quantity, given) {
  if (quantity.key === "fraction" && given) return given;
  const values = [];
  for (const run of runs)
    for (const frame of quantity.key === "size" || quantity.key === "layer" ? [run.at[0]] : run.at)
      for (let grain = 0; grain < run.grains; grain += 1 + Math.floor(run.grains / 4000)) {
        const value = quantity.of(run, frame, grain);
        if (value === value && frame.position[grain] !== ABSENT) values.push(value);
      }
  if (values.length === 0) return [0, 1];
  const sorted = Float64Array.from(values).sort();
  if (quantity.key === "speed") return [0, widened(0, percentile(sorted, 0.98))[1]];
  return widened(percentile(sorted, 0.02), percentile(sorted, 0.98));
}

/** Whether the quantity tells grains apart in any run. */
function worthOffering(runs, quantity) {
  if (quantity.key === "size") return runs.some((run) => run.shapes.length > 1);
  if (quantity.key === "layer") return runs.some((run) => run.at.length > 1);
  return true;
}
