/// @file
/// Euler's triangular array for the time of a descent from near the top (§§17–28): its rows, its columns, and
/// what the columns sum to.
///
/// α = ½η is half the angle from the top at which the descent begins, x = sin²α, and the time of the whole
/// descent in units √(b/2g) is K(cos α). With a_n = ½·¾···(2n−1)/2n the array is
///
///     K(cos α) = Σ_m a_m J_m,    J_m = sin²ᵐα ∫ dω/sin²ᵐ⁺¹ω from α to 90°                (rows)
///              = l cot ½α · Σ a_n² xⁿ + cos α · Σ_j S_j x^j,    S_j = Σ_m entry(m, j)    (columns)
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "exact/rational.hpp"
#include "pendulum/series.hpp"

namespace pendulum
{

/// l cot ½α, which is also artanh cos α. Domain: 0 < α ≤ 90°, radians. Real: double (to 3 ulp) or
/// exact::Fifty.
template <class Real>
Real log_cot_half(Real alpha)
{
  using std::atanh, std::cos, std::log, std::tan;
  return alpha < 1 ? -log(tan(alpha / 2)) : atanh(cos(alpha));
}

// [scaled_integral]
/// J_m, the integral of dω/sin²ᵐ⁺¹ω from α to 90° times sin²ᵐα, by Euler's reduction with the powers taken
/// out: nothing overflows, and all terms are positive. Domain: 0 < α ≤ 90°, radians; m ≥ 0. In double to
/// 3/cos²α ulp whatever m is: a step errs by an ulp or two and hands sin²α of its error on.
template <class Real>
Real scaled_integral(int m, Real alpha)
{
  using std::cos, std::sin;
  const Real x = sin(alpha) * sin(alpha);
  Real J = log_cot_half(alpha);
  for(int i = 1; i <= m; ++i)
    J = (cos(alpha) + (2 * i - 1) * x * J) / (2 * i);
  return J;
}
// [scaled_integral]

// [sum_by_rows]
/// The array summed by its rows from 0 to `rows` − 1. It falls short of K(cos α) by about 1/√(π rows),
/// however small α. Domain: 0 < α ≤ 90°, radians; rows ≥ 0.
template <class Real>
Real sum_by_rows(Real alpha, int rows)
{
  using std::cos, std::sin;
  const Real x = sin(alpha) * sin(alpha);
  Real J = log_cot_half(alpha);
  Real a = 1;
  Real sum = 0;
  for(int m = 1; m <= rows; ++m)
  {
    sum += a * J;
    a *= Real(2 * m - 1) / (2 * m);
    J = (cos(alpha) + (2 * m - 1) * x * J) / (2 * m);
  }
  return sum;
}
// [sum_by_rows]

/// The coefficient of cos α sin²ʲα in row m of the array, a_m²/(2(m−j) a_{m−j}), exactly.
/// Domain: 0 ≤ j < m, else std::domain_error.
exact::Rational entry(int m, int j);

// [column_sums]
/// The first sums S_0, S_1, ... of the columns that have cos α as a factor, by the recurrence of §28
/// (j+1)² S_{j+1} = (2j² + 2j + ¾) S_j − j² S_{j−1} − j a_j²/4(j+1), from S_0 = ln 2 and S_1 = ¾ ln 2.
/// The relative error in double grows in proportion to j: below 10⁻¹³ at j = 100, 10⁻¹² at j = 1000.
/// Domain: count ≥ 0.
template <class Real>
std::vector<Real> column_sums(int count)
{
  using std::log;
  std::vector<Real> S;
  Real before = 0;
  Real now = log(Real(2));
  Real a = 1;  // a_j
  for(int j = 0; j < count; ++j)
  {
    S.push_back(now);
    const Real jj = Real(j) * j;
    const Real next = (2 * jj + 2 * j + 0.75) * now - jj * before - j * a * a / (4 * (j + 1));
    before = now;
    now = next / (jj + 2 * j + 1);
    a *= Real(2 * j + 1) / (2 * j + 2);
  }
  return S;
}
// [column_sums]

/// A column's sum, exactly: S = β ln 2 − ρ with fractions β and ρ.
struct ColumnSum
{
  exact::Rational beta;  ///< that of ln 2
  exact::Rational rho;   ///< what is taken away

  /// Its value to fifty digits, less the one that the difference may cost.
  exact::Fifty value() const;
};

/// The same recurrence in exact fractions: S_0, ..., S_{count−1}. Domain: count ≥ 0.
std::vector<ColumnSum> exact_column_sums(int count);

// [sum_by_columns]
/// The array summed by its columns: the logarithmic one whole, and the first `columns` of the others. With
/// J = columns, what is missing lies between S_J x^J cos α/(1 − x S_{J+1}/S_J) and S_J x^J/cos α.
/// Domain: 0 < α < 90°, radians; columns ≥ 0. In double to 4 ulp for α ≤ 75°.
template <class Real>
Real sum_by_columns(Real alpha, int columns)
{
  using std::atan, std::cos, std::sin;
  const Real x = sin(alpha) * sin(alpha);
  const std::vector<Real> S = column_sums<Real>(columns);
  Real polynomial = 0;
  for(auto s = S.rbegin(); s != S.rend(); ++s)
    polynomial = polynomial * x + *s;
  const Real P = ratio_by_mean(4 * atan(Real(1)) - 2 * alpha);  // Σ a_n² xⁿ, whole
  return log_cot_half(alpha) * P + cos(alpha) * polynomial;
}
// [sum_by_columns]

// [sum_with_one_logarithm]
/// The whole array in one column, K(cos α) = Σ a_n² xⁿ (ln(4/sin α) − r_n), where r_n is the sum of
/// 2/((2i+1)(2i+2)) for i < n: its first `terms` terms. Domain: 0 < α < 90°, radians; terms ≥ 0.
template <class Real>
Real sum_with_one_logarithm(Real alpha, int terms)
{
  using std::log, std::sin;
  const Real s = sin(alpha);
  Real logarithm = log(4 / s);
  Real coefficient = 1;
  Real sum = 0;
  for(int n = 0; n < terms; ++n)
  {
    sum += coefficient * logarithm;
    const Real a = Real(2 * n + 1) / (2 * n + 2);
    coefficient *= a * a * s * s;
    logarithm -= Real(2) / ((Real(2) * n + 1) * (2 * n + 2));
  }
  return sum;
}
// [sum_with_one_logarithm]

// [half_versine]
/// q = ½(1 − √(1−vv)), of which D, V and W below are functions; the root is given too, since near v = 1 it
/// cannot be had from v. Domain: 0 ≤ v ≤ 1, root = √(1−vv). Then 0 ≤ q ≤ ½, and q is good to 2 ulp.
template <class Real>
Real half_versine(Real v, Real root)
{
  return v * v / (2 * (1 + root));
}
// [half_versine]

/// √(1−vv), to 2 ulp. Domain: 0 ≤ v ≤ 1.
template <class Real>
Real root_of(Real v)
{
  using std::sqrt;
  return sqrt((1 - v) * (1 + v));
}

// [D]
/// D(v) = l 2 − l(1+√(1−vv)) = Σ a_n v²ⁿ/2n, n ≥ 1 (§22). Domain as half_versine(); in double to 4 ulp.
template <class Real>
Real D(Real v, Real root)
{
  using std::log1p;
  return -log1p(-half_versine(v, root));
}
// [D]

// [V]
/// V(v) = d(D/v)/dv = Σ a_n (2n−1) v²ⁿ⁻²/2n, n ≥ 1 (§23): ¼ at v = 0, infinite at v = 1.
/// Domain as half_versine(); in double to 6 ulp.
template <class Real>
Real V(Real v, Real root)
{
  using std::log1p;
  const Real q = half_versine(v, root);
  const Real slope = q > 0 ? -log1p(-q) / q : Real(1);
  return (1 / root - slope / 2) / (2 * (1 - q));
}
// [V]

// [W]
/// W(v) = ∫V dv/v − ¼ l v = Σ a_{n+1}² v²ⁿ/(2n a_n), n ≥ 1 (§§24–27), W(1) = ¾ l 2. Domain as half_versine();
/// in double to 6 ulp: the infinite parts are cancelled by hand, and what is left of the logarithm,
/// −l(1−q) − q − ½qq, is summed as a series.
template <class Real>
Real W(Real v, Real root)
{
  const Real q = half_versine(v, root);
  Real rest = 0;  // q²/3 + q³/4 + ..., the qth part of it
  Real power = q * q;
  for(int k = 3; rest + power / k > rest; ++k, power *= q)
    rest += power / k;
  return (q * (Real(4.5) - q - q * q) + rest * (1 + 2 * q * (1 - q))) / (8 * (1 - q));
}
// [W]

/// D(v), V(v), W(v) where v is not so near 1 that √(1−vv) must be known better than v tells. Domain: 0 ≤ v ≤
/// 1.
/// @{
template <class Real>
Real D(Real v)
{
  return D(v, root_of(v));
}
template <class Real>
Real V(Real v)
{
  return V(v, root_of(v));
}
template <class Real>
Real W(Real v)
{
  return W(v, root_of(v));
}
/// @}

}  // namespace pendulum
