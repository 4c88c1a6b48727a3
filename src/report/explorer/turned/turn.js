"use strict";
// A scene in space, turned by hand: drawn from a direction as `slipproof draw --from` draws it. Arrows are as long in
// pixels from everywhere: what belongs to an anchor is scaled about it.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const plus = (a, b) => a.map((x, i) => x + b[i]);
const times = (k, a) => a.map((x) => k * x);
const minus = (a, b) => plus(a, times(-1, b));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(1 / Math.sqrt(dot(a, a)), a);
const direction = (azimuth, elevation) => {
  const [a, e] = [azimuth, elevation].map((degrees) => degrees * Math.PI / 180);
  return [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
};

function viewFrom(scene, from) {
  const towards = unit(from), near = (v) => Math.sqrt(dot(v, v)) < 1e-6;
  const right = unit([scene.up, [0, 1, 0], [0, 0, 1]].map((up) => cross(up, towards)).find((v) => !near(v)));
  const up = cross(towards, right), flat = scene.corners.map((p) => [dot(right, p), dot(up, p)]);
  const ends = [0, 1].map((i) => [Math.min(...flat.map((p) => p[i])), Math.max(...flat.map((p) => p[i]))]);
  const sizes = ends.map(([low, high]) => high - low), scales = [0, 1].filter((i) => sizes[i] > 0);
  const scale = Math.min(...scales.map((i) => scene.size[i] / sizes[i]), scales.length > 0 ? Infinity : 1);
  const middle = ends.map(([low, high]) => (low + high) / 2);
  const pixel = (p) => [scale * (dot(right, p) - middle[0]), -scale * (dot(up, p) - middle[1])];
  return { towards, scale, pixel, near: (anchor, p) => pixel(plus(anchor, times(scene.scale / scale, minus(p, anchor)))) };
}

// Of two solids that a face keeps apart, whose face is seen is in front of the other or behind it.
function beyondAFace(one, other, towards) {
  let best = { by: -Infinity, seen: false };
  for (const face of one.faces) {
    const facing = dot(face.normal, towards);
    for (const side of one.faces.length === 1 ? [1, -1] : [1]) {
      const least = Math.min(...other.corners.map((p) => side * dot(face.normal, minus(p, one.corners[face.corners[0]]))));
      if (Math.abs(facing) > 1e-9 && least > best.by) best = { by: least, seen: side * facing > 0 };
    }
  }
  return best;
}
const middleOf = (corners) => times(1 / corners.length, corners.reduce(plus));
function isInFront(one, other, towards) {
  const a = beyondAFace(one, other, towards), b = beyondAFace(other, one, towards);
  if (Math.max(a.by, b.by) > -1e-6 * (one.extent + other.extent)) return !(a.by >= b.by ? a.seen : !b.seen);
  return dot(towards, middleOf(other.corners)) <= dot(towards, middleOf(one.corners));
}
function paintingOrder(pieces, towards) {
  const hides = pieces.map(() => []), order = [];
  pieces.forEach((one, i) => pieces.slice(i + 1).forEach((other, k) => {
    hides[i][i + 1 + k] = isInFront(one, other, towards), hides[i + 1 + k][i] = !hides[i][i + 1 + k];
  }));
  const left = new Set(pieces.keys());
  while (left.size > 0) {
    const behind = (i) => [...left].filter((j) => hides[i][j]).length;
    const next = [...left].reduce((best, i) => behind(i) < behind(best) ? i : best);
    left.delete(next), order.push(next);
  }
  return order;
}

const escaped = (text) => text.replace(/[&<"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", '"': "&quot;" })[c]);
const path = (points, end) => points.map((p, i) => (i ? "L" : "M") + p.map((x) => x.toFixed(1)).join()).join("") + end;
const element = (name, css, values) =>
  `<${name} class="${css}"${Object.entries(values).map(([key, value]) => ` ${key}="${value}"`).join("")}/>`;

function arrow([x, y], [dx, dy], css, dashes) {
  const length = Math.hypot(dx, dy), head = Math.min(8, length), [ux, uy] = [dx / length, dy / length];
  if (length < 1) return "";
  const [bx, by] = [x + dx - head * ux, y + dy - head * uy], w = 0.45 * head;
  const shaft = { x1: x, y1: y, x2: bx, y2: by, ...(dashes ? { "stroke-dasharray": dashes } : {}) };
  const tip = path([[x + dx, y + dy], [bx - w * uy, by + w * ux], [bx + w * uy, by - w * ux]], "Z");
  return `<g class="${css}">` + element("line", "", shaft) + element("path", "", { stroke: "none", d: tip }) + "</g>";
}

function hullOf(points) {
  const half = (sorted) => sorted.reduce((hull, p) => {
    const turns = (a, b) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    while (hull.length > 1 && turns(hull[hull.length - 2], hull[hull.length - 1]) <= 0) hull.pop();
    return [...hull, p];
  }, []).slice(0, -1);
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  return [...half(sorted), ...half(sorted.reverse())];
}

function pieceDrawn(scene, piece, view) {
  const { towards, pixel } = view, seen = (face) => dot(face.normal, towards) > 1e-9;
  const light = unit(plus(plus(times(0.55, towards), times(0.8, scene.up)), times(0.35, cross(towards, scene.up))));
  const shade = (face) => "shade" + Math.floor(Math.min(Math.max((1 + dot(face.normal, light)) / 2, 0), 0.999) * 16);
  const faces = piece.faces.filter((face) => piece.faces.length === 1 || seen(face)).map((face) =>
    element("path", piece.floor ? "floor" : shade(face), { d: path(face.corners.map((c) => pixel(piece.corners[c])), "Z") }));
  const shadows = dot(scene.up, towards) > 0 ? piece.shadows.map((shadow) => element("path", "shadow", { d: path(shadow.map(pixel), "Z") })) : [];
  let front = "", behind = "";
  for (const edge of piece.edges) {
    const facing = edge.faces.filter((face) => seen(piece.faces[face])).length, flat = edge.faces.length === 1;
    if (edge.smooth && facing !== 1 && !flat) continue;
    const line = path([edge.from, edge.to].map((c) => pixel(piece.corners[c])), "");
    facing > 0 || flat ? front += line : behind += line;
  }
  const opacity = piece.floor ? (dot(piece.faces[0].normal, towards) < 0 ? 0.5 : 1) : 1;
  return `<g opacity="${opacity}"><g opacity="${piece.floor ? 1 : 0.86}">${faces.join("")}</g>${shadows.join("")}` +
    (behind && element("path", "hidden", { d: behind })) +
    (front && element("path", piece.floor ? "measure" : "rim", { d: front })) + "</g>";
}

function jointDrawn(joint, view) {
  const [at, to] = [joint.at, joint.to].map(view.pixel), reach = 13 / view.scale;
  const along = (axis) => [-reach, reach].map((k) => view.pixel(plus(joint.at, times(k, axis))));
  const axes = joint.axes.map((axis) => element("path", "joint", { d: path(along(axis), "") })).join("");
  if (joint.mark === "line") return axes + element("path", joint.css, { d: path([at, to], "") });
  if (joint.mark === "square") return axes + element("rect", "paper rim", { x: at[0] - 3.5, y: at[1] - 3.5, width: 7, height: 7 });
  return axes + element("circle", "paper rim", { cx: at[0], cy: at[1], r: 3.5 });
}

function strokeDrawn(stroke, view) {
  const points = stroke.points.map((p) => view.near(stroke.anchor, p)), [first] = points, end = points[points.length - 1];
  if (stroke.kind === "dot") return element("circle", stroke.css, { cx: first[0], cy: first[1], r: 3 });
  if (stroke.kind === "arrow") return arrow(first, minus(end, first), stroke.css, stroke.dashes);
  if (stroke.kind === "area") return element("path", stroke.css, { d: path(points, "Z") });
  if (stroke.kind === "cone") {
    const hull = hullOf([view.pixel(stroke.anchor), ...points]);
    return hull.length < 3 ? "" : [hull, points].map((one) => element("path", stroke.css, { d: path(one, "Z") })).join("");
  }
  const last = minus(end, points[points.length - 2]), size = Math.max(Math.hypot(...last), 0.1);  // a turn
  return element("path", stroke.css, { style: "fill:none", d: path(points, ""), ...(stroke.dashes ? { "stroke-dasharray": stroke.dashes } : {}) }) +
    arrow(end, times(8 / size, last), stroke.css);
}

// Each label beside its point: the first place where it covers no other label, or the one that covers least.
function labelsDrawn(labels, view, size) {
  const taken = [], sides = [[1, -1], [1, 1], [-1, -1], [-1, 1]].flatMap(([across, down]) => [0.5, 1.5, 2.5].map((far) => [across, down * far]));
  const covered = (a, b) => Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) *
    Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));
  return labels.map(({ anchor, at, text }) => {
    const [x, y] = view.near(anchor, at), width = 0.62 * size * text.length;
    const boxes = sides.map(([across, down]) => {
      const left = across > 0 ? x + 6 : x - 6 - width, base = y + size * (down > 0 ? down + 0.4 : down);
      const box = { left, base, right: left + width, top: base - size, bottom: base };
      return { ...box, cost: taken.reduce((sum, other) => sum + covered(box, other), 0) };
    });
    const best = boxes.reduce((a, b) => b.cost < a.cost ? b : a);
    taken.push(best);
    return `<text class="ink halo" x="${best.left.toFixed(1)}" y="${best.base.toFixed(1)}" font-size="${size}">${escaped(text)}</text>`;
  });
}

// The SVG inside of the picture of a motion, with letters of a size in its pixels.
function drawn(scene, motion, from, letters = 12) {
  const view = viewFrom(scene, from);
  const sticks = scene.sticks.map((ends) => ends.map(view.pixel)).map(([[x, y], [toX, toY]]) => x === toX && y === toY
    ? element("circle", "ink", { cx: x, cy: y, r: 2.5 }) : element("path", "body", { d: path([[x, y], [toX, toY]], "") }));
  return [...paintingOrder(scene.pieces, view.towards).map((i) => pieceDrawn(scene, scene.pieces[i], view)), ...sticks,
    ...scene.joints.map((joint) => jointDrawn(joint, view)), ...motion.strokes.map((stroke) => strokeDrawn(stroke, view)),
    ...labelsDrawn(motion.labels, view, letters)].join("\n");
}

if (typeof module !== "undefined") module.exports = { direction, drawn };
