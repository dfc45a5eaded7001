#include "balance/systems.hpp"

namespace balance::systems
{

#if defined(__x86_64__)

extern const Kernels sse2;
extern const Kernels avx2;
extern const Kernels avx512;

namespace
{

const Kernels* const variants[] = {&sse2, &avx2, &avx512};

std::size_t supported()
{
  __builtin_cpu_init();
  if(!__builtin_cpu_supports("avx2"))
    return 1;
  const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
                    && __builtin_cpu_supports("avx512vl");
  return wide ? 3 : 2;
}

}  // namespace

#else

extern const Kernels portable;

namespace
{

const Kernels* const variants[] = {&portable};

std::size_t supported()
{
  return 1;
}

}  // namespace

#endif

std::size_t count()
{
  static const std::size_t n = supported();
  return n;
}

const Kernels& kernels(std::size_t i)
{
  return *variants[i];
}

const Kernels& best()
{
  return kernels(count() - 1);
}

}  // namespace balance::systems
