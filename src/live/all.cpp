// All sections in one program, for the tests: each line of standard input is a JSON list ["tell", "frames" or
// "check", program, given], each line of standard output its answer.

#include <iostream>

#include <nlohmann/json.hpp>

#include "live/live.hpp"

int main()
{
  for(std::string line; std::getline(std::cin, line);)
  {
    const auto asked = nlohmann::json::parse(line);
    const std::string name = asked[1], given = asked[2].dump();
    const std::string answer = asked[0] == "tell"     ? live::tell(name, given, true)
                               : asked[0] == "frames" ? live::frames(name, given)
                                                      : live::check(name, given);
    std::cout << nlohmann::json::parse(answer).dump() << std::endl;
  }
}
