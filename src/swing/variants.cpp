#include "swing/kernels.hpp"

namespace swing::kernels
{

#if defined(__x86_64__)

extern const Table sse2;
extern const Table avx2;
extern const Table avx512;

namespace
{

const Table* const variants[] = {&sse2, &avx2, &avx512};

std::size_t supported()
{
  __builtin_cpu_init();
  if(!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
    return 1;
  const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
                    && __builtin_cpu_supports("avx512vl");
  return wide ? 3 : 2;
}

}  // namespace

#else

extern const Table portable;

namespace
{

const Table* const variants[] = {&portable};

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

const Table& variant(std::size_t i)
{
  return *variants[i];
}

const Table& best()
{
  return variant(count() - 1);
}

}  // namespace swing::kernels
