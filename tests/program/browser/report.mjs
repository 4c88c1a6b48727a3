// What a reader of the report meets in a browser: nothing is fetched, nothing complains, everything can be reached.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const report = pathToFileURL('index.html').href;
const project = process.env.PROJECT;
let browser;

before(async () => {
  browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
});
after(async () => browser?.close());

// A page that has loaded the report, with all that it said and asked for.
async function open({ width = 1280, colorScheme = 'light', media = 'screen', javaScriptEnabled = true, url = report } = {}) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme, javaScriptEnabled });
  const page = await context.newPage();
  page.said = [];
  page.asked = [];
  page.on('console', message => page.said.push(message.text()));
  page.on('pageerror', error => page.said.push(String(error)));
  page.on('request', request => page.asked.push(request.url()));
  await page.emulateMedia({ media, colorScheme });
  await page.goto(url);
  return page;
}

const solve = scene => JSON.parse(execFileSync(process.env.SLIPPROOF, ['solve', '--json', scene], { encoding: 'utf8' }));

test('loads from a file without a complaint and without asking for anything', async () => {
  const page = await open();
  assert.deepEqual(page.said, []);
  assert.deepEqual(page.asked.filter(url => url !== report && !url.startsWith('data:')), []);
  const times = await page.evaluate(() => new Promise(resolve => {
    const loaded = performance.getEntriesByType('navigation')[0].loadEventEnd;
    new PerformanceObserver(list => {
      const painted = list.getEntriesByName('first-contentful-paint')[0];
      if (painted) resolve([painted.startTime, loaded]);
    }).observe({ type: 'paint', buffered: true });
  }));
  console.log(`first contentful paint after ${Math.round(times[0])} ms, loaded after ${Math.round(times[1])} ms`);
});

test('sections are there, their links lead to them, a link to a claim opens it', async () => {
  const page = await open();
  for (const link of await page.locator('nav a').all()) {
    const target = (await link.getAttribute('href')).slice(1);
    await link.click();
    assert.equal(await page.evaluate(() => location.hash.slice(1)), target);
    assert.ok(await page.locator(`[id="${target}"]`).isVisible());
  }
  await page.locator('#errata a').first().click();
  const id = await page.evaluate(() => decodeURIComponent(location.hash.slice(1)));
  assert.ok(await page.locator(`[id="${id}"]`).evaluate(claim => claim.open));
});

test('the filter shows what it says', async () => {
  const page = await open();
  const visible = () => page.locator('.claim:visible').count();
  const all = await visible();
  await page.locator('#show-failing').check();
  const failing = await visible();
  assert.equal(failing, await page.locator('.claim.failing').count());
  assert.ok(0 < failing && failing < all);
});

// The motions at a point as the tooltip has them: [modes, {quantity: value}].
async function tooltip(figure) {
  return figure.locator('.tip').evaluate(tip => {
    const motions = [];
    for (const child of tip.children) {
      if (child.classList.contains('motion')) motions.push([child.textContent, {}]);
      if (child.tagName !== 'DL') continue;
      const names = [...child.querySelectorAll('dt')], values = [...child.querySelectorAll('dd')];
      names.forEach((name, i) => { motions.at(-1)[1][name.textContent] = values[i].textContent; });
    }
    return { place: tip.firstChild.textContent, motions };
  });
}

// The same from solve --json; quantities that are 0 do not stand in a tooltip.
function solved(scene) {
  return solve(scene).motions.map(motion => {
    const { modes, boundary_modes, status, accelerations, forces, force_ranges } = motion;
    const undetermined = Object.keys(force_ranges).map(name => [name, 'undetermined']);
    const named = [...Object.entries({ ...accelerations, ...forces }).filter(([, value]) => value !== '0'), ...undetermined];
    return [[...modes, ...boundary_modes].join(' = ') + (status === 'strict' ? '' : ' (boundary)'), Object.fromEntries(named)];
  });
}

test('tooltips say exactly what solve --json says at the same point', async () => {
  const page = await open();
  for (const name of ['city-bicycle', 'pulled-pedal', 'reduced-form']) {
    const text = readFileSync(`${project}/cases/${name}.toml`, 'utf8');
    const title = /^name = "(.*)"/m.exec(text)[1];
    const figure = page.locator('.grid .phase', { has: page.getByRole('heading', { name: title, exact: true }) });
    const svg = figure.locator('.plot svg');
    await svg.scrollIntoViewIfNeeded();
    const box = await svg.boundingBox();
    for (const [across, up] of [[0.35, 0.2], [0.5, 0.5], [0.8, 0.75]]) {
      await page.mouse.move(box.x + across * box.width, box.y + up * box.height);
      const shown = await tooltip(figure);
      const [, f, F] = /^f = (\S+), +F = (\S+)$/.exec(shown.place);
      const scene = text.replace(/^f = .*$/m, `f = "${f}"`).replace(/^[FP] = .*$/m, '')
        .replace(/^kind = .*$/m, line => `${line}\nF = "${F}"`);
      writeFileSync('scene.toml', scene);
      assert.deepEqual(shown.motions, solved('scene.toml'), `${name} at ${shown.place}`);
    }
  }
});

test('the arrow keys go from point to point, Escape hides, leaving hides', async () => {
  const page = await open();
  const figure = page.locator('#plane-b');
  await figure.locator('.plot').focus();
  const first = await tooltip(figure);
  await page.keyboard.press('ArrowRight');
  const second = await tooltip(figure);
  assert.notEqual(first.place, second.place);
  await page.keyboard.press('ArrowLeft');
  assert.deepEqual(await tooltip(figure), first);
  await page.keyboard.press('Escape');
  assert.ok(await figure.locator('.tip').isHidden());
});

test('a hostile name is text', async () => {
  const name = '</script><img src=x onerror="document.title=1">&amp;<b>bold</b>';
  const scene = readFileSync(`${project}/cases/city-bicycle.toml`, 'utf8').replace(/^name = .*$/m, `name = '${name}'`);
  writeFileSync('hostile.toml', scene);
  const svg = execFileSync(process.env.SLIPPROOF, ['map', 'hostile.toml', '--columns', '20'], { encoding: 'utf8' });
  writeFileSync('hostile.svg', svg);
  const page = await (await browser.newContext()).newPage();
  const asked = [];
  page.on('request', request => asked.push(request.url()));
  await page.goto(pathToFileURL('hostile.svg').href);
  assert.ok((await page.evaluate(() => document.documentElement.textContent)).includes(name));
  assert.equal(await page.locator('img, b, script').count(), 0);
  assert.equal(asked.length, 1);
});

for (const colorScheme of ['light', 'dark']) {
  test(`axe-core finds nothing to object to, ${colorScheme}`, async () => {
    const page = await open({ colorScheme });
    await page.evaluate(() => document.querySelectorAll('details.failing').forEach(d => { d.open = true; }));
    await page.evaluate(axe);
    const found = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
    const told = found.violations.map(v => `${v.id}: ${v.nodes.length}, ${v.nodes[0].html.slice(0, 200)} ${v.nodes[0].failureSummary}`);
    assert.deepEqual(told, []);
  });
}

for (const width of [360, 768, 1280]) {
  test(`nothing sticks out at a width of ${width}`, async () => {
    const page = await open({ width });
    await page.evaluate(() => document.querySelectorAll('details.failing').forEach(d => { d.open = true; }));
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(overflow <= 0, `${overflow} pixels`);
    await page.screenshot({ path: `report-${width}.png` });
  });
}

test('every table is whole at a width of 1280, without scrolling', async () => {
  const page = await open({ width: 1280 });
  const cut = await page.evaluate(() => [...document.querySelectorAll('.scroll')]
    .filter(e => e.scrollWidth > e.clientWidth).map(e => `${e.getAttribute('aria-label')}: ${e.scrollWidth - e.clientWidth} pixels`));
  assert.deepEqual(cut, []);
});

for (const width of [400, 1400]) {
  test(`the arithmetic of a counterexample is not cut off at a width of ${width}`, async () => {
    const page = await open({ width });
    const [shown, beyond] = await page.evaluate(() => {
      document.querySelectorAll('details').forEach(d => { d.open = true; });
      const parts = [...document.querySelectorAll('.by-hand *')];
      const sticksOut = e => e.getBoundingClientRect().right > e.closest('.counterexample').getBoundingClientRect().right;
      return [parts.length, parts.filter(sticksOut).map(e => e.outerHTML.slice(0, 120)).slice(0, 3)];
    });
    assert.ok(shown > 100);
    assert.deepEqual(beyond, []);
  });
}

// What fits between the margins of A4 and of Letter, in CSS pixels.
for (const [paper, width] of [['A4', 688], ['Letter', 710]]) {
  test(`on ${paper} nothing is dark or cut off, and on demand nothing is folded`, async () => {
    const page = await open({ width, media: 'print', colorScheme: 'dark', javaScriptEnabled: false });
    await page.evaluate(() => { document.getElementById('print-all').checked = true; });
    const hanging = 5;  // a blank at the end of a full line
    const found = await page.evaluate(hanging => ({
      beyond: [...document.querySelectorAll('main *')]
        .filter(e => !e.closest('svg') && e.getBoundingClientRect().right > innerWidth + hanging).map(e => e.outerHTML.slice(0, 120)).slice(0, 3),
      folded: [...document.querySelectorAll('details:not(.copy) > :not(summary, .download, .explore)')]
        .filter(e => !e.checkVisibility({ contentVisibilityAuto: true })).length,
      ink: getComputedStyle(document.body).color,
      backgrounds: [...document.querySelectorAll('main *')].map(e => getComputedStyle(e).backgroundColor)
        .filter(c => !/, 0\)$/.test(c) && /\d+/g.exec(c)[0] < 200).length,
    }), hanging);
    assert.deepEqual(found.beyond, []);
    assert.equal(found.folded, 0);
    assert.equal(found.ink, 'rgb(29, 39, 51)');
    assert.equal(found.backgrounds, 0);
  });
}

test('the shipped paper prints on 25 pages of A4 at most', async () => {
  const page = await open({ media: 'print', url: pathToFileURL('papers/rozenblat-yashin.html').href });
  const printed = (await page.pdf({ format: 'A4' })).toString('latin1');
  const pages = Math.max(...[...printed.matchAll(/\/Count (\d+)/g)].map(([, count]) => Number(count)));
  console.log(`${pages} pages`);
  assert.ok(5 < pages && pages <= 25, `${pages} pages`);
});

test("a script unfolds on demand what browsers without the style for it would leave folded, and folds it again", async () => {
  const page = await open();
  const folded = () => page.locator('details:not([open])').count();
  const before = await folded();
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.equal(await folded(), before);
  await page.locator('#print-all').check();
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.equal(await folded(), 0);
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await folded(), before);
});

test('everything can be read without a script', async () => {
  const page = await open({ javaScriptEnabled: false });
  assert.ok(await page.locator('#plane-b svg').first().isVisible());
  await page.locator('#plane-b details summary').click();
  assert.ok(await page.locator('#plane-b details table').isVisible());
});

// The explorer, where it is built, has a test of its own.
const papers = readdirSync('papers').filter(name => name.endsWith('.html') && name !== 'explorer.html');

// The page about a contact problem has the same manners.
for (const name of [...papers.map(paper => `papers/${paper}`), 'contact.html']) {
  test(`${name}: quiet, whole at two widths, and nothing for axe-core`, async () => {
    const url = pathToFileURL(name).href;
    for (const width of [1280, 400]) {
      const page = await open({ width, url });
      assert.deepEqual(page.said, []);
      assert.deepEqual(page.asked.filter(asked => asked !== url && !asked.startsWith('data:')), []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `sticks out at ${width}`);
      if (width > 400) {
        await page.evaluate(axe);
        const found = await page.evaluate(() => axe.run());
        assert.deepEqual(found.violations.map(v => `${v.id}: ${v.nodes[0].html}`), []);
        for (const claim of await page.locator('.claim').all()) await claim.evaluate(c => { c.open = true; });
        for (const picture of await page.locator('.claim svg').all()) {
          const box = await picture.boundingBox();
          assert.ok(box === null || (box.width > 0 && box.height > 0), 'an empty picture');
        }
      }
      await page.context().close();
    }
  });
}

test('the page of all papers is filtered by keys, and what is focused is in view', async () => {
  const page = await open({ width: 1000, url: pathToFileURL('papers/index.html').href });
  const shown = () => page.locator('.paper.item:visible h2 a').evaluateAll(all => all.map(a => a.getAttribute('href')));
  const all = await page.locator('.paper.item').count();
  await page.locator('input[type=search]').focus();
  await page.keyboard.type('PAINLEVE rod');
  assert.deepEqual(await shown(), ['painleve-rod.html']);
  assert.equal(await page.locator('.search output').textContent(), `1 of ${all}`);
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Delete');
  assert.equal(await page.locator('.paper.item:visible').count(), all);
  await page.goto(pathToFileURL('papers/two-wheeler.html').href);
  await page.locator('#reproduce pre').focus();
  for (let i = 0; i < 20; ++i) {
    await page.keyboard.press('Shift+Tab');
    assert.ok(await page.evaluate(() => {
      const { top, bottom, height } = document.activeElement.getBoundingClientRect();
      const bar = document.querySelector('.top');
      const from = getComputedStyle(bar).position === 'sticky' ? bar.offsetHeight : 0;
      const room = innerHeight - parseFloat(getComputedStyle(document.documentElement).scrollPaddingTop);
      return height > room ? bottom > from && top < innerHeight : top >= from && bottom <= innerHeight;
    }), await page.evaluate(() => document.activeElement.outerHTML.slice(0, 200)));
  }
});

test('the page of all papers leads to each of them, and they lead back', async () => {
  const page = await open({ url: pathToFileURL('papers/index.html').href });
  const all = await page.locator('.paper a:not([href^="https:"])').evaluateAll(all => all.map(a => a.getAttribute('href')));
  const links = [...new Set(all.map(href => href.replace(/#errata$/, '')))];
  assert.deepEqual([...links, 'index.html'].sort(), [...papers].sort());
  for (const link of links) {
    await page.goto(pathToFileURL(`papers/${link}`).href);
    await page.getByRole('link', { name: 'All sources' }).click();
    assert.ok(page.url().endsWith('/papers/index.html'));
  }
});
