#!/bin/sh
# g++ 12 (Debian g++-12 12.2.0-14+deb12u1): a precompiled header does not keep the templates that the functions of its headers
# call. Each unit makes them anew: one that is a single int makes 587 functions with <cmath>, <memory> and <string> precompiled
# (among them Bessel functions for float and long double, and strings of four kinds of characters), and drops them all. Of an
# empty section's compilation they were nine parts in ten.
#
# The guess: what is precompiled is done, and a unit pays for what it uses. So one adds a header to the precompiled one because
# it costs nothing there; and a short inline function in it is free, where one that stands in a source file is not. Way out:
# in the headers that are precompiled, bodies that call templates move to a source file. (clang has -fpch-instantiate-templates.)
#
#> functions made of "int nothing;":
#> without headers                  0
#> with headers                  1633
#> with headers, precompiled      587
#> symbols in the object            1
. "$(dirname "$0")/room.sh"
debian g++-12=12.2.0-14+deb12u1
printf '#include <cmath>\n#include <memory>\n#include <string>\n' >"$room/headers.hpp"
printf 'int nothing;\n' >"$room/unit.cpp"
cat >"$room/ask" <<'S'
made() { # words, options...
  words=$1
  shift
  : >dump
  g++-12 -std=c++20 -O1 -fdump-tree-original=dump "$@" -c unit.cpp
  printf '%-27s %6d\n' "$words" "$(grep -c '^;; Function' dump)"
}
echo 'functions made of "int nothing;":'
made 'without headers'
made 'with headers' -include headers.hpp
g++-12 -std=c++20 -O1 headers.hpp
made 'with headers, precompiled' -Winvalid-pch -Werror -include headers.hpp
printf '%-27s %6d\n' 'symbols in the object' "$(nm unit.o | wc -l)"
S
in_room sh ask >"$room/seen"
as_seen "$room/seen"
