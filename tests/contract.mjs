// The contract of every section's program: what it answers to each call, and what it refuses. Run with the program's path.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import readline from 'node:readline';
import { after, test } from 'node:test';

const program = path.resolve(process.argv[2]);
const name = path.basename(program);
const scratch = mkdtempSync(path.join(tmpdir(), `${name}-`));

// One shell starts all the programs: it is small, and to fork it takes half of what it takes to fork what runs this.
const shell = spawn('/bin/sh', { stdio: ['pipe', 'pipe', 'inherit'] });
const statuses = readline.createInterface({ input: shell.stdout })[Symbol.asyncIterator]();
after(() => {
  shell.stdin.end();
  rmSync(scratch, { recursive: true });
});

/** The exit status of a command of the shell's; 128 and a signal's number where that ended it. */
async function status(command) {
  shell.stdin.write(`${command}\necho $?\n`);
  const { value, done } = await statuses.next();
  assert.ok(!done, `the shell ended at ${command}`);
  return Number(value);
}

const quoted = (word) => `'${word.replaceAll("'", `'\\''`)}'`;
const [out, err] = ['out', 'err'].map((file) => path.join(scratch, file));
const limited = 'ulimit -t 10; ulimit -v 1048576;';

/** What the program answers; `limits` are set before it begins. */
async function run(args, limits = '') {
  const call = [program, ...args].map(quoted).join(' ');
  return {
    status: await status(`(${limits} exec ${call}) </dev/null >${quoted(out)} 2>${quoted(err)}`),
    out: readFileSync(out, 'utf8'),
    err: readFileSync(err, 'utf8'),
  };
}

async function refuses(args, status, ...words) {
  const r = await run(args);
  const call = `${name} ${args.join(' ')}`;
  assert.equal(r.status, status, `${call}: exit status`);
  assert.equal(r.out, '', `${call}: standard output`);
  assert.match(r.err, /^[^\n]+\n$/, `${call}: one line on standard error`);
  for (const word of words) assert.ok(r.err.includes(word), `${call}: "${word}" in: ${r.err}`);
}

const first = await run(['--json']);
const told = JSON.parse(first.out);

// Where every section is asked, each tries a fifth of what is the same for all.
const sweep = process.env.CONTRACT_SWEEP === 'yes'; // under the sanitizers neither time nor memory say anything
const share = (list) => list.filter((_, i) => !sweep || (i - told.section) % 5 === 0);

// What the book heard of the program, where it was made: what it told, and its checks, which may take seconds. A test of the
// section's own runs them.
const heard = process.env.CONTRACT_CHECKED;

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

test('it tells its section', async () => {
  const r = await run([]);
  assert.equal(r.status, 0);
  assert.equal(r.err, '');
  assert.ok(r.out.includes(told.title));
  for (const value of told.values) assert.ok(r.out.includes(value.name), value.name);
  assert.equal(`${told.chapter}-${String(told.section).padStart(2, '0')}`, name);
});

test('it says the same twice', async () => {
  const again = heard ? readFileSync(heard.replace(/check\.json$/, 'json'), 'utf8') : (await run(['--json'])).out;
  assert.ok(again === first.out, heard ? 'it tells something else than the book heard of it' : 'it differs');
});

test('its help lists every parameter, with unit, default, range and meaning', async () => {
  const r = await run(['--help']);
  assert.equal(r.status, 0);
  const words = r.out.replace(/\s+/g, ' ');
  for (const p of told.parameters)
    for (const word of [`--${p.name}`, p.meaning, p.range, 'default']) assert.ok(words.includes(word), `${p.name}: ${word}`);
});

test('it has a version', async () => {
  assert.match((await run(['--version'])).out, new RegExp(`^${name} \\(Euler on Oscillation [0-9.]+\\)\n$`));
});

// All parameters of a kind are read by the same code: the first has to refuse whatever is no number.
const noNumber = { real: [], integer: ['2.5'], angle: ['rad', '1.2grad'] };
for (const list of Object.values(noNumber))
  list.push('', '1,5', '0x10', '1 2', '--', 'nan', 'NaN', 'inf', '-inf', '1e9999', '1e-9999');
for (const [i, p] of told.parameters.entries())
  test(`it refuses bad input for --${p.name}`, async () => {
    const option = `--${p.name}`;
    const ofItsKind = told.parameters.find((q) => q.kind === p.kind) === p;
    const bad = ['abc', ...(ofItsKind ? share(noNumber[p.kind]) : []), ...outside(p)];
    for (const value of bad) await refuses([`${option}=${value}`], 2, option, value.slice(0, 3), 'allowed');
    if (sweep && i !== told.section % told.parameters.length) return;
    await refuses([option], 2, option, 'allowed');
    await refuses([option, String(p.default), option, String(p.default)], 2, option, String(p.default), 'allowed');
  });

test('it refuses what it does not know, and calls that contradict each other', async () => {
  for (const [args, ...words] of share([
    [['--no-such-option'], '--no-such-option', 'allowed'],
    [['stray'], 'stray', 'allowed'],
    [['--data', scratch, '--check'], '--data', 'allowed'],
    [['--', '-tc=x'], '-tc=x', '--check'],
    ...['--json', '--check', '--bench', '--help', '--version'].map((flag) => [[`${flag}=0`], flag, 'allowed']),
    [['--data', ''], '--data', 'allowed'],
    [['--data='], '--data', 'allowed'],
    [['--check', '--', '--no-such'], '--no-such', 'allowed'],
  ]))
    await refuses(args, 2, ...words);
});

test('what it refuses stays one line, and its status stays 2, whatever is written and wherever to', async () => {
  for (const look of share([
    () => refuses([`--no\nsuch`], 2, '\\x0a'),
    () => refuses(['x'.repeat(100_000)], 2, '100000 bytes'),
    async () => assert.equal(await status(`${quoted(program)} --no-such-option 2>/dev/full`), 2),
    async () => assert.equal(await status(`${quoted(program)} --no-such-option 2>&-`), 2),
  ]))
    await look();
});

let once;
const checked = async () => (once ??= heard ? readFileSync(heard, 'utf8') : (await run(['--check', '--json'])).out);
test('at the ends of every range, and at the extremes inside, it is right or refuses', { skip: !sweep }, async () => {
  const infinite = new Set(JSON.parse(await checked()).infinite);
  for (const p of told.parameters)
    for (const value of extremes(p)) {
      const call = `${name} --${p.name}=${value}`;
      const r = await run([`--${p.name}=${value}`, '--json'], limited);
      if (r.status === 2) {
        assert.match(r.err, /^[^\n]+ allowed: [^\n]+\n$/, `${call}: one line on standard error`);
        continue;
      }
      assert.equal(r.status, 0, `${call}: ${r.status} ${r.err}`);
      const now = JSON.parse(r.out);
      const cells = now.tables.flatMap((t) => t.columns.map((c, i) => [`${t.name}.${c.name}`, t.rows.map((row) => row[i])]));
      for (const [key, all] of [...now.values.map((v) => [v.name, [v.value]]), ...cells])
        for (const x of all) {
          assert.notEqual(x, 'nan', `${call}: ${key}`);
          if (x === 'inf' || x === '-inf') assert.ok(infinite.has(key), `${call}: ${key} is ${x}, and no claim says that it may be`);
        }
    }
});

test('where one angle is at its end and another rounds, it is right or refuses', { skip: !sweep }, async () => {
  const angles = told.parameters.filter((p) => p.unit === '°' && p.lo !== null && p.hi !== null);
  for (const p of angles)
    for (const q of angles)
      for (const end of ['lo', 'hi'])
        for (const degrees of [30, 60, 120, 150]) {
          if (p === q || q[`${end}_open`] || [p.name, q.name].sort().join() === 'eta,zeta') continue;
          const call = [`--${p.name}=${degrees}`, `--${q.name}=${q[end]}`];
          const r = await run([...call, '--json']);
          assert.ok(r.status === 0 || r.status === 2, `${name} ${call.join(' ')}: ${r.status}`);
          if (r.status === 0)
            for (const v of JSON.parse(r.out).values) assert.notEqual(v.value, 'nan', `${name} ${call.join(' ')}: ${v.name}`);
        }
});

const together = path.join(scratch, 'together');
test('with --data it can tell to machines too, and eight may write into one folder at once', async () => {
  assert.equal(JSON.parse((await run(['--json', '--data', together])).out).id, told.id);
  const one = `${quoted(program)} --data ${quoted(together)} </dev/null >/dev/null 2>&1`;
  const all = [1, 2, 3, 4, 5, 6, 7, 8];
  assert.equal(await status(`${all.map((i) => `${one} & p${i}=$!`).join('\n')}\n${all.map((i) => `wait $p${i}`).join(' && ')}`), 0);
});

test('a parameter may be given as what it is anyway', async () => {
  for (const p of told.parameters) assert.equal((await run(['--json', `--${p.name}`, String(p.default)])).status, 0, p.name);
});

test('its checks hold, each claims something, and a run without checks is no success', async () => {
  const report = JSON.parse(await checked());
  assert.ok(report.passed && report.cases.length > 0);
  for (const c of report.cases) {
    assert.ok(c.passed && c.claims.length > 0, c.name);
    for (const k of c.claims) // words are shown as words, not as the place where they lie
      for (const side of [k.got, k.expected]) assert.doesNotMatch(String(side), /^(!= )?0x[0-9a-f]{6,}$/, k.expression);
  }
  assert.deepEqual(report.uncovered, []);
  const entries = [...told.errata, ...told.emendations, ...told.doubtful, ...told.undecided];
  assert.equal(report.apparatus.length, entries.length);
  const none = await run(['--check', '--', '-tc=no such check']);
  assert.equal(none.status, 1);
  assert.match(none.out, /no check matches -tc=no such check/);
  assert.match((await run(['--check', '--', '-ltc'])).out, new RegExp(report.cases[0].name.slice(0, 20).replace(/[^\w ]/g, '.')));
});

test('its data are headed, rectangular, the same twice, and whole', async () => {
  const folder = path.join(scratch, 'data');
  const r = await run(['--data', folder]);
  assert.equal(r.status, 0, r.err);
  const files = [...told.tables.map((t) => [t.name, t.columns.map((c) => c.name)]), ...told.curves.map((c) => [c.name, c.columns])];
  assert.deepEqual(readdirSync(folder).sort(), files.map(([file]) => `${name}.${file}.tsv`).sort());
  const data = files.map(([file]) => readFileSync(path.join(folder, `${name}.${file}.tsv`), 'utf8'));
  for (const [i, [file, columns]] of files.entries()) {
    const lines = data[i].split('\n').filter((line) => line !== '');
    assert.equal(lines[0], columns.join('\t'), file);
    assert.ok(lines.length > 1, `${file} has no rows`);
    for (const line of lines) assert.equal(line.split('\t').length, columns.length, `${file}: ${line}`);
  }
  for (const [i, [file]] of files.entries())
    assert.equal(readFileSync(path.join(together, `${name}.${file}.tsv`), 'utf8'), data[i], `${file} differs the second time`);
});

test('a folder that cannot be made and a full disk end in one line', async () => {
  const file = path.join(scratch, 'a-file');
  writeFileSync(file, '');
  await refuses(['--data', path.join(file, 'below')], 1, file);
  assert.equal(await status(`${quoted(program)} >/dev/full 2>${quoted(err)}`), 1);
  assert.match(readFileSync(err, 'utf8'), /^[^\n]+\n$/);
});

test('its races are timed', { skip: told.races.length === 0 }, async () => {
  const races = JSON.parse((await run(['--bench', '--json'])).out).races;
  for (const race of races) for (const m of race.methods) assert.ok(m.seconds > 0 && m.ratio > 0, m.name);
});
