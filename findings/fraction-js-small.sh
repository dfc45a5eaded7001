#!/bin/sh
# fraction.js 5.3.4 and math.js 15.2.0 (npm), which uses it: a number below 5e-8 becomes the fraction 0, and what lies as near to
# another is that.
#
# The guess: a fraction is the exact side of things; new Fraction(x) is x, or says that it cannot. A double is made a fraction
# by the mediants of denominators up to ten million, with no word on what is left over. math.js' fraction(1e-8) does the
# same, and fraction('1e-8'), which would say what is meant, is no valid argument. Way out: a string without an exponent.
#
#> new Fraction(1e-7):  1/10000000
#> new Fraction(1e-8):  0
#> new Fraction(1.0000000001):  1
#> new Fraction('0.00000001'):  1/100000000
#> math.js, fraction(1e-8) + fraction(1, 3):  1/3
#> math.js, fraction('1e-8'):  Invalid argument
. "$(dirname "$0")/room.sh"
npm_packages fraction.js@5.3.4 mathjs@15.2.0
cat >"$room/ask.mjs" <<'J'
import Fraction from 'fraction.js';
import { evaluate, format } from 'mathjs';
for (const x of [1e-7, 1e-8, 1.0000000001, '0.00000001']) {
  const shown = typeof x === 'string' ? `'${x}'` : x === 1e-7 ? '1e-7' : x === 1e-8 ? '1e-8' : x;
  console.log(`new Fraction(${shown}):  ${new Fraction(x).toFraction()}`);
}
for (const text of ['fraction(1e-8) + fraction(1, 3)', "fraction('1e-8')"])
  try {
    console.log(`math.js, ${text}:  ${format(evaluate(text))}`);
  } catch (error) {
    console.log(`math.js, ${text}:  ${error.message}`);
  }
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
