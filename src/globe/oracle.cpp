#include "globe/oracle.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "exact/quadrature.hpp"
#include "globe/rolling.hpp"
#include "globe/smooth.hpp"

namespace globe::oracle
{
namespace
{

using exact::Fifty;

// What stands under the upper root, from the squares of sin ½Φ and cos ½Φ.
using Moment = std::function<Fifty(const Fifty& ss, const Fifty& tt)>;

// The integral of §13, or of §28, in y; the moment of inertia bends at some more y.
class Run
{
public:
  Run(Moment moment, const Energy<Fifty>& e, std::vector<Fifty> bends)
      : moment_(std::move(moment)), bends_(std::move(bends)), rocks_(e.from_top > 0),
        least_(rocks_ ? Fifty(1) : e.h), most_(rocks_ ? e.h : Fifty(1)), off_(abs(e.from_top))
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
    return sqrt(moment_(most_ * (sh * sh / chch), rest(sh) / chch) / b(sh));
  }

  Fifty to(const Fifty& end) const
  {
    std::vector<Fifty> bends{bends_};
    bends.insert(bends.end(), {0, 1, 6});
    const Fifty falls = off_ == 0 ? end : asinh(sqrt(least_ / off_));
    for(const double past : {0., 6., 40., 130.})
      bends.push_back(falls + past);
    std::sort(bends.begin(), bends.end());
    // Of two that all but coincide one is enough.
    bends.erase(std::unique(bends.begin(), bends.end(),
                            [](const Fifty& one, const Fifty& next) { return next - one < 1e-3; }),
                bends.end());
    Fifty sum = 0;
    for(std::size_t i = 1; i < bends.size() && bends[i - 1] < end; ++i)
      sum += exact::integrate([this](const Fifty& y) { return rate(y); }, bends[i - 1],
                              std::min(bends[i], end))
                 .value;
    return sum;
  }

private:
  Fifty b(const Fifty& sh) const { return least_ + off_ * sh * sh; }
  Fifty rest(const Fifty& sh) const { return rocks_ ? b(sh) : Fifty(1); }  // cos² ½Φ cosh² y

  Moment moment_;
  std::vector<Fifty> bends_;
  bool rocks_;
  Fifty least_, most_, off_;
};

Fifty end(const Energy<Fifty>& e, const Place<Fifty>& place)
{
  const Fifty left = e.from_top > 0 ? left_for_motion(e, place) : Fifty(place.c * place.c);
  return asinh(place.s / sqrt(left));
}

// To rest, or over half a turn.
Fifty to_end(const Run& run, const Energy<Fifty>& e)
{
  if(e.from_top == 0)
    return std::numeric_limits<double>::infinity();
  return run.to(asinh(sqrt((1 + e.h) / abs(e.from_top))) + 130);
}

Fifty to_place(const Run& run, const Energy<Fifty>& e, const Place<Fifty>& place)
{
  const Fifty y = end(e, place);
  return isfinite(y) ? run.to(y) : to_end(run, e);
}

Run smooth_run(const Fifty& c, const Fifty& k, const Energy<Fifty>& e)
{
  const auto moment = [c, k](const Fifty& ss, const Fifty& tt) {
    return Fifty(k * k + 4 * c * c * ss * tt);
  };
  return {moment, e, {asinh(k / (2 * c)), asinh(2 * c / k)}};
}

Run rolling_run(const Ball<Fifty>& ball, const Energy<Fifty>& e)
{
  const Fifty least = bb(ball), more = 4 * ball.a * ball.c;
  const auto moment = [least, more](const Fifty& ss, const Fifty&) { return Fifty(least + more * ss); };
  const Fifty bend = sqrt(least / (more * (e.from_top > 0 ? e.h : Fifty(1))));
  return {moment, e, {asinh(bend), asinh(1 / bend)}};
}

// One step of Newton's method from the double's answer.
Place<Fifty> put_right(const Run& run, const Energy<Fifty>& e, const Turned& near, const Fifty& tau)
{
  const Place<Fifty> start =
      near.from_top < 1 ? place_from_top(Fifty(near.from_top)) : place(Fifty(near.Phi));
  const Fifty y = end(e, start);
  return run.place(y + (tau - run.to(y)) / run.rate(y));
}

}  // namespace

Fifty smooth_time(const Fifty& c, const Fifty& k, const Energy<Fifty>& e, const Place<Fifty>& place)
{
  return to_place(smooth_run(c, k, e), e, place);
}

Fifty smooth_quarter(const Fifty& c, const Fifty& k, const Energy<Fifty>& e)
{
  return to_end(smooth_run(c, k, e), e);
}

Place<Fifty> smooth_place(const Fifty& c, const Fifty& k, const Energy<Fifty>& e, const Fifty& tau)
{
  return put_right(smooth_run(c, k, e), e, smooth::angle(double(c), double(k), rounded(e), double(tau)),
                   tau);
}

Fifty rolling_time(const Ball<Fifty>& ball, const Energy<Fifty>& e, const Place<Fifty>& place)
{
  return to_place(rolling_run(ball, e), e, place);
}

Fifty rolling_quarter(const Ball<Fifty>& ball, const Energy<Fifty>& e)
{
  return to_end(rolling_run(ball, e), e);
}

Place<Fifty> rolling_place(const Ball<Fifty>& ball, const Energy<Fifty>& e, const Fifty& tau)
{
  return put_right(rolling_run(ball, e), e, rolling::angle(rounded(ball), rounded(e), double(tau)), tau);
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
