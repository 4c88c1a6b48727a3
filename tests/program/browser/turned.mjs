// turned.mjs SLIPPROOF FOLDER SCENE...: the page of a scene in space draws it, from any direction, as `draw --from` does.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import assert from 'node:assert';
import vm from 'node:vm';

const [program, folder, ...scenes] = process.argv.slice(2);
const run = (...given) => execFileSync(program, given, { encoding: 'utf8' });

/// Lines, areas and dots with their classes and numbers, in the order in which they are painted; without the paper, and the
/// lines from labels, which the page places in a simpler way.
function drawnIn(svg) {
  const found = [];
  for (const [, name, rest] of svg.matchAll(/<(path|line|circle|rect)\b([^>]*)>/g)) {
    const value = Object.fromEntries([...rest.matchAll(/([\w-]+)="([^"]*)"/g)].map(([, key, text]) => [key, text]));
    if (value.class === 'paper' || (name === 'line' && value.class === 'measure')) continue;
    const keys = { path: ['d'], line: ['x1', 'y1', 'x2', 'y2'], circle: ['cx', 'cy', 'r'], rect: ['x', 'y', 'width', 'height'] };
    const numbers = keys[name].flatMap((key) => value[key].match(/-?[\d.]+(?:e[-+]?\d+)?/g).map(Number));
    if (value.style === 'fill:none') numbers.splice(2, numbers.length - 4);  // an arc, which the file has with fewer points
    found.push({ name, css: value.class ?? '', dashes: value['stroke-dasharray'] ?? '', numbers });
  }
  return found;
}

function compare(page, svg, what) {
  assert.strictEqual(page.length, svg.length, `${what}: as many parts`);
  page.forEach((one, i) => {
    const other = svg[i], place = `${what}: part ${i}, ${one.name} ${one.css}`;
    assert.deepStrictEqual([one.name, one.css, one.dashes, one.numbers.length], [other.name, other.css, other.dashes, other.numbers.length], place);
    one.numbers.forEach((x, k) => assert(Math.abs(x - other.numbers[k]) < 0.11, `${place}: ${one.numbers} and ${other.numbers}`));
  });
}

let compared = 0;
for (const scene of scenes) {
  run('explore', scene, '-o', `${folder}/page.html`, '--quiet');
  const page = readFileSync(`${folder}/page.html`, 'utf8');
  const model = JSON.parse(page.match(/<script type="application\/json" id="scene">([^<]*)<\/script>/)[1]);
  const module = { exports: {} };
  vm.runInNewContext(page.match(/<script>\s*("use strict";\s*\/\/ A scene in space[^]*?)<\/script>/)[1], { module });
  const { direction, drawn } = module.exports;
  assert(model.motions.length > 0);
  for (const [motion, one] of model.motions.entries()) {
    for (const from of [model.from, [125, -35]]) {
      run('draw', scene, '--motion', String(motion + 1), `--from=${from}`, '-o', `${folder}/drawn.svg`, '--quiet');
      const svg = readFileSync(`${folder}/drawn.svg`, 'utf8').replace(/<g class="axes">[^]*/, '');
      compare(drawnIn(drawn(model, one, direction(...from))), drawnIn(svg), `${scene} motion ${motion + 1} from ${from}`);
      ++compared;
    }
  }
}
console.log(`${compared} pictures are the same`);
