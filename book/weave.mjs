// Weaves the book: from each section's file, and from what its program told, one page for Doxygen; then the
// chapters' openings and the pages of book/matter. Usage: node weave.mjs SOURCE BUILD (the repository, and
// build/book).
import fs from 'node:fs';
import path from 'node:path';
import { claims, reading, sigla, verdict } from './cards.mjs';
import { palette, inline, standalone, thumbnail } from './figure.mjs';
import { lists } from './lists.mjs';
import { packages } from './packages.mjs';
import { Formulas, Page, escape } from './prose.mjs';
import { blocks, named, tagged } from './section.mjs';
import { races, value } from './speed.mjs';

/** A fault is one line: where, and what. */
process.on('uncaughtException', (error) => {
  console.error(error.message);
  process.exitCode = 1;
});

const [source, build] = process.argv.slice(2).map((p) => path.resolve(p));
const read = (file) => fs.readFileSync(file, 'utf8');
const json = (file) => JSON.parse(read(file));
const kept = new Set();

/** Writes a file of the build when it is new or changed. */
function write(name, text) {
  const file = path.join(build, name);
  kept.add(file);
  if (fs.existsSync(file) && read(file) === text) return;
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(file, text);
}

function fail(file, line, message) {
  throw new Error(`${file}:${line}: ${message}`);
}

// ---------------------------------------------------------------------------------------------- the sections

const edition = json(path.join(source, 'book/edition.json'));
const Ajv = packages('ajv');
const valid = Object.fromEntries(
  ['section', 'check', 'speeds'].map((name) => [
    name,
    new Ajv({ strict: true, allErrors: false }).compile(json(path.join(source, `book/schema/${name}.json`))),
  ]),
);

function checked(schema, file) {
  const data = json(file);
  if (!valid[schema](data)) {
    const [{ instancePath, message }] = valid[schema].errors;
    fail(path.relative(build, file), 1, `${instancePath || '/'} ${message} (book/schema/${schema}.json)`);
  }
  return data;
}

/** The piece of a file of src/ between two lines `// [name]`. */
function snippet(file, name) {
  const whole = path.join(source, 'src', file);
  const parts = fs.existsSync(whole) ? read(whole).split(`// [${name}]`) : [];
  if (parts.length !== 3) throw new Error(`src/${file}:1: has not two lines // [${name}]`);
  return parts[1];
}

/** What is known of a section before its page is woven. */
function section(name) {
  const [chapter, number] = name.split('-');
  const file = `chapters/${chapter}/s${number}.cpp`;
  if (!fs.existsSync(path.join(source, file)))
    fail(file, 1, `the program ${name} has no section file, so no page`);
  const told = (ending) => path.join(build, `told/${name}.${ending}`);
  if (!fs.existsSync(told('json'))) fail(file, 1, `the program ${name} has told nothing; is it built?`);
  const all = blocks(read(path.join(source, file)), file);
  const prose = all
    .filter((b) => b.kind === 'prose')
    .map((b) => b.text)
    .join('\n');
  const code = [
    ...all.map((b) => b.code ?? ''),
    ...[...prose.matchAll(/^::: code (\S+) (\w+)(.*)$/gm)].map((m) => `//${m[3]}\n${snippet(m[1], m[2])}`),
  ];
  const speeds = path.join(source, `book/speeds/${name}.json`);
  return {
    id: `${chapter}.${number}`,
    name,
    chapter,
    number,
    file,
    blocks: all,
    text: read(told('txt')),
    told: checked('section', told('json')),
    check: checked('check', told('check.json')),
    speeds: fs.existsSync(speeds) ? checked('speeds', speeds) : null,
    equations: new Set(tagged(prose)),
    coded: new Set(code.flatMap(named)),
  };
}

const programs = read(path.join(build, 'programs.txt')).split('\n').filter(Boolean).sort();
for (const { id } of edition.chapters)
  for (const file of fs.readdirSync(path.join(source, 'chapters', id)).filter((f) => /^s\d\d\.cpp$/.test(f)))
    if (!programs.includes(`${id}-${file.slice(1, 3)}`))
      fail(`chapters/${id}/${file}`, 1, 'is no program of this build; run cmake again');

const book = {
  source,
  build,
  ...edition,
  formulas: new Formulas(path.join(build, 'formulas.json')),
  sections: new Map(programs.map(section).map((s) => [s.id, s])),
  swing: json(path.join(source, 'book/speeds/swing.json')),
  colours: palette(read(path.join(source, 'figures/style.gp'))),
  snippet,
  drawn: new Set(),
};

// ----------------------------------------------------------------------------------------------- the figures

/** A drawing on a page, with what can be taken away: itself, its script, its data. */
function shown(name, script, data, alt, opening, caption) {
  const drawn = path.join(build, `drawn/${name}.svg`);
  if (!fs.existsSync(drawn)) throw new Error(`${script} has drawn nothing`);
  const svg = read(drawn);
  const file = path.basename(script);
  write(`html/figures/${name}.svg`, standalone(svg, name, alt, book.colours));
  write(`html/figures/${file}`, read(path.join(source, script)));
  for (const tsv of data) {
    const told = path.join(build, 'told', tsv);
    if (!fs.existsSync(told)) fail(script, 1, `draws from ${tsv}, which no program writes`);
    write(`html/data/${tsv}`, read(told));
  }
  const links = [
    [`figures/${name}.svg`, 'drawing'],
    [`figures/${file}`, 'script'],
    ...data.map((f) => [`data/${f}`, f]),
  ];
  return (
    `${opening}\n${inline(svg, name, alt, book.colours)}<figcaption>${caption}` +
    `<span class="take">${links.map(([to, text]) => `<a href="${to}" download>${text}</a>`).join(' ')}` +
    `</span></figcaption>\n</figure>\n`
  );
}

/** A section's figure, on its own page; or, without a number, on a page that is no section. */
book.figure = (name, alt, caption, page) => {
  const script = `figures/${name}.gp`;
  const own = !page.section || name.startsWith(page.section.name);
  if (!own || !fs.existsSync(path.join(source, script)))
    throw new Error(`there is no ${script} for ::: figure ${name}`);
  const text = read(path.join(source, script));
  const data = [...new Set([...text.matchAll(/tsv\("([^"]+)"\)/g)].map((m) => `${m[1]}.tsv`))];
  const number = page.figures.length;
  if (!page.section) return shown(name, script, data, alt, '<figure>', `${caption} `);
  const label = `<span class="label">Fig. ${number}</span> ${caption}`;
  book.drawn.add(name);
  write(
    `html/thumbnails/${name}.svg`,
    thumbnail(read(path.join(build, `drawn/${name}.svg`)), name, book.colours),
  );
  return shown(name, script, data, alt, `<figure id="fig-${number}">`, label);
};

/** A plot that race.mjs has drawn by a script that many share, its data under the plot's own name. */
book.plot = (name, script, alt, caption) =>
  shown(name, script, [`${name}.tsv`], alt, '<figure>', `${caption} `);

// ----------------------------------------------------------------------------------------- the section pages

const html = (text) => `\\htmlonly[block]\n${text.replaceAll('*/', '*&#47;').trim()}\n\\endhtmlonly\n`;
const code = (text, file, line) => {
  if (/\*\/|\\endcode/.test(text)) fail(file, line, 'a block comment at the margin is prose; in code use //');
  return `\\code{.cpp}\n${text}\n\\endcode\n`;
};
const page = (name, title, body) => {
  const command = name === 'index' ? 'mainpage' : `page ${name} ${title.replace(/[\\@#%&<>"]/g, ' ')}`;
  return `/*! \\${command}\n${body}*/\n`;
};
const plurals = { erratum: 'errata', emendation: 'emendations' };
const headings = ['What Euler does', 'The program', 'Checks', 'Notes'];

/** A statement with a capital, unless it opens with a letter of Euler's: b, dz, l 2. */
const sentence = (words) =>
  /^(a|an|[a-z]{3,})\b/.test(words) || /^(as|at|by|if|in|it|no|of|on|so|to|up)\b/.test(words)
    ? words[0].toUpperCase() + words.slice(1)
    : words;

/** A TELL block; one that only feeds a figure or a race is folded under a line that says so. */
function folded(block, file) {
  const feeds = [
    [/\bcurve\(/, 'what the figure is drawn from'],
    [/\brace\(/, 'the ways that are compared'],
  ].filter(([call]) => call.test(block.code));
  const shown = code(block.code, file, block.line);
  if (!feeds.length || /\b(tell|tell_lines|table)\(/.test(block.code)) return shown;
  const summary = feeds.map(([, words]) => words).join(', and ');
  return html(`<details class="folded"><summary>${summary}</summary>`) + shown + html('</details>');
}

function sectionPage(s) {
  const p = new Page(book, s.file, s);
  const found = [];
  const count = { check: 0 };
  const last = s.blocks.filter((b) => b.kind === 'TELL').at(-1);
  if (!last) fail(s.file, 1, 'no TELL block: the section says nothing');
  const weave = {
    prose(b) {
      for (const m of b.text.matchAll(/^(#+) +(.*)$/gm)) {
        const line = b.line + b.text.slice(0, m.index).split('\n').length - 1;
        if (m[1] === '#' || m[1].length > 3 || (m[1] === '###' && !found.length))
          fail(s.file, line, `the heading "${m[0]}" is out of order`);
        if (m[1] === '##' && m[2] !== headings[found.length])
          fail(
            s.file,
            line,
            `the heading "${m[2]}" stands where "${headings[found.length] ?? 'none'}" is due`,
          );
        if (m[1] === '##') found.push(m[2]);
      }
      return html(p.html(b.text, b.line));
    },
    code: (b) => code(b.code, s.file, b.line),
    TELL: (b) => folded(b, s.file) + (b === last ? html(told(s)) : ''),
    check(b) {
      const run = s.check.cases.find((c) => c.name === b.name);
      if (!run) fail(s.file, b.line, `the check "${b.name}" was not run`);
      count.check += 1;
      return (
        html(
          `<section class="check" id="check-${count.check}"><p class="statement">${verdict(run.passed)} ` +
            `${escape(sentence(b.name))}</p>`,
        ) +
        code(b.code, s.file, b.line) +
        html(`${claims(run.claims)}</section>`)
      );
    },
  };
  const entry = (b) => {
    const kind = b.kind.toLowerCase();
    const n = (count[kind] = (count[kind] ?? 0) + 1);
    const declared = [...s.told.errata, ...s.told.emendations, ...s.told.doubtful, ...s.told.undecided].find(
      (e) => e.kind === kind && e.where === b.name,
    );
    const tried = s.check.apparatus.find((e) => e.kind === kind && e.where === b.name);
    if (!declared || !tried) fail(s.file, b.line, `the ${kind} "${b.name}" is not told by the program`);
    return (
      html(
        `<section class="entry ${kind}" id="${kind}-${n}">${reading(declared, tried)}<details>` +
          `<summary>the proof</summary>`,
      ) +
      code(b.code, s.file, b.line) +
      html('</details></section>')
    );
  };
  const body = s.blocks.map((b) => (weave[b.kind] ?? entry)(b)).join('\n');
  for (const name of headings.slice(0, 3))
    if (!found.includes(name)) fail(s.file, 1, `the heading "${name}" is missing`);
  for (const n of s.coded)
    if (!s.equations.has(n))
      fail(s.file, 1, `a comment in the code names the formula (${n}), which the prose does not give`);
  if (!p.figures.length && !p.noFigure) fail(s.file, 1, 'no figure, and no reason for none (::: no-figure)');
  if (p.figures.length && p.noFigure) fail(s.file, 1, 'a figure, and a reason for none');
  const uncovered = s.check.cases.filter(
    (c) => !s.blocks.some((b) => b.kind === 'check' && b.name === c.name),
  );
  if (uncovered.length)
    fail(s.file, uncovered[0].line, `the check "${uncovered[0].name}" does not stand on the page`);
  const entries = ['erratum', 'emendation', 'doubtful', 'undecided'].filter((kind) => count[kind]);
  const account = s.blocks[0].text
    .replace(/^\s*## .*$/m, '')
    .trim()
    .split(/\n\s*\n/)[0];
  Object.assign(s, {
    figures: p.figures,
    noFigure: p.noFigure,
    entries,
    checks: count.check,
    holds: s.check.passed,
    line: p.inline(/^[^]*?[.!?](?=\s|$)/.exec(account.replace(/\s+/g, ' '))?.[0] ?? account),
  });
  const claimed = s.check.cases.reduce((n, c) => n + c.claims.length, 0);
  const chapter = book.chapters.find((c) => c.id === s.chapter);
  const head =
    `<header class="opening"><p class="running"><a href="${s.chapter}.html">${escape(chapter.title)}</a> ` +
    `<span class="section-number">§ ${Number(s.number)}</span></p>\n` +
    `<h1>${escape(s.told.title)}</h1></header>\n<aside class="margin summary"><p>${verdict(s.holds)} ` +
    `<a href="#checks">${count.check} ${count.check === 1 ? 'check' : 'checks'}, ${claimed} claims</a></p>` +
    entries
      .map(
        (kind) =>
          `<p><span class="siglum" aria-hidden="true">${sigla[kind]}</span> <a href="#${kind}-1">` +
          `${count[kind] === 1 ? kind : `${count[kind]} ${plurals[kind] ?? kind}`}</a></p>`,
      )
      .join('') +
    '</aside>';
  write(`html/programs/${s.name}.cpp`, read(path.join(source, s.file)));
  const plain =
    html(
      `<details class="plain"><summary>The whole program</summary>\n<p class="take"><a href="programs/` +
        `${s.name}.cpp" download>${s.name}.cpp</a></p>`,
    ) + `\\include ${s.chapter}/s${s.number}.cpp\n${html('</details>')}`;
  write(`dox/${s.name}.dox`, page(s.name, s.told.title, `${html(head)}\n${body}\n${plain}`));
  return {
    name: s.name,
    title: s.told.title,
    chapter: s.chapter,
    number: Number(s.number),
    outline: [
      ...found.slice(0, 2),
      'What it says',
      ...(s.told.races.length ? ['Speed against error'] : []),
      ...found.slice(2),
    ],
  };
}

function told(s) {
  return (
    `<h2 id="what-it-says">What it says</h2>\n` +
    `<pre class="told" tabindex="0" role="group" aria-label="Output of ${s.name}"><code>` +
    `<span class="prompt">$ ${s.name}</span>\n` +
    `${escape(s.text.trimEnd())}</code></pre>\n` +
    `${s.told.races.length ? `<h2 id="speed-against-error">Speed against error</h2>\n${races(s, book)}` : ''}`
  );
}

// --------------------------------------------------------------------------------------------- all the pages

/** A page of prose: `# Title`, then Markdown. */
function proseFile(file, name, head, more) {
  const text = read(path.join(source, file));
  const [, title] = /^# (.+)\n/.exec(text) ?? fail(file, 1, 'must open with "# " and a title');
  const p = new Page(book, file);
  p.name = name;
  const body = p.html(text.slice(text.indexOf('\n')), 1);
  write(
    `dox/${name}.dox`,
    page(
      name,
      title,
      html(`<header class="opening">${head}<h1>${p.inline(title)}</h1></header>\n${body}${more}`),
    ),
  );
  return { name, title, outline: [...text.matchAll(/^## (.+)$/gm)].map((m) => m[1]) };
}

book.collected = (what) => {
  const [name, rest] = what.split(/ (.*)/);
  if (!lists[name]) throw new Error(`{{collected ${what}}} is not known (${Object.keys(lists).join(', ')})`);
  return lists[name](book, rest);
};
book.speed = (name) => value(book, name);

function everything() {
  const pages = new Map([...book.sections.values()].map((s) => [s.name, sectionPage(s)]));
  for (const script of fs.readdirSync(path.join(source, 'figures')).filter((f) => f.endsWith('.gp'))) {
    const name = script.slice(0, -3);
    if (!['style', 'race', 'errors'].includes(name) && !book.drawn.has(name))
      fail(`figures/${script}`, 1, 'an orphan: no section shows this figure');
  }
  const matter = (name) => proseFile(`book/matter/${name}.md`, name, '', '');
  const order = edition.before.map(matter);
  for (const c of edition.chapters) {
    const head =
      `<p class="running"><span class="paper" lang="la">${c.paper}</span>` +
      `${c.where ? `, ${c.where}` : ''}</p>`;
    order.push({
      ...proseFile(`chapters/${c.id}/chapter.md`, c.id, head, lists.map(book, c)),
      title: c.title,
      chapter: c.id,
    });
    order.push(
      ...[...book.sections.values()].filter((s) => s.chapter === c.id).map((s) => pages.get(s.name)),
    );
  }
  order.push(...edition.after.map(matter));
  const claim = (s, c, k) => ({
    section: s.id,
    statement: c.name,
    claim: k.expression,
    value: k.got,
    expected: k.expected,
    tolerance: k.tolerance,
    because: k.because,
    check: `${s.file}:${c.line}`,
    verdict: k.passed ? 'holds' : 'fails',
  });
  const ledger = [...book.sections.values()].flatMap((s) =>
    s.check.cases.flatMap((c) => c.claims.map((k) => claim(s, c, k))),
  );
  write('html/claims.json', `${JSON.stringify(ledger, null, 1)}\n`);
  write('pages.json', `${JSON.stringify(order, null, 1)}\n`);
  book.formulas.save();
  for (const folder of ['dox', 'html/figures', 'html/thumbnails', 'html/data', 'html/programs'])
    // nothing stays of what is gone
    for (const f of fs.existsSync(path.join(build, folder)) ? fs.readdirSync(path.join(build, folder)) : [])
      if (!kept.has(path.join(build, folder, f))) fs.rmSync(path.join(build, folder, f));
  return order.length;
}

console.log(`woven: ${everything()} pages`);
