#!/bin/sh
# GNU units 2.22 (Debian units 2.22-2) and pint 0.19.2 (Debian python3-pint 0.19.2-1): sixty turns a minute are 6.28 hertz, and the
# root of g/l is a frequency; js-quantities 1.8.0 and mathjs 15.2.0 (npm) refuse.
#
# The guess: a library of units that is asked for hertz gives cycles a second, or says that it cannot. A turn is 2 pi here and an angle
# a number, so that what turns once a second has 6.28 Hz, and the small swings of a pendulum of a metre, which are half a hertz, have
# 3.13 Hz: the factor that one takes units on to watch over goes through them unseen. And rad/s is not an angular velocity for
# GNU units, where rad is a dose of radiation. Way out: hertz for nothing but what has been divided by 2 pi; radian, not rad.
#
#> units: 60 rpm are 6.2831853 Hz
#> units: the root of g/l is 3.132092 Hz
#> units: rad/s in radian/s: conformability error;0.01 m^2 / s^3;1 radian / s;
#> pint: 60 rpm are 6.2832 Hz
#> pint: the root of g/l is 3.1321 Hz
#> js-quantities, 60 rpm: Incompatible units: rpm and Hz
#> mathjs, 1 rad/s: Units do not match ('Hz' != '1 rad / s')
. "$(dirname "$0")/room.sh"
debian units=2.22-2 python3-pint=0.19.2-1
npm_packages js-quantities@1.8.0 mathjs@15.2.0
cat >"$room/ask.py" <<'PY'
import pint
unit = pint.UnitRegistry()
print('pint: 60 rpm are %.4f Hz' % unit('60 rpm').to('Hz').magnitude)
print('pint: the root of g/l is %.4f Hz' % ((unit('9.81 m/s^2') / unit('1 m')) ** 0.5).to('Hz').magnitude)
PY
cat >"$room/ask.mjs" <<'J'
import Qty from 'js-quantities';
import { evaluate } from 'mathjs';
const tell = (name, ask) => {
  try {
    console.log(`${name}: ${ask()}`);
  } catch (refusal) {
    console.log(`${name}: ${refusal.message ?? refusal}`);
  }
};
tell('js-quantities, 60 rpm', () => Qty('60 rpm').to('Hz').toString());
tell('mathjs, 1 rad/s', () => evaluate('1 rad/s to Hz').toString());
J
{
  echo "units: 60 rpm are $(in_room units --terse '60 rpm' Hz 2>"$room/log") Hz"
  echo "units: the root of g/l is $(in_room units --terse '(9.81 m/s^2 / m)^0.5' Hz 2>"$room/log") Hz"
  echo "units: rad/s in radian/s: $(in_room units --terse rad/s radian/s 2>"$room/log" | tr '\n' ';')"
  in_room /usr/bin/python3 ask.py
  (cd "$room" && node ask.mjs)
} >"$room/seen"
as_seen "$room/seen"
