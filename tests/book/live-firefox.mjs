// The pages that run themselves in a second browser, in short: from their folder, and without a network. Usage: node
// live-firefox.mjs HTML BIN (the book's pages, and the programs). Without Firefox it says so and ends with status 77, which ctest
// takes as skipped.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { asText, format } from '../../book/numbers.mjs';
import { Firefox } from './marionette.mjs';
import { shown } from './shown.mjs';

const [site, bin] = process.argv.slice(2).map((p) => path.resolve(p));
const program = ['/usr/bin/firefox-esr', '/usr/bin/firefox'].find((p) => fs.existsSync(p));
if (!program) {
  console.error('no Firefox: the live pages were not tried in it');
  process.exit(77);
}
const faults = [];
const expect = (holds, what) => holds || faults.push(what);
const firefox = await Firefox.begin(program);
const open = (page, hash = '') => firefox.open(`${pathToFileURL(path.join(site, `${page}.html`)).href}${hash}`);

/** Writes into a field, and waits until all is new. */
const write = (name, text) =>
  firefox.run(
    (field, x) =>
      new Promise((done) => {
        const { documentElement } = document;
        delete documentElement.dataset.live;
        new MutationObserver((_, watch) => {
          if (documentElement.dataset.live !== 'ready') return;
          watch.disconnect();
          done();
        }).observe(documentElement, { attributes: true });
        const input = document.querySelector(`.parameters input[name="${field}"]`);
        input.focus();
        input.value = x;
        input.dispatchEvent(new Event('input', { bubbles: true }));
      }),
    name,
    text,
  );
const refusal = () => firefox.run(() => document.getElementById('refusal').textContent);
const until = (what) =>
  firefox.run(
    `() => new Promise((done) => { const look = () => ((${what})() ? done() : setTimeout(look, 20)); look(); })`,
  );

try {
  // --- Euler's numbers, written otherwise, leave the page as it was woven.
  await open('pendulum-11');
  const woven = await firefox.run(shown);
  await write('zeta', '90.0');
  const told = await firefox.run(shown);
  expect(woven.numbers.length && woven.formulae.length && woven.figures.length, 'pendulum-11 has nothing to change');
  for (const [what, before] of Object.entries(woven)) {
    before.forEach((was, i) => expect(was === told[what][i], `of the ${what} the ${i + 1}st is not as woven`));
  }

  // --- Other numbers: what the page says is what the program says.
  await write('zeta', '60');
  const { parameters, values } = JSON.parse(execFileSync(path.join(bin, 'pendulum-11'), ['--zeta', '60', '--json']));
  const numbers = await firefox.run(() =>
    [...document.querySelectorAll('main data[data-name]')].map((e) => [e.dataset.name, e.dataset.format, e.textContent]),
  );
  for (const [full, spec, text] of numbers.filter(([name]) => name.startsWith('pendulum.11.'))) {
    const number = format([...parameters, ...values].find((x) => full.endsWith(`.${x.name}`)), spec);
    const allowed = [asText(number), asText({ ...number, suffix: '' })];
    expect(allowed.includes(text), `with 60°, ${full} reads ${text}, not ${allowed[0]}`);
  }
  expect((await firefox.run(() => location.hash)) === '#zeta=60', 'the address does not say 60°');

  // --- Refused input, and the way back.
  await write('zeta', '181');
  let sentence = '';
  try {
    execFileSync(path.join(bin, 'pendulum-11'), ['--zeta', '181'], { stdio: 'pipe' });
  } catch (error) {
    sentence = String(error.stderr).trim().replace('pendulum-11: ', '');
  }
  expect((await refusal()) === sentence, `181° is refused by "${await refusal()}", not "${sentence}"`);
  await firefox.run(() => document.querySelector('.live-bar button').click());
  await until(() => document.querySelector('.live-bar').hidden);
  expect(JSON.stringify(await firefox.run(shown)) === JSON.stringify(woven), 'the way back does not lead to the book');

  // --- The checks again.
  await firefox.run(() => document.querySelector('.again button').click());
  await until(() => / s: |fail|:/.test(document.querySelector('.again [role=status]').textContent));
  const verdict = await firefox.run(() => document.querySelector('.again [role=status]').textContent);
  expect(/all hold/.test(verdict), `the checks again: ${verdict}`);

  // --- A figure is drawn anew.
  await open('pendulum-09');
  const [drawn] = (await firefox.run(shown)).figures;
  await write('g', '6.22');
  expect((await firefox.run(shown)).figures[0] !== drawn, 'pendulum-09: with another g the figure is as it was');

  // --- The address, and a scene.
  await open('pendulum-05', '#zeta=150');
  await until(() => document.documentElement.dataset.live === 'ready');
  expect(
    (await firefox.run(() => document.querySelector('input[name=zeta]').value)) === '150',
    'the address does not fill the field',
  );
  await firefox.run(() => document.querySelector('figure[data-scene]').scrollIntoView());
  const press = () => firefox.run(() => document.querySelector('figure[data-scene] .start').click());
  const clock = () => firefox.run(() => document.querySelector('figure[data-scene] .clock').textContent);
  await press();
  await until(() => parseFloat(document.querySelector('figure[data-scene] .clock').textContent) > 0.1);
  await press();
  const stopped = await clock();
  await new Promise((done) => setTimeout(done, 200));
  expect(stopped === (await clock()), 'the scene does not stop');
} finally {
  await firefox.end();
}
console.log(`pendulum §§5, 9 and 11 in Firefox; ${faults.length} faults`);
if (faults.length) {
  console.error(faults.join('\n'));
  process.exit(1);
}
