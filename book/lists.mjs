// What the weaver collects from all sections: `{{collected NAME}}` in a page of book/matter, and each
// chapter's map.
import fs from 'node:fs';
import path from 'node:path';
import { reading, sigla, table, tableEnd, verdict } from './cards.mjs';
import { escape } from './prose.mjs';
import * as speed from './speed.mjs';

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
      ? `<img src="thumbnails/${s.figures[0]}.svg" alt="" width="128" height="80" loading="lazy">`
      : '';
    const marks = s.entries
      .map((kind) => `<abbr class="siglum" title="${kind}">${sigla[kind]}</abbr>`)
      .join(' ');
    return (
      `<li id="s${twoDigits(n)}"><span class="n">§ ${n}</span><div><a href="${s.name}.html">` +
      `${escape(s.told.title)}</a> ${marks}` +
      `<p>${s.line}</p><p class="state">${verdict(s.holds)}</p></div>${thumbnail}</li>`
    );
  };
  const numbers = Array.from({ length: chapter.sections }, (_, i) => i + 1);
  return `<h2 id="sections">The sections</h2>\n<ol class="map">\n${numbers.map(entry).join('\n')}\n</ol>\n`;
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
  const kinds = [
    ['erratum', 'errata', 'Errata'],
    ['emendation', 'emendations', 'Emendations'],
    ['doubtful', 'doubtful', 'Doubtful'],
    ['undecided', 'undecided', 'Undecided'],
  ];
  return kinds
    .map(([kind, list, heading]) => {
      const found = [...book.sections.values()].flatMap((s) => s.told[list].map((e, i) => [s, e, i + 1]));
      const items = found.map(([s, e, i]) => {
        const home =
          ` <a href="${s.name}.html#${kind}-${i}">` +
          `${escape(book.chapters.find((c) => c.id === s.chapter).short)}</a>`;
        return `<li>${reading(
          e,
          s.check.apparatus.find((a) => a.kind === kind && a.where === e.where),
          home,
        )}</li>`;
      });
      return (
        `<h2 id="${list}">${heading}</h2>\n` +
        `${items.length ? `<ul class="entries">\n${items.join('\n')}\n</ul>` : '<p>None yet.</p>'}\n`
      );
    })
    .join('');
}

/**
 * Every section there is in the four papers: program, checks, figure or the reason for none, page; or "not
 * yet".
 */
function concordance(book) {
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
          `<tr><th scope="row"><a href="${s.name}.html">§ ${i + 1}</a></th><td class="word"><a href="` +
          `${s.name}.html">${escape(s.told.title)}</a></td>` +
          `<td class="word"><a href="programs/${s.name}.cpp"><code class="whole">${s.name}</code></a></td>` +
          `<td>${s.checks} ${verdict(s.holds)}</td><td class="word">${figures}</td></tr>`
        );
      });
      return (
        `<h2 id="${c.id}">${escape(c.title)}</h2>\n` +
        `${table(`Sections of ${c.short}`, ['', 'page', 'program', 'checks', 'figures'])}${rows.join('\n')}` +
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
  const rows = Object.entries(made).map(
    ([name, version]) =>
      `<tr><th scope="row">${escape(name)}</th><td class="word">${escape(version)}</td></tr>`,
  );
  return `${table('Made with', ['what', 'which'])}${rows.join('\n')}${tableEnd}`;
}

const search = () => `<form class="search" role="search" action="search.html">
<label for="q">Search the book</label> <input id="q" name="q" type="search" autocomplete="off">
<button>Search</button>
</form>
<noscript><p>The search needs a script; all else in this book does without.</p></noscript>
<p id="found" role="status"></p>
<ol id="results"></ol>
<script src="search.js" defer></script>
`;

export const lists = {
  map,
  chapters,
  apparatus,
  concordance,
  races: speed.ofSections,
  scene: speed.scene,
  errors: speed.errors,
  scenes: speed.scenes,
  provenance: speed.provenance,
  colophon,
  search,
};
