#pragma once
/** @file
 * Formal power series, cut off at an order, over any numbers: `Rational` for identities, `Fifty` for values.
 */
#include "exact/rational.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace exact
{

/**
 * A power series c₀ + c₁x + ... + cₙxⁿ + O(xⁿ⁺¹) of the known order n, or a polynomial, of `unlimited` order.
 *
 * No more is pretended to be known than is: a sum or product has the order to which its terms determine it.
 * `Coefficient` needs + - * == and a conversion from `int`, and / where series are divided. A coefficient may
 * itself be a series (in two variables: `Series<Series<Rational>>`) or a `Laurent` polynomial.
 */
template <class Coefficient>
class Series
{
public:
  /// The order of a polynomial: all its coefficients are known.
  static constexpr int unlimited = std::numeric_limits<int>::max();

  Series() = default;  ///< The polynomial 0.
  /// A constant, as a polynomial.
  /// @{
  Series(int constant) : Series(Coefficient(constant)) {}
  Series(const Coefficient& constant) : c_{constant} {}
  /// @}

  /// c₀ + c₁x + ..., known to the given order; by default the polynomial itself.
  /// @throws std::invalid_argument if the order is negative
  explicit Series(std::vector<Coefficient> coefficients, int order = unlimited)
      : c_(std::move(coefficients)), order_(order)
  {
    if(order < 0)
    {
      throw std::invalid_argument("a series needs an order of at least 0");
    }
    if(order != unlimited)
    {
      c_.resize(static_cast<std::size_t>(order) + 1, Coefficient(0));
    }
  }

  /// The variable, x + O(xⁿ⁺¹).
  static Series x(int order = unlimited) { return Series({Coefficient(0), Coefficient(1)}, order); }

  /// The last order known, or `unlimited`.
  int order() const { return order_; }
  /// That of the last coefficient stored; -1 for none.
  int degree() const { return static_cast<int>(c_.size()) - 1; }

  /// The coefficient of xⁿ. @throws std::out_of_range if it is not known
  Coefficient operator[](int n) const
  {
    if(n < 0 || n > order_)
    {
      throw std::out_of_range("the series is known to order " + std::to_string(order_));
    }
    return n > degree() ? Coefficient(0) : c_[static_cast<std::size_t>(n)];
  }

  /// The same, forgetting what lies beyond an order.
  Series truncated(int order) const { return Series(c_, std::min(order, order_)); }

  /// The sum of the known terms at a point, in the point's own arithmetic.
  template <class Point>
  Point operator()(const Point& at) const
  {
    Point sum(0);
    for(auto c = c_.rbegin(); c != c_.rend(); ++c)
    {
      sum = sum * at + Point(*c);
    }
    return sum;
  }

  /// The four operations, each to the order that its terms determine. Two series are equal when their orders
  /// and coefficients are. @throws std::domain_error where a quotient is no such series, or
  /// where both are polynomials, whose quotient needs an order
  /// @{
  Series& operator+=(const Series& b) { return *this = combine(b, std::plus<>{}); }
  Series& operator-=(const Series& b) { return *this = combine(b, std::minus<>{}); }
  Series& operator*=(const Series& b) { return *this = product(*this, b); }
  Series& operator/=(const Series& b) { return *this = quotient(*this, b); }

  friend Series operator+(Series a, const Series& b) { return a += b; }
  friend Series operator-(Series a, const Series& b) { return a -= b; }
  friend Series operator*(const Series& a, const Series& b) { return product(a, b); }
  friend Series operator/(const Series& a, const Series& b) { return quotient(a, b); }
  friend Series operator-(const Series& a) { return Series() - a; }
  friend bool operator==(const Series& a, const Series& b)
  {
    const int last = std::max(a.degree(), b.degree());
    bool same = a.order_ == b.order_;
    for(int n = 0; same && n <= last; ++n)
    {
      same = a[n] == b[n];
    }
    return same;
  }
  /// @}

private:
  // The degree of what two series of these degrees and orders determine: no more than is asked for.
  static int last_known(int degree, int order) { return order == unlimited ? degree : order; }

  template <class Operation>
  Series combine(const Series& b, Operation operation) const
  {
    Series result;
    result.order_ = std::min(order_, b.order_);
    for(int n = 0; n <= last_known(std::max(degree(), b.degree()), result.order_); ++n)
    {
      result.c_.push_back(operation((*this)[n], b[n]));
    }
    return result;
  }

  static Series product(const Series& a, const Series& b)
  {
    Series result;
    result.order_ = std::min(a.order_, b.order_);
    const int last = a.c_.empty() || b.c_.empty() ? -1 : a.degree() + b.degree();
    for(int n = 0; n <= last_known(last, result.order_); ++n)
    {
      Coefficient sum(0);
      for(int i = std::max(0, n - b.degree()); i <= std::min(n, a.degree()); ++i)
      {
        sum = sum + a[i] * b[n - i];
      }
      result.c_.push_back(sum);
    }
    return result;
  }

  // Long division. A common power of x is cancelled first, and costs as many orders.
  static Series quotient(const Series& a, const Series& b)
  {
    int shift = 0;
    while(shift <= b.degree() && b[shift] == Coefficient(0))
    {
      ++shift;
    }
    if(shift > b.degree())
    {
      throw std::domain_error("division of a series by zero");
    }
    const int order = std::min(a.order_, b.order_);
    const bool exact = order == unlimited && shift == b.degree();
    if(order == unlimited && !exact)
    {
      throw std::domain_error("the quotient of two polynomials needs an order");
    }
    const int last = exact ? a.degree() - shift : order - shift;
    if(last < 0 && !exact)
    {
      throw std::domain_error("nothing is known of the quotient");
    }
    for(int n = 0; n < std::min(shift, a.degree() + 1); ++n)
    {
      if(!(a[n] == Coefficient(0)))
      {
        throw std::domain_error("the quotient has negative powers");
      }
    }
    Series result;
    result.order_ = exact ? unlimited : order - shift;
    for(int n = 0; n <= last; ++n)
    {
      Coefficient rest = a[n + shift];
      for(int i = std::max(0, n + shift - b.degree()); i < n; ++i)
      {
        rest = rest - result.c_[static_cast<std::size_t>(i)] * b[n + shift - i];
      }
      result.c_.push_back(rest / b[shift]);
    }
    return result;
  }

  std::vector<Coefficient> c_;
  int order_ = unlimited;
};

/// d/dx, one order less. @throws std::domain_error if only the constant term is known
template <class C>
Series<C> derivative(const Series<C>& a)
{
  const bool polynomial = a.order() == Series<C>::unlimited;
  if(a.order() == 0)
  {
    throw std::domain_error("the derivative of a series known to order 0 is not known");
  }
  std::vector<C> c;
  for(int n = 1; n <= a.degree(); ++n)
  {
    c.push_back(C(n) * a[n]);
  }
  return Series<C>(std::move(c), polynomial ? a.order() : a.order() - 1);
}

/// The integral from 0, one order more.
template <class C>
Series<C> integral(const Series<C>& a)
{
  const bool polynomial = a.order() == Series<C>::unlimited;
  std::vector<C> c = {C(0)};
  for(int n = 0; n <= a.degree(); ++n)
  {
    c.push_back(a[n] / C(n + 1));
  }
  return Series<C>(std::move(c), polynomial ? a.order() : a.order() + 1);
}

/// aⁿ for n ≥ 0, or n < 0 where 1/a exists.
template <class C>
Series<C> pow(const Series<C>& a, int n)
{
  Series<C> power = 1;
  for(int i = 0; i < (n < 0 ? -n : n); ++i)
  {
    power *= a;
  }
  return n < 0 ? Series<C>(1) / power : power;
}

/// a(b(x)). @throws std::domain_error if b has a constant term, unless a is a polynomial
template <class C>
Series<C> compose(const Series<C>& a, const Series<C>& b)
{
  if(a.order() != Series<C>::unlimited && !(b[0] == C(0)))
  {
    throw std::domain_error("a truncated series can only take up a series without a constant term");
  }
  Series<C> sum;
  for(int n = a.degree(); n >= 0; --n)
  {
    sum = sum * b + Series<C>(a[n]);
  }
  return sum.truncated(a.order());
}

namespace formal
{

/// What the functions below ask for: an order to stop at, and the constant term that keeps all rational.
template <class C>
void require(const Series<C>& a, int constant, const char* function)
{
  if(a.order() == Series<C>::unlimited)
  {
    throw std::domain_error(std::string(function) + " of a polynomial needs an order: use truncated()");
  }
  if(!(a[0] == C(constant)))
  {
    throw std::domain_error(std::string(function) + " of a series needs the constant term "
                            + std::to_string(constant));
  }
}

/// y with y' = f y, y(0) = 1.
template <class C>
Series<C> linear(const Series<C>& f, int order)
{
  std::vector<C> y = {C(1)};
  for(int n = 1; n <= order; ++n)
  {
    C sum(0);
    for(int i = 0; i < n; ++i)
    {
      sum = sum + f[n - 1 - i] * y[static_cast<std::size_t>(i)];
    }
    y.push_back(sum / C(n));
  }
  return Series<C>(std::move(y), order);
}

}  // namespace formal

/// exp a, for a without a constant term. @throws std::domain_error otherwise, or for a polynomial
template <class C>
Series<C> exp(const Series<C>& a)
{
  formal::require(a, 0, "exp");
  return a.order() == 0 ? Series<C>({C(1)}, 0) : formal::linear(derivative(a), a.order());
}

/// log a, for a with the constant term 1. @throws std::domain_error otherwise, or for a polynomial
template <class C>
Series<C> log(const Series<C>& a)
{
  formal::require(a, 1, "log");
  return a.order() == 0 ? Series<C>({C(0)}, 0) : integral(derivative(a) / a);
}

/// a^exponent, for a with the constant term 1. @throws std::domain_error otherwise, or for a polynomial
template <class C>
Series<C> pow(const Series<C>& a, const C& exponent)
{
  formal::require(a, 1, "a power");
  return a.order() == 0 ? a : formal::linear(Series<C>(exponent) * (derivative(a) / a), a.order());
}

/// √a, for a with the constant term 1. @throws std::domain_error otherwise, or for a polynomial
template <class C>
Series<C> sqrt(const Series<C>& a)
{
  return pow(a, C(1) / C(2));
}

namespace formal
{

/// The sine and the cosine together, from s' = a'c and c' = -a's.
template <class C>
std::pair<Series<C>, Series<C>> sine_and_cosine(const Series<C>& a)
{
  require(a, 0, "sin and cos");
  std::vector<C> s = {C(0)};
  std::vector<C> c = {C(1)};
  for(int n = 1; n <= a.order(); ++n)
  {
    C ds(0);
    C dc(0);
    for(int i = 1; i <= n; ++i)
    {
      const C slope = C(i) * a[i];
      ds = ds + slope * c[static_cast<std::size_t>(n - i)];
      dc = dc - slope * s[static_cast<std::size_t>(n - i)];
    }
    s.push_back(ds / C(n));
    c.push_back(dc / C(n));
  }
  return {Series<C>(std::move(s), a.order()), Series<C>(std::move(c), a.order())};
}

}  // namespace formal

/// sin a, for a without a constant term. @throws std::domain_error otherwise, or for a polynomial
template <class C>
Series<C> sin(const Series<C>& a)
{
  return formal::sine_and_cosine(a).first;
}

/// cos a, for a without a constant term. @throws std::domain_error otherwise, or for a polynomial
template <class C>
Series<C> cos(const Series<C>& a)
{
  return formal::sine_and_cosine(a).second;
}

/**
 * The series b with a(b(x)) = x, for a = c₁x + ..., c₁ ≠ 0, by Lagrange's theorem: n times the n-th
 * coefficient of b is the coefficient of xⁿ⁻¹ in (x/a)ⁿ.
 * @throws std::domain_error otherwise, or for a polynomial
 */
template <class C>
Series<C> reverse(const Series<C>& a)
{
  formal::require(a, 0, "the reverse");
  if(a.order() == 0 || a[1] == C(0))
  {
    throw std::domain_error("the reverse of a series needs a linear term");
  }
  const Series<C> x_over_a = Series<C>::x(a.order()) / a;
  Series<C> power = 1;
  std::vector<C> b = {C(0)};
  for(int n = 1; n <= a.order(); ++n)
  {
    power *= x_over_a;
    b.push_back(power[n - 1] / C(n));
  }
  return Series<C>(std::move(b), a.order());
}

/**
 * A polynomial in x and 1/x: a finite sum of cₙxⁿ over whole n of either sign.
 */
template <class Coefficient>
class Laurent
{
public:
  Laurent() = default;                                                      ///< Zero.
  Laurent(int constant) : Laurent(Coefficient(constant), 0) {}              ///< A constant.
  Laurent(const Coefficient& c, int n = 0) : lowest_(n), c_{c} { trim(); }  ///< c xⁿ

  /// The lowest power; 0 for zero.
  int lowest() const { return lowest_; }
  /// The highest power; 0 for zero.
  int highest() const { return c_.empty() ? 0 : lowest_ + static_cast<int>(c_.size()) - 1; }

  /// The coefficient of xⁿ.
  Coefficient operator[](int n) const
  {
    const bool stored = n >= lowest_ && n < lowest_ + static_cast<int>(c_.size());
    return stored ? c_[static_cast<std::size_t>(n - lowest_)] : Coefficient(0);
  }

  /// The value at a point other than zero, in the point's own arithmetic, `double`, `Fifty` or `Rational`.
  template <class Point>
  Point operator()(const Point& at) const
  {
    Point sum(0);
    for(auto c = c_.rbegin(); c != c_.rend(); ++c)
    {
      sum = sum * at + Point(*c);
    }
    const Point factor = lowest_ < 0 ? Point(1) / at : at;
    for(int i = 0; i < (lowest_ < 0 ? -lowest_ : lowest_); ++i)
    {
      sum = sum * factor;
    }
    return sum;
  }

  /// Sums, differences, products and equality.
  /// @{
  Laurent& operator+=(const Laurent& b) { return *this = sum(*this, b, Coefficient(1)); }
  Laurent& operator-=(const Laurent& b) { return *this = sum(*this, b, Coefficient(-1)); }
  friend Laurent operator+(const Laurent& a, const Laurent& b) { return sum(a, b, Coefficient(1)); }
  friend Laurent operator-(const Laurent& a, const Laurent& b) { return sum(a, b, Coefficient(-1)); }
  friend Laurent operator-(const Laurent& a) { return Laurent() - a; }

  friend Laurent operator*(const Laurent& a, const Laurent& b)
  {
    Laurent result;
    if(a.c_.empty() || b.c_.empty())
    {
      return result;
    }
    result.lowest_ = a.lowest_ + b.lowest_;
    result.c_.assign(a.c_.size() + b.c_.size() - 1, Coefficient(0));
    for(std::size_t i = 0; i < a.c_.size(); ++i)
    {
      for(std::size_t j = 0; j < b.c_.size(); ++j)
      {
        result.c_[i + j] = result.c_[i + j] + a.c_[i] * b.c_[j];
      }
    }
    result.trim();
    return result;
  }

  friend bool operator==(const Laurent& a, const Laurent& b)
  {
    return a.lowest_ == b.lowest_ && a.c_ == b.c_;
  }
  /// @}

  /// By a single power of x. @throws std::domain_error if b is anything else
  friend Laurent operator/(const Laurent& a, const Laurent& b)
  {
    if(b.c_.size() != 1)
    {
      throw std::domain_error("a Laurent polynomial is divided by a single power only");
    }
    return a * Laurent(Coefficient(1) / b.c_[0], -b.lowest_);
  }

private:
  static Laurent sum(const Laurent& a, const Laurent& b, const Coefficient& factor)
  {
    Laurent result;
    result.lowest_ = std::min(a.lowest_, b.lowest_);
    for(int n = result.lowest_; n <= std::max(a.highest(), b.highest()); ++n)
    {
      result.c_.push_back(a[n] + factor * b[n]);
    }
    result.trim();
    return result;
  }

  // No zero coefficient at either end.
  void trim()
  {
    while(!c_.empty() && c_.back() == Coefficient(0))
    {
      c_.pop_back();
    }
    const auto is_zero = [](const Coefficient& c) { return c == Coefficient(0); };
    const auto first = std::find_if_not(c_.begin(), c_.end(), is_zero);
    lowest_ = c_.empty() ? 0 : lowest_ + static_cast<int>(first - c_.begin());
    c_.erase(c_.begin(), first);
  }

  int lowest_ = 0;
  std::vector<Coefficient> c_;
};

/// d/dx
template <class C>
Laurent<C> derivative(const Laurent<C>& a)
{
  Laurent<C> sum;
  for(int n = a.lowest(); n <= a.highest(); ++n)
  {
    sum += Laurent<C>(C(n) * a[n], n - 1);
  }
  return sum;
}

/// The integral without a constant term. @throws std::domain_error if there is a term 1/x, whose integral is
/// ln x
template <class C>
Laurent<C> integral(const Laurent<C>& a)
{
  if(!(a[-1] == C(0)))
  {
    throw std::domain_error("the integral of 1/x is not a power");
  }
  Laurent<C> sum;
  for(int n = a.lowest(); n <= a.highest(); ++n)
  {
    sum += n == -1 ? Laurent<C>() : Laurent<C>(a[n] / C(n + 1), n + 1);
  }
  return sum;
}

}  // namespace exact
