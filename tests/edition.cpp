// The teller: how a parameter is read, how a name is judged, how words are put on a line, and what a comparison remembers.
#include <doctest/doctest.h>

#include <limits>

#include "edition/registry.hpp"

using namespace edition;

namespace
{

/// A section of its own, with the parameters of these tests.
Section& scene()
{
  static const Identity who{"pendulum", 99, "A section for the tests"};
  [[maybe_unused]] static const AmplitudeParameter pair = amplitude(90_deg, closed(0_deg, 180_deg));
  [[maybe_unused]] static const Parameter<double> b = real("b", 0.1, metres, scale, "a length");
  [[maybe_unused]] static const Parameter<int> n = integer("n", 5, 1, 9, "a number of terms");
  [[maybe_unused]] static const Parameter<double> whole = angle("whole", 90_deg, scale, "an angle");
  [[maybe_unused]] static const Parameter<double> part =
      angle("part", at_most(40_deg, "half of whole", [] { return whole.fifty() / 2; }), scale, "one in it");
  choose(*sections().front());
  return section();
}

const ParameterEntry& parameter(Section& s, const std::string& name)
{
  for(const ParameterEntry& p : s.parameters)
    if(p.name == name)
      return p;
  throw std::logic_error("no such parameter");
}

std::string refusal(const std::string& name, const std::string& text)
{
  try
  {
    set_parameters(scene(), {{name, text}});
  }
  catch(const BadInput& e)
  {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a number is carried as it was written, and the double is its rounding")
{
  Section& s = scene();
  set_parameters(s, {{"zeta", "179.999999999"}, {"b", "0.3"}});
  const Fifty eta = Fifty("0.000000001") * exact::pi() / 180;
  CHECK(abs(parameter(s, "eta").exact - eta) < Fifty("1e-47"));
  CHECK(parameter(s, "eta").value == static_cast<double>(eta));
  CHECK(parameter(s, "b").exact == Fifty("0.3"));
  CHECK(parameter(s, "b").value == 0.3);
  set_parameters(s, {{"eta", "1e-300rad"}});
  CHECK(parameter(s, "eta").exact == Fifty("1e-300"));
  CHECK(parameter(s, "zeta").value == std::numbers::pi);
  set_parameters(s, {{"zeta", "-0"}});
  CHECK(!std::signbit(parameter(s, "zeta").value));
}

TEST_CASE("defaults come back, and the ends of a range belong to it")
{
  Section& s = scene();
  set_parameters(s, {{"b", "2"}, {"n", "9"}});
  CHECK(parameter(s, "n").value == 9);
  set_parameters(s, {});
  CHECK(parameter(s, "b").exact == Fifty("0.1"));
  CHECK(parameter(s, "n").value == 5);
  for(const char* end : {"0", "180", "3.141592653589793rad"})
    CHECK(refusal("zeta", end).empty());
  for(const char* end : {"1e-100", "1e100"})
    CHECK(refusal("b", end).empty());
}

TEST_CASE("a default asks the parameters of its own section, whichever was asked last")
{
  Section& s = scene();
  static const Identity other{"pendulum", 98, "Another section for the tests"};
  for(const char* name : {"p", "q", "r", "s", "t", "u"})
    [[maybe_unused]] const auto any = angle(name, 10_deg, scale, "an angle");
  choose(*sections().back());
  set_parameters(s, {});
  CHECK(parameter(s, "part").value == 40_deg);
}

TEST_CASE("a default keeps to what another parameter allows, to all digits, and what is given does not")
{
  Section& s = scene();
  set_parameters(s, {});
  CHECK(parameter(s, "part").exact == parameter(s, "part").exact_default);
  set_parameters(s, {{"whole", "0.2"}});
  CHECK(parameter(s, "part").exact == parameter(s, "whole").exact / 2);
  CHECK(parameter(s, "part").shown == 0.1);
  CHECK(parameter(s, "part").value == static_cast<double>(exact::pi() / 1800));
  set_parameters(s, {{"whole", "0.2"}, {"part", "50"}});
  CHECK(parameter(s, "part").shown == 50);
  set_parameters(s, {});
  CHECK(parameter(s, "part").given.empty());
}

TEST_CASE(
    "a whole number is read in decimal however it is written, and compared with its range before it is cut")
{
  Section& s = scene();
  const auto n = [&s](const char* text) {
    set_parameters(s, {{"n", text}});
    return parameter(s, "n").value;
  };
  CHECK(n("07") == 7);
  CHECK(n("009") == 9);
  CHECK(n("+3") == 3);
  CHECK(n("3.0") == 3);
  CHECK(n("3.") == 3);
  CHECK(n("0.5e1") == 5);
  CHECK(n("80e-1") == 8);
  CHECK(n("0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000001")
        == 1);
  const auto says = [](const char* text, const char* words) {
    return refusal("n", text).find(words) != std::string::npos;
  };
  // As an int of 32 or 64 bits the first two would be 1.
  for(const char* beyond : {"4294967297", "18446744073709551617", "2147483648", "9223372036854775808",
                            "010", "1e3", "1e300", "0", "-0", "-1"})
    CHECK(says(beyond, "is out of range; allowed: a whole number from 1 to 9"));
  CHECK(says("1e400", "is not a finite number for a double"));
  // More digits than are carried, and so near to a whole number that its double is one.
  CHECK(says("3.0000000000000001", "is not a whole number"));
  CHECK(says("3.00000000000000000000000000000000000000000000000000000000000000000000000000000000000001",
             "is not a whole number"));
  CHECK(says("1e-400", "is not a whole number"));
  for(const char* odd : {"0x3", "0b11", "3'0", "1_0", "3u", "\u0663", "\uff13", "3 ", "1e", "e3"})
    CHECK(says(odd, "is not a number"));
}

TEST_CASE("what is no number of the range is refused in words that help")
{
  const auto says = [](const char* name, const char* text, const char* words) {
    return refusal(name, text).find(words) != std::string::npos;
  };
  CHECK(says("zeta", "60,5", "write a point for the comma"));
  CHECK(says("zeta", "\u221260", "typographic"));
  CHECK(says("zeta", "1e400", "not a finite number for a double"));
  CHECK(says("zeta", "1e99999999999", "not a finite number for a double"));
  CHECK(says("zeta", "1e-400", "too small for a double"));
  CHECK(says("zeta", "inf", "not a finite number"));
  CHECK(says("zeta", "180.0000001", "out of range"));
  CHECK(says("b", "0", "out of range"));
  CHECK(says("b", "9.9e-101", "out of range"));
  CHECK(says("n", "2.5", "whole"));
  CHECK(says("nothing", "1", "no parameter"));
  for(const char* odd : {"", "e5", "1e", "--1", "0x10", "1 2", ".", "+", "1rad2"})
    CHECK(says("b", odd, "is not a number"));
  CHECK_THROWS_AS(set_parameters(scene(), {{"zeta", "60"}, {"eta", "60"}}), BadInput);
}

TEST_CASE(
    "someone's words stand on one line, broken bytes and controls escaped, the rest of long ones left out")
{
  CHECK(on_one_line("1\n2") == "1\\x0a2");
  CHECK(on_one_line("\x1b[31m") == "\\x1b[31m");
  CHECK(on_one_line("\xff\xc3") == "\\xff\\xc3");
  CHECK(on_one_line("ζ = 60°") == "ζ = 60°");
  CHECK(on_one_line(std::string(100000, 'x')).size() < 100);
}

TEST_CASE("degrees as written are the radians nearest to them")
{
  CHECK(5_deg == static_cast<double>(exact::pi() / 36));
  CHECK(0.1_deg == static_cast<double>(Fifty("0.1") * exact::pi() / 180));
  CHECK(179.9_deg == static_cast<double>(Fifty("179.9") * exact::pi() / 180));
  CHECK(1e-9_deg == static_cast<double>(Fifty("1e-9") * exact::pi() / 180));
  CHECK(180_deg == std::numbers::pi);
}

TEST_CASE("a comparison remembers what it used of its tolerance, and an infinity is met by itself alone")
{
  CHECK(1.5 == within(1, 1.0, "half of it"));
  CHECK(take_last_claim().used == 0.5);
  CHECK_FALSE(2.5 == within(1, 1.0, "beyond"));
  CHECK(take_last_claim().used == 1.5);
  CHECK(2.0 == between(1, 3, "the middle"));
  CHECK(take_last_claim().expected == "1 … 3");
  const double beyond = std::numeric_limits<double>::infinity();
  CHECK(beyond == infinite("itself"));
  CHECK_FALSE(1e308 == infinite("a number"));
  CHECK(beyond == within_ulps(Fifty(beyond), 1, "itself"));
  CHECK_FALSE(std::nan("") == within(1, 1e300, "no number"));
  CHECK_FALSE(1.0 == within(Fifty(std::nan("")), 1e300, "no number is expected"));
}

TEST_CASE("a block tells again only where a parameter that it read is another, or more curves are wanted")
{
  static int of_b = 0;
  static int of_none = 0;
  Section& s = scene();
  s.telling = {{[] {
                 const Parameter<double> b(2);
                 ++of_b;
                 tell("twice", 2 * b, metres, "two of them");
                 curve("line", {"x"}, [&](Curve& out) { out.put({b}); });
               }},
               {[] {
                 ++of_none;
                 tell("one", 1, "always");
               }}};
  const auto told = [&](const char* b, const char* zeta, const Wanted& wanted) {
    set_parameters(s, {{"b", b}, {"zeta", zeta}});
    tell_anew(s, wanted);
    REQUIRE(s.said.values.size() == 2);
    CHECK(s.said.values[1].name == "one");
    CHECK(std::get<double>(s.said.values[0].number) == 2 * parameter(s, "b").value);
    REQUIRE(s.said.curves.size() == 1);
    if(!wanted.figures)
      return;
    REQUIRE(s.said.curves[0].points.size() == 1);
    CHECK(s.said.curves[0].points[0][0] == parameter(s, "b").value);
  };
  told("0.1", "90", {});
  told("0.1", "60", {});  // ζ was not read
  CHECK(of_b == 1);
  told("0.3", "60", {});
  CHECK(of_b == 2);
  CHECK(of_none == 1);
  told("0.3", "60", {true, true, false});
  told("0.3", "70", {true, false, false});  // fewer curves
  CHECK(of_b == 3);
  CHECK(of_none == 1);  // it has none
  tell_anew(s, {false, false, true});
  CHECK(of_b == 4);
  told("0.3", "60", {});  // what was told with times is not kept
  CHECK(of_b == 5);
  s.telling.clear();
}

TEST_CASE("a limit is met on both sides by two settings that differ in what the refusal names alone, and "
          "by little")
{
  Section& s = scene();
  const Ledger before = std::exchange(ledger(), Ledger{});
  const auto at = [&s](const std::string& setting,
                       const std::vector<std::pair<std::string, std::string>>& given) {
    set_parameters(s, given);
    ledger().setting = setting;
    try
    {
      require(parameter(s, "b").exact <= parameter(s, "n").exact, "b", "at most n");
    }
    catch(const BadInput&)
    {
    }
  };
  const auto met = [] {
    return ledger().limits.size() == 1 && both_sides(ledger().limits.begin()->second);
  };
  at("outside a check run nothing is kept", {{"n", "1"}, {"b", "1"}});
  CHECK(ledger().limits.empty());
  ledger().running = true;
  at("kept", {{"n", "2"}, {"b", "1.99"}});
  CHECK(!met());
  CHECK(one_sided(ledger().limits.begin()->first, ledger().limits.begin()->second)
            .ends_with("is not seen to refuse anything"));
  at("far", {{"n", "2"}, {"b", "2.02"}});
  CHECK(!met());
  at("by another", {{"n", "1"}, {"b", "1.99"}});
  CHECK(!met());
  at("by two", {{"n", "2"}, {"b", "2.001"}, {"whole", "80"}});
  CHECK(!met());
  CHECK(one_sided(ledger().limits.begin()->first, ledger().limits.begin()->second).find("by two")
        == std::string::npos);
  at("near", {{"n", "2"}, {"b", "2.001"}});
  CHECK(met());
  CHECK(ledger().limits.begin()->first.first.ends_with("edition.cpp"));
  ledger() = before;
  set_parameters(s, {});
}

TEST_CASE("words in a claim are shown, and not the place in the memory where they lie")
{
  const char* const words = "Huygens";
  const char* const none = nullptr;
  CHECK(doctest::toString(words) == "Huygens");
  CHECK(doctest::toString(none) == "nullptr");
}

TEST_CASE("names are letters, digits and _")
{
  CHECK(is_name("T_over_Theta2"));
  for(const char* odd : {"", "2a", "_a", "a-b", "a b", "μ", "../x"})
    CHECK_FALSE(is_name(odd));
}
