// The script ./euler: what it refuses, that one build waits for another, and what it says when it is interrupted. A copy of
// it runs in a folder of its own, where cmake only takes its time. Run with the script's path.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { chmodSync, copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';

const original = path.resolve(process.argv[2]);
const scratch = mkdtempSync(path.join(tmpdir(), 'euler-'));
after(() => rmSync(scratch, { recursive: true }));
const script = path.join(scratch, 'euler');
const log = path.join(scratch, 'log');
const words = path.join(scratch, 'words');
copyFileSync(original, script);
writeFileSync(path.join(scratch, 'CMakePresets.json'), '{}');
for (const folder of ['bin', 'chapters/pendulum', 'figures', 'build/bin']) mkdirSync(path.join(scratch, folder), { recursive: true });
for (const file of ['chapters/section.cpp.in', 'figures/figure.gp.in'])
  copyFileSync(path.join(path.dirname(original), file), path.join(scratch, file));
writeFileSync(path.join(scratch, 'chapters/pendulum/s11.cpp'), 'SECTION(pendulum, 11, "The whole series")\n');

function command(name, text) {
  const file = path.join(scratch, name);
  writeFileSync(file, `#!/usr/bin/env bash\n${text}\n`);
  chmodSync(file, 0o755);
}
command('bin/cmake', `echo "$@" >>${words}; echo begin >>${log}; sleep 0.5; echo end >>${log}`);
command('bin/apt-get', 'exit 1');
command('bin/dpkg-query', 'for p in "$@"; do echo -n "$p=installed "; done');
command('bin/xdg-open', 'exit 1');
command('build/bin/pendulum-11', 'echo told "$@"');

const settings = { encoding: 'utf8', cwd: tmpdir(), env: { ...process.env, PATH: `${scratch}/bin:${process.env.PATH}` } };
const run = (...words) => spawnSync(script, words, settings);
const logged = () => (existsSync(log) ? readFileSync(log, 'utf8').trim().split('\n') : []);

function refuses(words, ...said) {
  const r = run(...words);
  assert.equal(r.status, 1, words.join(' '));
  assert.equal(r.stdout, '', words.join(' '));
  for (const part of said) assert.ok(r.stderr.includes(part), `${words.join(' ')}: "${part}" in ${r.stderr}`);
}

test('what is wrong is refused in one line, and nothing is built for it', () => {
  refuses(['book', 'now'], '"now" is too much');
  refuses(['book', 'live', 'now'], '"now" is too much');
  refuses(['test', 'strict', 'now'], '"now" is too much');
  refuses(['test', 'gcc'], '"gcc"', 'default, strict, clang');
  refuses(['open', 'it'], '"it" is too much');
  refuses(['list', 'all'], '"all" is too much');
  refuses(['run'], 'which section?');
  refuses(['run', 'pendulum', '12'], 'there is no section pendulum 12');
  refuses(['run', '../pendulum', '11'], 'which section?');
  refuses(['page', 'pendulum'], 'which section?');
  refuses(['new', 'pendulum', '0'], 'which section?');
  refuses(['new', 'nowhere', '1'], 'which section?');
  refuses(['new', 'pendulum', '11'], 'chapters/pendulum/s11.cpp is there already');
  refuses(['bake'], '"bake" is not known');
  assert.deepEqual(logged(), []);
});

test('a section is begun in its own place', () => {
  assert.equal(run('new', 'pendulum', '7').status, 0);
  assert.match(readFileSync(path.join(scratch, 'chapters/pendulum/s07.cpp'), 'utf8'), /^SECTION\(pendulum, 7, "/m);
  assert.match(readFileSync(path.join(scratch, 'figures/pendulum-07.gp'), 'utf8'), /tsv\("pendulum-07\./);
  assert.match(run('list').stdout, /^pendulum 7 +The small swing$/m);
});

test('a program is given all its words, and only what it says is on standard output', () => {
  const r = run('run', 'pendulum', '11', '--zeta', '60');
  assert.equal(r.stdout, 'told --zeta 60\n');
  assert.equal(r.status, 0);
});

test('live pages are asked for, kept, and missed where they could not be made', () => {
  const asked = () => readFileSync(words, 'utf8').split('\n').filter((line) => line.startsWith('--preset'));
  mkdirSync(path.join(scratch, 'build/book/html/live'), { recursive: true });
  writeFileSync(path.join(scratch, 'build/book/made-with.json'), '{\n  "live pages": "none here: no compiler"\n}\n');
  const without = run('book', 'live');
  assert.equal(without.status, 1);
  assert.match(without.stdout, /^The book: /);
  assert.match(without.stderr, /^euler: its pages do not run themselves: no compiler$/m);
  assert.equal(asked().at(-1), '--preset default -DEDITION_LIVE=ON');
  writeFileSync(path.join(scratch, 'build/book/html/live/live.js'), '');
  rmSync(words);
  assert.equal(run('book', 'live').status, 0);
  assert.equal(run('book').status, 0);
  assert.equal(run('run', 'pendulum', '11').status, 0);
  assert.deepEqual(asked(), ['--preset default -DEDITION_LIVE=ON'], 'configured once, and again after it had failed');
});

test('the book is opened from anywhere', () => {
  const r = spawnSync(path.join(path.basename(scratch), 'euler'), ['open'], settings);
  assert.equal(r.status, 0, r.stderr);
  assert.match(r.stdout, /^open this in a browser: .*build\/book\/html\/index\.html$/m);
});

test('two builds at once: the second waits', async () => {
  rmSync(log, { force: true });
  const ended = [1, 2].map(
    () => new Promise((done) => spawn(script, ['run', 'pendulum', '11'], { ...settings, stdio: 'ignore' }).on('close', done)),
  );
  assert.deepEqual(await Promise.all(ended), [0, 0]);
  const order = logged();
  assert.ok(order.length >= 4);
  order.forEach((line, i) => assert.equal(line, i % 2 ? 'end' : 'begin', order.join(' ')));
});

test('interrupted, it says so, and not that the build failed', async () => {
  rmSync(log, { force: true });
  const child = spawn(script, ['run', 'pendulum', '11'], { ...settings, detached: true });
  let said = '';
  child.stderr.on('data', (text) => (said += text));
  while (!logged().length) await new Promise((done) => setTimeout(done, 20));
  process.kill(-child.pid, 'SIGINT');
  const status = await new Promise((done) => child.on('close', done));
  assert.equal(status, 130);
  assert.match(said, /^euler: interrupted$/m);
  assert.doesNotMatch(said, /failed/);
});
