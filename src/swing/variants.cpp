#include "elementary/processor.hpp"
#include "swing/kernels.hpp"

namespace swing::kernels
{

#if defined(__x86_64__)
extern const Table sse2;
extern const Table avx2;
extern const Table avx512;
#else
extern const Table portable;
#endif

namespace
{

const Table* const variants[] = {
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

const Table& variant(std::size_t i)
{
  return *variants[i];
}

const Table& best()
{
  return variant(count() - 1);
}

}  // namespace swing::kernels
