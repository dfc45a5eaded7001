#!/bin/sh
# libc++ 14 (Debian libc++-14-dev 1:14.0.6-12): each lambda that is made a std::function makes the compiler build 105 functions
# anew, five times as many as with libstdc++ 12; clang++ takes some 90 thousandths of a second for each. A plain function, which a
# lambda without captures turns into where it is asked to, makes four, the lambda itself among them, since all of one signature
# share what the std::function is made of. Here lambdas by the dozen in each section, given to the edition as std::function,
# were a quarter of the time that the page's modules take to compile.
#
# The guess: std::function costs a pointer and perhaps an allocation when the program runs, and the compiler next to nothing, so
# that one may take it wherever a function is taken. Way out: a type of one's own above it that takes a lambda without
# captures as the plain function that it is (here edition::Rule).
#
#> functions for one more      libstdc++  libc++
#> lambda                             22     105
#> plain function of a lambda          4       4
. "$(dirname "$0")/room.sh"
debian clang-14=1:14.0.6-12 libc++-14-dev=1:14.0.6-12 libc++abi-14-dev=1:14.0.6-12 libstdc++-12-dev=12.2.0-14+deb12u1
cat >"$room/ask" <<'S'
unit() { # sign before the lambda, how many
  echo '#include <functional>'
  echo 'double x;'
  for i in $(seq "$2"); do echo "std::function<double()> f$i = $1[] { return x + $i; };"; done
}
made() { # sign, how many, options...
  unit "$1" "$2" >unit.cpp
  shift 2
  clang++-14 -std=c++20 -O1 -Xclang -disable-llvm-passes -S -emit-llvm "$@" unit.cpp -o unit.ll
  grep -c '^define' unit.ll
}
more() { echo $((($(made "$1" 11 -stdlib="$2") - $(made "$1" 1 -stdlib="$2")) / 10)); }
printf '%-26s  %9s  %6s\n' 'functions for one more' libstdc++ libc++
printf '%-26s  %9d  %6d\n' lambda "$(more '' libstdc++)" "$(more '' libc++)"
printf '%-26s  %9d  %6d\n' 'plain function of a lambda' "$(more + libstdc++)" "$(more + libc++)"
S
in_room sh ask >"$room/seen"
as_seen "$room/seen"
