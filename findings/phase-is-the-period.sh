#!/bin/sh
# Python 3.11 and NumPy 1.24.2 (Debian python3-numpy 1:1.24.2-1+deb12u1), Octave 7.3.0 (octave 7.3.0-2): what is left of a
# time when whole periods are taken off can be the period itself.
#
# The guess: t % T is at least nought and less than T, so that int(t % T / T * n) is a place in a table of n. A time that is
# negative by rounding, as an event at nought is apt to be, gives T, and the place is n: one beyond the
# table. So do %, divmod, numpy.mod, Octave's mod, and x - T*floor(x/T), as one writes it oneself; fmod, and % in C and
# JavaScript, keep the sign instead. Way out: what is not less than T is nought.
#
#> Python: t % T < T: False, place 64 of 64
#> NumPy: mod(t, T) < T: False; remainder(float32) < T: False
#> divmod(t, T): (-1.0, 6.25)
#> math.fmod: -1e-17
#> Octave: mod(t, T) < T: False, 6.25
#> t - T*floor(t/T) < T: False
. "$(dirname "$0")/room.sh"
debian python3-numpy=1:1.24.2-1+deb12u1 octave=7.3.0-2
cat >"$room/ask.py" <<'P'
import math
import numpy
T = 6.25
t = -1e-17
print('Python: t %% T < T: %s, place %d of 64' % (t % T < T, t % T / T * 64))
print('NumPy: mod(t, T) < T: %s; remainder(float32) < T: %s' % (numpy.mod(t, T) < T, numpy.remainder(numpy.float32(t), numpy.float32(T)) < T))
print('divmod(t, T): %s' % (divmod(t, T),))
print('math.fmod: %g' % math.fmod(t, T))
P
cat >"$room/ask.m" <<'M'
T = 6.25;
t = -1e-17;
answer = {"False", "True"};
printf("Octave: mod(t, T) < T: %s, %g\n", answer{1 + (mod(t, T) < T)}, mod(t, T));
printf("t - T*floor(t/T) < T: %s\n", answer{1 + (t - T*floor(t/T) < T)});
M
{
  in_room /usr/bin/python3 ask.py
  in_room octave-cli --quiet ask.m 2>"$room/errors"
} >"$room/seen"
as_seen "$room/seen"
