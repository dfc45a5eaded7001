#!/bin/sh
# fmt 9.1.0 (Debian libfmt-dev 9.1.0+ds1-2) and printf of glibc 2.36 (Debian 12): three significant digits with their noughts, {:#.3g} and
# %#.3g, are sometimes four in fmt and sometimes one in printf.
#
# The guess: both are the form for a column of measured or computed numbers, three digits with the noughts at the end kept, and the
# same. 419.93 is 420. by printf and 420.0 by fmt, which says tenths where units are meant; so is every number whose digits
# before the point are as many as were asked for. 999.96, which becomes 1000 by rounding, is 1.00e+03 by fmt, as the standard of C
# has it, and 1.e+03 by printf, as are 999999.5 with six digits and all that a carry lifts to the exponent. Way out: {:.2e} and
# %.2e, which have the digits always.
#
#> glibc 2.36
#> 4.1993 with three digits: fmt 4.20, printf 4.20
#> 41.993 with three digits: fmt 42.0, printf 42.0
#> 419.93 with three digits: fmt 420.0, printf 420.
#> 999.96 with three digits: fmt 1.00e+03, printf 1.e+03
#> 4199.3 with three digits: fmt 4.20e+03, printf 4.20e+03
#> 981234.4 with six digits: fmt 981234.0, printf 981234.
#> 999999.5 with six digits: fmt 1.00000e+06, printf 1.e+06
. "$(dirname "$0")/room.sh"
debian libfmt-dev=9.1.0+ds1-2
cat >"$room/ask.cpp" <<'C'
#define FMT_HEADER_ONLY
#include <cstdio>
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <initializer_list>
static_assert(FMT_VERSION == 90100);
int main()
{
  std::printf("glibc %s\n", gnu_get_libc_version());
  for(const double x : {4.1993, 41.993, 419.93, 999.96, 4199.3})
    std::printf("%g with three digits: fmt %s, printf %#.3g\n", x, fmt::format("{:#.3g}", x).c_str(), x);
  for(const double x : {981234.4, 999999.5})
    std::printf("%.8g with six digits: fmt %s, printf %#g\n", x, fmt::format("{:#g}", x).c_str(), x);
}
C
in_room c++ -std=c++17 -O1 ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
