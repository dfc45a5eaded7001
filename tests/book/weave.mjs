// The weave refuses what must not reach a reader: each fault in a section stops it with one line that names
// file and line. Run by ctest; by hand: BOOK_PACKAGES=build/book/npm node --test tests/book/weave.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { asTeX, asText, format } from '../../book/numbers.mjs';
import { palette } from '../../book/figure.mjs';
import { blocks, named } from '../../book/section.mjs';
import { folded } from '../../book/search.mjs';

const root = path.resolve(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '../..');
let place;
before(() => {
  place = fs.mkdtempSync(path.join(os.tmpdir(), 'weave-'));
});
after(() => fs.rmSync(place, { recursive: true }));

const section = `#include "edition/section.hpp"

SECTION(pendulum, 11, "A section for the test")

/*!
## What Euler does
He finds a half. See {{sec pendulum.12}} and {{eq 1}}.

$$ \\frac{x}{2} = {{half|3}} \\tag{1} $$

## The program
One line.
*/

double half(double x)  // (1)
{
  return x / 2;
}

TELL
{
  tell("half", half(1), "half of one");
}

/*!
It is {{half|f2}}.

::: figure pendulum-11
alt: A line.

The caption.
:::

## Checks
*/

CHECK_THAT("half of one is a half")
{
  CHECK(half(1) == 0.5);
}

const Erratum slip{
    "§11", {"1/3", 1.0 / 3}, {"1/2", 0.5}, "it is a half", [](double reading) { return reading == 0.5; }};
`;
const told = {
  chapter: 'pendulum',
  section: 11,
  id: 'pendulum.11',
  title: 'A section for the test',
  parameters: [],
  values: [{ name: 'half', value: 0.5, unit: '', meaning: 'half of one' }],
  tables: [],
  curves: [{ name: 'line', columns: ['x', 'y'] }],
  races: [],
  errata: [{ kind: 'erratum', where: '§11', printed: '1/3', right: '1/2', because: 'it is a half' }],
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
      line: 41,
      passed: true,
      claims: [
        {
          expression: 'half(1) == 0.5',
          passed: true,
          got: '0.5',
          expected: '0.5',
          tolerance: 'exactly',
          because: '',
        },
      ],
    },
  ],
  apparatus: [{ kind: 'erratum', where: '§11', printed_holds: false, right_holds: true, passed: true }],
};
const figure = 'load "figures/style.gp"\nplot tsv("pendulum-11.line") using "x":"y"\n';
const drawing =
  '<svg\n viewBox="0 0 640 400">\n<g id="gnuplot_canvas">\n<defs>\n</defs>\n' +
  "<path stroke='rgb( 20,  71, 154)' d='M0,0 L1,1'/>\n</g>\n</svg>\n";

/** Weaves a book of one section, after `spoil` has changed some of its files. */
function weave(spoil = () => {}) {
  const source = fs.mkdtempSync(path.join(place, 'source-'));
  const build = fs.mkdtempSync(path.join(place, 'build-'));
  const chapters = ['tautochrone', 'balance', 'pendulum', 'globe'];
  const files = {
    [`${source}/chapters/pendulum/s11.cpp`]: section,
    [`${source}/figures/pendulum-11.gp`]: figure,
    [`${build}/told/pendulum-11.txt`]: 'It says a half.\n',
    [`${build}/told/pendulum-11.json`]: JSON.stringify(told),
    [`${build}/told/pendulum-11.check.json`]: JSON.stringify(check),
    [`${build}/told/pendulum-11.line.tsv`]: 'x\ty\n0\t0\n',
    [`${build}/drawn/pendulum-11.svg`]: drawing,
    [`${build}/programs.txt`]: 'pendulum-11\n',
    [`${build}/made-with.json`]: '{"compiler": "none"}',
    [`${source}/book/matter/index.md`]: '# The book\n\nIt opens.\n',
    [`${source}/figures/style.gp`]: fs.readFileSync(path.join(root, 'figures/style.gp'), 'utf8'),
  };
  for (const c of chapters) files[`${source}/chapters/${c}/chapter.md`] = `# ${c}\n\nIt opens.\n`;
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
  const run = spawnSync(process.execPath, [path.join(root, 'book/weave.mjs'), source, build], {
    encoding: 'utf8',
  });
  const page = (name = 'pendulum-11') => fs.readFileSync(path.join(build, `dox/${name}.dox`), 'utf8');
  return { ...run, page };
}

/** The line of the section's file on which a piece of it stands, once it is spoilt. */
const lineOf = (text, piece) => text.slice(0, text.indexOf(piece)).split('\n').length;

test('a section that is right is woven', () => {
  const { status, stderr, page } = weave();
  assert.equal(stderr, '');
  assert.equal(status, 0);
  const html = page();
  assert.match(html, /\\page pendulum-11 A section for the test/);
  assert.match(html, /<data value="0.5"[^>]*>0.50<\/data>/);
  assert.match(html, /id="eq-1"[^]*href="#code-1"/);
  assert.match(html, /✓ holds<\/span> Half of one is a half/);
  assert.match(html, /<span class="kind">erratum<\/span>/);
  assert.match(html, /stroke="var\(--blue\)"/);
  assert.match(html, /<title id="pendulum-11-title">A line\.<\/title>/);
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
  'code that names no formula': [
    ['s11.cpp', '// (1)', '// (2)'],
    /s11\.cpp:1: a comment in the code names the formula \(2\)/,
  ],
  'headings out of order': [
    ['s11.cpp', '## The program', '## Checks'],
    /s11\.cpp:LINE: the heading "Checks" stands where "The program" is due/,
    '## Checks',
  ],
  'a heading left out': [['s11.cpp', '## Checks\n', '\n'], /s11\.cpp:1: the heading "Checks" is missing/],
  'an unknown division': [
    ['s11.cpp', '::: figure pendulum-11', '::: picture pendulum-11'],
    /s11\.cpp:LINE: ::: picture/,
    '::: picture',
  ],
  'a figure without words': [
    ['s11.cpp', 'alt: A line.\n\n', ''],
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
    /figures\/pendulum-11\.gp: the colour rgb\( 20,  71, 155\)/,
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
  test(`refused: ${name}`, () => {
    const { status, stderr } = weave((files) => files.replace(...spoilt));
    const line = piece
      ? lineOf(
          section.replace(spoilt[1], () => spoilt[2]),
          piece,
        )
      : 0;
    assert.match(stderr, new RegExp(message.source.replace('LINE', line)));
    assert.equal(stderr.trim().split('\n').length, 1, stderr);
    assert.equal(status, 1);
  });

test('refused: an orphan figure script', () => {
  assert.match(
    weave((files) => files.add('figures/pendulum-12.gp', figure)).stderr,
    /^figures\/pendulum-12\.gp:1: an orphan/,
  );
});
test('refused: no figure and no reason for none; a reason is enough', () => {
  const without = (instead) => (files) => {
    files.replace('s11.cpp', '::: figure pendulum-11\nalt: A line.\n\nThe caption.\n:::', instead);
    files.remove('pendulum-11.gp');
  };
  assert.match(
    weave(without('')).stderr,
    /^chapters\/pendulum\/s11\.cpp:1: no figure, and no reason for none/,
  );
  assert.equal(weave(without('::: no-figure\nNothing is drawn.\n:::')).status, 0);
});
test('a page that is no section may show a section its figure, without a number', () => {
  const { status, page } = weave((files) =>
    files.replace('index.md', 'It opens.', '::: figure pendulum-11\nalt: A line.\n\nIt stands in front.\n:::'),
  );
  assert.equal(status, 0);
  assert.match(page('index'), /<figure>\n<svg [^]*<figcaption>It stands in front\./);
});
test('refused: a program without a page, a page without a program', () => {
  assert.match(
    weave((files) => files.replace('programs.txt', 'pendulum-11', 'pendulum-11\npendulum-12')).stderr,
    /^chapters\/pendulum\/s12\.cpp:1: the program pendulum-12 has no section file/,
  );
  assert.match(
    weave((files) => files.add('chapters/globe/s01.cpp', section)).stderr,
    /^chapters\/globe\/s01\.cpp:1: is no program of this build/,
  );
});
test('refused: a program that has told nothing', () => {
  assert.match(
    weave((files) => files.remove('pendulum-11.json')).stderr,
    /^chapters\/pendulum\/s11\.cpp:1: the program pendulum-11 has told nothing/,
  );
});
test('a check that fails is shown as failing', () => {
  const { page } = weave((files) =>
    files.replace('check.json', '"line":41,"passed":true', '"line":41,"passed":false'),
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

test('the sign of a told angle or percentage stands once', () => {
  const { status, stderr, page } = weave((files) => {
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
  assert.deepEqual(kinds, ['prose', 'code', 'TELL', 'prose', 'check', 'Erratum']);
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
