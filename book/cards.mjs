// The edition's standing forms: the verdict of a check, its claims, an entry of the apparatus, what a section's
// program can be given.
import { claims, table, tableEnd, verdict } from './claims.mjs';
import { escape, said } from './escape.mjs';
import { field } from './live/fields.mjs';
import { powers } from './numbers.mjs';
import { formulasIn, texOf } from './tex.mjs';

export const sigla = { erratum: '⁕', emendation: '†', doubtful: '‡', undecided: '◇' };

/** Words of the apparatus: a formula where they are one, and where they have some, these. A stop stays on the line. */
function words(text, formulas, stop = '') {
  const whole = texOf(text);
  const parts = whole === null ? formulasIn(text) : ['', whole];
  try {
    const ends = parts.at(-1) === '' ? parts.length - 2 : parts.length - 1;
    return parts
      .map((part, i) => {
        const end = i === ends ? stop : '';
        if (i % 2 === 0) return said(part) + end;
        return formulas.set(end ? `${part}\\text{${end}}` : part, false, part + end);
      })
      .join('');
  } catch {
    return said(text) + stop; // no formula after all
  }
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
  const concerned = words(entry.where, formulas);
  const where = place ? `<a href="#${place}">${concerned}</a>` : concerned;
  return (
    `<p class="reading"><span class="siglum" aria-hidden="true">${sigla[entry.kind]}</span> ` +
    `<span class="kind">${entry.kind}</span>${home} ` +
    `<span class="where">${where}</span>: ${what} <span class="has">` +
    `${words(entry.copy, formulas, ',')}</span> ${against} ` +
    `<span class="right">${words(entry.right, formulas, ';')}</span> ${words(entry.because, formulas, '.')} <span class="proof">` +
    `${!tried.passed ? verdict(false) : home ? '' : proof}</span></p>`
  );
}

const defaultOf = (p) =>
  escape(powers(String(p.default))) +
  (p.unit === '°' ? '°' : p.unit && ` ${escape(p.unit)}`);

/** What a section's program can be given: letter, default, range, meaning; on a live page the default is a field. */
export function parameters(section, live) {
  const { parameters: all } = section.told;
  if (!all.length) return '';
  const rows = all.map(
    (p) =>
      `<tr data-parameter="${p.name}"><th scope="row"><code class="whole">${p.name}</code></th>` +
      `<td${live ? ' class="field"' : ''}>${live ? field(p) : defaultOf(p)}</td>` +
      `<td class="word range">${escape(powers(p.range))}</td><td class="word">${said(p.meaning)}${
        p.default_at_most ? `; unless given, at most ${escape(p.default_at_most)}` : ''
      }</td></tr>`,
  );
  return (
    `<section class="parameters" data-program="${section.name}">\n` +
    `${table('What can be changed', ['letter', 'default', 'range', 'meaning'])}${rows.join('\n')}${tableEnd}</section>\n`
  );
}
