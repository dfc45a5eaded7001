// What the page's modules tell, draw and check is what the programs do, to the last bit: with Euler's numbers for every section,
// and with three other settings of its parameters; in any order, and twice. Usage: node live-same.mjs BUILD (build/book, beside
// which lie the programs in bin)
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import readline from 'node:readline';
import vm from 'node:vm';
import { Engine } from '../../book/live/engine.mjs';
import { slider, typed } from '../../book/live/fields.mjs';

const build = path.resolve(process.argv[2]);
const read = (file) => fs.readFileSync(path.join(build, file), 'utf8');
const programs = read('programs.txt').split('\n').filter(Boolean);
const faults = [];
const fault = (what) => faults.push(what);

// The modules, as a page has them: scripts that put themselves into self.LIVE. They are made for a worker.
globalThis.self = { location: { href: 'blob:' } };
globalThis.importScripts = () => {};
for (const file of fs
  .readdirSync(path.join(build, 'html/live'))
  .filter((f) => !['live.js', 'katex.js'].includes(f)))
  vm.runInThisContext(read(`html/live/${file}`), { filename: file });
const engines = {};
const engine = (program) => {
  const chapter = program.split('-')[0];
  return (engines[chapter] ??= new Engine(self.LIVE, chapter));
};

// All the sections in one native program.
const native = spawn(path.join(build, '../bin/all-sections'), { stdio: ['pipe', 'pipe', 'inherit'] });
const answers = readline.createInterface({ input: native.stdout })[Symbol.asyncIterator]();
async function ask(...question) {
  native.stdin.write(`${JSON.stringify(question)}\n`);
  return JSON.parse((await answers.next()).value);
}

/** Three settings that a hand can reach by the sliders, each of another parameter where there are so many. */
function settings(parameters) {
  const places = [0.3, 0.62, 0.85];
  const sliding = parameters.filter((p) => slider(p));
  return sliding.length
    ? places.map((part, i) => {
        const p = sliding[i % sliding.length];
        const { min, max, step, number } = slider(p);
        return { [p.name]: typed(number(min + Math.round(((max - min) * part) / step) * step)) };
      })
    : [];
}

const differing = (a, b) =>
  Object.keys({ ...a, ...b }).filter((name) => JSON.stringify(a[name]) !== JSON.stringify(b[name]));

let compared = { told: 0, data: 0, figures: 0, claims: 0, settings: 0, refused: 0 };
const figures = fs.readdirSync(path.join(build, 'drawn')).filter((f) => f.endsWith('.svg'));

// Euler's numbers: against what the book was woven from.
for (const program of programs) {
  const there = await engine(program).tell(program, {});
  if (!there.told) {
    fault(`${program}: ${there.failed ?? there.refused}`);
    continue;
  }
  const told = JSON.parse(read(`told/${program}.json`));
  for (const name of differing(told, there.told))
    fault(`${program}: ${name} differ from what the program tells`);
  if (there.text !== read(`told/${program}.txt`)) fault(`${program}: the text differs`);
  compared.told += 1;
  for (const [name, content] of Object.entries(there.data)) {
    compared.data += 1;
    if (content !== read(`told/${name}`)) fault(`${program}: ${name} differs`);
  }
  for (const file of figures.filter(
    (f) => f.startsWith(program) && self.LIVE[program.split('-')[0]].scripts[`figures/${f.slice(0, -4)}.gp`],
  )) {
    compared.figures += 1;
    const drawn = await engine(program).draw(file.slice(0, -4));
    if (drawn !== read(`drawn/${file}`)) fault(`${program}: ${file} is drawn otherwise`);
  }
  const { checked } = await engine(program).check(program, {});
  const check = JSON.parse(read(`told/${program}.check.json`));
  compared.claims += checked.cases.reduce((n, c) => n + c.claims.length, 0);
  for (const name of differing(check, checked)) fault(`${program}: of its checks, ${name} differ`);
}

// Other settings: against the native program with all sections in it, from the last section to the first.
for (const program of [...programs].reverse()) {
  const usual = await ask('tell', program, {});
  if (JSON.stringify(usual.told) !== JSON.stringify(JSON.parse(read(`told/${program}.json`))))
    fault(`${program}: in a program with others it tells something else`);
  for (const given of settings(usual.told.parameters)) {
    const [here, there] = [await ask('tell', program, given), await engine(program).tell(program, given)];
    compared.settings += 1;
    if (here.refused) compared.refused += 1;
    const where = `${program} with ${JSON.stringify(given)}`;
    if ((here.refused ?? here.failed) !== (there.refused ?? there.failed))
      fault(`${where}: refused otherwise`);
    else if (here.told) {
      for (const name of differing(here.told, there.told)) fault(`${where}: ${name} differ`);
      for (const name of differing(here.data, there.data)) fault(`${where}: ${name} differs`);
    }
  }
}

// And once more, after all that: nothing is left over from run to run.
for (const program of programs) {
  const there = await engine(program).tell(program, {});
  if (there.told && there.text !== read(`told/${program}.txt`))
    fault(`${program}: told again it tells something else`);
}

native.stdin.end();
faults.forEach((what) => console.error(what));
console.log(
  `${compared.told} sections, ${compared.data} data, ${compared.figures} figures, ${compared.claims} claims; ` +
    `${compared.settings} other settings (${compared.refused} refused); ${faults.length} differ`,
);
process.exitCode = faults.length || !compared.settings ? 1 : 0;
