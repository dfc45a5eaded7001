// What book/speeds records: the methods of a section's race; the scenes of the library, their names for files and
// values, and which belong together.

/** The parts of the library that have a benchmark: bench-NAME, recorded as book/speeds/NAME.json. */
export const libraries = ['swing', 'tautochrone', 'balance', 'globe'];

/** A name for files and values: "Φ(t), ζ = 10⁻⁴" is phi-t-zeta-10-4. */
export const idOf = (name) =>
  name
    .replace(/Φ/g, 'phi')
    .replace(/ζ/g, 'zeta')
    .replace(/η/g, 'eta')
    .normalize('NFKD')
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');

/** The recorded methods of a race; none where no run is recorded. */
export const recordedOf = (run, race) => run?.races.find((r) => r.name === race.name)?.methods ?? [];

/** A method's name without what it is given: "GSL ellint_Kcomp of sin ½ζ" is GSL ellint_Kcomp. */
export const plainly = (name) => name.replace(/ of [√s].*$/, '');

/** Scenes of one name before the comma, with the same methods: { id, name, scenes }, each with what follows. */
export function groups(scenes) {
  const found = new Map();
  for (const scene of scenes) {
    const [, name, short] = /^([^,]+), (.*)$/.exec(scene.name) ?? [];
    if (name) found.set(name, [...(found.get(name) ?? []), { ...scene, short }]);
  }
  return [...found].map(([name, list]) => ({ id: idOf(name), name, scenes: list }));
}

/** The methods that belong together as variants of one, "this edition, avx2": what they are called in common. */
export const familyOf = (name) => /^(.*), (?:[\d]|sse|avx|portable)/.exec(name)?.[1];

/** Whose a way of a section's race is: the plot's colour says it. */
export const kindOf = (name) => (/^this edition/.test(name) ? 'ours' : /^Euler/.test(name) ? 'Euler' : 'peer');

/** Relative errors below this are drawn at it; the data keep what they are. */
export const floor = 1e-17;

/** A way's worst error in a scene of the library: over all arguments, or of the one motion that the scene is about. */
export const worst = (m) => m.error ?? m.ulps_max;

/** Whether it gives no number at any of the arguments. */
export const fails = (m) => m.failures !== undefined && m.failures === m.judged;

/** The error at which it is drawn: ulps are not told apart below a twentieth. */
export const drawn = (m) => Math.max(worst(m), m.error === undefined ? 0.05 : floor);

/** Those that no other beats both in time and in error, from the quickest to the most exact. */
export const front = (points) =>
  [...points]
    .sort((a, b) => a.seconds - b.seconds || a.error - b.error)
    .filter((p, i, all) => all.slice(0, i).every((q) => q.error > p.error));
