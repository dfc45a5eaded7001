#!/bin/sh
# Boost.Multiprecision 1.74 (Debian libboost1.74-dev 1.74.0+ds1-21): the sine of a number of fifty digits has fewer digits the
# larger the number is, and beyond some 1e50 it is nought, without a word; cpp_bin_float and cpp_dec_float do it alike. In 1.81
# (1.81.0-5+deb12u1) the digits are there, and the nought still is.
#
# The guess: that is what many digits are for; a double's sine is right to the last place for 1e22 as it is for 1, in every C
# library. But turns are taken off with a pi of hardly more than the number's own digits. So a check "in fifty digits" of an
# angle after 1e30 turns has twenty. Way out: for the reduction a type with as many digits more as the number has before
# the point; mpmath and MPFR see to that themselves.
#
#> digits of sin x that are right, for x = 10^10, 10^20, 10^30, 10^40, 10^50, 10^60
#> 1.74, cpp_bin_float_50: 40 31 20 10 1 0
#> 1.74, cpp_dec_float_50: 50 48 39 31 0 0
#> sin 10^60: 0 and 0, with 200 digits 0.830389765219
#> 1.81, cpp_bin_float_50: 50 50 50 50 50 0
#> 1.81, cpp_dec_float_50: 50 50 50 50 0 0
#> sin 10^60: 0 and 0, with 200 digits 0.830389765219
. "$(dirname "$0")/room.sh"
cat >"$room/ask.cpp" <<'C'
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/version.hpp>
#include <iomanip>
#include <iostream>
#include <string>
namespace mp = boost::multiprecision;
using Long = mp::number<mp::cpp_dec_float<200>>;
std::string ten_to(int power)
{
  return "1e" + std::to_string(power);
}
template <class Number>
void digits(const char* name)
{
  std::cout << "1." << BOOST_VERSION / 100 % 1000 << ", " << name << ":";
  for(int power = 10; power <= 60; power += 10)
  {
    const Long exact = sin(Long(ten_to(power)));
    const Long off = abs(Long(sin(Number(ten_to(power))).str(70, std::ios::scientific)) / exact - 1);
    std::cout << ' ' << (off == 0 ? 50 : std::clamp(static_cast<int>(-log10(off).convert_to<double>()), 0, 50));
  }
  std::cout << '\n';
}
int main()
{
  digits<mp::cpp_bin_float_50>("cpp_bin_float_50");
  digits<mp::cpp_dec_float_50>("cpp_dec_float_50");
  std::cout << std::setprecision(12) << "sin 10^60: " << sin(mp::cpp_bin_float_50("1e60")) << " and "
            << sin(mp::cpp_dec_float_50("1e60")) << ", with 200 digits " << sin(Long("1e60")) << '\n';
}
C
echo 'digits of sin x that are right, for x = 10^10, 10^20, 10^30, 10^40, 10^50, 10^60' >"$room/seen"
for version in 1.74-dev=1.74.0+ds1-21 1.81-dev=1.81.0-5+deb12u1; do
  debian libboost$version
  in_room c++ -std=c++17 -O1 ask.cpp -o ask
  "$room/ask" >>"$room/seen"
done
as_seen "$room/seen"
