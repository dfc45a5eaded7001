// The edition's standing forms: the verdict of a check, its claims, an entry of the apparatus, a race.
import fs from 'node:fs';
import path from 'node:path';
import { asText, asTime, format } from './numbers.mjs';
import { inline } from './figure.mjs';
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
export const table = (label, heads) =>
  `<div class="table broad" tabindex="0" role="group" aria-label="${label}"><table><thead><tr>` +
  `${heads.map((h) => `<th scope="col">${h}</th>`).join('')}</tr></thead>\n<tbody>\n`;
export const tableEnd = '</tbody></table></div>\n';

const provenance = (run) =>
  `<p class="provenance">Recorded on ${escape(run.machine)} with ${escape(run.compiler)}, ` +
  `${escape(run.flags)}.` +
  ' The errors are of this build.</p>\n';

/**
 * The several ways to one number: error of each, and time and plot where a run is recorded in book/speeds.
 */
export function races(section, book) {
  return section.told.races
    .map((race) => {
      const recorded = section.speeds?.races.find((r) => r.name === race.name)?.methods ?? [];
      const rows = race.methods.map((m) => {
        const time = recorded.find((r) => r.name === m.name);
        const cells = [
          asText(format({ value: m.value }, '17')),
          asText(format({ value: m.ulps }, '2')),
          asText(format({ value: m.relative }, 'e2')),
          ...(recorded.length
            ? [time ? asTime(time.seconds) : '', time ? asText(format({ value: time.ratio }, '3')) : '']
            : []),
        ];
        return `<tr><th scope="row">${escape(m.name)}</th>${cells.map((c) => `<td>${c}</td>`).join('')}` +
        `</tr>\n`;
      });
      const heads = [
        'way',
        'value',
        'error <span class="unit">ulp</span>',
        'relative error',
        ...(recorded.length ? ['time', 'ratio'] : []),
      ];
      const drawn = path.join(book.build, `drawn/${section.name}.race-${race.name}.svg`);
      const alt = `The ways to ` +
      `${race.quantity}: relative error against time per evaluation, both logarithmic. The numbers stand ` +
      `in the table below.`;
      const plot =
        book.plots !== false && recorded.length && fs.existsSync(drawn)
          ? `<figure>\n` +
          inline(fs.readFileSync(drawn, 'utf8'), `${section.name}-race-${race.name}`, alt, book.colours) +
            '<figcaption>Error against time for one evaluation. Left and low is better; the grey steps ' +
            'join the ways that no other beats in both.</figcaption></figure>\n'
          : '';
      return (
        `<p class="race">${escape(race.quantity)}, exactly <data>${escape(race.exact)}</data></p>\n${plot}` +
        `${table(`Ways to ${escape(race.quantity)}`, heads)}${rows.join('')}${tableEnd}` +
        `${recorded.length ? provenance(section.speeds) : ''}`
      );
    })
    .join('');
}

/** The recorded comparison of the library with its peers. */
export function scenes(run) {
  return (
    run.scenes
      .map(
        (scene) =>
          `<h3>${escape(scene.name)}</h3>\n<p>${escape(scene.quantity)}</p>\n` +
          table(escape(scene.name), [
            'way',
            'time',
            'ratio',
            'worst <span class="unit">ulp</span>',
            'mean <span class="unit">ulp</span>',
          ]) +
          scene.methods
            .map(
              (m) =>
                `<tr><th scope="row">${escape(m.name)}</th><td>${asTime(m.seconds)}</td>` +
                `${[
                  [m.ratio, '3'],
                  [m.ulps_max, '2'],
                  [m.ulps_mean, '2'],
                ]
                  .map(([x, f]) => `<td>${asText(format({ value: x }, f))}</td>`)
                  .join('')}</tr>\n`,
            )
            .join('') +
          tableEnd,
      )
      .join('') + provenance(run).replace(' The errors are of this build.', '')
  );
}
