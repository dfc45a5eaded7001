// The rows of a told table; the weaver's, and the page's own when its numbers change.
import { escape } from './escape.mjs';
import { asText, format } from './numbers.mjs';

export const isWord = (x) => typeof x === 'string' && !/^-?(inf|nan)$/.test(x);

const cell = (x, c) => {
  if (isWord(x)) return `<td class="word">${escape(x)}</td>`;
  const digits = Number.isInteger(x) ? '' : String(c.digits);
  return `<td>${asText(format({ value: x, unit: '' }, digits))}</td>`;
};

/** A told table's rows as HTML. */
export const rows = (table) =>
  table.rows.map((row) => `<tr>${row.map((x, i) => cell(x, table.columns[i])).join('')}</tr>`);
