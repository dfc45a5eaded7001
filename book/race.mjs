// Draws error against time: a section's races, from what its program told and the run recorded in book/speeds;
// for a part of the library, its scenes beside its peers, and of each group of scenes the worst errors side by side.
// Usage: node race.mjs SOURCE BUILD PROGRAM GNUPLOT.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { drawn, familyOf, fails, floor, front, groups, idOf, kindOf, plainly, recordedOf } from './scenes.mjs';

const [source, build, program, gnuplot] = process.argv.slice(2);
const json = (...file) => JSON.parse(fs.readFileSync(path.join(...file), 'utf8'));
const recorded = json(source, `book/speeds/${program}.json`);

/** A method's colour, as a linetype of figures/style.gp. */
const colour = { ours: 1, Euler: 2, classic: 3, peer: 7 };

const lines = (heads, rows) => [heads, ...rows].map((r) => `${r.join('\t')}\n`).join('');

/** Runs a script of figures/ on blocks of data; `set` is what else gnuplot is told before it. */
function draw(script, name, blocks, set) {
  const data = path.join(build, `told/${name}.tsv`);
  const out = path.join(build, `drawn/${name}.svg`);
  for (const file of [data, out]) fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(data, blocks.join('\n\n'));
  const settings = `data='${path.dirname(data)}'; source='${name}'; out='${out}'; ${set}`;
  const run = spawnSync(gnuplot, ['-e', settings, script], {
    cwd: source,
    encoding: 'utf8',
    env: { ...process.env, LC_ALL: 'C.UTF-8' },
  });
  if (run.status !== 0 || run.stderr) throw new Error(`${script}: ${run.stderr}`);
}

/**
 * Heights at the right edge for the names, in the order of the errors, `apart` decades at least; of errors that are
 * nearly the same, the slowest lowest, so that its line crosses no other.
 */
function spread(points, apart) {
  const step = (p) => Math.round(Math.log10(p.drawn) / apart);
  const placed = [...points]
    .sort((a, b) => step(a) - step(b) || b.seconds - a.seconds)
    .map((p) => ({ ...p, height: Math.log10(p.drawn) }));
  placed.forEach((p, i) => {
    if (i && p.height < placed[i - 1].height + apart) p.height = placed[i - 1].height + apart;
  });
  return placed;
}

/**
 * Error against time for `given` { name, family, kind, seconds, error }. Errors below `lowest` are drawn there, and the
 * plot says so; the data have them as they are.
 */
function race(name, given, quantity, lowest = 0) {
  if (!given.length) return;
  const points = given.map((p) => ({ ...p, drawn: Math.max(p.error, lowest) }));
  const families = [...new Set(points.map((p) => p.family).filter(Boolean))];
  const decades = (key, digits) => [
    Math.floor(Math.min(...points.map((p) => Math.log10(p[key]))) - digits),
    Math.ceil(Math.max(...points.map((p) => Math.log10(p[key]))) + digits),
  ];
  const [left, right] = decades('seconds', 0.05);
  const [low, high] = decades('drawn', 0.3);
  const named = points.filter((p) => !p.family || p === points.findLast((q) => q.family === p.family));
  // Below what is clipped there is room for the line that says so; at the right, for the longest name.
  const clipped = points.some((p) => p.error < lowest);
  const bottom = low - (clipped ? Math.ceil((high - low) * 0.06) : 0);
  const edge = Math.min(0.64, 1 - (12 + 7.4 * Math.max(...named.map((p) => p.name.length))) / 640);
  // Names that are spread may want a higher frame, in which they stand nearer again.
  let [top, labelled] = [high, []];
  for (let reached = top, tries = 0; tries < 4 && (reached > top || !tries); tries += 1) {
    top = reached;
    labelled = spread(named, (top - bottom) / Math.max(13, 1.1 * named.length));
    reached = Math.max(high, Math.ceil(Math.max(...labelled.map((p) => p.height)) + 0.3));
  }
  // Where the decades are narrow, every second or third has its number.
  const every = Math.ceil((56 * (right - left)) / (640 * edge - 80));
  const heads = ['name', 'seconds', 'error', 'drawn', 'height', 'colour'];
  const rows = (list) =>
    list.map((p) => [p.name, p.seconds, p.error, p.drawn, 10 ** (p.height ?? 0), colour[p.kind]]);
  const joined = families.map((f) => rows(points.filter((p) => p.family === f)).map((r) => r.join('\t')));
  draw(
    'figures/race.gp',
    name,
    [
      ...[points, front(points), labelled].map((list) => lines(heads, rows(list))),
      `${heads.join('\t')}\n${joined.map((f) => `${f.join('\n')}\n`).join('\n')}`,
    ],
    `quantity='${quantity}'; families=${families.length}; ` +
      `clipped=${clipped ? lowest : 0}; edge=${edge.toFixed(3)}; ` +
      `left=1e${left}; right=1e${right}; low=1e${bottom}; high=1e${top}; every=1e${every}`,
  );
}

/** The worst errors of a group of scenes, scene by scene; variants with the same errors are drawn as one. */
function errors(name, group) {
  const ways = new Map();
  group.scenes.forEach((scene, row) =>
    scene.methods.forEach((m) => {
      const label = familyOf(m.name) ?? m.name.replace(/, one by one$/, '');
      const way = ways.get(label) ?? { label, kind: m.kind, at: [] };
      way.at[row] = { row, error: fails(m) ? NaN : drawn(m) };
      ways.set(label, way);
    }),
  );
  const all = [...ways.values()];
  const others = all.filter((way) => way.kind !== 'ours');
  for (const way of all) way.colour = way.kind === 'ours' ? 1 : [7, 4, 3, 2, 5, 6][others.indexOf(way)];
  // Each name stands where its line is farthest from the others, and no two in one row.
  const clear = (way, p) =>
    Math.min(...all.filter((w) => w !== way).map((w) => Math.abs(Math.log10(w.at[p.row].error / p.error))));
  const taken = new Set();
  const place = (way) => {
    const best = way.at
      .filter((p) => !taken.has(p.row))
      .reduce((a, b) => (clear(way, b) > clear(way, a) ? b : a));
    taken.add(best.row);
    return best;
  };
  draw(
    'figures/errors.gp',
    name,
    [
      ...all.map((way) =>
        lines(
          ['scene', 'row', 'error', 'colour'],
          way.at.map((p) => [group.scenes[p.row].short, p.row, p.error, way.colour]),
        ),
      ),
      lines(
        ['name', 'row', 'error', 'colour'],
        all.map((way) => [way, place(way)]).map(([way, p]) => [way.label, p.row, p.error, way.colour]),
      ),
    ],
    `ways=${all.length}; rows=${group.scenes.length - 1}; unit='${group.scenes[0].error_unit}'`,
  );
}

if (recorded.scenes) {
  for (const scene of recorded.scenes)
    race(
      `${program}.race-${idOf(scene.name)}`,
      scene.methods
        .filter((m) => !fails(m))
        .map((m) => ({
          ...m,
          name: plainly(m.name),
          family: familyOf(m.name),
          error: drawn(m),
        })),
      scene.error_unit === '1' ? 'error' : `${scene.methods[0].error === undefined ? 'worst error' : 'error'} (${scene.error_unit})`,
    );
  for (const group of groups(recorded.scenes).filter((g) => g.scenes.length > 5))
    errors(`${program}.errors-${group.id}`, group);
} else {
  for (const one of json(build, `told/${program}.json`).races) {
    const times = recordedOf(recorded, one);
    const points = one.methods.flatMap((m) => {
      const time = times.find((t) => t.name === m.name);
      return time && Number.isFinite(m.relative)
        ? [{ ...m, kind: kindOf(m.name), seconds: time.seconds, error: m.relative }]
        : [];
    });
    race(`${program}.race-${one.name}`, points, 'relative error', floor);
  }
}
fs.writeFileSync(path.join(build, `drawn/${program}.races`), '');
