"use strict";
// Everything on the page can be read without this script; it adds pointing, the keyboard, and printing.
(function () {
  const element = function (name, text, css) {
    const made = document.createElement(name);
    if (text !== undefined) made.textContent = text;
    if (css) made.className = css;
    return made;
  };

  // Where the plot is inside of its picture, in the picture's own units.
  const plotOf = function (svg) {
    const numbers = svg.dataset.plot.split(" ").map(Number);
    return { left: numbers[0], top: numbers[1], width: numbers[2], height: numbers[3] };
  };

  const describe = function (tip, data, point) {
    tip.replaceChildren(element("p", data.x + " = " + data.xs[point[0]][1] + ",  " + data.y + " = " + data.ys[point[1]][1]));
    point[2].forEach(function (motion) {
      const modes = data.modes[motion[0]];
      tip.append(element("p", modes[0].join(" = ") + (modes[1] ? "" : " (boundary)"), "motion"));
      const values = element("dl");
      data.names.forEach(function (name, i) {
        const value = motion[1][i];
        if (value !== 0) values.append(element("dt", name), element("dd", value === null ? "undetermined" : value));
      });
      tip.append(values);
    });
    point[3].forEach(function (mode) {
      tip.append(element("p", mode + " (continuum)", "motion"));
    });
    if (point[2].length + point[3].length === 0) tip.append(element("p", "no motion", "motion"));
  };

  document.querySelectorAll("script.points").forEach(function (points) {
    const figure = points.parentElement;
    const plot = figure.querySelector(".plot");
    const svg = plot.querySelector("svg");
    const data = JSON.parse(points.textContent);
    if (data.points.length === 0) return;
    const tip = element("div", "", "tip");
    tip.setAttribute("aria-live", "polite");
    tip.hidden = true;
    const dot = document.createElementNS("http://www.w3.org/2000/svg", "circle");
    dot.setAttribute("r", "4.5");
    dot.setAttribute("class", "ink halo");
    plot.append(tip);
    plot.tabIndex = 0;
    plot.setAttribute("role", "application");
    plot.setAttribute("aria-label", "Motions at points of the diagram: arrow keys go from point to point");
    figure.querySelector(".legend").after(element("p", "Point at the diagram, or focus it and use the arrow keys: exact values at " + data.points.length + " points.", "hint"));
    const shareOf = function (entry) { return entry[0]; };
    const columns = data.xs.map(shareOf), rows = data.ys.map(shareOf);
    const at = new Map(data.points.map(function (p) { return [p[0] + " " + p[1], p]; }));
    let column = Math.floor(columns.length / 2), row = Math.floor(rows.length / 2);

    const show = function () {
      const point = at.get(column + " " + row);
      if (point === undefined) return;
      const frame = plotOf(svg);
      const x = frame.left + columns[column] * frame.width;
      const y = frame.top + (1 - rows[row]) * frame.height;
      dot.setAttribute("cx", x);
      dot.setAttribute("cy", y);
      svg.append(dot);
      describe(tip, data, point);
      tip.hidden = false;
      const box = svg.getBoundingClientRect(), outer = plot.getBoundingClientRect();
      const scale = box.width / svg.viewBox.baseVal.width;
      // On a narrow screen a large diagram is wider than its frame, and scrolls in it.
      const px = box.left - outer.left + x * scale, py = box.top - outer.top + y * scale;
      const right = px + 16 + tip.offsetWidth;
      const left = Math.max(4, right - outer.width + 4 >= 0 ? px - 16 - tip.offsetWidth : px + 16);
      tip.style.left = plot.scrollLeft + Math.min(left, Math.max(4, outer.width - tip.offsetWidth - 4)) + "px";
      tip.style.top = Math.max(4, Math.min(py - 20, outer.height - tip.offsetHeight - 4)) + "px";
    };
    const hide = function () {
      tip.hidden = true;
      dot.remove();
    };
    const nearest = function (list, value) {
      let best = 0;
      list.forEach(function (other, i) {
        if (Math.abs(list[best] - value) - Math.abs(other - value) >= 0) best = i;
      });
      return best;
    };
    plot.addEventListener("pointermove", function (event) {
      const box = svg.getBoundingClientRect(), frame = plotOf(svg);
      const scale = svg.viewBox.baseVal.width / box.width;
      column = nearest(columns, ((event.clientX - box.left) * scale - frame.left) / frame.width);
      row = nearest(rows, 1 - ((event.clientY - box.top) * scale - frame.top) / frame.height);
      show();
    });
    plot.addEventListener("pointerleave", function () {
      if (document.activeElement !== plot) hide();
    });
    plot.addEventListener("focus", show);
    plot.addEventListener("blur", hide);
    plot.addEventListener("keydown", function (event) {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (event.key === "Escape") hide();
      if (!step) return;
      event.preventDefault();
      column = Math.min(Math.max(column + step[0], 0), columns.length - 1);
      row = Math.min(Math.max(row + step[1], 0), rows.length - 1);
      show();
      const box = dot.getBoundingClientRect(), outer = plot.getBoundingClientRect();
      if (box.left - outer.left - 20 < 0 || box.right - outer.right + 20 >= 0) {
        plot.scrollLeft += (box.left + box.right - outer.left - outer.right) / 2;
        show();
      }
    });
  });

  // What a link leads to is open.
  const reveal = function () {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target === null) return;
    if (target.classList.contains("claim")) document.getElementById("show-all").checked = true;
    if (target.tagName === "DETAILS") target.open = true;
    target.scrollIntoView();
  };
  window.addEventListener("hashchange", reveal);
  if (location.hash) reveal();

  // Paper does not unfold: on demand all is printed open.
  const opened = [];
  window.addEventListener("beforeprint", function () {
    const all = document.getElementById("print-all");
    if (all === null || !all.checked) return;
    document.querySelectorAll("details:not([open])").forEach(function (details) {
      details.open = true;
      opened.push(details);
    });
  });
  window.addEventListener("afterprint", function () {
    opened.splice(0).forEach(function (details) { details.open = false; });
  });
})();
