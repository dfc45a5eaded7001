// The checks: doctest, implemented once for all programs, with a reporter that keeps what each check claims.

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "edition/registry.hpp"

namespace edition
{
namespace
{

using nlohmann::ordered_json;

struct ClaimMade
{
  std::string expression;
  bool passed;
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

/// Keeps every case and every claim that doctest meets. A claim made again and again in a loop is kept once while it
/// holds, and whenever it fails.
struct Keeper : doctest::IReporter
{
  explicit Keeper(const doctest::ContextOptions&) {}

  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData& data) override
  {
    cases_run().push_back({data.m_name, data.m_line, false, {}});
  }
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats& stats) override
  {
    cases_run().back().passed = stats.testCaseSuccess && stats.numAssertsCurrentTest > 0;
  }
  void test_case_exception(const doctest::TestCaseException& e) override
  {
    cases_run().back().claims.push_back({"no exception", false, {}, e.error_string.c_str()});
  }
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData& data) override
  {
    auto& claims = cases_run().back().claims;
    ClaimMade made{data.m_expr, !data.m_failed, take_last_claim(),
                   data.m_failed ? data.m_decomp.c_str() : ""};
    const bool seen = std::any_of(claims.begin(), claims.end(), [&](const ClaimMade& c) {
      return c.passed && c.expression == made.expression;
    });
    if(data.m_failed || !seen)
      claims.push_back(std::move(made));
  }
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};

struct EntryTried
{
  const Entry* entry;
  bool printed_holds;
  bool right_holds;
  Claim claim;  ///< What the proof compared last, with the right reading.
  bool passed;
};

/// Tries the proof of an entry with both its readings.
EntryTried attempt(const Entry& e)
{
  const bool printed_holds = e.holds(e.printed.yields());
  take_last_claim();
  const bool right_holds = e.holds(e.right.yields());
  const bool told_apart = right_holds && !printed_holds;
  const bool passed = e.kind == Kind::undecided ? printed_holds == right_holds : told_apart;
  return {&e, printed_holds, right_holds, take_last_claim(), passed};
}

ordered_json as_json(const ClaimMade& made)
{
  return {{"expression", made.expression},
          {"passed", made.passed},
          {"got", made.claim.got},
          {"expected", made.claim.expected},
          {"tolerance", made.claim.tolerance},
          {"because", made.claim.because}};
}

std::string json_report(const Section& s, bool passed, const std::vector<EntryTried>& tried)
{
  ordered_json j{{"id", s.id()}, {"passed", passed}};
  j["cases"] = ordered_json::array();
  for(const CaseRun& c : cases_run())
  {
    auto claims = ordered_json::array();
    for(const ClaimMade& made : c.claims)
      claims.push_back(as_json(made));
    j["cases"].push_back({{"name", c.name}, {"line", c.line}, {"passed", c.passed}, {"claims", claims}});
  }
  j["apparatus"] = ordered_json::array();
  for(const EntryTried& t : tried)
    j["apparatus"].push_back({{"kind", name_of(t.entry->kind)},
                              {"where", t.entry->where},
                              {"printed_holds", t.printed_holds},
                              {"right_holds", t.right_holds},
                              {"expected", t.claim.expected},
                              {"tolerance", t.claim.tolerance},
                              {"because", t.claim.because},
                              {"passed", t.passed}});
  return j.dump(2) + '\n';
}

std::string text_report(const Section& s, const std::vector<EntryTried>& tried)
{
  std::string out =
      fmt::format("{}: {} checks, {} readings\n", s.program(), cases_run().size(), tried.size());
  for(const CaseRun& c : cases_run())
  {
    out += fmt::format("  {} {}\n", c.passed ? "holds " : "FAILS ", c.name);
    for(const ClaimMade& made : c.claims)
      if(!made.passed)
        out += fmt::format(
            "         line {}: {}\n         with values: {}\n         got {}, expected {} ({}: {})\n",
            c.line, made.expression, made.shown, made.claim.got, made.claim.expected, made.claim.tolerance,
            made.claim.because);
    if(c.claims.empty())
      out += "         it claims nothing\n";
  }
  for(const EntryTried& t : tried)
    out += fmt::format("  {} {}: {}: what is printed {}, what is right {}\n",
                       t.passed ? "holds " : "FAILS ", name_of(t.entry->kind), t.entry->where,
                       t.printed_holds ? "holds" : "fails", t.right_holds ? "holds" : "fails");
  return out;
}

}  // namespace

CheckResult run_checks(const Section& s, const std::vector<std::string>& doctest_arguments, bool json)
{
  doctest::Context context;
  context.setOption("reporters", "edition");
  context.setOption("success", true);
  std::vector<const char*> arguments{"checks"};
  for(const std::string& argument : doctest_arguments)
    arguments.push_back(argument.c_str());
  context.applyCommandLine(static_cast<int>(arguments.size()), arguments.data());
  const bool cases_pass =
      context.run() == 0
      && std::all_of(cases_run().begin(), cases_run().end(), [](const CaseRun& c) { return c.passed; });
  std::vector<EntryTried> tried;
  for(const Entry& e : s.apparatus)
    tried.push_back(attempt(e));
  const bool passed =
      cases_pass && !cases_run().empty()
      && std::all_of(tried.begin(), tried.end(), [](const EntryTried& t) { return t.passed; });
  return {passed, json ? json_report(s, passed, tried) : text_report(s, tried)};
}

}  // namespace edition

REGISTER_REPORTER("edition", 1, edition::Keeper);
