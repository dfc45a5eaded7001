#!/bin/sh
# CLI11 2.1.2 (Debian libcli11-dev 2.1.2+ds-1): "nan" is in every range, positive and not negative; and of two negative
# numbers in a list one may be an unknown option.
#
# The guess: CLI::Range(0.0, 180.0) lets through what lies between. It refuses what lies outside, and not-a-number does not lie
# outside. In a list -2e-3 is a number, since no option may begin with a digit, and -.5 is an option that does not exist.
# Way out: a check of one's own with std::isfinite; -0.5.
#
#> --zeta 181: refused
#> --zeta nan: nan
#> --positive nan: nan
#> --list 1 -2e-3: 1 -0.002
#> --list 1 -.5: refused
. "$(dirname "$0")/room.sh"
debian libcli11-dev=2.1.2+ds-1
cat >"$room/ask.cpp" <<'C'
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>
int main()
{
  for(const char* words : {"--zeta 181", "--zeta nan", "--positive nan", "--list 1 -2e-3", "--list 1 -.5"})
  {
    CLI::App app;
    std::vector<double> zeta, positive, list;
    app.add_option("--zeta", zeta)->check(CLI::Range(0.0, 180.0));
    app.add_option("--positive", positive)->check(CLI::PositiveNumber);
    app.add_option("--list", list);
    std::printf("%s:", words);
    try
    {
      app.parse(std::string(words));
      for(const auto* read : {&zeta, &positive, &list})
        for(const double x : *read)
          std::printf(" %g", x);
    }
    catch(const CLI::Error&)
    {
      std::printf(" refused");
    }
    std::puts("");
  }
}
C
in_room c++ -std=c++17 -w ask.cpp -o ask
"$room/ask" >"$room/seen"
as_seen "$room/seen"
