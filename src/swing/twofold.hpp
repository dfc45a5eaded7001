/// @file
/// Real numbers of 107 bits as the sum of two doubles: enough to prepare a motion for a million periods.
///
/// Only what that needs. The sums and products of two doubles with their exact errors are Knuth's and
/// Dekker's; they hold in round-to-nearest without contraction. The operations err by a few units of 2⁻¹⁰⁴.
#pragma once

#include <cmath>

namespace swing
{

/// hi + lo, where lo is at most half a unit in the last place of hi.
struct Twofold
{
  double hi = 0;  ///< the double nearest to the number
  double lo = 0;  ///< what it lacks
};

/// a + b as it is, for |a| ≥ |b| or a = 0.
inline Twofold ordered_sum(double a, double b)
{
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b as it is.
inline Twofold sum_of(double a, double b)
{
  const double sum = a + b;
  const double from_b = sum - a;
  return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// The upper 26 bits of x; x − head_of(x) has no more.
inline double head_of(double x)
{
  const double wide = x * 0x1.0000002p27;
  return wide - (wide - x);
}

/// a·b as it is.
inline Twofold product_of(double a, double b)
{
  const double product = a * b;
  const double ah = head_of(a);
  const double bh = head_of(b);
  return {product, ((ah * bh - product) + ah * (b - bh) + (a - ah) * bh) + (a - ah) * (b - bh)};
}

/// a + b.
inline Twofold operator+(Twofold a, Twofold b)
{
  const Twofold hi = sum_of(a.hi, b.hi);
  const Twofold lo = sum_of(a.lo, b.lo);
  const Twofold once = ordered_sum(hi.hi, hi.lo + lo.hi);
  return ordered_sum(once.hi, once.lo + lo.lo);
}

/// a·b.
inline Twofold operator*(Twofold a, Twofold b)
{
  const Twofold p = product_of(a.hi, b.hi);
  return ordered_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// −a.
inline Twofold operator-(Twofold a)
{
  return {-a.hi, -a.lo};
}
/// a − b.
inline Twofold operator-(Twofold a, Twofold b)
{
  return a + -b;
}

/// a/b for b ≠ 0.
inline Twofold operator/(Twofold a, Twofold b)
{
  const double first = a.hi / b.hi;
  const Twofold left = a - b * Twofold{first, 0};
  return ordered_sum(first, (left.hi + left.lo) / b.hi);
}

/// The root of a ≥ 0.
inline Twofold sqrt(Twofold a)
{
  if(a.hi <= 0)
    return {};
  if(a.hi < 0x1p-900)  // else what the square of the root is rounded by would be lost
  {
    const Twofold root = sqrt(Twofold{a.hi * 0x1p200, a.lo * 0x1p200});
    return {root.hi * 0x1p-100, root.lo * 0x1p-100};
  }
  const double root = std::sqrt(a.hi);
  const Twofold left = a - product_of(root, root);
  return ordered_sum(root, (left.hi + left.lo) / (2 * root));
}

/// sin x for |x| ≤ π/2, by its series.
inline Twofold sin(Twofold x)
{
  const Twofold square = x * x;
  Twofold term = x;
  Twofold sum = x;
  for(int n = 2; std::abs(term.hi) > 0x1p-108 * std::abs(sum.hi); n += 2)
  {
    term = -(term * square) / Twofold{static_cast<double>(n) * (n + 1), 0};
    sum = sum + term;
  }
  return sum;
}

/// The arithmetic-geometric mean of 1 and b > 0.
inline Twofold agm_of_one_and(Twofold b)
{
  Twofold a{1, 0};
  while(std::abs(a.hi - b.hi) > 1e-17 * a.hi)
  {
    const Twofold sum = a + b;
    b = sqrt(a) * sqrt(b);
    a = {0.5 * sum.hi, 0.5 * sum.lo};
  }
  const Twofold sum = a + b;
  return {0.5 * sum.hi, 0.5 * sum.lo};
}

}  // namespace swing
