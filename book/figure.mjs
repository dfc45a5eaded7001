// From gnuplot's SVG to the book's: colours by name so that they follow light and dark, ids of its own, real
// words for those who cannot see it; and from the same drawing a file to take away and a thumbnail.
import { printed, said } from './escape.mjs';

/** The palette that figures/style.gp defines: [{ name, light, dark }]. */
export function palette(style) {
  const colours = [...style.matchAll(/^(\w+) *= "(#[0-9a-f]{6})" # \w+ +(#[0-9a-f]{6})/gm)];
  return colours.map(([, name, light, dark]) => ({ name, light, dark }));
}

export const paletteCss = (colours, which) => colours.map((c) => `--${c.name}:${c[which]}`).join(';');

const hex = (rgb) =>
  `#${rgb
    .match(/\d+/g)
    .map((n) => Number(n).toString(16).padStart(2, '0'))
    .join('')}`;

/** What is drawn, without gnuplot's wrapping, in named colours. */
function drawing(svg, name, colours) {
  const named = (colour) => {
    const known =
      colour === 'black'
        ? 'ink'
        : colour === 'white'
          ? 'paper'
          : colours.find((c) => c.light === hex(colour))?.name;
    if (!known) throw new Error(`figures/${name}.gp: the colour ${colour} is not in figures/style.gp`);
    return `var(--${known})`;
  };
  return svg
    .slice(svg.indexOf('<defs>'), svg.lastIndexOf('</g>'))
    .replace(/<title>[^]*?<\/title>/g, '')
    .replace(/ *font-family="[^"]*"/g, '')
    .replace(
      /(color|stroke|fill|flood-color)=(["'])(rgb\([\d, ]+\)|black|white)\2/g,
      (_, what, q, colour) => `${what}="${named(colour)}"`,
    )
    .replace(/\b(?:xlink:)?href=(["'])#/g, `href=$1#${name}-`)
    .replace(/\bid=(["'])/g, `id=$1${name}-`)
    .replace(/url\(#/g, `url(#${name}-`)
    .replace(/(?:<g [^>]*>\s*<\/g>\s*)+/g, '')
    .replace(/>[^<>]*'[^<>]*</g, printed)
    .replace(/\t/g, ' ') // Doxygen would make some blanks of them
    .replace(/^\s+/gm, '');
}

const size = (svg) => /viewBox="0 0 (\d+) (\d+)"/.exec(svg).slice(1, 3);
const xmlns = 'xmlns="http://www.w3.org/2000/svg"';
const schemes = (colours) =>
  `svg{${paletteCss(colours, 'light')}}@media(prefers-color-scheme:dark){svg{` +
  `${paletteCss(colours, 'dark')}}}`;

/** For the page: part of it, in its fonts and colours. */
export function inline(svg, name, alt, colours) {
  const [width, height] = size(svg);
  const first = /^.*?[.:;](?= |$)/.exec(alt)?.[0] ?? alt;
  return (
    `<svg width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" aria-labelledby="` +
    `${name}-title ${name}-desc">` +
    `<title id="${name}-title">${said(first)}</title><desc id="${name}-desc">${said(alt)}</desc>\n` +
    `${drawing(svg, name, colours)}</svg>\n`
  );
}

/** To take away: on its own, light or dark as the viewer is. */
export function standalone(svg, name, alt, colours) {
  const [width, height] = size(svg);
  return (
    `<svg ${xmlns} width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">\n<title>` +
    `${said(name)}</title>` +
    `<desc>${said(alt)}</desc>\n<style>` +
    `${schemes(colours)}text{font-family:"EB Garamond",Garamond,Georgia,serif}</style>\n` +
    `${drawing(svg, name, colours)}</svg>\n`
  );
}

/** For the chapter's map: lines only. */
export function thumbnail(svg, name, colours) {
  const [width, height] = size(svg);
  const lines = drawing(svg, name, colours)
    .replace(/<g transform[^>]*>\s*<text>[^]*?<\/text>\s*<\/g>/g, '')
    .replace(/<path [^>]*class="gridline"[^>]*>/g, '');
  return (
    `<svg ${xmlns} width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"><style>` +
    `${schemes(colours)}` +
    `path,use{vector-effect:non-scaling-stroke}</style>\n${lines}</svg>\n`
  );
}
