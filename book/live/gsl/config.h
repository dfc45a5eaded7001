// What GSL's configure would have found out about WebAssembly under emscripten, as far as the sources
// compiled here ask.
#pragma once
#define HAVE_C99_INLINE 1
#define HAVE_DECL_ISNAN 1
#define HAVE_DECL_ISINF 1
#define HAVE_DECL_FINITE 1
#define HAVE_DECL_ISFINITE 1
#define HAVE_DECL_HYPOT 1
#define HAVE_DECL_EXPM1 1
#define HAVE_DECL_LOG1P 1
#define HAVE_DECL_ACOSH 1
#define HAVE_DECL_ASINH 1
#define HAVE_DECL_ATANH 1
#define HAVE_DECL_LDEXP 1
#define HAVE_DECL_FREXP 1
#define HAVE_STRDUP 1
#define HAVE_STRTOL 1
#define HAVE_STRTOUL 1
#define HAVE_VPRINTF 1
#define HAVE_IEEE_COMPARISONS 1
#define HAVE_IEEE_DENORMALS 1
#define HAVE_PRINTF_LONGDOUBLE 1
#define HAVE_DECL_FPRND_T 0
#define HAVE_EXTENDED_PRECISION_REGISTERS 0
#define GSL_COERCE_DBL(x) (x)
#define GSL_DISABLE_DEPRECATED 1
#define RETURN_IF_NULL(x) \
  if(!x) \
  { \
    return; \
  }
