// The moving scenes: what a section's program declares as bodies, drawn at any time of the motion that it told. The weaver draws
// the still with this, the page's script the motion.

import { said } from '../escape.mjs';

const width = 640;
const margin = 12;

/** The rows of tab-separated data under their header, numbers all. */
export function rowsOf(tsv) {
  const [head, ...lines] = tsv.trimEnd().split('\n');
  const names = head.split('\t');
  return lines
    .filter((line) => line.trim())
    .map((line) => Object.fromEntries(line.split('\t').map((x, i) => [names[i], Number(x)])));
}

/** The state at time `t`, between the two frames that enclose it. */
export function stateAt(rows, t) {
  let [below, above] = [0, rows.length - 1];
  while (above - below > 1) {
    const middle = (below + above) >> 1;
    if (rows[middle].t <= t) below = middle;
    else above = middle;
  }
  const [a, b] = [rows[below], rows[above]];
  const part = b.t > a.t ? Math.min(Math.max((t - a.t) / (b.t - a.t), 0), 1) : 0;
  return Object.fromEntries(Object.keys(a).map((name) => [name, a[name] + part * (b[name] - a[name])]));
}

const value = (coordinate, row) => (typeof coordinate === 'number' ? coordinate : row[coordinate]);

/** All points that a body comes to, as [x, y] with the room it needs around them. */
function reach(body, rows) {
  const room = body.radius ?? 0;
  return body.at.flatMap(([x, y]) =>
    rows.flatMap((row) => [
      [value(x, row) - room, value(y, row) - room],
      [value(x, row) + room, value(y, row) + room],
    ]),
  );
}

/**
 * A scene ready to be drawn: `viewBox`, and for each body its `tag`, its `fixed` attributes, and `moving(row)`, those at a
 * state. `scene` is { bodies: [{ kind, at: [[x, y], ...], radius, turn, colour }] }, a coordinate a number or a column's name.
 */
export function stage(scene, rows) {
  const points = scene.bodies.filter((b) => b.kind !== 'ground').flatMap((b) => reach(b, rows));
  const range = (i) => points.reduce(([least, most], p) => [Math.min(least, p[i]), Math.max(most, p[i])], [Infinity, -Infinity]);
  const [[left, right], [low, high]] = [range(0), range(1)];
  const scale = (width - 2 * margin) / Math.max(right - left, (high - low) * 1.4);
  const height = Math.ceil((high - low) * scale + 2 * margin);
  const shift = (width - (right - left) * scale) / 2;
  const px = (x) => ((x - left) * scale + shift).toFixed(2);
  const py = (y) => ((high - y) * scale + margin).toFixed(2);
  const place = ([x, y], row) => `${px(value(x, row))},${py(value(y, row))}`;
  const shapes = {
    rod: (b) => ({
      tag: 'polyline',
      fixed: {},
      moving: (row) => ({ points: b.at.map((p) => place(p, row)).join(' ') }),
    }),
    trail: (b) => ({ tag: 'polyline', fixed: { points: rows.map((row) => place(b.at[0], row)).join(' ') } }),
    bob: (b) => ({
      tag: 'circle',
      fixed: { r: Math.max(b.radius * scale, 3).toFixed(2) },
      moving: (row) => ({ cx: px(value(b.at[0][0], row)), cy: py(value(b.at[0][1], row)) }),
    }),
    ground: (b) => ({ tag: 'path', fixed: { d: `M0,${py(b.at[0][1])}H${width}` } }),
    /** A wheel with a spoke to the angle `turn`, counted from the vertical down, clockwise. */
    wheel: (b) => {
      const r = b.radius * scale;
      return {
        tag: 'path',
        fixed: { d: `M${-r},0a${r},${r} 0 1 0 ${2 * r},0a${r},${r} 0 1 0 ${-2 * r},0M0,0V${r}` },
        moving: (row) => ({
          transform: `translate(${place(b.at[0], row)})rotate(${((value(b.turn, row) * 180) / Math.PI).toFixed(3)})`,
        }),
      };
    },
  };
  return {
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    bodies: scene.bodies.map((b) => {
      const { tag, fixed, moving } = shapes[b.kind](b);
      return {
        tag,
        fixed: { class: b.kind, style: `--body:var(--${b.colour ?? 'ink'})`, ...fixed },
        moving: moving ?? (() => ({})),
      };
    }),
  };
}

const written = (attributes) =>
  Object.entries(attributes)
    .map(([name, x]) => ` ${name}="${x}"`)
    .join('');

/** The still: the first frame as SVG, in the page's colours. */
export function still(scene, tsv, name, alt) {
  const rows = rowsOf(tsv);
  const { viewBox, width: w, height, bodies } = stage(scene, rows);
  const drawn = bodies.map(
    ({ tag, fixed, moving }) => `<${tag}${written({ ...fixed, ...moving(rows[0]) })}/>`,
  );
  return (
    `<svg width="${w}" height="${height}" viewBox="${viewBox}" role="img" aria-labelledby="${name}-title">` +
    `<title id="${name}-title">${said(alt)}</title>${drawn.join('')}</svg>\n`
  );
}

/** What the reader has in hand below a scene. */
export const controls =
  `<p class="controls"><button type="button" class="start" aria-pressed="false">start</button> ` +
  `<input type="range" class="time" min="0" max="1" step="0.001" value="0" aria-label="Time in the motion"> ` +
  `<output class="clock">0.00 s</output></p>\n`;

/**
 * The motion in a figure of the page that has a still and controls. `told()` gives a promise of [scene, tsv]. It moves in real
 * time while it is started and seen; where less motion is asked for, only by the slider.
 */
export class Moving {
  constructor(figure, told) {
    this.figure = figure;
    this.told = told;
    this.button = figure.querySelector('.start');
    this.slider = figure.querySelector('.time');
    this.clock = figure.querySelector('.clock');
    this.t = 0;
    this.wanted = false; // by the reader
    this.seen = true;
    this.calm = matchMedia('(prefers-reduced-motion: reduce)');
    this.button.addEventListener('click', () => this.want(!this.wanted));
    this.slider.addEventListener('input', async () => {
      this.want(false);
      await this.ready();
      if (this.rows) this.show(Number(this.slider.value) * this.end);
    });
    new IntersectionObserver(([entry]) => {
      this.seen = entry.isIntersecting;
      this.step();
    }).observe(figure);
    document.addEventListener('visibilitychange', () => this.step());
    this.calm.addEventListener('change', () => this.forbid());
    this.forbid();
  }

  /** No start where less motion is asked for. */
  forbid() {
    this.button.hidden = this.calm.matches;
    if (this.calm.matches) this.want(false);
  }

  /** Takes up the scene anew: the program has told something else. */
  async take() {
    const [scene, tsv] = await this.told();
    const svg = this.figure.querySelector('svg');
    svg.classList.toggle('absent', !scene);
    if (!scene) return; // these numbers have no motion that can be seen
    this.rows = rowsOf(tsv);
    this.end = this.rows.at(-1).t;
    const { viewBox, width: w, height, bodies } = stage(scene, this.rows);
    for (const [name, x] of Object.entries({ viewBox, width: w, height })) svg.setAttribute(name, x);
    const drawn = bodies.map(({ tag, fixed, moving }) => {
      const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
      for (const [name, x] of Object.entries(fixed)) element.setAttribute(name, x);
      return [element, moving];
    });
    svg.replaceChildren(svg.querySelector('title'), ...drawn.map(([element]) => element));
    this.bodies = drawn;
    this.show(Math.min(this.t, this.end));
  }

  async ready() {
    if (this.rows) return;
    this.taking ??= this.take().finally(() => {
      this.taking = null;
    });
    await this.taking;
  }

  async want(it) {
    this.wanted = it;
    this.button.setAttribute('aria-pressed', it);
    this.button.textContent = it ? 'stop' : 'start';
    if (!it) return;
    await this.ready();
    this.last = null;
    this.step();
  }

  step() {
    if (this.asked || !this.wanted || !this.seen || document.hidden || !this.rows) return;
    this.asked = requestAnimationFrame((now) => {
      this.asked = 0;
      if (!this.wanted || !this.seen) {
        this.last = null;
        return;
      }
      const passed = now - this.last; // a page that was away does not leap
      if (this.last && passed < 250) this.show((this.t + passed / 1000) % this.end);
      this.last = now;
      this.step();
    });
  }

  show(t) {
    this.t = t;
    const row = stateAt(this.rows, t);
    for (const [element, moving] of this.bodies)
      for (const [name, x] of Object.entries(moving(row))) element.setAttribute(name, x);
    this.slider.value = t / this.end;
    const text = `${t.toFixed(2)} s`;
    this.clock.value = text;
    this.slider.setAttribute('aria-valuetext', text);
  }
}
