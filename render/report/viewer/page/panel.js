// The controls beside the view, as elements of the page.

function addElement(parent, kind, name, text) {
  const element = document.createElement(kind);
  if (name) element.className = name;
  if (text !== undefined) element.textContent = text;
  parent.appendChild(element);
  return element;
}

function addGroup(panel, title) {
  const group = addElement(panel, "fieldset");
  addElement(group, "legend", "", title);
  return group;
}

function addButton(parent, name, text, act) {
  const button = addElement(parent, "button", "", text);
  button.type = "button";
  button.dataset.control = name;
  button.addEventListener("click", act);
  return button;
}

function addCheck(parent, name, text, checked, act) {
  const label = addElement(parent, "label", "check"), box = addElement(label, "input");
  box.type = "checkbox"; box.checked = checked; box.dataset.control = name;
  label.append(text);
  box.addEventListener("change", () => act(box.checked));
  return box;
}

function addChoice(parent, name, text, choices, act) {
  const label = addElement(parent, "label", "row", text), select = addElement(label, "select");
  select.dataset.control = name;
  for (const [value, words] of choices) addElement(select, "option", "", words).value = value;
  select.addEventListener("change", () => act(select.value));
  return select;
}

/** A slider with its value beside it, which `words` puts as text. */
function addSlider(parent, name, text, range, words, act) {
  const label = addElement(parent, "label", "row", text), slider = addElement(label, "input");
  slider.type = "range"; slider.dataset.control = name;
  const output = addElement(label, "output");
  slider.setRange = (low, high, step, value) => {
    slider.min = low; slider.max = high; slider.step = step; slider.value = value;
    output.textContent = words(Number(slider.value));
  };
  slider.setRange(...range);
  slider.addEventListener("input", () => { output.textContent = words(Number(slider.value)); act(Number(slider.value)); });
  return slider;
}

function cameraControls(panel, view) {
  const group = addElement(addGroup(panel, "View"), "div", "buttons");
  for (const name of Object.keys(PRESETS)) addButton(group, "camera-" + name, name, () => view.camera.look(...PRESETS[name]));
  addButton(group, "camera-cavity", "cavity", () => view.frameCavity());
  addButton(group, "camera-all", "all", () => view.frameAll());
  view.turnButton = addButton(group, "turn", "turn", () => view.toggleTurn());
}

function powderControls(panel, view) {
  const group = addGroup(panel, "Powder"), runs = view.runs;
  const shows = [["grains", "grains"]];
  if (view.hasDensity) shows.push(["zones", "density zones"]);
  shows.push(["nothing", "nothing"]);
  addChoice(group, "powder", "Show", shows, (value) => view.set({ powder: value }));
  const offered = QUANTITIES.filter((quantity) => worthOffering(runs, quantity));
  addChoice(group, "colour", "Colour", offered.map((quantity) => [quantity.key, quantity.name]),
    (key) => view.setQuantity(QUANTITIES.find((quantity) => quantity.key === key)));
  addCheck(group, "inside", "only what ends in the cavity", false, (on) => view.set({ onlyInside: on }));
  if (!view.hasDensity) return;
  const zones = view.zonePanel = addElement(group, "div", "zones");
  const range = view.zoneRange();
  for (const key of ["loose", "dense"])
    addSlider(zones, key, key === "loose" ? "Looser than" : "Denser than", [range[0], range[1], 0.001, view.state[key]],
      (value) => value.toFixed(3), (value) => view.set({ [key]: value }));
  view.zoneText = addElement(zones, "p", "shares");
}

function sectionControls(panel, view) {
  const group = addGroup(panel, "Section");
  const axes = [["", "none"], ["0", "across x"], ["1", "across y"], ["2", "across z"]];
  addChoice(group, "section", "Cut", axes, (value) => view.setAxis(value === "" ? -1 : Number(value)));
  view.placeSlider = addSlider(group, "place", "At", [0, 1, 0.1, 0], (value) => value.toFixed(1) + " mm",
    (value) => view.set({ place: value }));
  addCheck(group, "flip", "keep the other side", false, (on) => view.set({ flip: on }));
  addCheck(group, "cut-powder", "cut powder", true, (on) => view.set({ cutPowder: on }));
  addCheck(group, "cut-tools", "cut tools", true, (on) => view.set({ cutTools: on }));
  if (!view.hasDensity) return;
  addCheck(group, "density", "averaged density at the end", true, (on) => view.set({ density: on }));
  addCheck(group, "bands", "in bands", false, (on) => view.set({ bands: on }));
}

function toolControls(panel, view) {
  const group = addGroup(panel, "Tools"), names = [];
  for (const run of view.runs) for (const tool of run.tools) if (tool.shown && !names.includes(tool.name)) names.push(tool.name);
  for (const name of names) addCheck(group, "tool-" + name, name, true, (on) => view.showTool(name, on));
  addSlider(group, "opacity", "Opacity", [5, 100, 5, 25], (value) => value + " %", (value) => view.set({ opacity: value / 100 }));
}

/** Below the view: play and the slider over the instants that were kept. */
function timeControls(parent, view) {
  const bar = addElement(parent, "div", "time");
  view.playButton = addButton(bar, "play", "▶", () => view.togglePlay());
  view.playButton.setAttribute("aria-label", "play");
  view.timeSlider = addSlider(bar, "time", "", [0, view.times.length - 1, 1, view.times.length - 1],
    (n) => "t = " + view.times[n].toFixed(3) + " s", (n) => view.set({ instant: n }));
  view.timeSlider.setAttribute("aria-label", "instant");
  if (view.times.length < 2) bar.hidden = true;
}
