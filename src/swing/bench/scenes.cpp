#include "scenes.hpp"

#include <cmath>
#include <random>

#include <gsl/gsl_errno.h>

#include "ways.hpp"

namespace bench
{

using exact::Fifty;

double gsl_value(int status, double value)
{
  return status == GSL_SUCCESS ? value : not_a_number;
}

// Uniform in the logarithm to base 2, by exact scaling alone so that the numbers are the same everywhere.
std::vector<double> logarithmic(std::uint64_t seed, std::size_t n, int octaves)
{
  std::mt19937_64 engine(seed);
  std::vector<double> x(n);
  for(double& y : x)
  {
    const double mantissa = 0.5 + std::ldexp(static_cast<double>(engine() >> 11), -54);
    y = std::ldexp(mantissa, -static_cast<int>(engine() % static_cast<std::uint64_t>(octaves)));
  }
  return x;
}

std::vector<Scene> all_scenes()
{
  // GSL's own handler would end the program where a modulus rounds to 1; each call's status is looked at
  // instead.
  gsl_set_error_handler_off();
  std::vector<Scene> scenes;
  add_values(scenes);
  add_motions(scenes);
  add_integrations(scenes);
  return scenes;
}

Error judge(const Scene& scene, const Method& method)
{
  const std::size_t n = scene.exact.size();
  std::vector<double> out(n);
  method.run(std::span(scene.in).first(n), out);
  Error error;
  error.judged = n;
  double sum = 0;
  for(std::size_t i = 0; i < n; ++i)
  {
    if(!std::isfinite(out[i]))
    {
      ++error.failures;
      continue;
    }
    const double e =
        scene.place > 0 ? static_cast<double>(abs(Fifty(out[i]) - scene.exact[i])) / (scene.place * 0x1p-52)
                        : exact::ulps(out[i], scene.exact[i]);
    error.worst = std::fmax(error.worst, e);
    sum += e;
  }
  if(n > error.failures)
    error.mean = sum / static_cast<double>(n - error.failures);
  return error;
}

}  // namespace bench
