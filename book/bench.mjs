// Times everything anew and records it for the book: every section that has a race, and the library against
// its peers. Records of what is gone are removed. Usage: node bench.mjs BUILD SPEEDS (the build folder, and book/speeds).
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { libraries } from './scenes.mjs';

const [build, speeds] = process.argv.slice(2);
const bin = path.join(build, 'bin');
const run = (program, ...options) =>
  JSON.parse(execFileSync(path.join(bin, program), options, { encoding: 'utf8' }));
const { compiler, flags, 'sections compiled by': forSections } = JSON.parse(
  fs.readFileSync(path.join(build, 'book/made-with.json'), 'utf8'),
);
const recorded = new Set();
const record = (name, measured) => {
  const made = {
    machine: `${os.cpus()[0].model.trim()}, one core of ${os.cpus().length}`,
    compiler,
    flags,
    ...measured,
  };
  fs.writeFileSync(path.join(speeds, `${name}.json`), `${JSON.stringify(made, null, 1)}\n`);
  recorded.add(`${name}.json`);
  console.log(`recorded ${name}`);
};
const short = ({ name, seconds, ratio }) => ({
  name,
  seconds: Number(seconds.toPrecision(4)),
  ratio: Number(ratio.toPrecision(4)),
});

fs.mkdirSync(speeds, { recursive: true });
for (const program of fs
  .readdirSync(bin)
  .filter((f) => /^[a-z]+-\d\d$/.test(f))
  .sort())
  if (run(program, '--json').races.length)
    record(program, {
      compiler: forSections === compiler ? compiler : `${forSections}, the library with ${compiler}`,
      races: run(program, '--bench', '--json').races.map(({ name, methods }) => ({
        name,
        methods: methods.map(short),
      })),
    });
for (const library of libraries)
  if (fs.existsSync(path.join(bin, `bench-${library}`)))
    record(library, { scenes: run(`bench-${library}`, '--json').scenes });
for (const old of fs.readdirSync(speeds)) if (!recorded.has(old)) fs.rmSync(path.join(speeds, old));
