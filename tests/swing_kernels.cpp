/// @file
/// The loops compiled for each instruction set give the same bits, here and on any other machine.
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "swing/motion.hpp"
#include "swing_worst.hpp"

namespace kernels = swing::kernels;

namespace
{

constexpr std::size_t many = 100003; // no multiple of any width

// Fowler, Noll and Vo's hash of the bits.
std::uint64_t hash_of(const std::vector<double>& x)
{
  std::uint64_t h = 0xcbf29ce484222325;
  for (double y : x)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &y, sizeof bits);
    for (int i = 0; i < 8; ++i)
      h = (h ^ ((bits >> (8 * i)) & 0xff)) * 0x100000001b3;
  }
  return h;
}

// Arguments that are the same everywhere, without any library's logarithm: a fraction times a power of two.
std::vector<double> arguments(std::uint64_t seed, int octaves)
{
  Dice dice(seed);
  std::vector<double> x(many);
  for (double& y : x)
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

Kernel of_numbers(const char* name, kernels::Table::Loop kernels::Table::*loop, std::vector<double> in,
                  std::uint64_t hash)
{
  return {name,
          [loop](const kernels::Table& table, const std::vector<double>& x, std::vector<double>& y)
          { (table.*loop)(x.data(), y.data(), x.size()); },
          std::move(in), hash};
}

Kernel of_times(const char* name, const swing::Motion& m,
                kernels::Table::Motion kernels::Table::Questions::*asked, std::uint64_t hash)
{
  std::vector<double> t = arguments(5, 4);
  for (double& x : t)
    x *= 4096;
  return {name,
          [m, asked](const kernels::Table& table, const std::vector<double>& x, std::vector<double>& y)
          { (table.motion[m.course()].*asked)(m.prepared(), x.data(), y.data(), x.size()); },
          std::move(t), hash};
}

std::vector<Kernel> all_kernels()
{
  using Questions = kernels::Table::Questions;
  std::vector<double> eta = arguments(3, 900);
  for (double& x : eta)
    x *= 3;
  const swing::Motion low(swing::Amplitude::from_zeta(1));
  const swing::Motion low_rest(swing::Amplitude::from_zeta(1), swing::Start::rest);
  const swing::Motion high(swing::Amplitude::from_eta(0x1p-30));
  const swing::Motion high_rest(swing::Amplitude::from_eta(0x1p-30), swing::Start::rest);
  const swing::Motion fast = swing::Motion::revolving(2);
  const swing::Motion barely = swing::Motion::revolving(0x1p-40);
  return {
      of_numbers("K", &kernels::Table::K, arguments(1, 5), 0x2576cfe7f7b256c2),
      of_numbers("K_from_complement", &kernels::Table::K_from_complement, arguments(2, 1070),
                 0xd665f1d254ccf290),
      of_numbers("ratio_from_top", &kernels::Table::ratio_from_top, eta, 0x8e027df89b4848b2),
      of_numbers("ratio_from_bottom", &kernels::Table::ratio, eta, 0x52042ad37f57973b),
      of_times("low angle", low, &Questions::angle, 0x62445de5ab2975f2),
      of_times("low velocity", low, &Questions::velocity, 0xb3fecda5e8a1df08),
      of_times("low from_top", low, &Questions::from_top, 0x0b101f31e9041994),
      of_times("low_from_rest angle", low_rest, &Questions::angle, 0xdcec5a4b1cb94251),
      of_times("low_from_rest velocity", low_rest, &Questions::velocity, 0x638f8d1e96ed152c),
      of_times("high angle", high, &Questions::angle, 0xfefbc4018ccdd8cf),
      of_times("high velocity", high, &Questions::velocity, 0x025635e37d015189),
      of_times("high from_top", high, &Questions::from_top, 0x0a40c61cdc162e47),
      of_times("high_from_rest angle", high_rest, &Questions::angle, 0x4e228673a2fcd9e4),
      of_times("high_from_rest velocity", high_rest, &Questions::velocity, 0x094384c3a36713c5),
      of_times("fast angle", fast, &Questions::angle, 0xf9dc7d6fffede01c),
      of_times("fast velocity", fast, &Questions::velocity, 0x87077112d6ec0d4d),
      of_times("barely angle", barely, &Questions::angle, 0x8a1e15daf3c7c4bb),
      of_times("barely velocity", barely, &Questions::velocity, 0xc326bd6677e967f3),
  };
}

} // namespace

TEST_CASE("every variant that this processor can run gives the same 10⁵ doubles, and so does every machine")
{
  MESSAGE("variants: " << kernels::count() << ", the widest is " << std::string(kernels::best().name));
  for (const Kernel& kernel : all_kernels())
    for (std::size_t v = 0; v < kernels::count(); ++v)
    {
      std::vector<double> out(many);
      kernel.run(kernels::variant(v), kernel.in, out);
      CAPTURE(kernel.name);
      const std::string variant = kernels::variant(v).name;
      CAPTURE(variant);
      CHECK(hash_of(out) == kernel.hash);
    }
}

TEST_CASE("a number alone and the same number among others give the same bits")
{
  for (const Kernel& kernel : all_kernels())
  {
    std::vector<double> together(many);
    kernel.run(kernels::best(), kernel.in, together);
    bool same = true;
    for (std::size_t i = 0; i < many; i += 97)
    {
      std::vector<double> alone(1);
      kernel.run(kernels::variant(0), {kernel.in[i]}, alone);
      same = same && std::memcmp(&alone[0], &together[i], sizeof(double)) == 0;
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
