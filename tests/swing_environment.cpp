/// @file
/// What the swing's functions lose where another rounding mode is set, or subnormal numbers are flushed to
/// zero.
#include <cfenv>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "swing/motion.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"
#include "swing_worst.hpp"

using exact::Fifty;
using swing::Amplitude;
using swing::Motion;
using swing::Start;
namespace kernels = swing::kernels;
namespace oracle = swing::oracle;

namespace
{

struct Setting
{
  std::string name;
  int rounding;
  bool flush;  // subnormal results, and subnormal arguments
};

std::vector<Setting> settings()
{
  return
  {
    {"upward", FE_UPWARD, false}, {"downward", FE_DOWNWARD, false}, {"toward zero", FE_TOWARDZERO, false},
#if defined(__x86_64__)
        {"flushed", FE_TONEAREST, true},
    {
      "upward and flushed", FE_UPWARD, true
    }
#endif
  };
}

// The setting holds as long as this lives.
class Under
{
public:
  explicit Under(const Setting& s)
  {
    std::fegetenv(&before_);
    std::fesetround(s.rounding);
#if defined(__x86_64__)
    if(s.flush)
      _mm_setcsr(_mm_getcsr() | _MM_FLUSH_ZERO_ON | 0x40);
#endif
  }
  ~Under()
  {
    std::fesetenv(&before_);
  }
  Under(const Under&) = delete;
  Under& operator=(const Under&) = delete;

private:
  std::fenv_t before_;
};

using Numbers = std::vector<double>;
using Function = std::function<double(double)>;

Numbers values(const Setting& s, const Function& f, const Numbers& in)
{
  Numbers out(in.size());
  const Under setting(s);
  for(std::size_t i = 0; i < in.size(); ++i)
    out[i] = f(in[i]);
  return out;
}

bool same_bits(const Numbers& a, const Numbers& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// In any setting f errs by no more than so many ulps.
void check(const Function& f, const std::function<Fifty(double)>& exact, const Numbers& in, double allowed)
{
  std::vector<Fifty> true_values;
  for(double x : in)
    true_values.push_back(exact(x));
  for(const Setting& s : settings())
  {
    const Numbers out = values(s, f, in);
    Worst worst;
    for(std::size_t i = 0; i < in.size(); ++i)
      worst.see(in[i], exact::ulps(out[i], true_values[i]));
    CAPTURE(s.name);
    CAPTURE(worst.at);
    CHECK(worst.error <= allowed);
  }
}

Numbers between(std::uint64_t seed, double a, double b)
{
  Dice dice(seed);
  Numbers x(1000);
  for(double& y : x)
    y = dice.between(a, b);
  return x;
}

// Two hundred in every range of magnitudes down to 10⁻³⁰⁰.
Numbers of_all_magnitudes(std::uint64_t seed, double last)
{
  Dice dice(seed);
  Numbers x;
  for(double least : {1e-2, 1e-8, 1e-16, 1e-100, 1e-300})
    for(int i = 0; i < 200; ++i)
      x.push_back(dice.log_between(least, last));
  return x;
}

// The same for an array, on each instruction set.
void check_loop(kernels::Table::Loop kernels::Table::*loop, const Function& one, const Numbers& in)
{
  for(const Setting& s : settings())
  {
    const Numbers single = values(s, one, in);
    for(std::size_t v = 0; v < kernels::count(); ++v)
    {
      Numbers out(in.size());
      {
        const Under setting(s);
        (kernels::variant(v).*loop)(in.data(), out.data(), in.size());
      }
      CAPTURE(s.name);
      CAPTURE(v);
      CHECK(same_bits(out, single));
    }
  }
}

}  // namespace

TEST_CASE(
    "what is read from tables errs by 1.15 ulp in any setting, and an array has the bits of one number")
{
  Numbers k = between(1, 0, 1);
  for(int j = 1; j <= 53; ++j)
    k.push_back(1 - std::ldexp(1, -j));
  const Numbers kc = of_all_magnitudes(2, 1);
  const Numbers eta = of_all_magnitudes(3, swing::pi_hi);
  const Numbers zeta = between(4, 0, swing::pi_hi);
  const auto K = [](double x) { return swing::K(x); };
  const auto K_from_complement = [](double x) { return swing::K_from_complement(x); };
  const auto ratio_from_top = [](double x) { return swing::ratio_from_top(x); };
  const auto ratio_from_bottom = [](double x) { return swing::ratio_from_bottom(x); };
  const auto ratio = [](double x) { return swing::ratio(Amplitude::from_zeta(x)); };
  const auto quarter = [](const Fifty& e) { return oracle::ratio_from_top(e) * exact::pi() / Fifty(2); };
  check(K, oracle::K, k, 1.15);
  check(K_from_complement, oracle::K_from_complement, kc, 1.1);
  check(ratio_from_top, oracle::ratio_from_top, eta, 1.1);
  check(swing::quarter_time_from_top, quarter, eta, 1.1);
  check(ratio_from_bottom, oracle::ratio_from_bottom, zeta, 1.1);
  check(ratio, oracle::ratio_from_bottom, zeta, 1.1);
  check_loop(&kernels::Table::K, K, k);
  check_loop(&kernels::Table::K_from_complement, K_from_complement, kc);
  check_loop(&kernels::Table::ratio_from_top, ratio_from_top, eta);
  check_loop(&kernels::Table::ratio, ratio_from_bottom, zeta);
}

TEST_CASE("what is computed by steps errs by twice as much as in round to nearest")
{
  const Numbers part = between(5, 0, 1);
  check([](double x) { return swing::ratio_excess(Amplitude::from_zeta(x)); }, oracle::ratio_excess,
        between(6, 0, swing::pi_hi), 10);
  check([](double x) { return swing::agm(1, x); }, [](double x) { return oracle::agm(1, x); }, part, 10);
  check([](double x) { return swing::time_from_bottom(x, Amplitude::from_zeta(1)); },
        [](double x) { return oracle::time_from_bottom(x, exact::pi() - Fifty(1)); }, part, 10);
  for(double eta : {0.1, 1e-9})
    check([eta](double x) { return swing::time_from_rest_past(x, eta); },
          [eta](double x) { return oracle::time_from_rest_past(x, eta); }, part, 12);
}

TEST_CASE(
    "a motion of the same amplitude is the same to the last bit in any setting, and leaves it as it was")
{
  const std::vector<std::function<Motion()>> motions{
      [a = Amplitude::from_zeta(1e-4)] { return Motion(a); },
      [a = Amplitude::from_zeta(1.4)] { return Motion(a, Start::rest); },
      [a = Amplitude::from_zeta(2.6)] { return Motion(a); },
      [a = Amplitude::from_eta(1e-9)] { return Motion(a, Start::rest); },
      [a = Amplitude::from_eta(0)] { return Motion(a); },
      [] { return Motion::revolving(1e-9); },
      [] { return Motion::revolving(2); },
  };
  const Numbers t = between(7, -300, 300);
  const auto ask = [&](const Motion& m) {
    Numbers out(t.size());
    Numbers all;
    const auto keep = [&] { all.insert(all.end(), out.begin(), out.end()); };
    m.angle(t, out);
    keep();
    m.velocity(t, out);
    keep();
    m.angle_from_top(t, out);
    keep();
    all.insert(all.end(), {m.angle(t[0]), m.velocity(t[0]), m.angle_from_top(t[0])});
    return all;
  };
  for(const auto& motion : motions)
  {
    const Numbers nearest = ask(motion());
    for(const Setting& s : settings())
    {
      Numbers out;
      int rounding = 0;
      {
        const Under setting(s);
        out = ask(motion());
        rounding = std::fegetround();
      }
      CAPTURE(s.name);
      CHECK(same_bits(out, nearest));
      CHECK(rounding == s.rounding);
    }
  }
}

#if defined(__x86_64__)
TEST_CASE("where subnormal numbers are flushed, a subnormal kc or η is zero")
{
  const double tiny = std::numeric_limits<double>::min() / 8;
  Numbers in(9, tiny);
  Numbers out(9);
  double one = 0;
  {
    const Under setting({"flushed", FE_TONEAREST, true});
    one = swing::K_from_complement(tiny);
    swing::ratio_from_top(in, out);
  }
  CHECK(std::isinf(one));
  for(double y : out)
    CHECK(std::isinf(y));
}
#endif
