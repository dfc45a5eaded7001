#include "balance/links.hpp"

#include <vector>

namespace balance::links
{

using exact::Fifty;

Place<double> runge_kutta(const Built<double>& of, Place<double> now, double until, int steps)
{
  const double step = until / steps;
  const auto moved = [](const Place<double>& from, const Place<double>& by, double time) {
    Place<double> to = from;
    for(std::size_t k{0}; k < 4; ++k)
    {
      to.q[k] += time * by.q[k];
      to.v[k] += time * by.v[k];
    }
    return to;
  };
  const auto slope = [&of](const Place<double>& at) { return Place<double>{at.v, of.accelerations(at)}; };
  for(int j = 0; j < steps; ++j)
  {
    const Place<double> k1 = slope(now), k2 = slope(moved(now, k1, step / 2)),
                        k3 = slope(moved(now, k2, step / 2)), k4 = slope(moved(now, k3, step));
    now = moved(moved(moved(moved(now, k1, step / 6), k2, step / 3), k3, step / 3), k4, step / 6);
  }
  return now;
}

Place<double> followed(const Suspended& s, const Full_state& from, double until)
{
  const int steps = 200 + static_cast<int>(until * 40 * modes(s).back().frequency);
  const Place<double> coarse = runge_kutta(built(s), place(from), until, steps);
  Place<double> fine = runge_kutta(built(s), place(from), until, 2 * steps);
  for(std::size_t k{0}; k < 4; ++k)  // the error of the fourth order falls to a sixteenth
  {
    fine.q[k] += (fine.q[k] - coarse.q[k]) / 15;
    fine.v[k] += (fine.v[k] - coarse.v[k]) / 15;
  }
  return fine;
}

Place<Fifty> small_motion(const Built<Fifty>& of, Place<Fifty> now, const Fifty& t, int parts)
{
  const auto stiffness = of.stiffness();
  Equations<Fifty> at_rest = of.equations({});
  const auto pulled = [&](const std::array<Fifty, 4>& x) {
    for(std::size_t k{0}; k < 4; ++k)
      at_rest[k][4] = -stiffness[k] * x[k];
    return solved(at_rest);
  };
  const Fifty time = t / parts;
  for(int j = 0; j < parts; ++j)
  {
    std::array<Fifty, 4> x = now.q, v = now.v;
    now = {};
    for(int k = 0; k < 60; k += 2)
    {
      const std::array<Fifty, 4> of_x = pulled(x), of_v = pulled(v);
      for(std::size_t i{0}; i < 4; ++i)
      {
        now.q[i] += x[i] + v[i] * time / (k + 1);
        now.v[i] += v[i] + of_x[i] * time / (k + 1);
        x[i] = of_x[i] * time * time / ((k + 1) * (k + 2));
        v[i] = of_v[i] * time * time / ((k + 1) * (k + 2));
      }
    }
  }
  return now;
}

Fifty handed_on(const Built<Fifty>& of)
{
  const auto stiffness = of.stiffness();
  const Equations<Fifty> masses = of.equations({});
  struct Answer
  {
    Fifty determinant, theta;
  };
  const auto answer = [&](const Fifty& s) {  // of (stiffness − s·masses) x = masses·(0, 0, 1, 0)
    Equations<Fifty> m = masses;
    for(std::size_t i{0}; i < 4; ++i)
    {
      for(std::size_t k{0}; k < 4; ++k)
        m[i][k] = (i == k ? stiffness[i] : Fifty(0)) - s * masses[i][k];
      m[i][4] = masses[i][2];
    }
    m = eliminated(m);
    return Answer{m[0][0] * m[1][1] * m[2][2] * m[3][3], m[3][4] / m[3][3]};
  };
  Fifty above = 0;  // the sum of the four squares
  for(std::size_t i{0}; i < 4; ++i)
  {
    Equations<Fifty> m = masses;
    for(std::size_t k{0}; k < 4; ++k)
      m[k][4] = k == i ? stiffness[i] : Fifty(0);
    above += solved(m)[i];
  }
  std::vector<Fifty> found;
  Fifty sum = 0;
  const Fifty slight("1e-20");
  while(found.size() < 4)
  {
    Fifty s = above * (1 + slight);
    for(int k = 0; k < 300; ++k)  // Newton's rule from above, what is found being divided out
    {
      const Fifty d = s * slight, here = answer(s).determinant;
      Fifty slope = (answer(s + d).determinant - answer(s - d).determinant) / (2 * d * here);
      for(const Fifty& root : found)
        slope -= 1 / (s - root);
      s -= 1 / slope;
      if(abs(1 / slope) < s * Fifty("1e-32"))
        break;
    }
    found.push_back(s);
    const Fifty d = s * slight;
    sum += abs(d * (answer(s + d).theta - answer(s - d).theta)) / 2;
  }
  return sum;
}

}  // namespace balance::links
