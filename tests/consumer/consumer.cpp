// The period of a pendulum at 150°, in doubles and in fifty digits, and what of it Euler's series has after five terms.
#include <cstdio>
#include <numbers>

#include <exact/fifty.hpp>
#include <pendulum/series.hpp>
#include <swing/time.hpp>

int main(int argc, char**)
{
  const int narrowed = argc + 0.5;  // a warning of the edition's, and an error there; not here
  const double eta = std::numbers::pi / 6;
  const double ratio = swing::ratio_from_top(eta);
  const exact::Fifty right = pendulum::ratio_by_mean(exact::Fifty(eta));
  std::printf("%.17g %s\n", ratio, right.str(30).c_str());
  return narrowed == 1 && exact::ulps(ratio, right) < 1 && pendulum::series(0.5, 5) < ratio ? 0 : 1;
}
