// Prose to HTML: CommonMark with tables, mathematics, told values, links, margin notes, figures, exercises. What is
// wrong is not thrown but told to the book, with its line, so that one weave tells all faults.
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import { sigla } from './cards.mjs';
import { escape, said } from './escape.mjs';
import { packages } from './packages.mjs';
import { asTeX, asText, fits, format, handTyped } from './numbers.mjs';
import { isWord, rows } from './table.mjs';
import { breaking, clauses, roomy } from './tex.mjs';

const MarkdownIt = packages('markdown-it');
const katex = packages('katex');

export { escape, said };

/** A function's name set as though it were a product of letters, as KaTeX's MathML then says; and what is said of it. */
export const asProduct = /\\mathrm\{[a-z]{2,}\}/;
export const productSaid = "a function's name is \\operatorname{…}; with \\mathrm it is read as a product of its letters";

/** A sign of relation that ends a column: it keeps no room between itself and what follows it. */
const cramped = /[=<>]\s*&(?!&)/;

/**
 * KaTeX, remembered by content in a file: a formula that was set once is not set again. What the weaver has put into
 * a formula (names of told numbers, signs of the apparatus) is not in the TeX that a reader copies.
 */
export class Formulas {
  constructor(file) {
    this.file = file;
    this.known = fs.existsSync(file) ? JSON.parse(fs.readFileSync(file, 'utf8')) : {};
    this.used = {};
  }

  /** The HTML of a formula; throws KaTeX's error when it does not parse. */
  set(tex, displayMode, toCopy = tex) {
    const key = createHash('sha256')
      .update(`${katex.version} 5 ${displayMode} ${tex}`)
      .digest('base64url');
    this.used[key] =
      this.known[key] ??
      clauses(
        katex.renderToString(displayMode ? breaking(roomy(tex)) : tex, {
          displayMode,
          throwOnError: true,
          trust: ({ command }) => ['\\htmlData', '\\htmlId', '\\htmlClass', '\\href'].includes(command),
          strict: (code) => (code === 'htmlExtension' ? 'ignore' : 'error'),
        }),
      )
        .replace(/(<annotation[^>]*>)[^]*?(?=<\/annotation>)/, (_, tag) => tag + escape(toCopy))
        .replace(/<mo href="[^"]*"/g, '<mo')
        .replace(/<a (?=[^>]*href)/g, '<a tabindex="-1" ');
    return this.used[key];
  }

  save() {
    fs.writeFileSync(this.file, JSON.stringify(this.used));
  }
}

const linesIn = (text) => text.split('\n').length - 1;

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
      if (last === end) {
        state.env.fault(state.env.line + start, `${first[0].trim()} is never closed`);
        last = end - 1;
      }
    }
    if (silent) return true;
    const token = state.push(type, '', 0);
    token.info = first[1] ?? '';
    const content = state
      .getLines(start, last + 1, 0, false)
      .slice(first[0].length + state.tShift[start])
      .replace(new RegExp(close, 'm'), '')
      .trimEnd();
    token.content = content.trimStart();
    token.map = [start, last + 1];
    token.first = state.env.line + start;
    token.line = state.env.line + start + linesIn(content.slice(0, content.length - token.content.length));
    state.line = last + 1;
    return true;
  };
}

/** The line of the file on which an inline rule stands. */
const here = (state) => (state.env?.blockLine ?? 1) + linesIn(state.src.slice(0, state.pos));

/**
 * An inline token of the given type for what `pattern` (sticky) matches: its content the first group, its
 * meta the second.
 */
function inline(type, pattern) {
  return (state, silent) => {
    pattern.lastIndex = state.pos;
    const match = pattern.exec(state.src);
    if (!match) return false;
    if (!silent)
      Object.assign(state.push(type, '', 0), { content: match[1], meta: match[2], line: here(state) });
    state.pos += match[0].length;
    return true;
  };
}

/** What must not stand in a line of prose: it is told, and passes as it is. */
function unwanted(pattern, message) {
  return (state, silent) => {
    pattern.lastIndex = state.pos;
    const match = pattern.exec(state.src);
    if (match && !silent) state.env.fault(here(state), message(match[0]));
    return false;
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
md.core.ruler.at('inline', (state) => {
  let block = 0;
  for (const token of state.tokens) {
    if (token.map) [block] = token.map;
    if (token.type !== 'inline') continue;
    state.env.blockLine = state.env.line + block;
    state.md.inline.parse(token.content, state.md, state.env, token.children);
  }
});
md.inline.ruler.before('escape', 'math', inline('math', /\$((?:[^$\\]|\\[^])+)\$([.,;:!?)]*)/y));
md.inline.ruler.before('escape', 'told', inline('told', /\{\{((?:[^{}\\]|\\.)+)\}\}(?=(\s?[°%])?)/y));
md.inline.ruler.before(
  'escape',
  'stray',
  unwanted(/\$/y, () => 'an odd number of $ (a dollar sign is written \\$)'),
);
md.inline.ruler.before(
  'autolink',
  'html',
  unwanted(/<[a-zA-Z][\w-]*(?:\s[^<>]*)?\/?>/y, (tag) => `HTML in prose: ${tag}`),
);

const guarded = (rule) => (tokens, i, options, page) => {
  try {
    return rule(tokens[i], page, tokens, i);
  } catch (error) {
    const { position = 0 } = error;
    const at = position ? tokens[i].line + linesIn(tokens[i].content.slice(0, position)) : tokens[i].first;
    page.fault(at ?? tokens[i].line, error.message);
    return '';
  }
};
const rules = md.renderer.rules;
/** Whether a formula is short, so that it is not broken. */
const short = ({ content }) =>
  content.replace(/\\[a-z]?frac|\\sqrt/g, '').replace(/\\[a-zA-Z]+/g, 'xx').replace(/[{}^_\s\\]/g, '').length <= 16;
const isSign = (token) => token?.type === 'told' && /^\s*entry\s/.test(token.content);
/** Where the sign of the apparatus stands behind a short formula, with or without a blank: they stay on one line. */
const signOf = (tokens, i) => {
  const between = tokens[i + 1];
  const at = between?.type === 'softbreak' || between?.content === ' ' ? i + 2 : i + 1;
  return tokens[i]?.type === 'math' && short(tokens[i]) && isSign(tokens[at]) ? at : null;
};
rules.math = guarded((token, page, tokens, i) => {
  const stop = token.meta; // it stays on the line: a short formula is not broken, of a long one it is the end
  const formula = page.mathematics(token.content, false, token.line, short(token) ? '' : stop);
  if (signOf(tokens, i)) return `<span class="stopped">${formula}${stop}`; // which the sign ends
  return stop && short(token) ? `<span class="stopped">${formula}${stop}</span>` : formula;
});
rules.told = guarded((token, page, tokens, i) => {
  const ends = signOf(tokens, i - 1) === i || signOf(tokens, i - 2) === i;
  return page.refer(token.content.replaceAll('\\|', '|').trim(), token.meta) + (ends ? '</span>' : '');
});
/** A unit behind a told number stays on its line. */
const unitBehind = (tokens, i, content) => tokens[i - 1]?.type === 'told' && /^ ?(?:[mn]?s|ft|1\/s)(?!\p{L})/u.test(content ?? '');
/** So does a sign of the apparatus behind its word. */
const signBehind = (tokens, i) => isSign(tokens[i + 1]);
/** And so do the number of a section and its sign, and both sides of a ratio of numbers. */
const together = (content) => content.replace(/(§) (?=\d)/g, '$1\u00a0').replace(/(\d) : (?=\d)/g, '$1\u00a0:\u00a0');
rules.text = (tokens, i) => {
  const { content } = tokens[i];
  const unit = together(unitBehind(tokens, i, content) ? content.replace(/^ /, '\u00a0') : content);
  return md.utils.escapeHtml(signBehind(tokens, i) ? unit.replace(/ $/, '\u00a0') : unit);
};
rules.softbreak = (tokens, i) =>
  unitBehind(tokens, i, tokens[i + 1]?.content) || signBehind(tokens, i) || /§$/.test(tokens[i - 1]?.content)
    ? '\u00a0'
    : '\n';
rules.told_block = guarded((token, page) =>
  token.info === 'table' ? page.table(token.content) : page.collected(token.content),
);
rules.formula = guarded((token, page) => page.equation(token.content, token.line));
rules.division = guarded((token, page, tokens, i) => {
  const kind = token.info.trim();
  if (kind === 'margin' && (tokens[i + 1]?.type ?? 'heading_open') === 'heading_open')
    throw new Error('a margin note begins beside the paragraph that follows it, and none does: put it before the last one');
  return page.division(kind, token.content, token.line);
});
rules.table_open = () => '<div class="table words" tabindex="0" role="group" aria-label="Table">\n<table>\n';
rules.table_close = () => '</table>\n</div>\n';
/** Code: what is short is not broken, and an option not behind its dashes. */
rules.code_inline = (tokens, i) => {
  const { content } = tokens[i];
  if (content.length < 30) return `<code class="whole">${escape(content)}</code>`;
  return `<code>${escape(content).replace(/--\w+/g, '<span class="stopped">$&</span>')}</code>`;
};
rules.heading_open = (tokens, i) => `<${tokens[i].tag} id="${slug(tokens[i + 1].content)}">`;
rules.heading_close = (tokens, i) => `${anchor(slug(tokens[i - 1].content))}</${tokens[i].tag}>\n`;
rules.fence = (tokens, i) =>
  `<pre class="code" tabindex="0" role="group" aria-label="Commands"><code>${escape(tokens[i].content)}</code></pre>\n`;

export const slug = (text) =>
  text
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');

/** The sign behind a heading that leads to it. */
export const anchor = (id) => `<a class="anchor" href="#${id}" aria-label="Link to this heading">#</a>`;

/** A heading of the weaver's own. */
export const heading = (text, id = slug(text)) => `<h2 id="${id}">${text}${anchor(id)}</h2>\n`;

const refersTo = /^(eq|sec|api|entry|term) +(.+)$/;

/**
 * One page under way: renders its pieces of prose, and knows what they refer to. `book` has formulas,
 * sections (by id: told, equations, title), chapters, `fault(file, line, message)`, and `collected(what)` for the
 * lists that the weaver makes. `chapter` is the one whose sections are named without it.
 */
export class Page {
  constructor(book, file, section = null, chapter = section?.chapter) {
    Object.assign(this, { book, file, section, chapter, formulas: book.formulas, figures: [], noFigure: null });
    Object.assign(this, { line: 1, numbers: new Map(), referred: new Set(), exercises: 0 });
  }

  fault(line, message) {
    this.book.fault(this.file, line, message.replace(/\s+/g, ' '));
  }

  /** HTML of prose that begins at `line` of the file. */
  html(text, line = 1) {
    return this.at(line, () => {
      this.judge(text);
      return md.render(text, this);
    });
  }

  inline(text, line = this.line) {
    return this.at(line, () => md.renderInline(text, this));
  }

  at(line, work) {
    const before = this.line;
    this.line = line;
    try {
      return work();
    } finally {
      this.line = before;
    }
  }

  /** Numbers typed where a told one has the same digits; bars that would end a table's cell; functions set as products. */
  judge(text) {
    const lines = text.split('\n');
    let cells = 0;
    let fence = false;
    lines.forEach((line, i) => {
      if (/^```/.test(line)) fence = !fence;
      if (fence) return;
      const row = /^\s*\|/.test(line);
      const bars = row ? line.replace(/\\\|/g, '').split('|').length : 0;
      if (row && cells && bars !== cells)
        this.fault(
          this.line + i,
          'a table row with more or fewer cells than its head: a bar in code or in a formula is written \\| (or \\vert)',
        );
      cells = row ? cells || bars : 0;
      if (asProduct.test(line)) this.fault(this.line + i, productSaid);
      if (cramped.test(line)) this.fault(this.line + i, 'a sign before & has no room behind it: it is written &= or ={}&');
      for (const [typed, name] of handTyped(line, this.section?.told.values ?? []))
        this.fault(this.line + i, `${typed} is typed by hand; the program tells it: {{${name}}}`);
    });
  }

  /** The value behind a name: of this section, of another (chapter.NN.name), or a recorded time (speed....). */
  value(name) {
    if (name.startsWith('speed.')) return this.book.speed(name);
    const [, id, own] = /^(?:([a-z]+\.\d\d)\.)?(\w+)$/.exec(name) ?? [];
    const section = id ? this.book.sections.get(id) : this.section;
    const told =
      section?.told.values.find((v) => v.name === own) ??
      section?.told.parameters.find((p) => p.name === own);
    if (told) return { ...told, full: `${section.id}.${own}`, section };
    if (id && this.book.only && !section) return { value: '…', unit: '', meaning: '', full: name };
    throw new Error(`no value is told by the name of {{${name}}}`);
  }

  /** What `name|format` stands for; without its sign (° or %) where the sign is written behind it. */
  number(what, sign) {
    const [name, spec = ''] = what.split('|').map((s) => s.trim());
    const value = this.value(name);
    if (!fits(value, spec)) throw new Error(`{{${what}}}: the format is for ${fits.wants(spec)}`);
    const number = format(value, spec);
    if (!number) throw new Error(`no format |${spec} in {{${what}}}`);
    this.numbers.set(value.full, value);
    return { value, spec, number: sign ? { ...number, suffix: '' } : number };
  }

  /** A formula with told values and signs of the apparatus in it, and the stop that ends it. */
  mathematics(tex, display, line, stop = '') {
    const fill = (told, entry) =>
      tex.replace(/\{\{([^{}]+)\}\}(?=(°|\^\\circ|(?:\\,)?\\%)?)/g, (all, what, sign, at) => {
        try {
          const name = /^entry +(\w+)$/.exec(what.trim())?.[1];
          return name ? entry(this.entry(name)) : told(this.number(what, sign));
        } catch (error) {
          throw Object.assign(error, { position: at });
        }
      });
    const named = fill(
      ({ value, spec, number }) =>
        `{\\htmlData{name=${value.full}, format=${spec}}{${asTeX(number)}}}`,
      ({ kind, to, id }) => {
        const sign = `\\htmlClass{siglum}{${{ erratum: '\\ast', emendation: '\\dagger', doubtful: '\\ddagger', undecided: '\\diamond' }[kind]}}`;
        return `{}^{\\href{#${to}}{${id ? `\\htmlId{${id}}{${sign}}` : sign}}}`;
      },
    );
    const plain = fill(({ number }) => `{${asTeX(number)}}`, () => '');
    try {
      return this.formulas.set(stop ? `${named}\\text{${stop}}` : named, display, plain + stop);
    } catch (error) {
      if (error.position > 0) error.position = Math.min(error.position, tex.length);
      throw error;
    }
  }

  /** An entry of this section's apparatus by its name; the first that refers to it has the id that it links back to. */
  entry(name) {
    const entry = this.section?.entries.find((e) => e.name === name);
    if (!entry) throw new Error(`no entry of the apparatus is called ${name}`);
    const id = this.referred.has(name) ? '' : `at-${name}`;
    this.referred.add(name);
    return { ...entry, id };
  }

  /** {{...}} in a line of prose. */
  refer(written, sign) {
    const what = written.replace(/\s+/g, ' ');
    const [, kind, rest] = refersTo.exec(what) ?? [];
    if (kind === 'api') return `<a class="api" data-api="${escape(rest)}"><code>${escape(rest)}</code></a>`;
    if (kind === 'sec') return this.linkToSection(rest);
    if (kind === 'term') {
      if (!this.book.terms.has(slug(rest))) throw new Error(`the glossary has no ${rest}`);
      return `<a class="term" href="glossary.html#term-${slug(rest)}">${escape(rest)}</a>`;
    }
    if (kind === 'entry') {
      const entry = this.entry(rest);
      const words = `${entry.kind}: ${entry.where}`;
      return (
        `<a class="siglum"${entry.id ? ` id="${entry.id}"` : ''} href="#${entry.to}" ` +
        `aria-label="${escape(words)}">${sigla[entry.kind]}</a>`
      );
    }
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
    const { value, spec, number } = this.number(what, sign);
    return (
      `<data class="told" tabindex="0" role="button" data-name="${escape(value.full)}" data-format="${escape(spec)}" ` +
      `value="${escape(value.text ?? value.value)}">${escape(asText(number))}</data>`
    );
  }

  /** A line for those who cannot see a figure: told numbers in it, and no other signs. */
  words(text) {
    return text
      .replace(/\s+/g, ' ')
      .replace(/\{\{([^{}]+)\}\}(?=(\s?[°%])?)/g, (_, what, sign) => asText(this.number(what, sign).number));
  }

  nameOf(id) {
    const [chapter, number] = id.split('.');
    const known = this.book.chapters.find((c) => c.id === chapter);
    if (!known || !(Number(number) >= 1 && Number(number) <= known.sections))
      throw new Error(`there is no section ${id}`);
    return `${chapter === this.chapter ? '' : `${known.short} `}§\u00a0${Number(number)}`;
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

  /**
   * A displayed formula; with \tag{n} it is numbered, linkable, and linked to the code that is it. A letter for a
   * number marks a formula of the edition's own.
   */
  equation(tex, line) {
    const number = /\\tag\{([^}]+)\}/.exec(tex)?.[1];
    const html = this.mathematics(tex.replace(/\\tag\{[^}]+\}/, ''), true, line);
    const ours = number && !/^\d/.test(number);
    const name = number ? ` ${number}${ours ? ', the edition’s own' : ''}` : '';
    const formula = `<div class="formula" tabindex="0" role="group" aria-label="Formula${name}">${html}</div>`;
    if (!number) return `<div class="equation">${formula}</div>\n`;
    const code = this.section?.coded.has(number)
      ? `<a class="to-code" href="#code-` +
        `${number}" title="the code that is this formula" aria-label="code of formula ${number}">code</a>`
      : '';
    return (
      `<div class="equation${ours ? ' ours' : ''}" id="eq-${number}">${formula}<span class="number"><a href="#eq-` +
      `${number}">(${number})</a>${ours ? '<span class="whose">ours</span>' : ''}${code}</span></div>\n`
    );
  }

  division(kind, text, line) {
    if (kind === 'margin') return `<aside class="margin">${this.html(text, line)}</aside>\n`;
    if (kind === 'no-figure') {
      this.noFigure = this.inline(text.replace(/\s+/g, ' '), line);
      return '';
    }
    if (kind === 'exercise') return this.exercise(text, line);
    const [, file, name, formulae] = /^code (\S+) (\w+)((?: \(\w+\))*)$/.exec(kind) ?? [];
    if (file) {
      this.book.snippet(file, name);
      const links = formulae.replace(/\((\w+)\)/g, '<a class="eqref" id="code-$1" href="#eq-$1">($1)</a>');
      return (
        `<p class="from">src/${file}${links}</p>\n` +
        `\\endhtmlonly\n\\snippet ${file} ${name}\n\\htmlonly[block]\n`
      );
    }
    const drawn = this.book.divisions?.[kind];
    if (drawn) return drawn(text, this, line);
    const [, what, figure] = /^(figure|scene) (\S+)$/.exec(kind) ?? [];
    if (!figure)
      throw new Error(
        `::: ${kind} is not known (margin, code FILE NAME (n), figure NAME, scene NAME, no-figure, exercise, map, route)`,
      );
    if (what === 'figure') this.figures.push(figure);
    const [, alternative, caption] = /^alt: *([^]*?)\n\s*\n([^]*)$/.exec(text) ?? [];
    if (!caption?.trim())
      throw new Error(`::: ${what} ${figure} needs "alt: ...", an empty line, and a caption`);
    return this.book[what](
      figure,
      this.words(alternative),
      this.inline(caption.trim(), line + linesIn(text.slice(0, text.length - caption.length))),
      this,
    );
  }

  /** Something to go on from, with its answer folded. */
  exercise(text, line) {
    const [question, answer] = text.split(/^answer: */m);
    this.exercises += 1;
    const folded = answer
      ? `<details><summary>answer</summary>${this.html(answer, line + linesIn(question))}</details>`
      : '';
    return (
      `<section class="exercise" id="exercise-${this.exercises}"><p class="n">${this.exercises}.</p>` +
      `<div>${this.html(question, line)}${folded}</div></section>\n`
    );
  }

  /** A told table, set as a table. */
  table(name) {
    const table = this.section?.told.tables.find((t) => t.name === name.trim());
    if (!table) throw new Error(`no table is told by the name of {{table ${name}}}`);
    (this.typeset ??= new Set()).add(table.name);
    const head = table.columns.map(
      (c, i) =>
        `<th scope="col"${table.rows.every((row) => isWord(row[i])) ? ' class="word"' : ''}>` +
        `${said(c.heading)}${c.unit ? ` <span class="unit">${escape(c.unit)}</span>` : ''}</th>`,
    );
    return (
      `<div class="table" tabindex="0" role="group" aria-label="Table"><table class="told" data-table="${table.name}">` +
      `<caption>${this.inline(table.caption)}</caption>\n` +
      `<thead><tr>${head.join('')}</tr></thead>\n<tbody>\n${rows(table).join('\n')}\n</tbody></table></div>\n`
    );
  }

  collected(name) {
    return this.book.collected(name.trim(), this);
  }
}
