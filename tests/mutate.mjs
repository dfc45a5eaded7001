// Changes one token of a file at a time and looks whether anything turns red: a section's checks or a room's tests, or else
// the record of what is told (tests/told.mjs): node tests/mutate.mjs BUILD FILE [COUNT [PROGRAM ...]].
// FILE is chapters/CHAPTER/sNN.cpp, looked at by its own program, or one of src/, looked at by the PROGRAMs that are named,
// tests (test-...) and sections, in that order. The places are of all classes in turn. A program that does not end is stopped,
// and is red, after the seconds of the processor that MUTATE_SECONDS says.
// BUILD is a configured build folder of a copy of the repository that nobody else uses: FILE is changed in place and put back.
// Not part of the tests' every run; its last table stands in tests/mutations.md.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

const [build, name, count = '10', ...others] = process.argv.slice(2);
const source = path.resolve(build, '..');
const file = path.join(source, name);
const section = /^chapters\/(\w+)\/s(\d\d)\.cpp$/.exec(name);
const programs = section ? [`${section[1]}-${section[2]}`] : others;
const text = readFileSync(file, 'utf8');

/** What a token may become; each is another program. */
const changes = [
  [/(?<![\w.'])(\d+(?:\.\d+)?)(?=_deg|_rad|[^\w.'])/g, (m) => m.replace(/^\d+/, (whole) => String(Number(whole) + 1))],
  [/ \+ /g, () => ' - '],
  [/ - /g, () => ' + '],
  [/ \* /g, () => ' / '],
  [/ \/ /g, () => ' * '],
  [/ [<>]=? /g, (m) => ({ ' < ': ' > ', ' > ': ' < ', ' <= ': ' < ', ' >= ': ' > ' })[m]],
  [/ && /g, () => ' || '],
  [/ \|\| /g, () => ' && '],
  [/\bsin\(/g, () => 'cos('],
  [/\bcos\(/g, () => 'sin('],
  [/, (seconds|degrees|percent|metres|feet),/g, (m) => (m.includes('percent') ? ', degrees,' : ', percent,')],
];

/** The class of a statement, by what it declares or calls; `head` is what stands before the braces around it. */
function classOf(statement, head) {
  if (!section) return 'library';
  if (/^(CHECK_THAT|(static )?const (Erratum|Emendation|Doubtful|Undecided))/.test(head || statement)) return undefined;
  if (/^(SECTION|using|namespace|illustration)\b/.test(statement)) return undefined;
  if (/\brequire\(/.test(statement)) return 'require';
  if (/^const auto \w+ = (real|integer|angle|amplitude\w*)\(/.test(statement)) return 'parameters';
  if (head !== 'TELL') return 'formulae';
  if (/\b(curve|scene\w*)\(/.test(statement)) return 'curves';
  if (/\b(table|\w+\.row|tell_events)\(/.test(statement)) return 'tables';
  if (/\b(race\(|ways\b)/.test(statement)) return 'races';
  return /\btell\(/.test(statement) ? 'told values' : 'formulae';
}

/** All places, statement by statement: one ends at a semicolon or a brace that no more than one brace is around. */
function places() {
  const blank = (s) => s.replace(/[^\n]/g, ' ');
  const program = section ? text.split(/^## Checks$/m)[0] : text; // a check's own tokens are not what it looks at
  const plain = program.replace(/\/\*[^]*?(?:\*\/|(?![^]))|"(\\.|[^"\n])*"|\/\/.*|^#.*/gm, blank);
  const all = [];
  let head = '';
  let depth = 0;
  let from = 0;
  for (let at = 0; at < plain.length; ++at) {
    if ('({['.includes(plain[at])) ++depth;
    if (')}]'.includes(plain[at])) --depth;
    const opens = plain[at] === '{' && depth === 1;
    if (!opens && !((plain[at] === ';' || plain[at] === '}') && depth < 2)) continue;
    const statement = plain.slice(from, at + 1);
    const kind = classOf(statement.trim(), head);
    for (const [pattern, to] of kind ? changes : [])
      for (const m of statement.matchAll(pattern)) all.push({ from: from + m.index, was: m[0], is: to(m[0]), kind });
    if (opens) head = statement.slice(0, -1).trim();
    if (depth === 0) head = '';
    from = at + 1;
  }
  return all;
}

/** A fixed sequence that looks random, so that a run can be repeated. */
let state = [...name].reduce((n, c) => (n * 31 + c.charCodeAt(0)) % 2147483647, 7);
const chance = () => (state = (state * 48271) % 2147483647) / 2147483647;

/** So many places, one of each class in turn. */
function chosen() {
  const classes = new Map();
  for (const place of places()) classes.set(place.kind, [...(classes.get(place.kind) ?? []), place]);
  const all = [];
  while (all.length < Number(count) && [...classes.values()].some((left) => left.length > 0))
    for (const left of classes.values()) if (left.length > 0) all.push(...left.splice(Math.floor(chance() * left.length), 1));
  return all.slice(0, Number(count));
}

const seconds = Number(process.env.MUTATE_SECONDS ?? 120);
const run = (program, ...words) =>
  spawnSync('sh', ['-c', `ulimit -t ${seconds}; exec "$0" "$@"`, path.join(build, 'bin', program), ...words], { encoding: 'utf8' });

/** Whether a section tells what stands in the record. */
function asRecorded(program) {
  const captured = mkdtempSync(path.join(tmpdir(), 'mutated-'));
  try {
    writeFileSync(path.join(captured, `${program}.json`), run(program, '--json', '--data', captured).stdout);
    const told = [path.join(source, 'tests/told.mjs'), captured, path.join(source, 'tests/told'), program];
    return spawnSync(process.execPath, told).status === 0;
  } finally {
    rmSync(captured, { recursive: true });
  }
}

function seen() {
  if (spawnSync('cmake', ['--build', build, '--target', ...programs]).status !== 0) return 'not compiled';
  const sections = programs.filter((program) => !program.startsWith('test-'));
  for (const program of programs) {
    const { status, signal } = run(program, ...(sections.includes(program) ? ['--check'] : []));
    if (status !== 0) return `red in ${program}${signal ? ` by ${signal}` : ''}`;
  }
  return sections.every(asRecorded) ? 'GREEN' : 'red in the record';
}

try {
  for (const place of chosen()) {
    writeFileSync(file, text.slice(0, place.from) + place.is + text.slice(place.from + place.was.length));
    const line = text.slice(0, place.from).split('\n').length;
    const words = text.split('\n')[line - 1].trim();
    console.log(`${name}:${line}\t${place.kind}\t${seen()}\t"${place.was.trim()}" → "${place.is.trim()}"\t${words}`);
  }
} finally {
  writeFileSync(file, text);
  execFileSync('cmake', ['--build', build, '--target', ...programs]);
}
