// The sections of a chapter and gnuplot, as WebAssembly: what the page's worker asks, and the tests in node. `packs` are what
// pack.mjs packed, by name: { glue, wasm, scripts }.

const style = 'figures/style.gp';

function bytes(base64) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(base64);
  const text = atob(base64);
  const result = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) result[i] = text.charCodeAt(i);
  return result;
}

/** What makes an instance of a packed module whose script calls itself `name`. It is compiled while it is unpacked. */
async function maker({ glue, wasm }, name) {
  const unpacked = new Blob([bytes(wasm)]).stream().pipeThrough(new DecompressionStream('gzip'));
  const type = { headers: { 'Content-Type': 'application/wasm' } };
  const compiled = await WebAssembly.compileStreaming(new Response(unpacked, type));
  const make = new Function(`${glue}; return ${name};`)();
  const instantiateWasm = (imports, done) => {
    const instance = new WebAssembly.Instance(compiled, imports);
    done(instance, compiled);
    return instance.exports;
  };
  return (options = {}) => make({ ...options, instantiateWasm });
}

export class Engine {
  constructor(packs, chapter) {
    this.scripts = { ...packs.gnuplot.scripts, ...packs[chapter].scripts };
    this.edition = maker(packs[chapter], 'Edition').then((make) => make());
    this.gnuplot = maker(packs.gnuplot, 'Gnuplot');
    this.data = {};
    this.drawn = new Map(); // of each figure what it was drawn from last, and what came of it
  }

  async ask(what, program, given, ...more) {
    const edition = await this.edition;
    const types = ['string', 'string', ...more.map(() => 'boolean')];
    return JSON.parse(edition.ccall(what, 'string', types, [program, JSON.stringify(given), ...more]));
  }

  /** { told, text } of a section with `given`, without its figures. */
  say(program, given) {
    return this.ask('live_tell', program, given, false);
  }

  /** { told, text } of a section with `given`; or { refused } or { failed }, a sentence. The data for its figures are kept. */
  async tell(program, given) {
    const { data, ...answer } = await this.ask('live_tell', program, given, true);
    if (data) this.data = data;
    return answer;
  }

  /** The frames of a scene with `given`, tab-separated; or undefined where it has none. */
  async frames(program, scene, given) {
    const { data } = await this.ask('live_frames', program, given);
    return data?.[`${program}.${scene}.tsv`];
  }

  /** { checked } of a section with `given`; or { refused } or { failed }. */
  check(program, given) {
    return this.ask('live_check', program, given);
  }

  /** An instance of gnuplot, which is good for one drawing, and what it says: a fault, for it warns and draws on. */
  async begun() {
    const said = [];
    const say = (line) => said.push(line);
    const quit = (_, status) => {
      throw status;
    };
    const instance = await (await this.gnuplot)({ print: say, printErr: say, quit });
    for (const folder of ['/figures', '/data']) instance.FS.mkdir(folder);
    return { ...instance, said };
  }

  /** The SVG of a figure with the data that were told last; where these are what they were, the one that was drawn. */
  async draw(figure) {
    const words = this.scripts[`figures/${figure}.gp`];
    const named = [...words.matchAll(/\btsv\(([^()]*)\)/g)].map(([, name]) => /^"([^"]*)"$/.exec(name)?.[1]);
    const files = named.every(Boolean) ? named.map((name) => `${name}.tsv`) : Object.keys(this.data);
    const from = files.map((file) => this.data[file]);
    const last = this.drawn.get(figure);
    if (last && from.every((content, i) => content === last.from[i])) return last.svg;
    const svg = await this.drawing(figure);
    this.drawn.set(figure, { from, svg });
    return svg;
  }

  async drawing(figure) {
    const { FS, callMain, said } = await (this.next ?? this.begun());
    this.next = null;
    setTimeout(() => {
      this.next ??= this.begun(); // while nothing is asked
    });
    const script = `figures/${figure}.gp`;
    for (const name of [style, script]) FS.writeFile(`/${name}`, this.scripts[name]);
    for (const [name, content] of Object.entries(this.data)) FS.writeFile(`/data/${name}`, content);
    try {
      callMain(['-e', "data='/data'; out='/drawn.svg'", script]);
    } catch (status) {
      if (status.name !== 'ExitStatus') throw status;
    }
    if (said.length) throw new Error(`${script}: ${said.join(' ')}`);
    return FS.readFile('/drawn.svg', { encoding: 'utf8' });
  }
}
