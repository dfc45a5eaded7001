// The built book in a browser, from its folder: every page, wide and light, narrow and dark. Usage: node
// site.mjs HTML. Without a browser it says so and ends with status 77, which ctest takes as skipped; where CI
// is set that is a failure.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { packages } from '../../book/packages.mjs';
import { launch } from './browser.mjs';

const site = path.resolve(process.argv[2]);
const axe = fs.readFileSync(packages.resolve('axe-core/axe.min.js'), 'utf8');
const browser = await launch('the book was not looked at');

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
  for (const svg of document.querySelectorAll('figure svg:not(.katex svg)')) {
    const box = svg.getBoundingClientRect();
    if (box.width < 100 || box.height < 50 || !svg.querySelector('path, polyline'))
      say('a figure without a drawing', svg);
    if (!svg.querySelector('title')?.textContent.trim()) say('a figure without a title', svg);
    if (document.querySelector('[id^="eq-"]'))
      for (const word of svg.querySelectorAll('text'))
        for (const [, number] of word.textContent.matchAll(/(?:^|[\s,])\((\d+|[A-Z])\)/g))
          if (!document.getElementById(`eq-${number}`)) say(`a figure names a formula (${number}) that the page has not`, word);
  }
  for (const image of document.images)
    if (image.loading === 'lazy') say('an image that is missing in print until it has been seen', image);
    else if (!image.complete || !image.naturalWidth) say('an image that did not load', image);
  const dots = document.querySelectorAll('.needs circle');
  document.querySelectorAll('.needs li').forEach((li, i) => {
    const [line, dot] = [li, dots[i]].map((e) => e.getBoundingClientRect());
    if (dot.top < line.top - 2 || dot.bottom > line.bottom + 2) say('a dot of the map beside its line', li);
  });
  for (const svg of document.querySelectorAll('figure.scene svg'))
    if (svg.getBoundingClientRect().width > svg.parentElement.clientWidth + 1) say('a scene that is cut', svg);
  if (innerWidth < 500) {
    for (const svg of document.querySelectorAll('figure svg:not(.katex svg)'))
      for (const word of svg.querySelectorAll('text, tspan[font-size]')) {
        const scale = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
        if (word.textContent.trim() && parseFloat(getComputedStyle(word).fontSize) * scale < 9.99) {
          say('letters below 10 pixels in a figure', word);
          break;
        }
      }
    for (const formula of document.querySelectorAll('main .katex-display')) {
      let [above, below, right] = [-Infinity, -Infinity, -Infinity]; // the row before, this row, and how far it has come
      for (const piece of formula.querySelectorAll('.katex-base')) {
        const box = piece.getBoundingClientRect();
        if (!box.height) continue;
        if (box.left < right - 1) [above, below] = [below, -Infinity];
        [below, right] = [Math.max(below, box.bottom), box.right];
        if (box.top < above + 4) say('a broken formula whose rows touch', formula.querySelector('annotation'));
      }
    }
    for (const block of document.querySelectorAll('pre.told'))
      if (block.scrollWidth > block.clientWidth + 1) say('the program’s words are cut', block);
  }
  if (getComputedStyle(document.documentElement).visibility !== 'visible') wrong.push('hidden');
  for (const number of document.querySelectorAll('data.told'))
    if (!document.getElementById('numbers')?.textContent.includes(`"${number.dataset.name}"`))
      say('a number without its explanation', number);
  if (document.querySelectorAll('h1').length !== 1) wrong.push('not one h1');
  let level = 1;
  for (const heading of document.querySelectorAll('main :is(h1, h2, h3, h4)')) {
    if (heading.tagName[1] - level > 1) say('a heading that skips a level', heading);
    level = Number(heading.tagName[1]);
  }
  if (innerWidth > 1200)
    for (const folded of document.querySelectorAll('details.claims')) {
      folded.open = true;
      const table = folded.querySelector('.table');
      if (table && table.scrollWidth > table.clientWidth + 2) say('a table of claims that is cut', table);
      folded.open = false;
    }
  if (innerWidth > 1200)
    for (const formula of document.querySelectorAll('main .formula'))
      if (formula.scrollWidth > formula.clientWidth + 1) say('a formula wider than its column', formula);
  for (const formula of document.querySelectorAll('main .katex-display')) {
    let [above, below, left] = [-Infinity, -Infinity, Infinity]; // the ends of two lines of a broken formula
    for (const part of formula.querySelectorAll('.katex-base')) {
      const box = part.getBoundingClientRect();
      if (box.left < left) [above, below] = [below, -Infinity];
      if (box.top < above + 4) say('lines of a broken formula that touch', formula);
      [below, left] = [Math.max(below, box.bottom), box.left];
    }
  }
  const text = document.createElement('div');
  text.innerHTML = document.body.innerHTML;
  text.querySelectorAll('pre, code, .katex-mathml, script, style').forEach((e) => e.remove());
  const raw = /\\[a-zA-Z]+|\$\$|\{\{|\}\}|:::|@(?:param|return|file)\b/.exec(text.textContent);
  if (raw) wrong.push(`raw TeX or a raw command: ${text.textContent.slice(raw.index - 20, raw.index + 30)}`);
  const stroke = document.body.classList.contains('library') ? null : /\p{L}['"]|"\p{L}/u.exec(text.textContent);
  if (stroke) wrong.push(`a straight apostrophe or quotation mark: ${text.textContent.slice(stroke.index - 20, stroke.index + 30)}`);
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
  context.setDefaultTimeout(180_000); // a busy machine is no fault of the book
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

/** Opens a page and waits for its letters. */
async function open(name) {
  await page.goto(address(name));
  await page.evaluate(() => document.fonts.ready);
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
const mean = await ask('arithmetic-geometric mean');
const firstOfLibrary = mean.findIndex((to) => /^(namespace|class|struct|concept|.*_8hpp)/.test(to));
if (!mean.length || (firstOfLibrary >= 0 && mean.slice(firstOfLibrary).some((to) => /-\d\d\.html$/.test(to))))
  faults.push(`the search puts the library before the sections: ${mean}`);
const [phrase, turned, words] = [
  await ask('"swings in the same time"'),
  await ask('"time in the same swings"'),
  await ask('swings in the same time'),
];
if (!phrase.length || turned.length || words.length <= phrase.length)
  faults.push(`a phrase finds ${phrase.length} pages, its words ${words.length}, and turned round ${turned.length}`);

// The keys, the explanation of a number, what is copied.
await open('pendulum-11.html');
await page.keyboard.press('/');
if (!(await page.evaluate(() => document.activeElement.matches('.find input'))))
  faults.push('/ does not lead to the search');
await page.evaluate(() => document.activeElement.blur());
for (const [key, rel] of [
  ['ArrowRight', 'next'],
  ['ArrowLeft', 'prev'],
]) {
  await open('pendulum-11.html');
  const to = await page.evaluate((r) => document.querySelector(`link[rel=${r}]`).href, rel);
  await Promise.all([page.waitForURL(to), page.keyboard.press(key)]).catch(() => faults.push(`${key} does not turn the page`));
}
await open('pendulum-11.html');
const explained = () => page.evaluate(() => document.querySelector('.explains:not([hidden])')?.textContent ?? '');
await page.locator('main data.told').first().click();
if (!/check/.test(await explained())) faults.push(`a number pressed says "${await explained()}"`);
await page.keyboard.press('Escape');
if (await explained()) faults.push('an explanation does not go away');
await page.locator('main data.told').first().focus();
await page.keyboard.press('Enter');
if (!(await explained())) faults.push('a number does not explain itself to the keyboard');
const taken = await page.evaluate(async () => {
  let text = '';
  Object.defineProperty(navigator, 'clipboard', { value: { writeText: async (t) => (text = t) } });
  document.querySelector('.copyable.told .copy').click();
  await new Promise((done) => setTimeout(done, 0));
  return text;
});
if (!/^pendulum-11\n/.test(taken) || /^\$|…/.test(taken)) faults.push(`the copy button gives "${taken.slice(0, 40)}"`);
const copied = await page.evaluate(() => {
  const paragraph = [...document.querySelectorAll('main p')].find((p) => p.querySelector('.katex'));
  getSelection().selectAllChildren(paragraph);
  let text = '';
  document.addEventListener('copy', (e) => (text = e.clipboardData.getData('text/plain')), { once: true });
  document.execCommand('copy');
  return { text, formulae: paragraph.querySelectorAll('.katex').length };
});
if ((copied.text.match(/\$[^$]+\$/g) ?? []).length !== copied.formulae || /htmlData/.test(copied.text))
  faults.push(`a paragraph is copied as "${copied.text}"`);
let thrown = '';
page.once('pageerror', (e) => (thrown = e.message));
await page.goto(`${address('pendulum-11.html')}#100%`);
await page.reload();
if (thrown) faults.push(`#100% throws: ${thrown}`);

// Scenes: nothing comes before the first touch; then they move, stop, and follow the slider; less motion is heeded. (What plays
// where a page runs itself, live.mjs tries.)
for (const name of pages) {
  if (!fs.readFileSync(path.join(site, name), 'utf8').includes('data-frames=')) continue;
  await open(name);
  const scripts = () => page.evaluate(() => document.querySelectorAll('script[src*="scene"]').length);
  if (await scripts()) faults.push(`${name}: the scene comes unasked`);
  const clock = async () => parseFloat(await page.textContent('.scene .clock'));
  const shape = () => page.evaluate(() => document.querySelector('.scene svg').innerHTML);
  const still = await shape();
  await page.locator('.scene').first().scrollIntoViewIfNeeded();
  await page.click('.scene .start');
  await page
    .waitForFunction(() => parseFloat(document.querySelector('.scene .clock').textContent) > 0)
    .catch(() => faults.push(`${name}: the scene does not start`));
  if ((await shape()) === still) faults.push(`${name}: the scene does not move`);
  await page.click('.scene .start');
  const stopped = await clock();
  await page.waitForTimeout(100);
  if (stopped !== (await clock())) faults.push(`${name}: the scene does not stop`);
  await page.focus('.scene .time');
  await page.keyboard.press('Home');
  await page
    .waitForFunction(() => parseFloat(document.querySelector('.scene .clock').textContent) === 0)
    .catch(() => faults.push(`${name}: the slider does not lead back`));
  await page.emulateMedia({ reducedMotion: 'reduce' });
  if (await page.isVisible('.scene .start')) faults.push(`${name}: the scene would move where less motion is asked for`);
  await page.emulateMedia({ reducedMotion: 'no-preference' });
}

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
    [...document.querySelectorAll('main pre, main .table, main figure, main .claims td')]
      .filter((e) => e.offsetWidth && e.scrollWidth > e.clientWidth + 1)
      .map((e) => e.outerHTML.slice(0, 80)),
  );
  cut.forEach((c) => faults.push(`${name} (printed): cut off: ${c}`));
  if (
    await page.evaluate(
      () =>
        [...document.querySelectorAll('.banner, .contents-tree, .turn, .plain, button, input[type="range"]')].some(
          (e) => e.offsetHeight,
        ) || document.querySelector('main details:not([open], .plain)'),
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
