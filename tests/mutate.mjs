// Changes one token of a section at a time and looks whether its checks turn red, or else the record of what it tells
// (tests/told.mjs): node tests/mutate.mjs BUILD CHAPTER NN [COUNT].
// BUILD is a configured build folder of a copy of the repository that nobody else uses: the section is changed in place and put back.
// Not part of the tests' every run; its last table stands in tests/mutations.md.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

const [build, chapter, number, count = '10'] = process.argv.slice(2);
const source = path.resolve(build, '..');
const file = path.join(source, `chapters/${chapter}/s${number}.cpp`);
const program = `${chapter}-${number}`;
const text = readFileSync(file, 'utf8');

/** The classes of places, by the kind of block that a line stands in. */
function classOf(line, block) {
  if (/\brequire\(/.test(line)) return 'require';
  if (/= (real|integer|angle|amplitude\w*)\(/.test(line)) return 'parameters';
  if (block === 'TELL' && /\btell\(/.test(line)) return 'told values';
  if (block === 'TELL' && /race\(|ways|\[=|\[&\] \{ return/.test(line)) return 'races';
  if (block === 'TELL' && /row\(/.test(line)) return 'tables';
  if (block === 'TELL') return 'curves';
  return 'formulae';
}

/** What a token may become; each is another program. */
const changes = [
  [/(?<![\w.])(\d+(?:\.\d+)?)(?![\w.'])/g, (m) => String(Number(m) + 1)],
  [/ \+ /g, () => ' - '],
  [/ - /g, () => ' + '],
  [/ \* /g, () => ' / '],
  [/ \/ /g, () => ' * '],
  [/\bsin\(/g, () => 'cos('],
  [/\bcos\(/g, () => 'sin('],
  [/, (seconds|degrees|percent|metres|feet),/g, (m) => (m.includes('percent') ? ', degrees,' : ', percent,')],
];

function places() {
  const all = [];
  let block = '';
  let prose = false;
  let depth = 0;
  let at = 0;
  for (const line of text.split('\n')) {
    if (line.startsWith('/*!')) prose = true;
    if (!prose) {
      if (/^TELL/.test(line)) block = 'TELL';
      else if (/^(CHECK_THAT|(static )?const (Erratum|Emendation|Doubtful|Undecided))/.test(line)) block = 'check';
      else if (depth === 0 && /^[a-z]/.test(line)) block = 'code';
      const plain = line.replace(/"[^"]*"/g, (s) => ' '.repeat(s.length)).replace(/\/\/.*/, (s) => ' '.repeat(s.length));
      if (block !== 'check' && !/^(#|SECTION|using|namespace)/.test(line))
        for (const [pattern, to] of changes)
          for (const m of plain.matchAll(pattern))
            all.push({ from: at + m.index, was: m[0], is: to(m[0]), kind: classOf(line, block), line });
      depth += (plain.match(/[{(]/g) ?? []).length - (plain.match(/[})]/g) ?? []).length;
    }
    if (prose && line.endsWith('*/')) prose = false;
    at += line.length + 1;
  }
  return all;
}

/** A fixed sequence that looks random, so that a run can be repeated. */
let state = [...program].reduce((n, c) => (n * 31 + c.charCodeAt(0)) % 2147483647, 7);
const chance = () => (state = (state * 48271) % 2147483647) / 2147483647;

const red = () => {
  const built = spawnSync('cmake', ['--build', build, '--target', program], { encoding: 'utf8' });
  if (built.status !== 0) return 'not compiled';
  const run = (...words) =>
    spawnSync('sh', ['-c', 'ulimit -t 60; exec "$0" "$@"', path.join(build, 'bin', program), ...words], { encoding: 'utf8' });
  if (run('--check').status !== 0) return 'red';
  const captured = mkdtempSync(path.join(tmpdir(), 'mutated-'));
  try {
    writeFileSync(path.join(captured, `${program}.json`), run('--json', '--data', captured).stdout);
    const told = [path.join(source, 'tests/told.mjs'), captured, path.join(source, 'tests/told'), program];
    return spawnSync(process.execPath, told).status === 0 ? 'GREEN' : 'red in told';
  } finally {
    rmSync(captured, { recursive: true });
  }
};

const all = places();
const chosen = Array.from({ length: Math.min(Number(count), all.length) }, () => all.splice(Math.floor(chance() * all.length), 1)[0]);
try {
  for (const place of chosen) {
    writeFileSync(file, text.slice(0, place.from) + place.is + text.slice(place.from + place.was.length));
    const line = text.slice(0, place.from).split('\n').length;
    console.log(`${program}:${line}\t${place.kind}\t${red()}\t"${place.was.trim()}" → "${place.is.trim()}"\t${place.line.trim()}`);
  }
} finally {
  writeFileSync(file, text);
  execFileSync('cmake', ['--build', build, '--target', program]);
}
