// The value under the pointer.

/** A line for every number of a grain. */
function grainText(run, frame, grain) {
  const centre = centreOf(run, frame, grain), fraction = fractionOf(frame.fraction[grain]);
  return ["grain " + run.id[grain] + ", d = " + inDigits(run.shapes[run.kind[grain]].diameter, 3) + " mm",
    "solid fraction " + (fraction === fraction ? fraction.toFixed(3) : "– (open cell)"),
    "speed " + inDigits(speedOf(frame, grain), 3) + " m/s",
    "at " + centre.map((value) => value.toFixed(1)).join(", ") + " mm"];
}

/** Depth along the ray of a section across `axis` at `place`. */
function depthOfSection(ray, axis, place) {
  const names = ["x", "y", "z"], along = ray.direction[names[axis]];
  return Math.abs(along) < 1e-9 ? Infinity : (place - ray.origin[names[axis]]) / along;
}

/** What to say about the place of a run under the ray; empty: nothing is there. */
function textUnder(view, cell, ray) {
  const state = view.state, frame = cell.frame();
  const grains = cell.grains.points.visible ? cell.grains.hit(ray.origin, ray.direction) : { depth: Infinity, grain: -1 };
  if (cell.section && cell.section.mesh.visible) {
    const depth = depthOfSection(ray, state.axis, state.place);
    const point = ray.origin.clone().addScaledVector(ray.direction, depth);
    const value = depth < grains.depth ? densityAt(cell.run.density, point.x, point.y, point.z) : NaN;
    if (value === value)
      return ["averaged solid fraction " + value.toFixed(3),
        "at " + [point.x, point.y, point.z].map((part) => part.toFixed(1)).join(", ") + " mm"];
  }
  return grains.grain < 0 ? [] : grainText(cell.run, frame, grains.grain);
}

/** Shows the value where the pointer rests, on a tap where there is none. */
class Pointer {
  constructor(canvas, view) {
    this.view = view; this.canvas = canvas;
    this.tip = addElement(canvas.parentElement, "div", "tip");
    this.tip.hidden = true;
    let waiting = false;
    const later = (event) => {
      this.last = event;
      if (!waiting) { waiting = true; requestAnimationFrame(() => { waiting = false; this.show(this.last); }); }
    };
    canvas.addEventListener("mousemove", (event) => { if (event.buttons === 0) later(event); else this.tip.hidden = true; });
    canvas.addEventListener("mouseleave", () => { this.tip.hidden = true; });
    canvas.addEventListener("touchend", (event) => { if (event.changedTouches.length === 1) later(event.changedTouches[0]); },
      { passive: true });
  }

  show(event) {
    const box = this.canvas.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    const cell = this.view.cells.find((one) => one.holds(x, y));
    const lines = cell ? textUnder(this.view, cell, this.view.camera.ray(...cell.within(x, y))) : [];
    this.tip.hidden = lines.length === 0;
    if (this.tip.hidden) return;
    this.tip.textContent = lines.join("\n");
    this.tip.style.left = Math.min(x + 14, box.width - this.tip.offsetWidth - 4) + "px";
    this.tip.style.top = Math.max(4, Math.min(y + 14, box.height - this.tip.offsetHeight - 4)) + "px";
  }
}
