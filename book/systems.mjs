// What other systems say of this pendulum: those that the edition is linked with as the program other-systems
// asked them when the book was built, the others, and the physics engines, as findings/ recorded them in
// book/systems.
import fs from 'node:fs';
import path from 'node:path';
import { table, tableEnd } from './claims.mjs';
import { asText, format } from './numbers.mjs';
import { escape } from './prose.mjs';

const recorded = (book, engines) => {
  const folder = path.join(book.source, 'book/systems');
  return fs
    .readdirSync(folder)
    .filter((name) => name.endsWith('.json') && name.startsWith('engines') === engines)
    .sort()
    .map((name) => JSON.parse(fs.readFileSync(path.join(folder, name), 'utf8')));
};
const linked = (book) => JSON.parse(fs.readFileSync(path.join(book.build, 'other-systems.json'), 'utf8'));

const all = (book) =>
  [...linked(book).systems, ...recorded(book, false)].sort((a, b) => a.system.localeCompare(b.system, 'en'));

// A decimal number times 10⁴⁰, exactly.
function scaled(text) {
  const parts = /^([-+]?)(\d+)(?:\.(\d*))?(?:[eE]([-+]?\d+))?$/.exec(text);
  const [, sign, whole, fraction = '', exponent = '0'] = parts;
  const zeros = 40 + Number(exponent) - fraction.length;
  const digits = BigInt(whole + fraction);
  return (sign === '-' ? -1n : 1n) * (zeros < 0 ? digits / 10n ** BigInt(-zeros) : digits * 10n ** BigInt(zeros));
}

/** The error of a decimal number in units of the last place of a double at the true one; NaN for what is no number. */
export function ulps(got, exact) {
  if (!/^[-+]?\d/.test(got)) return NaN;
  const ulp = 2 ** (Math.floor(Math.log2(Number(exact))) - 52);
  const wrong = scaled(got) - scaled(exact);
  return Number(wrong < 0n ? -wrong : wrong) / 1e40 / ulp;
}

// K and am(10) by the arithmetic-geometric mean: only to tell one convention from another.
function means(m) {
  const [a, c] = [[1], [Math.sqrt(m)]];
  for (let b = Math.sqrt(1 - m); Math.abs(c.at(-1)) > 1e-15; ) {
    const last = a.at(-1);
    a.push((last + b) / 2);
    c.push((last - b) / 2);
    b = Math.sqrt(last * b);
  }
  return { a, c };
}
const K = (m) => Math.PI / 2 / means(m).a.at(-1);
function amplitude(u, m) {
  const { a, c } = means(m);
  let phi = 2 ** (a.length - 1) * a.at(-1) * u;
  for (let n = a.length - 1; n > 0; --n) phi = (phi + Math.asin((c[n] / a[n]) * Math.sin(phi))) / 2;
  return phi;
}
// am(1) where m > 1.
const beyond = (m) => Math.asin(Math.sin(amplitude(Math.sqrt(m), 1 / m)) / Math.sqrt(m)).toPrecision(2);
const squares = { k: 1 / 16, m: 1 / 4, '1 − m': 3 / 4 };

/** What the argument of K is, told from what the system says of K(¼). */
export function argument(system) {
  const found = Object.keys(squares).find((name) => Math.abs(K(squares[name]) / Number(system.K.quarter) - 1) < 1e-9);
  if (!found) throw new Error(`${system.system}: K(1/4) = ${system.K.quarter} is that of no convention`);
  return found;
}

/** Whether 1 − n sin² or 1 + n sin² stands in the integral of the third kind, told from n = ¼. */
const sign = (system) => (Number(system.Pi.quarter) > Number(system.K.quarter) ? '1 − n sin²' : '1 + n sin²');

function turns(system) {
  const got = Number(system.am.ten);
  const dropped = Object.values(squares).map((m) => (amplitude(10, m) - got) / (2 * Math.PI));
  if (dropped.some((n) => Math.abs(n) < 1e-9)) return 'counts them';
  return dropped.some((n) => Math.abs(n - Math.round(n)) < 1e-9) ? 'drops whole turns' : 'stays within a quarter';
}

// An answer where there is no value to be had.
function said(text) {
  if (text === undefined || text === 'not asked') return 'not asked';
  if (text.startsWith('error')) return text.replace(/^error:? ?(error\("(.*)"\))?/, '$2') || 'an error';
  if (/^\+?inf/i.test(text)) return '∞';
  if (/^nan$/i.test(text)) return 'NaN';
  return /[iIj]/.test(text) ? 'complex' : Number(text).toPrecision(2).replace(/e\+(\d+)/, ' · 10^$1');
}
const short = (x) => asText(format({ value: x }, x >= 1e5 ? 'e2' : '2'));
const when = (system) => (system.recorded ? `recorded ${system.recorded}` : 'in this build');
const row = (head, cells) => `<tr><th scope="row">${head}</th>${cells.join('')}</tr>\n`;
const words = (text) => `<td class="word">${escape(text)}</td>`;
const code = (text) => `<td class="word call"><code>${escape(text)}</code></td>`;
// What a function turns out to be, and how it is asked; or that the system has none.
const asked = (of, what) =>
  of ? `<td class="word call">${escape(what())}<span class="below"><code>${escape(of.call)}</code></span></td>` : words('none');

/** `{{collected other-systems}}`: one row a system, how its functions are to be asked. */
export function conventions(book) {
  const rows = all(book).map((s) =>
    row(`${escape(s.system)}<span class="below">${escape(s.version)}, ${when(s)}</span>`, [
      code(s.K.call),
      words(argument(s)),
      words(said(s.K.one)),
      words(said(s.K.beyond)),
      asked(s.Pi, () => sign(s)),
      asked(s.am, () => turns(s)),
      words(s.am ? said(s.am.one) : 'none'),
      words(s.am ? said(s.am.beyond) : 'none'),
    ]),
  );
  const heads = [
    'system',
    'K is',
    'its argument',
    'says at the top',
    'at the argument 1½',
    'third kind has',
    'turns of am',
    `am(2) at the top (${(2 * Math.atan(Math.tanh(1))).toPrecision(2)})`,
    `am(1) at k = 1½ (${beyond(1.5 ** 2)}), m = 1½ (${beyond(1.5)})`,
  ];
  return `${table('Conventions of other systems', heads)}${rows.join('')}${tableEnd}`;
}

/** `{{collected other-systems T}}` or `Phi`: how wrong each way is at the three swings. */
export function errors(book, of) {
  const { question } = linked(book);
  const rows = all(book).flatMap((s) =>
    s.ways
      .filter((w) => w.of === of)
      .map((w) =>
        row(escape(s.system), [
          code(w.call),
          ...w.got.map((got, i) => {
            const wrong = ulps(got, question[of][i]);
            return Number.isNaN(wrong) ? words(said(got)) : `<td>${short(wrong)}</td>`;
          }),
        ]),
      ),
  );
  const heads = ['system', 'asked', ...['1°', '10⁻⁴', '10⁻⁹'].map((x) => `${x} <span class="unit">ulp</span>`)];
  return `${table(`Errors of ${of === 'T' ? 'T/Θ' : 'Φ'} near the top`, heads)}${rows.join('')}${tableEnd}`;
}

const degrees = Math.PI / 180;
const scenes = { pendulum: { title: 'Pendulum', start: 90 }, ball: { title: 'Loaded ball', start: 1.2 / degrees } };

/**
 * `{{collected engines}}`: the pendulum and the loaded ball after a minute in physics engines; with `pendulum` or `ball`
 * that one alone, and by how much its period is wrong.
 */
export function engines(book, only) {
  const truth = linked(book).engines;
  const shown = only ? [only] : Object.keys(scenes);
  const height = (angle) => 1 - Math.cos(angle * degrees);
  const exact = (engine, scene) => Number(scene === 'ball' ? truth.ball : truth.pendulum[engine.bob]);
  const cells = (engine, scene) => {
    const [{ period, amplitude }, own] = [engine[scene], exact(engine, scene)];
    const numbers = [
      amplitude.toFixed(1),
      ((100 * height(amplitude)) / height(scenes[scene].start)).toFixed(1),
      period.toFixed(3),
      own.toFixed(3),
    ];
    if (only) numbers.push((100 * (period / own - 1)).toFixed(1).replace(/^-(0\.0$)?/, (_, none) => none ?? '−'));
    return numbers.map((text) => `<td>${text}</td>`);
  };
  const row_of = (name, below, engine) =>
    row(
      `${name}<span class="below">${below}</span>`,
      shown.flatMap((scene) => cells(engine, scene)),
    );
  const rows = recorded(book, true).flatMap((record) =>
    record.engines.map((e) => row_of(escape(e.engine), `${escape(e.version)}, recorded ${record.recorded}`, e)),
  );
  const heads = shown.flatMap((scene) => [
    `${only ? '' : `${scenes[scene].title.toLowerCase()}: `}swings to, of ${scenes[scene].start.toFixed(1)} <span class="unit">°</span>`,
    'energy left <span class="unit">%</span>',
    'mean period <span class="unit">s</span>',
    'true period <span class="unit">s</span>',
    ...(only ? ['wrong by <span class="unit">%</span>'] : []),
  ]);
  const label = only ? `${scenes[only].title} in physics engines` : 'Physics engines after a minute';
  const own = row_of('this edition', 'in this build', truth.edition);
  return `${table(label, ['engine', ...heads])}${own}${rows.join('')}${tableEnd}`;
}
