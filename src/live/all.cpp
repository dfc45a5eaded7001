// All sections in one program, for the tests: each line of standard input is a JSON list ["tell" or
// "check", program, given], each line of standard output its answer.

#include <iostream>

#include <nlohmann/json.hpp>

#include "live/live.hpp"

int main()
{
  for(std::string line; std::getline(std::cin, line);)
  {
    const auto asked = nlohmann::json::parse(line);
    const auto answer = asked[0] == "tell" ? &live::tell : &live::check;
    std::cout << nlohmann::json::parse(answer(asked[1], asked[2].dump())).dump() << std::endl;
  }
}
