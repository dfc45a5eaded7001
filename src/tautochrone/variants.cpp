#include "tautochrone/kernels.hpp"

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
  static const Variants found = [] {
#if defined(__x86_64__)
    __builtin_cpu_init();
    Variants all{1,
                 {sum_sse2, sum_avx2, sum_avx512},
                 {find_sse2, find_avx2, find_avx512},
                 {"sse2", "avx2", "avx512"}};
    if(__builtin_cpu_supports("avx2"))
      all.count = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
                          && __builtin_cpu_supports("avx512vl")
                      ? 3
                      : 2;
    return all;
#else
    return Variants{1, {sum_portable}, {find_portable}, {"portable"}};
#endif
  }();
  return found;
}

}  // namespace tautochrone::kernels
