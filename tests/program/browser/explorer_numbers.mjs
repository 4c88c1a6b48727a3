// explorer_numbers.mjs SLIPPROOF LIBRARY COUNT SCENE...: the explorer's library under Node.js against the program, at COUNT
// random values of these scenes. The same documents, byte for byte in their numbers, or exit code 1.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';

const [slipproof, library, count, ...scenes] = process.argv.slice(2);
const Library = createRequire(import.meta.url)(resolve(library));
const compiled = readFileSync(library.replace(/js$/, 'wasm'));

let state = 20260301;
const below = n => {  // a linear congruential generator modulo 2^32, with a fixed seed
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return Math.floor(state / 2 ** 32 * n);
};

async function opened(scene) {
  execFileSync(slipproof, ['explore', scene, '-o', 'numbers.html', '--quiet'], { stdio: ['ignore', 'ignore', 'ignore'] });
  const given = JSON.parse(/id="given">(.*)<\/script>/.exec(readFileSync('numbers.html', 'utf8'))[1]);
  if (given.file) writeFileSync('mechanism.toml', given.file);
  const module = await Library({ wasmBinary: compiled });
  const mistakes = module.cwrap('slipproof_open', 'string', ['string', 'string'])(JSON.stringify(given), given.file);
  assert.equal(mistakes, '');
  const answer = module.cwrap('slipproof_answer', 'string', ['string']);
  return request => JSON.parse(answer(JSON.stringify(request)));
}

// A value in the range of a slider: a fraction, now and then a long one.
function drawn([from, to]) {
  const denominator = [10, 64, 997, 1_000_003][below(4)];
  const first = Math.ceil(from * denominator), last = Math.floor(to * denominator);
  return `${first + below(last - first + 1)}/${denominator}`;
}

let compared = 0, refused = 0, motions = 0;
const times = [];
for (const [i, scene] of scenes.entries()) {
  const answer = await opened(scene);
  const { values } = answer({ ranges: true });
  const share = Math.ceil((Number(count) - compared) / (scenes.length - i));
  for (let found = 0, tries = 0; found < share && tries < 20 * share; ++tries) {
    const set = {};
    for (const { symbol, range, kind } of values) {
      if (range && (kind === 'load' || tries % 3 === 0 || below(4) === 0)) set[symbol] = drawn(range.near);
    }
    const start = performance.now();
    const got = answer({ set });
    times.push(performance.now() - start);
    if (got.mistakes) {
      ++refused;
      continue;
    }
    writeFileSync('numbers.toml', got.scene);
    const run = spawnSync(slipproof, ['solve', '--json', '--quiet', 'numbers.toml'], { encoding: 'utf8', maxBuffer: 1 << 28 });
    assert.equal(run.status, 0, `${scene}: ${run.stderr}\n${got.scene}`);
    assert.deepEqual(got.solve, JSON.parse(run.stdout), `${scene}\n${got.scene}`);
    motions += got.solve.motions?.length ?? 0;
    ++found;
    ++compared;
  }
}
times.sort((x, y) => x - y);
console.log(`${compared} scenes with ${motions} motions: the same documents; ${refused} values outside domains refused`);
console.log(`an answer takes ${times[times.length >> 1].toFixed(1)} ms (median), ${times.at(-1).toFixed(1)} ms at most`);
if (compared < Number(count)) {
  console.log(`expected ${count} scenes`);
  process.exitCode = 1;
}
