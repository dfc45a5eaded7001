// How a told number is written in prose, in mathematics and in tables. Rounding is done on the decimal digits
// as told, so that fifty digits stay fifty and nothing is rounded twice. A number is ± digits · 10^-places,
// the digits a BigInt.

function decimal(text) {
  const parts = /^([+-]?)(\d+)\.?(\d*)(?:e([+-]?\d+))?$/i.exec(text);
  return (
    parts && {
      negative: parts[1] === '-',
      digits: BigInt(parts[2] + parts[3]),
      places: parts[3].length - Number(parts[4] ?? 0),
    }
  );
}

/** The number with `places` decimals, rounded half away from zero. */
function toPlaces({ negative, digits, places: have }, places) {
  if (places >= have) return { negative, digits: digits * 10n ** BigInt(places - have), places };
  const unit = 10n ** BigInt(have - places);
  return { negative, digits: (digits + unit / 2n) / unit, places };
}

/** The number with `count` significant digits. */
function toDigits(number, count) {
  if (number.digits === 0n) return { ...number, places: 0 };
  const places = (n) => count - (String(n.digits).length - n.places);
  const once = toPlaces(number, places(number));
  return toPlaces(once, places(once)); // 9.99 became 10.0
}

function withoutTrailingZeros({ negative, digits, places }) {
  while (digits !== 0n && digits % 10n === 0n) {
    digits /= 10n;
    places -= 1;
  }
  return { negative, digits, places };
}

function plain({ digits, places }) {
  if (places <= 0) return String(digits * 10n ** BigInt(-places));
  const all = String(digits).padStart(places + 1, '0');
  return `${all.slice(0, -places)}.${all.slice(-places)}`;
}

/**
 * A told value {value, unit, text?} under a format: '' (six digits), '8' (digits), 'f5' (decimals), 'e3'
 * (digits and a power of ten), 'percent2', 'deg1' (decimals). Gives { word } or { sign, digits, power, suffix
 * }; null for another format.
 */
export function format(told, spec = '') {
  const form = /^(f|e|percent|deg)?(\d*)$/.exec(spec);
  if (!form) return null;
  const [, kind, count] = form;
  const fixed = ['f', 'percent', 'deg'].includes(kind);
  const suffix = { percent: '%', deg: '°' }[kind] ?? (['°', '%'].includes(told.unit) ? told.unit : '');
  const scale = suffix === told.unit ? 1 : ({ percent: 100, deg: 180 / Math.PI }[kind] ?? 1);
  const source = scale === 1 ? (told.text ?? String(told.value)) : String(told.value * scale);
  const exact = decimal(source);
  if (!exact) return { word: { inf: '∞', '-inf': '−∞' }[source] ?? source };
  const number = fixed
    ? toPlaces(exact, Number(count || 1))
    : kind === 'e'
      ? toDigits(exact, Number(count || 3))
      : count
        ? toDigits(exact, Number(count))
        : Number.isInteger(told.value) && Math.abs(told.value) < 1e15
          ? toPlaces(exact, 0)
          : withoutTrailingZeros(toDigits(exact, 6));
  const sign = number.negative && number.digits !== 0n ? '−' : '';
  const length = String(number.digits).length;
  const power = length - number.places - 1; // that of the first digit
  const far =
    kind === 'e' ||
    (!fixed &&
      number.digits !== 0n &&
      (power < -4 || power >= Math.max(length, Number.isInteger(told.value) ? 15 : 6)));
  return far
    ? { sign, digits: plain({ ...number, places: length - 1 }), power, suffix }
    : { sign, digits: plain(number), suffix };
}

/** Whether a value may be written in a format: degrees are for angles, percentages for ratios. */
export function fits({ unit = '', value }, spec = '') {
  if (/^deg/.test(spec)) return ['°', 'rad'].includes(unit);
  if (/^percent/.test(spec)) return ['', '%'].includes(unit) && !Number.isInteger(value);
  return true;
}
fits.wants = (spec) => (/^deg/.test(spec) ? 'angles, in degrees or radians' : 'ratios');

/** What a line of prose has of code, links and told values is no prose. */
const aside = /`[^`]*`|\{\{[^{}]*\}\}|\]\([^)]*\)|\\tag\{[^}]*\}/g;

/**
 * The numbers typed in a line that a program tells with the same digits, three at least: [[typed, name]]. Euler's have
 * a comma and are his.
 */
export function handTyped(line, values) {
  const bare = line.replace(aside, (s) => ' '.repeat(s.length));
  return [...bare.matchAll(/(?<![\w.,{}^§])(\d+\.\d+|\d{4,})(?![\w.]*\d|\{?,\}?\d)/g)].flatMap(([, typed]) => {
    const number = decimal(typed);
    const figures = typed.replace('.', '').replace(/^0+/, '').length;
    if (figures < 3) return [];
    const same = values.find((v) => {
      const told = decimal(v.text ?? String(v.value));
      if (!told) return false;
      const rounded = toPlaces(told, number.places);
      return rounded.digits === number.digits && (number.places || told.places <= 0);
    });
    return same ? [[typed, same.name]] : [];
  });
}

const raised = (power) => `10${String(power).replace(/./g, (c) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] ?? '⁻')}`;

export function asText({ word, sign, digits, power, suffix = '' }) {
  if (word !== undefined) return word;
  return sign + digits + (power === undefined ? '' : ` × ${raised(power)}`) + (suffix === '%' ? ' %' : suffix);
}

/** Numbers as a program writes them, among words, as the book writes them: 1e-07 is 10⁻⁷, 2.5e+30 is 2.5 × 10³⁰, 1000000 is 10⁶. */
export const powers = (words) =>
  words.replace(/(?<![\w.^-])(-?)(\d+(?:\.\d+)?)(?:e([+-]?\d+))?(?![\w.])/g, (_, minus, mantissa, exponent) => {
    const noughts = exponent === undefined ? (/^[1-9]\d*?(0{6,})$/.exec(mantissa)?.[1].length ?? 0) : 0;
    const power = Number(exponent ?? noughts);
    const digits = noughts ? mantissa.slice(0, -noughts) : mantissa;
    const sign = minus && '−';
    return digits === '1' && power ? sign + raised(power) : asText({ sign, digits, power: power || undefined });
  });

export function asTeX({ word, sign, digits, power, suffix }) {
  if (word !== undefined) return { '∞': '\\infty', '−∞': '-\\infty' }[word] ?? `\\text{${word}}`;
  const unit = { '%': '\\,\\%', '°': '^\\circ' }[suffix] ?? '';
  return sign.replace('−', '-') + digits + (power === undefined ? '' : `\\times10^{${power}}`) + unit;
}

/** A time in seconds, with the prefix that suits it. */
export function asTime(seconds) {
  const [scale, unit] = [
    [1e-9, 'ns'],
    [1e-6, 'µs'],
    [1e-3, 'ms'],
    [1, 's'],
  ].find(([s]) => seconds < 1000 * s) ?? [1, 's'];
  return `${Number((seconds / scale).toPrecision(3))} ${unit}`;
}
