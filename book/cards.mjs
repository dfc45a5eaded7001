// The edition's standing forms: the verdict of a check, its claims, an entry of the apparatus, what a section's
// program can be given.
import { escape } from './prose.mjs';
import { texOf } from './tex.mjs';

export const sigla = { erratum: '⁕', emendation: '†', doubtful: '‡', undecided: '◇' };
export const verdict = (holds) =>
  `<span class="verdict ${holds ? 'holds' : 'fails'}">${holds ? '✓ holds' : '✗ fails'}</span>`;

/** How often a claim was made; of many, the one shown is the one that came nearest to failing. */
function times({ times: n, at, used }) {
  const where = at ? `at ${escape(at)}` : '';
  if (n < 2) return where && `<span class="times">${where}</span>`;
  const which = used === undefined ? '' : `, the nearest to failing${where && `: ${where}`}`;
  return `<span class="times">${n} times${which || (where && `, shown ${where}`)}</span>`;
}

/** The claims of a check. `check` is its number on the page. */
export function claims(all, check) {
  const rows = all.map(
    (c, i) =>
      `<tr data-check="${check}" data-claim="${i + 1}"><td class="claim"><code>${escape(c.expression)}</code>` +
      `${c.passed ? '' : ` ${verdict(false)}`}${times(c)}</td>` +
      `<td data-label="got">${escape(c.got)}</td><td data-label="expected">${escape(c.expected)}</td>` +
      `<td data-label="within">${escape(c.tolerance)}</td><td class="word" data-label="because">${escape(c.because)}</td></tr>`,
  );
  const made = all.reduce((n, c) => n + c.times, 0);
  return (
    `<details class="claims"><summary>${all.length} ${all.length === 1 ? 'claim' : 'claims'}` +
    `${made > all.length ? `, made ${made} times` : ''}</summary>\n` +
    `${table('Claims', ['claim', 'got', 'expected', 'within', 'because'], ' stacked')}${rows.join('\n')}${tableEnd}` +
    `</details>\n`
  );
}

/** Words of the apparatus: a formula where they are one. */
function words(text, formulas) {
  const tex = texOf(text);
  try {
    if (tex) return formulas.set(tex, false);
  } catch {
    // no formula after all
  }
  return escape(text);
}

/** An entry of the apparatus in words; `place` is where it stands in the account, `home` the section it is of. */
export function reading(entry, tried, formulas, { place = '', home = '' }) {
  const what = {
    erratum: 'Euler has',
    emendation: 'our copy has',
    doubtful: 'our copy has',
    undecided: 'either',
  }[entry.kind];
  const against = entry.kind === 'undecided' ? 'or' : 'read';
  const proof =
    entry.kind === 'undecided'
      ? 'The proof cannot tell them apart.'
      : 'The proof fails with the first and with others, and holds with the second.';
  const where = place ? `<a href="#${place}">${escape(entry.where)}</a>` : escape(entry.where);
  return (
    `<p class="reading"><span class="siglum" aria-hidden="true">${sigla[entry.kind]}</span> ` +
    `<span class="kind">${entry.kind}</span>${home} ` +
    `<span class="where">${where}</span>: ${what} <span class="has">` +
    `${words(entry.copy, formulas)}</span>, ${against} ` +
    `<span class="right">${words(entry.right, formulas)}</span>; ${escape(entry.because)}. <span class="proof">` +
    `${!tried.passed ? verdict(false) : home ? '' : proof}</span></p>`
  );
}

/** What a section's program can be given: letter, default, range, meaning. */
export function parameters(section) {
  const { parameters: all } = section.told;
  if (!all.length) return '';
  const rows = all.map(
    (p) =>
      `<tr data-parameter="${p.name}"><th scope="row"><code class="whole">${p.name}</code></th>` +
      `<td>${escape(String(p.default).replace(/^-/, '−').replace(/e([+-]?\d+)$/, ' × 10^$1'))}${p.unit === '°' ? '°' : p.unit && ` ${escape(p.unit)}`}</td>` +
      `<td class="word range">${escape(p.range)}</td><td class="word">${escape(p.meaning)}</td></tr>`,
  );
  return (
    `<section class="parameters" data-program="${section.name}">\n` +
    `${table('What can be changed', ['letter', 'default', 'range', 'meaning'])}${rows.join('\n')}${tableEnd}</section>\n`
  );
}

/** The table's opening, with what a keyboard needs to scroll it. */
export const table = (label, heads, more = '') =>
  `<div class="table broad${more}" tabindex="0" role="group" aria-label="${label}"><table><thead><tr>` +
  `${heads.map((h) => `<th scope="col">${h}</th>`).join('')}</tr></thead>\n<tbody>\n`;
export const tableEnd = '</tbody></table></div>\n';
