#include "published.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "swing_published.hpp"

namespace bench::published
{
namespace
{

// c₀ + c₁x + …
template <std::size_t n>
double polynomial(const double (&c)[n], double x)
{
  double sum = c[n - 1];
  for(std::size_t j = n - 1; j-- > 0;)
    sum = sum * x + c[j];
  return sum;
}

double quotient(const Small_quotient& q, double x)
{
  return polynomial(q.above, x - q.middle) / polynomial(q.below, x - q.middle);
}

}  // namespace

double K_in_one_piece(double m1, double logarithm)
{
  return polynomial(one_piece_plain, m1) - logarithm * polynomial(one_piece_with_log, m1);
}

double K_in_one_piece(double m1)
{
  return K_in_one_piece(m1, std::log(m1));
}

double K_by_polynomials(double m1)
{
  const double m = 1 - m1;
  switch(static_cast<int>(m * 20))
  {
    case 0:
    case 1:
      return polynomial(polynomial_0, m - 0.05);
    case 2:
    case 3:
      return polynomial(polynomial_1, m - 0.15);
    case 4:
    case 5:
      return polynomial(polynomial_2, m - 0.25);
    case 6:
    case 7:
      return polynomial(polynomial_3, m - 0.35);
    case 8:
    case 9:
      return polynomial(polynomial_4, m - 0.45);
    case 10:
    case 11:
      return polynomial(polynomial_5, m - 0.55);
    case 12:
    case 13:
      return polynomial(polynomial_6, m - 0.65);
    case 14:
    case 15:
      return polynomial(polynomial_7, m - 0.75);
    case 16:
      return polynomial(polynomial_8, m - 0.825);
    case 17:
      return polynomial(polynomial_9, m - 0.875);
    default:
      return -std::log(m1 * polynomial(nome, m1 - 0.05)) / std::numbers::pi
             * polynomial(polynomial_0, m1 - 0.05);
  }
}

double K_by_quotients(double m1)
{
  for(const Quotient_piece& q : quotients)
    if(m1 > q.end)
      return polynomial(q.above, m1 - q.middle) / polynomial(q.below, m1 - q.middle);
  return -std::log(m1 / 16) * quotient(small_quotients[0], m1) - m1 * quotient(small_quotients[1], m1);
}

// cn = 1 − u²/2! + (1 + 4m) u⁴/4! − (1 + 44m + 16m²) u⁶/6! + …; what five terms leave out below 0.05 is
// less than 2⁻⁵⁵ of the first.
Doubling::Doubling(double k, double kc, double K)
    : kc_(kc), mc_(kc * kc), m_(k * k), K_(K),
      shortest_(0.05), series_{1.0 / 2, -(1 + 4 * m_) / 24, (1 + m_ * (44 + 16 * m_)) / 720,
                               -(1 + m_ * (408 + m_ * (912 + 64 * m_))) / 40320,
                               (1 + m_ * (3688 + m_ * (30768 + m_ * (15808 + 256 * m_)))) / 3628800}
{
}

Doubling Doubling::as_published(double k, double kc)
{
  Doubling d(k, kc, K_by_quotients(kc * kc));
  d.shortest_ = 5.217e-3 - 2.143e-3 * d.m_;
  d.series_[3] = 0;
  d.series_[4] = 0;
  return d;
}

Doubling::Functions Doubling::operator()(double t) const
{
  const double half_periods = std::floor(std::fabs(t) / (2 * K_) + 0.5);
  const double left = std::fabs(t) - half_periods * (2 * K_);
  const bool odd = static_cast<long long>(half_periods) % 2 != 0;
  const double whole = std::fabs(left);
  const bool beyond = whole > K_ / 2;
  double u = beyond ? K_ - whole : whole;
  int n = 0;
  for(; u > shortest_; ++n)
    u *= 0.5;
  double b = u * u * polynomial(series_, u * u);
  double c = 0;
  bool by_cosine = false;
  for(; n > 0; --n)
  {
    if(!by_cosine && b > 0.5)
    {
      c = 1 - b;
      by_cosine = true;
    }
    if(by_cosine)
    {
      const double x = c * c;
      c = (x - (1 - x) * (mc_ + m_ * x)) / (mc_ + m_ * x * (2 - x));
    }
    else
    {
      const double y = b * (2 - b);
      b = 2 * y * (1 - m_ * y) / (1 - m_ * y * y);
    }
  }
  const double cosine = by_cosine ? c : 1 - b;
  const double sine2 = by_cosine ? (1 - c) * (1 + c) : b * (2 - b);
  const double sine = std::sqrt(sine2);
  const double delta = std::sqrt(by_cosine ? mc_ + m_ * cosine * cosine : 1 - m_ * sine2);
  // Of K − u they are cn/dn, kc sn/dn and kc/dn.
  Functions f{sine, cosine, delta};
  if(beyond)
    f = {cosine / delta, kc_ * sine / delta, kc_ / delta};
  if(odd != ((left < 0) != (t < 0)))
    f.sn = -f.sn;
  if(odd)
    f.cn = -f.cn;
  return f;
}

}  // namespace bench::published
