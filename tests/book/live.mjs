// The pages that run themselves, in a browser, from their folder and without a network. Usage: node live.mjs HTML BIN (the book's
// pages, and the programs). Without a browser it says so and ends with status 77, which ctest takes as skipped; where CI is set
// that is a failure. With EVERY set it tries every page, not every fourth, and tells how long they take.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { asText, format } from '../../book/numbers.mjs';
import { packages } from '../../book/packages.mjs';
import { rows } from '../../book/table.mjs';
import { launch } from './browser.mjs';
import { settings } from './settings.mjs';
import { shown } from './shown.mjs';

const [site, bin] = process.argv.slice(2).map((p) => path.resolve(p));
const axe = fs.readFileSync(packages.resolve('axe-core/axe.min.js'), 'utf8');
const browser = await launch('the live pages were not tried', ['--js-flags=--expose-gc', '--enable-precise-memory-info']);
const faults = [];
const expect = (holds, what) => holds || faults.push(what);
const address = (name) => pathToFileURL(path.join(site, `${name}.html`)).href;

const context = await browser.newContext({ offline: true, viewport: { width: 1280, height: 900 } });
const page = await context.newPage();
page.setDefaultTimeout(120000); // where the machine is busy
process.on('uncaughtException', (error) => {
  console.error([...faults, error.stack].join('\n'));
  process.exit(1);
});
let requests = [];
page.on('request', (r) => {
  requests.push(r.url());
  expect(/^(file|data|blob):/.test(r.url()), `asks for ${r.url()}`);
});
page.on('pageerror', (e) => faults.push(`${page.url()}: throws ${e.message}`));
page.on(
  'console',
  (m) => ['error', 'warning'].includes(m.type()) && faults.push(`${page.url()}: says ${m.text()}`),
);

async function open(name, hash = '') {
  requests = [];
  await page.goto('about:blank');
  await page.goto(address(name) + hash);
  await page.waitForFunction(() => !document.documentElement.hasAttribute('style'));
}
const settled = () =>
  page.waitForFunction(() => document.documentElement.dataset.live === 'ready', null, { timeout: 60000 });
async function write(name, text) {
  await page.evaluate(() => delete document.documentElement.dataset.live);
  await page.fill(`.parameters input[name="${name}"]`, text);
  await settled();
}
const programs = fs
  .readdirSync(site)
  .filter((f) => /^[a-z]+-\d\d\.html$/.test(f))
  .map((f) => f.slice(0, -5));
const parametersOf = (program) => JSON.parse(execFileSync(path.join(bin, program), ['--json'])).parameters;

const state = () => page.evaluate(shown);

// --- Many changes of one page: the last one counts; the memory stays.
await open('pendulum-11');
for (let i = 1; i <= 100; i += 1)
  await page.evaluate(
    (x) => {
      const field = document.querySelector('input[name=zeta]');
      field.value = x;
      field.dispatchEvent(new Event('input'));
    },
    String(30 + i),
  );
await page.evaluate(() => delete document.documentElement.dataset.live);
await write('zeta', '77.5');
expect(
  (await page.textContent('pre.told code')).includes('--zeta 77.5'),
  'after many changes the last one is not what is shown',
);
for (let i = 0; i < 100; i += 1) await write('zeta', String(20 + i / 2));
const pid = () =>
  fs
    .readdirSync('/proc')
    .filter((p) => /^\d+$/.test(p))
    .map((p) => {
      try {
        const command = fs.readFileSync(`/proc/${p}/cmdline`, 'utf8');
        const [, parent] = /PPid:\s+(\d+)/.exec(fs.readFileSync(`/proc/${p}/status`, 'utf8'));
        return command.includes('--type=renderer') && parent
          ? Number(/VmRSS:\s+(\d+)/.exec(fs.readFileSync(`/proc/${p}/status`, 'utf8'))?.[1] ?? 0) / 1024
          : 0;
      } catch {
        return 0;
      }
    });
const memory = os.platform() === 'linux' ? Math.max(...pid()) : 0;
expect(memory < 400, `after a hundred changes the page takes ${memory.toFixed(0)} MB`);

// --- Euler's numbers, written otherwise, leave every page as it was woven.
let tried = 0;
for (const program of programs.filter((_, i) => process.env.EVERY || i % 4 === 0 || _ === 'pendulum-11')) {
  const p = parametersOf(program).find((x) => Number.isFinite(x.default));
  if (!p) continue;
  tried += 1;
  await open(program);
  expect(
    !requests.some((r) => r.startsWith(pathToFileURL(path.join(site, 'live')).href)),
    `${program}: loads something before it is touched`,
  );
  const woven = await state();
  expect(woven.figures.length, `${program}: has no figure`);
  const again =
    Number.isInteger(p.default) && p.kind === 'integer'
      ? `+${p.default}`
      : /[.e]/.test(String(p.default))
        ? `+${p.default}`
        : `${p.default}.0`;
  await write(p.name, again);
  const refusal = await page.textContent('#refusal');
  expect(!refusal, `${program}: ${p.name} = ${again} is refused: ${refusal}`);
  const told = await state();
  for (const what of Object.keys(woven))
    woven[what].forEach((before, i) =>
      expect(
        before === told[what][i],
        `${program}: of the ${what} the ${i + 1}st is not as woven: ${before.slice(0, 90)} … ${told[what][i]?.slice(0, 90)}`,
      ),
    );
  await page.click('.live-bar button');
  await page.waitForFunction(() => document.querySelector('.live-bar').hidden);
  const backAgain = await state();
  expect(
    JSON.stringify(backAgain) === JSON.stringify(woven),
    `${program}: the way back does not lead to the book's numbers`,
  );
}

// --- Other settings: what the page says is what the program says.
for (const [program, given] of [
  ['pendulum-11', { zeta: '60' }],
  ['pendulum-11', { eta: '1e-300rad' }],
  ['pendulum-05', { zeta: '150', t: '2.5' }],
  ['globe-04', { c: '0.2' }], // with a number in a formula
]) {
  await open(program);
  for (const [name, text] of Object.entries(given)) await write(name, text);
  const options = Object.entries(given).flatMap(([name, text]) => [`--${name}`, text]);
  const told = JSON.parse(execFileSync(path.join(bin, program), [...options, '--json']));
  const where = `${program} ${options.join(' ')}`;
  const shown = await page.$$eval('main data[data-name]', (all) =>
    all.map((e) => [e.dataset.name, e.dataset.format, e.textContent]),
  );
  for (const [full, spec, text] of shown) {
    const [chapter, number, name] = full.split('.');
    if (`${chapter}-${number}` !== program) continue;
    const it = [...told.parameters, ...told.values].find((x) => x.name === name);
    const number_ = format(it, spec);
    expect(
      [asText(number_), asText({ ...number_, suffix: '' })].includes(text),
      `${where}: ${full} reads ${text}, not ${asText(number_)}`,
    );
  }
  const inFormulae = await page.$$eval('main .katex-html [data-name]', (all) =>
    all.map((e) => [e.dataset.name, e.dataset.format, e.textContent]),
  );
  for (const [full, spec, text] of inFormulae) {
    const [chapter, number, name] = full.split('.');
    const it = `${chapter}-${number}` === program && [...told.parameters, ...told.values].find((x) => x.name === name);
    if (!it) continue;
    const { digits } = format(it, spec);
    expect(text.includes(digits), `${where}: in a formula ${full} reads "${text}", not ${digits}`);
  }
  for (const table of told.tables) {
    const html = await page
      .$eval(`table[data-table="${table.name}"] tbody`, (e) => e.innerHTML)
      .catch(() => null);
    if (html === null) continue;
    const same = await page.evaluate(
      ([a, b]) => {
        const body = document.createElement('tbody');
        body.innerHTML = b;
        return (
          body.textContent.replace(/\s+/g, ' ').trim() ===
          Object.assign(document.createElement('tbody'), { innerHTML: a })
            .textContent.replace(/\s+/g, ' ')
            .trim()
        );
      },
      [html, rows(table).join('\n')],
    );
    expect(same, `${where}: the table ${table.name} is not the program's`);
  }
  const text = await page.textContent('pre.told code');
  expect(text.includes(options.join(' ')), `${where}: the terminal does not show the command`);
  expect(
    (await page.textContent('.live-bar .with')).startsWith('with your '),
    `${where}: nothing says whose numbers these are`,
  );
  expect(
    (await page.evaluate(() => location.hash)) ===
      `#${Object.entries(given)
        .map(([n, t]) => `${n}=${t}`)
        .join('&')}`,
    `${where}: the address does not say so`,
  );
}

// --- By the slider and the keyboard, too; and the figure follows, in named colours.
await open('pendulum-05');
const before = await state();
await page.focus('input[data-slides="zeta"]');
await page.keyboard.press('ArrowRight');
await settled();
await page.waitForFunction(
  (was) => document.querySelector('main data[data-name="pendulum.05.phi"]')?.getAttribute('value') !== was,
  before.numbers.find((n) => n.startsWith('pendulum.05.phi|')).split('|')[2],
);
await open('pendulum-09');
const [drawn] = (await state()).figures;
await write('g', '6.22');
const [drawnAnew] = (await state()).figures;
expect(drawnAnew !== drawn, 'pendulum-09: with another g the figure is as it was');
expect(/var\(--\w+\)/.test(drawnAnew), 'pendulum-09: the figure is not in named colours');

// --- Refused input: the program's own sentence, beside the field, and the page stays as it is.
await open('pendulum-11');
const woven = await state();
for (const bad of ['181', 'abc', '1e999', '-1', '']) {
  await write('zeta', bad);
  let sentence = '';
  try {
    execFileSync(path.join(bin, 'pendulum-11'), ['--zeta', bad], { stdio: 'pipe' });
  } catch (error) {
    sentence = String(error.stderr)
      .trim()
      .replace(/^pendulum-11: /, '');
  }
  expect(
    (await page.textContent('#refusal')) === sentence,
    `zeta "${bad}": the page says ${await page.textContent('#refusal')}, the program ${sentence}`,
  );
  expect(
    (await page.getAttribute('input[name=zeta]', 'aria-invalid')) === 'true',
    `zeta "${bad}": the field is not marked`,
  );
}
expect(JSON.stringify(await state()) === JSON.stringify(woven), 'a refused number changes the page');
await write('zeta', '90');
expect((await page.textContent('#refusal')) === '', 'the refusal stays when the number is mended');

// --- The address.
await open('pendulum-11', '#zeta=60');
await settled();
expect((await page.inputValue('input[name=zeta]')) === '60', 'the address does not fill the field');
expect((await page.inputValue('input[name=eta]')) === '120', 'the field of eta does not follow');
await page.evaluate(() => {
  delete document.documentElement.dataset.live;
  location.hash = '#zeta=150';
});
await settled();
expect((await page.inputValue('input[name=zeta]')) === '150', 'a new address does not fill the field');

// --- Stop: of a section that takes its time, as soon as it can be stopped; then it goes on.
await open('balance-36');
await write('mu', '4');
await page.evaluate(() => {
  delete document.documentElement.dataset.live;
  const halt = document.querySelector('.live-bar button:last-child');
  new MutationObserver((_, observer) => {
    if (halt.hidden) return;
    observer.disconnect();
    halt.click();
  }).observe(halt, { attributes: true });
});
await page.fill('input[name=mu]', '62');
await settled();
expect(/^Stopped/.test(await page.textContent('#refusal')), 'nothing says that it was stopped');
await write('mu', '5');
expect((await page.textContent('#refusal')) === '', 'after a stop the page does not go on');
expect((await page.textContent('pre.told code')).includes('--mu 5'), 'after a stop nothing is told');

// --- The checks again.
await open('pendulum-11');
const claims = await page.$$eval('details.claims', (all) => all.map((e) => e.innerHTML));
await page.click('.again button');
await page.waitForFunction(
  () => /all hold|fail|:/.test(document.querySelector('.again [role=status]').textContent),
  null,
  { timeout: 60000 },
);
expect(
  /all hold/.test(await page.textContent('.again [role=status]')),
  `the checks again: ${await page.textContent('.again [role=status]')}`,
);
expect(
  JSON.stringify(await page.$$eval('details.claims', (all) => all.map((e) => e.innerHTML))) ===
    JSON.stringify(claims),
  'the claims, run again, are not as woven',
);

// --- Scenes: they start, move in true time, rest when not seen, and stop; the slider shows any time; less motion is heeded.
const withScenes = programs.filter((p) =>
  fs.readFileSync(path.join(site, `${p}.html`), 'utf8').includes('data-scene='),
);
let slowest = 0; // seconds of script, style and layout a frame
const cdp = await context.newCDPSession(page);
await cdp.send('Performance.enable');
for (const program of withScenes) {
  await open(program);
  await page.locator('figure[data-scene]').first().scrollIntoViewIfNeeded();
  const clock = async () => parseFloat(await page.textContent('figure[data-scene] .clock'));
  await page.click('figure[data-scene] .start');
  await page.waitForFunction(
    () => parseFloat(document.querySelector('figure[data-scene] .clock').textContent) > 0,
    null,
    { timeout: 60000 },
  );
  const used = async () => {
    const { metrics } = await cdp.send('Performance.getMetrics');
    return metrics
      .filter((m) => ['ScriptDuration', 'RecalcStyleDuration', 'LayoutDuration'].includes(m.name))
      .reduce((n, m) => n + m.value, 0);
  };
  const before_ = await used();
  const moves = await page.evaluate(
    () =>
      new Promise((done) => {
        const shape = () => document.querySelector('figure[data-scene] svg').innerHTML;
        const [start, first] = [performance.now(), shape()];
        let frames = 0;
        const count = () => {
          frames += 1;
          if (performance.now() - start < 500) requestAnimationFrame(count);
          else done({ moved: shape() !== first, frames });
        };
        requestAnimationFrame(count);
      }),
  );
  expect(moves.moved, `${program}: the scene does not move`);
  slowest = Math.max(slowest, ((await used()) - before_) / moves.frames);
  await page.click('figure[data-scene] .start');
  const stopped = await clock();
  await page.waitForTimeout(200);
  expect(stopped === (await clock()), `${program}: the scene does not stop`);
  await page.focus('figure[data-scene] .time');
  await page.keyboard.press('End');
  await page.waitForFunction(
    (t) => parseFloat(document.querySelector('figure[data-scene] .clock').textContent) !== t,
    stopped,
  );
}

// --- For everyone: fields, buttons and marks.
await open('pendulum-11');
await write('zeta', '60');
await page.evaluate(axe);
const violations = await page.evaluate(
  async () =>
    (await window.axe.run({ exclude: ['.katex'] }, { resultTypes: ['violations'], preload: false }))
      .violations,
);
for (const v of violations.filter((x) => ['serious', 'critical'].includes(x.impact)))
  faults.push(`${v.id}: ${v.help}, as at ${v.nodes[0].html.slice(0, 140)}`);

// --- How long: first touch to ready, and a change to all new, on every page; and whether the page answers while it runs. Told,
// not judged.
const touched = () =>
  page.evaluate(
    () =>
      new Promise((done) => {
        const start = performance.now();
        new MutationObserver(
          () => document.documentElement.dataset.live === 'ready' && done(performance.now() - start),
        ).observe(document.documentElement, { attributes: true });
        document.querySelector('.parameters input').focus();
      }),
  );
/** From the change of a field to all new: { took, held }, the latter the longest time that the page did not answer. */
const changed = ([name, text]) =>
  page.evaluate(
    ([field, x]) =>
      new Promise((done) => {
        delete document.documentElement.dataset.live;
        const start = performance.now();
        let [held, lastly] = [0, start];
        const ticking = setInterval(() => {
          held = Math.max(held, performance.now() - lastly);
          lastly = performance.now();
        }, 4);
        const watch = new MutationObserver(() => {
          if (document.documentElement.dataset.live !== 'ready') return;
          watch.disconnect();
          clearInterval(ticking);
          const now = performance.now();
          done({ took: now - start, held: Math.max(held, now - lastly) });
        });
        watch.observe(document.documentElement, { attributes: true });
        const input = document.querySelector(`.parameters input[name="${field}"]`);
        input.value = x;
        input.dispatchEvent(new Event('input'));
      }),
    [name, text],
  );
const [firsts, changes] = [[], []];
for (const program of process.env.EVERY ? programs : []) {
  const parameters = parametersOf(program);
  const given = settings(parameters);
  if (!given.length) continue;
  await open(program);
  firsts.push({ program, took: await touched() });
  for (const one of [{ [parameters[0].name]: String(parameters[0].default) }, ...given]) {
    const { took, held } = await changed(Object.entries(one)[0]);
    changes.push({ program, one, took, held });
  }
}
const sorted = (list, by) => [...list].sort((a, b) => a[by] - b[by]);
const middle = (list, by) => sorted(list, by)[list.length >> 1][by];
const worst = (list, by) => sorted(list, by).at(-1);
function slowly() {
  const slow = worst(changes, 'took');
  const stiff = worst(changes, 'held');
  return `first touch to ready ${middle(firsts, 'took').toFixed(0)} ms (worst ${worst(firsts, 'took').took.toFixed(0)}, ${worst(firsts, 'took').program}); \
a change ${middle(changes, 'took').toFixed(0)} ms (worst ${slow.took.toFixed(0)}, ${slow.program} with ${JSON.stringify(slow.one)}); \
the page held for ${stiff.held.toFixed(0)} ms at most (${stiff.program}); `;
}

// --- How much: the modules as the folder has them, compressed.
const sizes = Object.fromEntries(
  fs.readdirSync(path.join(site, 'live')).map((f) => [f, fs.statSync(path.join(site, 'live', f)).size / 1e6]),
);
for (const chapter of new Set(programs.map((p) => p.split('-')[0])))
  expect(sizes[`${chapter}.js`] <= 1.3, `live/${chapter}.js has ${sizes[`${chapter}.js`].toFixed(2)} MB`);
expect(sizes['gnuplot.js'] <= 0.75, `live/gnuplot.js has ${sizes['gnuplot.js'].toFixed(2)} MB`);

await browser.close();

console.log(
  `${tried} pages with Euler's numbers, ${withScenes.length} scenes; ${changes.length ? slowly() : ''}after a hundred changes ${memory.toFixed(0)} MB; \
a frame of a scene ${(slowest * 1000).toFixed(1)} ms; ${Object.entries(sizes)
    .map(([file, size]) => `${file} ${size.toFixed(2)} MB`)
    .join(', ')}; ${faults.length} faults`,
);
if (faults.length) {
  console.error(faults.join('\n'));
  process.exit(1);
}
