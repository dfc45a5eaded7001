#!/bin/sh
# Boost.Multiprecision 1.74 (Debian libboost1.74-dev 1.74.0+ds1-21): a difference of two numbers of cpp_bin_float can miss the
# nearest number. Where more than a quarter and less than half of a unit of the last place is taken from a number whose last bit
# is 1, a whole unit is gone. 1.81 (1.81.0-5+deb12u1) rounds as it should.
#
# The guess: the type rounds to the nearest, as doubles do; with 53 bits it is a double by software, to the bit. But of a number
# that ends in 1, less 0.28 of its last unit, the 1 is gone. So a step that leans on exact differences, as a compensated sum
# does, and a check that a double is the nearest one go wrong in rare cases. Way out: some bits more than are wanted, a newer
# Boost, MPFR.
#
#> what is gone where a part of a unit is taken from 1 + 2 and from 1 + 3 units
#> 1.74, 50 digits:  0.21875 0 0  0.25 0 0  0.28125 0 1  0.46875 0 1  0.5 0 1
#> 1.74, 113 bits:  0.21875 0 0  0.25 0 0  0.28125 0 1  0.46875 0 1  0.5 0 1
#> 1.74, 53 bits:  0.21875 0 0  0.25 0 0  0.28125 0 1  0.46875 0 1  0.5 0 1
#> a double:  0.21875 0 0  0.25 0 0  0.28125 0 0  0.46875 0 0  0.5 0 1
#> 1.81, 50 digits:  0.21875 0 0  0.25 0 0  0.28125 0 0  0.46875 0 0  0.5 0 1
#> 1.81, 113 bits:  0.21875 0 0  0.25 0 0  0.28125 0 0  0.46875 0 0  0.5 0 1
#> 1.81, 53 bits:  0.21875 0 0  0.25 0 0  0.28125 0 0  0.46875 0 0  0.5 0 1
#> a double:  0.21875 0 0  0.25 0 0  0.28125 0 0  0.46875 0 0  0.5 0 1
. "$(dirname "$0")/room.sh"
cat >"$room/ask.cpp" <<'C'
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/version.hpp>
#include <iostream>
#include <limits>
#include <string>
namespace mp = boost::multiprecision;
template <class Number>
void ask(const std::string& name)
{
  using std::ldexp;
  const Number unit = std::numeric_limits<Number>::epsilon();
  std::cout << name << ':';
  for(const double part : {0.21875, 0.25, 0.28125, 0.46875, 0.5})
  {
    std::cout << "  " << part;
    for(const int last : {2, 3})
    {
      const Number from = 1 + last * unit;
      const Number left = from - part * unit;
      std::cout << ' ' << (from - left) / unit;
    }
  }
  std::cout << '\n';
}
int main()
{
  const std::string version = "1." + std::to_string(BOOST_VERSION / 100 % 1000);
  ask<mp::cpp_bin_float_50>(version + ", 50 digits");
  ask<mp::cpp_bin_float_quad>(version + ", 113 bits");
  ask<mp::cpp_bin_float_double>(version + ", 53 bits");
  ask<double>("a double");
}
C
echo 'what is gone where a part of a unit is taken from 1 + 2 and from 1 + 3 units' >"$room/seen"
for version in 1.74-dev=1.74.0+ds1-21 1.81-dev=1.81.0-5+deb12u1; do
  debian libboost$version
  in_room c++ -std=c++17 -O1 -ffp-contract=off ask.cpp -o ask
  "$room/ask" >>"$room/seen"
done
as_seen "$room/seen"
