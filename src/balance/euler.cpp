#include "balance/euler.hpp"

#include <algorithm>
#include <numbers>

namespace balance
{

Balance<> balance_of(const Release& r)
{
  return {r.lambda * r.lambda, r.mu * r.mu, 2 * r.i / r.lambda, r.rho};
}

std::vector<Moment> one_period(const Release& r, int parts)
{
  const Balance<> b = balance_of(r);
  Balance<> longer = b;
  longer.mu2 /= std::pow(1 + r.at.eta * r.at.eta / 16, 2);
  Motion motion(b, {r.at, {}});
  std::vector<Moment> moments;
  for(int k = 0; k <= parts; ++k)
  {
    const double t = 2 * std::numbers::pi / r.lambda * k / parts;
    const Angles<> exact = motion.to(t).at;
    moments.push_back({t, exact, euler(r, t), second_order(b, r.at, t), second_order(longer, r.at, t)});
  }
  return moments;
}

Departure greatest_departure(const Release& r)
{
  Departure greatest{};
  const auto grow = [](double& so_far, double x) { so_far = std::max(so_far, std::abs(x)); };
  for(const Moment& now : one_period(r, 720))
  {
    const Departure d = departure(r, now);
    grow(greatest.strays, d.strays);
    grow(greatest.from_euler, d.from_euler);
    grow(greatest.from_second_order, d.from_second_order);
    grow(greatest.from_lengthened, d.from_lengthened);
  }
  return greatest;
}

}  // namespace balance
