// The rows of a told table; the weaver's, and the page's own when its numbers change.
import { said } from './escape.mjs';
import { asText, format } from './numbers.mjs';

export const isWord = (x) => typeof x === 'string' && !/^-?(inf|nan)$/.test(x);

/** How many digits write the number as somebody typed it, up to the rounding of a unit (30° as radians and back); 0: many. */
const typed = (x) => {
  const near = Number(x.toPrecision(12));
  const digits = near.toExponential().replace(/e.*|\D/g, '').length;
  return Math.abs(x - near) <= 2 ** -51 * Math.abs(x) && digits <= 4 ? digits : 0;
};

const cell = (x, c, asTyped) => {
  if (isWord(x)) return `<td class="word">${said(x)}</td>`;
  const digits = Number.isInteger(x) ? '' : String(asTyped && typeof x === 'number' ? typed(x) : c.digits);
  return `<td>${asText(format({ value: x, unit: '' }, digits))}</td>`;
};

/** A told table's rows as HTML; a column of numbers that were all typed shows them so. */
export const rows = (table) => {
  const asTyped = table.columns.map((_, i) => table.rows.every((row) => typeof row[i] !== 'number' || typed(row[i])));
  return table.rows.map((row) => `<tr>${row.map((x, i) => cell(x, table.columns[i], asTyped[i])).join('')}</tr>`);
};
