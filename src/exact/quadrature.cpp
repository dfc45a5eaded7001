#include "exact/quadrature.hpp"

#include <stdexcept>
#include <vector>

namespace exact
{
namespace
{

// A node 1 - c of the rule on [-1, 1], in its right half, and its weight per mesh width.
struct Node
{
  Fifty c;
  Fifty weight;
};

// x = tanh(½π sinh t), with q = exp(-π sinh t): 1 - x = 2q/(1+q), dx/dt = 2π cosh t q/(1+q)².
Node node(const Fifty& t)
{
  const Fifty q = exp(-pi() * sinh(t));
  return {2 * q / (1 + q), 2 * pi() * cosh(t) * q / ((1 + q) * (1 + q))};
}

constexpr double last_t = 5.68;  // where 1 - x is 1e-200
constexpr int levels = 9;

// Those of level 0, at t = 1, 2, ...; of a later one those that lie halfway between its forerunners'. They cost as much as
// most integrands, and are the same for all: each thread makes a level once, when it first asks for it.
const std::vector<Node>& nodes(int level)
{
  thread_local std::vector<Node> made[levels + 1];
  std::vector<Node>& of = made[level];
  if(of.empty())
  {
    const Fifty h = ldexp(Fifty(1), -level);
    for(Fifty t = h; t < last_t; t += level == 0 ? h : 2 * h)
      of.push_back(node(t));
  }
  return of;
}

}  // namespace

Integral integrate_from_ends(const std::function<Fifty(const Fifty&, const Fifty&)>& f, const Fifty& a,
                             const Fifty& b, const Fifty& tolerance)
{
  if(!isfinite(a) || !isfinite(b))
  {
    throw std::domain_error("an integral needs finite ends");
  }
  const Fifty half = (b - a) / 2;
  Integral result;
  Fifty sum, size;  // of f and of |f|, over all nodes so far
  const auto add = [&](const Fifty& x, const Fifty& to_nearer_end, const Fifty& weight) {
    const Fifty y = f(x, to_nearer_end) * weight;
    if(!isfinite(y))
    {
      throw std::domain_error("the integrand is not finite at " + x.str(20));
    }
    sum += y;
    size += abs(y);
    ++result.evaluations;
  };

  add(a + half, half, node(0).weight);
  for(int level = 0; level <= levels; ++level)
  {
    const Fifty h = ldexp(Fifty(1), -level);
    for(const auto& [c, weight] : nodes(level))
    {
      add(a + half * c, -half * c, weight);
      add(b - half * c, half * c, weight);
    }
    const Fifty value = half * h * sum;
    const Fifty whole = abs(half) * h * size;
    const Fifty change = abs(value - result.value);
    result.error = change + Fifty("1e-49") * whole;
    result.value = value;
    if(level > 1 && change <= tolerance * whole)
    {
      return result;
    }
  }
  throw std::runtime_error("the integral still changes by " + result.error.str(3));
}

Integral integrate(const std::function<Fifty(const Fifty&)>& f, const Fifty& a, const Fifty& b,
                   const Fifty& tolerance)
{
  // Where x cannot be told from an end, the weight is below 1e-48 of the greatest.
  const auto inside = [&](const Fifty& x, const Fifty&) { return x == a || x == b ? Fifty(0) : f(x); };
  return integrate_from_ends(inside, a, b, tolerance);
}

}  // namespace exact
