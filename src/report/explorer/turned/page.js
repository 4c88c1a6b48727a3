"use strict";
const scene = JSON.parse(document.getElementById("scene").textContent);
const at = (id) => document.getElementById(id);
const [width, height] = [scene.size[0] + 170, scene.size[1] + 160], least_letters = 12;  // room for arrows; pixels of the window
let [azimuth, elevation] = scene.from, shown = 0, held = null;

function show() {
  const motion = scene.motions[shown];
  const letters = least_letters * Math.max(1, width / (at("picture").getBoundingClientRect().width || width));
  at("picture").innerHTML = drawn(scene, motion, direction(azimuth, elevation), letters);
  at("kind").textContent = motion.kind;
  at("from").textContent = `--from=${Math.round(azimuth * 10) / 10},${Math.round(elevation * 10) / 10}`;
  at("numbers").replaceChildren(...motion.rows.map((cells) => {
    const row = document.createElement("tr");
    row.append(...cells.map((text, i) => Object.assign(document.createElement(i ? "td" : "th"), { textContent: text })));
    return row;
  }));
  [...at("tabs").children].forEach((tab, i) => {
    tab.setAttribute("aria-selected", i === shown);
    tab.tabIndex = i === shown ? 0 : -1;
  });
}
function turn(right, up) {
  azimuth = (azimuth - right + 540) % 360 - 180;
  elevation = Math.min(90, Math.max(-90, elevation + up));
  show();
}

at("name").textContent = document.title = scene.name;
at("subject").textContent = scene.counted;
at("tabs").append(...scene.motions.map((motion, i) => {
  const tab = Object.assign(document.createElement("button"), { type: "button", textContent: motion.heading });
  tab.setAttribute("role", "tab");
  tab.addEventListener("click", () => { shown = i; show(); });
  return tab;
}));
at("tabs").addEventListener("keydown", (event) => {
  const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!by) return;
  shown = (shown + by + scene.motions.length) % scene.motions.length;
  show();
  at("tabs").children[shown].focus();
});
const picture = at("picture");
picture.setAttribute("viewBox", [-width / 2, -height / 2, width, height].join(" "));
addEventListener("resize", show);
picture.addEventListener("pointerdown", (event) => {
  held = [event.clientX, event.clientY];
  picture.setPointerCapture(event.pointerId);
});
picture.addEventListener("pointermove", (event) => {
  if (held === null) return;
  turn((event.clientX - held[0]) / 2, (event.clientY - held[1]) / 2);
  held = [event.clientX, event.clientY];
});
for (const end of ["pointerup", "pointercancel"]) picture.addEventListener(end, () => { held = null; });
picture.addEventListener("keydown", (event) => {
  const by = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] }[event.key];
  if (!by) return;
  event.preventDefault();
  turn(...by);
});
at("reset").addEventListener("click", () => { [azimuth, elevation] = scene.from; show(); });
show();
