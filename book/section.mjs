// A section's file, taken apart: prose and code in turn, and in the code the checks and the entries of the
// apparatus.

const cxxString = String.raw`"(?:[^"\\]|\\.)*"`;
const strings = new RegExp(String.raw`(?:${cxxString}\s*)+`);
const marked = /^(?:CHECK_THAT|TELL|(?:static )?(?:const )?(?:Erratum|Emendation|Doubtful|Undecided)\b)/;
const bare = (line) => line.replace(new RegExp(`${cxxString}|'(?:[^'\\\\]|\\\\.)'|//.*`, 'g'), '');
const count = (line, sign) => bare(line).split(sign).length - 1;

/** The first string literal in a piece of code, pieces of it joined. */
function literal(code) {
  return (strings.exec(code)?.[0].match(new RegExp(cxxString, 'g')) ?? []).map((s) => JSON.parse(s)).join('');
}

/** Code in pieces: each check, TELL block and entry of the apparatus by itself, and what is between. */
function pieces(code, line) {
  const all = [];
  let open = 0;
  let piece = null;
  code.split('\n').forEach((text, i) => {
    const kind = open === 0 ? marked.exec(text)?.[0].replace(/static |const /g, '') : null;
    if (!piece || kind || (open === 0 && piece.closed)) {
      if (!text.trim()) return;
      piece = { kind: kind ?? 'code', line: line + i, code: '', begun: false };
      all.push(piece);
    }
    piece.code += `${text}\n`;
    open += count(text, '{') - count(text, '}');
    piece.begun ||= count(text, '{') > 0;
    piece.closed = piece.kind !== 'code' && piece.begun && open === 0;
  });
  for (const p of all) {
    p.code = p.code.replace(/\s+$/, '');
    if (p.kind !== 'code' && p.kind !== 'TELL') p.name = literal(p.code);
    if (/^[EDU]/.test(p.kind)) p.object = /^[\w ]*?(\w+)\s*\{/.exec(p.code)?.[1];
    if (p.kind === 'CHECK_THAT') p.kind = 'check';
  }
  return all;
}

/** A piece of prose, parted before each heading of the second level: so that a piece opens with its heading. */
function divided(text, line) {
  const parts = text.split(/^(?=## )/m);
  return parts.flatMap((part, i) => {
    const before = parts.slice(0, i).join('').split('\n').length - 1;
    const heading = /^## +(.*)$/m.exec(part)?.[1];
    return part.trim() ? [{ kind: 'prose', line: line + before, text: part, heading }] : [];
  });
}

/**
 * The blocks of a section's file in their order: { kind: 'prose', line, text, heading } or { kind: 'code' | 'TELL' |
 * 'check' | 'Erratum' ..., line, code, name, object }. What stands before the first prose is left out.
 */
export function blocks(source) {
  const all = [];
  const lines = source.split('\n');
  let from = lines.findIndex((l) => l.startsWith('/*!'));
  if (from < 0) throw new Error('no prose (a comment that opens with /*! at the margin)');
  while (from < lines.length) {
    const prose = lines[from].startsWith('/*!');
    let to = from;
    if (prose) {
      while (to < lines.length && !lines[to].endsWith('*/')) to += 1;
      if (to === lines.length) throw Object.assign(new Error('prose that is never closed'), { line: from + 1 });
      to += 1;
      all.push(...divided(lines.slice(from, to).join('\n').slice(3, -2), from + 1));
    } else {
      while (to < lines.length && !lines[to].startsWith('/*!')) to += 1;
      all.push(...pieces(lines.slice(from, to).join('\n'), from + 1));
    }
    from = to;
  }
  return all;
}

/** The numbers of the formulae that prose gives, with their lines; and of those that code names in comments `// (n)`. */
export const tagged = (text, line = 1) =>
  [...text.matchAll(/\\tag\{([^}]+)\}/g)].map((m) => ({
    number: m[1],
    line: line + text.slice(0, m.index).split('\n').length - 1,
  }));
export const named = (code) =>
  [...code.matchAll(/\/\/ (\(\w+\)(?:,? (?:and )?\(\w+\))*)/g)].flatMap((m) =>
    [...m[1].matchAll(/\((\w+)\)/g)].map((n) => n[1]),
  );
