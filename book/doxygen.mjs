// What the weaver hands to Doxygen: a page's comment, HTML that it lets through, and code that it colours.
import { proofs } from './sectionpage.mjs';

export const html = (text) =>
  `\\htmlonly[block]\n${text.replaceAll('*/', '*&#47;').trim()}\n\\endhtmlonly\n`;

export function code(text, line, fault) {
  if (/\*\/|\\endcode/.test(text)) fault(line, 'a block comment at the margin is prose; in code use //');
  return `\\code{.cpp}\n${text}\n\\endcode\n`;
}

export function page(name, title, body) {
  const command = name === 'index' ? 'mainpage' : `page ${name} ${title.replace(/[\\@#%&<>"]/g, ' ')}`;
  return `/*! \\${command}\n${body}*/\n`;
}

/** What a page's numbers mean and which checks look at them, for the page's own script. */
export function explained(p) {
  const all = [...p.numbers.values()].map((v) => [
    v.full,
    {
      value: `${v.text ?? v.value}${v.unit === '°' ? '°' : v.unit && ` ${v.unit}`}`,
      meaning: v.meaning,
      ...(v.illustration ? { illustration: v.illustration } : {}),
      ...(v.section && v.default === undefined
        ? {
            page: v.section === p.section ? '' : `${v.section.name}.html`,
            checks: proofs(v.section, v.full.split('.').at(-1)),
          }
        : {}),
    },
  ]);
  return all.length
    ? `<script type="application/json" id="numbers">${JSON.stringify(Object.fromEntries(all)).replaceAll('<', '\\u003c')}</script>`
    : '';
}
