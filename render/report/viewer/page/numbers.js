// Numbers for people: ticks of a scale, digits, round lengths.

/** Rises by 1, 2 or 5 times a power of ten, so that about `count` steps span `span`. */
function roundStep(span, count) {
  const raw = Math.max(span, 1e-30) / count;
  const power = Math.pow(10, Math.floor(Math.log10(raw)));
  for (const factor of [1, 2, 5, 10]) if (raw <= factor * power * 1.0001) return factor * power;
  return 10 * power;
}

/** Round values between the limits. */
function ticksBetween(lower, upper, count) {
  const step = roundStep(upper - lower, count), ticks = [];
  for (let n = Math.ceil(lower / step - 1e-6); n * step <= upper + 1e-6 * step; ++n) ticks.push(n * step);
  return { step: step, values: ticks };
}

/** As many digits as tell steps of `step` apart. */
function inStepsOf(value, step) {
  return (value + 0).toFixed(Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9))));
}

/** With `digits` significant digits, no exponent, no trailing zeros. */
function inDigits(value, digits) {
  return String(Number(value.toPrecision(digits)));
}

/** Widens the limits to round numbers. */
function widened(lower, upper) {
  if (!(upper > lower)) { const half = Math.max(Math.abs(lower) * 0.02, 1e-6); lower -= half; upper += half; }
  const step = roundStep(upper - lower, 10);
  return [Math.floor(lower / step + 1e-6) * step, Math.ceil(upper / step - 1e-6) * step];
}

/** Value below which a share of the numbers lies. */
function percentile(sorted, share) {
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
