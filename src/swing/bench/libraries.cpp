#include "libraries.hpp"

#include <limits>

#include "published.hpp"

#ifdef HAS_ARB
#include <acb_elliptic.h>
#endif
#ifdef HAS_PARI
#include <pari/pari.h>
#endif
#ifdef HAS_SLEEF
#include <sleef.h>
#endif

namespace bench::libraries
{
namespace
{

#ifdef HAS_ARB
// By the parameter m = k², with as many bits as a double has and eleven more.
double K_by_arb(double k, double)
{
  acb_t m;
  acb_t K;
  acb_init(m);
  acb_init(K);
  arb_set_d(acb_realref(m), k);
  acb_mul(m, m, m, 128);
  acb_elliptic_k(K, m, 64);
  const double result = arf_get_d(arb_midref(acb_realref(K)), ARF_RND_NEAR);
  acb_clear(m);
  acb_clear(K);
  return result;
}
#endif

#ifdef HAS_PARI
// By the modulus, with PARI's 19 digits; what lies on its stack is dropped again.
double K_by_pari(double k, double)
{
  if(!(k < 1))  // there PARI ends the program
    return std::numeric_limits<double>::quiet_NaN();
  static const bool started = (pari_init_opts(8000000, 0, INIT_DFTm), true);
  const pari_sp before = started ? avma : 0;
  const double result = gtodouble(ellK(dbltor(k), DEFAULTPREC));
  avma = before;
  return result;
}
#endif

#ifdef HAS_SLEEF
double K_with_sleef(double, double kc)
{
  return published::K_in_one_piece(kc * kc, Sleef_log_u10(kc * kc));
}
#endif

}  // namespace

std::vector<K_way> K_ways()
{
  return {
#ifdef HAS_SLEEF
      {"method of Cephes with SLEEF's logarithm", K_with_sleef},
#endif
#ifdef HAS_ARB
      {"FLINT's Arb, 64 bits", K_by_arb},
#endif
#ifdef HAS_PARI
      {"PARI ellK", K_by_pari},
#endif
  };
}

std::vector<std::string> left_out()
{
  return {
#ifndef HAS_SLEEF
      "SLEEF",
#endif
#ifndef HAS_ARB
      "FLINT's Arb",
#endif
#ifndef HAS_PARI
      "PARI",
#endif
  };
}

}  // namespace bench::libraries
