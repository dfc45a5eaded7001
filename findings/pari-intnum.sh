#!/bin/sh
# PARI 2.15.2 (Debian pari-gp 2.15.2-1): intnum with 38 digits gives the smooth integral of a swing near the top to
# fewer and fewer of them, and prints all 38.
#
# The guess: the integrand of K has no singular point on the way, so that nothing need be told
# to intnum. It has one *near* the way, at the distance of half the angle that is left to the top. Way out: the agm.
#
#> 0.5 rad from the top: digits that agree with the agm: 33
#> 0.01 rad from the top: digits that agree with the agm: 16
#> 0.0001 rad from the top: digits that agree with the agm: 10
. "$(dirname "$0")/room.sh"
debian pari-gp=2.15.2-1
cat >"$room/ask.gp" <<'G'
swing(x) = { my(k = cos(x/2), a = intnum(s = 0, Pi/2, 1/sqrt(1 - k^2 * sin(s)^2)), b = Pi/2/agm(1, sin(x/2))); floor(-log(abs(a/b - 1))/log(10)); }
print("0.5 rad from the top: digits that agree with the agm: ", swing(0.5));
print("0.01 rad from the top: digits that agree with the agm: ", swing(0.01));
print("0.0001 rad from the top: digits that agree with the agm: ", swing(0.0001));
G
in_room gp --quiet --fast ask.gp </dev/null >"$room/seen"
as_seen "$room/seen"
