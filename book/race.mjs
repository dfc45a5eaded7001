// Draws a section's races, error against time, from what its program told and the run recorded in
// book/speeds. Usage: node race.mjs SOURCE BUILD PROGRAM GNUPLOT.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const [source, build, program, gnuplot] = process.argv.slice(2);
const json = (...file) => JSON.parse(fs.readFileSync(path.join(...file), 'utf8'));
const told = json(build, `told/${program}.json`);
const recorded = json(source, `book/speeds/${program}.json`);
const floor = 1e-17; // where an error of nothing is drawn

/** Those that no other beats both in time and in error, from the quickest to the most exact. */
const front = (points) =>
  [...points]
    .sort((a, b) => a.seconds - b.seconds || a.error - b.error)
    .filter((p, i, all) => all.slice(0, i).every((q) => q.error > p.error));

/** Heights at the right edge for the names, in the order of the errors, `apart` decades at least. */
function spread(points, apart) {
  const placed = [...points]
    .sort((a, b) => a.error - b.error || a.seconds - b.seconds)
    .map((p) => ({ ...p, height: Math.log10(p.error) }));
  placed.forEach((p, i) => {
    if (i && p.height < placed[i - 1].height + apart) p.height = placed[i - 1].height + apart;
  });
  return placed;
}

for (const race of told.races) {
  const times = recorded.races.find((r) => r.name === race.name)?.methods ?? [];
  const points = race.methods.flatMap((m) => {
    const time = times.find((t) => t.name === m.name);
    return time && Number.isFinite(m.relative)
      ? [{ name: m.name, family: m.family, seconds: time.seconds, error: Math.max(m.relative, floor) }]
      : [];
  });
  if (!points.length) continue;
  const families = [...new Set(points.map((p) => p.family).filter(Boolean))];
  const decades = (key, digits) => [
    Math.floor(Math.min(...points.map((p) => Math.log10(p[key]))) - digits),
    Math.ceil(Math.max(...points.map((p) => Math.log10(p[key]))) + digits),
  ];
  const [left, right] = decades('seconds', 0.05);
  const [low, high] = decades('error', 0.3);
  const rows = (list) =>
    list.map((p) => `${p.name}\t${p.seconds}\t${p.error}\t${10 ** (p.height ?? 0)}\n`).join('');
  const block = (list) => `name\tseconds\terror\theight\n${list}`;
  const labelled = spread(
    points.filter((p) => !p.family || p === points.findLast((q) => q.family === p.family)),
    (high - low) / 15,
  );
  const data = path.join(build, `told/${program}.race-${race.name}.tsv`);
  fs.writeFileSync(
    data,
    [
      ...[points, front(points), labelled].map(rows),
      families.map((f) => rows(points.filter((p) => p.family === f))).join('\n'),
    ]
      .map(block)
      .join('\n\n'),
  );
  const out = path.join(build, `drawn/${program}.race-${race.name}.svg`);
  fs.mkdirSync(path.dirname(out), { recursive: true });
  const run = spawnSync(
    gnuplot,
    [
      '-e',
      `data='${path.dirname(data)}'; race='${path.basename(data, '.tsv')}'; families=` +
      `${families.length}; left=1e${left}; right=1e${right}; low=1e${low}; high=1e${high}; out='${out}'`,
      'figures/race.gp',
    ],
    { cwd: source, encoding: 'utf8', env: { ...process.env, LC_ALL: 'C.UTF-8' } },
  );
  if (run.status !== 0 || run.stderr) throw new Error(`figures/race.gp: ${run.stderr}`);
}
fs.writeFileSync(path.join(build, `drawn/${program}.races`), '');
