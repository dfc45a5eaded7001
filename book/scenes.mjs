// What book/speeds records: the methods of a section's race; the scenes of the library, their names for files and
// values, and which belong together.

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
