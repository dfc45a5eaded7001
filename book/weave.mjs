// Weaves the book: from each section's file, and from what its program told, one page for Doxygen; then the
// chapters' openings and the pages of book/matter. All faults of a weave are told at once, each with its file and line.
// Usage: node weave.mjs SOURCE BUILD [--only CHAPTER-NN] (the repository, and build/book; with --only that one page and
// its faults, whatever else is built or not).
import fs from 'node:fs';
import path from 'node:path';
import { asProduct, escape, Formulas, heading, Page, productSaid, slug } from './prose.mjs';
import { explained, html, page } from './doxygen.mjs';
import { palette, inline, standalone, thumbnail } from './figure.mjs';
import { lists } from './lists.mjs';
import { controls, still } from './live/scene.mjs';
import { divisions } from './map.mjs';
import { packages } from './packages.mjs';
import { blocks, named, tagged } from './section.mjs';
import { lookedAt, sectionPage } from './sectionpage.mjs';
import { libraries } from './scenes.mjs';
import { value } from './speed.mjs';

const [source, build, ...options] = process.argv.slice(2);
if (!build || (options.length && (options[0] !== '--only' || options.length !== 2))) {
  console.error('usage: node weave.mjs SOURCE BUILD [--only CHAPTER-NN]');
  process.exit(2);
}
const only = options[1];
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

/** The faults of this weave, in the order of files and lines. */
const faults = new Map();
const ownFile = only && `chapters/${only.replace('-', '/s')}.cpp`;
function fault(file, line, message) {
  if (only && file !== ownFile && !file.startsWith(`figures/${only}`) && !file.startsWith(`told/${only}`)) return;
  const words = message.replace(/\s+/g, ' ');
  faults.set(`${file}:${line}: ${words}`, [file, line]);
}

// ---------------------------------------------------------------------------------------------- the sections

const edition = json(path.join(source, 'book/edition.json'));
const Ajv = packages('ajv');
const valid = Object.fromEntries(
  ['section', 'check', 'speeds', 'library'].map((name) => [
    name,
    new Ajv({ strict: true, allErrors: false }).compile(json(path.join(source, `book/schema/${name}.json`))),
  ]),
);

function checked(schema, file) {
  const data = json(file);
  if (!valid[schema](data)) {
    const [{ instancePath, message }] = valid[schema].errors;
    const place = path.relative(file.startsWith(build) ? build : source, file);
    throw Object.assign(new Error(`${instancePath || '/'} ${message} (book/schema/${schema}.json)`), { place });
  }
  return data;
}

/** The piece of a file of src/ between two lines `// [name]`. */
function snippet(file, name) {
  const whole = path.join(source, 'src', file);
  const parts = fs.existsSync(whole) ? read(whole).split(`// [${name}]`) : [];
  if (parts.length !== 3) throw new Error(`src/${file} has not two lines // [${name}]`);
  return parts[1];
}

const limit = 110;
function tooLong(file, text) {
  text.split('\n').forEach((line, i) => {
    if ([...line].length > limit) fault(file, i + 1, `a line of ${[...line].length} characters; ${limit} is the limit`);
  });
}

/** Holds every require() of a section to what the checks have met: one limit each, and none that no run comes to. */
function limitsMet(text, file, met) {
  for (const m of text.matchAll(/\brequire\(([^;]*?), *(?:[\w.]+ [^,]*\? )?"[^;]*;/g)) {
    const line = text.slice(0, m.index).split('\n').length;
    const last = line + m[0].split('\n').length - 1;
    if (m[1].includes('&&')) fault(file, line, 'a require() has one limit; two are two');
    if (!met.some((at) => at.line >= line && at.line <= last)) fault(file, line, 'no check comes to this require()');
  }
}

/** The formulae that prose gives; a number that is given twice is a fault. */
function equationsOf(prose, file) {
  const equations = new Set();
  for (const b of prose)
    for (const { number, line } of tagged(b.text, b.line)) {
      if (equations.has(number)) fault(file, line, `a second formula (${number})`);
      if (!/^(\d+|[A-Z])$/.test(number))
        fault(file, line, `\\tag{${number}}: Euler's formulae have numbers, the edition's own a letter, A to Z`);
      equations.add(number);
    }
  return equations;
}

const kinds = { errata: 'erratum', emendations: 'emendation', doubtful: 'doubtful', undecided: 'undecided' };

/** What is known of a section before its page is woven; nothing where its file or its program has no sense. */
function section(name) {
  const [chapter, number] = name.split('-');
  const file = `chapters/${chapter}/s${number}.cpp`;
  if (!fs.existsSync(path.join(source, file)))
    return fault(file, 1, `the program ${name} has no section file, so no page`);
  const from = (ending) => path.join(build, `told/${name}.${ending}`);
  if (!fs.existsSync(from('json'))) return fault(file, 1, `the program ${name} has told nothing; is it built?`);
  const text = read(path.join(source, file));
  tooLong(file, text);
  try {
    const all = blocks(text);
    const prose = all.filter((b) => b.kind === 'prose');
    const code = all.map((b) => b.code ?? '');
    for (const m of prose.flatMap((b) => [...b.text.matchAll(/^::: code (\S+) (\w+)(.*)$/gm)]))
      try {
        code.push(`//${m[3]}\n${snippet(m[1], m[2])}`);
      } catch {
        // told where the page is woven
      }
    const speeds = path.join(source, `book/speeds/${name}.json`);
    const told = checked('section', from('json'));
    const check = checked('check', from('check.json'));
    limitsMet(text, file, check.limits);
    const declared = Object.keys(kinds).flatMap((list) => told[list]);
    const counted = {};
    const entries = all
      .filter((b) => Object.values(kinds).includes(b.kind.toLowerCase()))
      .map((block) => {
        const kind = block.kind.toLowerCase();
        counted[kind] = (counted[kind] ?? 0) + 1;
        const same = (e) => e.kind === kind && e.where === block.name;
        return {
          name: block.object,
          kind,
          where: block.name,
          to: `${kind}-${counted[kind]}`,
          block,
          declared: declared.find(same),
          tried: check.apparatus.find(same),
        };
      });
    return {
      id: `${chapter}.${number}`,
      name,
      chapter,
      number,
      file,
      blocks: all,
      text: read(from('txt')),
      told,
      check,
      speeds: fs.existsSync(speeds) ? checked('speeds', speeds) : null,
      entries,
      placed: new Set(),
      equations: equationsOf(prose, file),
      coded: new Set(code.flatMap(named)),
    };
  } catch (error) {
    const { place = file, line = 1, message } = error;
    fault(place, line, message);
    return undefined;
  }
}

const programs = read(path.join(build, 'programs.txt')).split('\n').filter(Boolean).sort();
if (only && !programs.includes(only)) programs.push(only);
for (const { id } of edition.chapters)
  for (const file of fs.readdirSync(path.join(source, 'chapters', id)).filter((f) => /^s\d\d\.cpp$/.test(f)))
    if (!programs.includes(`${id}-${file.slice(1, 3)}`))
      fault(`chapters/${id}/${file}`, 1, 'is no program of this build; run cmake again');

const book = {
  source,
  build,
  live: !/^none/.test(json(path.join(build, 'made-with.json'))['live pages'] || 'none'),
  only,
  ...edition,
  version: /project\([^)]*VERSION ([\d.]+)/.exec(read(path.join(source, 'CMakeLists.txt')))?.[1] ?? '',
  formulas: new Formulas(path.join(build, only ? `formulas-${only}.json` : 'formulas.json')),
  sections: new Map(
    programs
      .map(section)
      .filter(Boolean)
      .map((s) => [s.id, s]),
  ),
  library: Object.fromEntries(
    libraries.map((name) => [name, checked('library', path.join(source, `book/speeds/${name}.json`))]),
  ),
  colours: palette(read(path.join(source, 'figures/style.gp'))),
  snippet,
  divisions,
  drawn: new Set(),
  write,
  fault,
  read: (file) => (fs.existsSync(path.join(source, file)) ? read(path.join(source, file)) : null),
};
book.terms = lists.terms(book);

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
    if (!fs.existsSync(told)) {
      fault(script, 1, `draws from ${tsv}, which no program writes`);
      continue;
    }
    write(`html/data/${tsv}`, read(told));
  }
  const links = [
    [`figures/${name}.svg`, 'drawing'],
    [`figures/${file}`, 'script'],
    ...data.map((f) => [`data/${f}`, f]),
  ];
  return (
    `${opening}\n<div class="drawing" tabindex="0" role="group" aria-label="Drawing">\n` +
    `${inline(svg, name, alt, book.colours)}</div>\n<figcaption>${caption}` +
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
  if (!page.section) return shown(name, script, data, alt, `<figure data-figure="${name}">`, `${caption} `);
  book.drawn.add(name);
  write(
    `html/thumbnails/${name}.svg`,
    thumbnail(read(path.join(build, `drawn/${name}.svg`)), name, book.colours),
  );
  const curves = data.map((f) => f.split('.')[1]).map((curve) => lookedAt(page.section, curve));
  const proved = [...new Set(curves.filter(Boolean))].join('; ');
  return numbered(page, name, script, data, alt, `${caption}${proved && ` <span class="proved">Its data: ${proved}.</span>`}`);
};

/**
 * A scene that the section declares: its first frame, and what starts it. Where the page does not run itself, its frames lie
 * beside it as a script, which is fetched when the scene is first touched.
 */
book.scene = (name, alt, caption, page) => {
  const declared = page.section?.told.scenes.find((s) => s.name === name);
  if (!declared) throw new Error(`no scene is told by the name of ::: scene ${name}`);
  page.drawings = (page.drawings ?? 0) + 1;
  const id = `fig-${page.drawings}`;
  const frames = read(path.join(build, `told/${page.section.name}.${name}.tsv`));
  const script = `scenes/${page.section.name}.${name}.js`;
  if (!book.live) {
    const packed = [name, [declared, frames]].map((x) => JSON.stringify(x));
    write(`html/${script}`, `(self.SCENES ??= {})[${packed[0]}] = ${packed[1]};\n`);
  }
  return (
    `<figure id="${id}" class="scene" data-scene="${name}"${book.live ? '' : ` data-frames="${script}"`}>\n` +
    `<div class="drawing">\n${still(declared, frames, `scene-${name}`, alt)}</div>\n${controls}` +
    `<figcaption><a class="label" href="#${id}">Fig. ${page.drawings}</a> ${caption}</figcaption>\n</figure>\n`
  );
};

/** A figure with its number on a section's page, where it can be linked to. */
function numbered(page, name, script, data, alt, caption) {
  page.drawings = (page.drawings ?? 0) + 1;
  const opening = `<figure id="fig-${page.drawings}" data-figure="${name}">`;
  const label = `<a class="label" href="#fig-${page.drawings}">Fig. ${page.drawings}</a> `;
  return shown(name, script, data, alt, opening, label + caption);
}

/** A plot that race.mjs has drawn by a script that many share, its data under the plot's own name. */
book.plot = (name, script, alt, caption, page) =>
  page?.section
    ? numbered(page, name, script, [`${name}.tsv`], alt, caption)
    : shown(name, script, [`${name}.tsv`], alt, `<figure data-figure="${name}">`, `${caption} `);

// --------------------------------------------------------------------------------------------- all the pages

/** A page of prose: `# Title`, then Markdown. */
function proseFile(file, name, head, more, chapter) {
  const text = read(path.join(source, file));
  const title = /^# (.+)\n/.exec(text)?.[1];
  if (!title) fault(file, 1, 'must open with "# " and a title');
  const p = new Page(book, file, null, chapter);
  p.name = name;
  const body = p.html(text.slice(text.indexOf('\n')), 1);
  const opening = `<header class="opening">${head}<h1>${p.inline(title ?? name)}</h1></header>\n`;
  write(`dox/${name}.dox`, page(name, title ?? name, html(`${opening}${body}${more}${explained(p)}`)));
  const headings = [...text.matchAll(/^## (.+)$/gm)].map((m) => [slug(m[1]), m[1]]);
  return { name, title, outline: [...headings, ...(p.headings ?? [])] };
}

book.collected = (what, page) => {
  const [name, rest] = what.split(/ (.*)/);
  if (!lists[name]) throw new Error(`{{collected ${what}}} is not known (${Object.keys(lists).join(', ')})`);
  return lists[name](book, rest, page);
};
book.speed = (name) => value(book, name);
book.page = (file, chapter) => new Page(book, file, null, chapter);

/** What no section's page shows of figures/, and what Doxygen would lose of the library: tables and templates. */
function orphans() {
  for (const script of fs.readdirSync(path.join(source, 'figures')).filter((f) => f.endsWith('.gp'))) {
    const name = script.slice(0, -3);
    const of = /^([a-z]+)-(\d\d)/.exec(name);
    const known = !of || !programs.includes(of[0]) || book.sections.has(`${of[1]}.${of[2]}`);
    if (!['style', 'race', 'errors'].includes(name) && known && !book.drawn.has(name))
      fault(`figures/${script}`, 1, 'an orphan: no section shows this figure');
  }
  const src = path.join(source, 'src');
  const headers = fs.existsSync(src)
    ? fs.readdirSync(src, { recursive: true }).filter((f) => f.endsWith('.hpp'))
    : [];
  for (const header of headers)
    read(path.join(src, header))
      .split('\n')
      .forEach((line, i) => {
        const row = /^\s*(?:\/\/\/|\*)\s*(\|.*\|)\s*$/.exec(line)?.[1];
        if (row && /`[^`]*\|[^`]*`|\\f\$[^$]*\|[^$]*\\f\$/.test(row))
          fault(`src/${header}`, i + 1, 'a bar in code or in a formula: Doxygen loses the whole table');
        if (asProduct.test(line)) fault(`src/${header}`, i + 1, productSaid);
      });
  for (const header of headers) {
    // Comments and strings blanked, their lines kept.
    const code = read(path.join(src, header)).replace(/\/\/.*|\/\*[^]*?\*\/|"(?:\\.|[^"\\\n])*"/g, (s) => s.replace(/[^\n]/g, ' '));
    for (const { 0: head, index } of code.matchAll(/\btemplate\s*<[^;{}]*/g))
      if ((head.match(/(?<![=&|(]\s*|requires\s+)\brequires\b/g) ?? []).length > 1)
        fault(
          `src/${header}`,
          code.slice(0, index).split('\n').length,
          'two "requires" clauses: for Doxygen the function vanishes into the next one; join them by &&',
        );
  }
}

/** The ledger: every claim of every check, and which told numbers the check looks at. */
function ledger() {
  const claim = (s, c, looks, k) => ({
    section: s.id,
    statement: c.name,
    claim: k.expression,
    value: k.got,
    expected: k.expected,
    tolerance: k.tolerance,
    because: k.because,
    times: k.times,
    at: k.at,
    looks,
    check: `${s.file}:${c.line}`,
    verdict: k.passed ? 'holds' : 'fails',
  });
  return [...book.sections.values()].flatMap((s) =>
    s.check.cases.flatMap((c, i) => {
      const looks = Object.keys(s.check.covers).filter((key) => s.check.covers[key].includes(i + 1));
      return c.claims.map((k) => claim(s, c, looks, k));
    }),
  );
}

/** The order of the book: each page's name, title and outline. `weave` makes a page, or only names it. */
function everything() {
  const titled = (file) => /^# (.+)$/m.exec(read(path.join(source, file)))?.[1] ?? file;
  const prose = (file, name, head = '', more = () => '', chapter = undefined) =>
    only ? { name, title: titled(file), outline: [] } : proseFile(file, name, head, more(), chapter);
  const matter = (name) => prose(`book/matter/${name}.md`, name);
  const of = (c) => [...book.sections.values()].filter((s) => s.chapter === c.id);
  const pages = new Map();
  for (const s of book.sections.values())
    pages.set(
      s.name,
      !only || s.name === only
        ? sectionPage(s, book)
        : { name: s.name, title: s.told.title, chapter: s.chapter, number: Number(s.number), outline: [] },
    );
  const order = edition.before.map(matter);
  for (const c of edition.chapters) {
    const head =
      `<p class="running"><span class="paper" lang="la">${c.paper}</span>` +
      `${c.where ? `, ${c.where}` : ''}</p>`;
    const opening = prose(`chapters/${c.id}/chapter.md`, c.id, head, () => lists.map(book, c), c.id);
    order.push({ ...opening, title: c.title, chapter: c.id });
    if (book.read(`chapters/${c.id}/map.md`)) {
      const running = `<p class="running"><a href="${c.id}.html">${escape(c.title)}</a></p>`;
      const map = prose(`chapters/${c.id}/map.md`, `${c.id}-map`, running, () => '', c.id);
      order.push({ ...map, chapter: c.id });
    }
    order.push(...of(c).map((s) => pages.get(s.name)));
  }
  order.push(...edition.after.map(matter));
  write('pages.json', `${JSON.stringify(order, null, 1)}\n`);
  if (only) return 1;
  orphans();
  write('html/claims.json', `${JSON.stringify(ledger(), null, 1)}\n`);
  for (const folder of ['dox', 'html/figures', 'html/thumbnails', 'html/data', 'html/programs', 'html/scenes'])
    // nothing stays of what is gone
    for (const f of fs.existsSync(path.join(build, folder)) ? fs.readdirSync(path.join(build, folder)) : [])
      if (!kept.has(path.join(build, folder, f))) fs.rmSync(path.join(build, folder, f));
  return order.length;
}

const woven = everything();
book.formulas.save();
if (faults.size) {
  const sorted = [...faults].sort(([, [f, l]], [, [g, m]]) => (f < g ? -1 : f > g ? 1 : l - m));
  console.error(sorted.map(([words]) => words).join('\n'));
  process.exitCode = 1;
} else console.log(`woven: ${woven} ${woven === 1 ? 'page' : 'pages'}`);
