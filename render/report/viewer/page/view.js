// The view of one run or several: their scenes side by side under one camera, drawn when something has changed.

/** One run: its scene and its place in the canvas (CSS pixels). */
class Cell {
  constructor(run, stage, scale) {
    this.run = run; this.scene = new THREE.Scene();
    this.grains = new Grains(run);
    this.scene.add(this.grains.points);
    this.tools = run.tools.map((tool, n) => new Tool(tool, n));
    for (const tool of this.tools) this.scene.add(tool.group);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8890a0, 0.75));
    if (run.density && run.density.words) this.addDensity(run.density, scale);
    this.label = addElement(stage, "div", "label");
    this.number = run.at.length - 1;
  }

  addDensity(grid) {
    this.section = new Section(grid);
    this.loose = new Zone(grid, 0x7a5cd6); this.dense = new Zone(grid, 0xf2d22e);
    this.scene.add(this.section.mesh, this.loose.mesh, this.dense.mesh);
  }

  frame() { return this.run.at[this.number]; }

  /** To the kept instant nearest to this time (s); false: it is there already. */
  seek(time) {
    let best = 0;
    this.run.at.forEach((frame, n) => { if (Math.abs(frame.time - time) < Math.abs(this.run.at[best].time - time)) best = n; });
    if (best === this.number && this.moved) return false;
    this.number = best; this.moved = true;
    return true;
  }

  holds(x, y) { return x >= this.x && y >= this.y && x < this.x + this.width && y < this.y + this.height; }

  within(x, y) { return [2 * (x - this.x) / this.width - 1, 1 - 2 * (y - this.y) / this.height]; }
}

class View {
  constructor(root, runs, description) {
    this.root = root; this.runs = runs; this.given = description.range;
    this.hasDensity = runs.some((run) => run.density && run.density.words);
    this.times = allTimes(runs);
    this.scale = new Scale(bytesOf(description.palette));
    this.quantity = QUANTITIES[0];
    this.slow = true;  // until the first picture has told
    this.state = { instant: this.times.length - 1, powder: "grains", onlyInside: false, axis: -1, place: 0, flip: false,
      cutPowder: true, cutTools: true, density: true, bands: false, opacity: 0.25, hidden: new Set(),
      loose: fractionAtShare(runs, 0.1), dense: fractionAtShare(runs, 0.9) };
    this.build();
  }

  build() {
    this.stage = addElement(this.root, "div", "stage");
    const panel = addElement(this.root, "div", "panel");
    const canvas = this.canvas = addElement(this.stage, "canvas");
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "Powder and tools in three dimensions. Arrows turn, plus and minus zoom, "
      + "space plays, comma and point step through time, 1 to 5 are views.");
    const context = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!context) throw new Error("no WebGL");
    this.renderer = new THREE.WebGLRenderer({ canvas: canvas, context: context, antialias: true });
    this.renderer.setClearColor(0xffffff);
    this.renderer.localClippingEnabled = true;
    this.renderer.setScissorTest(true);
    this.cells = this.runs.map((run) => new Cell(run, this.stage, this.scale));
    this.camera = new Camera(canvas, () => this.redraw());
    this.lamp = new THREE.Vector3();
    this.marks = { legend: new Legend(this.stage), axes: new Axes(this.stage), bar: new ScaleBar(this.stage) };
    this.pointer = new Pointer(canvas, this);
    timeControls(this.stage, this);
    for (const add of [cameraControls, powderControls, sectionControls, toolControls]) add(panel, this);
    obeyKeys(canvas, this);
    this.setQuantity(this.quantity);
    this.frameCavity();
    new ResizeObserver(() => this.arrange()).observe(this.stage);
    this.arrange();
  }

  zoneRange() {
    return [fractionAtShare(this.runs, 0.002), fractionAtShare(this.runs, 0.998)];
  }

  set(changes) {
    Object.assign(this.state, changes);
    this.update();
  }

  setQuantity(quantity) {
    this.quantity = quantity;
    [this.scale.lower, this.scale.upper] = limitsOf(this.runs, quantity, this.given);
    this.marks.legend.show(quantity, this.scale);
    this.painted = null;
    this.update();
  }

  setAxis(axis) {
    if (axis >= 0) {
      const [low, high] = this.bounds();
      this.placeSlider.setRange(low[axis].toFixed(2), high[axis].toFixed(2), 0.05, 0.5 * (low[axis] + high[axis]));
      this.state.place = Number(this.placeSlider.value);
    }
    this.set({ axis: axis });
  }

  showTool(name, on) {
    if (on) this.state.hidden.delete(name); else this.state.hidden.add(name);
    this.update();
  }

  /** Corners of the cavities; of all powder where a run has none. */
  bounds() {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const run of this.runs) {
      const box = run.cavity && run.cavity.lower ? run.cavity : powderBox(run);
      for (let n = 0; n < 3; ++n) { low[n] = Math.min(low[n], box.lower[n]); high[n] = Math.max(high[n], box.upper[n]); }
    }
    return [low, high];
  }

  frameCavity() {
    const [low, high] = this.bounds(), rise = 0.3 * (high[2] - low[2]);
    this.camera.frame(low, [high[0], high[1], high[2] + rise]);
  }

  frameAll() {
    const boxes = this.runs.map(powderBox);
    this.camera.frame([0, 1, 2].map((n) => Math.min(...boxes.map((box) => box.lower[n]))),
      [0, 1, 2].map((n) => Math.max(...boxes.map((box) => box.upper[n]))));
  }

  step(by) {
    const count = this.times.length;
    this.timeSlider.value = (this.state.instant + by + count) % count;
    this.timeSlider.dispatchEvent(new Event("input"));
  }

  togglePlay() {
    this.playing = !this.playing && this.times.length > 1;
    this.playButton.textContent = this.playing ? "❚❚" : "▶";
    const next = () => { if (this.playing) { this.step(1); setTimeout(next, 120); } };
    next();
  }

  toggleTurn() {
    this.turning = !this.turning;
    this.turnButton.classList.toggle("on", this.turning);
    const next = () => { if (this.turning) { this.camera.turn(1.5, 0); setTimeout(next, 40); } };
    next();
  }

  /** What is taken away by the section: normal and distance; null without one. */
  cutPlane() {
    const { axis, place, flip } = this.state;
    if (axis < 0) return null;
    // What stands before the section as the default view sees it goes: less x or y, more z.
    const sign = (axis === 2 ? 1 : -1) * (flip ? -1 : 1), normal = [0, 0, 0];
    normal[axis] = sign;
    return new THREE.Vector4(...normal, sign * place);
  }

  update() {
    const state = this.state, plane = this.cutPlane();
    for (const cell of this.cells) {
      this.updateGrains(cell, state, plane);
      this.updateTools(cell, state, plane);
      if (cell.section) this.updateDensity(cell, state);
      cell.label.textContent = (this.runs.length > 1 ? cell.run.name + ", " : "") + "t = " + cell.frame().time.toFixed(3) + " s";
    }
    this.placeSlider.disabled = state.axis < 0;
    if (this.zonePanel) this.zonePanel.hidden = state.powder !== "zones";
    this.redraw();
  }

  updateGrains(cell, state, plane) {
    const moved = cell.seek(this.times[state.instant]) || cell.grains.onlyInside !== state.onlyInside;
    cell.grains.onlyInside = state.onlyInside;
    cell.grains.points.visible = state.powder === "grains";
    if (moved) cell.grains.move(cell.frame());
    if (moved || cell.painted !== this.quantity) cell.grains.paint(cell.frame(), this.quantity, this.scale);
    cell.painted = this.quantity;
    // Whole spheres would stand before the density on the section.
    const behind = this.showsDensity(cell, state) ? 1.05 * cell.run.largest : 0;
    cell.grains.cut(plane && state.cutPowder ? plane.clone().sub(new THREE.Vector4(0, 0, 0, behind)) : null);
  }

  updateTools(cell, state, plane) {
    const cut = plane && state.cutTools
      ? [new THREE.Plane(new THREE.Vector3(-plane.x, -plane.y, -plane.z), plane.w)] : null;
    for (const tool of cell.tools) {
      tool.group.visible = tool.shown && !state.hidden.has(tool.name);
      tool.move(cell.frame().poses[tool.number]);
      tool.setOpacity(state.opacity);
      tool.cut(cut);
    }
  }

  /** The field is that of the end. */
  showsDensity(cell, state) {
    return Boolean(cell.section) && state.axis >= 0 && state.density && cell.number === cell.run.at.length - 1;
  }

  updateDensity(cell, state) {
    const shown = cell.section.mesh.visible = this.showsDensity(cell, state);
    const key = [state.axis, state.place, state.bands, this.scale.lower, this.scale.upper].join();
    if (shown && cell.sectionKey !== key) {
      cell.section.draw(state.axis, state.place, this.fractionScale(), state.bands ? this.bandWidth() : 0);
      cell.sectionKey = key;
    }
    const zones = state.powder === "zones";
    cell.loose.mesh.visible = cell.dense.mesh.visible = zones;
    if (!zones) return;
    const loose = (value) => value < state.loose, dense = (value) => value > state.dense;
    if (cell.looseKey !== state.loose) cell.loose.show(loose);
    if (cell.denseKey !== state.dense) cell.dense.show(dense);
    cell.looseKey = state.loose; cell.denseKey = state.dense;
    this.zoneText.textContent = this.cells.map((one) => this.zoneWords(one, loose, dense)).join("\n");
  }

  zoneWords(cell, loose, dense) {
    const share = (inZone) => (100 * zoneShare(cell.run.density, inZone)).toFixed(1) + " %";
    return (this.runs.length > 1 ? cell.run.name + ": " : "") + "violet, looser: " + share(loose) + "; yellow, denser: "
      + share(dense) + " of the powder at the end";
  }

  /** The section always shows the solid fraction, whatever colours the grains. */
  fractionScale() {
    const scale = new Scale(this.scale.palette);
    [scale.lower, scale.upper] = limitsOf(this.runs, QUANTITIES[0], this.given);
    return scale;
  }

  bandWidth() {
    const scale = this.fractionScale();
    return roundStep(scale.upper - scale.lower, 8);
  }

  /** Gives every run its part of the canvas: side by side, below each other where it is narrow. */
  arrange() {
    this.pointer.tip.hidden = true;  // its place was that of the old width
    const width = this.stage.clientWidth, count = this.cells.length;
    const columns = Math.max(1, Math.min(count, Math.floor(width / 300), count === 4 ? 2 : 3)), rows = Math.ceil(count / columns);
    const across = width / columns, high = Math.min(Math.round(across * (count > 1 ? 0.95 : 0.75)), 620);
    this.canvas.style.height = rows * high + "px";
    this.cells.forEach((cell, n) => {
      cell.x = (n % columns) * across; cell.y = Math.floor(n / columns) * high;
      cell.width = across; cell.height = high;
      cell.label.style.left = cell.x + 8 + "px"; cell.label.style.top = cell.y + 6 + "px";
      cell.label.style.maxWidth = across - 70 + "px";
    });
    this.renderer.setSize(width, rows * high, false);
    this.redraw();
  }

  redraw() {
    this.stale = true;
    if (this.drawing) return;
    this.drawing = true;
    requestAnimationFrame(() => this.draw(this.slow ? 0.5 : 1));
  }

  draw(fineness) {
    const start = performance.now(), total = this.canvas.clientHeight;
    this.stale = false;
    if (!this.cells[0].width || !total) { this.drawing = false; return; }
    this.renderer.setPixelRatio(fineness);
    this.clearAll();
    for (const cell of this.cells) {
      this.camera.shape(cell.width / cell.height);
      const uniforms = cell.grains.material.uniforms;
      uniforms.pixels.value = this.camera.scale(cell.height) * fineness;
      uniforms.span.value = this.camera.span;
      const place = [cell.x, total - cell.y - cell.height, cell.width, cell.height];
      this.renderer.setViewport(...place);
      this.renderer.setScissor(place[0], place[1], place[2] - 1, place[3] - 1);
      this.renderer.render(cell.scene, this.camera.eye);
    }
    this.marks.axes.show(this.camera.eye);
    this.marks.bar.show(this.camera.scale(this.cells[0].height));
    this.whenDrawn(() => {
      this.root.dataset.drawn = Number(this.root.dataset.drawn || 0) + 1;
      this.drawing = false;
      if (this.stale) this.redraw(); else this.refine(fineness, performance.now() - start);
    });
  }

  /** Calls `then` once the picture is there; the page is not held up meanwhile. */
  whenDrawn(then) {
    const gl = this.renderer.getContext(), fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const look = () => {
      if (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) { setTimeout(look, 4); return; }
      gl.deleteSync(fence);
      then();
    };
    setTimeout(look);
  }

  /** Coarse while it moves on a slow machine; at rest as fine as the machine draws in a moment. */
  refine(fineness, lasted) {
    clearTimeout(this.later);
    if (fineness <= 1) this.slow = lasted > (fineness < 1 ? 60 : 150);
    const finer = fineness < 1 ? 1 : fineness === 1 && lasted < 700 ? 2 : 0;
    if (finer) this.later = setTimeout(() => { if (!this.playing && !this.turning) this.draw(finer); }, 250);
  }

  /** The lines between the runs. */
  clearAll() {
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(this.cells.length > 1 ? 0xc9ced6 : 0xffffff);
    this.renderer.clear();
    this.renderer.setClearColor(0xffffff);
    this.renderer.setScissorTest(true);
  }
}

/** Corners of the powder at the end, mm. */
function powderBox(run) {
  const frame = run.at[run.at.length - 1], low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let g = 0; g < run.grains; ++g) {
    const centre = centreOf(run, frame, g);
    for (let n = 0; centre && n < 3; ++n) { low[n] = Math.min(low[n], centre[n]); high[n] = Math.max(high[n], centre[n]); }
  }
  return low[0] <= high[0] ? { lower: low, upper: high } : { lower: [-1, -1, -1], upper: [1, 1, 1] };
}

/** The times of all runs' instants, rising, each once. */
function allTimes(runs) {
  const times = [].concat(...runs.map((run) => run.at.map((frame) => frame.time))).sort((a, b) => a - b);
  return times.filter((time, n) => n === 0 || time - times[n - 1] > 1e-9);
}
