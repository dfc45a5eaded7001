#include "tautochrone/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tautochrone
{
namespace
{

constexpr int fewest_nodes = kernels::lanes, most_nodes = 1944;

// cos²α of the midpoint rules with 8, 24, 72, ... nodes, each time only the new ones.
const std::array<double, most_nodes>& nodes()
{
  static const std::array<double, most_nodes> made = [] {
    std::array<double, most_nodes> cos2{};
    std::size_t filled = 0;
    for(int n = fewest_nodes; filled < most_nodes; n *= 3)
      for(int i = 0; i < n; ++i)
        if(n == fewest_nodes || i % 3 != 1)
        {
          const double cosine = std::cos((i + 0.5) / n * (std::numbers::pi / 2));
          cos2[filled++] = cosine * cosine;
        }
    return cos2;
  }();
  return made;
}

}  // namespace

Path::Path(const exact::Laurent<double>& r, double k)
    : powers_(std::max(r.highest() + 1, 0)), inverse_powers_(std::max(-r.lowest(), 0)), kk_(k * k)
{
  if(powers_ > most_powers || inverse_powers_ > most_powers || r[-1] != 0)
    throw std::domain_error("the radius may have the powers -24 to 23 of cos φ, but not -1");
  if(!(k >= 0 && k <= 1e100))
    throw std::domain_error("a body needs 0 ≤ k/a ≤ 1e100");
  for(int i = 0; i < most_powers; ++i)
  {
    const auto j = static_cast<std::size_t>(i);
    r_[j] = r[i];
    r_inverse_[j] = r[-i - 1];
    over_[j] = r[i] / (i + 1);
    over_inverse_[j] = i == 0 ? 0 : r[-i - 1] / i;
  }
}

double Path::swing_time(double phi0) const
{
  const kernels::Variants& variants = kernels::variants();
  return swing_time(phi0, variants.sum[variants.count - 1]);
}

double Path::swing_time(double phi0, kernels::Sum sum) const
{
  if(!(phi0 > 0 && phi0 < (inverse_powers_ > 0 ? std::numbers::pi / 2 : std::numbers::pi)))
    throw std::domain_error("this amplitude is not between 0 and the curve's end");
  const double half = std::sin(phi0 / 2), uu2 = 2 * half * half;
  const double c0 = inverse_powers_ > 0 ? std::cos(phi0) : 1 - uu2;  // relatively or absolutely good
  // x₀ − x is the integral of r dc from c₀ to c. Its divided difference, by powers of c and of e:
  double rise[most_powers], rise_inverse[most_powers];
  double carried = 0;
  for(int i = powers_; i-- > 0;)
    rise[i] = carried = carried * c0 + over_[static_cast<std::size_t>(i)];
  if(inverse_powers_ > 0)
  {
    const double e0 = 1 / c0;
    carried = 0;
    for(int i = inverse_powers_; i-- > 1;)
    {
      carried = carried * e0 + over_inverse_[static_cast<std::size_t>(i)];
      rise_inverse[i - 1] = carried * e0;
    }
    rise_inverse[inverse_powers_ - 1] = 0;
  }
  const kernels::Swing s{
      powers_, inverse_powers_, r_.data(), rise, r_inverse_.data(), rise_inverse, c0, uu2, kk_};
  double total = 0, coarse = 0;
  for(int n = 3 * fewest_nodes, done = 0; n <= most_nodes; n *= 3)
  {
    for(double sums[3]; done < n; done += 3 * kernels::lanes)
    {
      sum(s, nodes().data() + done, sums);
      if(done == 0)
        coarse = sums[0] / fewest_nodes;
      total += sums[0] + (sums[1] + sums[2]);
    }
    const double fine = total / n;
    if(std::isnan(fine))
      throw std::domain_error("the curve does not rise as far as " + std::to_string(phi0) + " rad");
    if(std::abs(fine - coarse) <= 4e-9 * fine)
      return 2 * std::numbers::pi * fine;
    coarse = fine;
  }
  throw std::runtime_error("the time of the swing does not settle");
}

}  // namespace tautochrone
