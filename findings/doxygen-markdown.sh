#!/bin/sh
# Doxygen 1.9.4 (Debian doxygen 1.9.4-4): three ways in which its Markdown changes what is said, without a warning. A prime
# in a code span closes it, as the second half of `quoted' does, and turns code and prose of the rest of the paragraph
# inside out. A year and a full stop at the beginning of a line are a list's first point, and the year is gone. A per cent
# sign before a letter vanishes.
#
# The guess: CommonMark's rules, in which none of the three happens (a list that does not begin with 1 does not
# interrupt a paragraph). Derivatives have primes, and years get to the beginning of a line whenever a text is filled anew.
# Way out: code between <code> and </code>, or two backticks at each end; a backslash before the stop; %% for a per cent
# sign.
#
#> <p >The slope &lsquo;phi&rsquo;<code>and the time</code>t` are told.</p>
#> <p >It was read in</p><ol type="1"><li>and is printed since.</li></ol>
#> <p >Less by one tenth, 10 is, of it.</p>
. "$(dirname "$0")/room.sh"
debian doxygen=1.9.4-4
cat >"$room/page.md" <<'M'
# A page {#page}

The slope `phi'` and the time `t` are told.

It was read in
1787. and is printed since.

Less by one tenth, 10 %is, of it.
M
printf '%s\n' INPUT=page.md GENERATE_LATEX=NO HAVE_DOT=NO QUIET=YES >"$room/Doxyfile"
in_room doxygen >"$room/log" 2>&1
tr -d '\n' <"$room/html/page.html" | sed 's/.*id="md_page"><\/a> *//; s/<\/div><\/div>.*//; s/^/<p >/; s/ <\/p>/<\/p>/g; s/<\/p><p >/<\/p>\n<p >/g; s/<\/ol>/&\n/; s/$/\n/' | sed '/^<p ><\/p>$/d; /^$/d' >"$room/seen"
as_seen "$room/seen"
