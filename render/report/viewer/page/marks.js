// What makes the picture readable: colour bar, axes, scale bar, names of runs.

/** The colour scale with its ticks. */
class Legend {
  constructor(parent) {
    this.box = addElement(parent, "div", "legend");
    this.title = addElement(this.box, "div", "title");
    this.bar = addElement(this.box, "div", "bar");
    this.ticks = addElement(this.box, "div", "ticks");
    this.none = addElement(this.box, "div", "none");
  }

  show(quantity, scale) {
    this.title.textContent = quantity.name + (quantity.unit ? " [" + quantity.unit + "]" : "");
    const stops = [];
    for (let n = 0; n <= 16; ++n) stops.push(scale.css(n / 16));
    this.bar.style.background = "linear-gradient(to right, " + stops.join(", ") + ")";
    this.ticks.textContent = "";
    const { step, values } = ticksBetween(scale.lower, scale.upper, 5);
    for (const value of values) {
      const tick = addElement(this.ticks, "span", "", inStepsOf(value, step));
      tick.style.left = 100 * (value - scale.lower) / (scale.upper - scale.lower) + "%";
    }
    this.none.textContent = quantity.none ? "grey: " + quantity.none : "";
  }
}

function svgElement(parent, kind, attributes) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", kind);
  for (const name of Object.keys(attributes)) element.setAttribute(name, attributes[name]);
  parent.appendChild(element);
  return element;
}

/** The directions of x, y and z. */
class Axes {
  constructor(parent) {
    const svg = svgElement(parent, "svg", { class: "axes", viewBox: "-40 -40 80 80", "aria-hidden": "true" });
    this.parts = [["x", "#b03030"], ["y", "#2c7a3a"], ["z", "#2b4fa0"]].map(([name, colour]) => {
      const line = svgElement(svg, "line", { x1: 0, y1: 0, stroke: colour, "stroke-width": 2.5 });
      const text = svgElement(svg, "text", { fill: colour, "text-anchor": "middle", "dominant-baseline": "central" });
      text.textContent = name;
      return { line: line, text: text };
    });
  }

  show(eye) {
    const turn = new THREE.Matrix3().setFromMatrix4(eye.matrixWorldInverse);
    this.parts.forEach((part, n) => {
      const axis = new THREE.Vector3().setComponent(n, 1).applyMatrix3(turn);
      part.line.setAttribute("x2", 24 * axis.x); part.line.setAttribute("y2", -24 * axis.y);
      part.text.setAttribute("x", 33 * axis.x); part.text.setAttribute("y", -33 * axis.y);
    });
  }
}

/** A round length in the picture's scale. */
class ScaleBar {
  constructor(parent) {
    this.box = addElement(parent, "div", "scale");
    this.line = addElement(this.box, "div", "line");
    this.text = addElement(this.box, "div");
  }

  show(pixelsPerMillimetre) {
    const length = roundStep(110 / pixelsPerMillimetre, 1) / 2 < 70 / pixelsPerMillimetre
      ? roundStep(70 / pixelsPerMillimetre, 1) : roundStep(110 / pixelsPerMillimetre, 1) / 2;
    this.line.style.width = length * pixelsPerMillimetre + "px";
    this.text.textContent = inDigits(length, 3) + " mm";
  }
}
