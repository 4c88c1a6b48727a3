'use strict';
// The page: values that are dragged, and what the library answers. Every number is the library's; the page only counts
// the steps of a slider.
(() => {
const by = id => document.getElementById(id);
const linked = scenePart(location.hash);
let given = JSON.parse(by('given').textContent);
const front = 'front' in document.body.dataset;  // of the site
const svgNamespace = 'http://www.w3.org/2000/svg';

let compiled, library, answerer, mapper, original, current;
let rows = new Map();   // by symbol
let changed = {};       // texts of numbers by symbol; null: no value
let across = '';        // the horizontal axis of the diagram
let mapped = null;      // the diagram that is shown
let pending = false;

// ---- the values

function addRow(value, place) {
  const id = 'value-' + rows.size;
  const number = make('input', { type: 'text', id, autocomplete: 'off', spellcheck: false });
  number.setAttribute('aria-describedby', id + '-note');
  const row = { symbol: value.symbol, kind: value.kind, number, range: value.range, note: make('p', { id: id + '-note' }) };
  const label = make('label', { htmlFor: id, textContent: value.symbol });
  let slider = make('span');
  if (value.range) {
    row.steps = stepsOf(value.range.near);
    slider = row.slider = make('input', { type: 'range', min: row.steps.first, max: row.steps.last, step: 1 });
    slider.setAttribute('aria-label', value.symbol);
    slider.addEventListener('input', () => set(value.symbol, row.steps.text(Number(slider.value))));
  }
  number.addEventListener('change', () => {
    const text = number.value.trim();
    set(value.symbol, text === '' && value.kind === 'load' ? null : text);
  });
  row.meaning = value.meaning;
  rows.set(value.symbol, row);
  by(place).append(make('div', { className: 'row' }, label, slider, number, row.note));
}

function showValues(values) {
  for (const value of values) {
    const row = rows.get(value.symbol);
    row.value = value;
    if (document.activeElement !== row.number) put(row.number, 'value', value.value ?? '');
    row.number.removeAttribute('aria-invalid');
    if (row.slider) {
      if (value.near !== null && document.activeElement !== row.slider) put(row.slider, 'value', String(row.steps.nearest(value.near)));
      row.slider.setAttribute('aria-valuetext', spokenValue(value));
    }
    const none = value.value !== null ? '' : value.kind === 'load' ? 'every load' : 'no value';
    put(row.note, 'textContent', [none, nearText(value), row.meaning].filter(Boolean).join(' · '));
  }
}

function set(symbol, text) {
  changed[symbol] = text;
  ask();
}

// ---- what the library answers

function ask() {
  if (pending) return;
  pending = true;
  requestAnimationFrame(() => {
    pending = false;
    refresh();
  });
}

function show(answer) {
  current = answer;
  showValues(answer.values);
  showMotions(answer);
  by('scene-text').value = answer.scene;
  moveMark();
}

let answering = false, outdated = false;

// One answer at a time: while it is made, the page shows the last one, and what changes meanwhile is asked next.
function refresh() {
  outdated = answering;
  if (answering) return;
  answering = true;
  answerer.post({ request: { set: changed, every_q: false } });
}

function take({ answer, took }) {
  answering = false;
  if (outdated) ask();
  const start = performance.now();
  for (const id of ['pictures', 'numbers']) by(id).classList.toggle('stale', 'mistakes' in answer);
  by('mistakes').textContent = (answer.mistakes ?? []).join('\n');
  if (answer.mistakes) {
    for (const [symbol, { number }] of rows) {
      if (!answer.mistakes.some(text => text.startsWith(symbol + ':'))) continue;
      number.setAttribute('aria-invalid', 'true');
      number.value = changed[symbol] ?? '';
    }
    by('count').textContent = 'No answer';
    return;
  }
  show(answer);
  later('state', 250, keepState);
  later('map', 250, askForMap);
  later('calm', 150, () => drawings().forEach(drawing => drawing.classList.remove('hurried')));
  later('spoken', 700, () => { by('spoken').textContent = by('count').textContent; });
  const shown = performance.now() - start;
  by('took').textContent = `This answer took ${took.toFixed(1)} ms, its pictures ${shown.toFixed(1)} ms.`;
  window.slipproofTimes = [took, took + shown];
}

const timers = {};
function later(name, milliseconds, work) {
  clearTimeout(timers[name]);
  timers[name] = setTimeout(work, milliseconds);
}

// ---- the motions

const drawings = () => [...by('pictures').querySelectorAll('.drawing')].map(host => host.shadowRoot.firstChild);

function showMotions({ solve, pictures }) {
  by('count').textContent = countText(solve);
  const figures = [...by('pictures').children];
  pictures.forEach((picture, i) => {
    let figure = figures[i];
    if (!figure) {
      figure = make('figure', {}, make('figcaption'), make('div', { className: 'drawing' }));
      by('pictures').append(figure);
    }
    figure.children[0].textContent = picture.title;
    showDrawing(figure.children[1], picture.svg).classList.add('hurried');
  });
  figures.slice(pictures.length).forEach(figure => figure.remove());
  by('move-row').hidden = !moving.take(drawings());
  by('move-note').textContent = moving.words();
  by('numbers').replaceChildren(...tablesOf(solve));
}

// ---- the diagram

let asked = 0, waiting = false, shownKey = null, wantedKey = null;

function askForMap() {
  if (!current.solve.load) {
    by('diagram').hidden = true;
    return;
  }
  // The diagram does not depend on the values of its own axes, as long as the point is in it.
  const others = { ...changed };
  delete others[across];
  const row = rows.get(across), load = current.values.find(value => value.kind === 'load');
  const inside = !mapped || (within(row?.value?.near, mapped.frames[0].x) && within(load.near, mapped.frames[0].y));
  if (inside) delete others[load.symbol];
  else Object.assign(others, changed);
  const key = JSON.stringify([across, others]);
  if (key === wantedKey) return;
  wantedKey = key;
  if (!waiting) sendMap(key, others);
  else by('map').classList.add('stale');
}

const within = (x, axis) => x === null || x === undefined || (axis.near[0] <= x && x <= axis.near[1]);

function sendMap(key, others) {
  waiting = true;
  by('map').classList.add('stale');
  by('map-state').textContent = 'is being drawn …';
  mapper.post({ id: ++asked, key, request: { set: others, map: across } });
  mapper.key = key;
}

function showMap({ answer }) {
  waiting = false;
  shownKey = mapper.key;
  if (wantedKey !== shownKey) {
    wantedKey = null;
    askForMap();
    return;
  }
  by('map').classList.remove('stale');
  by('map-state').textContent = answer.mistakes ? answer.mistakes.join(' ') : '';
  if (answer.mistakes) {
    mapped = null;
    by('map').replaceChildren();
    return;
  }
  mapped = answer;
  by('map-note').textContent = answer.note;
  if (!by('map').firstChild) by('map').append(make('div', { className: 'drawing' }));
  mapped.drawing = showDrawing(by('map').firstChild, answer.map);
  // The diagram itself, and what is enlarged of it, each with its axes.
  [...mapped.drawing.querySelectorAll('[data-plot]')].forEach((plot, i) => {
    plot.style.touchAction = 'none';  // a finger drags the point
    Object.assign(mapped.frames[i], { plot, place: plot.dataset.plot.split(' ').map(Number) });
  });
  mapped.drawing.style.cursor = 'crosshair';
  mapped.drawing.addEventListener('pointerdown', dragInMap);
  mapped.drawing.addEventListener('pointermove', event => { if (event.buttons === 1) dragInMap(event); });
  moveMark();
}

function moveMark() {
  for (const frame of mapped?.frames ?? []) {
    frame.mark?.remove();
    frame.mark = null;
    const x = rows.get(frame.x.symbol)?.value?.near, y = rows.get(frame.y.symbol)?.value?.near;
    if (x == null || y == null || !within(x, frame.x) || !within(y, frame.y)) continue;
    const [left, top, width, height] = frame.place;
    const at = (value, [from, to]) => (value - from) / (to - from);
    const mark = document.createElementNS(svgNamespace, 'g');
    const cx = left + width * at(x, frame.x.near), cy = top + height * (1 - at(y, frame.y.near));
    for (const [radius, fill] of [[7, 'paper'], [5, 'ink']]) {
      const circle = document.createElementNS(svgNamespace, 'circle');
      for (const [name, text] of Object.entries({ cx, cy, r: radius, class: fill })) circle.setAttribute(name, text);
      mark.append(circle);
    }
    frame.plot.append(frame.mark = mark);
  }
}

function dragInMap(event) {
  for (const { x, y, plot, place: [left, top, width, height] } of mapped.frames) {
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(plot.getScreenCTM().inverse());
    const parts = [[x, (point.x - left) / width], [y, 1 - (point.y - top) / height]];
    if (parts.some(([, part]) => part < 0 || part > 1)) continue;
    for (const [axis, part] of parts) {
      const steps = stepsOf(axis.near);
      changed[axis.symbol] = steps.text(steps.nearest(axis.near[0] + part * (axis.near[1] - axis.near[0])));
    }
    event.preventDefault();
    return ask();
  }
}

// ---- a link that keeps the state

function keepState() {
  const parts = Object.entries(changed).map(([symbol, text]) => `${encodeURIComponent(symbol)}=${encodeURIComponent(text ?? '')}`);
  if (linked) parts.unshift(linked);
  if (across !== original.across) parts.push('across:=' + encodeURIComponent(across));
  const hash = parts.length ? '#' + parts.join('&') : '#';
  if (hash === (location.hash || '#')) return;
  try {
    history.replaceState(null, '', hash);
  } catch {
    location.replace(hash);
  }
}

function readState() {
  changed = {};
  across = original.across;
  for (const part of location.hash.slice(1).split('&').filter(Boolean)) {
    let [symbol, text = ''] = part.split('=');
    try {
      symbol = decodeURIComponent(symbol), text = decodeURIComponent(text);
    } catch {
      continue;
    }
    if (symbol === 'scene:') continue;
    if (symbol === 'across:') across = [...by('across').options].some(option => option.value === text) ? text : across;
    else if (rows.has(symbol)) changed[symbol] = text === '' ? null : text;
    else by('copied').textContent = `The link has a value of ${symbol}, which this scene does not have.`;
  }
  by('across').value = across;
}

function move(on) {
  moving.turn(on);
  by('move').setAttribute('aria-pressed', on);
  by('move-note').textContent = moving.words();
}

function wire() {
  by('move').addEventListener('click', () => move(!moving.isOn()));
  pasting.wire(text => library.answer({ set: changed, pasted: text }), () => current);
  by('reset').addEventListener('click', () => {
    changed = {};
    ask();
  });
  by('copy-link').addEventListener('click', () => {
    keepState();
    copy(location.href, 'Link', by('copied'));
  });
  by('copy-scene').addEventListener('click', () => copy(by('scene-text').value, 'Scene', by('copied')));
  by('copy-mechanism').addEventListener('click', () => copy(given.file, 'Mechanism', by('copied-mechanism')));
  by('across').addEventListener('change', () => {
    across = by('across').value;
    mapped = null;
    keepState();
    askForMap();
  });
  window.addEventListener('hashchange', () => {
    if (scenePart(location.hash) !== linked) return location.reload();
    readState();
    ask();
  });
}

// ---- the start

async function start() {
  if (given === null) given = sceneOf(linked);
  compiled = await unpacked(by('compiled').textContent);
  library = await openLibrary(given, compiled);
  original = library.answer({ ranges: true, every_q: false });
  if (original.mistakes) throw new Error(original.mistakes.join('\n'));
  if (!front) document.title = `${original.name} – explorer`;
  by('name').textContent = original.name;
  by('subject').textContent = `Mechanism: ${original.mechanism}. Drag a value; the motions follow, exactly.`;
  // What the diagram shows comes first: the load, and the parameter across.
  const rank = value => value.kind === 'load' ? 0 : value.symbol === original.usual ? 1 : 2;
  const ranked = [...original.values].sort((x, y) => rank(x) - rank(y));
  const first = ranked.filter(value => rank(value) < 2).length;
  const few = ranked.length <= 6 || first === 0 ? ranked.length : first;
  ranked.forEach((value, i) => addRow(value, i < few ? 'rows' : 'other-rows'));
  by('others').hidden = few === ranked.length;
  by('others').open = !front && matchMedia('(min-width: 60rem)').matches;
  const usable = original.values.filter(value => value.kind !== 'load' && value.range);
  by('across').append(...usable.map(value => make('option', { value: value.symbol, textContent: value.symbol })));
  original.across = usable.find(value => value.symbol === original.usual)?.symbol ?? usable[0]?.symbol ?? '';
  if (!usable.length) by('diagram').hidden = true;
  if (given.file) {
    by('mechanism').hidden = false;
    by('mechanism-text').value = given.file;
  }
  readState();
  wire();
  mapper = startWorker(given, compiled, library);
  mapper.listen(showMap);
  if (Object.keys(changed).length) show(original);  // it stays if the link's values are refused
  take(timed(library, { set: changed, every_q: false }));
  answerer = startWorker(given, compiled, library);
  answerer.listen(take);
  if (front && moving.startsByItself()) move(true);
  document.body.dataset.ready = 'true';
}

start().catch(error => { by('mistakes').textContent = String(error.message ?? error); });
})();
