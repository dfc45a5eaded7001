// A section's file, taken apart: prose and code in turn, and in the code the checks and the entries of the
// apparatus.

const cxxString = String.raw`"(?:[^"\\]|\\.)*"`;
const strings = new RegExp(String.raw`(?:${cxxString}\s*)+`);
const marked = /^(CHECK_THAT|TELL|(?:const )?(?:Erratum|Emendation|Doubtful|Undecided)\b)/;
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
    const kind = open === 0 ? marked.exec(text)?.[1].replace('const ', '') : null;
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
    if (p.kind === 'CHECK_THAT') p.kind = 'check';
  }
  return all;
}

/**
 * The blocks of a section's file in their order: { kind: 'prose', line, text } or { kind: 'code' | 'TELL' |
 * 'check' | 'Erratum' ..., line, code, name }. What stands before the first prose is left out.
 */
export function blocks(source, file) {
  const all = [];
  const lines = source.split('\n');
  let from = lines.findIndex((l) => l.startsWith('/*!'));
  if (from < 0) throw new Error(`${file}:1: no prose (a comment that opens with /*! at the margin)`);
  while (from < lines.length) {
    const prose = lines[from].startsWith('/*!');
    let to = from;
    if (prose) {
      while (to < lines.length && !lines[to].endsWith('*/')) to += 1;
      if (to === lines.length) throw new Error(`${file}:${from + 1}: prose that is never closed`);
      to += 1;
      all.push({ kind: 'prose', line: from + 1, text: lines.slice(from, to).join('\n').slice(3, -2) });
    } else {
      while (to < lines.length && !lines[to].startsWith('/*!')) to += 1;
      all.push(...pieces(lines.slice(from, to).join('\n'), from + 1));
    }
    from = to;
  }
  return all;
}

/** The numbers of the formulae that prose gives, and of those that code names in comments `// (n)`. */
export const tagged = (text) => [...text.matchAll(/\\tag\{([^}]+)\}/g)].map((m) => m[1]);
export const named = (code) =>
  [...code.matchAll(/\/\/ (\(\w+\)(?:,? (?:and )?\(\w+\))*)/g)].flatMap((m) =>
    [...m[1].matchAll(/\((\w+)\)/g)].map((n) => n[1]),
  );
