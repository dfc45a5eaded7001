// Compiled once for each instruction set, with BALANCE_VARIANT naming it.
#include "balance/systems.hpp"

#define BALANCE_TEXT(x) #x
#define BALANCE_NAME(x) BALANCE_TEXT(x)

namespace balance::systems
{

extern const Kernels BALANCE_VARIANT;
const Kernels BALANCE_VARIANT = {BALANCE_NAME(BALANCE_VARIANT),
                                 collocation::engine_here<Fixed>,
                                 collocation::engine_of_eight_here<Fixed>,
                                 collocation::engine_here<Hung>,
                                 collocation::engine_here<Prescribed>,
                                 chart::halves_of_one,
                                 chart::halves_of_many};

}  // namespace balance::systems
