// The parallel view that all runs share: presets, framing, mouse and touch by OrbitControls, keys.

/** Azimuth and elevation of the eye in degrees, as `diefill map --camera` has them. */
const PRESETS = { front: [0, 20], side: [90, 20], corner: [35, 30], above: [0, 60], top: [0, 90] };
const HIGHEST = 89.9;  // degrees: straight down, up would be undefined

class Camera {
  /** `canvas`: what is dragged; `changed`: called when the view has. */
  constructor(canvas, changed) {
    this.changed = changed;
    this.eye = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 1);
    this.eye.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.eye, canvas);
    this.controls.screenSpacePanning = true;
    this.controls.enableKeys = false;
    this.controls.enableZoom = false;  // the wheel scrolls the page until the view has the focus
    this.controls.addEventListener("change", changed);
    canvas.addEventListener("focus", () => { this.controls.enableZoom = true; });
    canvas.addEventListener("blur", () => { this.controls.enableZoom = false; });
    canvas.addEventListener("touchstart", () => { this.controls.enableZoom = true; }, { capture: true, passive: true });
    this.half = 1;
    this.azimuth = 0; this.elevation = 20;
  }

  /** Frames a box (mm) so that it fills the view from everywhere. */
  frame(lower, upper) {
    const size = Math.max(1e-3, Math.hypot(...lower.map((low, n) => upper[n] - low)));
    this.half = 0.58 * size;
    this.span = 40 * size;
    this.eye.near = 0; this.eye.far = this.span;
    this.eye.zoom = 1;
    this.controls.target.set(...lower.map((low, n) => 0.5 * (low + upper[n])));
    this.look(this.azimuth, this.elevation);
  }

  look(azimuth, elevation) {
    const turn = azimuth * Math.PI / 180, tilt = Math.min(HIGHEST, Math.max(-HIGHEST, elevation)) * Math.PI / 180;
    const direction = new THREE.Vector3(Math.sin(turn) * Math.cos(tilt), -Math.cos(turn) * Math.cos(tilt), Math.sin(tilt));
    this.eye.position.copy(this.controls.target).addScaledVector(direction, 0.5 * this.span);
    this.eye.lookAt(this.controls.target);
    this.controls.update();
    this.changed();
  }

  /** Where the eye is, degrees. */
  direction() {
    const to = this.eye.position.clone().sub(this.controls.target).normalize();
    return [Math.atan2(to.x, -to.y) * 180 / Math.PI, Math.asin(Math.max(-1, Math.min(1, to.z))) * 180 / Math.PI];
  }

  turn(aside, up) {
    const [azimuth, elevation] = this.direction();
    this.look(azimuth + aside, elevation + up);
  }

  zoom(factor) {
    this.eye.zoom = Math.max(0.05, Math.min(200, this.eye.zoom * factor));
    this.changed();
  }

  /** For a view of this width over height; a narrow one keeps its width. */
  shape(aspect) {
    const half = this.half / Math.min(1, aspect);
    this.eye.top = half; this.eye.bottom = -half;
    this.eye.left = -half * aspect; this.eye.right = half * aspect;
    this.eye.updateProjectionMatrix();
  }

  /** Picture points a mm, in a view so many points high. */
  scale(height) {
    return height * this.eye.zoom / (this.eye.top - this.eye.bottom);
  }

  /** Origin and direction of what lies under a place of the view, each coordinate from -1 to 1. */
  ray(x, y) {
    const direction = this.eye.getWorldDirection(new THREE.Vector3());
    return { origin: new THREE.Vector3(x, y, -1).unproject(this.eye), direction: direction };
  }
}

/** Keys on the focused view: what each does. */
function keyActions(view) {
  const camera = view.camera;
  return {
    ArrowLeft: () => camera.turn(-5, 0), ArrowRight: () => camera.turn(5, 0),
    ArrowUp: () => camera.turn(0, 5), ArrowDown: () => camera.turn(0, -5),
    "+": () => camera.zoom(1.15), "=": () => camera.zoom(1.15), "-": () => camera.zoom(1 / 1.15),
    Home: () => view.frameCavity(), " ": () => view.togglePlay(),
    ",": () => view.step(-1), ".": () => view.step(1),
    "1": () => camera.look(...PRESETS.front), "2": () => camera.look(...PRESETS.side),
    "3": () => camera.look(...PRESETS.corner), "4": () => camera.look(...PRESETS.above),
    "5": () => camera.look(...PRESETS.top)
  };
}

function obeyKeys(canvas, view) {
  const actions = keyActions(view);
  canvas.addEventListener("keydown", (event) => {
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    action();
  });
}
