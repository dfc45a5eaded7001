// The edition's K(k) and Φ(t), compiled to WebAssembly, beside what JavaScript's packages have, in one engine: time, and error
// against fifty digits. Usage: node peers.mjs GLUE WASM PACKAGES OUT (the module, the folder with the packages, the record)
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const [glue, wasm, folder, out] = process.argv.slice(2);
const packages = createRequire(path.join(path.resolve(folder), 'package.json'));
const version = (name) =>
  JSON.parse(fs.readFileSync(path.join(folder, 'node_modules', name, 'package.json'), 'utf8')).version;
globalThis.self = { location: { href: 'blob:' } };
globalThis.importScripts = () => {};
const make = new Function(`${fs.readFileSync(glue, 'utf8')}; return Peers;`)();
const compiled = new WebAssembly.Module(fs.readFileSync(wasm));
const ours = await make({
  instantiateWasm: (imports, done) => {
    const instance = new WebAssembly.Instance(compiled, imports);
    done(instance, compiled);
    return instance.exports;
  },
});
const ellipk = packages('@stdlib/math-base-special-ellipk');
const ellipj = packages('@stdlib/math-base-special-ellipj');
const cephes = packages('cephes');
await cephes.compiled;

const n = 4096;
const zeta = 2.5; // of the motion
const k = Math.sin(zeta / 2);
const moduli = Float64Array.from({ length: n }, (_, i) => Math.sin((Math.PI / 2) * ((i + 0.5) / n)));
const times = Float64Array.from({ length: n }, (_, i) => (20 * (i + 0.5)) / n);
const [input, output] = [ours._malloc(8 * n), ours._malloc(8 * n)];
const array = (call, numbers) => (results) => {
  ours.HEAPF64.set(numbers, input / 8);
  call(input, output, n);
  results.set(ours.HEAPF64.subarray(output / 8, output / 8 + n));
};
// A loop of its own for each, as a program has that uses one of them: of one that they share, and of one with the same text, the
// engine knows less.
let loops = 0;
const each = (call, numbers) => {
  loops += 1;
  const loop = `return function loop${loops}(results) { for (let i = 0; i < ${n}; i += 1) results[i] = call(numbers[i]); };`;
  return new Function('call', 'numbers', loop)(call, numbers);
};
// Until it is called, emscripten's name of a function is one that calls it in a roundabout way.
const directly = (name, ...given) => (ours[name](...given), ours[name]);
ours._peers_prepare(zeta);
const empty = 'a call that gives its argument back';
const stdlib = (name) => `@stdlib/${name} ${version(`@stdlib/${name}`)}`;
const races = [
  {
    name: 'K',
    quantity: 'K(k), ζ from 0 to 180°',
    unit: 'ulp',
    error: (i, x) => ours._peers_error_K(moduli[i], x),
    own: (i, x) => ours._peers_error_K_of_m(moduli[i] * moduli[i], x), // k² as it is rounded before the packages get it
    ways: {
      'this edition': each(directly('_peers_K', 0), moduli),
      'this edition, an array': array(ours._peers_K_array, moduli),
      [empty]: each(directly('_peers_given', 0), moduli),
      [stdlib('math-base-special-ellipk')]: each((x) => ellipk(x * x), moduli),
      [`cephes ${version('cephes')}, ellpk`]: each((x) => cephes.ellpk(1 - x * x), moduli),
    },
  },
  {
    name: 'angle',
    quantity: `Φ(t), ζ = ${zeta}, t from 0 to 20 √(b/2g)`,
    unit: 'of ζ',
    error: (i, x) => ours._peers_error_angle(zeta, times[i], x),
    ways: {
      'this edition': each(directly('_peers_angle', 0), times),
      'this edition, an array': array(ours._peers_angle_array, times),
      [stdlib('math-base-special-ellipj')]: each((t) => 2 * Math.asin(k * ellipj(t, k * k)[0]), times),
      [`cephes ${version('cephes')}, ellpj`]: each(
        (t) => 2 * Math.asin(k * cephes.ellpj(t, k * k)[1].sn),
        times,
      ),
    },
  },
];

const median = (x) => [...x].sort((a, b) => a - b)[x.length >> 1];
const seconds = (way, results, repeat) => {
  const start = process.hrtime.bigint();
  for (let i = 0; i < repeat; i += 1) way(results);
  return Number(process.hrtime.bigint() - start) / 1e9 / repeat / n;
};
const record = races.map(({ name, quantity, unit, error, own, ways }) => {
  const results = new Float64Array(n);
  const entries = Object.entries(ways);
  for (const [, way] of entries) seconds(way, results, 20); // warm, and compiled
  const rounds = Array.from({ length: 15 }, () => entries.map(([, way]) => seconds(way, results, 6)));
  return {
    name,
    quantity,
    unit,
    ways: entries.map(([what, way], i) => {
      way(results);
      const worst = (of) => {
        let most = 0;
        for (let j = 0; j < n; j += 8) most = Math.max(most, of(j, results[j]));
        return Number(most.toPrecision(2));
      };
      const theirs = own && what !== empty && !what.startsWith('this edition');
      return {
        name: what,
        seconds: Number(median(rounds.map((r) => r[i])).toPrecision(3)),
        ratio: Number(median(rounds.map((r) => r[i] / r[0])).toPrecision(3)),
        ...(what !== empty ? { error: worst(error) } : {}),
        ...(theirs ? { of_k2: worst(own) } : {}),
      };
    }),
  };
});
fs.writeFileSync(
  out,
  `${JSON.stringify({ engine: `node ${process.versions.node}, V8 ${process.versions.v8}`, races: record }, null, 2)}\n`,
);
for (const { quantity, unit, ways } of record) {
  console.log(quantity);
  for (const w of ways)
    console.log(
      `  ${w.name.padEnd(48)} ${(w.seconds * 1e9).toFixed(1).padStart(8)} ns  × ${w.ratio}  ${w.error ?? ''} ${unit}`,
    );
}
