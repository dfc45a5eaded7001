#!/bin/sh
# decimal.js 10.6.0 (npm; math.js 15.2.0 uses it for its BigNumber): the tangent near a right angle has fewer digits than were asked
# for, the nearer the fewer, and at 1e-15 from it and nearer it is always the same number.
#
# The guess: the tangent has the digits asked for, as sin and cos have them. It is made of the sine alone, by sin/root(1 - sin^2), with
# ten digits in reserve, and near a right angle 1 - sin^2 loses two digits for each one of the distance. Of the twenty digits that
# are the default six are right at 1e-12, and from 1e-15 on it stays the same number, all twenty digits of it shown; of fifty, half
# are right at 1e-24. Nothing that goes with the tangent of half an angle, such as the time of a pendulum near the top, has
# more. Way out: sin(x)/cos(x), which has them all.
#
#> 20 digits, 1e-3 from pi/2: tan 999.999666666644, right digits 19; of sin/cos 19
#> 20 digits, 1e-6 from pi/2: tan 999999.999999635, right digits 17; of sin/cos 19
#> 20 digits, 1e-9 from pi/2: tan 999999999.968, right digits 12; of sin/cos 19
#> 20 digits, 1e-12 from pi/2: tan 999999000001.5, right digits 6; of sin/cos 19
#> 20 digits, 1e-15 from pi/2: tan 707106781186548, right digits 0; of sin/cos 19
#> 20 digits, 1e-18 from pi/2: tan 707106781186548, right digits 0; of sin/cos 19
#> 50 digits, 1e-3 from pi/2: tan 999.999666666644, right digits 49; of sin/cos 49
#> 50 digits, 1e-6 from pi/2: tan 999999.999999667, right digits 48; of sin/cos 49
#> 50 digits, 1e-9 from pi/2: tan 1000000000, right digits 41; of sin/cos 49
#> 50 digits, 1e-12 from pi/2: tan 1000000000000, right digits 35; of sin/cos 49
#> 50 digits, 1e-15 from pi/2: tan 1000000000000000, right digits 30; of sin/cos 49
#> 50 digits, 1e-18 from pi/2: tan 1000000000000000000, right digits 31; of sin/cos 49
#> 50 digits, 1e-24 from pi/2: tan 1e+24, right digits 25; of sin/cos 49
#> 50 digits, 1e-30 from pi/2: tan 7.07106781186548e+29, right digits 0; of sin/cos 49
#> math.js, 20 digits: tan(pi/2 - 1e-15) = 707106781186547.5244
. "$(dirname "$0")/room.sh"
npm_packages decimal.js@10.6.0 mathjs@15.2.0
cat >"$room/ask.mjs" <<'J'
import Decimal from 'decimal.js';
import { create, all } from 'mathjs';
const exact = Decimal.clone({ precision: 160 });
const right = exact.acos(0);
const digits = (value, truth) => Math.floor(-exact.log10(exact.div(value.toString(), truth).minus(1).abs()).toNumber());
for (const precision of [20, 50]) {
  const D = Decimal.clone({ precision });
  for (const distance of ['1e-3', '1e-6', '1e-9', '1e-12', '1e-15', '1e-18', '1e-24', '1e-30']) {
    if (precision === 20 && Number(distance) < 1e-18) continue;
    const x = right.minus(distance).toSignificantDigits(precision).toString();
    const truth = exact.tan(x);
    const [tan, quotient] = [D.tan(x), D.sin(x).div(D.cos(x))];
    const shown = tan.toSignificantDigits(15);
    const [own, other] = [tan, quotient].map((value) => Math.min(Math.max(digits(value, truth), 0), precision - 1));
    console.log(`${precision} digits, ${distance} from pi/2: tan ${shown}, right digits ${own}; of sin/cos ${other}`);
  }
}
const math = create(all, { number: 'BigNumber', precision: 20 });
console.log(`math.js, 20 digits: tan(pi/2 - 1e-15) = ${math.evaluate('tan(pi/2 - 1e-15)')}`);
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
