/// @file
/// Writes swing_published.hpp: the coefficients of published methods for K, which the benchmark sets beside
/// the edition's own. The methods are the authors'; the coefficients are found here, with fifty digits, so
/// that each does its best. Usage: swing-published FILE
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "exact/fifty.hpp"
#include "minimax.hpp"
#include "swing/oracle.hpp"
#include "writing.hpp"

namespace
{

using exact::Fifty;
using generate::bits;
using generate::hex;
using generate::rounded;
using generate::Sample;
using generate::write_array;
namespace oracle = swing::oracle;

std::FILE* out = nullptr;

// K by m₁ = 1 − k².
Fifty K_of(const Fifty& m1)
{
  return oracle::K_from_complement(sqrt(m1));
}
// (2/π)K of the complementary modulus, which multiplies the logarithm.
Fifty factor(const Fifty& m1)
{
  return Fifty(2) / exact::pi() * oracle::K(sqrt(m1));
}

// As in Cephes, after Hastings and Cody: K = P(m₁) − ln m₁ Q(m₁) for all m₁ from 0 to 1, both of degree 10.
// The first coefficients are what they must be, ln 4 and ½; the others make the largest relative error the
// smallest.
void write_one_piece()
{
  constexpr int degree = 10;
  std::vector<Sample> samples;
  for(const Fifty& u : generate::tchebychef_points(700, Fifty(0.02), Fifty(1)))
  {
    const Fifty m1 = u * u * u * u;
    const Fifty value = K_of(m1);
    const Fifty logarithm = -log(m1);
    Sample sample;
    Fifty power = m1 / value;
    for(int j = 1; j <= degree; ++j, power *= m1)
    {
      sample.basis.push_back(power);
      sample.basis.push_back(power * logarithm);
    }
    sample.target = (value - log(Fifty(4)) - logarithm / Fifty(2)) / value;
    samples.push_back(std::move(sample));
  }
  const generate::Fit fit = generate::minimax(samples);
  std::vector<Fifty> plain{log(Fifty(4))};
  std::vector<Fifty> with_log{Fifty(0.5)};
  for(std::size_t j = 0; j < fit.coefficients.size(); j += 2)
  {
    plain.push_back(fit.coefficients[j]);
    with_log.push_back(fit.coefficients[j + 1]);
  }
  write_array(out, "one_piece_plain", "P; largest relative error " + bits(fit.error), rounded(plain));
  write_array(out, "one_piece_with_log", "Q", rounded(with_log));
}

// As Fukushima's of 2009: polynomials about the middles of ten intervals of m up to 0.9, of the degrees
// that they need; beyond, the nome of m₁ and K of m₁.
void write_polynomials()
{
  std::vector<std::vector<double>> pieces;
  Fifty worst = 0;
  const auto fit = [&](const Fifty& a, const Fifty& b, const auto& f) {
    for(int n = 6;; ++n)
    {
      std::vector<Fifty> t;
      std::vector<Fifty> values;
      for(const Fifty& x : generate::tchebychef_points(n, a, b))
      {
        t.push_back(x - (a + b) / Fifty(2));
        values.push_back(f(x));
      }
      const std::vector<Fifty> c = generate::through(t, values);
      Fifty error = 0;
      for(const Fifty& x : generate::tchebychef_points(50, a, b))
        error = std::max(error, abs(generate::value(c, x - (a + b) / Fifty(2)) / f(x) - Fifty(1)));
      if(error < ldexp(Fifty(1), -55))
      {
        worst = std::max(worst, error);
        return rounded(c);
      }
    }
  };
  const double ends[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9};
  for(int i = 0; i < 10; ++i)
    pieces.push_back(
        fit(Fifty(ends[i]), Fifty(ends[i + 1]), [](const Fifty& m) { return oracle::K(sqrt(m)); }));
  const std::vector<double> nome = fit(Fifty(0), Fifty(0.1), [](const Fifty& m1) {
    return m1 == Fifty(0) ? Fifty(1) / Fifty(16) : exp(-exact::pi() * K_of(m1) / oracle::K(sqrt(m1))) / m1;
  });
  for(std::size_t i = 0; i < pieces.size(); ++i)
    write_array(out, "polynomial_" + std::to_string(i),
                "K by m about the middle of the interval from " + std::to_string(ends[i]).substr(0, 4)
                    + " to " + std::to_string(ends[i + 1]).substr(0, 4),
                pieces[i]);
  write_array(out, "nome", "the nome over m, about m = 0.05; largest relative error of all " + bits(worst),
              nome);
}

// As Fukushima's of 2015: quotients of polynomials of degree 5 on nine intervals of m₁ which shrink by the
// same ratio; below, the logarithm and two quotients of degree 2.
void write_quotients()
{
  constexpr int pieces = 9;
  const Fifty ratio = Fifty(0.593);
  Fifty worst = 0;
  std::string table;
  Fifty b = 1;
  const auto add = [&](const Fifty& low, const Fifty& high, int n, const auto& f) {
    const Fifty middle = (low + high) / Fifty(2);
    const generate::Quotient q = generate::rational(f, n, low, high, middle);
    for(const Fifty& x : generate::tchebychef_points(50, low, high))
      worst = std::max(
          worst, abs(generate::value(q.above, x - middle) / generate::value(q.below, x - middle) / f(x)
                     - Fifty(1)));
    table += "    {" + hex(static_cast<double>(low)) + ", " + hex(static_cast<double>(middle)) + ", {";
    for(double c : rounded(q.above))
      table += hex(c) + ", ";
    table += "}, {";
    for(double c : rounded(q.below))
      table += hex(c) + ", ";
    table += "}},\n";
  };
  for(int i = 0; i < pieces; ++i, b *= ratio)
    add(Fifty(static_cast<double>(b * ratio)), Fifty(static_cast<double>(b)), 5, K_of);
  std::fprintf(
      out,
      "\n// K by m₁ on %d intervals: where each ends below, its middle, numerator and denominator;\n"
      "// largest relative error %s\n"
      "struct Quotient_piece\n{\n  double end;\n  double middle;\n  double above[6];\n  double "
      "below[6];\n};\n"
      "inline constexpr Quotient_piece quotients[] = {\n%s};\n",
      pieces, bits(worst).c_str(), table.c_str());
  table.clear();
  worst = 0;
  const Fifty tiny = Fifty(1e-20);
  add(tiny, b, 2, [](const Fifty& m1) { return factor(m1) / Fifty(2); });
  add(tiny, b, 2,
      [](const Fifty& m1) { return (factor(m1) * log(Fifty(16) / m1) / Fifty(2) - K_of(m1)) / m1; });
  std::fprintf(out,
               "\n// Below: K = ln(16/m₁) A − m₁ B, with largest relative error of A and B %s\n"
               "struct Small_quotient\n{\n  double end;\n  double middle;\n  double above[3];\n  double "
               "below[3];\n};\n"
               "inline constexpr Small_quotient small_quotients[] = {\n%s};\n",
               bits(worst).c_str(), table.c_str());
}

}  // namespace

int main(int argc, char** argv)
{
  if(argc != 2 || (out = std::fopen(argv[1], "w")) == nullptr)
  {
    std::fprintf(stderr, "usage: swing-published FILE\n");
    return 2;
  }
  std::fprintf(out, "// Made by src/swing/generate/published.cpp with fifty digits; not to be edited.\n"
                    "#pragma once\n\nnamespace bench::published\n{\n");
  write_one_piece();
  write_polynomials();
  write_quotients();
  std::fprintf(out, "\n} // namespace bench::published\n");
  return std::fclose(out) == 0 ? 0 : 1;
}
