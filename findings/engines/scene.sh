# Sourced by the scripts of this folder. Every engine is given, in metres, kilograms and seconds, g = 9.81, steps of
# 1/60 s, its own settings otherwise and nothing that damps:
# - a pendulum: a ball (disc) of radius 0.1 held at its centre, 1 from the axis; from rest at 90 degrees;
# - a loaded ball: radius 1, centre of gravity 0.5 below its middle, moment of inertia 0.4 about it, friction 1, on a
#   level plane; from rest at 1.2 rad.
# After a minute: the mean time of a whole oscillation, and the largest angle of the last five seconds.
. "$(dirname "$0")/../room.sh"

# as_recorded NAME: compares $room/seen, a line of JSON per engine, with book/systems/NAME.json; with RECORD=1 in the
# environment it is written instead.
as_recorded() {
  node - "$(dirname "$0")/../../book/systems/$1.json" "$room/seen" <<'J'
const fs = require('fs');
const [file, seen] = process.argv.slice(2);
const engines = fs.readFileSync(seen, 'utf8').trim().split('\n').map((line) => JSON.parse(line));
if (process.env.RECORD) {
  const recorded = new Date().toISOString().slice(0, 10);
  fs.writeFileSync(file, `${JSON.stringify({ recorded, engines }, null, 2)}\n`);
} else {
  const was = JSON.parse(fs.readFileSync(file, 'utf8'));
  console.log(JSON.stringify(engines, null, 2));
  if (JSON.stringify(was.engines) !== JSON.stringify(engines)) {
    console.error(`no longer what was recorded on ${was.recorded}`);
    process.exit(1);
  }
}
J
}
