#!/bin/sh
# Boost.Math 1.81 (Debian libboost1.81-dev 1.81.0-5+deb12u1), autodiff: the derivatives of sinc are right at nought and wrong next
# to it, the higher the more.
#
# The guess: a library has a sinc because sin(x)/x is not to be had at nought, so that it is as good next to it; sinc_pi, the function
# for plain numbers in the same library, is. For numbers that carry derivatives nought alone has the series. Any other number is
# divided, and each derivative is a difference of nearly equal numbers, divided by it once more. Right are -1/3 for the
# second and 1/5 for the fourth: a force of this form that is linearised next to its equilibrium has any stiffness. Way out: the
# series by hand, a polynomial in x * x, below a tenth or so.
#
#> at 0: value 1 (sinc_pi 1), second derivative -0.3333, fourth 0.2
#> at 1e-09: value 1 (sinc_pi 1), second derivative -1, fourth -8e+18
#> at 1e-08: value 1 (sinc_pi 1), second derivative -1, fourth -8e+16
#> at 1e-05: fourth derivative off by more than a thousand times itself
#> at 0.001: fourth derivative off by more than a thousandth
#> at 0.01: fourth derivative off by less than a thousandth
. "$(dirname "$0")/room.sh"
debian libboost1.81-dev=1.81.0-5+deb12u1
cat >"$room/ask.cpp" <<'C'
#include <boost/math/differentiation/autodiff.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <boost/version.hpp>
#include <cmath>
#include <cstdio>
#include <initializer_list>
using boost::math::differentiation::make_fvar;
static_assert(BOOST_VERSION == 108100);
int main()
{
  for(const double x : {0.0, 1e-9, 1e-8})
  {
    const auto y = sinc(make_fvar<double, 4>(x));
    std::printf("at %g: value %.4g (sinc_pi %.4g), second derivative %.4g, fourth %.4g\n", x, y.derivative(0),
      boost::math::sinc_pi(x), y.derivative(2), y.derivative(4));
  }
  for(const double x : {1e-5, 1e-3, 1e-2})
  {
    const double off = std::abs(sinc(make_fvar<double, 4>(x)).derivative(4) * 5 - 1);
    std::printf("at %g: fourth derivative off by %s\n", x,
      off > 1000 ? "more than a thousand times itself" : off < 1e-3 ? "less than a thousandth" : "more than a thousandth");
  }
}
C
in_room c++ -std=c++17 -O1 ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
