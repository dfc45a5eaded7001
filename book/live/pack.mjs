// Packs a module for the page: a classic script, since a page that was opened from a folder may fetch nothing and import
// nothing, with the module's own script as text, its WebAssembly compressed, and the figures' scripts that it draws or draws
// for; what is no .gp file is the notice of those who wrote it. Usage: node pack.mjs NAME GLUE WASM OUT FILE...
import fs from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';

const [name, glue, wasm, out, ...files] = process.argv.slice(2);
const packed = {
  glue: fs.readFileSync(glue, 'utf8'),
  wasm: gzipSync(fs.readFileSync(wasm), { level: 9 }).toString('base64'),
  scripts: Object.fromEntries(
    files
      .filter((f) => f.endsWith('.gp'))
      .map((f) => [`figures/${path.basename(f)}`, fs.readFileSync(f, 'utf8')]),
  ),
  notice: files
    .filter((f) => !f.endsWith('.gp'))
    .map((f) => fs.readFileSync(f, 'utf8'))
    .join('\n'),
};
fs.writeFileSync(out, `(self.LIVE ??= {})[${JSON.stringify(name)}] = ${JSON.stringify(packed)};\n`);
