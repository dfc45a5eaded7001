// The edition's standing forms: the verdict of a check, its claims, an entry of the apparatus.
import { escape } from './prose.mjs';

export const sigla = { erratum: '⁕', emendation: '†', doubtful: '‡', undecided: '◇' };
export const verdict = (holds) =>
  `<span class="verdict ${holds ? 'holds' : 'fails'}">${holds ? '✓ holds' : '✗ fails'}</span>`;

/** The claims of a check, those of a loop drawn together. */
export function claims(all) {
  const groups = new Map();
  for (const c of all) {
    const key = [c.expression, c.because, c.passed].join('\n');
    groups.set(key, [...(groups.get(key) ?? []), c]);
  }
  const rows = [...groups.values()].map(
    ([c, ...more]) =>
      `<tr><td class="claim"><code>${escape(c.expression)}</code>${c.passed ? '' : ` ${verdict(false)}`}` +
      `${more.length ? `<span class="times"> the first of ${more.length + 1}</span>` : ''}</td>` +
      `<td>${escape(c.got)}</td><td>${escape(c.expected)}</td><td>${escape(c.tolerance)}</td>` +
      `<td class="word">${escape(c.because)}</td></tr>`,
  );
  return (
    `<details class="claims"><summary>${all.length} ${all.length === 1 ? 'claim' : 'claims'}</summary>\n` +
    `${table('Claims', ['claim', 'got', 'expected', 'within', 'because'])}${rows.join('\n')}${tableEnd}` +
    `</details>\n`
  );
}

/** An entry of the apparatus in words. */
export function reading(entry, check, home = '') {
  const what = {
    erratum: 'Euler has',
    emendation: 'the scan has',
    doubtful: 'printed is',
    undecided: 'either',
  }[entry.kind];
  const against = entry.kind === 'undecided' ? 'or' : 'read';
  const proof =
    entry.kind === 'undecided'
      ? 'The proof cannot tell them apart.'
      : 'The proof fails with the first and holds with the second.';
  return (
    `<p class="reading"><span class="siglum" aria-hidden="true">${sigla[entry.kind]}</span> ` +
    `<span class="kind">${entry.kind}</span>${home} ` +
    `<span class="where">${escape(entry.where)}</span>: ${what} <span class="printed">` +
    `${escape(entry.printed)}</span>, ${against} ` +
    `<span class="right">${escape(entry.right)}</span>; ${escape(entry.because)}. <span class="proof">` +
    `${!check.passed ? verdict(false) : home ? '' : proof}</span></p>`
  );
}

/** The table's opening, with what a keyboard needs to scroll it. */
export const table = (label, heads, more = '') =>
  `<div class="table broad${more}" tabindex="0" role="group" aria-label="${label}"><table><thead><tr>` +
  `${heads.map((h) => `<th scope="col">${h}</th>`).join('')}</tr></thead>\n<tbody>\n`;
export const tableEnd = '</tbody></table></div>\n';
