// Three settings that a hand can reach by the sliders, each of another parameter where there are so many.
import { slider, typed } from '../../book/live/fields.mjs';

const places = [0.3, 0.62, 0.85];

/** For the parameters as a program declares them: [{ name: text }, ...]; empty where there is nothing to slide. */
export function settings(parameters) {
  const sliding = parameters.filter((p) => slider(p));
  return sliding.length
    ? places.map((part, i) => {
        const p = sliding[i % sliding.length];
        const { min, max, step, number } = slider(p);
        return { [p.name]: typed(number(min + Math.round(((max - min) * part) / step) * step)) };
      })
    : [];
}
