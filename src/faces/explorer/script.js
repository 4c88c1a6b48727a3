'use strict';
// The page: values that are dragged, and what the library answers. Every number is the library's; the page only counts
// the steps of a slider.
(() => {
const given = JSON.parse(document.getElementById('given').textContent);
const by = id => document.getElementById(id);
const make = (name, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...children);
  return element;
};
const svgNamespace = 'http://www.w3.org/2000/svg';

let library, mapper, original, current;
let rows = new Map();   // by symbol
let changed = {};       // texts of numbers by symbol; null: no value
let across = '';        // the horizontal axis of the diagram
let mapped = null;      // the diagram that is shown
let pending = false;

// ---- rational steps

// About 200 steps of 1, 2 or 5 times a power of ten; the value of a step is a fraction of whole numbers.
function stepsOf([from, to]) {
  const wanted = (to - from) / 200;
  let power = Math.floor(Math.log10(wanted)), digit = 1;
  for (const d of [1, 2, 5, 10]) {
    digit = d;
    if (d * 10 ** power >= wanted) break;
  }
  const size = digit * 10 ** power;
  const text = k => power < 0 ? `${BigInt(k) * BigInt(digit)}/${10n ** BigInt(-power)}`
                              : `${BigInt(k) * BigInt(digit) * 10n ** BigInt(power)}`;
  const ten = 10 ** Math.abs(power);
  const near = k => power < 0 ? k * digit / ten : k * digit * ten;
  return { first: Math.ceil(from / size - 1e-9), last: Math.floor(to / size + 1e-9), text, near, nearest: x => Math.round(x / size) };
}

const decimal = x => x === null ? '' : String(Number(x.toPrecision(4)));
const degrees = half => decimal(2 * Math.atan(half) * 180 / Math.PI) + '°';
const isPlain = text => !text.includes('/');

function spokenValue(value) {
  if (value.value === null) return 'no value';
  if (value.kind === 'angle') return `${degrees(value.near)}, tan of the half ${value.value}`;
  return value.value + (value.unit && value.unit !== '1' ? ' ' + value.unit : '');
}

function nearText(value) {
  const parts = [];
  if (value.value !== null && value.kind === 'angle') parts.push(`tan(${value.symbol}/2); ${degrees(value.near)}`);
  else if (value.value !== null && !isPlain(value.value)) parts.push('≈ ' + decimal(value.near));
  if (value.unit && value.unit !== '1') parts.push(value.unit);
  return parts.join(' ');
}

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
    if (document.activeElement !== row.number) row.number.value = value.value ?? '';
    row.number.removeAttribute('aria-invalid');
    if (row.slider) {
      if (value.near !== null && document.activeElement !== row.slider) row.slider.value = row.steps.nearest(value.near);
      row.slider.setAttribute('aria-valuetext', spokenValue(value));
    }
    row.note.textContent = [nearText(value), row.meaning].filter(Boolean).join(' · ') ||
                           (value.value === null ? (value.kind === 'load' ? 'no value: every load' : 'no value') : '');
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

function refresh() {
  const start = performance.now();
  const answer = library.answer({ set: changed });
  const took = performance.now() - start;
  for (const id of ['pictures', 'numbers']) by(id).classList.toggle('stale', 'mistakes' in answer);
  by('mistakes').textContent = (answer.mistakes ?? []).join('\n');
  if (answer.mistakes) {
    for (const [symbol, text] of Object.entries(changed)) {
      const row = rows.get(symbol);
      if (row && text !== row.value?.value) row.number.setAttribute('aria-invalid', 'true');
    }
    by('count').textContent = 'No answer';
    return;
  }
  current = answer;
  showValues(answer.values);
  showMotions(answer);
  by('scene-text').value = answer.scene;
  moveMark();
  later('state', 250, keepState);
  later('map', 250, askForMap);
  later('spoken', 700, () => { by('spoken').textContent = by('count').textContent; });
  const shown = performance.now() - start;
  by('took').textContent = `This answer took ${took.toFixed(1)} ms, its pictures ${(shown - took).toFixed(1)} ms.`;
  window.slipproofTimes = [took, shown];
}

const timers = {};
function later(name, milliseconds, work) {
  clearTimeout(timers[name]);
  timers[name] = setTimeout(work, milliseconds);
}

// ---- the motions

// An SVG file, with its style and its ids to itself.
function showDrawing(host, svg) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
  const drawing = document.importNode(new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement, true);
  drawing.style.display = 'block';
  drawing.style.width = '100%';
  drawing.style.height = 'auto';
  root.replaceChildren(drawing);
  return drawing;
}

function countText(solve) {
  if (!solve.motions) return 'Motions by load';
  const n = solve.motions.length, continua = solve.continua?.length ?? 0;
  const motions = n === 0 ? (continua ? 'No single motion' : 'No motion') : n === 1 ? 'One motion' : `${n} motions`;
  const load = solve.load ? ` at ${solve.load.symbol} = ${solve.load.value}` : '';
  const names = solve.motions.map(motion => motion.modes[0] ?? motion.boundary_modes[0]).join(', ');
  return motions + (continua ? `, and ${continua === 1 ? 'a continuum' : continua + ' continua'}` : '') + load + (names ? `: ${names}` : '');
}

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
    showDrawing(figure.children[1], picture.svg);
  });
  figures.slice(pictures.length).forEach(figure => figure.remove());
  by('numbers').replaceChildren(solve.motions ? motionTable(solve.motions) : loadTable(solve));
}

const endText = (lower, upper, closed = [true, true]) =>
  `${lower === null || !closed[0] ? '(' : '['}${lower ?? '−∞'}, ${upper ?? '+∞'}${upper === null || !closed[1] ? ')' : ']'}`;

function fraction(text) {
  const cell = make('td', {}, text);
  const [p, q] = text.split('/');
  if (q) cell.append(make('small', { textContent: '≈ ' + decimal(Number(p) / Number(q)) }));
  return cell;
}

function motionTable(motions) {
  const table = make('table', {}, make('caption', { textContent: 'Exact values; accelerations first, then forces' }));
  const head = make('tr', {}, make('th', { scope: 'col', textContent: 'quantity' }));
  for (const motion of motions) {
    const name = motion.modes.concat(motion.boundary_modes)[0] ?? 'motion';
    head.append(make('th', { scope: 'col', textContent: name + (motion.status === 'strict' ? '' : ` (${motion.status})`) }));
  }
  const body = make('tbody');
  for (const kind of ['accelerations', 'forces']) {
    for (const symbol of Object.keys(motions[0]?.[kind] ?? {})) {
      const line = make('tr', {}, make('th', { scope: 'row', textContent: symbol }));
      for (const motion of motions) {
        const value = motion[kind][symbol];
        const range = motion.force_ranges?.[symbol];
        line.append(value !== null ? fraction(value)
                    : make('td', { textContent: Array.isArray(range) ? 'in ' + endText(...range) : 'undetermined' }));
      }
      body.append(line);
    }
  }
  table.append(make('thead', {}, head), body);
  return motions.length ? table : make('p', { textContent: 'No mode of the contacts satisfies all equations and conditions.' });
}

function loadTable(solve) {
  const table = make('table', {}, make('caption', { textContent: 'Every load, with its motions. Give the load a value to see them drawn.' }));
  const body = make('tbody');
  for (const cell of solve.cells ?? []) {
    const motions = cell.motions.map(motion => motion.modes.concat(motion.boundary_modes ?? [])[0]).join(', ');
    const loads = cell.load[0] !== null && cell.load[0] === cell.load[1] ? cell.load[0] : endText(...cell.load, cell.closed);
    body.append(make('tr', {}, make('td', { textContent: loads }), make('td', { textContent: motions || 'no motion' })));
  }
  table.append(make('thead', {}, make('tr', {}, make('th', { scope: 'col', textContent: solve.load?.symbol ?? 'load' }),
                                     make('th', { scope: 'col', textContent: 'motions' }))), body);
  return table;
}

// ---- the diagram

// A worker answers, so that dragging stays smooth; where there are no workers, the page itself does.
function startMapper() {
  const code = ['library', 'asking'].map(id => by(id).textContent).join('\n') + `
    let opened;
    onmessage = async ({ data }) => {
      try {
        if (data.given) opened = openLibrary(data.given);
        else postMessage({ id: data.id, answer: (await opened).answer(data.request) });
      } catch (error) {
        postMessage({ id: data.id, answer: { mistakes: [String(error.message ?? error)] } });
      }
    };`;
  try {
    const worker = new Worker(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
    worker.postMessage({ given });
    return { post: message => worker.postMessage(message), listen: listener => { worker.onmessage = ({ data }) => listener(data); } };
  } catch {
    let listener;
    return { post: ({ id, request }) => listener({ id, answer: library.answer(request) }), listen: other => { listener = other; } };
  }
}

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
  const inside = !mapped || (within(row?.value?.near, mapped.x) && within(load.near, mapped.y));
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
  mapped.plot = mapped.drawing.querySelector('[data-plot]');
  mapped.place = mapped.plot.dataset.plot.split(' ').map(Number);
  mapped.drawing.style.cursor = 'crosshair';
  mapped.drawing.addEventListener('pointerdown', dragInMap);
  mapped.drawing.addEventListener('pointermove', event => { if (event.buttons === 1) dragInMap(event); });
  moveMark();
}

function moveMark() {
  if (!mapped?.plot) return;
  const x = rows.get(mapped.x.symbol)?.value?.near, y = rows.get(mapped.y.symbol)?.value?.near;
  mapped.mark?.remove();
  mapped.mark = null;
  if (x == null || y == null || !within(x, mapped.x) || !within(y, mapped.y)) return;
  const [left, top, width, height] = mapped.place;
  const at = (value, [from, to]) => (value - from) / (to - from);
  const mark = document.createElementNS(svgNamespace, 'g');
  const cx = left + width * at(x, mapped.x.near), cy = top + height * (1 - at(y, mapped.y.near));
  for (const [radius, fill] of [[7, 'paper'], [5, 'ink']]) {
    const circle = document.createElementNS(svgNamespace, 'circle');
    for (const [name, text] of Object.entries({ cx, cy, r: radius, class: fill })) circle.setAttribute(name, text);
    mark.append(circle);
  }
  mapped.plot.append(mapped.mark = mark);
}

function dragInMap(event) {
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(mapped.plot.getScreenCTM().inverse());
  const [left, top, width, height] = mapped.place;
  const parts = [[mapped.x, (point.x - left) / width], [mapped.y, 1 - (point.y - top) / height]];
  if (parts.some(([, part]) => part < 0 || part > 1)) return;
  for (const [axis, part] of parts) {
    const row = rows.get(axis.symbol), { near: [from, to] } = axis;
    const steps = row?.steps ?? stepsOf(axis.near);
    changed[axis.symbol] = steps.text(steps.nearest(from + part * (to - from)));
  }
  event.preventDefault();
  ask();
}

// ---- a link that keeps the state

function keepState() {
  const parts = Object.entries(changed).map(([symbol, text]) => `${encodeURIComponent(symbol)}=${encodeURIComponent(text ?? '')}`);
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
    if (symbol === 'across:') across = [...by('across').options].some(option => option.value === text) ? text : across;
    else if (rows.has(symbol)) changed[symbol] = text === '' ? null : text;
    else by('copied').textContent = `The link has a value of ${symbol}, which this scene does not have.`;
  }
  by('across').value = across;
}

async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = make('textarea', { value: text });
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    if (!done) {
      by('copied').textContent = 'The browser does not let this page copy.';
      return;
    }
  }
  by('copied').textContent = `${what} copied.`;
}

function wire() {
  by('reset').addEventListener('click', () => {
    changed = {};
    ask();
  });
  by('copy-link').addEventListener('click', () => {
    keepState();
    copy(location.href, 'Link');
  });
  by('copy-scene').addEventListener('click', () => copy(by('scene-text').value, 'Scene'));
  by('across').addEventListener('change', () => {
    across = by('across').value;
    mapped = null;
    keepState();
    askForMap();
  });
  window.addEventListener('hashchange', () => {
    readState();
    ask();
  });
}

// ---- the start

async function start() {
  if (given === null) throw new Error('This is the explorer without a scene. `slipproof explore SCENE -o explorer.html` puts one into it.');
  library = await openLibrary(given);
  original = library.answer({ ranges: true });
  if (original.mistakes) throw new Error(original.mistakes.join('\n'));
  document.title = `${original.name} – explorer`;
  by('name').textContent = original.name;
  by('subject').textContent = `Mechanism: ${original.mechanism}. Drag a value; the motions follow, exactly.`;
  // What the diagram shows comes first: the load, and the parameter across.
  const rank = value => value.kind === 'load' ? 0 : value.symbol === original.usual ? 1 : 2;
  const ranked = [...original.values].sort((x, y) => rank(x) - rank(y));
  const few = ranked.length <= 6 ? ranked.length : ranked.filter(value => rank(value) < 2).length;
  ranked.forEach((value, i) => addRow(value, i < few ? 'rows' : 'other-rows'));
  by('others').hidden = few === ranked.length;
  by('others').open = matchMedia('(min-width: 60rem)').matches;
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
  mapper = startMapper();
  mapper.listen(showMap);
  refresh();
  document.body.dataset.ready = 'true';
}

start().catch(error => { by('mistakes').textContent = String(error.message ?? error); });
})();
