// The readings of the apparatus are plain words, for a terminal. Where such words are a formula, they are set as one:
// here they become TeX.

const functions = { sin: '\\sin', cos: '\\cos', tan: '\\tan', cot: '\\cot', log: '\\log', ln: '\\ln', tg: '\\operatorname{tg}', tang: '\\operatorname{tang}' };
const signs = {
  '−': '-', '·': '\\cdot ', '×': '\\times ', '±': '\\pm ', '∓': '\\mp ', '≈': '\\approx ', '≤': '\\le ', '≥': '\\ge ', '…': '\\dots ',
  '∫': '\\int ', '∞': '\\infty ', '′': "'", '°': '^\\circ ', '+': '+', '=': '=', '<': '<', '>': '>', '(': '(', ')': ')',
  '[': '[', ']': ']', '/': '/', ':': ':', ',': ',\\; ', ';': ';\\; ', '*': '^*',
}; // prettier-ignore
const fractions = { '½': '\\tfrac12 ', '⅓': '\\tfrac13 ', '⅔': '\\tfrac23 ', '¼': '\\tfrac14 ', '¾': '\\tfrac34 ', '⅛': '\\tfrac18 ', '⅜': '\\tfrac38 ', '⅝': '\\tfrac58 ', '⅞': '\\tfrac78 ' };
const raised = '⁰¹²³⁴⁵⁶⁷⁸⁹';
const lowered = '₀₁₂₃₄₅₆₇₈₉';
// Words of four letters and more are English unless they have a square of Euler's, aa or kk.
const english =
  /^(an|as|at|be|by|he|if|in|is|it|no|of|on|or|so|to|up|we|all|and|but|for|its|not|one|out|the|too|two|(?!.*(aa|kk))(\p{L}{5,}|[a-z]{4}))$/u;

const small = (text, digits, minus, plus) =>
  [...text].map((c) => (c === minus ? '-' : c === plus ? '+' : c === 'ⁿ' ? 'n' : digits.indexOf(c))).join('');

const tokens =
  /(?<space>\s+)|(?<number>\d+(?:[,.]\d+)?)|(?<up>[⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ]+)|(?<down>[₀₁₂₃₄₅₆₇₈₉]+)|(?<word>[A-Za-z]{2,})|(?<letter>\p{L})|(?<root>√)|(?<sign>.)/uy;

const differential = /^(?:d{1,2}|∂{1,2})\p{L}(?!\p{L})/u;

/** TeX for words that are a formula; null for words that are words. */
export function texOf(text) {
  let out = '';
  tokens.lastIndex = 0;
  const roots = []; // depths of parentheses at which a root ends
  let depth = 0;
  let pending = false; // a root waits for what it covers
  for (let match = tokens.exec(text); match; match = tokens.exec(text)) {
    const { space, number, up, down, word, letter, root, sign } = match.groups;
    const covered = (tex) => {
      out += pending ? `{${tex}}` : tex;
      pending = false;
    };
    if (space) {
      const before = out.trimEnd();
      if (/[\p{L}\d)}\]]$/u.test(before) && !before.endsWith('\\int') && differential.test(text.slice(tokens.lastIndex)))
        out += '\\,';
      continue;
    }
    if (number) covered(number.replace(/[,.]/, (c) => `{${c}}`));
    else if (up) out += `^{${small(up, raised, '⁻', '⁺')}}`;
    else if (down) out += `_{${small(down, lowered)}}`;
    else if (word === 'etc') {
      out += '\\text{etc.}';
      if (text[tokens.lastIndex] === '.') tokens.lastIndex += 1;
    } else if (word && functions[word]) out += `${functions[word]} `;
    else if (word) {
      if (english.test(word)) return null;
      covered(word);
    } else if (letter === 'l') covered('l\\,');
    else if (letter) covered(letter);
    else if (root) {
      out += '\\sqrt';
      pending = true;
    } else if (fractions[sign]) covered(fractions[sign]);
    else if (pending && sign === '(') {
      out += '{';
      roots.push(depth);
      depth += 1;
      pending = false;
    } else if (signs[sign] === undefined) return null;
    else {
      if (sign === '(') depth += 1;
      if (sign === ')') depth -= 1;
      if (sign === ')' && roots.at(-1) === depth) {
        roots.pop();
        out += '}';
      } else out += signs[sign];
    }
  }
  return pending || roots.length ? null : out;
}

// A piece between two spaces that may be part of a formula; what makes it one (a sign, a Greek letter, a function).
const symbol = /[√∫−=<>/·×±≈≤≥½⅓⅔¼¾⅛⅜⅝⅞²³⁴⁵⁶⁷⁸⁹ⁿ\p{Script=Greek}]|(?<!\p{L})(?:sin|cos|cot|tang?|tg|ln|log)(?!\p{L})/u;
const letters = /^(?:(\p{L})\1|dd?\p{L}|l\p{L}|sin|cos|tang?|cot|tg|ln|log|etc)$/u;
const plainWords = /^(?:do|day|due|did|a|I|'s)$/;
const ofFormula = (piece) =>
  piece !== '' &&
  !/^\(?\(?\p{L}?\d*\)$|§|['’"“”]/u.test(piece) &&
  !plainWords.test(piece) &&
  [...piece.matchAll(/(\d?)([A-Za-z]{2,})/g)].every(([, digit, word]) => letters.test(word) || (digit && word.length < 3)) &&
  (texOf(piece.replace(/[()[\]]/g, '')) !== null || /^√?[()[\]]*$/.test(piece));

/** What may stand beside a formula among words: a word, a reference, or nothing. */
const beside = (piece) =>
  piece === undefined || english.test(piece) || /^(?:are|has|here|nor|was|§§?\d+|\(\w\))$/.test(piece);

/**
 * Words with formulas among them, in turn: [words, formula, words, ...]. A run of pieces is a formula where it has a sign, a
 * Greek letter or a function, is whole, and has words on both sides; all else stays with the words.
 */
export function formulasIn(text) {
  const pieces = text.split(' ').map((piece) => /^(.*?)((?:(?<!etc)\.|[,;:])*)$/u.exec(piece));
  const out = [''];
  for (let from = 0; from < pieces.length; ) {
    let to = from; // behind the run that begins here
    while (to < pieces.length && ofFormula(pieces[to][1]) && (to === from || !pieces[to - 1][2])) to += 1;
    const run = pieces.slice(from, to).map(([, core]) => core).join(' ');
    const before = from && (!pieces[from - 1][2] || !pieces[from - 1][1]) ? pieces[from - 1][1] : undefined;
    const after = to < pieces.length && to > from && !pieces[to - 1][2] ? pieces[to][1] : undefined;
    const signed = from === 0 && run.startsWith('+ '); // a reading may begin with its sign
    if (to > from && isWhole(signed ? run.slice(2) : run) && beside(before) && beside(after)) {
      out.push(texOf(run), pieces[to - 1][2]);
      from = to;
    } else {
      to = Math.max(to, from + 1);
      out[out.length - 1] += pieces.slice(from, to).map(([piece]) => piece).join(' ');
      from = to;
    }
    if (from < pieces.length) out[out.length - 1] += ' ';
  }
  return out;
}

const isWhole = (run) =>
  symbol.test(run) && !/^[^\p{L}\d(√∫−\u00bc-\u00be⅓-⅞[]|[^\p{L}\d)\]°′²³¹⁴-⁹ⁿ\u00bc-\u00be⅓-⅞…]$|√\d+\p{L}|(?:sin|cos|tang?|cot|tg|ln|log|∫)$/u.test(run) &&
  balanced(run) && texOf(run) !== null;

const balanced = (text) => [...text].reduce((depth, c) => (depth < 0 ? depth : depth + (c === '(' ? 1 : c === ')' ? -1 : 0)), 0) === 0;

const greek = 'alpha α beta β gamma γ delta δ epsilon ε varepsilon ε zeta ζ eta η theta θ vartheta ϑ iota ι kappa κ lambda λ mu μ nu ν xi ξ pi π rho ρ sigma σ tau τ upsilon υ phi φ varphi φ chi χ psi ψ omega ω Gamma Γ Delta Δ Theta Θ Lambda Λ Xi Ξ Pi Π Sigma Σ Phi Φ Psi Ψ Omega Ω'; // prettier-ignore
const names = new Map(
  (
    `${greek} cdot · times × pm ± mp ∓ le ≤ leq ≤ ge ≥ geq ≥ ne ≠ neq ≠ approx ≈ infty ∞ int ∫ sum ∑ prod ∏ partial ∂ ` +
    `to → quad  qquad  circ ° dots … ldots … cdots ⋯ prime ′ dagger † ddagger ‡ diamond ◇ ast ∗ sqrt √ angle ∠ equiv ≡ ` +
    `lfloor ⌊ rfloor ⌋ sim ~ ll ≪ gg ≫ in ∈ ell ℓ mathfrak  text  mathrm  operatorname  left  right  big  Big  bigl  bigr ` +
    `Bigl  Bigr  displaystyle  textstyle  begin  end  tfrac  dfrac  frac `
  ).match(/\S+ \S*/g).map((pair) => pair.split(' ')),
); // prettier-ignore
const oneOver = Object.fromEntries(Object.entries(fractions).map(([c, tex]) => [tex.slice(6, 8), c]));

/** TeX as a line that can be read, for searches and for descriptions. */
export function readable(tex) {
  return tex
    .replace(/\\(?:begin|end)\{\w+\}(?:\{[^}]*\})?|\\tag\{[^}]*\}|&/g, ' ')
    .replace(/\\[td]?frac *(\d)(\d)/g, (all, a, b) => oneOver[a + b] ?? ` ${a}/${b}`)
    .replace(/\\sqrt *\{([^{}]*)\}/g, '√($1)')
    .replace(/\\[td]?frac *\{([^{}]*)\}\{([^{}]*)\}/g, '($1)/($2)')
    .replace(/\^\{?\\circ\}?/g, '°')
    .replace(/\^(?:\{(-?\d+)\}|(\d))/g, (_, a, b) => [...(a ?? b)].map((c) => (c === '-' ? '⁻' : raised[c])).join(''))
    .replace(/_(?:\{(\d+)\}|(\d))/g, (_, a, b) => [...(a ?? b)].map((c) => lowered[c]).join(''))
    .replace(/\\\\|\\[,;:! ]/g, ' ')
    .replace(/\\([A-Za-z]+)\s*/g, (_, name) => names.get(name) ?? `${name} `)
    .replace(/[{}]/g, '')
    .replace(/\((\w+)\)\/\((\w+)\)/g, '$1/$2')
    .replace(/-/g, '−')
    .replace(/\s+/g, ' ')
    .trim();
}

/**
 * TeX in which rows of fractions stand clear of each other: between one and the next of an array some room is left. KaTeX
 * takes it from where the row of plain letters would end, which a fraction passes by half as much.
 */
export function roomy(tex) {
  const mark = /\\\\(?:\[(\d+)pt\]|(\s*\[))?|\\(begin|end)\{|\\d?frac(?![A-Za-z])/g;
  const arrays = []; // not yet closed: where the last row ended, whether that row and this one have a fraction, or any had
  const places = [];
  const tall = (array) => {
    if (array.before && !array.here && array.end) places.push(array.end);
    Object.assign(array, { here: true, any: true });
  };
  for (let match = mark.exec(tex); match; match = mark.exec(tex)) {
    const [text, points, other, edge] = match;
    const array = arrays.at(-1);
    if (edge === 'begin') arrays.push({});
    else if (edge === 'end') {
      if (arrays.pop()?.any && arrays.length) tall(arrays.at(-1));
    } else if (!array) continue;
    else if (text.startsWith('\\\\')) {
      const end = other || points >= 10 ? undefined : { from: match.index + 2, to: mark.lastIndex };
      Object.assign(array, { end, before: array.here, here: false });
    } else tall(array);
  }
  return places.sort((a, b) => b.from - a.from).reduce((out, { from, to }) => `${out.slice(0, from)}[10pt]${out.slice(to)}`, tex);
}

/**
 * TeX of a displayed formula of several statements: on a narrow page the line ends between two of them, and not within one that
 * is short enough for a line.
 */
export function parted(tex) {
  const marks = /\\(?:begin|end|left|right)(?![A-Za-z])|\\q?quad(?![A-Za-z])|\\.|[{}]/g;
  const parts = [];
  let depth = 0;
  let from = 0;
  for (let match = marks.exec(tex); match; match = marks.exec(tex)) {
    const [mark] = match;
    if (mark === '{' || /^.(?:begin|left)$/.test(mark)) depth += 1;
    else if (mark === '}' || /^.(?:end|right)$/.test(mark)) depth -= 1;
    else if (depth === 0 && /quad$/.test(mark)) {
      parts.push(tex.slice(from, match.index), mark);
      from = marks.lastIndex;
    }
  }
  if (!parts.length) return tex;
  parts.push(tex.slice(from));
  const length = (part) => readable(part.replace(/\\(?:href|html[A-Z][a-z]+)\{[^}]*\}/g, '')).length;
  return parts
    .map((part, i) => (i % 2 ? `${part}\\allowbreak ` : part.trim() && length(part) <= 32 ? `{${part.trim()}}` : part))
    .join('');
}

/** HTML with every formula replaced by `what(its TeX)`. */
export function withoutFormulas(html, what) {
  let out = '';
  let from = 0;
  for (let at = html.indexOf('<span class="katex">'); at >= 0; at = html.indexOf('<span class="katex">', from)) {
    out += html.slice(from, at);
    const tags = /<(\/?)span\b/g;
    tags.lastIndex = at;
    let depth = 0;
    let tag;
    do {
      tag = tags.exec(html);
      depth += tag[1] ? -1 : 1;
    } while (depth);
    from = tags.lastIndex + 1;
    out += what(/<annotation[^>]*>([^]*?)<\/annotation>/.exec(html.slice(at, from))?.[1] ?? '');
  }
  return out + html.slice(from);
}

/** HTML of a line as bare words. */
export const bareWords = (html) =>
  withoutFormulas(html, (tex) => readable(unescape(tex)))
    .replace(/<[^>]+>/g, '')
    .replace(/&(lt|gt|quot|amp);/g, (_, name) => ({ lt: '<', gt: '>', quot: '"', amp: '&' })[name])
    .replace(/\s+/g, ' ')
    .trim();

const unescape = (text) =>
  text.replace(/&(lt|gt|quot|amp);/g, (_, name) => ({ lt: '<', gt: '>', quot: '"', amp: '&' })[name]);
