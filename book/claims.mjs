// What came of a check: its verdict and its claims; the weaver's, and the page's own when it runs them again.
import { escape, said } from './escape.mjs';

export const verdict = (holds) =>
  `<span class="verdict ${holds ? 'holds' : 'fails'}">${holds ? '✓ holds' : '✗ fails'}</span>`;

/** The table's opening, with what a keyboard needs to scroll it; with a title to be seen, if there is one. */
export const table = (label, heads, more = '', title = '') =>
  `<div class="table broad${more}" tabindex="0" role="group" aria-label="${label}"><table>` +
  `${title && `<caption>${title}</caption>`}<thead><tr>` +
  `${heads.map((h) => `<th scope="col">${h}</th>`).join('')}</tr></thead>\n<tbody>\n`;
export const tableEnd = '</tbody></table></div>\n';

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
      `<td data-label="within">${escape(c.tolerance)}</td><td class="word" data-label="because">${said(c.because)}</td></tr>`,
  );
  const made = all.reduce((n, c) => n + c.times, 0);
  return (
    `<details class="claims"><summary>${all.length} ${all.length === 1 ? 'claim' : 'claims'}` +
    `${made > all.length ? `, made ${made} times` : ''}</summary>\n` +
    `${table('Claims', ['claim', 'got', 'expected', 'within', 'because'], ' stacked')}${rows.join('\n')}${tableEnd}` +
    `</details>\n`
  );
}
