#!/bin/sh
# doctest 2.4.9 (Debian doctest-dev 2.4.9~ds-1): a test case whose name has a comma cannot be chosen by its name, and the
# message of a failed comparison rounds both sides to six digits.
#
# The guess: --test-case="near the top, at rest" runs the test of that name. The comma ends the first of two filters; no
# name is "near the top" or " at rest", nothing runs, and the exit status is that of success. A backslash helps. And a
# test that fails by one unit of the last place says that a number is not equal to itself. Way out: names without
# commas, or commas with a backslash; a StringMaker of one's own with 17 digits.
#
#> by its name: test cases: 0 | 0 passed | 0 failed | 2 skipped; status 0
#> with a backslash: test cases: 1 | 1 passed | 0 failed | 1 skipped; status 0
#>   values: CHECK( 1.85407 == 1.85407 )
. "$(dirname "$0")/room.sh"
debian doctest-dev=2.4.9~ds-1
cat >"$room/ask.cpp" <<'C'
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
TEST_CASE("near the top, at rest") { CHECK(1 + 1 == 2); }
TEST_CASE("equal") { CHECK(1.8540746773013719 == 1.8540746773013721); }
C
in_room c++ -std=c++17 -O0 -I/usr/include/doctest ask.cpp -o ask
counted() {
  status=0
  "$room/ask" "$1" >"$room/log" || status=$?
  echo "$(sed -n 's/^\[doctest\] \(test cases: .*\)/\1/p' "$room/log" | tr -s ' '); status $status"
}
{
  echo "by its name: $(counted '--test-case=near the top, at rest')"
  echo "with a backslash: $(counted '--test-case=near the top\, at rest')"
  "$room/ask" --test-case=equal | grep values
} >"$room/seen"
as_seen "$room/seen"
