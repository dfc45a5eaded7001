#include "minimax.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace generate
{
namespace
{

// Gauss' elimination with pivoting; a is square and is used up.
std::vector<Fifty> solve(std::vector<std::vector<Fifty>> a, std::vector<Fifty> b)
{
  const std::size_t n = b.size();
  for(std::size_t k = 0; k < n; ++k)
  {
    std::size_t pivot = k;
    for(std::size_t i = k + 1; i < n; ++i)
      if(abs(a[i][k]) > abs(a[pivot][k]))
        pivot = i;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for(std::size_t i = k + 1; i < n; ++i)
    {
      const Fifty factor = a[i][k] / a[k][k];
      for(std::size_t j = k; j < n; ++j)
        a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for(std::size_t k = n; k-- > 0;)
  {
    for(std::size_t j = k + 1; j < n; ++j)
      b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

// The combination whose errors at the chosen samples are ±e, alternating; e is the last of the result.
std::vector<Fifty> levelled(const std::vector<Sample>& samples, const std::vector<std::size_t>& chosen)
{
  std::vector<std::vector<Fifty>> a;
  std::vector<Fifty> b;
  for(std::size_t i = 0; i < chosen.size(); ++i)
  {
    a.push_back(samples[chosen[i]].basis);
    a.back().push_back(Fifty(i % 2 == 0 ? 1 : -1));
    b.push_back(samples[chosen[i]].target);
  }
  return solve(std::move(a), std::move(b));
}

Fifty error_at(const Sample& sample, const std::vector<Fifty>& c)
{
  Fifty rest = sample.target;
  for(std::size_t j = 0; j < sample.basis.size(); ++j)
    rest -= c[j] * sample.basis[j];
  return rest;
}

// Where the error is largest between two changes of its sign; then the smaller ones at the ends are
// dropped.
std::vector<std::size_t> extremes(const std::vector<Fifty>& errors, std::size_t wanted)
{
  std::vector<std::size_t> found{0};
  for(std::size_t i = 1; i < errors.size(); ++i)
  {
    if((errors[i] > Fifty(0)) != (errors[found.back()] > Fifty(0)))
      found.push_back(i);
    else if(abs(errors[i]) > abs(errors[found.back()]))
      found.back() = i;
  }
  while(found.size() > wanted)
    found.erase(abs(errors[found.front()]) < abs(errors[found.back()]) ? found.begin() : found.end() - 1);
  return found;
}

}  // namespace

Fit minimax(const std::vector<Sample>& samples)
{
  const std::size_t n = samples.front().basis.size();
  std::vector<std::size_t> chosen;
  for(std::size_t i = 0; i <= n; ++i)
    chosen.push_back(i * (samples.size() - 1) / n);
  for(int round = 0; round < 60; ++round)
  {
    std::vector<Fifty> c = levelled(samples, chosen);
    const Fifty level = abs(c.back());
    c.pop_back();
    std::vector<Fifty> errors;
    for(const Sample& sample : samples)
      errors.push_back(error_at(sample, c));
    std::vector<std::size_t> next = extremes(errors, n + 1);
    Fifty largest = 0;
    for(const Fifty& e : errors)
      largest = std::max(largest, abs(e));
    if(largest < level * Fifty(1.01))
      return {c, largest};
    if(next.size() != n + 1)
      break;
    chosen = std::move(next);
  }
  throw std::runtime_error("minimax: the error does not level out");
}

std::vector<Fifty> through(const std::vector<Fifty>& x, const std::vector<Fifty>& y)
{
  // Newton's divided differences, then multiplied out from the innermost bracket.
  std::vector<Fifty> d = y;
  for(std::size_t k = 1; k < x.size(); ++k)
    for(std::size_t i = x.size(); i-- > k;)
      d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - k]);
  std::vector<Fifty> c{d.back()};
  for(std::size_t i = x.size() - 1; i-- > 0;)
  {
    c.insert(c.begin(), Fifty(0));
    for(std::size_t j = 0; j + 1 < c.size(); ++j)
      c[j] -= x[i] * c[j + 1];
    c[0] += d[i];
  }
  return c;
}

Quotient rational(const std::function<Fifty(const Fifty&)>& f, int n, const Fifty& a, const Fifty& b,
                  const Fifty& centre)
{
  // above − f (below − 1) = f, linear in the coefficients.
  std::vector<std::vector<Fifty>> rows;
  std::vector<Fifty> right;
  for(const Fifty& x : tchebychef_points(2 * n + 1, a, b))
  {
    const Fifty t = x - centre;
    const Fifty value = f(x);
    std::vector<Fifty> row;
    Fifty power = 1;
    for(int j = 0; j <= n; ++j, power *= t)
      row.push_back(power);
    power = t;
    for(int j = 1; j <= n; ++j, power *= t)
      row.push_back(-value * power);
    rows.push_back(std::move(row));
    right.push_back(value);
  }
  const std::vector<Fifty> c = solve(std::move(rows), std::move(right));
  Quotient q{{c.begin(), c.begin() + n + 1}, {Fifty(1)}};
  q.below.insert(q.below.end(), c.begin() + n + 1, c.end());
  return q;
}

Fifty value(const std::vector<Fifty>& c, const Fifty& x)
{
  Fifty sum = 0;
  for(std::size_t j = c.size(); j-- > 0;)
    sum = sum * x + c[j];
  return sum;
}

std::vector<Fifty> tchebychef_points(int n, const Fifty& a, const Fifty& b)
{
  std::vector<Fifty> x;
  for(int i = 0; i < n; ++i)
    x.push_back((a + b) / Fifty(2)
                - (b - a) / Fifty(2) * cos(exact::pi() * Fifty(2 * i + 1) / Fifty(2 * n)));
  return x;
}

}  // namespace generate
