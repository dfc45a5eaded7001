// What a program says, as the page shows it: each line in its parts, so that a narrow window can set the meaning
// under the value; without what the page sets as a table. The page's live face uses it, too.

const escape = (text) => text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);
const indent = (line) => /^ */.exec(line)[0].length;

/** The paragraphs of the output: lines that follow one another. */
const paragraphs = (text) => text.trimEnd().split(/\n(?:[ \t]*\n)+/);

/** A line in its columns, which stand two blanks or more apart; lines that carry on the last column go with it. */
function said(lines) {
  const rows = [];
  for (const line of lines) {
    if (rows.length && indent(line) > 8) rows.at(-1).push(line);
    else rows.push([line]);
  }
  return rows
    .map(([line, ...more]) => {
      const parts = line.slice(indent(line)).split(/( {2,})/);
      const cells = parts.map((part, i) =>
        i % 2
          ? `<span class="gap">${part}</span>`
          : `<span class="${i === parts.length - 1 && i > 0 ? 'meaning' : 'part'}">${escape(part)}` +
            `${i === parts.length - 1 ? more.map((m) => `\n${escape(m)}`).join('') : ''}</span>`,
      );
      return `<span class="said"><span class="gap">${' '.repeat(indent(line))}</span>${cells.join('')}</span>`;
    })
    .join('\n');
}

/**
 * The output of a program as HTML. `told` is its JSON; `typeset` the names of the tables that the page sets in
 * another place; its parameters, too, stand elsewhere.
 */
export function terminal(name, text, told, typeset) {
  const [title, ...rest] = paragraphs(text);
  const left = [];
  const shown = rest.filter((paragraph) => {
    const lines = paragraph.split('\n');
    const first = lines[0].trim();
    if (told.parameters.length && first.split(/ *= /)[0] === told.parameters[0].name) {
      left.push('the parameters, as above');
      return false;
    }
    const table = told.tables.find((t) => t.caption.startsWith(first.slice(0, 60)) || first === t.caption);
    if (!table || !typeset.has(table.name)) return true;
    left.push(`the table “${table.caption.replace(/\$|\{\{[^}]*\}\}/g, '')}”, as below`);
    return false;
  });
  const omitted = left.map((what) => `\n\n<span class="omitted">  … ${escape(what)}</span>`);
  const [first, ...others] = left[0]?.startsWith('the parameters') ? omitted : ['', ...omitted];
  return (
    `<span class="prompt" aria-hidden="true">$ </span><span class="command">${name}</span>\n${escape(title)}${first}` +
    `${shown.map((p) => `\n\n${said(p.split('\n'))}`).join('')}${others.join('')}`
  );
}
