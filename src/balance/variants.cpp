#include "balance/systems.hpp"
#include "elementary/processor.hpp"

namespace balance::systems
{

#if defined(__x86_64__)
extern const Kernels sse2;
extern const Kernels avx2;
extern const Kernels avx512;
#else
extern const Kernels portable;
#endif

namespace
{

const Kernels* const variants[] = {
#if defined(__x86_64__)
    &sse2, &avx2, &avx512
#else
    &portable
#endif
};

}  // namespace

std::size_t count()
{
  return elementary::variants_that_run();
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
