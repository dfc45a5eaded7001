#include "balance/causes.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "balance/links.hpp"
#include "balance/motion.hpp"

namespace balance::causes
{
namespace
{

using exact::Fifty;

const Balance<>& plain_beam()
{
  static const Balance<> numbers = numbers_of(designed.beam);
  return numbers;
}

State<> beam_and_P()
{
  return released(of_beam, of_P, 0);
}

constexpr double window = 25.1;  // four of the beam's swings to and fro

double looked_until(Cause by)
{
  return 1.5 * theory(by == Cause::none ? Cause::pivot : by);
}

}  // namespace

double theory(Cause by)
{
  if(by == Cause::beam)
    return averaged(plain_beam(), of_beam).time;
  return transfer(balance_with(by)).time;
}

Farthest passing(Cause by)
{
  const double until = looked_until(by);
  if(by != Cause::beam)
    return farthest(pans(balance_with(by), only_P), until, look);
  const Handover over = handover(envelopes(plain_beam(), beam_and_P(), until, window, 400));
  return {over.time, over.Q * of_P, over.P * of_P};
}

std::vector<std::array<double, 2>> way(Cause by)
{
  const double until = 1.3 * theory(by);
  std::vector<std::array<double, 2>> found;
  if(by == Cause::beam)
  {
    for(const Envelope& now : envelopes(plain_beam(), beam_and_P(), until, window, 130))
      found.push_back({now.t, now.Q / of_P});
    return found;
  }
  Full_motion motion(balance_with(by), only_P);
  for(int j = 30; j <= 160; ++j)
  {
    const double time = std::pow(until, j / 160.);
    const Full_state& now = motion.to(time);
    found.push_back({time, std::hypot(now.at.theta, now.rate.theta / 4) / of_P});
  }
  return found;
}

Fifty theory_exactly(Cause by)
{
  const Instrument& x = designed.beam;
  const Fifty M = x.M, c = x.c, a2 = Fifty(x.a) * x.a, m = Fifty(1) / 6;
  const auto inertia = [&](const Fifty& e) { return M * (x.kk + c * c) + 2 * x.L * (a2 + e * e); };
  if(by == Cause::pivot)
    return 5 * exact::pi();
  if(by == Cause::beam)  // §31, (B)
  {
    const Fifty I = inertia(0), lambda2 = 32 * M * c / I, rho = x.L * a2 / I;
    return 2 * exact::pi() * (16 - 4 * lambda2) / (rho * 64 * m * m);
  }
  if(by == Cause::ends)  // σ of §37, near 4
  {
    const Fifty e = balance_with(by).e, I = inertia(e), lambda2 = 32 * (M * c + 2 * e) / I,
                rest = 1 - 2 * e * e / I, sum = lambda2 + 16;
    return exact::pi() / (sqrt((sum + sqrt(sum * sum - 64 * rest * lambda2)) / (2 * rest)) - 4);
  }
  throw std::invalid_argument("where nothing couples the pans, no time is to be had");
}

Farthest judged(Cause by)
{
  if(by == Cause::beam)
  {
    const double time = passing(by).time;
    const Envelope there = mean_by_gsl(time), first = mean_by_gsl(12.6);
    return {time, there.Q / first.P * of_P, there.P / first.P * of_P};
  }
  const links::Built<double> of = links::built(balance_with(by));
  links::Place<double> now = links::place(only_P);
  double at = 0;
  return farthest(
      [&](double time) {
        if(time > at)
          now = links::runge_kutta(of, now, time - at, 3);
        at = time;
        return std::array<double, 2>{now.q[2], now.q[3]};
      },
      looked_until(by), look);
}

Envelope mean_by_gsl(double middle)
{
  return by_gsl_in_the_mean(plain_beam(), beam_and_P(), middle,
                            8 * std::numbers::pi / std::sqrt(plain_beam().lambda2), 400);
}

}  // namespace balance::causes
