// Compiled once for each set of instructions, without contraction: the same bits from each.
#include "tautochrone/path.hpp"

#include <cmath>
#include <cstring>

namespace tautochrone::kernels
{

#define TAUTOCHRONE_JOIN(a, b) a##b
#define TAUTOCHRONE_NAME(variant) TAUTOCHRONE_JOIN(sum_, variant)

void TAUTOCHRONE_NAME(TAUTOCHRONE_VARIANT)(const Swing& swing, const double* cos2, double* sums);

// [sum]
void TAUTOCHRONE_NAME(TAUTOCHRONE_VARIANT)(const Swing& swing, const double* cos2, double* sums)
{
  constexpr int width = TAUTOCHRONE_WIDTH, together = width == 8 ? 3 : 2;  // as the registers allow
  using Some = double __attribute__((vector_size(width * sizeof(double))));
  double terms[3 * lanes];
  for(int first = 0; first < 3 * lanes; first += together * width)
  {
    Some c[together], r[together] = {}, rise[together] = {};
    for(int part = 0; part < together; ++part)
    {
      std::memcpy(&c[part], cos2 + first + part * width, sizeof(Some));
      c[part] = swing.c0 + swing.uu2 * c[part];
    }
    for(int i = swing.powers; i-- > 0;)
      for(int part = 0; part < together; ++part)
      {
        r[part] = r[part] * c[part] + swing.r[i];
        rise[part] = rise[part] * c[part] + swing.rise[i];
      }
    if(swing.inverse_powers > 0)
    {
      Some e[together], of_r[together] = {}, of_rise[together] = {};
      for(int part = 0; part < together; ++part)
        e[part] = 1 / c[part];
      for(int i = swing.inverse_powers; i-- > 0;)
        for(int part = 0; part < together; ++part)
        {
          of_r[part] = (of_r[part] + swing.r_inverse[i]) * e[part];
          of_rise[part] = (of_rise[part] + swing.rise_inverse[i]) * e[part];
        }
      for(int part = 0; part < together; ++part)
      {
        r[part] += of_r[part];
        rise[part] += of_rise[part];
      }
    }
    for(int part = 0; part < together; ++part)
    {
      const Some square = (swing.kk + r[part] * r[part]) / ((1 + c[part]) * rise[part]);
      std::memcpy(terms + first + part * width, &square, sizeof(Some));
    }
  }
  for(double& term : terms)
    term = std::sqrt(term);
  for(int block = 0; block < 3; ++block)
  {
    const double* t = terms + block * lanes;
    sums[block] = ((t[0] + t[1]) + (t[2] + t[3])) + ((t[4] + t[5]) + (t[6] + t[7]));
  }
}
// [sum]

}  // namespace tautochrone::kernels
