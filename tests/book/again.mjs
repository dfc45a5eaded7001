// The same programs' words and drawings, woven a second time into another folder, give the same bytes.
// Usage: node again.mjs SOURCE BUILD DOXYGEN.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const [source, build, doxygen] = process.argv.slice(2);
const other = fs.mkdtempSync(path.join(os.tmpdir(), 'again-'));
try {
  const said = fs.readdirSync(build).filter((name) => /\.(json|txt)$/.test(name)); // by the build, for the weaver
  const made = ['told', 'drawn', 'html/fonts', 'html/live']; // the last only where pages run themselves
  for (const what of [...made.filter((name) => fs.existsSync(path.join(build, name))), ...said])
    fs.cpSync(path.join(build, what), path.join(other, what), { recursive: true });
  fs.writeFileSync(
    path.join(other, 'Doxyfile'),
    fs.readFileSync(path.join(build, 'Doxyfile'), 'utf8').replaceAll(build, other),
  );
  const run = (program, ...options) =>
    execFileSync(program, options, { stdio: ['ignore', 'ignore', 'inherit'] });
  run(process.execPath, path.join(source, 'book/weave.mjs'), source, other);
  run(doxygen, path.join(other, 'Doxyfile'));
  run(process.execPath, path.join(source, 'book/finish.mjs'), source, other);

  const files = (root, folder = '') =>
    fs
      .readdirSync(path.join(root, folder), { withFileTypes: true })
      .flatMap((f) =>
        f.isDirectory() ? files(root, path.join(folder, f.name)) : [path.join(folder, f.name)],
      )
      .sort();
  const [first, second] = [build, other].map((b) => files(path.join(b, 'html')));
  const only = [...first.filter((f) => !second.includes(f)), ...second.filter((f) => !first.includes(f))];
  const differ = first.filter(
    (f) =>
      second.includes(f) &&
      !fs.readFileSync(path.join(build, 'html', f)).equals(fs.readFileSync(path.join(other, 'html', f))),
  );
  console.log(`${first.length} files, ${only.length} in one build only, ${differ.length} that differ`);
  if (!first.length || only.length || differ.length) throw new Error([...only, ...differ].join('\n'));
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
} finally {
  fs.rmSync(other, { recursive: true });
}
