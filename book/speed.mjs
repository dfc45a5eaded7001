// Speed against error: the ways to one number in a section, and the library against its peers.
import fs from 'node:fs';
import path from 'node:path';
import { table, tableEnd } from './claims.mjs';
import { asText, asTime, format } from './numbers.mjs';
import { escape, said } from './prose.mjs';
import { drawn, familyOf, fails, floor, front, groups, idOf, kindOf, plainly, recordedOf, worst } from './scenes.mjs';
import { lookedAt } from './sectionpage.mjs';

const short = (x, form) => asText(format({ value: x }, x !== 0 && (x < 1e-3 || x >= 1e5) ? 'e2' : form));
const worstShort = (m) => (fails(m) ? 'fails' : short(worst(m), '2'));

/** The scenes of all parts of the library, each with the part it is of. */
const scenesOf = (book) =>
  Object.entries(book.library).flatMap(([part, { scenes }]) => scenes.map((s) => ({ ...s, part })));

const recordedOn = (run) =>
  `Recorded on ${escape(run.machine)} with ${escape(run.compiler)}, ${escape(run.flags)}.`;

/** A plot that race.mjs has drawn, or nothing. */
function plot(book, name, alt, caption, script = 'race', page = null) {
  const drawn = fs.existsSync(path.join(book.build, `drawn/${name}.svg`));
  return drawn ? book.plot(name, `figures/${script}.gp`, alt, caption, page) : '';
}

/** Words with a capital, unless they begin with a letter that would be another one: τ is no T. */
const capital = (words) => (/^\p{Script=Latin}/u.test(words) ? words[0].toUpperCase() + words.slice(1) : words);
/** What a scene of the library asks for, as a caption begins: Carlson's letters have indices. */
const asked = (quantity) => said(capital(quantity)).replace(/\b(R)_([A-Z])\b/g, '<i>$1</i><sub>$2</sub>');
const list = (words) => (words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`);

/** What there is to see in a plot of error against time: what is not in it is not spoken of. */
function legend(points) {
  const families = [...new Set(points.map((p) => p.family).filter(Boolean))].filter(
    (f) => points.filter((p) => p.family === f).length > 1,
  );
  const colours = {
    ours: ['blue', 'this edition'],
    Euler: ['orange-red', 'Euler'],
    classic: ['green', 'a classical way'],
    peer: ['the colour of the letters', 'another way'],
  };
  const registers = (p) => /, (?:sse|avx|portable)\w*$/.test(p.name);
  const grows = (f) =>
    points.filter((p) => p.family === f).every(registers) ? 'wider and wider registers' : 'more and more terms or steps';
  const kinds = Object.keys(colours).filter((kind) => points.some((p) => p.kind === kind));
  return [
    'Left and low is better.',
    front(points).length > 1 ? 'The dashed steps join the ways that no other beats in both.' : '',
    families.length
      ? `${families.length === 1 ? 'The' : 'A'} solid line joins one way with ${list([...new Set(families.map(grows))])}.`
      : '',
    kinds.length > 1
      ? `${capital(list(kinds.map((kind, n) => colours[kind].join(n === 0 ? ' is ' : ' '))))}.`
      : '',
    points.some((p) => p.error < floor) ? 'What is nearer than 10⁻¹⁷ is drawn at 10⁻¹⁷.' : '',
  ]
    .filter(Boolean)
    .join(' ');
}

/** Two digits, and how far the rounds differ where that was recorded. */
const ratio = ({ ratio: r, spread }) =>
  `${short(r, '2')}${spread === undefined ? '' : ` ± ${Math.max(1, Math.round(100 * spread))} %`}`;

/**
 * The several ways to one number: error of each, and time and plot where a run is recorded in book/speeds.
 */
export function races(section, book, page) {
  return section.told.races
    .map((race) => {
      const recorded = recordedOf(section.speeds, race);
      const timed = (m) => recorded.find((r) => r.name === m.name);
      const rows = race.methods.map((m) => {
        const time = timed(m);
        const cells = [
          asText(format({ value: m.value, text: m.value.toPrecision?.(17) }, '17')),
          asText(format({ value: m.ulps }, '2')),
          asText(format({ value: m.relative }, 'e2')),
          ...(recorded.length ? [time ? asTime(time.seconds) : '', time ? ratio(time) : ''] : []),
        ];
        return (
          `<tr data-method="${escape(m.name)}"><th scope="row">${said(m.name)}</th>` +
          `${cells.map((c) => `<td>${c}</td>`).join('')}</tr>\n`
        );
      });
      const heads = [
        'way',
        'value',
        'error <span class="unit">ulp</span>',
        'relative error',
        ...(recorded.length ? ['time', 'ratio'] : []),
      ];
      const exact = asText(format({ value: Number(race.exact), text: race.exact }, '30'));
      const alt =
        `The ways to ${race.quantity}: relative error against time per evaluation, both logarithmic. ` +
        `The numbers stand in the table below.`;
      const points = race.methods
        .filter((m) => timed(m) && Number.isFinite(m.relative))
        .map((m) => ({ ...m, kind: kindOf(m.name), seconds: timed(m).seconds, error: m.relative }));
      const looked = lookedAt(section, race.name);
      return (
        `<div data-race="${race.name}"><p class="race">${said(race.quantity)} to thirty digits: ` +
        `<span class="digits">${exact}</span></p>\n` +
        `${plot(book, `${section.name}.race-${race.name}`, alt, `Error against time for one evaluation. ${legend(points)}`, 'race', page)}` +
        `${table(`Ways to ${escape(race.quantity)}`, heads)}${rows.join('')}${tableEnd}</div>` +
        `<p class="provenance">${looked && `The errors are looked at by ${looked}. `}${
          recorded.length
            ? `Times: ${recordedOn(section.speeds)} A ratio is the median, over the rounds, of a way’s time to that of ` +
              `the first; the errors are of this build. The library against its peers: ` +
              `<a href="speed.html">Speed against error</a>.`
            : ''
        }</p>\n`
      );
    })
    .join('');
}

/** All races of the sections, a line each: the quickest way, and the quickest that is right to two ulps. */
export function ofSections(book) {
  const inOrder = book.chapters.flatMap((c) => [...book.sections.values()].filter((s) => s.chapter === c.id));
  const rows = inOrder.flatMap((s) =>
    s.told.races.map((race) => {
      const times = recordedOf(s.speeds, race);
      const ways = race.methods
        .map((m) => ({ ...m, seconds: times.find((t) => t.name === m.name)?.seconds ?? Infinity }))
        .sort((a, b) => a.seconds - b.seconds || a.ulps - b.ulps);
      const cell = (m) =>
        m
          ? `<td class="word">${said(m.name)}<span class="below">${short(m.relative, '2')}` +
            `${Number.isFinite(m.seconds) ? `, ${asTime(m.seconds)}` : ''}</span></td>`
          : '<td class="word">none</td>';
      const chapter = book.chapters.find((c) => c.id === s.chapter).short;
      return (
        `<tr><th scope="row"><a href="${s.name}.html#speed-against-error">${escape(chapter)} §\u00a0` +
        `${Number(s.number)}</a></th><td class="word">${said(race.quantity)}</td><td>${ways.length}</td>` +
        `${cell(ways[0])}${cell(ways.find((m) => m.ulps <= 2))}</tr>\n`
      );
    }),
  );
  const heads = ['', 'number', 'ways', 'quickest of all', 'quickest right to 2 ulps'];
  return rows.length
    ? `${table('Races of the sections', heads)}${rows.join('')}${tableEnd}`
    : '<p>None yet.</p>';
}

/** A scene, a group or a method of the library's run, by its name or by the one that prose gives it. */
function find(list, name, what) {
  const found = list.find((x) => x.name === name || idOf(plainly(x.name)) === name);
  if (!found) throw new Error(`no ${what} ${name} (${list.map((x) => idOf(plainly(x.name))).join(', ')})`);
  return found;
}

/** `{{collected scene NAME}}`: one scene, plot and numbers. */
export function scene(book, name) {
  const it = find(scenesOf(book), name, 'scene');
  const points = it.methods
    .filter((m) => !fails(m))
    .map((m) => ({ ...m, family: familyOf(m.name), error: drawn(m) }));
  const alt = `${it.quantity}: worst error against time per evaluation, both logarithmic, for ${it.methods.length} ways.`;
  const unit = it.error_unit === '1' ? '' : ` <span class="unit">${it.error_unit}</span>`;
  const motions = it.methods.some((m) => m.error !== undefined);
  const [, of] = /, ([ζη] = .*)$/.exec(it.name) ?? []; // the amplitude, where the name alone has it
  const energy = it.methods.some((m) => m.energy !== undefined);
  const heads = [
    ...['way', 'time', 'ratio'],
    ...(motions ? [`error${unit}`, ...(energy ? ['energy'] : [])] : [`worst${unit}`, 'mean', 'fails']),
  ];
  const judged = (m) =>
    motions
      ? [worstShort(m), ...(energy ? [short(m.energy, '2')] : [])]
      : [
          worstShort(m),
          fails(m) ? '' : short(m.ulps_mean, '2'),
          m.failures ? `${m.failures} of ${m.judged}` : '',
        ];
  const rows = it.methods.map(
    (m) =>
      `<tr><th scope="row">${said(m.name)}</th>` +
      `${[asTime(m.seconds), short(m.ratio, '2'), ...judged(m)].map((c) => `<td>${c}</td>`).join('')}</tr>\n`,
  );
  return (
    `${plot(book, `${it.part}.race-${idOf(it.name)}`, alt, `${asked(it.quantity)}${of ? `, ${of}` : ''}. ${legend(points)}`)}` +
    `<details class="folded"><summary>the numbers of all ${it.methods.length}</summary>\n` +
    `${table(escape(it.name), heads)}${rows.join('')}${tableEnd}</details>\n`
  );
}

/** `{{collected errors GROUP}}`: the worst errors of a group of scenes, side by side. */
export function errors(book, name) {
  const group = find(groups(scenesOf(book)), name, 'group of scenes');
  const alt = `${group.name}: the worst error of each way in ${group.scenes.length} scenes, logarithmic.`;
  return plot(
    book,
    `${group.scenes[0].part}.errors-${group.id}`,
    alt,
    `${asked(group.scenes[0].quantity)}: the worst errors, in ${escape(group.scenes[0].error_unit)}, scene by scene.`,
    'errors',
  );
}

/** `{{collected scenes GROUP}}`: the numbers of a group of scenes, worst error above time. */
export function scenes(book, name) {
  const group = find(groups(scenesOf(book)), name, 'group of scenes');
  const rows = group.scenes[0].methods.map((first) => {
    const cells = group.scenes.map((s) => {
      const m = find(s.methods, first.name, 'method');
      return `<td>${worstShort(m)}<span class="below">${asTime(m.seconds)}</span></td>`;
    });
    return `<tr><th scope="row">${said(first.name)}</th>${cells.join('')}</tr>\n`;
  });
  const unit = group.scenes[0].error_unit;
  const heads = [
    `worst error${unit === '1' ? '' : ` <span class="unit">${unit}</span>`}, time`,
    ...group.scenes.map((s) => `<span class="scene">${escape(s.short.replace(/ (?==)|(?<==) | (?=[ak]$)/g, '\u00a0'))}</span>`),
  ];
  return `${table(escape(group.name), heads, ' tight', asked(group.name))}${rows.join('')}${tableEnd}`;
}

/** `{{collected provenance PART}}`: on what the run of a part of the library was recorded. */
export function provenance(book, part) {
  if (!book.library[part]) throw new Error(`no run ${part} (${Object.keys(book.library).join(', ')})`);
  return `<p class="provenance">${recordedOn(book.library[part])}</p>\n`;
}

/**
 * A recorded number by its name in prose, speed.SCENE.METHOD.WHAT: `faster`, how many times as fast as the scene's
 * peer; `worst`, the worst error; `ns` or `ms`, the time of one evaluation; `energy`, what a motion adds to its energy or
 * loses of it; `fails`, the share of arguments it fails at. Of
 * a group of scenes it is the least favourable.
 */
export function value(book, name) {
  const [, where, method, what] = name.split('.');
  const all = scenesOf(book);
  const group = groups(all).find((g) => g.id === where)?.scenes ?? [find(all, where, 'scene')];
  const found = group.map((scene) => find(scene.methods, method ?? '', 'method'));
  const meanings = {
    faster: [(m) => 1 / m.ratio, `how many times as fast as ${group[0].peer}`, Math.min],
    worst: [worst, `worst error, ${group[0].error_unit}`, Math.max],
    ns: [(m) => m.seconds * 1e9, 'nanoseconds for one evaluation', Math.max],
    ms: [(m) => m.seconds * 1e3, 'milliseconds for one evaluation', Math.max],
    energy: [(m) => Math.abs(m.energy), 'relative error of the energy', Math.max],
    fails: [(m) => m.failures / m.judged, 'share of the arguments at which it gives no number', Math.max],
  };
  if (!meanings[what]) throw new Error(`{{${name}}} ends in none of ${Object.keys(meanings).join(', ')}`);
  const [number, meaning, least] = meanings[what];
  return { value: least(...found.map(number)), unit: '', meaning: `${method}: ${meaning}`, full: name };
}
