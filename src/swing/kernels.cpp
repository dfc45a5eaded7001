// Compiled once for each instruction set, with SWING_VARIANT naming it; see kernels.hpp. Everything but the
// last object has internal linkage and nothing inline is taken from a library, so that no code made for one
// processor can be picked by the linker for another.
#include "swing/kernels.hpp"

#include "swing/kernels/forms.hpp"
#include "swing/kernels/rows.hpp"
#include "swing/kernels/values.hpp"

#define SWING_TEXT(x) #x
#define SWING_NAME(x) SWING_TEXT(x)

namespace swing::kernels
{

extern const Table SWING_VARIANT;

#define SWING_BY_SERIES(form, from)                                                                        \
  {                                                                                                        \
    series_loop<form, from, angle>, series_loop<form, from, velocity>, series_loop<form, from, from_top>   \
  }
#define SWING_BY_THETA(form, from)                                                                         \
  {                                                                                                        \
    theta_loop<form, from, angle>, theta_loop<form, from, velocity>, theta_loop<form, from, from_top>      \
  }

const Table SWING_VARIANT = {
    SWING_NAME(SWING_VARIANT),
    table_loop<By_modulus>,
    table_loop<As_given<rows::K_by_complement>>,
    table_loop<By_zeta>,
    table_loop<By_eta>,
    {SWING_BY_SERIES(Low<few_terms>, From::bottom), SWING_BY_SERIES(Low<few_terms>, From::rest),
     SWING_BY_SERIES(Low<series_terms>, From::bottom), SWING_BY_SERIES(Low<series_terms>, From::rest),
     SWING_BY_THETA(High<3>, From::bottom), SWING_BY_THETA(High<3>, From::rest),
     SWING_BY_THETA(High<1>, From::bottom), SWING_BY_THETA(High<1>, From::rest),
     SWING_BY_SERIES(Fast, From::going_round), SWING_BY_THETA(Barely, From::going_round)},
    read_any_motion,
    read_one<false>,
    read_one<true>,
    make_rows<false>,
    make_rows<true>};

}  // namespace swing::kernels
