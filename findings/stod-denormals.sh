#!/bin/sh
# libstdc++ 12.2 (Debian g++-12 12.2.0-14+deb12u1): std::stod throws out_of_range for a text that is the decimal form of a
# perfectly good double below 2.2e-308; std::from_chars and a stream read it.
#
# The guess: out of range is what is too large or rounds to nought. stod looks at errno, which the C library sets for every
# denormal that is not exact. Way out: std::from_chars.
#
#> 5e-324 by stod: out of range, by from_chars: 4.9406564584124654e-324, by a stream: 4.9406564584124654e-324
#> 1e-310 by stod: out of range, by from_chars: 9.9999999999999694e-311, by a stream: 9.9999999999999694e-311
#> 1e-300 by stod: 1e-300, by from_chars: 1e-300, by a stream: 1e-300
. "$(dirname "$0")/room.sh"
debian g++-12=12.2.0-14+deb12u1
cat >"$room/ask.cpp" <<'C'
#include <charconv>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
int main()
{
  for(const std::string text : {"5e-324", "1e-310", "1e-300"})
  {
    std::printf("%s by stod: ", text.c_str());
    try
    {
      std::printf("%.17g", std::stod(text));
    }
    catch(const std::out_of_range&)
    {
      std::printf("out of range");
    }
    double by_chars = 0, by_stream = 0;
    std::from_chars(text.data(), text.data() + text.size(), by_chars);
    std::istringstream(text) >> by_stream;
    std::printf(", by from_chars: %.17g, by a stream: %.17g\n", by_chars, by_stream);
  }
}
C
in_room g++-12 -std=c++17 ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
