// The contract of every section's program: what it answers to each call, and what it refuses. Run with the program's path.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { openSync, closeSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';

const program = path.resolve(process.argv[2]);
const name = path.basename(program);
const scratch = mkdtempSync(path.join(tmpdir(), `${name}-`));
after(() => rmSync(scratch, { recursive: true }));

function run(args, stdout = 'pipe') {
  const r = spawnSync(program, args, { encoding: 'utf8', stdio: ['ignore', stdout, 'pipe'], maxBuffer: 1 << 28 });
  return { status: r.status, out: r.stdout ?? '', err: r.stderr };
}

function refuses(args, status, ...words) {
  const r = run(args);
  const call = `${name} ${args.join(' ')}`;
  assert.equal(r.status, status, `${call}: exit status`);
  assert.equal(r.out, '', `${call}: standard output`);
  assert.match(r.err, /^[^\n]+\n$/, `${call}: one line on standard error`);
  for (const word of words) assert.ok(r.err.includes(word), `${call}: "${word}" in: ${r.err}`);
}

const told = JSON.parse(run(['--json']).out);

const number = (x) => (typeof x === 'number' ? x : Number(x.replace('inf', 'Infinity')));

/** Numbers on the wrong side of each end of a parameter's range. */
function outside({ kind, lo, hi }) {
  const beyond = (x, sign) => (kind === 'integer' ? x + sign : x + sign * (Math.abs(x) + 1));
  return [beyond(number(lo), -1), beyond(number(hi), 1)].filter(Number.isFinite).map(String);
}

/** The ends of a parameter's range, what is just inside, and the extremes of the doubles that it allows. */
function extremes({ kind, lo, hi, lo_open, hi_open }) {
  const [from, to] = [number(lo), number(hi)];
  const inside = (x) => (lo_open ? x > from : x >= from) && (hi_open ? x < to : x <= to);
  if (kind === 'integer') return [...new Set([from, from + 1, to - 1, to])].filter(inside).map(String);
  const near = (x, toward) => x + (toward - x) * 1e-12;
  const candidates = [from, to, 5e-324, 1e-300, 1e-160, 1e160, Number.MAX_VALUE, -1e160, -5e-324];
  if (Number.isFinite(from) && Number.isFinite(to)) candidates.push(near(from, to), near(to, from));
  return [...new Set(candidates.filter((x) => Number.isFinite(x) && inside(x)).map(String))];
}

test('it tells its section', () => {
  const r = run([]);
  assert.equal(r.status, 0);
  assert.equal(r.err, '');
  assert.ok(r.out.includes(told.title));
  for (const value of told.values) assert.ok(r.out.includes(value.name), value.name);
  assert.equal(`${told.chapter}-${String(told.section).padStart(2, '0')}`, name);
});

test('it says the same twice', () => {
  assert.equal(run(['--json']).out, run(['--json']).out);
});

test('its help lists every parameter, with unit, default, range and meaning', () => {
  const r = run(['--help']);
  assert.equal(r.status, 0);
  const words = r.out.replace(/\s+/g, ' ');
  for (const p of told.parameters)
    for (const word of [`--${p.name}`, p.meaning, p.range, 'default']) assert.ok(words.includes(word), `${p.name}: ${word}`);
});

test('it has a version', () => {
  assert.match(run(['--version']).out, new RegExp(`^${name} \\(Euler on Oscillation [0-9.]+\\)\n$`));
});

const packages = process.env.BOOK_PACKAGES;
test('its JSON follows the schema', { skip: packages ? false : 'the npm packages are not installed' }, () => {
  const Ajv = createRequire(path.join(packages, 'package.json'))('ajv/dist/2020.js').default;
  const schema = JSON.parse(readFileSync(new URL('../book/schema/section.json', import.meta.url)));
  const valid = new Ajv({ strict: false }).compile(schema);
  assert.ok(valid(told), JSON.stringify(valid.errors));
});

// All parameters of a kind are read by the same code: the first has to refuse whatever is no number.
const noNumber = { real: [], integer: ['2.5'], angle: ['rad', '1.2grad'] };
for (const list of Object.values(noNumber))
  list.push('', '1,5', '0x10', '1 2', '--', 'nan', 'NaN', 'inf', '-inf', '1e9999', '1e-9999');
for (const p of told.parameters)
  test(`it refuses bad input for --${p.name}`, () => {
    const option = `--${p.name}`;
    const first = told.parameters.find((q) => q.kind === p.kind) === p;
    const bad = ['abc', ...(first ? noNumber[p.kind] : []), ...outside(p)];
    for (const value of bad) refuses([`${option}=${value}`], 2, option, value.slice(0, 3), 'allowed');
    refuses([option], 2, option, 'allowed');
    refuses([option, String(p.default), option, String(p.default)], 2, option, String(p.default), 'allowed');
  });

test('it refuses what it does not know, and calls that contradict each other', () => {
  refuses(['--no-such-option'], 2, '--no-such-option', 'allowed');
  refuses(['stray'], 2, 'stray', 'allowed');
  refuses(['--data', scratch, '--check'], 2, '--data', 'allowed');
  refuses(['--', '-tc=x'], 2, '-tc=x', '--check');
  for (const flag of ['--json', '--check', '--bench', '--help', '--version']) refuses([`${flag}=0`], 2, flag, 'allowed');
  refuses(['--data', ''], 2, '--data', 'allowed');
  refuses(['--data='], 2, '--data', 'allowed');
});

test('what it refuses stays one line, and its status stays 2, whatever is written and wherever to', () => {
  refuses([`--no\nsuch`], 2, '\\x0a');
  refuses(['x'.repeat(100_000)], 2, '100000 bytes');
  const shell = (redirection) => spawnSync('sh', ['-c', `"$0" --no-such-option 2>${redirection}`, program]).status;
  assert.equal(shell('/dev/full'), 2);
  assert.equal(shell('&-'), 2);
});

// Under the sanitizers neither time nor memory say anything.
const sweep = process.env.CONTRACT_SWEEP === 'yes';
// The checks of a section may take seconds: where the book was made, what it heard of them is taken. A test of the
// section's own runs them.
let once;
const heard = process.env.CONTRACT_CHECKED;
const checked = () => (once ??= heard ? readFileSync(heard, 'utf8') : run(['--check', '--json']).out);
test('at the ends of every range, and at the extremes inside, it is right or refuses', { skip: !sweep }, () => {
  const infinite = new Set(JSON.parse(checked()).infinite);
  for (const p of told.parameters)
    for (const value of extremes(p)) {
      const call = `${name} --${p.name}=${value}`;
      const limits = 'ulimit -t 10; ulimit -v 1048576; exec "$0" "$@"';
      const r = spawnSync('sh', ['-c', limits, program, `--${p.name}=${value}`, '--json'], { encoding: 'utf8', maxBuffer: 1 << 28 });
      if (r.status === 2) {
        assert.match(r.stderr, /^[^\n]+ allowed: [^\n]+\n$/, `${call}: one line on standard error`);
        continue;
      }
      assert.equal(r.status, 0, `${call}: ${r.signal ?? r.stderr}`);
      const now = JSON.parse(r.stdout);
      const cells = now.tables.flatMap((t) => t.columns.map((c, i) => [`${t.name}.${c.name}`, t.rows.map((row) => row[i])]));
      for (const [key, all] of [...now.values.map((v) => [v.name, [v.value]]), ...cells])
        for (const x of all) {
          assert.notEqual(x, 'nan', `${call}: ${key}`);
          if (x === 'inf' || x === '-inf') assert.ok(infinite.has(key), `${call}: ${key} is ${x}, and no claim says that it may be`);
        }
    }
});

test('where one angle is at its end and another rounds, it is right or refuses', { skip: !sweep }, () => {
  const angles = told.parameters.filter((p) => p.unit === '°' && p.lo !== null && p.hi !== null);
  for (const p of angles)
    for (const q of angles)
      for (const end of ['lo', 'hi'])
        for (const degrees of [30, 60, 120, 150]) {
          if (p === q || q[`${end}_open`] || [p.name, q.name].sort().join() === 'eta,zeta') continue;
          const call = [`--${p.name}=${degrees}`, `--${q.name}=${q[end]}`];
          const r = run([...call, '--json']);
          assert.ok(r.status === 0 || r.status === 2, `${name} ${call.join(' ')}: ${r.status}`);
          if (r.status === 0)
            for (const v of JSON.parse(r.out).values) assert.notEqual(v.value, 'nan', `${name} ${call.join(' ')}: ${v.name}`);
        }
});

test('with --data it can tell to machines too, and eight may write into one folder at once', async () => {
  const folder = path.join(scratch, 'together');
  assert.equal(JSON.parse(run(['--json', '--data', folder]).out).id, told.id);
  const one = () => new Promise((done) => spawn(program, ['--data', folder], { stdio: 'ignore' }).on('exit', done));
  assert.deepEqual(await Promise.all(Array.from({ length: 8 }, one)), Array(8).fill(0));
});

test('a parameter may be given as what it is anyway', () => {
  for (const p of told.parameters) assert.equal(run(['--json', `--${p.name}`, String(p.default)]).status, 0, p.name);
});

test('its checks hold, each claims something, and a run without checks is no success', () => {
  const report = JSON.parse(checked());
  assert.ok(report.passed && report.cases.length > 0);
  for (const c of report.cases) {
    assert.ok(c.passed && c.claims.length > 0, c.name);
    for (const k of c.claims) // words are shown as words, not as the place where they lie
      for (const side of [k.got, k.expected]) assert.doesNotMatch(String(side), /^(!= )?0x[0-9a-f]{6,}$/, k.expression);
  }
  assert.deepEqual(report.uncovered, []);
  const entries = [...told.errata, ...told.emendations, ...told.doubtful, ...told.undecided];
  assert.equal(report.apparatus.length, entries.length);
  const none = run(['--check', '--', '-tc=no such check']);
  assert.equal(none.status, 1);
  assert.match(none.out, /no check matches -tc=no such check/);
  assert.match(run(['--check', '--', '-ltc']).out, new RegExp(report.cases[0].name.slice(0, 20).replace(/[^\w ]/g, '.')));
  refuses(['--check', '--', '--no-such'], 2, '--no-such', 'allowed');
});

test('its data are headed, rectangular, the same twice, and whole', () => {
  const folder = path.join(scratch, 'data');
  const r = run(['--data', folder]);
  assert.equal(r.status, 0, r.err);
  const files = [...told.tables.map((t) => [t.name, t.columns.map((c) => c.name)]), ...told.curves.map((c) => [c.name, c.columns])];
  assert.deepEqual(readdirSync(folder).sort(), files.map(([file]) => `${name}.${file}.tsv`).sort());
  const before = files.map(([file]) => readFileSync(path.join(folder, `${name}.${file}.tsv`), 'utf8'));
  for (const [i, [file, columns]] of files.entries()) {
    const lines = before[i].split('\n').filter((line) => line !== '');
    assert.equal(lines[0], columns.join('\t'), file);
    assert.ok(lines.length > 1, `${file} has no rows`);
    for (const line of lines) assert.equal(line.split('\t').length, columns.length, `${file}: ${line}`);
  }
  run(['--data', folder]);
  for (const [i, [file]] of files.entries())
    assert.equal(readFileSync(path.join(folder, `${name}.${file}.tsv`), 'utf8'), before[i], `${file} differs the second time`);
});

test('a folder that cannot be made and a full disk end in one line', () => {
  const file = path.join(scratch, 'a-file');
  writeFileSync(file, '');
  refuses(['--data', path.join(file, 'below')], 1, file);
  const full = openSync('/dev/full', 'w');
  const r = run([], full);
  closeSync(full);
  assert.equal(r.status, 1);
  assert.match(r.err, /^[^\n]+\n$/);
});

test('its races are timed', { skip: told.races.length === 0 }, () => {
  const races = JSON.parse(run(['--bench', '--json']).out).races;
  for (const race of races) for (const m of race.methods) assert.ok(m.seconds > 0 && m.ratio > 0, m.name);
});
