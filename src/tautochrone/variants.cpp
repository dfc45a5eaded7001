#include "tautochrone/kernels.hpp"

#include "elementary/processor.hpp"

namespace tautochrone::kernels
{

#if defined(__x86_64__)
void sum_sse2(const Swing& swing, const double* cos2, double* sums);
void sum_avx2(const Swing& swing, const double* cos2, double* sums);
void sum_avx512(const Swing& swing, const double* cos2, double* sums);
void find_sse2(const Step& step, const double* angles, Places& places);
void find_avx2(const Step& step, const double* angles, Places& places);
void find_avx512(const Step& step, const double* angles, Places& places);
#else
void sum_portable(const Swing& swing, const double* cos2, double* sums);
void find_portable(const Step& step, const double* angles, Places& places);
#endif

const Variants& variants()
{
#if defined(__x86_64__)
  static const Variants found{elementary::variants_that_run(),
                              {sum_sse2, sum_avx2, sum_avx512},
                              {find_sse2, find_avx2, find_avx512},
                              {"sse2", "avx2", "avx512"}};
#else
  static const Variants found{
      elementary::variants_that_run(), {sum_portable}, {find_portable}, {"portable"}};
#endif
  return found;
}

}  // namespace tautochrone::kernels
