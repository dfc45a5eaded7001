#!/bin/sh
# Boost.Odeint 1.81 (Debian libboost1.81-dev 1.81.0-5+deb12u1; 1.74 the same): adams_bashforth of two to eight steps converges like Euler's
# rule, and extrapolation_stepper, with which it begins, does not converge at all where it steps in place.
#
# The guess: the number behind the name is the order, so that half the step leaves a 32nd of the error with five steps. It
# leaves a half. The first steps, by which a rule of many steps gets its past, are taken by extrapolation_stepper with the
# same state as what goes in and what comes out, and it reads its input again after it has written to it: they land
# somewhere else, by a distance of the order of a step, and no later step can mend that. A pendulum is let go at a right
# angle and followed for a whole period, in n steps; the error is that of angle and speed. Way out: another stepper to begin
# with, as the eighth template argument; the orders are then those of the name. Or adams_bashforth_moulton.
#
#> two steps, n = 320, 640, 1280:                        3.3e-02 1.6e-02 7.9e-03
#> five steps:                                           3.8e-01 1.8e-01 8.7e-02
#> five steps, begun by runge_kutta_fehlberg78:          5.3e-08 1.6e-09 5.1e-11
#> extrapolation_stepper of order four, in place:        3.5e+00 3.6e+00 3.6e+00
#> the same, from one state into another:                8.5e-10 5.3e-11 3.3e-12
. "$(dirname "$0")/room.sh"
debian libboost1.81-dev=1.81.0-5+deb12u1
cat >"$room/ask.cpp" <<'C'
#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>
#include <cmath>
#include <cstdio>
using namespace boost::numeric::odeint;
using State = std::array<double, 2>;
static_assert(BOOST_VERSION == 108100);
constexpr double period = 4 * 1.8540746773013719;
void pendulum(const State& y, State& rate, double)
{
  rate = {y[1], -std::sin(y[0])};
}
template <class Step>
void tell(const char* name, Step step_once)
{
  std::printf("%-53s", name);
  for(const int n : {320, 640, 1280})
  {
    State y{M_PI / 2, 0};
    auto stepper = step_once;
    for(int i = 0; i < n; ++i)
      stepper(y, i * period / n, period / n);
    std::printf(" %.1e", std::abs(y[0] - M_PI / 2) + std::abs(y[1]));
  }
  std::puts("");
}
template <class Stepper>
auto in_place(Stepper stepper)
{
  return [stepper](State& y, double t, double dt) mutable { stepper.do_step(pendulum, y, t, dt); };
}
int main()
{
  tell("two steps, n = 320, 640, 1280:", in_place(adams_bashforth<2, State>()));
  tell("five steps:", in_place(adams_bashforth<5, State>()));
  tell("five steps, begun by runge_kutta_fehlberg78:",
       in_place(adams_bashforth<5, State, double, State, double, array_algebra, default_operations, initially_resizer,
                                runge_kutta_fehlberg78<State>>()));
  tell("extrapolation_stepper of order four, in place:", in_place(extrapolation_stepper<4, State>()));
  tell("the same, from one state into another:",
       [stepper = extrapolation_stepper<4, State>()](State& y, double t, double dt) mutable {
         State next;
         stepper.do_step(pendulum, y, t, next, dt);
         y = next;
       });
}
C
in_room c++ -std=c++17 -O1 -w ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
