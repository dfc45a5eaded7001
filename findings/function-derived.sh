#!/bin/sh
# libstdc++ 12 (Debian libstdc++-12-dev 12.2.0-14+deb12u1) and libc++ 14 (libc++-14-dev 1:14.0.6-12): an object of a class derived from
# std::function, given where a std::function of the same signature is taken by value or stored, is not copied as the
# std::function that it is: it is wrapped, whole, in a new one, so that each call goes through two. Only a reference to
# const takes it as what it is. Here the ways of a race were given on like this, by code that was not optimized, and each took
# some 15 ns more, five times what the quickest takes.
#
# The guess: a derived object is sliced to its base, as with every other class, and a std::function of the same signature is
# never wrapped in another. The constructor from anything that can be called takes it: to it the derived class is an exact match,
# and it leaves out std::function itself only, not what is derived from it. Way out: take it by reference to const, and copy there.
#
#> given                           libstdc++  libc++
#> by value                        wrapped    wrapped
#> to a member                     wrapped    wrapped
#> by reference to const           as it is   as it is
#> copied from such a reference    as it is   as it is
. "$(dirname "$0")/room.sh"
debian clang-14=1:14.0.6-12 libc++-14-dev=1:14.0.6-12 libc++abi-14-dev=1:14.0.6-12 libstdc++-12-dev=12.2.0-14+deb12u1
cat >"$room/ask" <<'S'
cat >given.cpp <<'C'
#include <cstdio>
#include <functional>
using Function = std::function<double()>;
struct Derived : Function
{
  using Function::function;
};
struct Holder
{
  Function member;
};
void say(const Function& f) { std::puts(f.target<Derived>() ? "wrapped" : "as it is"); }
void by_value(Function f) { say(f); }
void by_reference(const Function& f) { say(f); }
void copied(const Function& f) { by_value(f); }
int main()
{
  const Derived derived(+[] { return 1.; });
  by_value(derived);
  say(Holder{derived}.member);
  by_reference(derived);
  copied(derived);
}
C
for library in libstdc++ libc++; do
  clang++-14 -std=c++20 -stdlib=$library given.cpp -o given && ./given >$library
done
printf '%-30s  %-9s  %s\n' given libstdc++ libc++
printf '%s\n' 'by value' 'to a member' 'by reference to const' 'copied from such a reference' |
  paste - libstdc++ libc++ | while IFS="$(printf '\t')" read -r how one other; do
  printf '%-30s  %-9s  %s\n' "$how" "$one" "$other"
done
S
in_room sh ask >"$room/seen"
as_seen "$room/seen"
