// The built book in a browser, from its folder: every page, wide and light, narrow and dark. Usage: node
// site.mjs HTML. Without a browser it says so and ends with status 77, which ctest takes as skipped; where CI
// is set that is a failure.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { packages } from '../../book/packages.mjs';

const site = path.resolve(process.argv[2]);
const executablePath = [
  process.env.BROWSER,
  '/usr/bin/chromium',
  '/usr/bin/chromium-browser',
  '/usr/bin/google-chrome',
].find((p) => p && fs.existsSync(p));
if (!executablePath) {
  console.error('no browser (chromium): the book was not looked at');
  process.exit(process.env.CI ? 1 : 77);
}
const { chromium } = packages('playwright-core');
const axe = fs.readFileSync(packages.resolve('axe-core/axe.min.js'), 'utf8');
const browser = await chromium.launch({
  executablePath,
  args: [
    '--no-sandbox',
    '--disable-gpu',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--no-first-run',
  ],
});

const faults = [];
const pages = fs
  .readdirSync(site)
  .filter((f) => f.endsWith('.html'))
  .sort();
const address = (name) => pathToFileURL(path.join(site, name)).href;
const ids = new Map();
const links = [];

/** What is wrong with a page as it stands, judged inside the page. */
function judged() {
  const wrong = [];
  const say = (what, element) =>
    wrong.push(`${what}: ${(element.outerHTML ?? String(element)).slice(0, 120)}`);
  if (document.documentElement.scrollWidth > window.innerWidth)
    wrong.push(`wider than the window by ${document.documentElement.scrollWidth - window.innerWidth}`);
  for (const svg of document.querySelectorAll('figure > svg')) {
    const box = svg.getBoundingClientRect();
    if (box.width < 100 || box.height < 50 || !svg.querySelector('path'))
      say('a figure without a drawing', svg);
    if (!svg.querySelector('title')?.textContent.trim()) say('a figure without a title', svg);
  }
  for (const image of document.images)
    if (!image.complete || !image.naturalWidth) say('an image that did not load', image);
  if (document.querySelectorAll('h1').length !== 1) wrong.push('not one h1');
  let level = 1;
  for (const heading of document.querySelectorAll('main :is(h1, h2, h3, h4)')) {
    if (heading.tagName[1] - level > 1) say('a heading that skips a level', heading);
    level = Number(heading.tagName[1]);
  }
  if (innerWidth > 1200)
    for (const formula of document.querySelectorAll('main .formula'))
      if (formula.scrollWidth > formula.clientWidth + 1) say('a formula wider than its column', formula);
  const text = document.createElement('div');
  text.innerHTML = document.body.innerHTML;
  text.querySelectorAll('pre, code, .katex-mathml, script, style').forEach((e) => e.remove());
  const raw = /\\[a-zA-Z]+|\$\$|\{\{|\}\}|:::|@(?:param|return|file)\b/.exec(text.textContent);
  if (raw) wrong.push(`raw TeX or a raw command: ${text.textContent.slice(raw.index - 20, raw.index + 30)}`);
  if (document.querySelector('.katex-error')) wrong.push('a formula that did not parse');
  return {
    wrong,
    shift: window.shift,
    ids: [...document.querySelectorAll('[id]')].map((e) => e.id),
    links: [...document.querySelectorAll('a[href], link[href]')].map((e) => e.href),
  };
}

const everything = { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'] };
const whatChanges = {
  runOnly: { type: 'rule', values: ['color-contrast', 'scrollable-region-focusable', 'link-in-text-block'] },
};

/** A tab in which one page after another is opened, wide or narrow, light or dark. */
async function tab(mode) {
  const context = await browser.newContext(mode);
  await context.addInitScript(watch);
  const page = await context.newPage();
  let name = 'index.html';
  const fault = (what) => faults.push(`${name} (${mode.name}): ${what}`);
  page.on('request', (r) => {
    if (!/^(file|data):/.test(r.url())) fault(`asks for ${r.url()}`);
  });
  page.on('requestfailed', (r) => fault(`did not get ${r.url()}`));
  page.on('console', (m) => {
    if (['error', 'warning'].includes(m.type())) fault(`says ${m.text()}`);
  });
  page.on('pageerror', (e) => fault(`throws ${e.message}`));
  await page.goto(address('index.html')); // so that no page is charged with the browser's own start
  for (name of pages) {
    await page.goto(address(name));
    await page.evaluate(async () => {
      for (const image of document.images) image.loading = 'eager';
      await Promise.all([
        document.fonts.ready,
        ...[...document.images].map((i) => i.decode().catch(() => {})),
      ]);
    });
    const found = await page.evaluate(judged);
    found.wrong.forEach(fault);
    if (found.shift > 0.01) fault(`its layout shifts by ${found.shift.toFixed(3)}`);
    if (mode.first) {
      ids.set(name, new Set(found.ids));
      found.links.forEach((to) => links.push([name, to]));
    }
    await page.evaluate(axe);
    const violations = await page.evaluate(
      async (options) =>
        (
          await window.axe.run(
            { exclude: ['.katex'] },
            { resultTypes: ['violations'], preload: false, ...options },
          )
        ).violations,
      mode.first ? everything : whatChanges,
    );
    for (const v of violations.filter((x) => ['serious', 'critical'].includes(x.impact)))
      fault(`${v.id}: ${v.help}, ${v.nodes.length} times, as at ${v.nodes[0].html.slice(0, 140)}`);
  }
  return page;
}

const watch = () => {
  window.shift = 0;
  new PerformanceObserver((list) =>
    list.getEntries().forEach((e) => {
      window.shift += e.value;
    }),
  ).observe({ type: 'layout-shift', buffered: true });
};
const [page] = await Promise.all([
  tab({ name: 'wide, light', first: true, viewport: { width: 1280, height: 900 }, colorScheme: 'light' }),
  tab({ name: 'narrow, dark', first: false, viewport: { width: 390, height: 800 }, colorScheme: 'dark' }),
]);

for (const [from, to] of links) {
  const { protocol, pathname, hash } = new URL(to);
  if (protocol !== 'file:') continue;
  const file = path.relative(site, decodeURIComponent(pathname));
  const anchor = decodeURIComponent(hash.slice(1));
  if (!fs.existsSync(path.join(site, file))) faults.push(`${from}: ${to} is not there`);
  else if (anchor && !ids.get(file)?.has(anchor)) faults.push(`${from}: ${to} has no such anchor`);
}

/** Opens a page and waits until it shows itself, which it does when its letters are there. */
async function open(name) {
  await page.goto(address(name));
  await page.waitForFunction(() => !document.documentElement.hasAttribute('style'));
}

// The search, from a page's own field, with old spelling and new.
const ask = async (words) => {
  await open('index.html');
  await page.fill('.find input', words);
  await page.press('.find input', 'Enter');
  await page.waitForFunction(() => document.getElementById('found')?.textContent);
  return page.$$eval('#results a', (all) => all.map((a) => a.getAttribute('href')));
};
if (!(await ask('apparatus')).includes('apparatus.html'))
  faults.push('the search does not find the apparatus');
const [today, old] = [await ask('curve given'), await ask('curue giuen')];
if (!today.length || String(today) !== String(old))
  faults.push(`the search takes u for v no more: ${today} against ${old}`);
if ((await ask('zzyzx')).length) faults.push('the search finds what is not there');

// By keyboard: the first stop leads to the text. Printed: no controls, and nothing cut.
await open('index.html');
await page.keyboard.press('Tab');
if ((await page.evaluate(() => document.activeElement.getAttribute('href'))) !== '#main')
  faults.push('the first stop of the keyboard is not the way to the text');
for (const name of pages.filter((f) => /^[a-z]+-\d\d\.html$/.test(f))) {
  await open(name);
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({ media: 'print' });
  await page.setViewportSize({ width: 640, height: 900 }); // what A4 leaves between its margins
  const cut = await page.evaluate(() =>
    [...document.querySelectorAll('main pre, main .table, main figure')]
      .filter((e) => e.offsetWidth && e.scrollWidth > e.clientWidth + 1)
      .map((e) => e.outerHTML.slice(0, 80)),
  );
  cut.forEach((c) => faults.push(`${name} (printed): cut off: ${c}`));
  if (
    await page.evaluate(
      () =>
        [...document.querySelectorAll('.banner, .contents-tree, .turn, main details:not([open])')].some(
          (e) => e.offsetHeight && !e.matches('details'),
        ) || document.querySelector('main details:not([open])'),
    )
  )
    faults.push(`${name} (printed): controls, or something folded`);
  await page.emulateMedia({ media: 'screen' });
  await page.setViewportSize({ width: 1280, height: 900 });
}
await browser.close();

console.log(`${pages.length} pages, ${links.length} links, ${faults.length} faults`);
if (faults.length) {
  console.error(faults.join('\n'));
  process.exit(1);
}
