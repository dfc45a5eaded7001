// One section's page by itself, from what its program has told: woven, made by Doxygen, finished, in BUILD/html; all
// its faults at once. Usage: node one.mjs SOURCE BUILD CHAPTER-NN DOXYGEN.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const [source, build, name, doxygen] = process.argv.slice(2);
const here = path.dirname(new URL(import.meta.url).pathname);

function run(program, ...options) {
  const { status } = spawnSync(program, options, { stdio: ['ignore', 'ignore', 'inherit'] });
  if (status !== 0) process.exit(1);
}

const folder = path.join(build, 'doxygen-only');
fs.rmSync(folder, { recursive: true, force: true });
const configuration = path.join(build, 'Doxyfile-only');
fs.writeFileSync(
  configuration,
  `${fs.readFileSync(path.join(build, 'Doxyfile'), 'utf8')}
INPUT            = "${build}/dox/${name}.dox" "${source}/book/library.dox" "${source}/src"
HTML_OUTPUT      = doxygen-only
GENERATE_TAGFILE = "${build}/book-only.tag"
WARN_IF_UNDOCUMENTED = NO
`,
);
run(process.execPath, path.join(here, 'weave.mjs'), source, build, '--only', name);
run(doxygen, configuration);
run(process.execPath, path.join(here, 'finish.mjs'), source, build, '--only', name);
console.log(path.join(build, 'html', `${name}.html`));
