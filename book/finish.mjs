// Finishes what Doxygen made: puts every page into book/page.html with contents, previous and next; sets the
// formulae of the library's pages; turns code into <pre>; links comments to formulae and prose to the
// library; checks every link; writes the index for the search. Usage: node finish.mjs SOURCE BUILD [--only PAGE]: with
// --only that one page, from what Doxygen left in BUILD/doxygen-only.
import fs from 'node:fs';
import path from 'node:path';
import { balanced } from './balanced.mjs';
import { palette, paletteCss } from './figure.mjs';
import { packages } from './packages.mjs';
import { Formulas, escape, said } from './prose.mjs';
import { readable, withoutFormulas } from './tex.mjs';

process.on('uncaughtException', (error) => {
  console.error(error.message);
  process.exitCode = 1;
});

const [source, build, , only] = process.argv.slice(2).map((p, i) => (i < 2 ? path.resolve(p) : p));
const read = (...file) => fs.readFileSync(path.join(...file), 'utf8');
const site = path.join(build, 'html');
const from = path.join(build, only ? 'doxygen-only' : 'doxygen');
const pages = JSON.parse(read(build, 'pages.json'));
pages.splice(
  pages.findIndex((p) => p.name === 'colophon'),
  0,
  { name: 'namespaces', title: 'The library' },
);
const chapters = JSON.parse(read(source, 'book/edition.json')).chapters;
const template = read(source, 'book/page.html');
const formulas = new Formulas(path.join(build, 'formulas-of-library.json'));

function write(name, text) {
  const file = path.join(site, name);
  if (fs.existsSync(file) && fs.readFileSync(file).equals(Buffer.from(text))) return;
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(file, text);
}

const unescape = (text) =>
  text
    .replace(/&lt;/g, '<')
    .replace(/&gt;/g, '>')
    .replace(/&quot;/g, '"')
    .replace(/&#39;/g, "'")
    .replace(/&#160;|&nbsp;/g, ' ')
    .replace(/&amp;/g, '&');
const words = (html) =>
  unescape(
    withoutFormulas(html, (tex) => ` ${escape(readable(unescape(tex)))} `)
      .replace(/<(script|style|svg)\b[^]*?<\/\1>/g, ' ')
      .replace(/<[^>]+>/g, (tag) => (/^<\/?(a|abbr|b|code|data|em|i|span|strong)\b/.test(tag) ? '' : ' ')),
  )
    .replace(/\s+/g, ' ')
    .replace(/ (?=[.,;:!?)])/g, '')
    .trim();

// ----------------------------------------------------------------------------------------------- the library

/** Where Doxygen put the members of the library: qualified name to address. */
const api = new Map();

/** The pages of the library, each with the headers that it tells of. */
const headers = new Map();
const tell = (page, header) => headers.set(page, new Set([...(headers.get(page) ?? []), header]));
const pageOf = (file) => `${file}${/\.html$/.test(file) ? '' : '.html'}`;
const compounds = [
  ...read(build, only ? 'book-only.tag' : 'book.tag').matchAll(
    /<compound kind="(file|namespace|class|struct|concept)"[^>]*>([^]*?)<\/compound>/g,
  ),
].map(([, kind, compound]) => ({
  kind,
  compound,
  name: unescape(/<name>([^<]*)<\/name>/.exec(compound)[1]),
  file: /<filename>([^<]*)<\/filename>/.exec(compound)[1],
}));
const named = new Map(compounds.filter((c) => c.kind !== 'file').map((c) => [c.name, pageOf(c.file)]));
for (const { kind, compound, name, file } of compounds) {
  if (kind !== 'file') continue;
  const header = `${/<path>[^<]*\/src\/([^<]*)<\/path>/.exec(compound)?.[1] ?? ''}${name}`;
  tell(pageOf(file), header);
  for (const [, of] of compound.matchAll(/<(?:class|namespace|concept)\b[^>]*>([^<]*)</g))
    if (named.has(unescape(of))) tell(named.get(unescape(of)), header);
}

for (const { kind, compound, name, file } of compounds) {
  if (kind === 'file') continue;
  api.set(name, pageOf(file));
  if (kind === 'concept') continue;
  for (const [, member] of compound.matchAll(/<member [^>]*>([^]*?)<\/member>/g)) {
    const [own, anchorFile, anchor] = ['name', 'anchorfile', 'anchor'].map(
      (t) => new RegExp(`<${t}>([^<]*)</${t}>`).exec(member)?.[1],
    );
    if (!api.has(`${name}::${unescape(own)}`))
      api.set(`${name}::${unescape(own)}`, `${anchorFile}#${anchor}`);
  }
}

// ------------------------------------------------------------------------------------ from Doxygen to a page

/** A listing: lines in a <pre>, comments `// (n)` linked to the formula that they name. */
function listing(html, seen) {
  const lines = [...html.matchAll(/<div class="line">([^]*?)<\/div>/g)].map((m) => m[1]);
  const linked = lines.map((line) =>
    line
      .replace(/<a [^>]*>(std::\w+)<\/a>/g, '$1')
      .replace(/<span class="comment">\/\/ \(\w+\)[^]*?<\/span>/, (comment) =>
        comment.replace(/\((\w+)\)/g, (all, n) => {
          if (!seen.equations.has(n)) return all;
          const id = seen.coded.has(n) ? '' : ` id="code-${n}"`;
          seen.coded.add(n);
          return `<a class="eqref"${id} href="#eq-${n}">(${n})</a>`;
        }),
      ),
  );
  const longest = Math.max(...lines.map((l) => words(l.replace(/ /g, '.')).length));
  return (
    `<pre class="code${longest > 68 ? ' wide' : ''}" tabindex="0" role="group" aria-label="Code">` +
    `<code>${linked.join('\n').trimEnd()}</code></pre>`
  );
}

function mathematics(html, file) {
  const set = (tex, display) => {
    try {
      return formulas.set(unescape(tex), display);
    } catch (error) {
      throw new Error(`${file}: ${error.message}`);
    }
  };
  return html
    .replace(/\\\[([^]*?)\\\]/g, (_, tex) => `<span class="equation">${set(tex, true)}</span>`)
    .replace(/\\\(([^]*?)\\\)/g, (_, tex) => set(tex, false));
}

/** The sections that include what a page of the library tells of, chapter by chapter. */
function usedBy(file) {
  const of = headers.get(file) ?? new Set();
  const lists = chapters
    .map((c) => [c, pages.filter((p) => p.chapter === c.id && p.uses?.some((header) => of.has(header)))])
    .filter(([, users]) => users.length)
    .map(([c, users]) => {
      const links = users.map(
        (p) => `<a href="${p.name}.html" title="${said(p.title)}">§\u00a0${p.number}</a>`,
      );
      return `${escape(c.short)} ${links.join(', ')}`;
    });
  return lists.length ? `<p class="used">Used in ${lists.join('; ')}.</p>\n` : '';
}

/** Doxygen's own pages: headings in order, tables of layout named as such, no traces of its scripts. */
function repaired(html, title, file) {
  return (
    `<header class="opening">` +
    `${title === 'The library' ? '' : '<p class="running"><a href="namespaces.html">The library</a></p>'}` +
    `<h1>${title}</h1></header>\n${usedBy(file)}` +
    html
      .replace(/<div class="summary">[^]*?<\/div>/g, '')
      .replace(
        /<h2 class="memtitle">([^]*?)<\/h2>/g,
        (_, t) =>
          `<h3 class="memtitle">` +
          `${t.replace(/<span class="(?:permalink|overload)">[^]*?<\/span>/g, '')}</h3>`,
      )
      .replace(
        /<table class="(memberdecls|memname|mlabels|directory|params|exception|retval|fieldtable)"/g,
        (all, c) => (/param|exc|ret|field/.test(c) ? all : `<table role="presentation" class="${c}"`),
      )
      .replace(
        /<tr class="heading"><td colspan="2"><h2 class="groupheader">([^]*?)<\/h2><\/td><\/tr>/g,
        (_, t) => `<tr class="heading"><td colspan="2"><h2>${t}</h2></td></tr>`,
      )
      .replace(/<tr class="(?:separator|inherit_header)[^]*?<\/tr>/g, '')
      .replace(
        /<a (?:name|id)="details" id="details"><\/a>|<a id="details" name="details"><\/a>/,
        '<a id="details"></a>',
      )
      .replace(
        /<pre class="fragment">/g,
        '<pre class="code" tabindex="0" role="group" aria-label="Formulae">',
      )
      .replace(/ (?:on(?:click|mouse\w+)|align|valign|nowrap|width)="[^"]*"| nowrap(?=[ >])/g, '')
      .replace(/<a id="([^"]*)" name="\1"><\/a>/g, '<a id="$1"></a>')
      .replace(
        /<dl class="section (?:see|return|note|pre|post|warning|remark|author|since)"/g,
        '<dl class="section"',
      )
  );
}

function contents(current) {
  const item = (p) => {
    const here = p.name === current.name;
    const outline =
      here && p.outline?.length
        ? `<ul>${p.outline.map(([id, h]) => `<li><a href="#${id}">${said(h)}</a></li>`).join('')}</ul>`
        : '';
    return (
      `<li><a href="${p.name}.html"${here ? ' aria-current="page"' : ''}>` +
      `${p.number ? `<span class="n">${p.number}</span> ` : ''}${said(p.title)}</a>${outline}</li>`
    );
  };
  const plain = (list) => `<ul>\n${list.map(item).join('\n')}\n</ul>`;
  const first = pages.findIndex((p) => p.chapter);
  const last = pages.findLastIndex((p) => p.chapter);
  const middle = chapters.map((c) => {
    const [opening, ...sections] = pages.filter((p) => p.chapter === c.id);
    return (
      `<details${current.chapter === c.id ? ' open' : ''}><summary>${escape(c.short)}</summary>\n` +
      `${plain([{ ...opening, title: 'Opening' }, ...sections.map((p) => (p.number ? p : { ...p, title: 'What needs what' }))])}</details>`
    );
  });
  return `${plain(pages.slice(0, first))}\n${middle.join('\n')}\n${plain(pages.slice(last + 1))}`;
}

const neighbours = (index) => (index < 0 ? [] : [pages[index - 1], pages[index + 1]]);

function turn(index) {
  const link = (p, rel, word) =>
    p
      ? `<a rel="${rel}" href="${p.name}.html"><span class="way">${word}</span> ` +
        `${p.number ? `§ ${p.number}. ` : ''}${said(p.title)}</a>`
      : '';
  const [before, after] = neighbours(index);
  return link(before, 'prev', 'Previous') + link(after, 'next', 'Next');
}

/** The same for the banner, and for browsers that look at the head. */
function arrows(index) {
  const [before, after] = neighbours(index);
  const one = (p, word, sign) => (p ? `<a href="${p.name}.html" aria-label="${word}: ${said(p.title)}">${sign}</a>` : '');
  return one(before, 'Previous', '←') + one(after, 'Next', '→');
}

function relations(index) {
  const [before, after] = neighbours(index);
  const one = (p, rel) => (p ? `<link rel="${rel}" href="${p.name}.html">\n` : '');
  return one(before, 'prev') + one(after, 'next');
}

const documents = [];
const made = new Map(); // page to the ids in it

/** Doxygen's pages that the book does without: lists of lists. */
const spare =
  /^(?:(?:dir_|functions|globals|namespacem)[\w~]*|.*-members|annotated|classes|files|hierarchy|pages|library_8dox)\.html/;

for (const file of fs
  .readdirSync(from)
  .filter((f) => f.endsWith('.html') && !spare.test(f) && (!only || f === `${only}.html`))
  .sort()) {
  const name = file.slice(0, -5);
  const raw = read(from, file);
  const index = pages.findIndex((p) => p.name === name);
  const ours = fs.existsSync(path.join(build, `dox/${name}.dox`));
  const page = pages[index] ?? { name };
  const title =
    page.title ??
    unescape(
      /<title>([^]*?)<\/title>/
        .exec(raw)[1]
        .replace(/^Euler on Oscillation: /, '')
        .replace(/ (Namespace|Struct|Class|File|Concept)( Template)? Reference$/, ''),
    );
  let body = raw.slice(raw.indexOf('<body>') + 6, raw.lastIndexOf('</body>')).replace(/<!--[^]*?-->/g, '');
  body = body
    .replace(/<div id="nav-path"[^]*?<\/ul>\s*<\/div>/, '')
    .replace(/<div class="(?:PageDoc"><div class=")?header">[^]*?(?=<div class="contents">)/, '');
  const seen = {
    equations: new Set([...body.matchAll(/id="eq-([^"]+)"/g)].map((m) => m[1])),
    coded: new Set([...body.matchAll(/id="code-([^"]+)"/g)].map((m) => m[1])),
  };
  body = body.replace(
    /<div class="fragment">((?:<div class="line">[^]*?<\/div>\s*)*)<\/div>(?:<!-- fragment -->)?/g,
    (_, lines) => listing(lines, seen),
  );
  body = body.replace(/<div class="ttc"[^>]*>(?:<div[^>]*>[^]*?<\/div>)*<\/div>/g, '');
  body = body.replace(/<a [^>]*href="([^"]*)"[^>]*>([^]*?)<\/a>/g, (all, to, text) =>
    spare.test(to) ? text : all,
  );
  body = body.replace(/<p>\s*<\/p>/g, '').replace(/<p>(?=\s*<(?:pre|div|section|figure|header|h2))/g, '');
  if (!ours) body = repaired(mathematics(body, file), escape(title), file);
  body = body.replace(/<a class="api" data-api="([^"]*)">/g, (_, what) => {
    const target = api.get(unescape(what).replace(/\(.*$/, ''));
    if (!target) throw new Error(`${name}: {{api ${what}}}: the library has no such name`);
    return `<a class="api" href="${target}">`;
  });
  const once = new Set();
  body = body.replace(/ id="([^"]*)"/g, (all, id) => {
    if (once.has(id) && !ours) return '';
    once.add(id);
    return all;
  });
  body = balanced(body.replace(/^\s*(?:<\/div>\s*)+/, ''));
  const text = words(body.replace(/<pre[^]*?<\/pre>|<svg[^]*?<\/svg>|<header[^]*?<\/header>|<aside class="margin summary">[^]*?<\/aside>|<a class="anchor"[^]*?<\/a>/g, ' '));
  const first = /^.{20,200}?[.!?](?= )/.exec(text)?.[0] ?? text.slice(0, 160).replace(/\s+\S*$/, '');
  const fill = {
    title:
      name === 'index'
        ? escape(title)
        : `${page.number ? `§ ${page.number}. ` : ''}${escape(title)} · Euler on Oscillation`,
    description: escape(page.description ?? (ours ? first : `${title}, of the library: ${first}`)),
    relations: relations(index),
    kind: page.number ? 'section' : page.chapter ? 'chapter' : ours ? 'matter' : 'library',
    body: body.trim(),
    arrows: arrows(index),
    turn: turn(index),
    contents: contents(page),
  };
  const html = template.replace(
    /\{(title|description|relations|kind|body|arrows|turn|contents)\}/g,
    (_, key) => fill[key],
  );
  write(file, html);
  made.set(file, new Set([...html.matchAll(/\bid="([^"]+)"/g)].map((m) => m[1])));
  const chapter = chapters.find((c) => c.id === page.chapter);
  if (name !== 'search')
    documents.push({
      id: documents.length,
      page: file,
      title: `${page.number ? `${chapter.short} § ${page.number}. ` : ''}${title}`,
      text,
      rank: ours ? 1 : 0.2,
    });
  // A word of the glossary is found by itself, too: whoever asks for it wants its meaning before its uses.
  if (name === 'glossary')
    for (const [, id, term, meaning] of body.matchAll(/<dt id="([^"]+)">([^]*?)<\/dt>\s*<dd>([^]*?)<\/dd>/g))
      documents.push({
        id: documents.length,
        page: `${file}#${id}`,
        title: words(term),
        shown: `Glossary: ${words(term)}`,
        text: words(meaning),
        rank: 1,
      });
}

// -------------------------------------------------------------------------------------- search, links, files

/** The index of the search. */
async function index() {
  const { folded, options } = await import('./search.mjs');
  const MiniSearch = packages('minisearch');
  const made = new MiniSearch({ ...options, processTerm: folded });
  made.addAll(documents);
  write('search-index.js', `window.bookIndex = ${JSON.stringify(made)};\n`);
}

/** The scripts, the style sheets and the faces of the formulae. */
function files() {
  const umd = fs
    .readFileSync(packages.resolve('minisearch').replace(/dist.*/, 'dist/umd/index.js'), 'utf8')
    .replace(/\n?\/\/# sourceMappingURL.*\n?/, '\n');
  write('minisearch.js', umd);
  write('search.js', read(source, 'book/search.mjs').replace(/^export /gm, ''));
  write('book.js', read(source, 'book/book.js'));
  const { outputFiles } = packages('esbuild').buildSync({
    entryPoints: [path.join(source, 'book/live/frames.mjs')],
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    charset: 'utf8',
    write: false,
    logLevel: 'error',
  });
  write('scene.js', outputFiles[0].text);
  write('copy-tex.js', fs.readFileSync(packages.resolve('katex/dist/contrib/copy-tex.min.js'), 'utf8'));

  /**
   * The faces that most pages need are put into the style sheets themselves: so they are there when the first
   * line is laid out.
   */
  const woven = (css, folder, faces) =>
    css.replace(/url\((?:fonts\/)([\w-]+)\.woff2\)/g, (all, face) =>
      faces.test(face)
        ? `url(data:font/woff2;base64,` +
          `${fs.readFileSync(path.join(folder, `${face}.woff2`)).toString('base64')})`
        : all,
    );
  const colours = palette(read(source, 'figures/style.gp'));
  const style = read(source, 'book/style.css')
    .replace('/*light*/', paletteCss(colours, 'light'))
    .replace('/*dark*/', paletteCss(colours, 'dark'));
  write(
    'style.css',
    woven(style, path.join(site, 'fonts'), /^(EBGaramond12-(Regular|Italic)|JetBrainsMono-Regular)$/),
  );
  const katex = path.dirname(packages.resolve('katex/dist/katex.min.css'));
  const formulaStyle = read(katex, 'katex.min.css').replace(
    /,url\([^)]*\.(?:woff|ttf)\) format\("[^"]*"\)/g,
    '',
  );
  write(
    'katex/katex.css',
    woven(formulaStyle, path.join(katex, 'fonts'), /^KaTeX_(Main-Regular|Math-Italic|Size\d-Regular)$/),
  );
  for (const font of fs.readdirSync(path.join(katex, 'fonts')).filter((f) => f.endsWith('.woff2')))
    write(`katex/fonts/${font}`, fs.readFileSync(path.join(katex, 'fonts', font)));
}

files();
if (!only) {
  await index();
  for (const p of pages) if (!made.has(`${p.name}.html`)) throw new Error(`${p.name}: no page was made`);
  for (const old of fs.readdirSync(site))
    if (old.endsWith('.html') && !made.has(old)) fs.rmSync(path.join(site, old));
}
const dead = [];
for (const [file] of made) {
  const html = read(site, file).replace(/<annotation[^]*?<\/annotation>/g, '');
  for (const [, link] of html.matchAll(/\b(?:href|src)="([^"]*)"/g)) {
    const [to, anchor] = unescape(link).split('#');
    if (/^[a-z]+:/.test(to)) {
      if (!/^(https:|mailto:)/.test(to)) dead.push(`${file}: ${link}`);
      continue;
    }
    const target = to ? to.split('?')[0] : file;
    if (only && target !== file) continue;
    if (!made.has(target) && !fs.existsSync(path.join(site, target)))
      dead.push(`${file}: ${link} is not there`);
    else if (anchor && !made.get(target)?.has(decodeURIComponent(anchor)))
      dead.push(`${file}: ${link} has no such anchor`);
  }
  const visible = words(html.replace(/<(pre|code|script|style)\b[^]*?<\/\1>/g, ' '));
  const raw = /\\[a-zA-Z]+|\$\$|\{\{|\}\}|:::/.exec(visible);
  if (raw)
    dead.push(
      `${file}: "${visible.slice(Math.max(raw.index - 30, 0), raw.index + 30)}" is raw TeX or a raw command`,
    );
}
formulas.save();
if (dead.length) {
  console.error(dead.join('\n'));
  process.exitCode = 1;
} else console.log(`finished: ${made.size} ${made.size === 1 ? 'page' : 'pages'}`);
