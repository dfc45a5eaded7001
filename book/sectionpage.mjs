// A section's page: its file's prose and code in turn, with what the program says, its races, its checks and its
// apparatus put where they belong.
import fs from 'node:fs';
import path from 'node:path';
import { parameters, reading, sigla } from './cards.mjs';
import { claims, verdict } from './claims.mjs';
import { code, explained, html, page } from './doxygen.mjs';
import { Page, anchor, escape, heading, said, slug } from './prose.mjs';
import { races } from './speed.mjs';
import { terminal } from './terminal.mjs';
import { bareWords } from './tex.mjs';

const plurals = { erratum: 'errata', emendation: 'emendations' };

/** The headings that a section has, in this order; those with a condition only where it is so. */
const headings = {
  'What Euler does': () => true,
  'The program': () => true,
  'Speed against error': (s) => s.told.races.length > 0,
  Checks: () => true,
  Notes: null,
  'Go on from here': null,
};
const order = Object.keys(headings);
const before = (part, other) => order.indexOf(part) < order.indexOf(other);

/** A statement with a capital, unless it opens with a letter of Euler's: b, dz, l 2. */
const sentence = (words) =>
  /^(a|an|[a-z]{3,})\b/.test(words) || /^(as|at|by|if|in|it|no|of|on|so|to|up)\b/.test(words)
    ? words[0].toUpperCase() + words.slice(1)
    : words;

/** The checks that look at a told name, or at a part of it: { n, words }, n as on the page. */
export function proofs(s, name) {
  const cases = Object.entries(s.check.covers)
    .filter(([key]) => key === name || key.startsWith(`${name}.`) || key.startsWith(`${name}/`))
    .flatMap(([, list]) => list);
  const onPage = s.blocks.filter((b) => b.kind === 'check').map((b) => b.name);
  return [...new Set(cases)]
    .map((i) => s.check.cases[i - 1]?.name)
    .filter(Boolean)
    .map((words) => ({ n: onPage.indexOf(words) + 1, words: sentence(words) }))
    .sort((a, b) => a.n - b.n);
}

/** "checks 1 and 3", linked. */
export function lookedAt(s, name) {
  const all = proofs(s, name).map(({ n }) => `<a href="#check-${n}">${n}</a>`);
  return all.length ? `${all.length === 1 ? 'check' : 'checks'} ${all.join(', ')}` : '';
}

/** What no check looks at, with the reason that the section gives. */
function illustrations(s) {
  const { values, tables, curves, races: run } = s.told;
  const named = [
    ...values.map((v) => [v.name, v]),
    ...tables.flatMap((t) => t.columns.map((c) => [`${t.name}.${c.name}`, c])),
    ...curves.map((c) => [`the curve ${c.name}`, c]),
    ...run.flatMap((r) => r.methods.map((m) => [m.name, m])),
  ].filter(([, what]) => what.illustration);
  return named.length
    ? `<p class="illustrations">No check looks at ${named
        .map(([name, what]) => `<code class="whole">${escape(name)}</code> (${said(what.illustration)})`)
        .join(', ')}.</p>\n`
    : '';
}

/** Where the reader has the checks run again; only the page's own script does anything there. */
const again =
  '\n<p class="again"><button type="button">Run these checks again, in this page</button> <span role="status"></span></p>';

const hasRace = (b) => b.kind === 'TELL' && /\brace\(/.test(b.code);

/** A TELL block; one that only feeds a figure or a race is folded under a line that says so. */
function folded(block, fault) {
  const feeds = [
    [/\bcurve\(/, 'what the figure is drawn from'],
    [/\brace\(/, 'the ways that are compared'],
  ].filter(([call]) => call.test(block.code));
  const shown = code(block.code, block.line, fault);
  if (!feeds.length || /\b(tell|tell_lines|table)\(/.test(block.code)) return shown;
  const summary = feeds.map(([, words]) => words).join(', and ');
  return html(`<details class="folded"><summary>${summary}</summary>`) + shown + html('</details>');
}

function head(s, book, claimed) {
  const chapter = book.chapters.find((c) => c.id === s.chapter);
  const kinds = Object.keys(sigla).map((kind) => [kind, s.entries.filter((e) => e.kind === kind).length]);
  const checks = `${s.checks} ${s.checks === 1 ? 'check' : 'checks'}, ${claimed} ${claimed === 1 ? 'claim' : 'claims'}`;
  return (
    `<header class="opening"><p class="running"><a href="${s.chapter}.html">${escape(chapter.title)}</a> ` +
    `<span class="section-number">§ ${Number(s.number)}</span></p>\n` +
    `<h1>${said(s.told.title)}</h1></header>\n<aside class="margin summary"><p>${verdict(s.holds)} ` +
    `<a href="#checks">${checks}</a></p>` +
    kinds
      .filter(([, n]) => n)
      .map(
        ([kind, n]) =>
          `<p><span class="siglum" aria-hidden="true">${sigla[kind]}</span> <a href="#${kind}-1">` +
          `${n === 1 ? kind : `${n} ${plurals[kind] ?? kind}`}</a></p>`,
      )
      .join('') +
    '</aside>'
  );
}

/** Weaves the page of section `s`; returns what the book's order needs of it. */
export function sectionPage(s, book) {
  const p = new Page(book, s.file, s);
  const fault = (line, message) => book.fault(s.file, line, message);
  const found = [];
  let part = '';
  let checks = 0;
  let missed = false; // a check of the file that was not run: then one that was run may be the same under an old name
  const inPart = [];
  for (const b of s.blocks) {
    if (b.heading) part = b.heading;
    inPart.push([part, b]);
  }
  const last = inPart.filter(([of, b]) => of === 'The program' && b.kind === 'TELL').at(-1)?.[1];
  if (!last && inPart.some(([of]) => of === 'The program')) fault(1, 'no TELL block under "The program": the section says nothing');

  const opens = (b) => {
    for (const m of b.text.matchAll(/^(#+) +(.*)$/gm)) {
      const line = b.line + b.text.slice(0, m.index).split('\n').length - 1;
      const second = m[1] === '##';
      if (m[1] === '#' || m[1].length > 3 || (m[1] === '###' && !found.length))
        fault(line, `the heading "${m[0]}" is out of order`);
      if (!second) continue;
      if (!order.includes(m[2])) fault(line, `the heading "${m[2]}" is none of ${order.join(', ')}`);
      else if (found.length && !before(found.at(-1), m[2]))
        fault(line, `the heading "${m[2]}" stands after "${found.at(-1)}"`);
      else found.push(m[2]);
    }
  };
  const weave = {
    prose(b, of) {
      opens(b);
      const prose = html(p.html(b.text, b.line));
      if (!['Checks', 'Notes', 'Go on from here'].includes(of)) for (const name of p.referred) s.placed.add(name);
      return prose;
    },
    code: (b) => code(b.code, b.line, fault),
    TELL(b, of) {
      if (hasRace(b) && of !== 'Speed against error')
        fault(b.line, 'a race stands under the heading "Speed against error"');
      return folded(b, fault) + (b === last ? '\0told\0' : '');
    },
    check(b, of) {
      const run = s.check.cases.find((c) => c.name === b.name);
      if (!run) {
        missed = true;
        return fault(b.line, `the check "${b.name}" was not run`);
      }
      checks += 1;
      // What confirms an answer would give it away.
      const [fold, end] = of === 'Go on from here' ? ['<details class="folded"><summary>what confirms it</summary>', '</details>'] : ['', ''];
      return (
        html(
          `${fold}<section class="check" id="check-${checks}"><p class="statement">${verdict(run.passed)} ` +
            `${said(sentence(b.name))}${anchor(`check-${checks}`)}</p>`,
        ) +
        code(b.code, b.line, fault) +
        html(`${claims(run.claims, checks)}</section>${end}`)
      );
    },
  };
  const entry = (b) => {
    const it = s.entries.find((e) => e.block === b);
    if (!it.declared || !it.tried)
      return fault(b.line, `the ${it.kind} "${b.name}" is not told by the program`);
    return `\0entry ${it.to}\0`;
  };
  let body = '';
  let left = '';
  for (const [of, b] of inPart) {
    if (b.heading && left === 'Speed against error') body += '\0races\0';
    if (b.heading) left = b.heading;
    body += `${(weave[b.kind] ?? entry)(b, of) ?? ''}\n`;
  }
  if (left === 'Speed against error') body += '\0races\0';

  for (const [name, due] of Object.entries(headings)) {
    if (due?.(s) && !found.includes(name)) fault(1, `the heading "${name}" is missing`);
    if (due && !due(s) && found.includes(name)) fault(1, `the heading "${name}" stands over no race`);
  }
  for (const n of s.coded)
    if (!s.equations.has(n))
      fault(1, `a comment in the code names the formula (${n}), which the prose does not give`);
  if (!p.figures.length && !p.noFigure) fault(1, 'no figure, and no reason for none (::: no-figure)');
  if (p.figures.length && p.noFigure) fault(1, 'a figure, and a reason for none');
  for (const c of missed ? [] : s.check.cases)
    if (!s.blocks.some((b) => b.kind === 'check' && b.name === c.name))
      fault(c.line, `the check "${c.name}" does not stand on the page`);
  for (const e of s.entries)
    if (e.declared?.shown && !s.placed.has(e.name))
      fault(
        e.block.line,
        `nothing in the account refers to this ${e.kind}: put {{entry ${e.name}}} where its reading stands, or declare it not_shown`,
      );
  for (const what of s.check.uncovered) fault(1, what);

  const says =
    heading('What it says') +
    parameters(s, book.live) +
    `<pre class="told" data-program="${s.name}" tabindex="0" role="group" aria-label="Output of ${s.name}"><code>` +
    `${terminal(s.name, s.text, s.told, p.typeset ?? new Set())}</code></pre>\n${illustrations(s)}`;
  body = body
    .replace('\0told\0', () => html(says))
    .replace(/<h2 id="checks">[^]*?<\/h2>/, (h2) => h2 + (book.live ? again : ''))
    .replace('\0races\0', () => html(races(s, book, p)))
    .replace(/\0entry ([\w-]+)\0/g, (_, to) => {
      const e = s.entries.find((x) => x.to === to);
      const place = p.referred.has(e.name) ? `at-${e.name}` : '';
      return (
        html(
          `<section class="entry ${e.kind}" id="${to}">${reading(e.declared, e.tried, book.formulas, { place })}` +
            `<details><summary>the proof</summary>`,
        ) +
        code(e.block.code, e.block.line, fault) +
        html('</details></section>')
      );
    });

  const account = s.blocks[0].text
    .replace(/^\s*## .*$/m, '')
    .replace(/^::: [^]*?^:::$/gm, '')
    .trim()
    .split(/\n\s*\n/)[0]
    .replace(/\s*\{\{entry \w+\}\}/g, '');
  Object.assign(s, {
    figures: p.figures,
    noFigure: p.noFigure,
    checks,
    holds: s.check.passed,
    line: p.inline(/^[^]*?[.!?](?=\s|$)/.exec(account.replace(/\s+/g, ' '))?.[0] ?? account, s.blocks[0].line),
  });
  const claimed = s.check.cases.reduce((n, c) => n + c.claims.length, 0);
  const source = fs.readFileSync(path.join(book.source, s.file), 'utf8');
  book.write(`html/programs/${s.name}.cpp`, source);
  const plain =
    html(
      `<details class="plain"><summary>The whole program</summary>\n<p class="take"><a href="programs/` +
        `${s.name}.cpp" download>${s.name}.cpp</a></p>`,
    ) +
    `\\include ${s.chapter}/s${s.number}.cpp\n` +
    html(`</details><p class="on-paper">The whole program is chapters/${s.chapter}/s${s.number}.cpp.</p>`);
  const numbers = html(explained(p));
  book.write(
    `dox/${s.name}.dox`,
    page(s.name, s.told.title, `${html(head(s, book, claimed))}\n${body}\n${plain}${numbers}`),
  );
  const at = found.indexOf('The program') + 1;
  return {
    name: s.name,
    title: s.told.title,
    chapter: s.chapter,
    number: Number(s.number),
    description: bareWords(s.line),
    uses: [...new Set([...source.matchAll(/^#include "(\S+)"|^::: code (\S+)/gm)].map((m) => m[1] ?? m[2]))],
    outline: [...found.slice(0, at), 'What it says', ...found.slice(at)].map((h) => [slug(h), h]),
  };
}
