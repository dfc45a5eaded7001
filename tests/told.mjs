// What all programs tell at their defaults, against what stands in tests/told/: a change of the library shows there what
// it changes in the book. Run with the folder that the book's build captured (build/book/told) and the folder of the
// record; with a third word, rewrite, the record is made anew (./euler told), with a program's name it alone is compared.
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';

const [captured, record, third] = process.argv.slice(2);
const rewrite = third === 'rewrite';
const promised = 10; // significant digits that are kept, or as many as are shown where those are fewer
const kept = 12; // of a curve's points, evenly from the first to the last

/** A number with so many significant digits; words as they are. */
const rounded = (x, digits = promised) => (typeof x === 'number' ? Number(x.toPrecision(Math.min(digits, promised))) : x);

/** A few points of a curve, each a list of rounded numbers. */
function points(file) {
  const lines = readFileSync(file, 'utf8').split('\n').slice(1).filter((line) => /^[-\d.n]|^inf/.test(line));
  const count = Math.min(kept, lines.length);
  const at = (k) => (count < 2 ? 0 : Math.floor((k * (lines.length - 1)) / (count - 1)));
  const numbers = (line) => line.split('\t').map((word) => (Number.isNaN(Number(word)) ? word : rounded(Number(word))));
  return { of: lines.length, points: Array.from({ length: count }, (_, k) => numbers(lines[at(k)])) };
}

/** What is kept of a program's telling: names, units, and numbers with the digits that are promised. */
function essence(program) {
  const told = JSON.parse(readFileSync(path.join(captured, `${program}.json`), 'utf8'));
  const list = (things, of) => Object.fromEntries(things.map((thing) => [thing.name, of(thing)]));
  return {
    parameters: list(told.parameters, (p) => [rounded(p.default), p.unit, p.range]),
    values: list(told.values, (v) => [v.text && !v.digits ? v.text : rounded(v.value, v.digits), v.unit]),
    tables: list(told.tables, (t) => ({
      columns: t.columns.map((c) => `${c.name} ${c.unit}`.trim()),
      rows: t.rows.map((row) => row.map((x, i) => rounded(x, t.columns[i].digits))),
    })),
    curves: list(told.curves, (c) => ({ columns: c.columns, ...points(path.join(captured, `${program}.${c.name}.tsv`)) })),
    races: list(told.races, (r) => list(r.methods, (m) => rounded(m.value))),
  };
}

/** Where two essences differ, as paths; numbers may differ by one unit of the last digit that is kept. */
function differences(was, is, at = '') {
  if (typeof was === 'number' && typeof is === 'number') {
    const unit = 10 ** (1 - promised) * Math.max(Math.abs(was), Math.abs(is));
    return Math.abs(was - is) <= unit ? [] : [`${at}: ${was} → ${is}`];
  }
  if (was === null || is === null || typeof was !== 'object' || typeof is !== 'object')
    return was === is ? [] : [`${at}: ${JSON.stringify(was)} → ${JSON.stringify(is)}`];
  const keys = [...new Set([...Object.keys(was), ...Object.keys(is)])];
  return keys.flatMap((key) => differences(was[key], is[key], at ? `${at}.${key}` : key));
}

const programs = readdirSync(captured).map((f) => /^([a-z]+-\d\d)\.json$/.exec(f)?.[1]).filter((name) => name && (rewrite || !third || name === third));
if (rewrite) {
  rmSync(record, { recursive: true, force: true });
  mkdirSync(record, { recursive: true });
  for (const program of programs) writeFileSync(path.join(record, `${program}.json`), `${JSON.stringify(essence(program))}\n`);
  console.log(`${programs.length} sections are recorded in ${record}`);
} else {
  const faults = programs.flatMap((program) => {
    const file = path.join(record, `${program}.json`);
    if (!existsSync(file)) return [`${program}: is not recorded; ./euler told does so`];
    return differences(JSON.parse(readFileSync(file, 'utf8')), essence(program)).map((what) => `${program}: ${what}`);
  });
  for (const file of third ? [] : readdirSync(record))
    if (!programs.includes(path.basename(file, '.json'))) faults.push(`${file}: no program tells it any more`);
  for (const fault of faults.slice(0, 40)) console.error(fault);
  if (faults.length > 40) console.error(`and ${faults.length - 40} more`);
  console.log(`${programs.length - new Set(faults.map((f) => f.split(':')[0])).size} passed, ${faults.length} failed`);
  process.exitCode = faults.length ? 1 : 0;
}
