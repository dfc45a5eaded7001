#!/bin/sh
# mathjs 15.2.0 (npm): a product without a sign binds closer than a quotient, unless what stands before it is a quotient of
# two plain numbers; and == and > look at twelve digits only.
#
# The guess: "pi/2 k" and "1/2 k" are read alike. The first is pi/(2 k), the second (1/2) k. And a claim such as
# "error > 0" or "a == b" is about a and b: numbers that differ by one in the thirteenth digit are equal and neither is larger.
# Way out: write every product's sign; compare the difference.
#
#> 1/2 k at k = 4: 2
#> h/2 k at h = 1, k = 4: 0.125
#> 1 == 1 + 1e-13: true
#> 1 + 1e-13 > 1: false
. "$(dirname "$0")/room.sh"
npm_packages mathjs@15.2.0
cat >"$room/ask.mjs" <<'J'
import { evaluate } from 'mathjs';
console.log('1/2 k at k = 4:', evaluate('1/2 k', { k: 4 }));
console.log('h/2 k at h = 1, k = 4:', evaluate('h/2 k', { h: 1, k: 4 }));
for (const claim of ['1 == 1 + 1e-13', '1 + 1e-13 > 1']) console.log(`${claim}:`, evaluate(claim));
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
