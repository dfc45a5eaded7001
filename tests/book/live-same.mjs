// What the page's modules tell, draw and check is what the programs do, to the last bit: with Euler's numbers for every section,
// and with three other settings of its parameters; in any order, and twice; and so it is where the C library's fused variants are
// switched off. Usage: node live-same.mjs BUILD [CHAPTER...] (build/book, beside which lie the programs in bin)
import fs from 'node:fs';
import path from 'node:path';
import { isDeepStrictEqual } from 'node:util';
import vm from 'node:vm';
import { Engine } from '../../book/live/engine.mjs';
import { Program, differing, placeless } from './program.mjs';
import { settings } from './settings.mjs';

const [folder, ...chapters] = process.argv.slice(2);
const build = path.resolve(folder);
const read = (file) => fs.readFileSync(path.join(build, file), 'utf8');
const programs = read('programs.txt')
  .split('\n')
  .filter((p) => p && (!chapters.length || chapters.includes(p.split('-')[0])));
let faults = 0;
function fault(what) {
  faults += 1;
  console.error(what);
}

// The modules, as a page has them: scripts that put themselves into self.LIVE. They are made for a worker.
globalThis.self = { location: { href: 'blob:' } };
globalThis.importScripts = () => {};
for (const file of ['gnuplot', ...new Set(programs.map((p) => p.split('-')[0]))].map((name) => `${name}.js`))
  vm.runInThisContext(read(`html/live/${file}`), { filename: file });
const engines = {};
const engine = (program) => {
  const chapter = program.split('-')[0];
  return (engines[chapter] ??= new Engine(self.LIVE, chapter));
};

// All the sections in one native program, as it is and without the processor's fused operations.
const native = (env) => new Program([path.join(build, '../bin/all-sections')], env);
const usually = native({});
const unfused = native({ GLIBC_TUNABLES: 'glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2' });

/** All data of a section, those of its scenes too, as the page has them after it was told with `given`. */
async function dataThere(program, { told }, given) {
  const data = { ...engine(program).data };
  for (const { name } of told.scenes)
    data[`${program}.${name}.tsv`] = await engine(program).frames(program, name, given);
  return data;
}

let compared = { told: 0, data: 0, figures: 0, claims: 0, settings: 0, refused: 0 };
const figuresOf = (program) =>
  fs
    .readdirSync(path.join(build, 'drawn'))
    .filter((f) => f.startsWith(program) && f.endsWith('.svg'))
    .map((f) => f.slice(0, -4))
    .filter((name) => self.LIVE[program.split('-')[0]].scripts[`figures/${name}.gp`]);
const took = []; // to tell with other numbers and to draw

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
  for (const [name, content] of Object.entries(await dataThere(program, there, {}))) {
    compared.data += 1;
    if (content !== read(`told/${name}`)) fault(`${program}: ${name} differs`);
  }
  for (const name of figuresOf(program)) {
    compared.figures += 1;
    const drawn = await engine(program).draw(name);
    if (drawn !== read(`drawn/${name}.svg`)) fault(`${program}: ${name}.svg is drawn otherwise`);
  }
  const { checked } = await engine(program).check(program, {});
  const check = JSON.parse(read(`told/${program}.check.json`));
  compared.claims += checked.cases.reduce((n, c) => n + c.claims.length, 0);
  for (const name of differing(placeless(check), placeless(checked)))
    fault(`${program}: of its checks, ${name} differ`);
}

// Other settings: against the native program with all sections in it, from the last section to the first.
for (const program of [...programs].reverse()) {
  const usual = await usually.tell(program, {});
  const plain = await unfused.tell(program, {});
  for (const name of differing(usual.told, plain.told)) fault(`${program}: unfused, ${name} differ`);
  for (const name of differing(usual.data, plain.data)) fault(`${program}: unfused, ${name} differs`);
  if (!isDeepStrictEqual(usual.told, JSON.parse(read(`told/${program}.json`))))
    fault(`${program}: in a program with others it tells something else`);
  for (const given of settings(usual.told.parameters)) {
    const where = `${program} with ${JSON.stringify(given)}`;
    const here = await usually.tell(program, given);
    const start = performance.now();
    const there = await engine(program).tell(program, given);
    for (const name of there.told ? figuresOf(program) : [])
      await engine(program)
        .draw(name)
        .catch((error) => fault(`${where}: ${name} cannot be drawn: ${error.message ?? error}`));
    took.push({ ms: performance.now() - start, where });
    compared.settings += 1;
    if (here.refused) compared.refused += 1;
    if ((here.refused ?? here.failed) !== (there.refused ?? there.failed))
      fault(`${where}: refused otherwise`);
    else if (here.told) {
      for (const name of differing(here.told, there.told)) fault(`${where}: ${name} differ`);
      for (const name of differing(here.data, await dataThere(program, there, given)))
        fault(`${where}: ${name} differs`);
    }
  }
}

// And once more, after all that: nothing is left over from run to run.
for (const program of programs) {
  const there = await engine(program).tell(program, {});
  if (there.told && there.text !== read(`told/${program}.txt`))
    fault(`${program}: told again it tells something else`);
}

usually.end();
unfused.end();
console.log(
  `${compared.told} sections, ${compared.data} data, ${compared.figures} figures, ${compared.claims} claims; ` +
    `${compared.settings} other settings (${compared.refused} refused); ${faults} differ`,
);
took.sort((a, b) => a.ms - b.ms);
if (took.length)
  console.log(
    `told and drawn anew in ${took[took.length >> 1].ms.toFixed(0)} ms (median); the slowest: ` +
      took
        .slice(-5)
        .reverse()
        .map(({ ms, where }) => `${ms.toFixed(0)} ms ${where}`)
        .join(', '),
  );
process.exitCode = faults || !compared.settings ? 1 : 0;
