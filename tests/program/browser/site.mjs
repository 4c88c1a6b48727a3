// What a reader of the site meets in a browser, from a file: the front page with its explorer, and pages that are found.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
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

async function open(file, { width = 1400, colorScheme = 'light' } = {}) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme });
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

test('the front page runs the explorer, alone, at every width, in light and dark', async () => {
  for (const [width, colorScheme] of [[1400, 'light'], [800, 'dark'], [400, 'light']]) {
    const page = await open('index.html', { width, colorScheme });
    const frame = await (await page.waitForSelector('iframe.explorer')).contentFrame();
    await frame.waitForSelector('body[data-ready]', { timeout: 60000 });
    assert.equal(await frame.locator('#pictures figure').count(), 3);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `wider than ${width}`);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa'] }));
    assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes[0].html}`), []);
    assert.deepEqual(page.wrong, []);
  }
});

test('every link of the front page and of the pages leads to a file', () => {
  const missing = new Set();
  for (const file of [join(site, 'index.html'), ...pages(join(site, 'pages'))]) {
    if (file.endsWith('/404.html')) continue;  // its links are those of a server
    for (const [, target] of readFileSync(file, 'utf8').matchAll(/(?:href|src)="([^"#?]+)/g)) {
      if (/^[a-z]+:/.test(target) || target.startsWith('//')) continue;
      const found = fileURLToPath(new URL(target.replaceAll('&amp;', '&'), pathToFileURL(file)));
      if (!existsSync(found)) missing.add(`${file}: ${target}`);
    }
  }
  assert.deepEqual([...missing].slice(0, 10), []);
});

// What somebody asks in the first hour, and a page that must be among the first five answers.
const questions = [
  ['install', 'index.html'],
  ['does it stand', 'cases/mechanisms/bodies/index.html'],
  ['certify tolerance', 'cases/CERTIFYING.html'],
  ['exit codes', 'index.html'],
  ['URDF', 'cases/imported/index.html'],
  ['continuum', 'proofs/GLOSSARY.html'],
  ['FCLIB', 'src/contact/formats/FORMATS.html'],
  ['Python', 'src/faces/python/index.html'],
  ['Coq', 'proofs/coq/index.html'],
  ['Painlevé', 'proofs/painleve-rod/index.html'],
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

test('pages can be read by everyone', async () => {
  for (const file of ['index.html', 'cases/CERTIFYING.html', 'COMMAND_LINE.html', 'proofs/ladder/index.html']) {
    for (const [width, colorScheme] of [[1400, 'light'], [400, 'dark']]) {
      const page = await open(`pages/${file}`, { width, colorScheme });
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa'] }));
      assert.deepEqual(violations.map(v => `${file}: ${v.id}: ${v.nodes[0].html}`), []);
    }
  }
});
