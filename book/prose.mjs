// Prose to HTML: CommonMark with tables, mathematics, told values, links, margin notes and figures.
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import { packages } from './packages.mjs';
import { asTeX, asText, format } from './numbers.mjs';

const MarkdownIt = packages('markdown-it');
const katex = packages('katex');

export const escape = (text) =>
  String(text).replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

/** KaTeX, remembered by content in a file: a formula that was set once is not set again. */
export class Formulas {
  constructor(file) {
    this.file = file;
    this.known = fs.existsSync(file) ? JSON.parse(fs.readFileSync(file, 'utf8')) : {};
    this.used = {};
  }

  /** The HTML of a formula; throws KaTeX's message when it does not parse. */
  set(tex, displayMode) {
    const key = createHash('sha256').update(`${katex.version} ${displayMode} ${tex}`).digest('base64url');
    this.used[key] =
      this.known[key] ?? katex.renderToString(tex, { displayMode, throwOnError: true, strict: 'error' });
    return this.used[key];
  }

  save() {
    fs.writeFileSync(this.file, JSON.stringify(this.used));
  }
}

/** What stands between a line `open` and a line `close` (or on one line) is one token of the given type. */
function fenced(type, open, close) {
  return (state, start, end, silent) => {
    const line = (n) => state.src.slice(state.bMarks[n] + state.tShift[n], state.eMarks[n]);
    const first = open.exec(line(start));
    if (!first) return false;
    let last = start;
    if (!close.exec(line(start).slice(first[0].length))) {
      do last += 1;
      while (last < end && !close.test(line(last)));
      if (last === end) throw new Error(`${first[0].trim()} is never closed`);
    }
    if (silent) return true;
    const token = state.push(type, '', 0);
    token.info = first[1] ?? '';
    token.content = state
      .getLines(start, last + 1, 0, false)
      .trim()
      .slice(first[0].length)
      .replace(new RegExp(close, 'm'), '')
      .trim();
    token.map = [start, last + 1];
    state.line = last + 1;
    return true;
  };
}

/**
 * An inline token of the given type for what `pattern` (sticky) matches: its content the first group, its
 * meta the second.
 */
function inline(type, pattern) {
  return (state, silent) => {
    pattern.lastIndex = state.pos;
    const match = pattern.exec(state.src);
    if (!match) return false;
    if (!silent) Object.assign(state.push(type, '', 0), { content: match[1], meta: match[2] });
    state.pos += match[0].length;
    return true;
  };
}

const md = new MarkdownIt({ typographer: true }).disable('replacements');
const alt = { alt: ['paragraph', 'reference', 'blockquote', 'list'] };
md.block.ruler.before('fence', 'formula', fenced('formula', /^\$\$/, /\$\$$/), alt);
md.block.ruler.before('fence', 'division', fenced('division', /^::: *(\S.*)/, /^:::$/), alt);
md.block.ruler.before(
  'fence',
  'told_block',
  fenced('told_block', /^\{\{(table|collected) (?=[^{}]+\}\}$)/, /\}\}$/),
  alt,
);
md.inline.ruler.before('escape', 'math', inline('math', /\$((?:[^$\\]|\\[^])+)\$([.,;:!?)]*)/y));
md.inline.ruler.before('escape', 'told', inline('told', /\{\{((?:[^{}\\]|\\.)+)\}\}(?=(\s?[°%])?)/y));

const rules = md.renderer.rules;
rules.math = (tokens, i, _, page) => {
  const formula = page.formulas.set(page.fill(tokens[i].content), false);
  const stop = tokens[i].meta; // after a short formula it stays on the line
  const together = stop && tokens[i].content.length <= 20;
  return together ? `<span class="stopped">${formula}${stop}</span>` : formula + (stop && `\u2060${stop}`);
};
rules.told = (tokens, i, _, page) =>
  page.refer(tokens[i].content.replaceAll('\\|', '|').trim(), tokens[i].meta);
rules.told_block = (tokens, i, _, page) =>
  tokens[i].info === 'table' ? page.table(tokens[i].content) : page.collected(tokens[i].content);
rules.formula = (tokens, i, _, page) => page.equation(tokens[i].content);
rules.division = (tokens, i, _, page) => page.division(tokens[i].info.trim(), tokens[i].content);
rules.table_open = () => '<div class="table words" tabindex="0" role="group" aria-label="Table">\n<table>\n';
rules.table_close = () => '</table>\n</div>\n';
rules.code_inline = (tokens, i) =>
  `<code${tokens[i].content.length < 30 ? ' class="whole"' : ''}>${escape(tokens[i].content)}</code>`;
rules.heading_open = (tokens, i) => `<${tokens[i].tag} id="${slug(tokens[i + 1].content)}">`;
rules.fence = (tokens, i) =>
  `<pre class="code" tabindex="0"><code>${escape(tokens[i].content)}</code></pre>\n`;

export const slug = (text) =>
  text
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');

/**
 * One page under way: renders its pieces of prose, and knows what they refer to. `book` has formulas,
 * sections (by id: told, equations, title), chapters, and `collected(what)` for the lists that the
 * weaver makes.
 */
export class Page {
  constructor(book, file, section = null) {
    Object.assign(this, { book, file, section, formulas: book.formulas, figures: [], noFigure: null });
  }

  /** HTML of prose that begins at `line` of the file. Errors name file and line. */
  html(text, line = 1) {
    this.text = text;
    this.line = line;
    this.within = '';
    try {
      return md.render(text, this);
    } catch (error) {
      if (!error.placed)
        error.message = `${this.file}:${this.lineOf(this.within)}: ${error.message.replace(/\n/g, ' ')}`;
      throw Object.assign(error, { placed: true });
    }
  }

  inline(text) {
    return md.renderInline(text, this);
  }

  lineOf(piece) {
    return this.line + this.text.slice(0, Math.max(this.text.indexOf(piece), 0)).split('\n').length - 1;
  }

  /** The value behind a name: of this section, of another (chapter.NN.name), or a recorded time (speed....). */
  value(name) {
    if (name.startsWith('speed.')) return this.book.speed(name);
    const [, id, own] = /^(?:([a-z]+\.\d\d)\.)?(\w+)$/.exec(name) ?? [];
    const section = id ? this.book.sections.get(id) : this.section;
    const told =
      section?.told.values.find((v) => v.name === own) ??
      section?.told.parameters.find((p) => p.name === own);
    if (!told) throw new Error(`no value is told by the name of {{${name}}}`);
    return { ...told, full: `${section.id}.${own}` };
  }

  /** Told values inside mathematics. */
  fill(tex) {
    this.within = tex;
    return tex.replace(
      /\{\{([^{}]+)\}\}(?=(°|\^\\circ|(?:\\,)?\\%)?)/g,
      (_, what, sign) => `{${asTeX(this.number(what, sign).number)}}`,
    );
  }

  /** What `name|format` stands for; without its sign (° or %) where the sign is written behind it. */
  number(what, sign) {
    const [name, spec] = what.split('|').map((s) => s.trim());
    const value = this.value(name);
    const number = format(value, spec);
    if (!number) throw new Error(`no format |${spec} in {{${what}}}`);
    return { value, number: sign ? { ...number, suffix: '' } : number };
  }

  /** {{...}} in a line of prose. */
  refer(written, sign) {
    this.within = written;
    const what = written.replace(/\s+/g, ' ');
    const [, kind, rest] = /^(eq|sec|api) +(.+)$/.exec(what) ?? [];
    if (kind === 'api') return `<a class="api" data-api="${escape(rest)}"><code>${escape(rest)}</code></a>`;
    if (kind === 'sec') return this.linkToSection(rest);
    if (kind === 'eq') {
      const [number, id] = rest.split(/ +/).reverse();
      const target = id ? this.book.sections.get(id) : this.section;
      if (id && !target) return `${this.linkToSection(id)} (${number})`;
      if (!target?.equations.has(number)) throw new Error(`no formula (${number}) for {{${what}}}`);
      const prefix = id ? `${this.nameOf(id)} ` : '';
      return (
        `<a class="eqref" href="${id ? `${target.name}.html` : ''}#eq-${number}">${prefix}(${number})` +
        `</a>`
      );
    }
    const { value, number } = this.number(what, sign);
    const title =
      `${value.full} = ${value.text ?? value.value}${value.unit ? ` ${value.unit}` : ''}: ` +
      `${value.meaning}`;
    return (
      `<data value="${escape(value.text ?? value.value)}" title="${escape(title)}">` +
      `${escape(asText(number))}</data>`
    );
  }

  nameOf(id) {
    const [chapter, number] = id.split('.');
    const known = this.book.chapters.find((c) => c.id === chapter);
    if (!known || !(Number(number) >= 1 && Number(number) <= known.sections))
      throw new Error(`there is no section ${id}`);
    return `${chapter === this.section?.chapter ? '' : `${known.short} `}§ ${Number(number)}`;
  }

  /** A link to a section's page; to its row in the chapter's map while there is no page. */
  linkToSection(id) {
    const name = this.nameOf(id);
    const [chapter, number] = id.split('.');
    const target = this.book.sections.get(id);
    return target
      ? `<a href="${target.name}.html">${name}</a>`
      : `<a class="not-yet" title="not yet in this edition" href="${chapter}.html#s${number}">${name}</a>`;
  }

  /** A displayed formula; with \tag{n} it is numbered, linkable, and linked to the code that is it. */
  equation(tex) {
    this.within = tex.split('\n')[0];
    const number = /\\tag\{([^}]+)\}/.exec(tex)?.[1];
    const html = this.formulas.set(this.fill(tex.replace(/\\tag\{[^}]+\}/, '')), true);
    const formula =
      `<div class="formula" tabindex="0" role="group" aria-label="Formula` +
      `${number ? ` ${number}` : ''}">${html}</div>`;
    if (!number) return `<div class="equation">${formula}</div>\n`;
    const code = this.section?.coded.has(number)
      ? `<a class="to-code" href="#code-` +
        `${number}" title="the code that is this formula" aria-label="code of formula ${number}">code</a>`
      : '';
    return (
      `<div class="equation" id="eq-${number}">${formula}<span class="number"><a href="#eq-` +
      `${number}">(${number})</a>${code}</span></div>\n`
    );
  }

  division(kind, text) {
    this.within = `::: ${kind}`;
    if (kind === 'margin') return `<aside class="margin">${md.render(text, this)}</aside>\n`;
    if (kind === 'no-figure') {
      this.noFigure = this.inline(text.replace(/\s+/g, ' '));
      return '';
    }
    const [, file, name, formulae] = /^code (\S+) (\w+)((?: \(\w+\))*)$/.exec(kind) ?? [];
    if (file) {
      this.book.snippet(file, name);
      const links = formulae.replace(/\((\w+)\)/g, '<a class="eqref" id="code-$1" href="#eq-$1">($1)</a>');
      return (
        `<p class="from">src/${file}${links}</p>\n` +
        `\\endhtmlonly\n\\snippet ${file} ${name}\n\\htmlonly[block]\n`
      );
    }
    const figure = /^figure (\S+)$/.exec(kind)?.[1];
    if (!figure)
      throw new Error(`::: ${kind} is not known (margin, code FILE NAME (n), figure NAME, no-figure)`);
    const [, alternative, caption] = /^alt: *([^]*?)\n\s*\n([^]*)$/.exec(text) ?? [];
    if (!caption?.trim())
      throw new Error(`::: figure ${figure} needs "alt: ...", an empty line, and a caption`);
    this.figures.push(figure);
    return this.book.figure(figure, alternative.replace(/\s+/g, ' '), this.inline(caption.trim()), this);
  }

  /** A told table, set as a table. */
  table(name) {
    this.within = name;
    const table = this.section?.told.tables.find((t) => t.name === name.trim());
    if (!table) throw new Error(`no table is told by the name of {{table ${name}}}`);
    const isWord = (x) => typeof x === 'string' && !/^-?(inf|nan)$/.test(x);
    const head = table.columns.map(
      (c, i) =>
        `<th scope="col"${table.rows.every((row) => isWord(row[i])) ? ' class="word"' : ''}>` +
        `${escape(c.heading)}${c.unit ? ` <span class="unit">${escape(c.unit)}</span>` : ''}</th>`,
    );
    const cell = (x, c) => {
      if (isWord(x)) return `<td class="word">${escape(x)}</td>`;
      const digits = Number.isInteger(x) ? '' : String(c.digits);
      return `<td>${asText(format({ value: x, unit: '' }, digits))}</td>`;
    };
    const rows = table.rows.map((row) => `<tr>${row.map((x, i) => cell(x, table.columns[i])).join('')}</tr>`);
    return (
      `<div class="table" tabindex="0" role="group" aria-label="Table"><table class="told"><caption>` +
      `${this.inline(table.caption)}</caption>\n` +
      `<thead><tr>${head.join('')}</tr></thead>\n<tbody>\n${rows.join('\n')}\n</tbody></table></div>\n`
    );
  }

  collected(name) {
    this.within = name;
    return this.book.collected(name.trim());
  }
}
