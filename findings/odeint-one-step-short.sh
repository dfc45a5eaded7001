#!/bin/sh
# Boost.Odeint 1.81 (Debian libboost1.81-dev 1.81.0-5+deb12u1; 1.74 the same): integrate_const from 0 to 20 in steps of 0.1 with a
# controlled stepper ends at 19.9, and the state that it leaves is the one there.
#
# The guess: what integrate_const(…, x, 0, 20, 0.1, …) leaves in x is the state at 20, as with integrate_adaptive, and to
# whatever tolerance the stepper has been given. The times are added up, and a last step whose end is beyond the end
# by the rounding of two hundred sums is not taken. With a plain stepper the times are multiples, and it depends on the
# quotient: 0.7 is reached in steps of 0.1, 2.3 is not. A pendulum from a right angle, asked with 1e-12. Way out: look at
# the last time that was observed; integrate_adaptive or integrate_n_steps; for places on the way integrate_times.
#
#> integrate_const:    last observed at 19.900, angle there -0.6722
#> integrate_adaptive: last observed at 20.000, angle there -0.5442
#> plain steps of 0.1 to 0.7: last observed at 0.7
#> plain steps of 0.1 to 2.3: last observed at 2.2
. "$(dirname "$0")/room.sh"
debian libboost1.81-dev=1.81.0-5+deb12u1
cat >"$room/ask.cpp" <<'C'
#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>
#include <cmath>
#include <cstdio>
#include <initializer_list>
using namespace boost::numeric::odeint;
using State = std::array<double, 2>;
static_assert(BOOST_VERSION == 108100);
void pendulum(const State& y, State& rate, double)
{
  rate = {y[1], -std::sin(y[0])};
}
int main()
{
  double last = 0;
  const auto observe = [&last](const State&, double t) { last = t; };
  const auto start = State{std::acos(0.0), 0};
  State x = start;
  const auto stepper = [] { return make_controlled(1e-12, 1e-12, runge_kutta_dopri5<State>()); };
  integrate_const(stepper(), pendulum, x, 0.0, 20.0, 0.1, observe);
  std::printf("integrate_const:    last observed at %.3f, angle there %.4f\n", last, x[0]);
  x = start;
  integrate_adaptive(stepper(), pendulum, x, 0.0, 20.0, 0.1, observe);
  std::printf("integrate_adaptive: last observed at %.3f, angle there %.4f\n", last, x[0]);
  for(const double end : {0.7, 2.3})
  {
    x = start;
    integrate_const(runge_kutta4<State>(), pendulum, x, 0.0, end, 0.1, observe);
    std::printf("plain steps of 0.1 to %g: last observed at %g\n", end, last);
  }
}
C
in_room c++ -std=c++17 -O1 ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
