#!/bin/sh
# CLI11 2.1.2 (Debian libcli11-dev 2.1.2+ds-1): a whole number with a leading nought is read in octal, and one that is too
# large for its type becomes the largest there is, both without a word. Numbers that are not whole are read in decimal.
#
# The guess: 010 is ten, as it is for the option beside it that takes a double; and 9223372036854775808 is refused as 12.7
# is. A table "for the first --terms 010" has eight rows. Way out: a validator or transformer of one's own that looks at the
# text.
#
#> --terms 010: 8
#> --terms 08: refused
#> --terms 12.7: refused
#> --terms 9223372036854775808: 9223372036854775807
#> --length 010: 10
. "$(dirname "$0")/room.sh"
debian libcli11-dev=2.1.2+ds-1
cat >"$room/ask.cpp" <<'C'
#include <CLI/CLI.hpp>
#include <cstdio>
int main(int argc, char** argv)
{
  CLI::App app;
  long terms = 0;
  double length = 0;
  auto* of_terms = app.add_option("--terms", terms);
  app.add_option("--length", length);
  try
  {
    app.parse(argc, argv);
  }
  catch(const CLI::ParseError&)
  {
    std::puts("refused");
    return 0;
  }
  if(of_terms->count()) std::printf("%ld\n", terms);
  else std::printf("%g\n", length);
}
C
in_room c++ -std=c++17 -O0 ask.cpp -o ask
for given in '--terms 010' '--terms 08' '--terms 12.7' '--terms 9223372036854775808' '--length 010'; do
  echo "$given: $("$room/ask" $given)"
done >"$room/seen"
as_seen "$room/seen"
