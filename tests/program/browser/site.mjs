// What a reader of the site meets in a browser, from a file: the front page with its explorer, and pages that are found.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const site = resolve('site');
let browser;

before(async () => {
  browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
});
after(async () => browser?.close());

async function open(file, { width = 1400, colorScheme = 'light', reducedMotion = 'no-preference' } = {}) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme, reducedMotion });
  context.setDefaultTimeout(0);  // on a busy machine an answer may take minutes; the whole test has its limit
  const page = await context.newPage();
  page.wrong = [];
  page.on('pageerror', error => page.wrong.push(String(error)));
  page.on('console', message => message.type() === 'error' && page.wrong.push(message.text()));
  page.on('request', request => /^(file|blob|data):/.test(request.url()) || page.wrong.push(request.url()));
  await page.goto(pathToFileURL(join(site, file)).href);
  return page;
}

function* pages(folder) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    if (entry.isDirectory()) yield* pages(join(folder, entry.name));
    else if (entry.name.endsWith('.html')) yield join(folder, entry.name);
  }
}

const looks = [[1400, 'light'], [1400, 'dark'], [800, 'light'], [800, 'dark'], [400, 'light'], [400, 'dark']];

async function front(options) {
  const page = await open('index.html', options);
  await page.waitForSelector('body[data-ready]');
  return page;
}

// The smallest letters of the pictures in a frame, in pixels of the window; subscripts are smaller.
const letters = frame => frame.evaluate(() => {
  const roots = root => [root, ...[...root.querySelectorAll('*')].flatMap(one => one.shadowRoot ? roots(one.shadowRoot) : [])];
  return Math.min(...roots(document).flatMap(root => [...root.querySelectorAll('svg text')]).map(text => {
    const { a, b } = text.getScreenCTM();
    return parseFloat(getComputedStyle(text).fontSize) * Math.hypot(a, b);
  }));
});

test('the front page needs nothing else, fits every width, and has nothing for axe-core, in light and dark', async () => {
  for (const [width, colorScheme] of looks) {
    const page = await front({ width, colorScheme });
    assert.equal(await page.locator('#pictures figure').count(), 3);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `wider than ${width}`);
    await page.waitForFunction(() => document.querySelector('#map .drawing') && !document.querySelector('#map').classList.contains('stale'));
    for (const frame of page.frames()) {
      const smallest = await letters(frame);
      assert.ok(smallest >= 10, `letters of ${smallest} pixels at ${width} on ${frame.url()}`);
      await frame.evaluate(axe);
      const { violations } = await frame.evaluate(() => axe.run());
      assert.deepEqual(violations.map(v => `${frame.url()}: ${v.id}: ${v.nodes[0].html}`), []);
    }
    assert.deepEqual(page.wrong, []);
    await page.context().close();
  }
});

// Processor time of a page's main thread in milliseconds, which other programs on the machine do not lengthen.
async function clock(page) {
  const client = await page.context().newCDPSession(page);
  await client.send('Performance.enable', { timeDomain: 'threadTicks' });
  return async () => {
    const { metrics } = await client.send('Performance.getMetrics');
    return 1000 * metrics.find(({ name }) => name === 'TaskDuration').value;
  };
}

test('the front page has at most 6 MB, and answers within 2 seconds', async () => {
  const bytes = ['index.html', 'stand.html'].reduce((sum, name) => sum + statSync(join(site, name)).size, 0);
  const page = await (await browser.newContext()).newPage();
  const busy = await clock(page);
  const start = performance.now();
  await page.goto(pathToFileURL(join(site, 'index.html')).href);
  await page.waitForSelector('body[data-ready]');
  const [elapsed, worked] = [performance.now() - start, await busy()];
  console.log(`${bytes} bytes; interactive after ${Math.round(worked)} ms of processor time, ${Math.round(elapsed)} ms in all`);
  assert.ok(bytes <= 6e6);
  assert.ok(worked < 2000);
});

test('dragging the bicycle gives 60 frames a second', async () => {
  const page = await front({ reducedMotion: 'reduce' });
  const busy = await clock(page);
  const slider = page.getByRole('slider', { name: 'F', exact: true });
  await slider.scrollIntoViewIfNeeded();
  const drag = frames => slider.evaluate(async (slider, frames) => {  // another value in each frame
    const [low, high] = [Number(slider.min), Number(slider.max)];
    let answers = 0, last = window.slipproofTimes;
    const start = performance.now();
    for (let i = 0; i < frames; ++i) {
      slider.value = Math.round(low + (high - low) * (0.5 + 0.4 * Math.sin(i / 7)));
      slider.dispatchEvent(new Event('input'));
      await new Promise(requestAnimationFrame);
      if (last !== window.slipproofTimes) ++answers;
      last = window.slipproofTimes;
    }
    return { answers, seconds: (performance.now() - start) / 1000 };
  }, frames);
  await drag(60);  // the browser compiles what runs often
  const before = await busy(), frames = 180, { answers, seconds } = await drag(frames), worked = await busy() - before;
  console.log(`an answer takes ${(worked / answers).toFixed(1)} ms of the page's processor time; ` +
    `${(frames / seconds).toFixed(0)} frames and ${(answers / seconds).toFixed(0)} answers a second here`);
  assert.ok(answers > 1);
  assert.ok(worked / answers < 1000 / 60);
});

test('the motions move, unless somebody asks for less motion, and then show their end', async () => {
  const places = page => page.evaluate(() => [...document.querySelectorAll('#pictures .drawing')].map(host =>
    host.shadowRoot.querySelector('[data-about]').getAttribute('transform')));
  for (const reducedMotion of ['no-preference', 'reduce']) {
    const page = await front({ reducedMotion });
    const button = page.getByRole('button', { name: 'Move', exact: true });
    const moves = reducedMotion === 'no-preference';
    assert.equal(await button.getAttribute('aria-pressed'), String(moves));
    if (!moves) await button.click();
    await page.waitForFunction(() => /Half a second/.test(document.querySelector('#move-note').textContent));
    const before = await places(page);
    await page.waitForTimeout(400);
    assert.equal(JSON.stringify(await places(page)) !== JSON.stringify(before), moves);
    assert.equal(new Set(before).size, 3);
    await button.click();
    assert.ok((await places(page)).every(text => text.startsWith('translate(0 0) rotate(0 ')));
    await page.context().close();
  }
});

test('pasted answers get the verdicts of the program', async () => {
  const page = await front();
  const verdicts = () => page.locator('#judged strong').allTextContents();
  for (const [example, verdict] of [['right', 'certified'], ['wrong', 'wrong'], ['one of several', 'ambiguous'], ['a record of this scene', 'ambiguous']]) {
    await page.locator('#judged').evaluate(list => list.replaceChildren());
    await page.getByRole('button', { name: example, exact: true }).click();
    await page.waitForSelector('#judged strong');
    assert.deepEqual(await verdicts(), [verdict]);
  }
  const problems = readFileSync(join(process.env.PROJECT, 'cases/contact-problems/examples.jsonl'), 'utf8').trim().split('\n');
  const run = spawnSync(process.env.SLIPPROOF, ['certify', '-'], { input: problems.join('\n') + '\n', encoding: 'utf8' });
  const expected = run.stdout.split('\n').filter(line => line.startsWith('{')).map(line => JSON.parse(line));
  assert.equal(expected.length, problems.length);
  for (const [i, problem] of problems.entries()) {
    await page.locator('#pasted').fill(problem);
    await page.getByRole('button', { name: 'Judge' }).click();
    const found = JSON.parse(await page.locator('#judged code').first().textContent());
    assert.deepEqual({ ...found, record: i + 1 }, expected[i]);
  }
  await page.locator('#pasted').fill('{"W": [[1');
  await page.getByRole('button', { name: 'Judge' }).click();
  assert.notEqual(await page.locator('#pasted-mistakes').textContent(), '');
  assert.deepEqual(await verdicts(), []);
});

test('the front page is used by the keyboard alone', async () => {
  const page = await front({ reducedMotion: 'reduce' });
  const at = () => page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute('aria-label') || document.activeElement.textContent.trim());
  const reached = [];
  for (let i = 0; i < 80 && reached.at(-1) !== 'stand'; ++i) {
    await page.keyboard.press('Tab');
    reached.push(await page.evaluate(() => document.activeElement.tagName) === 'IFRAME' ? 'stand' : await at());
  }
  for (const part of ['Skip to the bicycle', 'F', 'f', 'move', 'map', 'numbers', 'pasted', 'judge', 'stand']) {
    assert.ok(reached.includes(part), `${part} is not reached: ${reached.join(', ')}`);
  }
  await page.getByRole('slider', { name: 'f', exact: true }).focus();
  const before = await page.locator('#numbers').textContent();
  await page.keyboard.press('Home');
  await page.waitForFunction(text => document.querySelector('#numbers').textContent !== text, before);
  const frame = page.frames().find(one => one.url().endsWith('stand.html'));
  const drawing = () => frame.locator('#picture').innerHTML();
  const still = await drawing();
  await frame.locator('#picture').focus();
  await page.keyboard.press('ArrowLeft');
  assert.notEqual(await drawing(), still);
});

test('on a narrow window, keys open the menu of the documentation and its sections, and stop at nothing that is closed', async () => {
  const page = await open('pages/cases/CERTIFYING.html', { width: 400, reducedMotion: 'reduce' });
  const until = async selector => {
    for (let i = 0; i < 30; ++i) {
      await page.keyboard.press('Tab');
      assert.ok(await page.evaluate(() => document.activeElement.closest('.md-search__output') === null));
      if (await page.evaluate(text => document.activeElement.matches(text), selector)) return;
    }
    assert.fail(`${selector} is not reached`);
  };
  const link = page.locator('.md-sidebar--primary a.md-nav__link', { hasText: 'The model' });
  assert.ok(!await link.isVisible());
  await until('button.menu');
  await page.keyboard.press('Enter');
  await until('#__nav_2');
  await page.keyboard.press('Space');
  await link.waitFor();
  await until('.md-sidebar--primary a[href$="MODEL.html"]');
  await page.context().close();
});

test('a wide table scrolls by keys', async () => {
  const page = await open('pages/cases/CERTIFYING.html', { width: 400 });
  await page.locator('.md-typeset__scrollwrap[tabindex="0"]').first().focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => document.activeElement.scrollLeft > 0);
  await page.context().close();
});

test('every link of pages and reports leads to a file, and the name of each of them to the front page', () => {
  const missing = new Set();
  let names = 0;
  for (const file of [join(site, 'index.html'), ...['pages', 'papers', 'engines'].flatMap(part => [...pages(join(site, part))])]) {
    if (file.endsWith('/404.html')) continue;  // its links are those of a server
    const text = readFileSync(file, 'utf8');
    const name = text.match(/<a href="([^"]+)"[^>]*md-logo|<a class="brand" href="([^"]+)"/);
    if (name) assert.equal(fileURLToPath(new URL(name[1] ?? name[2], pathToFileURL(file))), join(site, 'index.html'), file);
    names += Boolean(name);
    for (const [, target] of text.matchAll(/(?:href|src)="([^"#?]+)/g)) {
      if (/^[a-z]+:/.test(target) || target.startsWith('//')) continue;
      const found = fileURLToPath(new URL(target.replaceAll('&amp;', '&'), pathToFileURL(file)));
      if (!existsSync(found) || !statSync(found).isFile()) missing.add(`${file}: ${target}`);
    }
  }
  assert.deepEqual([...missing].slice(0, 10), []);
  assert.ok(names > 250, `${names} names`);
});

// What somebody asks in the first hour, and a page that must be among the first five answers.
const questions = [
  ['how to install', 'index.html'],
  ['does it stand', 'cases/mechanisms/bodies/index.html'],
  ['certify tolerance', 'cases/CERTIFYING.html'],
  ['exit codes', 'index.html'],
  ['URDF', 'cases/imported/index.html'],
  ['continuum', 'proofs/GLOSSARY.html'],
  ['FCLIB', 'src/contact/formats/FORMATS.html'],
  ['Python', 'src/faces/python/index.html'],
  ['Coq', 'proofs/coq/index.html'],
  ['Painlevé', 'proofs/painleve-rod/index.html'],
  ['painleve', 'proofs/painleve-rod/index.html'],
  ['what is a mode', 'proofs/GLOSSARY.html'],
  ['license', 'index.html'],
];

test('the search finds what a newcomer asks for, without a server', async () => {
  const page = await open('pages/index.html');
  await page.locator('.md-search__input').focus();
  await page.waitForFunction(() => !/Initializing/.test(document.querySelector('.md-search-result__meta').textContent));
  for (const [question, expected] of questions) {
    await page.locator('.md-search__input').clear();
    await page.locator('.md-search__input').press('Backspace');  // the theme listens to keys
    await page.waitForFunction(() => document.querySelectorAll('.md-search-result__item').length === 0);
    await page.locator('.md-search__input').pressSequentially(question);
    await page.waitForTimeout(500);
    await page.waitForSelector('.md-search-result__item');
    const found = await page.locator('.md-search-result__item').evaluateAll(
        items => items.slice(0, 5).map(item => item.querySelector('a').href));
    assert.ok(found.some(href => href.includes(`/pages/${expected}`)), `${question}: ${found.join(', ')}`);
  }
  assert.deepEqual(page.wrong, []);
});

// What axe-core finds on a page.
async function violations(file, looks) {
  const found = [];
  const page = await open(file);
  for (const [width, colorScheme] of looks) {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme });
    await page.reload();
    assert.deepEqual(page.wrong, []);
    await page.evaluate(axe);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${file}: wider than ${width}`);
    const { violations } = await page.evaluate(() => axe.run());
    found.push(...violations.map(v => `${file}, ${width} ${colorScheme}: ${v.id}: ${v.nodes[0].html}`));
    page.wrong.length = 0;  // axe-core asks for style sheets, which a file does not get
  }
  await page.context().close();
  return found;
}

test('pages can be read by everyone', async () => {
  for (const file of ['index.html', 'cases/CERTIFYING.html', 'COMMAND_LINE.html', 'proofs/ladder/index.html']) {
    assert.deepEqual(await violations(`pages/${file}`, looks), []);
  }
});

test('reports can be read by everyone: of papers at every width, in light and dark; of engines, each tenth at one of them', async () => {
  const reports = folder => [...pages(join(site, folder))].map(file => file.slice(site.length + 1))
    .filter(file => !file.endsWith('explorer.html')).sort();
  const papers = reports('papers');
  assert.ok(papers.length > 28);
  for (const file of [...papers, 'engines/index.html']) assert.deepEqual(await violations(file, looks), []);
  for (const [i, file] of reports('engines').filter((_, i) => i % 10 === 0).entries()) {
    assert.deepEqual(await violations(file, [looks[i % looks.length]]), []);
  }
});

test('from the first page, next leads through all pages of the documentation, and previous back', () => {
  const beside = (file, rel) => {
    const link = readFileSync(file, 'utf8').match(new RegExp(`<a href="([^"]+)" class="md-footer__link md-footer__link--${rel}"`));
    return link && fileURLToPath(new URL(link[1], pathToFileURL(file)));
  };
  const reached = [join(site, 'pages/index.html')];
  for (let next; (next = beside(reached.at(-1), 'next')); reached.push(next)) {
    assert.equal(beside(next, 'prev'), reached.at(-1));
    assert.ok(!reached.includes(next));
  }
  const project = spawnSync('git', ['-C', process.env.PROJECT, 'ls-files', '*.md'], { encoding: 'utf8' }).stdout.trim().split('\n');
  assert.ok(reached.length >= project.length, `${reached.length} of ${project.length}`);
});
