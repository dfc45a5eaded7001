// Compiled once for each set of instructions, without contraction: the same bits from each.
#include "tautochrone/kernels.hpp"
#include "elementary/circular.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace tautochrone::kernels
{

#define TAUTOCHRONE_JOIN(a, b) a##b
#define TAUTOCHRONE_NAMED(name, variant) TAUTOCHRONE_JOIN(name, variant)
#define TAUTOCHRONE_NAME(name) TAUTOCHRONE_NAMED(name, TAUTOCHRONE_VARIANT)

void TAUTOCHRONE_NAME(sum_)(const Swing& swing, const double* cos2, double* sums);
void TAUTOCHRONE_NAME(find_)(const Step& step, const double* angles, Places& places);

namespace
{

constexpr int width = TAUTOCHRONE_WIDTH;
using Some = double __attribute__((vector_size(width * sizeof(double))));

}  // namespace

// [sum]
void TAUTOCHRONE_NAME(sum_)(const Swing& swing, const double* cos2, double* sums)
{
  constexpr int together = width == 8 ? 3 : 2;  // as the registers allow
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

// By Chebyshev's method from the guess. A place is told as it was when it was found, however many are looked for beside it.
void TAUTOCHRONE_NAME(find_)(const Step& step, const double* angles, Places& places)
{
  constexpr int together = width == 8 ? 1 : 2;  // as the registers allow
  using Mask = decltype(Some{} < Some{});
  const double k = step.k, eps = step.eps, per_k = 1 / k, per_eps = 1 / eps, per_Y = 1 / step.Y;
  const double unit_Y = step.unit * step.Y, gain = unit_Y * unit_Y, lift = gain * per_eps * per_eps;
  const double raised0 = eps * step.lifted, per_unit = 1 / step.unit, q0 = std::sqrt(2 * step.lifted);
  const bool wide = step.cosine < 0.5;
  for(int first = 0; first < lanes; first += together * width)
  {
    Some wanted[together], t[together], there[together] = {}, u_there[together] = {};
    Mask done[together] = {}, found[together] = {};
    for(int part = 0; part < together; ++part)
    {
      Some phi;
      std::memcpy(&phi, angles + first + part * width, sizeof(Some));
      const Some q = 2 * elementary::circular::swift_sincos<Some>(0.5 * phi).sine * per_unit * per_Y,
                 d = q - q0;
      wanted[part] = eps * (0.5 * q * q - step.lifted);
      if(wide)
        wanted[part] = eps * (step.cosine - elementary::circular::swift_sincos<Some>(phi).cosine) / gain;
      const double* g = step.guess;
      t[part] = d * (g[0] + d * (g[1] + d * (g[2] + d * (g[3] + d * (g[4] + d * (g[5] + d * g[6]))))));
    }
    for(int pass = 0; pass < 5; ++pass)
    {
      asm volatile(
          ""
          :
          :
          : "memory");  // the terms are read again each time: there are no registers to keep them in
      // Four sums each, which can be made at the same time.
      Some w[together], u[together];
      for(int part = 0; part < together; ++part)
      {
        const Some at = t[part], tt = at * at, fourth = tt * tt;
        Some w_of[4]{}, u_of[4]{};
        w_of[0] += step.terms[last_power][0];
        u_of[0] += step.terms[last_power][1];
        for(std::size_t n = last_power; n > 0;)
        {
          n -= 4;
          for(std::size_t j = 0; j < 4; ++j)
          {
            w_of[j] = w_of[j] * fourth + step.terms[n + j][0];
            u_of[j] = u_of[j] * fourth + step.terms[n + j][1];
          }
        }
        w[part] = (w_of[0] + tt * w_of[2]) + at * (w_of[1] + tt * w_of[3]);
        u[part] = (u_of[0] + tt * u_of[2]) + at * (u_of[1] + tt * u_of[3]);
      }
      Mask left = {};
      for(int part = 0; part < together; ++part)
      {
        const Some at = t[part], w_now = w[part], u_now = u[part];
        const Some z = k * (1 + at) + u_now, per_z = 1 / z, newton = (wanted[part] - w_now) * per_z;
        const Some du = u_now * per_k * per_z - lift * (raised0 + w_now), dz = k + du;
        const Some ddu = (du - u_now * per_z * dz) * per_k * per_z - lift * z;
        const Some change = newton * (1 - 0.5 * dz * per_z * newton);
        const Mask near = elementary::magnitude(newton) < step.small, now = near & ~done[part];
        there[part] = now ? at + change : there[part];
        u_there[part] = now ? u_now + change * (du + 0.5 * ddu * change) : u_there[part];
        found[part] |= now;
        t[part] = at + change;
        done[part] |= near | ~((t[part] > -1.1 * step.length) & (t[part] < 0.1 * step.length));
        left |= ~done[part];
      }
      std::int64_t any = 0, each[width];
      std::memcpy(each, &left, sizeof each);
      for(const std::int64_t one : each)
        any |= one;
      if(any == 0)
        break;
    }
    for(int part = 0; part < together; ++part)
    {
      const Some at = there[part], z = k * (1 + at) + u_there[part], per_z = 1 / z,
                 Y = step.unit * (step.Y * (1 + at)), s = u_there[part] * per_z;
      const Some r = k * (1 + at) * per_z, x = (1 + step.kk) / 2 * Y * Y, wound = s > 0 ? s : Some{};
      const Mask here = found[part] & (at <= 0) & (at >= -step.length);
      const int place = first + part * width;
      std::memcpy(places.r + place, &r, sizeof(Some));
      std::memcpy(places.x + place, &x, sizeof(Some));
      std::memcpy(places.s + place, &wound, sizeof(Some));
      std::memcpy(places.found + place, &here, sizeof(Some));
    }
  }
}

}  // namespace tautochrone::kernels
