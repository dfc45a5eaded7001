// The weave refuses what must not reach a reader: each fault in a section is told in one line that names file and
// line, and all of them at once. Run by ctest; by hand: BOOK_PACKAGES=build/book/npm node --test tests/book/weave.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { after, before, test } from 'node:test';
import { asTeX, asText, format, powers } from '../../book/numbers.mjs';
import { palette } from '../../book/figure.mjs';
import { packages } from '../../book/packages.mjs';
import { blocks, named } from '../../book/section.mjs';
import { rows } from '../../book/table.mjs';
import { asked, folded } from '../../book/search.mjs';
import { breaking, clauses, formulasIn, readable, roomy, texOf } from '../../book/tex.mjs';

const katex = packages('katex');
const root = path.resolve(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '../..');
const edition = JSON.parse(fs.readFileSync(path.join(root, 'book/edition.json'), 'utf8'));
let place;
before(() => {
  place = fs.mkdtempSync(path.join(os.tmpdir(), 'weave-'));
});
after(() => fs.rmSync(place, { recursive: true }));

const section = `#include "edition/section.hpp"

SECTION(pendulum, 11, "A section for the test")

/*!
## What Euler does
He finds a third {{entry slip}}. See {{sec pendulum.12}} and {{eq 1}}.

$$ \\frac{x}{2} = {{half|3}} \\tag{1} $$

$$ x = 1{{entry slip}} \\tag{A} $$

## The program
One line.
*/

double half(double x)  // (1)
{
  return x / 2;
}

const auto x = real("x", 1.0, none, scale, "what is halved");

TELL
{
  tell("half", half(x), "half of one");
}

/*!
It is {{half|f2}}. In {{half|f2}} s or {{half|f2}}
ft it stays together, and {{half|f2}} so far does not.

{{table rows}}

::: figure pendulum-11
alt: A line at {{half}}.

The caption.
:::

## Speed against error
*/

TELL
{
  race("half", "½", 0.5, {{"by hand", [] { return 0.5; }}, {"by eye", [] { return 0.4; }}});
}

/*!
## Checks
*/

CHECK_THAT("half of one is a half")
{
  CHECK(half(1) == 0.5);
}

const Erratum slip{
    "§11", {"1/3", 1.0 / 3}, {"1/2", 0.5}, "it is a half", [](double reading) { return reading == 0.5; }};

/*!
## Go on from here

::: exercise
What is half of two?
answer: One.
:::
*/
`;
const told = {
  chapter: 'pendulum',
  section: 11,
  id: 'pendulum.11',
  title: 'A section for the test',
  parameters: [
    {
      name: 'x',
      kind: 'real',
      unit: '',
      default: 1,
      value: 1,
      range: '1e-100 ≤ x ≤ 1e100',
      lo: 1e-100,
      hi: 1e100,
      lo_open: false,
      hi_open: false,
      log: true,
      meaning: 'what is halved',
    },
  ],
  values: [{ name: 'half', value: 0.5, unit: '', digits: 12, meaning: 'half of one' }],
  tables: [
    {
      name: 'rows',
      caption: 'Halves',
      columns: [{ name: 'of', heading: 'of', unit: '', digits: 3 }],
      rows: [[0.25], [0.125]],
    },
  ],
  curves: [{ name: 'line', columns: ['x', 'y'] }],
  scenes: [],
  races: [
    {
      name: 'half',
      quantity: '½',
      exact: '0.5',
      methods: [
        { name: 'by hand', value: 0.5, ulps: 0, relative: 0 },
        { name: 'by eye', value: 0.4, ulps: 9e14, relative: 0.2 },
      ],
    },
  ],
  errata: [
    { kind: 'erratum', where: '§11', copy: '1/3', right: '1/2', because: 'it is a half', shown: true },
  ],
  emendations: [],
  doubtful: [],
  undecided: [],
};
const check = {
  id: 'pendulum.11',
  passed: true,
  cases: [
    {
      name: 'half of one is a half',
      line: 51,
      passed: true,
      claims: [
        {
          expression: 'half(1) == 0.5',
          line: 53,
          passed: true,
          times: 3,
          at: 'x=2',
          got: '0.5',
          expected: '0.5',
          tolerance: 'exactly',
          used: 0,
          because: '',
        },
      ],
    },
  ],
  covers: { half: [1], 'rows.of': [1], 'half/by hand': [1] },
  infinite: [],
  limits: [],
  uncovered: [],
  apparatus: [
    {
      kind: 'erratum',
      where: '§11',
      copy_holds: false,
      right_holds: true,
      third_holds: false,
      expected: '0.5',
      tolerance: 'exactly',
      because: '',
      passed: true,
    },
  ],
};
const words = `Pendulum §11. A section for the test

  x  = 1  what is halved

  half  0.5  half of one

Halves
  of
  0.25
  0.125
`;
const figure = 'load "figures/style.gp"\nplot tsv("pendulum-11.line") using "x":"y"\n';
const drawing =
  '<svg\n viewBox="0 0 640 400">\n<g id="gnuplot_canvas">\n<defs>\n</defs>\n' +
  "<path stroke='rgb( 20,  71, 154)' d='M0,0 L1,1'/>\n</g>\n</svg>\n";

const weaver = path.join(root, 'book/weave.mjs');
let weaves = 0;

/** What the weaver says of two folders. It is loaded anew each time, but for the modules that it takes, which keep nothing. */
async function woven(...words) {
  const told = { status: 0, stdout: '', stderr: '' };
  const { argv, exitCode } = process;
  const { log, error } = console;
  process.argv = [process.execPath, weaver, ...words];
  process.exitCode = 0;
  console.log = (line) => (told.stdout += `${line}\n`);
  console.error = (line) => (told.stderr += `${line}\n`);
  try {
    await import(`${pathToFileURL(weaver)}?${(weaves += 1)}`);
    told.status = process.exitCode;
  } catch (thrown) {
    told.status = 1;
    told.stderr += thrown.stack;
  } finally {
    Object.assign(console, { log, error });
    Object.assign(process, { argv, exitCode });
  }
  return told;
}

/** Weaves a book of one section, after `spoil` has changed some of its files. */
async function weave(spoil = () => {}, ...options) {
  const source = fs.mkdtempSync(path.join(place, 'source-'));
  const build = fs.mkdtempSync(path.join(place, 'build-'));
  const files = {
    [`${source}/chapters/pendulum/s11.cpp`]: section,
    [`${source}/figures/pendulum-11.gp`]: figure,
    [`${build}/told/pendulum-11.txt`]: words,
    [`${build}/told/pendulum-11.json`]: JSON.stringify(told),
    [`${build}/told/pendulum-11.check.json`]: JSON.stringify(check),
    [`${build}/told/pendulum-11.line.tsv`]: 'x\ty\n0\t0\n',
    [`${build}/drawn/pendulum-11.svg`]: drawing,
    [`${build}/programs.txt`]: 'pendulum-11\n',
    [`${build}/made-with.json`]: '{"compiler": "none"}',
    [`${build}/other-systems.json`]: JSON.stringify({
      question: { T: ['1', '2', '4'], Phi: ['1', '2', '4'] },
      systems: [],
      engines: {
        pendulum: { 0: '2', 0.004: '2', 0.005: '2' },
        ball: '3',
        edition: { bob: '0', pendulum: { period: 2, amplitude: 90 }, ball: { period: 3, amplitude: 68.8 } },
      },
    }),
    [`${source}/book/matter/index.md`]: '# The book\n\nIt opens.\n',
    [`${source}/CMakeLists.txt`]: 'project(euler-on-oscillation VERSION 1.0.0)\n',
    [`${source}/figures/style.gp`]: fs.readFileSync(path.join(root, 'figures/style.gp'), 'utf8'),
  };
  for (const { id } of edition.chapters) files[`${source}/chapters/${id}/chapter.md`] = `# ${id}\n\nIt opens.\n`;
  spoil({
    replace(name, from, to) {
      const key = Object.keys(files).find((k) => k.endsWith(name));
      assert.ok(files[key].includes(from), `${name} has "${from}"`);
      files[key] = files[key].replace(from, () => to);
    },
    add(name, text) {
      files[name.startsWith('told') ? `${build}/${name}` : `${source}/${name}`] = text;
    },
    remove(name) {
      delete files[Object.keys(files).find((k) => k.endsWith(name))];
    },
  });
  const link = (name) => {
    fs.mkdirSync(path.dirname(path.join(source, name)), { recursive: true });
    fs.symlinkSync(path.join(root, name), path.join(source, name));
  };
  for (const [file, text] of Object.entries(files)) {
    fs.mkdirSync(path.dirname(file), { recursive: true });
    fs.writeFileSync(file, text);
  }
  for (const name of fs.readdirSync(path.join(root, 'book')).filter((f) => f !== 'matter'))
    link(`book/${name}`);
  for (const name of fs.readdirSync(path.join(root, 'book/matter')).filter((f) => f !== 'index.md'))
    link(`book/matter/${name}`);
  const run = await woven(source, build, ...options);
  const page = (name = 'pendulum-11') => fs.readFileSync(path.join(build, `dox/${name}.dox`), 'utf8');
  return { ...run, page, source, build };
}

/** The same by a process of its own, as the build does it. */
function byItself({ source, build }) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [weaver, source, build], { encoding: 'utf8' });
  return { status, stdout, stderr };
}

/** The line of the section's file on which a piece of it stands, once it is spoilt. */
const lineOf = (text, piece) => text.slice(0, text.indexOf(piece)).split('\n').length;

test('a section that is right is woven', async () => {
  const { page, source, build, ...said } = await weave();
  const { status, stderr } = said;
  assert.equal(stderr, '');
  assert.equal(status, 0);
  const html = page();
  assert.deepEqual(byItself({ source, build }), said);
  assert.equal(page(), html);
  assert.match(html, /\\page pendulum-11 A section for the test/);
  assert.match(html, /<data class="told"[^>]*data-name="pendulum.11.half"[^>]*value="0.5">0.50<\/data>/);
  assert.match(html, /data-name="pendulum\.11\.half" data-format="3"/); // in the formula
  assert.match(html, /0\.50<\/data>\u00a0s or [^]*0\.50<\/data>\u00a0ft it stays[^]*0\.50<\/data> so far/);
  assert.match(html, /<desc[^>]*>A line at 0\.5\.<\/desc>/);
  assert.match(html, /id="eq-1"[^]*href="#code-1"/);
  assert.match(html, /class="equation ours" id="eq-A"/);
  assert.match(html, /<a class="siglum" id="at-slip" href="#erratum-1"[^>]*>⁕<\/a>/);
  assert.match(html, /<section class="entry erratum" id="erratum-1">[^]*href="#at-slip"/);
  assert.doesNotMatch(html, /annotation[^>]*>[^<]*htmlData/); // what is copied is plain TeX
  assert.match(html, /<tr data-parameter="x">/);
  assert.match(html, /<tr data-check="1" data-claim="1">[^]*3 times, the nearest to failing: at x=2/);
  assert.match(html, /"pendulum\.11\.half":\{"value":"0\.5"[^]*"checks":\[\{"n":1,/);
  assert.match(html, /class="exercise"[^]*<summary>answer<\/summary>/);
  assert.match(html, /✓ holds<\/span> Half of one is a half/);
  assert.match(html, /<span class="kind">erratum<\/span>/);
  const order = ['what-euler-does', 'the-program', 'what-it-says', 'fig-1', 'speed-against-error', 'checks'];
  const places = order.map((id) => html.indexOf(`id="${id}"`));
  assert.deepEqual(places, [...places].sort((a, b) => a - b));
  assert.ok(places.every((at) => at > 0));
  // What is typeset is not in the terminal block once more.
  const block = /<pre class="told"[^]*?<\/pre>/.exec(html)[0];
  assert.match(block, /half of one/);
  assert.doesNotMatch(block, /0\.125|what is halved|by hand/);
  assert.match(block, /the parameters, as above[^]*the table “Halves”, as below/);
  assert.match(html, /stroke="var\(--blue\)"/);
  assert.match(html, /<title id="pendulum-11-title">A line at 0\.5\.<\/title>/);
  assert.match(html, /href="pendulum\.html#s12">§\u00a012<\/a>/);
});

/** Each fault: what is spoilt, and what the one line must say. */
const faults = {
  'an unknown value': [
    ['s11.cpp', '{{half|f2}}', '{{third}}'],
    /s11\.cpp:LINE: no value is told by the name of \{\{third\}\}/,
    '{{third}}',
  ],
  'a recorded number that is none': [
    ['s11.cpp', '{{half|f2}}', '{{speed.k-by-modulus.this-edition.slower}}'],
    /s11\.cpp:LINE: \{\{speed\.k-by-modulus\.this-edition\.slower\}\} ends in none of/,
    '{{speed',
  ],
  'a recorded number of no scene': [
    ['s11.cpp', '{{half|f2}}', '{{speed.k-by-hand.table.worst}}'],
    /s11\.cpp:LINE: no scene k-by-hand/,
    '{{speed',
  ],
  'an unknown value in a formula': [
    ['s11.cpp', '{{half|3}}', '{{third}}'],
    /s11\.cpp:\d+: no value is told by the name of \{\{third\}\}/,
  ],
  'an unknown format': [
    ['s11.cpp', '{{half|f2}}', '{{half|x2}}'],
    /s11\.cpp:LINE: no format \|x2/,
    '{{half|x2}}',
  ],
  'a formula that does not parse': [
    ['s11.cpp', '\\frac{x}{2}', '\\frac{x}{2'],
    /s11\.cpp:LINE: .*KaTeX parse error/,
    '\\frac',
  ],
  'a link to no formula': [
    ['s11.cpp', '{{eq 1}}', '{{eq 7}}'],
    /s11\.cpp:LINE: no formula \(7\)/,
    '{{eq 7}}',
  ],
  'a link to no section': [
    ['s11.cpp', '{{sec pendulum.12}}', '{{sec pendulum.39}}'],
    /s11\.cpp:LINE: there is no section pendulum\.39/,
    '{{sec',
  ],
  'a margin note that no paragraph follows': [
    ['s11.cpp', '## The program\nOne line.', '::: margin\nToday.\n:::\n\n## The program\nOne line.'],
    /s11\.cpp:LINE: a margin note begins beside the paragraph that follows it, and none does/,
    '::: margin',
  ],
  'a $ without its fellow': [
    ['s11.cpp', 'One line.', 'One $x line.'],
    /s11\.cpp:LINE: an odd number of \$/,
    'One $x',
  ],
  'a $ without its fellow, on a later line of a paragraph': [
    ['s11.cpp', 'One line.', 'One\nline and $x.'],
    /s11\.cpp:LINE: an odd number of \$/,
    'line and',
  ],
  'HTML in prose': [
    ['s11.cpp', 'One line.', 'One <b>line</b>.'],
    /s11\.cpp:LINE: HTML in prose: <b>/,
    'One <b>',
  ],
  'degrees of what is no angle': [
    ['s11.cpp', '{{half|f2}}', '{{half|deg1}}'],
    /s11\.cpp:LINE: \{\{half\|deg1\}\}: the format is for angles/,
    '{{half|deg1',
  ],
  'a number given twice': [
    ['s11.cpp', '\\tag{A}', '\\tag{1}'],
    /s11\.cpp:LINE: a second formula \(1\)/,
    '$$ x = 1',
  ],
  'a formula that is neither his nor ours': [
    ['s11.cpp', '\\tag{A}', '\\tag{x}'],
    /s11\.cpp:LINE: \\tag\{x\}: Euler's formulae have numbers/,
    '$$ x = 1',
  ],
  'a sign that ends a column': [
    ['s11.cpp', '$$ x = 1', '$$ \\begin{aligned} x = & 1 \\end{aligned}'],
    /s11\.cpp:LINE: a sign before & has no room behind it/,
    '$$ \\begin{aligned}',
  ],
  'a number typed by hand': [
    ['s11.cpp', 'It is {{half|f2}}.', 'It is 0.500.'],
    /s11\.cpp:LINE: 0\.500 is typed by hand; the program tells it: \{\{half\}\}/,
    'It is 0.500',
  ],
  'a line over the limit': [
    ['s11.cpp', 'One line.', `One line${' and more'.repeat(13)}.`],
    /s11\.cpp:LINE: a line of 126 characters; 110 is the limit/,
    'One line and',
  ],
  'a bar that ends a cell': [
    ['s11.cpp', 'One line.', '| a | b |\n| --- | --- |\n| $|x|$ | b |'],
    /s11\.cpp:LINE: a table row with more or fewer cells/,
    '| $|x|',
  ],
  "a function's name set as a product": [
    ['s11.cpp', 'One line.', 'One $\\mathrm{sn}\\,u$ line.'],
    /s11\.cpp:LINE: a function's name is \\operatorname/,
    'One $',
  ],
  'a piece of the library that is not marked': [
    ['s11.cpp', 'One line.', '::: code pendulum/series.hpp nothing\n:::'],
    /s11\.cpp:LINE: src\/pendulum\/series\.hpp has not two lines \/\/ \[nothing\]/,
    '::: code',
  ],
  'a sign for no entry': [
    ['s11.cpp', 'a third {{entry slip}}', 'a third {{entry slip}} {{entry slap}}'],
    /s11\.cpp:LINE: no entry of the apparatus is called slap/,
    'a third',
  ],
  'a race under another heading': [
    ['s11.cpp', '/*!\n## Checks\n*/', '/*!\n## Checks\n*/\n\nTELL\n{\n  race("half");\n}'],
    /s11\.cpp:\d+: a race stands under the heading "Speed against error"/,
  ],
  'a number that no check looks at': [
    ['check.json', '"uncovered":[]', '"uncovered":["no claim looks at half"]'],
    /s11\.cpp:1: no claim looks at half/,
  ],
  'a limit that no check comes to': [
    ['s11.cpp', 'TELL\n{', 'TELL\n{\n  require(x <= 2, "x",\n          "at most 2");'],
    /s11\.cpp:LINE: no check comes to this require\(\)/,
    'require(',
  ],
  'two limits in one': [
    ['s11.cpp', 'TELL\n{', 'TELL\n{\n  require(x > 0 && x <= 2, x > 1 ? "x" : "y", "at most 2");'],
    /s11\.cpp:LINE: a require\(\) has one limit; two are two/,
    'require(',
  ],
  'code that names no formula': [
    ['s11.cpp', '// (1)', '// (2)'],
    /s11\.cpp:1: a comment in the code names the formula \(2\)/,
  ],
  'headings out of order': [
    ['s11.cpp', '## The program', '## Checks'],
    /s11\.cpp:LINE: the heading "Checks" stands after "Checks"/,
    '## Checks\n*/',
  ],
  'a heading left out': [['s11.cpp', '## Checks\n', '\n'], /s11\.cpp:1: the heading "Checks" is missing/],
  'an unknown division': [
    ['s11.cpp', '::: figure pendulum-11', '::: picture pendulum-11'],
    /s11\.cpp:LINE: ::: picture/,
    '::: picture',
  ],
  'a figure without words': [
    ['s11.cpp', 'alt: A line at {{half}}.\n\n', ''],
    /s11\.cpp:LINE: ::: figure pendulum-11 needs "alt/,
    '::: figure',
  ],
  'a figure without a script': [
    ['s11.cpp', '::: figure pendulum-11', '::: figure pendulum-11-more'],
    /s11\.cpp:LINE: there is no figures\/pendulum-11-more\.gp/,
    '::: figure',
  ],
  'a division never closed': [
    ['s11.cpp', 'The caption.\n:::', 'The caption.'],
    /s11\.cpp:\d+: ::: figure pendulum-11 is never closed/,
  ],
  'a check that was not run': [
    ['s11.cpp', 'half of one is a half', 'half of one is a third'],
    /s11\.cpp:LINE: the check "half of one is a third" was not run/,
    'CHECK_THAT',
  ],
  'an entry that is not told': [
    ['s11.cpp', '"§11", {"1/3"', '"§12", {"1/3"'],
    /s11\.cpp:LINE: the erratum "§12" is not told/,
    'const Erratum',
  ],
  'a section that says nothing': [['s11.cpp', 'TELL\n', 'void f()\n'], /s11\.cpp:1: no TELL block/],
  'a colour outside the palette': [
    ['pendulum-11.svg', '20,  71, 154', '20,  71, 155'],
    /figures\/pendulum-11\.gp: the colour rgb\( 20, 71, 155\)/,
  ],
  'data that no program writes': [
    ['pendulum-11.gp', 'pendulum-11.line', 'pendulum-11.curve'],
    /figures\/pendulum-11\.gp:1: draws from pendulum-11\.curve\.tsv/,
  ],
  "JSON that is not the schema's": [
    ['pendulum-11.json', '"values"', '"worths"'],
    /told\/pendulum-11\.json:1: .*values.*section\.json/,
  ],
};
for (const [name, [spoilt, message, piece]] of Object.entries(faults))
  test(`refused: ${name}`, async () => {
    const { status, stderr } = await weave((files) => files.replace(...spoilt));
    const line = piece
      ? lineOf(
          section.replace(spoilt[1], () => spoilt[2]),
          piece,
        )
      : 0;
    assert.match(stderr, new RegExp(message.source.replace('LINE', line)));
    for (const told of stderr.trim().split('\n')) assert.match(told, /^[\w./-]+:\d+: \S/);
    assert.equal(status, 1);
  });

test('what confirms an answer is folded as the answer is', async () => {
  const claimed = 'CHECK_THAT("half of one is a half")\n{\n  CHECK(half(1) == 0.5);\n}\n';
  const { stderr, page } = await weave((files) => {
    files.replace('s11.cpp', claimed, '');
    files.replace('s11.cpp', 'answer: One.\n:::\n*/\n', `answer: One.\n:::\n*/\n\n${claimed}`);
  });
  assert.equal(stderr, '');
  assert.match(page(), /<details class="folded"><summary>what confirms it<\/summary><section class="check" id="check-1">/);
});

test('refused: an orphan figure script', async () => {
  assert.match(
    (await weave((files) => files.add('figures/pendulum-12.gp', figure))).stderr,
    /^figures\/pendulum-12\.gp:1: an orphan/,
  );
});
test('refused: what Doxygen would lose of the library', async () => {
  const header = async (text) => (await weave((files) => files.add('src/swing/time.hpp', text))).stderr;
  assert.match(await header('/// | a | b |\n/// | --- | --- |\n/// | `x|y` | b |\n'), /^src\/swing\/time\.hpp:3: a bar in code/);
  assert.match(await header('/// | \\f$|x|\\f$ | b |\n'), /^src\/swing\/time\.hpp:1: a bar in code or in a formula/);
  assert.match(await header('/// It is \\f$\\mathrm{sn}\\,u\\f$.\n'), /^src\/swing\/time\.hpp:1: a function's name/);
  const twice = '/// It is.\ntemplate <class T>\n  requires A<T>\nT f(T x) requires B<T>;\n';
  assert.match(await header(twice), /^src\/swing\/time\.hpp:2: two "requires" clauses/);
  const once = '// requires\ntemplate <class T>\n  requires(A<T> && requires(T x) { x + x; })\nT f(T x);\n';
  assert.equal(await header(once), '');
});

test('refused: no figure and no reason for none; a reason is enough', async () => {
  const without = (instead) => (files) => {
    files.replace('s11.cpp', '::: figure pendulum-11\nalt: A line at {{half}}.\n\nThe caption.\n:::', instead);
    files.remove('pendulum-11.gp');
  };
  assert.match(
    (await weave(without(''))).stderr,
    /^chapters\/pendulum\/s11\.cpp:1: no figure, and no reason for none/,
  );
  assert.equal((await weave(without('::: no-figure\nNothing is drawn.\n:::'))).status, 0);
});
test('a page that is no section may show a section its figure, without a number', async () => {
  const { status, page } = await weave((files) =>
    files.replace('index.md', 'It opens.', '::: figure pendulum-11\nalt: A line.\n\nIt stands in front.\n:::'),
  );
  assert.equal(status, 0);
  assert.match(page('index'), /<figure data-figure="pendulum-11">\n<div[^]*<figcaption>It stands in front\./);
});
test('refused: a program without a page, a page without a program', async () => {
  assert.match(
    (await weave((files) => files.replace('programs.txt', 'pendulum-11', 'pendulum-11\npendulum-12'))).stderr,
    /^chapters\/pendulum\/s12\.cpp:1: the program pendulum-12 has no section file/,
  );
  assert.match(
    (await weave((files) => files.add('chapters/globe/s01.cpp', section))).stderr,
    /^chapters\/globe\/s01\.cpp:1: is no program of this build/,
  );
});
test('refused: a program that has told nothing', async () => {
  assert.match(
    (await weave((files) => files.remove('pendulum-11.json'))).stderr,
    /^chapters\/pendulum\/s11\.cpp:1: the program pendulum-11 has told nothing/,
  );
});
test('refused: an entry that nothing refers to, unless it says that its place is not shown', async () => {
  const without = (files) => {
    files.replace('s11.cpp', 'a third {{entry slip}}', 'a third');
    files.replace('s11.cpp', 'x = 1{{entry slip}}', 'x = 1');
  };
  assert.match((await weave(without)).stderr, /s11\.cpp:\d+: nothing in the account refers to this erratum: put \{\{entry slip\}\}/);
  const { status } = await weave((files) => {
    without(files);
    files.replace('pendulum-11.json', '"shown":true', '"shown":false');
  });
  assert.equal(status, 0);
});
test('all faults of a weave are told at once, in the order of the file', async () => {
  const { page, source, build, ...said } = await weave((files) => {
    files.replace('s11.cpp', '{{half|f2}}', '{{third}}');
    files.replace('s11.cpp', 'One line.', 'One $x line, and <i>HTML</i>.');
    files.replace('s11.cpp', '{{sec pendulum.12}}', '{{sec pendulum.39}}');
    files.replace('index.md', 'It opens.', 'It opens {{nothing}}.');
  });
  const { status, stderr } = said;
  assert.equal(status, 1);
  assert.deepEqual(byItself({ source, build }), said);
  const lines = stderr.trim().split('\n');
  assert.equal(lines.length, 5, stderr);
  assert.match(lines[0], /^book\/matter\/index\.md:3: /);
  const numbers = lines.slice(1).map((l) => Number(l.split(':')[1]));
  assert.deepEqual(numbers, [...numbers].sort((a, b) => a - b));
});
test('one page alone is woven with all its faults, and no one else’s', async () => {
  const alone = ['--only', 'pendulum-11'];
  const { status, stdout, page } = await weave(
    (files) => files.replace('index.md', 'It opens.', 'It opens {{nothing}}.'),
    ...alone,
  );
  assert.equal(status, 0);
  assert.match(stdout, /woven: 1 page/);
  assert.match(page(), /A section for the test/);
  const spoilt = await weave((files) => files.replace('s11.cpp', '{{half|f2}}', '{{third}} and {{fourth}}'), ...alone);
  assert.equal(spoilt.status, 1);
  assert.equal(spoilt.stderr.trim().split('\n').length, 2);
});
test('a chapter has its map, its notation and its words', async () => {
  const map = '# What needs what\n\n::: map\n11 <- 7 8\n:::\n\n::: route\n11: Because.\n:::\n';
  const notation = (where) =>
    `| Euler | today | in the code | meaning | first |\n| --- | --- | --- | --- | --- |\n| $a$ | | | a letter | ${where} |\n`;
  const add = (files, wrong) => {
    files.add('chapters/pendulum/map.md', wrong ? map.replace('7 8', '7 39') : map);
    files.add('chapters/pendulum/notation.md', notation(wrong ? '' : '{{sec pendulum.11}}'));
    files.add('chapters/pendulum/glossary.md', wrong ? 'sagitta\nan arrow\n' : 'sagitta\n: An arrow.\n');
  };
  const { status, stderr, page } = await weave((files) => add(files, false));
  assert.equal(stderr, '');
  assert.equal(status, 0);
  assert.match(page('pendulum-map'), /<div class="needs"><svg[^]*<path[^]*needs §\u00a07, §\u00a08/);
  assert.match(page('pendulum-map'), /<ol class="route">[^]*pendulum-11\.html[^]*Because/);
  assert.match(page('notation'), /<a href="pendulum-11\.html">§\u00a011<\/a>/);
  assert.match(page('glossary'), /<dt id="term-sagitta">sagitta<\/dt>/);
  const wrong = (await weave((files) => add(files, true))).stderr;
  assert.match(wrong, /pendulum\/map\.md:4: there is no § 39/);
  assert.match(wrong, /pendulum\/notation\.md:3: the row does not say where/);
  assert.match(wrong, /pendulum\/glossary\.md:1: an entry is a line with the term/);
});
test('rows of fractions that follow each other are given room, and no others', () => {
  const aligned = (rows) => `\\begin{aligned} ${rows} \\end{aligned}`;
  const two = (between) => aligned(`a &= \\frac12,\\\\${between} b &= \\dfrac13`);
  assert.equal(roomy(two('')), two('[10pt]'));
  assert.equal(roomy(two('[4pt]')), two('[10pt]')); // less than a fraction's own depth has no effect
  assert.equal(roomy(two('[12pt]')), two('[12pt]'));
  assert.equal(roomy(two('[1em]')), two('[1em]'));
  const alone = aligned('a &= \\frac12,\\\\ b &= 1\\\\[3pt] c &= \\frac13\\\\ d &= \\tfrac15');
  assert.equal(roomy(alone), alone);
  assert.equal(roomy(`\\frac12\\\\ ${aligned('1')}\\\\ \\frac13`), `\\frac12\\\\ ${aligned('1')}\\\\ \\frac13`);
  const inner = (between) => `\\begin{gathered} ${aligned('a\\\\ \\frac12')}\\\\${between} \\frac34 \\end{gathered}`;
  assert.equal(roomy(inner('')), inner('[10pt]'));
  const height = (tex) => Number(/class="(?:katex-)?strut" style="height:([\d.]+)em/.exec(katex.renderToString(tex, { displayMode: true }))[1]);
  assert.ok(height(roomy(two(''))) > height(two('')) + 0.3);
});

test('formulae that stand side by side may part, brackets do not', () => {
  const set = (tex) => clauses(katex.renderToString(breaking(tex), { displayMode: true, strict: 'error' }));
  const both = set('a = \\frac12, \\qquad b = 3');
  assert.equal(both.split('<span class="clause"><span class="katex-base">').length, 3);
  assert.equal(both.match(/<span\b/g).length, both.match(/<\/span>/g).length);
  assert.ok(!/allowbreak|<mspace><\/mspace>/.test(both.replace(/<annotation[^]*?<\/annotation>/, '')));
  for (const one of ['a = f(b + c) + d', 'a = f + (b + c)^2', 'a + \\bigl(b + c\\bigr)^2'])
    assert.equal(set(one).split('<span class="whole">').length, 2);
  assert.ok(!set('a + (b + c + d + e + f)').includes('whole')); // too long to be kept together
  for (const one of ['a = b + c', 'a, b) + c', '(a + b', '\\begin{gathered} a, \\qquad b \\end{gathered}'])
    assert.equal(set(one), katex.renderToString(one, { displayMode: true }));
});

test('readings become formulae where they are ones, and readable again where they are searched', () => {
  assert.equal(texOf('dz/(1 − zz)'), 'dz/(1-zz)');
  assert.equal(texOf('1,1805'), '1{,}1805');
  assert.equal(texOf('√(cc − zz)'), '\\sqrt{cc-zz}');
  assert.equal(texOf('sin²α'), '\\sin ^{2}α');
  assert.equal(texOf('f + c cos Φ dΦ/dt'), 'f+c\\cos Φ\\,dΦ/dt');
  assert.equal(texOf('(n:k)√gc ∓ 3aakkPP'), '(n:k)\\sqrt{gc}\\mp 3aakkPP');
  assert.equal(texOf('[ackk] / [2aafx(…)]'), '[ackk]/[2aafx(\\dots )]');
  assert.equal(texOf('the longer (maius)'), null);
  assert.equal(texOf('15½ and 31'), null);
  assert.deepEqual(formulasIn('its derivative must be 1/sinⁿ⁺¹ω, here at v = ½'), [
    'its derivative must be ', '1/\\sin ^{n+1}ω', ', here at ', 'v=\\tfrac12 ', '',
  ]); // prettier-ignore
  assert.deepEqual(formulasIn('(a−s)²(c − ∫(a−s)dφ sin φ) over kk'), ['', '(a-s)^{2}(c-\\int (a-s)dφ\\sin φ)', ' over kk']);
  assert.deepEqual(formulasIn('+ k l(1+√2), or − k l(√2−1)'), [
    '', '+kl\\,(1+\\sqrt{2})', ', or ', '-kl\\,(\\sqrt{2}-1)', '',
  ]); // prettier-ignore
  for (const words of ['the longer (maius)', 'GZ : GH = 1.11', 'dds is a ddΦ', 'a 3 read or set as a 5', '(1) with c', 't√2gc'])
    assert.deepEqual(formulasIn(words), [words]); // what is no formula, or may be none
  assert.equal(readable('\\frac{t\\sqrt{2g}}{\\sqrt b} = \\tfrac12\\ln 2^{-3}'), '(t√(2g))/(√b) = ½ln 2⁻³');
});
test('a phrase in quotation marks is looked up as a phrase', () => {
  assert.deepEqual(asked('the "Rule of the" sagitta').phrases, [' rule of the ']);
  assert.equal(asked('rule').phrases.length, 0);
});
test('a check that fails is shown as failing', async () => {
  const { page } = await weave((files) =>
    files.replace('check.json', '"line":51,"passed":true', '"line":51,"passed":false'),
  );
  assert.match(page(), /✗ fails<\/span> Half of one is a half/);
});

test('numbers are rounded on their decimals and written as prose and as mathematics', () => {
  const text = (value, spec, unit = '') => asText(format({ value, unit }, spec));
  for (const [value, spec, written] of [
    [1.1803405990160963, '', '1.18034'],
    [1.1803405990160963, '8', '1.1803406'],
    [0.999, 'f2', '1.00'],
    [9.996, '3', '10.0'],
    [-0.0004, 'f2', '0.00'],
    [0.000012345, '', '1.2345 × 10⁻⁵'],
    [1e-300, 'e3', '1.00 × 10⁻³⁰⁰'],
    [12, '', '12'],
    [123456789, '', '123456789'],
    [0.15432, 'percent1', '15.4 %'],
    [Math.PI / 3, 'deg2', '60.00°'],
    [2.5, 'f0', '3'],
    ['inf', '', '∞'],
    [-2.5, '', '−2.5'],
    ['by 3', '', 'by 3'],
  ])
    assert.equal(text(value, spec), written, `${value}|${spec}`);
  assert.equal(text(12.5, 'deg1', '°'), '12.5°'); // told in degrees: not converted again
  assert.equal(
    asText(format({ value: 1.18, text: '1.18034059901609622604533794056', unit: '' }, '20')),
    '1.1803405990160962260',
  );
  assert.equal(asTeX(format({ value: -0.00001, unit: '' }, 'e2')), '-1.0\\times10^{-5}');
  assert.equal(format({ value: 1, unit: '' }, 'x'), null);
});

test('an option is not broken behind its dashes', async () => {
  const call = '`pendulum-11 --x 0.000000001 --check`';
  const { page } = await weave((files) => files.replace('s11.cpp', 'He finds a third', `He finds ${call}, a third`));
  assert.match(page(), /<code>pendulum-11 <span class="stopped">--x<\/span> 0\.0+1 <span class="stopped">--check<\/span><\/code>/);
});

test('a sign of the apparatus stays on the line of its formula', async () => {
  const { page } = await weave((files) => files.replace('s11.cpp', 'He finds a third {{entry', 'He finds $\\tfrac13$ {{entry'));
  assert.match(page(), /He finds <span class="stopped"><span class="katex">[^]*?<\/span>\u00a0<a class="siglum"[^>]*>⁕<\/a><\/span>\. See/);
});

test('a range is written with powers of ten, as the numbers are', async () => {
  for (const [told, written] of [
    ['1e-10 ft ≤ b ≤ 10000000000 ft', '10⁻¹⁰ ft ≤ b ≤ 10¹⁰ ft'],
    ['-1e+12° ≤ Phi ≤ 1e+12°', '−10¹²° ≤ Phi ≤ 10¹²°'],
    ['1e-06 1/s ≤ theta_rate < 2000000 1/s²', '10⁻⁶ 1/s ≤ theta_rate < 2 × 10⁶ 1/s²'],
    ['5.72957795131e-299° ≤ omega < 90°', '5.72957795131 × 10⁻²⁹⁹° ≤ omega < 90°'],
    ['-0.25 ≤ x1 < 100000', '−0.25 ≤ x1 < 100000'],
    ['a whole number from 0 to 1000000', 'a whole number from 0 to 10⁶'],
  ])
    assert.equal(powers(told), written);
  assert.match((await weave()).page(), /<td class="word range">10⁻¹⁰⁰ ≤ x ≤ 10¹⁰⁰<\/td>/);
});

test('a column of numbers that were typed shows them so, one of results all its digits', () => {
  const table = {
    columns: [{ digits: 4 }, { digits: 6 }],
    rows: [[30.000000000000004, 1e-6], [0.5, 0.25000012], [90, 2]],
  };
  const cells = rows(table).map((row) => [...row.matchAll(/<td>(.*?)<\/td>/g)].map((m) => m[1]));
  assert.deepEqual(cells, [['30', '1.00000 × 10⁻⁶'], ['0.5', '0.250000'], ['90', '2']]);
});

test('the sign of a told angle or percentage stands once', async () => {
  const { status, stderr, page } = await weave((files) => {
    files.replace(
      'pendulum-11.json',
      '"values":[',
      '"values":[{"name":"angle","value":12.5,"unit":"°","meaning":"an angle"},' +
        '{"name":"part","value":0.125,"unit":"","meaning":"a part"},',
    );
    files.replace(
      's11.cpp',
      'It is {{half|f2}}.',
      'It is {{angle}}, {{angle|f2}}°, ${{angle}}^\\circ$ and {{part|percent1}}.',
    );
  });
  assert.equal(stderr, '');
  assert.equal(status, 0);
  const text = page().replace(/<annotation[^]*?<\/annotation>|<[^>]+>/g, '');
  assert.match(text, /It is 12\.5°, 12\.50°, /);
  assert.match(text, /and 12\.5 %\./);
  assert.doesNotMatch(page(), /circ\}?\^/);
});

test("a section's file comes apart at its seams", () => {
  const kinds = blocks(section, 's11.cpp').map((b) => b.kind);
  assert.deepEqual(
    kinds,
    'prose prose code TELL prose prose TELL prose check Erratum prose'.split(' '), // prose is parted at its headings
  );
  const parts = blocks(section, 's11.cpp').filter((b) => b.kind === 'prose');
  assert.deepEqual(
    parts.map((b) => section.split('\n')[b.line - 1].replace('## ', '')),
    ['What Euler does', 'The program', '/*!', 'Speed against error', 'Checks', 'Go on from here'],
  );
  assert.equal(blocks(section, 's11.cpp').find((b) => b.kind === 'Erratum').object, 'slip');
  assert.deepEqual(named('f();  // (3), (4)\n// (5) and (6)\ng(1);  // see (7)'), ['3', '4', '5', '6']);
  const [, piece] = blocks(
    '/*! x */\nCHECK_THAT("a brace } in a text, "\n           "and a \\"second\\" line")\n' +
      "{\n  CHECK('{');\n}\n",
    'f',
  );
  assert.equal(piece.name, 'a brace } in a text, and a "second" line');
});

test('the search takes u and v, i and j, æ and ae as one', () => {
  assert.equal(folded('Vis'), folded('uis'));
  assert.equal(folded('iuſtæ'), folded('justae'));
  assert.notEqual(folded('arcus'), folded('arcum'));
});

test('the palette is readable on its paper, light and dark', () => {
  const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  const luminance = (hex) =>
    [0.2126, 0.7152, 0.0722].reduce(
      (sum, weight, i) => sum + weight * linear(parseInt(hex.slice(1 + 2 * i, 3 + 2 * i), 16) / 255),
      0,
    );
  const contrast = (a, b) =>
    (Math.max(luminance(a), luminance(b)) + 0.05) / (Math.min(luminance(a), luminance(b)) + 0.05);
  const colours = palette(fs.readFileSync(path.join(root, 'figures/style.gp'), 'utf8'));
  const paper = colours.find((c) => c.name === 'paper');
  assert.ok(colours.length >= 9);
  for (const c of colours.filter((x) => !['paper', 'faint'].includes(x.name)))
    for (const which of ['light', 'dark'])
      assert.ok(
        contrast(c[which], paper[which]) >= 4.5,
        `${c.name}, ${which}: ${contrast(c[which], paper[which])}`,
      );
});

test('the pages say what our copy has, not what is printed', () => {
  const said = [];
  for (const chapter of fs.readdirSync(path.join(root, 'chapters'), { withFileTypes: true }).filter((d) => d.isDirectory()))
    for (const name of fs.readdirSync(path.join(root, 'chapters', chapter.name))) {
      const text = fs.readFileSync(path.join(root, 'chapters', chapter.name, name), 'utf8');
      const prose = name.endsWith('.md') ? [text] : [...text.matchAll(/\/\*![^]*?\n\*\/|"[^"\n]*"/g)].map(([piece]) => piece);
      for (const piece of prose)
        if (piece !== '"printed"' && /\bprinted\b/.test(piece.replace(/\{\{[^{}]*\}\}/g, '')))
          said.push(`${chapter.name}/${name}: ${/[^\n]*\bprinted\b[^\n]*/.exec(piece)[0]}`);
    }
  assert.deepEqual(said, []);
});
