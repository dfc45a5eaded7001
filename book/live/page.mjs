// The page that runs itself: what a reader changes is told anew by the section's own program, in a worker, and put where it
// stands on the page. Loaded at the first touch of a field, a button of the checks, or a scene; WORKER is the worker's script.
import { claims, verdict } from '../claims.mjs';
import { escape } from '../escape.mjs';
import { inline, palette } from '../figure.mjs';
import { asTeX, asText, format } from '../numbers.mjs';
import { rows as tableRows } from '../table.mjs';
import { terminal } from '../terminal.mjs';
import { letter, slider, typed, withUnit } from './fields.mjs';
import { Moving } from './scene.mjs';

const all = (selector, within = document) => [...within.querySelectorAll(selector)];
const make = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

const { program } = document.querySelector('pre.told[data-program]').dataset;
const own = document.querySelector('section.parameters') ?? make('section');
const [chapter] = program.split('-');
const id = program.replace('-', '.');

// ---------------------------------------------------------------------------------------------------- the worker

/** Loads a script of the book's folder, once. */
const load = (name) =>
  new Promise((ready, failed) => {
    document.head.append(
      make('script', {
        src: `live/${name}.js`,
        onload: ready,
        onerror: () => failed(new Error(`live/${name}.js is missing`)),
      }),
    );
  });
const loaded = Promise.all([load(chapter), load('gnuplot')]);

let worker = null;
let waiting = new Map();
let asked = 0;

async function begin() {
  await loaded;
  const { LIVE } = self;
  const url = URL.createObjectURL(new Blob([WORKER], { type: 'text/javascript' }));
  worker = new Worker(url);
  URL.revokeObjectURL(url);
  worker.onmessage = ({ data }) => {
    const [answered, failed] = waiting.get(data.id);
    waiting.delete(data.id);
    if (data.fault === undefined) answered(data.answer);
    else failed(new Error(data.fault));
  };
  worker.onerror = (event) => stop(event.message);
  worker.postMessage({ packs: { gnuplot: LIVE.gnuplot, [chapter]: LIVE[chapter] }, chapter });
}

let beginning = null;
async function ask(...question) {
  await (beginning ??= begin());
  return new Promise((answered, failed) => {
    asked += 1;
    waiting.set(asked, [answered, failed]);
    worker.postMessage({ id: asked, ask: question });
  });
}

class Stopped extends Error {}

/** Ends what runs; the next question begins anew. */
function stop(why = 'stopped') {
  worker?.terminate();
  worker = null;
  beginning = null;
  const left = waiting;
  waiting = new Map();
  for (const [, failed] of left.values()) failed(new Stopped(why));
}

// ------------------------------------------------------------------------------------------- the fields, the address

const inputs = new Map(all('input[type=text]', own).map((input) => [input.name, input]));
const slides = new Map(all('input[data-slides]', own).map((input) => [input.dataset.slides, input]));
const defaults = new Map([...inputs].map(([name, input]) => [name, input.defaultValue]));
const given = new Map(); // what the reader has changed, as written
let parameters = null; // as the program declares them, once it has told

/** Takes what is written for a parameter. Of an amplitude from the lowest point and from the top the last written holds. */
function give(name, text) {
  const other = { zeta: 'eta', eta: 'zeta' }[name];
  if (other && inputs.has(other)) given.delete(other);
  if (text.trim() === defaults.get(name)) given.delete(name);
  else given.set(name, text.trim());
}

const written = () => {
  const units = new Map((parameters ?? []).map((p) => [p.name, p.unit]));
  const bare = (text) => /^[-+\d.e]+$/i.test(text);
  return [...given]
    .map(
      ([name, text]) =>
        `${letter(name)} = ${bare(text) ? withUnit(text.replace(/^-/, '−'), units.get(name)) : text}`,
    )
    .join(', ');
};
const address = () => [...given].map(([name, text]) => `${name}=${encodeURIComponent(text)}`).join('&');

function fromAddress() {
  const found = [...new URLSearchParams(location.hash.slice(1))].filter(([name]) => inputs.has(name));
  if (!found.length) return false;
  given.clear();
  for (const [name, text] of found) {
    give(name, text);
    inputs.get(name).value = text;
  }
  return true;
}

// ------------------------------------------------------------------------------------- what is put in its place

const kept = new Map(); // elements that were changed, and what they were

/** Puts `html` into an element, and marks it where that is not what the book has. */
function put(element, html, attributes = {}) {
  if (!kept.has(element)) {
    const names = Object.keys(attributes);
    const were = Object.fromEntries(names.map((name) => [name, element.getAttribute(name)]));
    kept.set(element, { html: element.innerHTML, were });
  }
  if (element.innerHTML !== html) element.innerHTML = html;
  for (const [name, x] of Object.entries(attributes)) element.setAttribute(name, x);
  element.classList.toggle('yours', element.innerHTML !== kept.get(element).html);
}

const drawings = new Map(); // figures that were drawn anew, and what they were

function putBack() {
  for (const [figure, { html }] of drawings) {
    figure.querySelector('.drawing > svg').outerHTML = html;
    figure.classList.remove('yours');
    figureFault(figure, '');
  }
  drawings.clear();
  for (const [element, { html, were }] of kept) {
    element.innerHTML = html;
    for (const [name, x] of Object.entries(were)) element.setAttribute(name, x);
    element.classList.remove('yours');
  }
  kept.clear();
}

const named = (told) => {
  const everything = [...told.parameters, ...told.values];
  return (full) => {
    const [, name] = /^(?:\w+\.\d\d)\.(\w+)$/.exec(full) ?? [];
    return full.startsWith(`${id}.`) ? everything.find((x) => x.name === name) : undefined;
  };
};

/** A number in its format, without its sign where the page has it without. */
const as = (told, spec, bare) => {
  const number = format(told, spec);
  return bare ? { ...number, suffix: '' } : number;
};

let bookTold = null; // what the program tells with Euler's numbers

async function book() {
  if (!bookTold) {
    bookTold = (await ask('say', program, {})).told;
    ({ parameters } = bookTold);
  }
  return bookTold;
}

/** The numbers in the prose, the captions and the tables' heads. */
function putProse(value, usual) {
  for (const data of all('data[data-name]')) {
    const now = value(data.dataset.name);
    if (!now) continue;
    const spec = data.dataset.format;
    data.dataset.bare ??= data.textContent !== asText(format(usual(data.dataset.name), spec));
    const bare = data.dataset.bare === 'true';
    put(data, escape(asText(as(now, spec, bare))), { value: now.text ?? now.value });
  }
}

let katexLoaded = null;

/** The numbers in formulae: set by the same KaTeX, in what is seen and in what is read out. */
async function putFormulae(value, usual) {
  const formulae = all('.katex').filter((k) => all('[data-name]', k).some((e) => value(e.dataset.name)));
  if (!formulae.length) return;
  await (katexLoaded ??= load('katex'));
  const { katex } = self;
  const set = (number) => {
    const box = make('div', { innerHTML: katex.renderToString(asTeX(number), { output: 'htmlAndMathml' }) });
    return all('.katex-html > .katex-base', box)
      .map((base) => base.innerHTML)
      .join('')
      .replace(/<span class="katex-strut"[^>]*><\/span>/g, '');
  };
  for (const formula of formulae) {
    const before = kept.get(formula)?.html ?? formula.innerHTML;
    const box = make('span', { innerHTML: before });
    const read = all('mn', box);
    for (const span of all('[data-name]', box)) {
      const was = usual(span.dataset.name);
      const now = value(span.dataset.name);
      if (!now) continue;
      const spec = span.dataset.format;
      const old = format(was, spec);
      const bare = span.textContent !== make('div', { innerHTML: set(old) }).textContent;
      const number = as(now, spec, bare);
      const [oldText, newText] = [asText(as(was, spec, true)), asText({ ...number, suffix: '' })];
      if (oldText === newText) continue;
      span.innerHTML = set(number);
      readAloud(read, old, newText);
    }
    put(formula, box.innerHTML);
  }
}

/** The first of the numbers in the MathML that reads as the old one reads as the new one. */
function readAloud(numbers, { digits, sign, power }, text) {
  const at = numbers.findIndex((mn) => mn.textContent === digits);
  if (at < 0) return;
  const [mn] = numbers.splice(0, at + 1).slice(-1);
  mn.textContent = text;
  if (sign && mn.previousElementSibling?.textContent === '−') mn.previousElementSibling.remove();
  if (power !== undefined) {
    mn.nextElementSibling?.remove(); // ×
    mn.nextElementSibling?.remove(); // 10^n
  }
}

function putTables(told) {
  for (const table of all('table[data-table]')) {
    const now = told.tables.find((t) => t.name === table.dataset.table);
    if (now) put(table.tBodies[0], `\n${tableRows(now).join('\n')}\n`);
  }
}

function putTerminal(told, text) {
  for (const pre of all(`pre.told[data-program="${program}"]`)) {
    const set = new Set(all('table[data-table]').map((t) => t.dataset.table));
    const options = [...given].map(([name, x]) => ` --${name} ${/^[\w.+-]+$/.test(x) ? x : `'${x}'`}`);
    put(pre.querySelector('code'), terminal(program + options.join(''), text, told, set));
  }
}

/** What the cards of book.js say of a number. */
function putCards(value) {
  if (typeof known === 'undefined') return;
  for (const [full, card] of Object.entries(known)) {
    const now = value(full);
    if (!now) continue;
    card.value = `${now.text ?? now.value}${now.unit === '°' ? '°' : now.unit && ` ${now.unit}`}`;
  }
}

const colours = () => palette(self.LIVE.gnuplot.scripts['figures/style.gp']);

async function putFigures(still) {
  for (const figure of all('figure[data-figure]')) {
    const name = figure.dataset.figure;
    if (!name.startsWith(program) || !self.LIVE[chapter].scripts[`figures/${name}.gp`]) continue;
    let svg;
    try {
      svg = await ask('draw', name);
    } catch (fault) {
      if (fault instanceof Stopped) throw fault;
      figureFault(figure, fault.message);
      continue;
    }
    if (!still()) return;
    figureFault(figure, '');
    const svgNow = figure.querySelector('.drawing > svg');
    if (!drawings.has(figure))
      drawings.set(figure, { html: svgNow.outerHTML, alt: svgNow.querySelector('desc').textContent });
    const { html, alt } = drawings.get(figure);
    svgNow.outerHTML = inline(
      svg,
      name,
      `With ${written()}; with the book’s numbers: ${alt}`,
      colours(),
    ).trim();
    const bare = (drawn) => drawn.replace(/<(title|desc)[^]*?<\/\1>/g, '');
    figure.classList.toggle('yours', bare(figure.querySelector('.drawing > svg').outerHTML) !== bare(html));
  }
}

function figureFault(figure, what) {
  figure.querySelector('.undrawn')?.remove();
  if (what)
    figure.append(
      make('p', {
        className: 'undrawn',
        textContent: 'With these numbers there is nothing that this figure could show.',
        title: what,
      }),
    );
}

// ----------------------------------------------------------------------------------------------------- the telling

const words = make('span', { className: 'with' });
const back = make('button', { type: 'button', textContent: 'back to the book’s numbers' });
const link = make('button', { type: 'button', textContent: 'copy a link' });
const halt = make('button', { type: 'button', textContent: 'stop', hidden: true });
const bar = make('div', { className: 'live-bar', hidden: true }, words, ' ', back, ' ', link, ' ', halt);
const refusal = make('p', { className: 'refusal', id: 'refusal' });
words.setAttribute('role', 'status');
bar.setAttribute('role', 'region');
bar.setAttribute('aria-label', 'Your numbers');
refusal.setAttribute('role', 'alert');
own.append(refusal);
document.body.append(bar);

function refuse(sentence) {
  refusal.textContent = sentence;
  const name = /^--(\w+):/.exec(sentence)?.[1];
  for (const [of, input] of inputs) {
    const here = sentence && of === name;
    input.setAttribute('aria-invalid', here);
    if (here) input.setAttribute('aria-describedby', 'refusal');
    else input.removeAttribute('aria-describedby');
    if (here) input.closest('td').append(refusal);
  }
  if (sentence && !inputs.has(name)) own.append(refusal);
}

function state(name) {
  document.documentElement.dataset.live = name;
  halt.hidden = name !== 'busy';
  own.setAttribute('aria-busy', name === 'busy');
}

function sayWhose() {
  words.textContent = given.size ? `with your ${written()}` : '';
  bar.hidden = !given.size && halt.hidden;
  back.hidden = link.hidden = !given.size;
}

/** The fields that the reader did not write in follow. */
function putFields(told) {
  for (const p of told.parameters) {
    const input = inputs.get(p.name);
    if (input && !given.has(p.name) && document.activeElement !== input) input.value = typed(p.value);
    const slide = slides.get(p.name);
    const scale = slider(p);
    if (slide && scale && document.activeElement !== slide) slide.value = scale.place(Number(p.value));
    slide?.setAttribute('aria-valuetext', withUnit(typed(p.value), p.unit));
  }
}

const scenes = [];
let last = null; // what was told last, and with what

async function tell() {
  const these = Object.fromEntries(given);
  const answer = await ask('tell', program, these);
  if (answer.refused) refuse(answer.refused);
  else if (answer.failed) refuse(`This section cannot tell it: ${answer.failed}`);
  else {
    refuse('');
    last = { ...answer, with: these };
  }
  return !answer.refused && !answer.failed;
}

let running = false;
let again = false;

/** Has the section tell what the fields say. While it does, only the last change is kept. */
async function run() {
  again = true;
  if (running) return;
  running = true;
  const late = setTimeout(() => {
    state('busy');
    sayWhose();
  }, 100);
  try {
    await book();
    while (again) {
      again = false;
      if (!given.size) {
        backToTheBook();
        continue;
      }
      if (!(await tell()) || again) continue;
      const { told, text } = last;
      const [value, usual] = [named(told), named(bookTold)];
      putFields(told);
      putProse(value, usual);
      putTables(told);
      putTerminal(told, text);
      putCards(value);
      await putFormulae(value, usual);
      await putFigures(() => !again);
      for (const scene of scenes) if (scene.rows) await scene.take();
      history.replaceState(null, '', `#${address()}`);
    }
  } catch (fault) {
    if (!(fault instanceof Stopped)) refuse(fault.message);
    else refuse('Stopped. The page shows what was told before.');
  } finally {
    clearTimeout(late);
    running = false;
    state('ready');
    sayWhose();
  }
}

/** All is as the book has it. */
function backToTheBook() {
  putBack();
  putCards(named(bookTold));
  putFields(bookTold);
  refuse('');
  last = null;
  for (const check of all('.again-run')) check.classList.remove('again-run');
  for (const scene of scenes) if (scene.rows) scene.take();
  history.replaceState(null, '', location.pathname + location.search);
}

function reset() {
  given.clear();
  for (const [name, input] of inputs) input.value = defaults.get(name);
  run();
}

// -------------------------------------------------------------------------------------------------- the checks again

async function checkAgain(button, said) {
  button.disabled = true;
  state('busy');
  said.textContent = ' running …';
  const start = performance.now();
  try {
    const answer = await ask('check', program, Object.fromEntries(given));
    if (!answer.checked) {
      said.textContent = ` ${answer.refused ?? answer.failed}`;
      return;
    }
    const { cases, apparatus } = answer.checked;
    const byLine = [...cases].sort((a, b) => a.line - b.line);
    all('section.check').forEach((section, i) => {
      const it = byLine[i];
      section.querySelector('.statement .verdict').outerHTML = verdict(it.passed);
      const details = section.querySelector('details.claims');
      const { open } = details;
      const anew = make('div', { innerHTML: claims(it.claims, i + 1) }).firstElementChild;
      anew.open = open;
      details.replaceWith(anew);
      section.classList.add('again-run');
    });
    const count = {};
    for (const entry of apparatus) {
      count[entry.kind] = (count[entry.kind] ?? 0) + 1;
      const section = document.getElementById(`${entry.kind}-${count[entry.kind]}`);
      const proof = section?.querySelector('.proof');
      if (!proof) continue;
      section.querySelector('.proof .verdict')?.remove();
      proof.insertAdjacentHTML('beforeend', ` ${verdict(entry.passed)}`);
      section.classList.add('again-run');
    }
    const failing = cases.filter((c) => !c.passed).length + apparatus.filter((e) => !e.passed).length;
    const took = ((performance.now() - start) / 1000).toFixed(2);
    const what = `${cases.length} ${cases.length === 1 ? 'check' : 'checks'}${apparatus.length ? `, ${apparatus.length} proofs of the apparatus` : ''}`;
    const whose = given.size ? ` with your ${written()}` : '';
    said.textContent = ` ${what}, run in this page${whose} in ${took} s: ${failing ? `${failing} fail` : 'all hold'}.`;
  } catch (fault) {
    said.textContent = ` ${fault.message}`;
  } finally {
    button.disabled = false;
    state('ready');
  }
}

// --------------------------------------------------------------------------------------------------------- begin

for (const [name, input] of inputs)
  input.addEventListener('input', () => {
    give(name, input.value);
    run();
  });
for (const [name, slide] of slides)
  slide.addEventListener('input', async () => {
    await book();
    const input = inputs.get(name);
    input.value = typed(slider(parameters.find((p) => p.name === name)).number(slide.value));
    give(name, input.value);
    run();
  });
back.addEventListener('click', reset);
halt.addEventListener('click', () => stop());
link.addEventListener('click', async () => {
  try {
    await navigator.clipboard.writeText(location.href);
    link.textContent = 'copied';
  } catch {
    link.textContent = 'it stands in the address line';
  }
  setTimeout(() => {
    link.textContent = 'copy a link';
  }, 1500);
});
addEventListener('hashchange', () => fromAddress() && run());

for (const line of all('.again')) {
  const button = line.querySelector('button');
  const said = line.querySelector('[role=status]');
  button.addEventListener('click', () => checkAgain(button, said));
}
for (const figure of all('figure[data-scene]')) {
  const name = figure.dataset.scene;
  scenes.push(
    new Moving(figure, async () => {
      const yours = given.size ? last : null;
      const told = yours?.told ?? (await book());
      const scene = told.scenes.find((s) => s.name === name);
      return [scene, scene && (await ask('frames', program, name, yours?.with ?? {}))];
    }),
  );
}

// What was changed or clicked before this script was there.
const early = [...inputs].filter(([, input]) => input.value !== input.defaultValue);
for (const [name, input] of early) give(name, input.value);
/** Where a slider stands of itself: at the step that is next to what was woven. */
const atRest = (slide) => Object.assign(slide.cloneNode(), { value: slide.defaultValue }).value;
const moved = [...slides].filter(([, slide]) => slide.value !== atRest(slide));
if (fromAddress() || early.length) run();
else if (moved.length) for (const [, slide] of moved) slide.dispatchEvent(new Event('input'));
else
  book().then(() => running || state('ready'));
self.liveListens = true;
self.liveWanted?.click();
