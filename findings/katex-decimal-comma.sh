#!/bin/sh
# KaTeX 0.19.1 (npm): a decimal comma makes three things of a number, two numbers with a separator between them, also in the
# MathML that a screen reader has; in braces it is one number.
#
# The guess: 3,16621 is set as it is written, only perhaps with a wider gap. It is read out as a list of 3 and 16621. The
# braces of the printed page, 3{,}16621, which are there for the gap, mend the meaning too; a decimal point needs nothing.
#
#> 3,16621   <mn>3</mn><mo separator="true">,</mo><mn>16621</mn>
#> 3{,}16621 <mn>3,16621</mn>
#> 3.16621   <mn>3.16621</mn>
. "$(dirname "$0")/room.sh"
npm_packages katex@0.19.1
cat >"$room/ask.mjs" <<'J'
import katex from 'katex';
for (const number of ['3,16621', '3{,}16621', '3.16621']) {
  const html = katex.renderToString(number, { output: 'mathml' });
  console.log(number.padEnd(9), /<semantics><mrow>(.*?)<\/mrow>/.exec(html)[1]);
}
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
