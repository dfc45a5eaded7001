#!/bin/sh
# gnuplot 5.4.4 (Debian gnuplot-nox 5.4.4+dfsg1-2+b2): where a highest value is met more than once, "stats" gives the place of the
# last one, and of a lowest value that of the first.
#
# The guess: pos_max_y and pos_min_y are the first place where the extreme is met, or the last, but both alike; the manual says neither.
# The same version built with another C library (emscripten's) gave other ones of the places. So a label that is put at the highest
# place of a curve that is periodic or even stands elsewhere from build to build, and of a curve and its mirror image one is
# labelled at the right and one at the left. Way out: look for the extreme in a range where it is met once.
#
#> 5 at 10 60 110 160: max at 160, index 160
#> -5 at 10 60 110 160: min at 10, index 10
#> the same from right to left: max at 10, index 190
#> the same from right to left: min at 160, index 40
. "$(dirname "$0")/room.sh"
debian gnuplot-nox=5.4.4+dfsg1-2+b2
cat >"$room/ask.gp" <<'G'
set print "-"
f(x) = int(x) % 50 == 10 ? 5 : 0
set table "up"; set samples 201; plot [0:200] f(x); unset table
stats "up" using 1:2 name "A" nooutput
stats "up" using 1:(-$2) name "B" nooutput
stats "<tac up | grep -v '^#' | grep ." using 1:2 name "C" nooutput
stats "<tac up | grep -v '^#' | grep ." using 1:(-$2) name "D" nooutput
print sprintf("5 at 10 60 110 160: max at %g, index %d", A_pos_max_y, A_index_max_y)
print sprintf("-5 at 10 60 110 160: min at %g, index %d", B_pos_min_y, B_index_min_y)
print sprintf("the same from right to left: max at %g, index %d", C_pos_max_y, C_index_max_y)
print sprintf("the same from right to left: min at %g, index %d", D_pos_min_y, D_index_min_y)
G
in_room gnuplot ask.gp >"$room/seen" 2>&1
as_seen "$room/seen"
