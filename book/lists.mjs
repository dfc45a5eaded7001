// What the weaver collects from all sections: `{{collected NAME}}` in a page of book/matter, and each
// chapter's map.
import fs from 'node:fs';
import path from 'node:path';
import { reading, sigla } from './cards.mjs';
import { table, tableEnd, verdict } from './claims.mjs';
import { escape, heading, said, slug } from './prose.mjs';
import { asText, asTime, format } from './numbers.mjs';
import * as speed from './speed.mjs';
import * as systems from './systems.mjs';

const twoDigits = (n) => String(n).padStart(2, '0');
const sectionsOf = (book, chapter) => [...book.sections.values()].filter((s) => s.chapter === chapter.id);

/**
 * A chapter's sections, all of them: what each does, its figure in small, its verdict; or that it is not yet
 * there.
 */
function map(book, chapter) {
  const entry = (n) => {
    const s = book.sections.get(`${chapter.id}.${twoDigits(n)}`);
    if (!s)
      return (
        `<li id="s${twoDigits(n)}" class="not-yet"><span class="n">§ ${n}</span> <span>not yet</span>` +
        `</li>`
      );
    const thumbnail = s.figures.length
      ? `<img src="thumbnails/${s.figures[0]}.svg" alt="" width="128" height="80">`
      : '';
    const marks = Object.keys(sigla)
      .filter((kind) => s.entries.some((e) => e.kind === kind))
      .map((kind) => `\u00a0<abbr class="siglum" title="${kind}">${sigla[kind]}</abbr>`) // never alone on a line
      .join('');
    return (
      `<li id="s${twoDigits(n)}"><span class="n">§ ${n}</span><div><a href="${s.name}.html">` +
      `${said(s.told.title)}</a>${marks}` +
      `<p>${s.line}</p><p class="state">${verdict(s.holds)}</p></div>${thumbnail}</li>`
    );
  };
  const numbers = Array.from({ length: chapter.sections }, (_, i) => i + 1);
  const needs = book.read(`chapters/${chapter.id}/map.md`)
    ? `<p><a href="${chapter.id}-map.html">What needs what</a>: a drawn map, a route of a few sections, and the ` +
      `argument in today’s notation.</p>\n`
    : '';
  return `${heading('The sections', 'sections')}${needs}<ol class="map">\n${numbers.map(entry).join('\n')}\n</ol>\n`;
}

/** The four chapters, for the front page. */
function chapters(book) {
  const there = (n, c) => (n === c.sections ? `all ${n} sections` : `${n} of ${c.sections} sections`);
  return `<ol class="chapters">\n${book.chapters
    .map(
      (c) =>
        `<li><a href="${c.id}.html">${escape(c.title)}</a> <span class="paper" lang="la">${escape(c.paper)}` +
        `</span>` +
        `<span class="state">${c.where ? `${escape(c.where)} · ` : ''}${there(sectionsOf(book, c).length, c)}` +
        `</span></li>`,
    )
    .join('\n')}\n</ol>\n`;
}

/** All errata, emendations, doubtful and undecided readings, by kind and chapter. */
function apparatus(book) {
  const kinds = { erratum: 'Errata', emendation: 'Emendations', doubtful: 'Doubtful', undecided: 'Undecided' };
  return Object.entries(kinds)
    .map(([kind, title]) => {
      const found = [...book.sections.values()].flatMap((s) =>
        s.entries.filter((e) => e.kind === kind && e.declared && e.tried).map((e) => [s, e]),
      );
      const items = found.map(([s, e]) => {
        const home =
          ` <a href="${s.name}.html#${e.to}">` +
          `${escape(book.chapters.find((c) => c.id === s.chapter).short)}</a>`;
        return `<li>${reading(e.declared, e.tried, book.formulas, { home })}</li>`;
      });
      return (
        heading(`${title}${items.length ? ` <span class="count">${items.length}</span>` : ''}`, slug(title)) +
        `${items.length ? `<ul class="entries">\n${items.join('\n')}\n</ul>` : '<p>None yet.</p>'}\n`
      );
    })
    .join('');
}

/**
 * Every section there is in the four papers: program, checks, figure or the reason for none, page; or "not
 * yet".
 */
function sections(book) {
  return book.chapters
    .map((c) => {
      const rows = Array.from({ length: c.sections }, (_, i) => {
        const s = book.sections.get(`${c.id}.${twoDigits(i + 1)}`);
        if (!s)
          return `<tr><th scope="row">§ ${i + 1}</th><td class="word not-yet" colspan="4">not yet</td></tr>`;
        const figures =
          s.figures.map((f, k) => `<a href="${s.name}.html#fig-${k + 1}">${f}</a>`).join(', ') ||
          `none: ${s.noFigure}`;
        return (
          `<tr><th scope="row"><a href="${s.name}.html">§\u00a0${i + 1}</a></th><td class="word"><a href="` +
          `${s.name}.html">${said(s.told.title)}</a></td>` +
          `<td class="word"><a href="programs/${s.name}.cpp"><code class="whole">${s.name}</code></a></td>` +
          `<td>${s.checks} ${verdict(s.holds)}</td><td class="word">${figures}</td></tr>`
        );
      });
      return (
        heading(escape(c.title), c.id) +
        `${table(`Sections of ${c.short}`, ['', 'page', 'program', 'checks', 'figures'], ' sections')}${rows.join('\n')}` +
        `${tableEnd}`
      );
    })
    .join('');
}

/** What the programs and the book were made with. */
function colophon(book) {
  const made = JSON.parse(fs.readFileSync(path.join(book.build, 'made-with.json'), 'utf8'));
  const lock = JSON.parse(fs.readFileSync(path.join(book.source, 'book/package-lock.json'), 'utf8')).packages;
  for (const name of Object.keys(lock[''].dependencies)) made[name] = lock[`node_modules/${name}`].version;
  const rows = Object.entries({ 'this edition': book.version, ...made }).map(
    ([name, version]) =>
      `<tr><th scope="row">${escape(name)}</th>` +
      `<td class="word">${name === 'flags' ? `<code>${escape(version)}</code>` : escape(version)}</td></tr>`,
  );
  return `${table('Made with', ['what', 'which'])}${rows.join('\n')}${tableEnd}`;
}

/** The glossary's entries: `term`, then lines that begin with `: `; from book/glossary.md and the chapters' own. */
function terms(book) {
  const found = new Map();
  const files = ['book/glossary.md', ...book.chapters.map((c) => `chapters/${c.id}/glossary.md`)];
  for (const file of files) {
    let line = 1;
    for (const entry of (book.read(file) ?? '').split(/\n\s*\n/)) {
      const [, term, text] = /^\s*(\S.*)\n: *([^]+)$/.exec(entry) ?? [];
      if (term && !found.has(slug(term)))
        found.set(slug(term), { term, text, file, line: line + 1 });
      else if (entry.trim())
        book.fault(file, line, term ? `a second entry for ${term}` : 'an entry is a line with the term, then ": " and what it means');
      line += entry.split('\n').length + 1;
    }
  }
  return found;
}

/** `{{collected glossary}}`: all terms, in the order of the alphabet. */
function glossary(book, _, page) {
  const items = [...book.terms]
    .sort(([a], [b]) => (a < b ? -1 : 1))
    .map(([id, { term, text, file, line }]) => {
      const p = book.page(file); // of no chapter, so that a section is named with its own
      const meaning = p.html(text.replace(/^[:] ?|\n: ?/g, '\n').trim(), line);
      for (const [name, number] of p.numbers) page.numbers.set(name, number);
      return `<dt id="term-${id}">${said(term)}</dt>\n<dd>${meaning}</dd>`;
    });
  return `<dl class="glossary">\n${items.join('\n')}\n</dl>\n`;
}

/** `{{collected notation}}`: each chapter's own table; every row names where its letter is first used. */
function notation(book, _, page) {
  page.headings = [];
  return book.chapters
    .map((c) => {
      const file = `chapters/${c.id}/notation.md`;
      const text = book.read(file);
      if (!text) return '';
      const rows = text.split('\n');
      const placed = /\| *first *\|/.test(rows[0]);
      rows.forEach((row, i) => {
        if (!placed) return;
        const head = /^\|[\s:|-]+$/.test(rows[i + 1] ?? '');
        if (/^\|/.test(row) && !head && !/^\|[\s:|-]+$/.test(row) && !/\{\{(sec|eq) /.test(row))
          book.fault(file, i + 1, 'the row does not say where its letter is first used ({{sec ...}} or {{eq ...}})');
      });
      page.headings.push([c.id, c.short]);
      return heading(escape(c.short), c.id) + book.page(file, c.id).html(text, 1);
    })
    .join('');
}

/** `{{collected citation}}`: how this edition is cited, as it is. */
function citation(book) {
  const text = `${book.title}: an executable, annotated edition of four papers by Leonhard Euler. Version ${book.version}.`;
  const bibtex = `@misc{euler-on-oscillation,\n  title   = {${book.title}},\n  note    = {An executable, annotated edition of four papers\n             by Leonhard Euler},\n  version = {${book.version}}\n}`;
  return (
    `<p class="citation">${escape(text)}</p>\n` +
    `<pre class="code" tabindex="0" role="group" aria-label="BibTeX"><code>${escape(bibtex)}</code></pre>\n`
  );
}

/** A recorded number in two digits. */
const inTwo = (x) => asText(format({ value: x }, '2'));

/** `{{collected peers}}`: K and Φ(t) beside JavaScript's packages, as book/live/peers recorded them. */
function peers(book) {
  const { engine, races } = JSON.parse(book.read('book/live/peers.json'));
  const row = (unit) => (w) =>
    `<tr><th scope="row">${escape(w.name)}</th><td>${asTime(w.seconds)}</td><td>${inTwo(w.ratio)}</td>` +
    `<td>${w.error === undefined ? '' : `${inTwo(w.error)} ${unit}`}` +
    `${w.of_k2 ? ` (${inTwo(w.of_k2)} of the rounded cc)` : ''}</td></tr>`;
  return races
    .map(
      ({ quantity, unit, ways }) =>
        `<p>${escape(quantity)}; ${escape(engine)}</p>\n` +
        `${table(quantity, ['way', 'time a number', 'ratio', 'worst error'])}${ways.map(row(unit)).join('\n')}${tableEnd}`,
    )
    .join('');
}

/** `{{collected live}}`: how the pages run themselves, where they do. */
function live(book) {
  const file = 'book/live/running.md';
  return book.live
    ? book.page(file).html(book.read(file), 1)
    : '<p>This copy of the book was made without the pages that run themselves; the <a href="colophon.html">colophon</a> says why.</p>\n';
}

const search = () => `<form class="search" role="search" action="search.html">
<label for="q">Search the book</label> <input id="q" name="q" type="search" autocomplete="off">
<button>Search</button>
</form>
<noscript><p>The search needs a script; what the pages say can be read without one.</p></noscript>
<p id="found" role="status"></p>
<ol id="results"></ol>
<script src="search.js" defer></script>
`;

export const lists = {
  map,
  chapters,
  apparatus,
  sections,
  races: speed.ofSections,
  scene: speed.scene,
  errors: speed.errors,
  scenes: speed.scenes,
  provenance: speed.provenance,
  colophon,
  live,
  peers,
  terms,
  glossary,
  notation,
  citation,
  search,
  'other-systems': (book, of) => (of ? systems.errors(book, of) : systems.conventions(book)),
  engines: systems.engines,
};
