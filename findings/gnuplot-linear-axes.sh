#!/bin/sh
# gnuplot 5.4.4 (Debian gnuplot-nox 5.4.4+dfsg1-2+b2): GPVAL_X_LOG and GPVAL_Y_LOG, the bases of the axes' logarithms, are 10 for
# axes that have none, and stay what they were when an axis is linear again.
#
# The guess: the base is nought where an axis is linear, so that a script or a test which places something by the axis' ends
# can ask whether to take logarithms. Of a linear axis from -24 to 24 it takes the logarithm of a negative number, and a
# comparison with what is no number says nothing. Way out: look at the script's own `set logscale`.
#
#> linear: x 10, y 10
#> logscale y 2: x 10, y 2
#> y linear again: x 10, y 2
. "$(dirname "$0")/room.sh"
debian gnuplot-nox=5.4.4+dfsg1-2+b2
cat >"$room/ask.gp" <<'G'
set terminal dumb
set output "/dev/null"
say(what) = sprintf("%s: x %g, y %g", what, GPVAL_X_LOG, GPVAL_Y_LOG)
plot [1:10] x
print say("linear")
set logscale y 2
plot [1:10] x
print say("logscale y 2")
unset logscale y
plot [1:10] x
print say("y linear again")
G
in_room gnuplot ask.gp 2>"$room/seen"
as_seen "$room/seen"
