// Brings the page's views to life. Where a browser cannot, the still pictures stay.

async function startView(root) {
  const description = JSON.parse(root.querySelector(".description").textContent);
  const data = [...root.querySelectorAll(".data")];
  const runs = await Promise.all(description.runs.map((run, n) => unpackRun(run, data[n].textContent)));
  const place = document.createElement("div");
  place.className = "viewer";
  root.prepend(place);
  try {
    root.view = new View(place, runs, description);
  } catch (problem) {
    place.remove();
    throw problem;
  }
  root.classList.add("alive");
  for (const run of runs) if (run.remark) addElement(root, "p", "note", (runs.length > 1 ? run.name + ": " : "") + run.remark);
}

for (const root of document.querySelectorAll(".view3d")) {
  const test = document.createElement("canvas");
  const able = window.DecompressionStream && window.ResizeObserver && test.getContext("webgl2");
  if (able) startView(root).catch((problem) => { root.dataset.problem = String(problem); });
  else root.dataset.problem = "this browser has no WebGL";
}
