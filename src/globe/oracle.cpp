#include "globe/oracle.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "exact/quadrature.hpp"
#include "globe/smooth.hpp"

namespace globe::oracle
{
namespace
{

using exact::Fifty;

// The integral of §13 in y.
class Run
{
public:
  Run(Fifty c, Fifty k, const Energy<Fifty>& e)
      : c_(std::move(c)), k_(std::move(k)), rocks_(e.from_top > 0), least_(rocks_ ? Fifty(1) : e.h),
        most_(rocks_ ? e.h : Fifty(1)), off_(abs(e.from_top))
  {
  }

  Place<Fifty> place(const Fifty& y) const
  {
    const Fifty sh = sinh(y), root = sqrt(1 + sh * sh);
    return {sqrt(most_) * sh / root, sqrt(rest(sh)) / root};
  }

  Fifty rate(const Fifty& y) const
  {
    const Fifty sh = sinh(y), chch = 1 + sh * sh;
    return sqrt(k_ * k_ + 4 * c_ * c_ * most_ * (sh * sh / chch) * (rest(sh) / chch)) / sqrt(b(sh));
  }

  Fifty to(const Fifty& end) const
  {
    std::vector<Fifty> bends{0, asinh(k_ / (2 * c_)), 1, asinh(2 * c_ / k_), 6};
    const Fifty falls = off_ == 0 ? end : asinh(sqrt(least_ / off_));
    for(const double past : {0., 6., 40., 130.})
      bends.push_back(falls + past);
    std::sort(bends.begin(), bends.end());
    Fifty sum = 0;
    for(std::size_t i = 1; i < bends.size() && bends[i - 1] < end; ++i)
      if(bends[i] > bends[i - 1])
        sum += exact::integrate([this](const Fifty& y) { return rate(y); }, bends[i - 1],
                                std::min(bends[i], end))
                   .value;
    return sum;
  }

private:
  Fifty b(const Fifty& sh) const { return least_ + off_ * sh * sh; }
  Fifty rest(const Fifty& sh) const { return rocks_ ? b(sh) : Fifty(1); }  // cos² ½Φ cosh² y

  Fifty c_, k_;
  bool rocks_;
  Fifty least_, most_, off_;
};

Fifty end(const Energy<Fifty>& e, const Place<Fifty>& place)
{
  const Fifty left = e.from_top > 0 ? left_for_motion(e, place) : Fifty(place.c * place.c);
  return asinh(place.s / sqrt(left));
}

}  // namespace

Fifty smooth_time(const Fifty& c, const Fifty& k, const Energy<Fifty>& e, const Place<Fifty>& place)
{
  const Fifty y = end(e, place);
  return isfinite(y) ? Run(c, k, e).to(y) : smooth_quarter(c, k, e);
}

Fifty smooth_quarter(const Fifty& c, const Fifty& k, const Energy<Fifty>& e)
{
  if(e.from_top == 0)
    return std::numeric_limits<double>::infinity();
  return Run(c, k, e).to(asinh(sqrt((1 + e.h) / abs(e.from_top))) + 130);
}

Place<Fifty> smooth_place(const Fifty& c, const Fifty& k, const Energy<Fifty>& e, const Fifty& tau)
{
  const Turned near = smooth::angle(double(c), double(k), {double(e.h), double(e.from_top)}, double(tau));
  const Run run(c, k, e);
  const Place<Fifty> start =
      near.from_top < 1 ? place_from_top(Fifty(near.from_top)) : place(Fifty(near.Phi));
  const Fifty y = end(e, start);
  return run.place(y + (tau - run.to(y)) / run.rate(y));
}

Fifty gauss(int n, const std::function<Fifty(const Fifty&)>& f, const Fifty& a, const Fifty& b)
{
  Fifty sum = 0;
  for(int i = 0; i < n; ++i)
  {
    Fifty x = cos(exact::pi() * (i + Fifty(3) / 4) / (n + Fifty(1) / 2)), slope;
    for(int turn = 0; turn < 9; ++turn)  // Newton's method for the root of Legendre's polynomial
    {
      Fifty p = 1, q = x;
      for(int m = 2; m <= n; ++m)
        p = std::exchange(q, Fifty((2 * m - 1) * x * q - (m - 1) * p) / m);
      slope = n * (p - x * q) / (1 - x * x);
      x -= q / slope;
    }
    sum += f(a + (1 + x) * (b - a) / 2) * (b - a) / ((1 - x * x) * slope * slope);
  }
  return sum;
}

}  // namespace globe::oracle
