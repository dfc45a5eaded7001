/// @file
/// The loops compiled for each instruction set give the same bits, here and on any other machine.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "swing/motion.hpp"
#include "swing_worst.hpp"

namespace kernels = swing::kernels;

namespace
{

constexpr std::size_t many = 100003;  // no multiple of any width

// Fowler, Noll and Vo's hash of the bits.
std::uint64_t hash_of(const std::vector<double>& x)
{
  std::uint64_t h = 0xcbf29ce484222325;
  for(double y : x)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &y, sizeof bits);
    for(int i = 0; i < 8; ++i)
      h = (h ^ ((bits >> (8 * i)) & 0xff)) * 0x100000001b3;
  }
  return h;
}

// Arguments that are the same everywhere, without any library's logarithm: a fraction times a power of two.
std::vector<double> arguments(std::uint64_t seed, int octaves)
{
  Dice dice(seed);
  std::vector<double> x(many);
  for(double& y : x)
  {
    const int exponent = -static_cast<int>(dice.unit() * octaves);
    y = std::ldexp(dice.unit(), exponent);
  }
  return x;
}

struct Kernel
{
  std::string name;
  std::function<void(const kernels::Table&, const std::vector<double>&, std::vector<double>&)> run;
  std::vector<double> in;
  std::uint64_t hash;
};

Kernel of_numbers(const std::string& name, kernels::Table::Loop kernels::Table::*loop,
                  std::vector<double> in, std::uint64_t hash)
{
  return {name,
          [loop](const kernels::Table& table, const std::vector<double>& x, std::vector<double>& y) {
            (table.*loop)(x.data(), y.data(), x.size());
          },
          std::move(in), hash};
}

std::vector<double> times()
{
  std::vector<double> t = arguments(5, 4);
  for(double& x : t)
    x *= 4096;
  return t;
}

// Computed from the beginning.
Kernel of_times(const std::string& name, const swing::Motion& m, kernels::Question asked,
                std::uint64_t hash)
{
  return {name,
          [m, asked](const kernels::Table& table, const std::vector<double>& x, std::vector<double>& y) {
            table.direct[m.course()][asked](m.prepared(), x.data(), y.data(), x.size());
          },
          times(), hash};
}

// Read from the motion's rows.
Kernel by_rows(const std::string& name, const swing::Motion& m, kernels::Question asked, std::uint64_t hash)
{
  return {name + " by rows",
          [m, asked](const kernels::Table& table, const std::vector<double>& x, std::vector<double>& y) {
            table.read(*m.rows(asked), x.data(), y.data(), x.size());
          },
          times(), hash};
}

std::vector<Kernel> all_kernels()
{
  std::vector<double> eta = arguments(3, 900);
  for(double& x : eta)
    x *= 3;
  using swing::Amplitude;
  using swing::Motion;
  using swing::Start;
  const Motion small(Amplitude::from_zeta(0.1));
  const Motion small_rest(Amplitude::from_zeta(0.1), Start::rest);
  const Motion low(Amplitude::from_zeta(1));
  const Motion low_rest(Amplitude::from_zeta(1), Start::rest);
  const Motion high(Amplitude::from_eta(1));
  const Motion high_rest(Amplitude::from_eta(1), Start::rest);
  const Motion near_top(Amplitude::from_eta(0x1p-30));
  const Motion near_top_rest(Amplitude::from_eta(0x1p-30), Start::rest);
  const Motion fast = Motion::revolving(2);
  const Motion barely = Motion::revolving(0x1p-40);
  return {
      of_numbers("K", &kernels::Table::K, arguments(1, 5), 0x64ce6ffe39a69ba0),
      of_numbers("K_from_complement", &kernels::Table::K_from_complement, arguments(2, 1070),
                 0x4072fa00ffe64f21),
      of_numbers("ratio_from_top", &kernels::Table::ratio_from_top, eta, 0x3ff57c89d8c7b459),
      of_numbers("ratio_from_bottom", &kernels::Table::ratio, eta, 0xcc8fa79053910e18),
      of_times("small angle", small, kernels::angle, 0x926f88e1f6239eef),
      of_times("small velocity", small, kernels::velocity, 0xc07b99198ccbd8ac),
      of_times("small from_top", small, kernels::from_top, 0x4b46be941d423221),
      of_times("small_from_rest angle", small_rest, kernels::angle, 0x0d1848801937a35b),
      of_times("small_from_rest velocity", small_rest, kernels::velocity, 0x7a89f2444b9750a8),
      of_times("low angle", low, kernels::angle, 0xe71bd1c911523928),
      of_times("low velocity", low, kernels::velocity, 0xc10985369f636d22),
      of_times("low from_top", low, kernels::from_top, 0xb015d53639c447a8),
      of_times("low_from_rest angle", low_rest, kernels::angle, 0x4ed15940e5d37c9e),
      of_times("low_from_rest velocity", low_rest, kernels::velocity, 0xc6306119b023bd8a),
      of_times("high angle", high, kernels::angle, 0xa1952c8cf83e4cab),
      of_times("high velocity", high, kernels::velocity, 0xd8707330c312a18d),
      of_times("high from_top", high, kernels::from_top, 0x3cacf4e269d5ccac),
      of_times("high_from_rest angle", high_rest, kernels::angle, 0x35577c0b2003cc22),
      of_times("high_from_rest velocity", high_rest, kernels::velocity, 0x09f9a3571616d8ec),
      of_times("near_top angle", near_top, kernels::angle, 0x9ef1fe1c5008a9c0),
      of_times("near_top velocity", near_top, kernels::velocity, 0xdb85e0c4402bca21),
      of_times("near_top from_top", near_top, kernels::from_top, 0x0e7ff0c47cfc40fd),
      of_times("near_top_from_rest angle", near_top_rest, kernels::angle, 0x6a0b0224ae9f350b),
      of_times("near_top_from_rest velocity", near_top_rest, kernels::velocity, 0x957ffb38811b9aa4),
      of_times("fast angle", fast, kernels::angle, 0x934468564007c53e),
      of_times("fast velocity", fast, kernels::velocity, 0x518580038bae2164),
      of_times("fast from_top", fast, kernels::from_top, 0x92414b9ce32f5295),
      of_times("barely angle", barely, kernels::angle, 0x2818ae360ee610be),
      of_times("barely velocity", barely, kernels::velocity, 0x0ea5dfd62e5a00bd),
      of_times("barely from_top", barely, kernels::from_top, 0x19acaa2935247bd5),
      by_rows("small angle", small, kernels::angle, 0x44e5085fd44def16),
      by_rows("small velocity", small, kernels::velocity, 0xb47b2d0c96c6e64e),
      by_rows("small from_top", small, kernels::from_top, 0xaf05f3bf39bb6cfc),
      by_rows("small_from_rest angle", small_rest, kernels::angle, 0x153314e4676b8deb),
      by_rows("small_from_rest velocity", small_rest, kernels::velocity, 0x3e73e77a0af0b7bb),
      by_rows("low angle", low, kernels::angle, 0x906b9be006847184),
      by_rows("low velocity", low, kernels::velocity, 0xd8ad4e895e2743fa),
      by_rows("low from_top", low, kernels::from_top, 0x70e523731169cff3),
      by_rows("low_from_rest angle", low_rest, kernels::angle, 0xeb85d708a15c630b),
      by_rows("low_from_rest velocity", low_rest, kernels::velocity, 0x1ec0a0c35525a72c),
      by_rows("high angle", high, kernels::angle, 0x27da741d986cac1c),
      by_rows("high velocity", high, kernels::velocity, 0x0cff4638bd181e18),
      by_rows("high from_top", high, kernels::from_top, 0x0d6eda5e592cbffb),
      by_rows("high_from_rest angle", high_rest, kernels::angle, 0x9efd9431a3278d1f),
      by_rows("high_from_rest velocity", high_rest, kernels::velocity, 0x0cdd213b9f4a8ff0),
      by_rows("fast angle", fast, kernels::angle, 0x20c6a025fd3c06d3),
      by_rows("fast velocity", fast, kernels::velocity, 0xf06d2400e7ac3596),
      by_rows("fast from_top", fast, kernels::from_top, 0x70d0e9c746de83c9),
      by_rows("barely angle", barely, kernels::angle, 0xf3a8cc84591e3486),
      by_rows("barely velocity", barely, kernels::velocity, 0xf2458683fc4f4c90),
      by_rows("barely from_top", barely, kernels::from_top, 0xfa375f94d6cd41cf),
  };
}

}  // namespace

TEST_CASE("every variant that this processor can run gives the same 10⁵ doubles, and so does every machine")
{
  MESSAGE("variants: " << kernels::count() << ", the widest is " << std::string(kernels::best().name));
  for(const Kernel& kernel : all_kernels())
    for(std::size_t v = 0; v < kernels::count(); ++v)
    {
      std::vector<double> out(many);
      kernel.run(kernels::variant(v), kernel.in, out);
      CAPTURE(kernel.name);
      const std::string variant = kernels::variant(v).name;
      CAPTURE(variant);
      CHECK(hash_of(out) == kernel.hash);
    }
}

TEST_CASE("every variant gives the same for times so small that what a product is rounded by underflows")
{
  const std::vector<double> mantissas = arguments(6, 1);
  std::vector<double> t{5e-324, 1e-323, 0x1p-1022, 1e-300};
  for(std::size_t i = 0; i < 4000; ++i)
    t.push_back(std::ldexp(mantissas[i], -850 - static_cast<int>(i % 220)));
  using swing::Amplitude;
  for(const swing::Motion& m :
      {swing::Motion(Amplitude::from_zeta(1)), swing::Motion(Amplitude::from_eta(1)),
       swing::Motion(Amplitude::from_eta(0x1p-30), swing::Start::rest)})
    for(const kernels::Question asked : {kernels::angle, kernels::velocity, kernels::from_top})
    {
      const auto read = [&](std::size_t v) {
        std::vector<double> out(t.size());
        kernels::variant(v).read(*m.rows(asked), t.data(), out.data(), t.size());
        return hash_of(out);
      };
      const auto computed = [&](std::size_t v) {
        std::vector<double> out(t.size());
        kernels::variant(v).direct[m.course()][asked](m.prepared(), t.data(), out.data(), t.size());
        return hash_of(out);
      };
      for(std::size_t v = 1; v < kernels::count(); ++v)
      {
        CHECK(read(v) == read(0));
        CHECK(computed(v) == computed(0));
      }
    }
}

TEST_CASE("every variant makes the same rows")
{
  std::vector<double> angle(64);
  std::vector<double> speed(64);
  for(std::size_t i = 0; i < angle.size(); ++i)
  {
    angle[i] = swing::pi_hi * static_cast<double>(i) / 63;
    speed[i] = 2 - angle[i] / 2;
  }
  const kernels::Centres centres{angle.data(), speed.data(), angle.size(), -1, 0.04};
  const auto made = [&](kernels::Table::Make make) {
    std::vector<kernels::Row> rows(angle.size());
    make(centres, rows.data());
    std::vector<double> numbers;
    for(const kernels::Row& row : rows)
      numbers.insert(numbers.end(), std::begin(row.c), std::end(row.c));
    return hash_of(numbers);
  };
  for(std::size_t v = 0; v < kernels::count(); ++v)
  {
    CHECK(made(kernels::variant(v).rows_of_angle) == made(kernels::variant(0).rows_of_angle));
    CHECK(made(kernels::variant(v).rows_of_velocity) == made(kernels::variant(0).rows_of_velocity));
  }
}

TEST_CASE("an array gives the same bits as the function of one number")
{
  const auto same = [](void (*array)(std::span<const double>, std::span<double>), double (*one)(double),
                       const std::vector<double>& in) {
    std::vector<double> out(in.size());
    array(in, out);
    std::size_t differing = 0;
    for(std::size_t i = 0; i < in.size(); ++i)
    {
      const double single = one(in[i]);
      differing += std::bit_cast<std::uint64_t>(single) != std::bit_cast<std::uint64_t>(out[i]);
    }
    return differing == 0;
  };
  // Below their tables, out of their domains and beyond the last multiple of any width too.
  std::vector<double> x = arguments(7, 1074);
  const std::vector<double> wide = arguments(8, 60);
  for(std::size_t i = 0; i < many; i += 3)
    x[i] = 4 * wide[i];
  x.insert(x.end(), {0.0, -0.0, 1.0, -1.0, swing::pi_hi, HUGE_VAL, std::nan("")});
  CHECK(same(swing::K, swing::K, x));
  CHECK(same(swing::K_from_complement, swing::K_from_complement, x));
  CHECK(same(swing::ratio_from_bottom, swing::ratio_from_bottom, x));
  CHECK(same(swing::ratio_from_top, swing::ratio_from_top, x));
}

TEST_CASE("an array of times gives the same bits as one time, whether read from rows or not")
{
  std::vector<double> t = times();
  t.resize(10007);
  t.insert(t.end(), {0.0, -0.0, 1e-300, -1e-130, 0x1p60, -0x1p60, HUGE_VAL, std::nan("")});
  using swing::Amplitude;
  using swing::Start;
  for(const swing::Motion& m :
      {swing::Motion(Amplitude::from_zeta(1e-200)), swing::Motion(Amplitude::from_zeta(1.4), Start::rest),
       swing::Motion(Amplitude::from_zeta(2.6)), swing::Motion(Amplitude::from_eta(1e-9)),
       swing::Motion(Amplitude::from_eta(1e-14)), swing::Motion::revolving(0.1),
       swing::Motion::revolving(1e300)})
  {
    const auto same = [&](double (swing::Motion::*one)(double) const,
                          void (swing::Motion::*array)(std::span<const double>, std::span<double>) const) {
      std::vector<double> together(t.size());
      (m.*array)(t, together);
      std::vector<double> alone;
      for(double x : t)
        alone.push_back((m.*one)(x));
      return hash_of(together) == hash_of(alone);
    };
    CHECK(same(&swing::Motion::angle, &swing::Motion::angle));
    CHECK(same(&swing::Motion::velocity, &swing::Motion::velocity));
    CHECK(same(&swing::Motion::angle_from_top, &swing::Motion::angle_from_top));
  }
}

TEST_CASE("a number alone and the same number among others give the same bits")
{
  for(const Kernel& kernel : all_kernels())
  {
    std::vector<double> together(many);
    kernel.run(kernels::best(), kernel.in, together);
    bool same = true;
    for(std::size_t i = 0; i < many; i += 97)
    {
      std::vector<double> alone(1);
      kernel.run(kernels::variant(0), {kernel.in[i]}, alone);
      same = same && std::bit_cast<std::uint64_t>(alone[0]) == std::bit_cast<std::uint64_t>(together[i]);
    }
    CAPTURE(kernel.name);
    CHECK(same);
  }
}

TEST_CASE("an empty array is left alone, and an array may be its own result")
{
  kernels::best().K(nullptr, nullptr, 0);
  std::vector<double> x = arguments(6, 3);
  std::vector<double> y(many);
  kernels::best().K(x.data(), y.data(), many);
  kernels::best().K(x.data(), x.data(), many);
  CHECK(x == y);
}
