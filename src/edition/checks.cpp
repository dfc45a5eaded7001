// The checks: doctest, implemented once for all programs, with a reporter that keeps what each check claims.

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "edition/registry.hpp"

namespace edition
{
namespace
{

using nlohmann::ordered_json;

/// A claim, made once or again and again; `claim` is the time when most of its tolerance was used.
struct ClaimMade
{
  std::string expression;
  int line;
  bool passed;
  int times;
  std::string at;  ///< The setting.
  Claim claim;
  std::string shown;  ///< The expression with its values, for one that failed.
};

struct CaseRun
{
  std::string name;
  unsigned line;
  bool passed = false;
  std::vector<ClaimMade> claims;
};

std::vector<CaseRun>& cases_run()
{
  static std::vector<CaseRun> all;
  return all;
}

/// Both sides of a comparison without a tolerance, from doctest's words for it.
Claim sides(const std::string& words)
{
  for(const char* sign : {" == ", " != ", " <= ", " >= ", " < ", " > "})
    if(const auto at = words.find(sign); at != std::string::npos)
    {
      const std::string_view op(sign);
      const std::string right = words.substr(at + op.size());
      const bool same = op == " == ";
      return {words.substr(0, at), same ? right : std::string(op.substr(1)) + right, "exactly", "", -1};
    }
  return {words, "true", "exactly", "", -1};
}

/// Keeps every case and every claim that doctest meets. Of a claim that is made again and again in a loop, the
/// time is kept when it came nearest to failing, and each time that it failed.
struct Keeper : doctest::IReporter
{
  explicit Keeper(const doctest::ContextOptions&) {}

  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData& data) override
  {
    cases_run().push_back({data.m_name, data.m_line, false, {}});
    ledger().current_case = cases_run().size();
  }
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats& stats) override
  {
    cases_run().back().passed = stats.testCaseSuccess && stats.numAssertsCurrentTest > 0;
  }
  void test_case_exception(const doctest::TestCaseException& e) override
  {
    cases_run().back().claims.push_back(
        {"no exception", 0, false, 1, ledger().setting, {}, e.error_string.c_str()});
  }
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData& data) override
  {
    auto& claims = cases_run().back().claims;
    const std::string words = data.m_decomp.c_str();
    Claim claim = take_last_claim();
    if(claim.expected.empty())
      claim = sides(words);
    ClaimMade made{data.m_expr,
                   data.m_line,
                   !data.m_failed,
                   1,
                   ledger().setting,
                   std::move(claim),
                   data.m_failed ? words : ""};
    const auto before = std::find_if(claims.begin(), claims.end(), [&](const ClaimMade& c) {
      return c.passed && c.line == made.line && c.expression == made.expression;
    });
    if(data.m_failed || before == claims.end())
    {
      claims.push_back(std::move(made));
      return;
    }
    made.times = before->times + 1;
    if(made.claim.used > before->claim.used)
      *before = std::move(made);
    else
      before->times = made.times;
  }
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};

struct EntryTried
{
  const Entry* entry;
  bool copy_holds;
  bool right_holds;
  bool third_holds;  ///< Whether a reading holds that is neither; of an undecided one, whether all do.
  Claim claim;       ///< What the proof compared last, with the right reading.
  bool passed;
};

/// Tries the proof of an entry with both its readings, and with some that are neither.
EntryTried attempt(const Entry& e)
{
  const double copy = e.copy.yields();
  const double right = e.right.yields();
  const bool copy_holds = e.holds(copy);
  std::vector<bool> others;
  for(const double other : {right * 1.0625, right * 0.9375, 2 * right + (right == 0 ? 1 : 0), -right})
    if(other != right && other != copy)
      others.push_back(e.holds(other));
  const auto holds = [](bool held) { return held; };
  const bool third_holds = e.kind == Kind::undecided ? std::all_of(others.begin(), others.end(), holds)
                                                     : std::any_of(others.begin(), others.end(), holds);
  take_last_claim();
  const bool right_holds = e.holds(right);
  const bool expected = e.kind == Kind::undecided ? copy_holds : !copy_holds;
  return {&e,          copy_holds,        right_holds,
          third_holds, take_last_claim(), right_holds && expected && !third_holds};
}

ordered_json as_json(const ClaimMade& made)
{
  ordered_json j{{"expression", made.expression},
                 {"line", made.line},
                 {"passed", made.passed},
                 {"times", made.times},
                 {"at", made.at},
                 {"got", made.claim.got},
                 {"expected", made.claim.expected},
                 {"tolerance", made.claim.tolerance}};
  if(made.claim.used >= 0)
    j["used"] = made.claim.used;
  j["because"] = made.claim.because;
  return j;
}

struct Outcome
{
  bool passed;
  std::vector<EntryTried> tried;
  std::vector<std::string> uncovered;
};

std::string json_report(const Section& s, const Outcome& o)
{
  ordered_json j{{"id", s.id()}, {"passed", o.passed}};
  j["cases"] = ordered_json::array();
  for(const CaseRun& c : cases_run())
  {
    auto claims = ordered_json::array();
    for(const ClaimMade& made : c.claims)
      claims.push_back(as_json(made));
    j["cases"].push_back({{"name", c.name}, {"line", c.line}, {"passed", c.passed}, {"claims", claims}});
  }
  j["covers"] = ordered_json::object();
  j["infinite"] = ordered_json::array();
  for(const auto& [key, looked] : ledger().coverage)
  {
    if(!looked.cases.empty())
      j["covers"][key] = looked.cases;
    if(looked.infinite)
      j["infinite"].push_back(key);
  }
  j["limits"] = ordered_json::array();
  for(const auto& [place, limit] : ledger().limits)
    if(place.first == "chapters/" + s.file())
      j["limits"].push_back({{"line", place.second}});
  j["uncovered"] = o.uncovered;
  j["apparatus"] = ordered_json::array();
  for(const EntryTried& t : o.tried)
    j["apparatus"].push_back({{"kind", name_of(t.entry->kind)},
                              {"where", t.entry->where},
                              {"copy_holds", t.copy_holds},
                              {"right_holds", t.right_holds},
                              {"third_holds", t.third_holds},
                              {"expected", t.claim.expected},
                              {"tolerance", t.claim.tolerance},
                              {"because", t.claim.because},
                              {"passed", t.passed}});
  return j.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

std::string text_report(const Section& s, const Outcome& o)
{
  std::string out =
      fmt::format("{}: {} checks, {} readings\n", s.program(), cases_run().size(), o.tried.size());
  for(const CaseRun& c : cases_run())
  {
    out += fmt::format("  {} {}\n", c.passed ? "holds " : "FAILS ", c.name);
    for(const ClaimMade& made : c.claims)
      if(!made.passed)
        out += fmt::format("         line {}{}: {}\n         with values: {}\n"
                           "         got {}, expected {} ({}: {})\n",
                           made.line, made.at.empty() ? "" : fmt::format(" at {}", made.at),
                           made.expression, made.shown, made.claim.got, made.claim.expected,
                           made.claim.tolerance, made.claim.because);
    if(c.claims.empty())
      out += "         it claims nothing\n";
  }
  for(const EntryTried& t : o.tried)
    out += fmt::format("  {} {}: {}: what our copy has {}, what is right {}, what is neither {}\n",
                       t.passed ? "holds " : "FAILS ", name_of(t.entry->kind), t.entry->where,
                       t.copy_holds ? "holds" : "fails", t.right_holds ? "holds" : "fails",
                       t.third_holds ? "holds" : "fails");
  for(const std::string& what : o.uncovered)
    out += fmt::format("  FAILS  {}\n", what);
  return out;
}

/// doctest's own words when it is asked a question rather than to run: its lists, counts and help.
bool is_question(const std::string& argument)
{
  constexpr std::array questions{"?",
                                 "h",
                                 "help",
                                 "v",
                                 "version",
                                 "c",
                                 "count",
                                 "ltc",
                                 "list-test-cases",
                                 "lts",
                                 "list-test-suites",
                                 "lr",
                                 "list-reporters"};
  const auto from = argument.find_first_not_of('-');
  std::string name = argument.substr(std::min(from, argument.size()));
  name = name.substr(0, name.find('='));
  name = name.starts_with("dt-") ? name.substr(3) : name;
  return std::find(questions.begin(), questions.end(), name) != questions.end();
}

/// Refuses what doctest would ignore.
void must_be_known(const std::string& argument)
{
  constexpr std::array known{
      "tc", "test-case",   "tce", "test-case-exclude", "ts", "test-suite", "tse", "test-suite-exclude",
      "sc", "subcase",     "sce", "subcase-exclude",   "f",  "first",      "l",   "last",
      "aa", "abort-after", "ob",  "order-by",          "rs", "rand-seed"};
  const auto from = argument.find_first_not_of('-');
  std::string name = argument.substr(std::min(from, argument.size()));
  const bool has_value = name.find('=') != std::string::npos;
  name = name.substr(0, name.find('='));
  name = name.starts_with("dt-") ? name.substr(3) : name;
  if(!argument.starts_with('-') || !has_value || std::find(known.begin(), known.end(), name) == known.end())
    throw BadInput(
        fmt::format("-- \"{}\": is no filter of doctest's; allowed: -tc=…, -tce=…, -f=…, -l=…, -aa=…, "
                    "-ob=…, -rs=…, or a question: -ltc, -c, -h, -v",
                    on_one_line(argument)));
}

}  // namespace

CheckResult run_checks(Section& s, const std::vector<std::string>& doctest_arguments, bool json)
{
  doctest::Context context;
  const std::string own_file = "*chapters/" + s.file();
  context.addFilter("source-file", own_file.c_str());
  context.setOption("no-breaks", true);
  std::vector<const char*> arguments{"checks"};
  const bool question = std::any_of(doctest_arguments.begin(), doctest_arguments.end(), is_question);
  for(const std::string& argument : doctest_arguments)
  {
    if(!is_question(argument))
      must_be_known(argument);
    arguments.push_back(argument.c_str());
  }
  if(!question)
  {
    context.setOption("reporters", "edition");
    context.setOption("success", true);
  }
  context.applyCommandLine(static_cast<int>(arguments.size()), arguments.data());
  choose(s);
  cases_run().clear();
  ledger() = Ledger{};
  ledger().own = s.parameters;
  ledger().running = true;
  const bool ran = context.run() == 0;
  if(question)
    return {ran, ""};
  const bool cases_pass =
      ran && std::all_of(cases_run().begin(), cases_run().end(), [](const CaseRun& c) { return c.passed; });
  if(cases_run().empty() && !doctest_arguments.empty())
    return {false,
            fmt::format("{}: no check matches {}\n", s.program(), fmt::join(doctest_arguments, " "))};
  Outcome o{cases_pass && !cases_run().empty(), {}, {}};
  if(doctest_arguments.empty())
    o.uncovered = uncovered(s);
  for(const Entry& e : s.apparatus)
    o.tried.push_back(attempt(e));
  o.passed = o.passed && o.uncovered.empty()
             && std::all_of(o.tried.begin(), o.tried.end(), [](const EntryTried& t) { return t.passed; });
  return {o.passed, json ? json_report(s, o) : text_report(s, o)};
}

}  // namespace edition

REGISTER_REPORTER("edition", 1, edition::Keeper);
