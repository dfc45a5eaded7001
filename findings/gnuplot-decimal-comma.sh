#!/bin/sh
# gnuplot 5.4.4 (Debian gnuplot-nox 5.4.4+dfsg1-2+b2): a column of numbers with decimal commas is read up to the comma, and no
# record counts as invalid; a quotient of two whole numbers is a whole number.
#
# The guess: what is not a number is left out or counted among the invalid. A table copied from an old book, 1,1803 and
# 3,16621, is drawn as 1 and 3. And 1/4*x is a parabola's slope; it is nought. Way out: replace
# the commas; 1./4.
#
#> 2 records, 0 invalid, from 1 to 3
#> 1/4*8 = 0, 1./4*8 = 2
. "$(dirname "$0")/room.sh"
debian gnuplot-nox=5.4.4+dfsg1-2+b2
printf '%s\n' '1 1,1803' '2 3,16621' >"$room/table"
cat >"$room/ask.gp" <<'G'
stats "table" using 2 nooutput
print sprintf("%d records, %d invalid, from %g to %g", STATS_records, STATS_invalid, STATS_min, STATS_max)
print sprintf("1/4*8 = %g, 1./4*8 = %g", 1/4*8, 1./4*8)
G
in_room gnuplot ask.gp 2>"$room/seen"
as_seen "$room/seen"
