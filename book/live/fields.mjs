// The fields and sliders by which a reader changes a section's parameters: their HTML, which the weaver puts on the page, and
// what a slider's places mean.

import { escape } from '../escape.mjs';

const greek = {
  alpha: 'α',
  beta: 'β',
  gamma: 'γ',
  delta: 'δ',
  epsilon: 'ε',
  zeta: 'ζ',
  eta: 'η',
  theta: 'θ',
  iota: 'ι',
  kappa: 'κ',
  lambda: 'λ',
  mu: 'μ',
  nu: 'ν',
  xi: 'ξ',
  rho: 'ρ',
  sigma: 'σ',
  tau: 'τ',
  phi: 'φ',
  chi: 'χ',
  psi: 'ψ',
  omega: 'ω',
};

/** A parameter's name as its letter: zeta is ζ. */
export const letter = (name) => greek[name] ?? name;

/** A number as a reader would type it; with a unit, as the page says it. */
export const typed = (x) => String(x).replace(/e\+/, 'e');
export const withUnit = (number, unit) => (unit === '°' ? `${number}°` : unit ? `${number} ${unit}` : number);

const decades = 300; // as far as a slider of a small quantity goes down
const steps = 400;

/** The step 1, 2 or 5 · 10^n that divides `length` into about `steps`. */
function niceStep(length) {
  const raw = length / steps;
  const power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].find((n) => n * power >= raw * 0.999) * power;
}

/** A slider whose places are the powers of ten between two numbers. */
function logarithmic(bottom, top, whole, below) {
  const [min, max] = [Math.log10(bottom), Math.log10(top)];
  const number = (place) => {
    const x = Math.min(Math.max(Number((10 ** Number(place)).toPrecision(3)), bottom), top);
    if (whole) return Math.round(x);
    return below && x >= top ? Number((top * 0.999).toPrecision(3)) : x;
  };
  return { min, max, step: (max - min) / steps, place: (x) => Math.log10(Math.max(x, bottom)), number };
}

/**
 * The slider of a parameter: { min, max, step, place(number), number(place) }; null where a hand can slide nothing. The angle
 * from the top goes down to 1e-300; of a range wider than a hand can tell apart it shows ten times less and ten times more.
 */
export function slider({ name, kind, default: usual, lo, hi, lo_open: above, hi_open: below, log }) {
  const [low, high] = [Number(lo), Number(hi)];
  const whole = kind === 'integer';
  if (name === 'eta' && kind === 'angle')
    return logarithmic(Math.max(low, 10 ** -decades), high, false, below);
  if (whole && high - low > 1000) return logarithmic(Math.max(low, 1), high, true, false);
  if (!Number.isFinite(high - low) || high - low > 1e6 * Math.abs(usual))
    return usual > 0 ? logarithmic(usual / 10, usual * 10, false, false) : null;
  if (log && kind !== 'angle') return logarithmic(low > 0 ? low : high / 1e6, high, false, below);
  const step = whole ? 1 : niceStep(high - low);
  const fraction = Math.max(0, -Math.floor(Math.log10(step)));
  const number = (place) => {
    const x = Number(Number(place).toFixed(fraction));
    if (above && x <= low) return Number((low + step).toFixed(fraction));
    return below && x >= high ? Number((high - step).toFixed(fraction)) : x;
  };
  return { min: low, max: high, step, place: (x) => x, number };
}

/** The field of a parameter, with its slider below it, both at the default. */
export function field(p) {
  const slides = slider(p);
  const name = escape(`${letter(p.name)}, ${p.meaning}${p.unit ? `, in ${p.unit}` : ''}`);
  const usual = typed(p.default);
  const input =
    `<input type="text"${usual.length > 14 ? ' class="long"' : ''} name="${p.name}" value="${usual}" size="9" inputmode="decimal" autocomplete="off" ` +
    `spellcheck="false" aria-label="${name}">`;
  if (!slides) return withUnit(input, p.unit);
  return (
    `${withUnit(input, p.unit)}<input type="range" data-slides="${p.name}" min="${slides.min}" max="${slides.max}" ` +
    `step="${slides.step}" value="${slides.place(p.default)}" autocomplete="off" aria-label="${name}">`
  );
}
