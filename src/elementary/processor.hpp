/// @file
/// Which of the variants of a loop that is compiled once for each instruction set the processor can run.
#pragma once

#include <cstddef>

namespace elementary
{

/// How many of the variants this processor runs, from the plainest on, at least one: on x86_64 of sse2, avx2
/// (with fused products) and avx512; elsewhere there is but one, portable. The processor is asked once.
inline std::size_t variants_that_run()
{
#if defined(__x86_64__)
  static const std::size_t count = []() -> std::size_t {
    __builtin_cpu_init();
    if(!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
      return 1;
    const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
                      && __builtin_cpu_supports("avx512vl");
    return wide ? 3 : 2;
  }();
  return count;
#else
  return 1;
#endif
}

}  // namespace elementary
