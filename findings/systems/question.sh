# Sourced by the scripts of this folder: the question that all systems are asked. A pendulum is left with the
# angle eta to the top (1 degree, 1e-4 and 1e-9 radians): T/Theta, and the angle Phi half-way in time between the
# lowest point and the turn, u = K/2 after the lowest point (time in units of the root of l/g).
. "$(dirname "$0")/../room.sh"
eta='0.017453292519943295 1e-4 1e-9'
u='3.06388941226336 5.6448909602518995 11.401353689313124'
# The same as a list of the given separator: $(list , $eta).
list() {
  separator=$1
  shift
  printf %s "$1"
  shift
  for x; do printf '%s%s' "$separator" "$x"; done
}

# as_recorded NAME: compares what was asked ($room/asked) and said ($room/said) with book/systems/NAME.json;
# with RECORD=1 in the environment it is written instead.
as_recorded() {
  node "$(dirname "$0")/record.mjs" "$1" "$room/asked" "$room/said"
}
