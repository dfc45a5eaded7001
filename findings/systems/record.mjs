// What a system was asked and what it said, from two files of lines "key text", as the record that the page
// "Other systems" is made from: book/systems/NAME.json. Without RECORD=1 in the environment the record stays as
// it is and the two are compared.
import fs from 'node:fs';
import path from 'node:path';

const [name, asked, said] = process.argv.slice(2);
const file = path.join(import.meta.dirname, '../../book/systems', `${name}.json`);

const lines = (from) =>
  fs
    .readFileSync(from, 'utf8')
    .split('\n')
    .filter((line) => line.trim())
    .map((line) => /^(\S+)\s+(.*?)\s*$/.exec(line).slice(1));
// A blank inside one of several answers is an underscore there.
const plain = (text) => text.replace(/_/g, ' ');
const answers = new Map(lines(said));
const record = {};
const ways = [];
for (const [key, text] of lines(asked)) {
  const [of, part] = key.split('.');
  if (of === 'T' || of === 'Phi') ways.push({ of, call: text, got: answers.get(key).split(/\s+/).map(plain) });
  else if (part) record[of] = { call: text };
  else record[key] = text;
}
for (const [key, text] of answers) {
  const [of, part] = key.split('.');
  if (of !== 'T' && of !== 'Phi') record[of][part] = plain(text);
}
record.ways = ways;

if (process.env.RECORD) {
  const today = new Date().toISOString().slice(0, 10);
  fs.writeFileSync(file, `${JSON.stringify({ ...record, recorded: today }, null, 2)}\n`);
  console.log(`${file} is written`);
} else {
  const { recorded, ...kept } = JSON.parse(fs.readFileSync(file, 'utf8'));
  const [was, is] = [kept, record].map((r) => JSON.stringify(r, null, 2));
  console.log(is);
  if (was !== is) {
    console.error(`${name}: no longer what was recorded on ${recorded}:\n${was}`);
    process.exit(1);
  }
}
