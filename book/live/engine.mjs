// The sections of a chapter and gnuplot, as WebAssembly: what the page's worker asks, and the tests in node. `packs` are what
// pack.mjs packed, by name: { glue, wasm, scripts }.

const style = 'figures/style.gp';

async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/** What makes an instance of a packed module whose script calls itself `name`. */
async function maker({ glue, wasm }, name) {
  const compiled = await WebAssembly.compile(await unpacked(wasm));
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
  }

  async ask(what, program, given) {
    const edition = await this.edition;
    return JSON.parse(edition.ccall(what, 'string', ['string', 'string'], [program, JSON.stringify(given)]));
  }

  /** { told, text, data } of a section with `given`; or { refused } or { failed }, a sentence. */
  async tell(program, given) {
    const answer = await this.ask('live_tell', program, given);
    if (answer.data) this.data = answer.data;
    return answer;
  }

  /** { checked } of a section with `given`; or { refused } or { failed }. */
  check(program, given) {
    return this.ask('live_check', program, given);
  }

  /** The SVG of a figure with the data that were told last. What gnuplot says is a fault: it warns and draws on. */
  async draw(figure) {
    const said = [];
    const say = (line) => said.push(line);
    const make = await this.gnuplot;
    const quit = (_, status) => {
      throw status;
    };
    const { FS, callMain } = await make({ print: say, printErr: say, quit });
    for (const folder of ['/figures', '/data']) FS.mkdir(folder);
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
