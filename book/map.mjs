// A chapter's map: which section needs which, drawn beside the list of all; and a way through it in a few sections.
import { said } from './prose.mjs';

const row = 26; // pixels, as style.css has it
const width = 150;
const twoDigits = (n) => String(n).padStart(2, '0');

/** The lines `15 <- 7 8` as pairs [needing, needed]; what is no such line, or names no section, is a fault. */
function needs(text, page, line, sections) {
  const pairs = [];
  const seen = new Set();
  text.split('\n').forEach((words, i) => {
    if (!words.trim()) return;
    const say = (message) => page.fault(line + i, message);
    const [, to, from] = /^(\d+) *<- *(\d+(?: +\d+)*)$/.exec(words.trim()) ?? [];
    if (!to) {
      say(`"${words.trim()}" is not of the form 15 <- 7 8`);
      return;
    }
    if (seen.has(to)) say(`a second line for § ${to}`);
    seen.add(to);
    for (const n of from.split(/ +/))
      if (n === to) say(`§ ${n} needs itself`);
      else if ([n, to].some((x) => x < 1 || x > sections)) say(`there is no § ${n > sections ? n : to}`);
      else pairs.push([Number(to), Number(n)]);
  });
  return pairs;
}

/** Arcs at the left of the list, from what is needed to what needs it; the wider, the farther apart. */
function arcs(pairs, sections) {
  const height = sections * row;
  const y = (n) => (n - 0.5) * row;
  const x = width - 12;
  const bulge = (a, b) => Math.min(x - 4, 10 + 24 * Math.sqrt(Math.abs(a - b) - 0.75)) * 1.33;
  const arc = ([to, from]) =>
    `<path d="M${x},${y(from)} C${(x - bulge(to, from)).toFixed(1)},${y(from)} ` +
    `${(x - bulge(to, from)).toFixed(1)},${y(to)} ${x},${y(to)}"${to < from ? ' class="back"' : ''}/>`;
  const dot = (_, i) => `<circle cx="${x}" cy="${y(i + 1)}" r="3"/>`;
  return (
    `<svg width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" preserveAspectRatio="none" aria-hidden="true">` +
    `${pairs.map(arc).join('')}${Array.from({ length: sections }, dot).join('')}</svg>`
  );
}

function map(text, page, line) {
  const chapter = page.book.chapters.find((c) => c.id === page.chapter);
  if (!chapter) throw new Error('::: map belongs into chapters/CHAPTER/map.md');
  const pairs = needs(text, page, line, chapter.sections);
  const item = (_, i) => {
    const s = page.book.sections.get(`${chapter.id}.${twoDigits(i + 1)}`);
    const needed = pairs.filter(([to]) => to === i + 1).map(([, from]) => `§\u00a0${from}`);
    const behind = needed.length ? `<span class="needed"> needs ${needed.join(', ')}</span>` : '';
    const title = s
      ? `<a href="${s.name}.html">${said(s.told.title)}</a>`
      : '<span class="not-yet">not yet</span>';
    return `<li><span class="n">§ ${i + 1}</span> ${title}${behind}</li>`;
  };
  return (
    `<div class="needs">${arcs(pairs, chapter.sections)}<ol>\n` +
    `${Array.from({ length: chapter.sections }, item).join('\n')}\n</ol></div>\n`
  );
}

function route(text, page, line) {
  const items = text
    .split(/\n(?=\d+:)/)
    .map((words) => {
      const at = line + text.slice(0, text.indexOf(words)).split('\n').length - 1;
      const [, n, why] = /^(\d+): *([^]+)$/.exec(words.trim()) ?? [];
      if (!n) return page.fault(at, `"${words.trim().slice(0, 40)}" is not of the form 11: why`);
      const id = `${page.chapter}.${twoDigits(n)}`;
      const s = page.book.sections.get(id);
      return (
        `<li>${page.linkToSection(id)}${s ? ` <span class="title">${said(s.told.title)}</span>` : ''}` +
        `<p>${page.inline(why, at)}</p></li>`
      );
    })
    .filter(Boolean);
  return `<ol class="route">\n${items.join('\n')}\n</ol>\n`;
}

export const divisions = { map, route };
