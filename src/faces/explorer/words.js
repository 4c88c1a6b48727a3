'use strict';
// What the page says in words, numbers, tables and pictures, from what the library answers. Nothing here depends on the page's state.
const make = (name, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...children);
  return element;
};

// ---- rational steps

function fractionText(p, q) {
  let [a, b] = [p < 0n ? -p : p, q];
  while (b) [a, b] = [b, a % b];
  return q === a ? `${p / a}` : `${p / a}/${q / a}`;
}

// About 200 steps of 1, 2 or 5 times a power of ten; the value of a step is a fraction of whole numbers.
function stepsOf([from, to]) {
  const wanted = (to - from) / 200;
  let power = Math.floor(Math.log10(wanted)), digit = 1;
  for (const d of [1, 2, 5, 10]) {
    digit = d;
    if (d * 10 ** power >= wanted) break;
  }
  const size = digit * 10 ** power;
  const text = k => power < 0 ? fractionText(BigInt(k) * BigInt(digit), 10n ** BigInt(-power))
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
// ---- the motions

const shortened = text => text.length > 40 ? text.slice(0, 24) + '…' : text;

function countText(solve) {
  if (!solve.motions) return 'Motions by load';
  const n = solve.motions.length, continua = solve.continua?.length ?? 0;
  const motions = n === 0 ? (continua ? 'No single motion' : 'No motion') : n === 1 ? 'One motion' : `${n} motions`;
  const load = solve.load ? ` at ${solve.load.symbol} = ${shortened(solve.load.value)}` : '';
  const names = solve.motions.map(motion => motion.modes[0] ?? motion.boundary_modes[0])
    .concat((solve.continua ?? []).map(one => one.mode)).join(', ');
  return motions + (continua ? `, and ${continua === 1 ? 'a continuum' : continua + ' continua'}` : '') + load + (names ? `: ${names}` : '');
}
const endText = (lower, upper, closed = [true, true]) =>
  `${lower === null || !closed[0] ? '(' : '['}${lower ?? '−∞'}, ${upper ?? '+∞'}${upper === null || !closed[1] ? ')' : ']'}`;

function fraction(text) {
  const cell = make('td', {}, text);
  const [p, q] = text.split('/');
  if (q) {
    // Only as many digits as a double holds: numbers may be longer than its range.
    const tail = Math.max(0, Math.min(p.length, q.length) - 40);
    const near = Number(p.slice(0, p.length - tail)) / Number(q.slice(0, q.length - tail));
    if (Number.isFinite(near)) cell.append(make('small', { textContent: '≈ ' + decimal(near) }));
  }
  return cell;
}

function quantityTable(caption, names) {
  const head = make('tr', {}, make('th', { scope: 'col', textContent: 'quantity' }));
  for (const name of names) head.append(make('th', { scope: 'col', textContent: name }));
  const body = make('tbody');
  return [make('table', {}, make('caption', { textContent: caption }), make('thead', {}, head), body), body];
}

function motionTable(motions) {
  const [table, body] = quantityTable('Exact values; accelerations first, then forces', motions.map(motion =>
      (motion.modes.concat(motion.boundary_modes)[0] ?? 'motion') + (motion.status === 'strict' ? '' : ` (${motion.status})`)));
  // A force is undetermined in some motions, and has a range there.
  const all = motions.map(({ accelerations, forces, force_ranges }) => ({ ...accelerations, ...forces, ...force_ranges }));
  for (const symbol of new Set(all.flatMap(Object.keys))) {
    const line = make('tr', {}, make('th', { scope: 'row', textContent: symbol }));
    for (const { [symbol]: value } of all) {
      line.append(Array.isArray(value) ? make('td', { textContent: 'in ' + endText(...value) }) : fraction(value));
    }
    body.append(line);
  }
  return table;
}

// A continuum by the range of each quantity.
function continuumTable(continua) {
  const [table, body] = quantityTable('Continua of motions: the range of each quantity, exact', continua.map(({ mode, status }) =>
      mode + (status === 'strict' ? '' : ` (${status})`)));
  for (const symbol of Object.keys(continua[0].ranges)) {
    const line = make('tr', {}, make('th', { scope: 'row', textContent: symbol }));
    for (const { ranges: { [symbol]: [from, to] } } of continua) {
      line.append(from !== null && from === to ? fraction(from) : make('td', { textContent: endText(from, to) }));
    }
    body.append(line);
  }
  return table;
}

function tablesOf(solve) {
  if (!solve.motions) return [loadTable(solve)];
  const tables = [];
  if (solve.motions.length) tables.push(motionTable(solve.motions));
  if (solve.continua?.length) tables.push(continuumTable(solve.continua));
  return tables.length ? tables : [make('p', { textContent: 'No mode of the contacts satisfies all equations and conditions.' })];
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

// An SVG file, with its style and its ids to itself.
function showDrawing(host, svg) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
  const drawing = document.importNode(new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement, true);
  drawing.style.display = 'block';
  drawing.style.width = '100%';
  drawing.style.height = 'auto';
  // What stays behind in motion; and the rims of letters, which take most of the time, while a value is dragged.
  const faded = document.createElementNS('http://www.w3.org/2000/svg', 'style');
  faded.textContent = '.moves-now>:not([data-about],.frame){opacity:0.3}.hurried .halo{stroke:none;paint-order:normal}';
  drawing.append(faded);
  root.replaceChildren(drawing);
  return drawing;
}

// Writes what is not there yet: whatever is written is laid out and drawn again.
function put(node, key, text) {
  if (node[key] !== text) node[key] = text;
}

// Copies, and says so, or why not.
async function copy(text, what, said) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = make('textarea', { value: text });
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    if (!done) {
      said.textContent = 'The browser does not let this page copy.';
      return;
    }
  }
  said.textContent = `${what} copied.`;
}
