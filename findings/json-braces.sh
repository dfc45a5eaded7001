#!/bin/sh
# nlohmann-json 3.11.2 (Debian nlohmann-json3-dev 3.11.2-2) under two compilers: "json copy{object}" is the object with
# clang++ 14 and an array that holds the object with g++ 12. And value("name", 0) gives a whole number, whatever stands there.
#
# The guess: braces and parentheses both copy, as they do for every other type; and a default says what to take when the
# name is missing, not what type the answer has. 2.5 seconds with the default 0 are 2. Way out: parentheses or =, and 0.0.
#
#> g++:     {"T":2.5} in braces: [{"T":2.5}], in parentheses: {"T":2.5}; value("T", 0): 2, value("T", 0.0): 2.5
#> clang++: {"T":2.5} in braces: {"T":2.5}, in parentheses: {"T":2.5}; value("T", 0): 2, value("T", 0.0): 2.5
. "$(dirname "$0")/room.sh"
debian nlohmann-json3-dev=3.11.2-2 g++-12=12.2.0-14+deb12u1 clang-14=1:14.0.6-12
cat >"$room/ask.cpp" <<'C'
#include <iostream>
#include <nlohmann/json.hpp>
int main()
{
  const auto object = nlohmann::json::parse(R"({"T":2.5})");
  const nlohmann::json braces{object};
  const nlohmann::json parentheses(object);
  std::cout << object << " in braces: " << braces << ", in parentheses: " << parentheses
            << "; value(\"T\", 0): " << object.value("T", 0) << ", value(\"T\", 0.0): " << object.value("T", 0.0) << '\n';
}
C
in_room sh -c 'g++-12 -std=c++17 ask.cpp -o by_gcc && clang++-14 -std=c++17 ask.cpp -o by_clang'
{
  echo "g++:     $("$room/by_gcc")"
  echo "clang++: $("$room/by_clang")"
} >"$room/seen"
as_seen "$room/seen"
