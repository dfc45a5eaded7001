#include "exact/ode.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace exact
{
namespace
{

using std::size_t;

// a += h b
void go_along(State& a, const Fifty& h, const State& b)
{
  for(size_t i = 0; i < a.size(); ++i)
  {
    a[i] += h * b[i];
  }
}

// The greatest difference, absolute where |y| < 1, else relative.
Fifty distance(const State& x, const State& y)
{
  Fifty greatest;
  for(size_t i = 0; i < x.size(); ++i)
  {
    greatest = std::max(greatest, abs(x[i] - y[i]) / std::max(Fifty(1), abs(y[i])));
  }
  return greatest;
}

bool all_finite(const State& y)
{
  return std::all_of(y.begin(), y.end(), [](const Fifty& component) { return isfinite(component); });
}

// A step led to where the right-hand side is not finite.
struct StepTooLong
{
};

class Extrapolation
{
public:
  Extrapolation(const RightSide& f, size_t columns) : f_(f), columns_(columns) {}

  State run(Fifty t, State y, const Fifty& t1, const Fifty& tolerance);
  int evaluations = 0;

private:
  State slope(const Fifty& t, const State& y);
  State midpoint(const Fifty& t, const State& y, const State& slope0, const Fifty& step, int parts);
  Fifty extrapolate(const Fifty& t, const State& y, const Fifty& step, State& result);

  const RightSide& f_;
  size_t columns_;
};

State Extrapolation::slope(const Fifty& t, const State& y)
{
  ++evaluations;
  State result = f_(t, y);
  if(result.size() != y.size())
  {
    throw std::invalid_argument("the right-hand side has not as many components as the state");
  }
  if(!all_finite(result))
  {
    throw StepTooLong{};
  }
  return result;
}

// Gragg's rule: its error is a series in even powers of step/parts, parts even.
State Extrapolation::midpoint(const Fifty& t, const State& y, const State& slope0, const Fifty& step,
                              int parts)
{
  const Fifty h = step / parts, twice = 2 * h;
  State before = y;
  State now = y;
  go_along(now, h, slope0);
  for(int i = 1; i < parts; ++i)
  {
    go_along(before, twice, slope(t + i * h, now));
    std::swap(before, now);
  }
  return now;
}

// The step with all columns in `result`; the answer is how far the last two columns differ.
Fifty Extrapolation::extrapolate(const Fifty& t, const State& y, const Fifty& step, State& result)
{
  const State slope0 = slope(t, y);
  std::vector<State> row;
  for(size_t j = 0; j < columns_; ++j)
  {
    const int parts = 2 * static_cast<int>(j + 1);
    State value = midpoint(t, y, slope0, step, parts);
    for(size_t k = 0; k < j; ++k)
    {  // Aitken and Neville
      const Fifty ratio = Fifty(parts) / (2 * static_cast<int>(j - k));
      State better = value;
      for(size_t i = 0; i < better.size(); ++i)
      {
        better[i] += (value[i] - row[k][i]) / (ratio * ratio - 1);
      }
      row[k] = std::move(value);
      value = std::move(better);
    }
    row.push_back(std::move(value));
  }
  result = row[columns_ - 1];
  return distance(row[columns_ - 2], result);
}

State Extrapolation::run(Fifty t, State y, const Fifty& t1, const Fifty& tolerance)
{
  constexpr int most_steps = 100'000;
  const Fifty whole = t1 - t;
  const double order = 2.0 * static_cast<double>(columns_) - 1;
  Fifty step = whole;
  for(int steps = 0; t != t1; ++steps)
  {
    const bool last = abs(step) >= abs(t1 - t);
    if(last)
    {
      step = t1 - t;
    }
    double factor = 0.1;
    try
    {
      State next;
      const Fifty error = extrapolate(t, y, step, next);
      if(error <= tolerance)
      {
        t = last ? t1 : t + step;
        y = std::move(next);
      }
      const double ratio = std::max(static_cast<double>(error / tolerance), 1e-30);
      factor = std::clamp(0.8 * std::pow(ratio, -1 / order), 0.1, 3.0);
    }
    catch(const StepTooLong&)
    {
    }
    step *= factor;
    if(steps == most_steps || abs(step) < abs(whole) * Fifty("1e-30"))
    {
      throw std::runtime_error("the integration cannot pass t = " + t.str(20));
    }
  }
  return y;
}

}  // namespace

Solution solve(const RightSide& f, const Fifty& t0, const State& y0, const Fifty& t1,
               const Fifty& tolerance)
{
  if(!(tolerance >= Fifty("1e-40") && tolerance <= Fifty("1e-3")))
  {
    throw std::invalid_argument("the tolerance must lie between 1e-40 and 1e-3, not at "
                                + tolerance.str(3));
  }
  if(!all_finite(y0) || !isfinite(t0) || !isfinite(t1))
  {
    throw std::invalid_argument("the start or the end of the integration is not finite");
  }
  // The cheapest number on a Kepler ellipse: a column for every three digits.
  const auto columns = static_cast<size_t>(std::ceil(3 - std::log10(static_cast<double>(tolerance)) / 3));
  Extrapolation first(f, columns);
  Extrapolation second(f, columns + 2);
  const State rough = first.run(t0, y0, t1, tolerance);
  Solution result;
  result.y = second.run(t0, y0, t1, tolerance / 1000);
  result.error = distance(rough, result.y);
  result.evaluations = first.evaluations + second.evaluations;
  return result;
}

std::vector<Solution> solve(const RightSide& f, const Fifty& t0, const State& y0,
                            const std::vector<Fifty>& times, const Fifty& tolerance)
{
  std::vector<Solution> results;
  Fifty t = t0;
  State y = y0;
  for(const Fifty& t1 : times)
  {
    results.push_back(solve(f, t, y, t1, tolerance));
    t = t1;
    y = results.back().y;
  }
  return results;
}

}  // namespace exact
