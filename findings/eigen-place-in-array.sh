#!/bin/sh
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4), as compiled for any x86-64: exp and log of an array depend on where in it the
# number stands. What fills whole vectors is computed by Eigen, the one that is left over at the end by the C library.
#
# The guess: the same number has the same exponential, five times over. In an array of five the last differs from the others
# in the last place for an eighth of all arguments (exp) or a third (log). At the ends of the range they are no longer
# the same number at all: exp(-800) is 5.6e-309 four times, then 0, and the logarithm of the smallest double is wrong by 36.
# sin, tanh and pow of doubles are the C library's throughout. Way out: unaryExpr, if results are to be the same whatever the length.
#
#> exp of one number five times: the last differs for 13 of 100
#> log of one number five times: the last differs for 36 of 100
#> sin of one number five times: the last differs for 0 of 100
#> exp(-800) first 5.6e-309, last 0
#> log(5e-324) first -708.396, last -744.44
. "$(dirname "$0")/room.sh"
debian libeigen3-dev=3.4.0-4
cat >"$room/ask.cpp" <<'C'
#include <Eigen/Core>
#include <cstdio>
using Eigen::ArrayXd;
ArrayXd five(double x)
{
  return ArrayXd::Constant(5, x);
}
template <class F>
void count(const char* name, F f)
{
  int differ = 0;
  const int all = 20000;
  for(int i = 0; i < all; ++i)
  {
    const ArrayXd y = f(five(0.001 + 10 * std::fmod(i * 0.6180339887498949, 1)));
    differ += y[0] != y[4];
  }
  std::printf("%s of one number five times: the last differs for %.0f of 100\n", name, 100.0 * differ / all);
}
int main()
{
  count("exp", [](const ArrayXd& x) -> ArrayXd { return x.exp(); });
  count("log", [](const ArrayXd& x) -> ArrayXd { return x.log(); });
  count("sin", [](const ArrayXd& x) -> ArrayXd { return x.sin(); });
  const ArrayXd low = five(-800).exp(), least = five(5e-324).log();
  std::printf("exp(-800) first %.1e, last %g\n", low[0], low[4]);
  std::printf("log(5e-324) first %g, last %g\n", least[0], least[4]);
}
C
in_room c++ -std=c++17 -O1 -w -isystem /usr/include/eigen3 ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
