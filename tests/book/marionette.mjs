// Firefox, driven by Marionette: what it speaks on a socket is a message's length, a colon, and JSON. Without a network: all
// that is not a file goes to a proxy that is not there.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import fs from 'node:fs';
import net from 'node:net';
import os from 'node:os';
import path from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';

const preferences = {
  'marionette.port': 0, // one that is free
  'network.proxy.type': 1,
  'network.proxy.http': '127.0.0.1',
  'network.proxy.http_port': 9,
  'network.proxy.ssl': '127.0.0.1',
  'network.proxy.ssl_port': 9,
};

export class Firefox {
  /** Starts the browser with a profile of its own. */
  static async begin(program) {
    const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'firefox-'));
    const lines = Object.entries(preferences).map(([name, x]) => `user_pref("${name}", ${JSON.stringify(x)});\n`);
    fs.writeFileSync(path.join(profile, 'user.js'), lines.join(''));
    const child = spawn(program, ['--headless', '--no-remote', '--marionette', '--profile', profile], { stdio: 'ignore' });
    const file = path.join(profile, 'MarionetteActivePort');
    for (let i = 0; i < 1200 && !(fs.existsSync(file) && fs.readFileSync(file, 'utf8')); i += 1) await pause(100);
    if (!fs.existsSync(file)) {
      child.kill();
      throw new Error(`${program} does not listen`);
    }
    const firefox = new Firefox();
    Object.assign(firefox, { profile, child, asked: 0, waiting: new Map() });
    await firefox.connect(Number(fs.readFileSync(file, 'utf8')));
    await firefox.command('WebDriver:NewSession', {});
    await firefox.command('WebDriver:SetTimeouts', { script: 120000, pageLoad: 120000 });
    return firefox;
  }

  async connect(port) {
    this.socket = net.connect(port, '127.0.0.1');
    let bytes = Buffer.alloc(0);
    this.socket.on('data', (chunk) => {
      bytes = Buffer.concat([bytes, chunk]);
      for (;;) {
        const colon = bytes.indexOf(':');
        const end = colon + 1 + Number(bytes.subarray(0, colon));
        if (colon < 0 || bytes.length < end) return;
        this.take(JSON.parse(bytes.subarray(colon + 1, end)));
        bytes = bytes.subarray(end);
      }
    });
    await once(this.socket, 'connect');
  }

  /** An answer is [1, id, error, result]; the greeting is none. */
  take(message) {
    if (!Array.isArray(message)) return;
    const [, id, error, result] = message;
    const [answered, failed] = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) failed(new Error(`${error.error}: ${error.message}`));
    else answered(result?.value);
  }

  command(name, parameters) {
    this.asked += 1;
    const message = JSON.stringify([0, this.asked, name, parameters]);
    this.socket.write(`${Buffer.byteLength(message)}:${message}`);
    return new Promise((answered, failed) => {
      this.waiting.set(this.asked, [answered, failed]);
    });
  }

  open(url) {
    return this.command('WebDriver:Navigate', { url });
  }

  /** What a function gives when the page runs it; it may be a promise. */
  run(what, ...args) {
    const script = `const done = arguments[arguments.length - 1];
      Promise.resolve((${what})(...[...arguments].slice(0, -1))).then((x) => done({ x }), (e) => done({ fault: String(e) }));`;
    return this.command('WebDriver:ExecuteAsyncScript', { script, args }).then(({ x, fault }) => {
      if (fault) throw new Error(fault);
      return x;
    });
  }

  async end() {
    const gone = once(this.child, 'exit');
    await this.command('Marionette:Quit', { flags: ['eForceQuit'] });
    await gone;
    fs.rmSync(this.profile, { recursive: true, maxRetries: 5 });
  }
}
