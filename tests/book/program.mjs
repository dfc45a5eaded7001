// The native program with all sections in it (src/live/all.cpp), asked one question after another.
import { spawn } from 'node:child_process';
import readline from 'node:readline';
import { isDeepStrictEqual } from 'node:util';

export class Program {
  /** `command`: the program, or what runs it and the program. */
  constructor(command, env = {}) {
    const stdio = ['pipe', 'pipe', 'inherit'];
    this.child = spawn(command[0], command.slice(1), { stdio, env: { ...process.env, ...env } });
    this.answers = readline.createInterface({ input: this.child.stdout })[Symbol.asyncIterator]();
  }

  async ask(...question) {
    this.child.stdin.write(`${JSON.stringify(question)}\n`);
    const { value, done } = await this.answers.next();
    if (done) throw new Error(`${this.child.spawnargs.join(' ')}: ended at ${JSON.stringify(question)}`);
    return JSON.parse(value);
  }

  /** What a section tells, with the data of its figures and of its scenes. */
  async tell(program, given) {
    const told = await this.ask('tell', program, given);
    if (!told.told) return told;
    const { data } = await this.ask('frames', program, given);
    return { ...told, data: { ...told.data, ...data } };
  }

  end() {
    this.child.stdin.end();
  }
}

/** The names of what differs in two objects. */
export const differing = (a, b) =>
  Object.keys({ ...a, ...b }).filter((name) => !isDeepStrictEqual(a?.[name], b?.[name]));

/** What came of checks, but for where claims stand: of one that takes several lines two compilers say that each in its own way. */
export const placeless = (checked) =>
  JSON.parse(JSON.stringify(checked, (key, x) => (key === 'line' ? undefined : x)));
