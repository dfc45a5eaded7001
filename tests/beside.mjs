// What all sections of a chapter tell in another build (EDITION_BESIDE: another processor, compiler or C++ library) is what they
// tell here, to the last bit: with Euler's numbers and with three other settings; and what came of their checks, unless those
// would take hours, the other processor being emulated. Usage: node beside.mjs CHAPTER checks|telling HERE COMMAND... (HERE:
// all-sections of this build; COMMAND: the other's, with what runs it.) Not part of the tests' every run: ./euler test aarch64,
// libc++ or clang.
import { readdirSync } from 'node:fs';
import { Program, differing, placeless } from './book/program.mjs';
import { settings } from './book/settings.mjs';

const [chapter, extent, ...commands] = process.argv.slice(2);
const [here, there] = [commands.slice(0, 1), commands.slice(1)].map((command) => new Program(command));
const folder = new URL(`../chapters/${chapter}`, import.meta.url);
const sections = readdirSync(folder).flatMap((file) => /^s(\d\d)\.cpp$/.exec(file)?.[1] ?? []);
const count = { sections: 0, settings: 0, refused: 0, values: 0, data: 0, claims: 0 };
let faults = 0;

/** The first place where two answers part, with what each has there. */
function parting(a, b, at = '') {
  if (a === null || b === null || typeof a !== 'object' || typeof b !== 'object')
    return `${at}: ${JSON.stringify(a)?.slice(0, 80)} here, ${JSON.stringify(b)?.slice(0, 80)} there`;
  const [key] = differing(a, b);
  return parting(a[key], b[key], `${at}.${a[key]?.name ?? b[key]?.name ?? key}`);
}

/** Files as lists of lines, so that it is lines that part. */
const lines = ({ data, text, ...rest }) => ({
  ...rest,
  ...(text && { text: text.split('\n') }),
  ...(data && { data: Object.fromEntries(Object.entries(data).map(([name, x]) => [name, x.split('\n')])) }),
});

function compare(where, one, other) {
  for (const name of differing(one, other)) {
    faults += 1;
    console.error(`${where}: ${parting(one[name], other[name], name)}`);
  }
}

for (const section of sections) {
  const program = `${chapter}-${section}`;
  const asked = async (given) => {
    const [one, other] = await Promise.all([here, there].map((p) => p.tell(program, given)));
    compare(`${program} ${JSON.stringify(given)}`, lines(one), lines(other));
    if (one.refused) count.refused += 1;
    count.values += one.told?.values.length ?? 0;
    count.data += Object.keys(one.data ?? {}).length;
    return one;
  };
  const { told } = await asked({});
  count.sections += 1;
  for (const given of settings(told.parameters)) {
    await asked(given);
    count.settings += 1;
  }
  if (extent !== 'checks') continue;
  const [one, other] = await Promise.all([here, there].map((p) => p.ask('check', program, {})));
  count.claims += one.checked.cases.reduce((n, c) => n + c.claims.length, 0);
  compare(`${program} checked`, placeless(one.checked), placeless(other.checked));
}
here.end();
there.end();
console.log(
  `${chapter}: ${count.sections} sections, ${count.settings} other settings (${count.refused} refused), ${count.values} values, ` +
    `${count.data} data, ${count.claims} claims; ${faults} differ`,
);
process.exitCode = faults || !count.settings ? 1 : 0;
