// What a reader of the explorer meets in a browser: nothing is fetched, values are dragged, and the numbers are the
// program's.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const explorer = pathToFileURL('explorer.html').href;
let browser;

before(async () => {
  browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
});
after(async () => browser?.close());

async function open({ width = 1280, colorScheme = 'light', hash = '', file = 'explorer.html', ready = true } = {}) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme });
  context.setDefaultTimeout(0);  // on a busy machine an answer may take minutes; the whole test has its limit
  const page = await context.newPage();
  page.said = [];
  page.asked = [];
  page.on('console', message => page.said.push(message.text()));
  page.on('pageerror', error => page.said.push(String(error)));
  page.on('request', request => page.asked.push(request.url()));
  await page.goto(pathToFileURL(file).href + hash);
  if (ready) await page.waitForSelector('body[data-ready]');
  return page;
}

const drawn = page => page.waitForFunction(() => document.querySelector('#map .drawing') &&
                                                 !document.querySelector('#map').classList.contains('stale'));

// What the program answers to the scene that the page shows, and its mechanism.
async function solved(page) {
  writeFileSync('copied.toml', await page.locator('#scene-text').inputValue());
  writeFileSync('mechanism.toml', await page.locator('#mechanism-text').inputValue());
  return JSON.parse(execFileSync(process.env.SLIPPROOF, ['solve', '--json', 'copied.toml'], { encoding: 'utf8' }));
}

const shown = page => page.evaluate(() => {
  const rows = [...document.querySelectorAll('#numbers table:first-child tbody tr')];
  return rows.map(row => [...row.children].map(cell => cell.firstChild.textContent));
});

async function sameAsProgram(page) {
  const { motions, continua = [] } = await solved(page);
  const numbers = motions.length === 0 ? [] : await shown(page);
  const all = motions.map(({ accelerations, forces, force_ranges }) => ({ ...accelerations, ...forces, ...force_ranges }));
  const text = value => Array.isArray(value) ? `in [${value[0]}, ${value[1]}]` : value;
  const expected = [...new Set(all.flatMap(Object.keys))].map(name => [name, ...all.map(values => text(values[name]))]);
  assert.deepEqual(numbers, expected);
  assert.equal(await page.locator('#pictures figure').count(), Math.max(1, motions.length + continua.length));
  return motions.length;
}

test('loads from a file without a complaint and without asking for anything', async () => {
  const page = await open();
  await drawn(page);
  assert.deepEqual(page.said, []);
  assert.deepEqual(page.asked.filter(url => url !== explorer && !/^(data|blob):/.test(url)), []);
  assert.ok(readFileSync('explorer.html').length < 4e6);
});

test('the numbers are those of the program, while a value is dragged', async () => {
  const page = await open();
  assert.equal(await sameAsProgram(page), 3);
  const slider = page.getByRole('slider', { name: 'F', exact: true });
  await slider.focus();
  for (const key of ['ArrowRight', 'ArrowLeft', 'Home', 'PageUp']) {
    const before = await page.locator('#scene-text').inputValue();
    await slider.press(key);
    await page.waitForFunction(text => document.querySelector('#scene-text').value !== text, before);
    await sameAsProgram(page);
  }
});

test('a value outside its domain is refused in words, and the page goes on', async () => {
  const page = await open();
  const f = page.getByRole('textbox', { name: 'f', exact: true });
  await f.fill('-1');
  await f.press('Enter');
  await page.waitForFunction(() => document.querySelector('#mistakes').textContent !== '');
  assert.match(await page.locator('#mistakes').textContent(), /f: found '-1', expected f >/);
  assert.equal(await f.getAttribute('aria-invalid'), 'true');
  await f.fill('1/3');
  await f.press('Enter');
  await page.waitForFunction(() => document.querySelector('#mistakes').textContent === '');
  assert.match(await page.locator('#scene-text').inputValue(), /^f = "1\/3"$/m);
  await sameAsProgram(page);
});

test('a link keeps the state', async () => {
  const page = await open();
  const f = page.getByRole('textbox', { name: 'f', exact: true });
  await f.fill('5/4');
  await f.press('Enter');
  await page.waitForFunction(() => location.hash.includes('f=5%2F4'));
  const again = await open({ hash: new URL(page.url()).hash });
  assert.match(await again.locator('#scene-text').inputValue(), /^f = "5\/4"$/m);
  assert.equal(await again.locator('#scene-text').inputValue(), await page.locator('#scene-text').inputValue());
});

test('a link with a refused value shows the scene and the refusal', async () => {
  const page = await open({ hash: '#f=-1&R=0.5' });
  const value = name => page.getByRole('textbox', { name, exact: true });
  assert.match(await page.locator('#mistakes').textContent(), /f: found '-1'/);
  assert.deepEqual(await Promise.all(['f', 'R', 'F'].map(name => value(name).inputValue())), ['-1', '1/4', '327/100']);
  assert.equal(await value('f').getAttribute('aria-invalid'), 'true');
  assert.equal(await value('R').getAttribute('aria-invalid'), null);
  await value('f').fill('1');
  await value('f').press('Enter');
  await page.waitForFunction(() => document.querySelector('#mistakes').textContent === '');
  assert.equal(await value('R').inputValue(), '1/2');
});

test('Copy as scene and Copy link put them on the clipboard', async () => {
  const page = await open();
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  for (const [button, said, expected] of [['Copy as scene', 'Scene copied.', () => page.locator('#scene-text').inputValue()],
                                          ['Copy link', 'Link copied.', () => page.url()]]) {
    await page.getByRole('button', { name: button }).click();
    await page.waitForFunction(text => document.querySelector('#copied').textContent === text, said);
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await expected());
  }
});

test('a click into the diagram takes its point', async () => {
  const page = await open();
  await drawn(page);
  const plots = page.locator('#map [data-plot]');
  for (let i = 0; i < await plots.count(); ++i) {
    const before = await page.locator('#scene-text').inputValue();
    const [x, y] = await plots.nth(i).evaluate(plot => {
      const [left, top, width, height] = plot.dataset.plot.split(' ').map(Number);
      const point = () => new DOMPoint(left + 0.3 * width, top + 0.4 * height).matrixTransform(plot.getScreenCTM());
      scrollBy(0, point().y - innerHeight / 2);
      return [point().x, point().y];
    });
    await page.mouse.click(x, y);
    await page.waitForFunction(text => document.querySelector('#scene-text').value !== text, before);
    await sameAsProgram(page);
    // What is above the plot may have another height now.
    const off = await plots.nth(i).evaluate(plot => {
      const [left, top, width, height] = plot.dataset.plot.split(' ').map(Number);
      const point = new DOMPoint(left + 0.3 * width, top + 0.4 * height).matrixTransform(plot.getScreenCTM());
      return Math.min(...[...plot.querySelectorAll(':scope > g > circle')].map(one => {
        const box = one.getBoundingClientRect();
        return Math.hypot(box.x + box.width / 2 - point.x, box.y + box.height / 2 - point.y);
      }));
    });
    assert.ok(off < 5, `the mark of plot ${i} is ${off} pixels off`);
  }
});

test('no motion, a continuum, every load and values of a thousand digits are shown as the program has them', async () => {
  const rod = await open({ file: 'rod.html' });
  assert.equal(await rod.locator('#count').textContent(), 'No motion');
  assert.equal(await rod.locator('#pictures figure').count(), 1);
  assert.match(await rod.locator('#numbers').textContent(), /No mode/);
  const truck = await open({ file: 'truck.html' });
  assert.match(await truck.locator('#count').textContent(), /^3 motions, and 2 continua at T = 9000: /);
  assert.equal(await truck.locator('#pictures figure').count(), 5);
  const { continua } = await solved(truck);
  const line = await truck.locator('#numbers table:last-child tr', { has: truck.getByRole('rowheader', { name: 'ax', exact: true }) })
    .locator('td').allTextContents();
  assert.deepEqual(line, continua.map(({ ranges: { ax: [from, to] } }) => `[${from}, ${to}]`));
  const page = await open();
  const load = page.getByRole('textbox', { name: 'F', exact: true });
  for (const value of ['', '1' + '0'.repeat(1000), '1/' + '7'.repeat(1000)]) {
    await load.fill(value);
    await load.press('Enter');
    await page.waitForFunction(text => document.querySelector('#count').textContent.includes(text.slice(0, 20)), value || 'Motions by load');
    if (value) await sameAsProgram(page);
    assert.doesNotMatch(await page.locator('main').innerText(), /NaN|Infinity|undefined/);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 1280);
  }
});

test('a page of the report leads to its scene', async () => {
  for (const { file, link, at } of [{ file: 'engines/one-motion/cube-tips.html', link: '.explore a', at: 'engines/explorer.html' },
                                    { file: 'papers/ladder.html', link: '.phase .explore a', at: 'papers/explorer.html' }]) {
    const page = await open({ file, ready: false });
    const href = await page.locator(link).first().getAttribute('href');
    const there = await open({ file: at, hash: href.slice(href.indexOf('#')) });
    assert.ok(await sameAsProgram(there) >= 1);
    const state = there.url();
    await there.getByRole('slider').first().press('ArrowRight');
    await there.waitForFunction(url => location.href !== url, state);
    const again = await open({ file: at, hash: new URL(there.url()).hash });
    assert.equal(await again.locator('#scene-text').inputValue(), await there.locator('#scene-text').inputValue());
  }
  const broken = await open({ file: 'engines/explorer.html', hash: '#scene:=%7B%22scene', ready: false });
  await broken.waitForFunction(() => document.querySelector('#mistakes').textContent.includes('cannot be read'));
});

test('everything can be read and reached: no violation of axe-core, no scrolling sideways', async () => {
  for (const colorScheme of ['light', 'dark']) {
    for (const width of [1400, 800, 400]) {
      const page = await open({ width, colorScheme });
      await drawn(page);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width);
      await page.addScriptTag({ content: axe }).catch(() => page.evaluate(axe));
      const { violations } = await page.evaluate(() => axe.run());
      assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(node => node.target)]), []);
      await page.context().close();
    }
  }
});

test('how long an answer takes', async () => {
  const page = await open();
  await drawn(page);
  const times = await page.evaluate(async () => {
    const slider = document.querySelector('#rows input[type=range]');
    const all = [];
    for (let i = 0; i < 60; ++i) {
      slider.value = Number(slider.value) + 1;
      slider.dispatchEvent(new Event('input'));
      await new Promise(resolve => requestAnimationFrame(() => setTimeout(resolve)));
      all.push(window.slipproofTimes);
    }
    return all;
  });
  const middle = k => times.map(time => time[k]).sort((x, y) => x - y)[times.length / 2].toFixed(1);
  console.log(`an answer takes ${middle(0)} ms, with its pictures ${middle(1)} ms (medians of ${times.length})`);
});
