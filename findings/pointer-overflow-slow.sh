#!/bin/sh
# clang++ 14 (Debian clang-14 1:14.0.6-12): of all the checks that -fsanitize=undefined stands for, -fsanitize=pointer-overflow
# alone makes the time of compiling inlined loops over short arrays grow faster than the code, where the address sanitizer is asked
# for too. A polynomial of 250 terms, of eight numbers in four registers each, takes more than three times as long to compile
# with this check as without it; here a file of such code took 36 s and 1.2 GB instead of 3 s and 0.2 GB. It finds pointers that
# wrap around the end of memory; whatever reads or writes beyond an array the address sanitizer finds without it.
#
# The guess: each check costs about as much, so that a slow build under the sanitizers is the price of having them, and one lowers
# the level of optimization (which made that file four times as slow again) or leaves the sanitizers out. Way out:
# -fno-sanitize=pointer-overflow.
#
#> compiled with             -O2
#> all checks but this one   1
#> all checks                more than 3
. "$(dirname "$0")/room.sh"
debian clang-14=1:14.0.6-12 libclang-rt-14-dev=1:14.0.6-12
cat >"$room/ask" <<'S'
{
  echo 'using Register = double __attribute__((vector_size(16)));'
  echo 'struct Eight { Register part[4]; };'
  for sign in + '*'; do
    echo "__attribute__((always_inline)) inline Eight operator$sign(const Eight& x, const Eight& y)"
    echo '{'
    echo '  Eight r;'
    echo '  for(unsigned i = 0; i < 4; ++i)'
    echo "    r.part[i] = x.part[i] $sign y.part[i];"
    echo '  return r;'
    echo '}'
  done
  echo 'void polynomial(Eight& y, const Eight& x, const Eight* a)'
  echo '{'
  echo '  y = a[0];'
  for i in $(seq 250); do echo "  y = y * x + a[$i];"; done
  echo '}'
} >polynomial.cpp
TIMEFORMAT=%U
took() { # options...
  { time clang++-14 -std=c++20 -O2 -fsanitize=address,undefined "$@" -c polynomial.cpp; } 2>&1
}
without=$(took -fno-sanitize=pointer-overflow)
with=$(took)
echo "compiled with             -O2"
echo "all checks but this one   1"
awk -v a="$with" -v b="$without" 'BEGIN { print "all checks                " (a > 3 * b ? "more than 3" : "not more than 3: " a / b) }'
S
in_room bash ask >"$room/seen"
as_seen "$room/seen"
