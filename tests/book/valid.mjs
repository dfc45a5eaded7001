// Every page is valid HTML: what a checker from the registry has to say against it. Usage: node valid.mjs HTML.
import fs from 'node:fs';
import path from 'node:path';
import { packages } from '../../book/packages.mjs';

const { HtmlValidate, StaticConfigLoader } = packages('html-validate');
const site = process.argv[2];
/** One configuration for all pages, put together once. */
class Loader extends StaticConfigLoader {
  getConfigFor(page) {
    return (this.config ??= super.getConfigFor(page));
  }
}
const checker = new HtmlValidate(new Loader({
  extends: ['html-validate:standard'],
  rules: {
    'no-inline-style': 'off', // KaTeX sets heights and shifts so
    'long-title': 'off', // a section's title is a sentence
    'prefer-native-element': 'off', // a told number is data that can be pressed; a button cannot be copied as text
    'require-sri': 'off', // nothing is fetched from elsewhere
  },
}));

const pages = fs.readdirSync(site).filter((f) => f.endsWith('.html'));
const faults = [];
for (const page of pages) {
  const whole = fs.readFileSync(path.join(site, page), 'utf8');
  const { results } = await checker.validateString(whole);
  for (const { messages } of results)
    for (const m of messages) faults.push(`${page}:${m.line}:${m.column}: ${m.message} (${m.ruleId})`);
  // The checker takes a closing tag without an opening one for what it was before; this does not.
  const html = whole.replace(/<(script|style)\b[^]*?<\/\1>|<!--[^]*?-->/g, '');
  for (const tag of ['div', 'p', 'section', 'span', 'main', 'table', 'details']) {
    const [opened, closed] = [`<${tag}[\\s>]`, `</${tag}>`].map((t) => (html.match(new RegExp(t, 'g')) ?? []).length);
    if (opened !== closed) faults.push(`${page}: ${opened} <${tag}> and ${closed} </${tag}>`);
  }
  if (/\/(?:home|root|tmp|usr|var|work|build)\/[\w.-]+\//.test(html.replace(/<code[^]*?<\/code>/g, '')))
    faults.push(`${page}: a path of the machine that built it`);
  const description = /<meta name="description" content="([^"]*)"/.exec(html)?.[1] ?? '';
  if (description.length < 10 || /^[✓✗†‡⁕◇]|\\/.test(description)) faults.push(`${page}: the description "${description}"`);
}
// What a reader can touch works: without the live modules no page offers to run anything.
const live = fs.existsSync(path.join(site, 'live/live.js'));
const text = (page) => fs.readFileSync(path.join(site, page), 'utf8');
const touched = pages.filter((f) => /class="(again|field)"/.test(text(f)));
if (!live) for (const page of touched) faults.push(`${page}: fields or a button that nothing answers`);
// A scene's button is answered by the frames that were woven, where the page does not run itself.
for (const page of live ? [] : pages.filter((f) => /class="controls"/.test(text(f)))) {
  const frames = [...text(page).matchAll(/<figure[^>]* class="scene"[^>]* data-frames="([^"]+)"/g)].map((m) => m[1]);
  const missing = ['scene.js', ...frames].filter((f) => !fs.existsSync(path.join(site, f)));
  if (!frames.length || missing.length) faults.push(`${page}: a scene without ${missing.join(', ') || 'frames'}`);
}
console.log(`${pages.length} pages, ${faults.length} faults`);
if (!pages.length || faults.length) {
  console.error(faults.slice(0, 200).join('\n'));
  process.exit(1);
}
