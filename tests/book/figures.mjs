// Every figure at three settings of its section's parameters: gnuplot has nothing to say, no curve leaves its frame that stays in
// it with Euler's numbers, no label leaves the drawing, none the curve whose colour it has, and every upright axis has its name
// (gnuplot leaves it out, silently, where a margin has no room for it). Usage: node figures.mjs BUILD GNUPLOT [FIGURE...]
// (build/book, beside which lie the programs in bin; run in the repository's folder)
import { execFile } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { promisify } from 'node:util';
import { settings } from './settings.mjs';

const [build, gnuplot, ...only] = process.argv.slice(2);
const run = promisify(execFile);
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'figures-'));
process.on('exit', () => fs.rmSync(scratch, { recursive: true }));
const programs = fs.readFileSync(path.join(build, 'programs.txt'), 'utf8').split('\n').filter(Boolean);

// How far a label may be from its curve, in the drawing's units of 1/640 of its width, and how much farther than with Euler's
// numbers; how much of the frame's side a curve may lie beyond it, since what is clipped by a hair is not seen.
const near = 45;
const farther = 25;
const beyond = 0.02;

const numbers = /-?\d+(?:\.\d+)?/g;
const colour = (text) => text.match(/\d+/g).join();
const plain = ['31,27,22', '107,102,94', '0,0,0']; // ink, grey, black: letters and constructions

/** The texts with their boxes, and what is drawn, by colour. */
function parts(svg) {
  const drawn = {};
  const put = (of, points) => (drawn[colour(of)] ??= []).push(points);
  for (const [, stroke, d] of svg.matchAll(/<path stroke='rgb\(([^)]*)\)'(?![^>]*gridline)[^>]*d='([^']*)'/g))
    for (const piece of d.split('M').slice(1)) {
      const xy = piece.match(numbers)?.map(Number) ?? [];
      put(stroke, Array.from({ length: xy.length >> 1 }, (_, i) => [xy[2 * i], xy[2 * i + 1]]));
    }
  for (const [, x, y, of] of svg.matchAll(/<use [^>]*translate\(([-\d.]+),([-\d.]+)\)[^>]*color='rgb\(([^)]*)\)'/g))
    put(of, [[Number(x), Number(y)]]);
  for (const [, of, points] of svg.matchAll(/<polygon fill\s*=\s*'rgb\(([^)]*)\)'[^>]*points\s*=\s*'([^']*)'/g)) {
    const xy = points.match(numbers).map(Number);
    put(of, Array.from({ length: xy.length >> 1 }, (_, i) => [xy[2 * i], xy[2 * i + 1]]));
  }
  const texts = [];
  for (const [, x, y, turned, fill, size, anchor, inner] of svg.matchAll(
    /<g transform="translate\(([-\d.]+),([-\d.]+)\)( rotate[^"]*)?"[^>]*fill="rgb\(([^)]*)\)"[^>]*font-size="([\d.]+)"\s+text-anchor="(\w+)">\s*<text>(.*?)<\/text>/gs,
  )) {
    const text = inner.replace(/<[^>]*>/g, '').replace(/&\w+;/g, '·').trim();
    if (turned || !text) continue;
    const width = 0.42 * Number(size) * text.length;
    const left = Number(x) - { start: 0, middle: width / 2, end: width }[anchor];
    texts.push({ text, fill: colour(fill), box: [left, Number(y) - 0.7 * size, left + width, Number(y) + 0.2 * size] });
  }
  return { drawn, texts };
}

/** From a box to a line, the least distance; 0 where they meet. */
function distance([left, top, right, bottom], points) {
  const from = ([x, y]) => Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));
  let least = Infinity;
  points.forEach((b, i) => {
    const a = points[Math.max(i - 1, 0)];
    const pieces = Math.max(1, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / 4));
    for (let k = 0; k <= pieces; k += 1)
      least = Math.min(least, from([a[0] + ((b[0] - a[0]) * k) / pieces, a[1] + ((b[1] - a[1]) * k) / pieces]));
  });
  return least;
}

/** How far a drawing's parts lie off: { frame: shares of its sides, labels: [{ text, off, out }] }. */
async function drawing(figure, data) {
  const out = path.join(scratch, `${figure}-${path.basename(data)}.svg`);
  const script = `figures/${figure}.gp`;
  const print = 'print GPVAL_X_MIN, GPVAL_X_MAX, GPVAL_Y_MIN, GPVAL_Y_MAX';
  const again = `set print '-'; ${print}; unset output; set output '/dev/null'; set autoscale xy; replot; ${print.replaceAll('GPVAL_X_M', 'GPVAL_DATA_X_M').replaceAll('GPVAL_Y_M', 'GPVAL_DATA_Y_M')}`;
  const words = fs.readFileSync(script, 'utf8');
  const multiple = /multiplot/.test(words);
  const logarithmic = [...words.matchAll(/^\s*set log(?:scale)?\b *(\w*)/gm)].map(([, axes]) => axes || 'xy').join('');
  const { stdout, stderr } = await run(gnuplot, ['-e', `data='${data}'; out='${out}'`, script, ...(multiple ? [] : ['-e', again])], {
    env: { ...process.env, LC_ALL: 'C.UTF-8' },
  });
  const svg = fs.readFileSync(out, 'utf8');
  const [frame, all] = stdout.trim().split('\n').map((line) => line.split(' ').map(Number));
  const off = [0, 0];
  if (!multiple)
    for (const axis of [0, 1]) {
      const as = (x) => (logarithmic.includes('xy'[axis]) ? Math.log(x) : x);
      const [lo, hi] = frame.slice(2 * axis, 2 * axis + 2).map(as);
      const [least, most] = all.slice(2 * axis, 2 * axis + 2).map(as);
      const share = Math.max((Math.min(lo, hi) - least) / Math.abs(hi - lo), (most - Math.max(lo, hi)) / Math.abs(hi - lo));
      off[axis] = Math.max(share, 0);
    }
  const [width, height] = svg.match(/viewBox="0 0 (\d+) (\d+)"/).slice(1).map(Number);
  const { drawn, texts } = parts(svg);
  return {
    said: stderr.trim(),
    nameless: (words.match(/^\s*set ylabel "[^"]/gm) ?? []).length - (svg.match(/ rotate\(270\)/g) ?? []).length,
    frame: off,
    labels: texts.map(({ text, fill, box }) => ({
      text,
      fill,
      off: plain.includes(fill) ? 0 : Math.min(...(drawn[fill] ?? []).map((points) => distance(box, points))),
      out: Math.max(-box[0], -box[1], box[2] - width, box[3] - height, 0),
    })),
  };
}

let faults = 0;
function fault(what) {
  faults += 1;
  console.error(what);
}
let [figures, drawings] = [0, 0];
async function tryFigures(program) {
  const own = fs
    .readdirSync('figures')
    .filter((f) => f.startsWith(program) && f.endsWith('.gp'))
    .map((f) => f.slice(0, -3))
    .filter((f) => !only.length || only.includes(f));
  if (!own.length) return;
  const told = path.join(build, 'told');
  const usual = {};
  for (const figure of own) {
    usual[figure] = await drawing(figure, told);
    if (usual[figure].nameless > 0) fault(`${figure}: the name of an upright axis is left out`);
  }
  figures += own.length;
  const { parameters } = JSON.parse(fs.readFileSync(path.join(told, `${program}.json`), 'utf8'));
  for (const given of settings(parameters)) {
    const options = Object.entries(given).flatMap(([name, text]) => [`--${name}`, text]);
    const data = path.join(scratch, `${program}${options.join('')}`);
    try {
      await run(path.join(build, '../bin', program), [...options, '--data', data]);
    } catch (refusal) {
      if (refusal.code !== 2) throw refusal;
      continue;
    }
    for (const figure of own) {
      const where = `${figure} with ${options.join(' ')}`;
      drawings += 1;
      let now;
      try {
        now = await drawing(figure, data);
      } catch (error) {
        fault(`${where}: ${String(error.stderr ?? error.message).trim().split('\n').pop()}`);
        continue;
      }
      if (now.nameless > usual[figure].nameless) fault(`${where}: the name of an upright axis is left out`);
      if (now.said) fault(`${where}: gnuplot says ${now.said.split('\n').pop()}`);
      now.frame.forEach((share, axis) => {
        if (!(share <= usual[figure].frame[axis] + beyond))
          fault(`${where}: a curve leaves its frame by ${(100 * share).toFixed(0)} % in ${'xy'[axis]}`);
      });
      const worst = (of, what) => Math.max(0, ...usual[figure].labels.filter((l) => l.fill === of).map((l) => l[what]));
      for (const { text, fill, off, out } of now.labels) {
        if (off > Math.max(near, worst(fill, 'off') + farther))
          fault(`${where}: the label "${text}" is ${off === Infinity ? 'without' : `${off.toFixed(0)} from`} its curve`);
        if (out > worst(fill, 'out') + 4) fault(`${where}: the label "${text}" leaves the drawing by ${out.toFixed(0)}`);
      }
    }
  }
}

const left = [...programs];
await Promise.all(
  Array.from({ length: os.cpus().length }, async () => {
    while (left.length) await tryFigures(left.shift());
  }),
);
// The plots of error against time stand as the book has them: no name of a method leaves the drawing, no note lies on an axis,
// no two words on each other.
let races = 0;
if (!only.length)
  for (const name of fs.readdirSync(path.join(build, 'drawn')).filter((f) => /\.race-.*\.svg$/.test(f))) {
    races += 1;
    const svg = fs.readFileSync(path.join(build, 'drawn', name), 'utf8');
    const [width, height] = svg.match(/viewBox="0 0 (\d+) (\d+)"/).slice(1).map(Number);
    const { drawn, texts } = parts(svg);
    const axis = Math.max(...(drawn[plain[0]] ?? []).flat().map(([, y]) => y)); // the lowest that is drawn in ink
    for (const { text, box } of texts) {
      const out = Math.max(-box[0], -box[1], box[2] - width, box[3] - height, 0);
      if (out > 4) fault(`${name}: "${text}" leaves the drawing by ${out.toFixed(0)}`);
      if (box[1] < axis - 6 && box[3] > axis - 2 && text.startsWith('what'))
        fault(`${name}: "${text}" lies on the axis`);
    }
    texts.forEach(({ text, box }, i) => {
      for (const other of texts.slice(i + 1)) {
        const [across, down] = [0, 1].map((k) => Math.min(box[k + 2], other.box[k + 2]) - Math.max(box[k], other.box[k]));
        if (across > 4 && down > 3) fault(`${name}: "${text}" and "${other.text}" lie on each other`);
      }
    });
  }
console.log(`${figures} figures, ${races} plots of speed, ${drawings} drawings with other numbers; ${faults} faults`);
process.exitCode = faults || !drawings ? 1 : 0;
