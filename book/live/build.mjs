// Makes the page's script: the worker's bundled into a text, the page's around it. Usage: node build.mjs OUT
import path from 'node:path';
import { packages } from '../packages.mjs';

const { buildSync } = packages('esbuild');
const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const bundled = (name, define = {}) => {
  const result = buildSync({
    entryPoints: [path.join(here, name)],
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    charset: 'utf8',
    define,
    write: false,
    logLevel: 'error',
  });
  return result.outputFiles[0].text;
};
const fs = await import('node:fs');
fs.writeFileSync(process.argv[2], bundled('page.mjs', { WORKER: JSON.stringify(bundled('worker.mjs')) }));
