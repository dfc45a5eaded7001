#!/bin/sh
# markdown-it 15.0.3 (npm): with its typographer, which is wanted for quotation marks and dashes, a reference to formula (c)
# becomes a copyright sign, (r) a registered one, (tm) a trade mark; (a) and (b) stay. And stars inside a formula are
# emphasis even between letters, where underscores are not.
#
# The guess: typographer is about quotes. Formulae and figures (a) to (d) are right but for (c). And what holds for x_1_2,
# which is left alone, holds for k*k*m. Way out: the rule "replacements" can be disabled by itself; the formulae must be
# taken out by an inline rule before emphasis is looked for.
#
#> <p>by (a), (b), © and (d)</p>
#> <p>x_1_2 and k<em>k</em>m</p>
#> without replacements: <p>by (a), (b), (c) and “(d)”</p>
. "$(dirname "$0")/room.sh"
npm_packages markdown-it@15.0.3
cat >"$room/ask.mjs" <<'J'
import MarkdownIt from 'markdown-it';
const md = new MarkdownIt({ typographer: true });
console.log(md.render('by (a), (b), (c) and (d)').trim());
console.log(md.render('x_1_2 and k*k*m').trim());
md.disable('replacements');
console.log('without replacements:', md.render('by (a), (b), (c) and "(d)"').trim());
J
(cd "$room" && node ask.mjs) >"$room/seen"
as_seen "$room/seen"
