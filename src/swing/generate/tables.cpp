/// @file
/// Writes swing_tables.hpp: the polynomials and tables on which the swing's fast functions stand.
///
/// The whole of them is made here, with fifty digits, each time the edition is built. Every piece is written
/// with its method, its interval, its degree, and the largest error found. Usage: swing-tables FILE
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "exact/fifty.hpp"
#include "minimax.hpp"
#include "swing/oracle.hpp"

namespace
{

using exact::Fifty;
using generate::Fit;
using generate::Sample;
namespace oracle = swing::oracle;
using Function = std::function<Fifty(const Fifty&)>;

std::FILE* out = nullptr;

std::string hex(double x)
{
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

void write_array(const std::string& name, const std::string& comment, const std::vector<double>& c)
{
  std::fprintf(out, "\n// %s\ninline constexpr double %s[] = {", comment.c_str(), name.c_str());
  for(std::size_t i = 0; i < c.size(); ++i)
    std::fprintf(out, "%s%s", i == 0 ? "\n    " : i % 4 == 0 ? ",\n    " : ", ", hex(c[i]).c_str());
  std::fprintf(out, "};\n");
}

std::vector<double> rounded(const std::vector<Fifty>& c)
{
  std::vector<double> d;
  for(const Fifty& x : c)
    d.push_back(static_cast<double>(x));
  return d;
}

// log₂ of an error, for the comments.
std::string bits(const Fifty& error)
{
  char text[40];
  std::snprintf(text, sizeof text, "2^%.1f", std::log2(static_cast<double>(abs(error))));
  return text;
}

constexpr int dense = 600;

// Points from a to b, crowded towards both ends, where the extremes of a best approximation crowd too.
std::vector<Fifty> grid(const Fifty& a, const Fifty& b)
{
  return generate::tchebychef_points(dense, a, b);
}

// f(x) = fixed(x) + scale(x)·(c₀ + c₁x² + …), the error relative to f: writes the c.
void write_even(const std::string& name, const std::string& what, int terms, const Fifty& a, const Fifty& b,
                const Function& f, const Function& fixed, const Function& scale)
{
  std::vector<Sample> samples;
  for(const Fifty& x : grid(a, b))
  {
    Sample sample;
    Fifty term = scale(x) / f(x);
    for(int j = 0; j < terms; ++j, term *= x * x)
      sample.basis.push_back(term);
    sample.target = (f(x) - fixed(x)) / f(x);
    samples.push_back(std::move(sample));
  }
  const Fit fit = generate::minimax(samples);
  write_array(name,
              what + "; best for x from " + a.str(6) + " to " + b.str(6) + ", largest relative error "
                  + bits(fit.error),
              rounded(fit.coefficients));
}

void write_elementary()
{
  const Fifty tiny = Fifty(1e-6);
  const Fifty pi = exact::pi();
  const Fifty root2 = sqrt(Fifty(2));
  write_even(
      "sine_of_turns", "sin πx / π = x + x³(c₀ + c₁x² + …)", 8, tiny, Fifty(0.5),
      [=](const Fifty& x) { return sin(pi * x) / pi; }, [](const Fifty& x) { return x; },
      [](const Fifty& x) { return x * x * x; });
  write_even(
      "arc_tangent", "arctan x = x + x³(c₀ + c₁x² + …)", 11, tiny, root2 - Fifty(1),
      [](const Fifty& x) { return atan(x); }, [](const Fifty& x) { return x; },
      [](const Fifty& x) { return x * x * x; });
}

void write_exponential()
{
  constexpr int terms = 11;
  const Fifty half = exact::ln2() / Fifty(2) * Fifty(1.0001);
  std::vector<Sample> samples;
  for(const Fifty& x : grid(-half, half))
  {
    Sample sample;
    Fifty term = x * x / expm1(x);
    for(int j = 0; j < terms; ++j, term *= x)
      sample.basis.push_back(term);
    sample.target = Fifty(1) - x / expm1(x);
    samples.push_back(std::move(sample));
  }
  const Fit fit = generate::minimax(samples);
  write_array("exponential",
              "eˣ − 1 = x + x²(c₀ + c₁x + …); best for |x| up to ½ ln 2, largest relative error "
                  + bits(fit.error),
              rounded(fit.coefficients));
}

void write_excess()
{
  const Fifty last = exact::pi() / Fifty(2) * Fifty(1.0001);
  write_even(
      "excess", "T/Θ − 1 = x²(c₀ + c₁x² + …), x = ζ", 14, Fifty(1e-3), last, oracle::ratio_excess,
      [](const Fifty&) { return Fifty(0); }, [](const Fifty& x) { return x * x; });
}

// One row of a table: where its polynomial is centred, and the polynomial.
struct Row
{
  double centre;
  std::vector<double> c;
  double error;
};

constexpr int degree = 6;

// The centre is moved about the middle of the interval until the function there is very nearly a double: then
// its value needs no second word. The rest of the polynomial interpolates (f(x) − f(centre))/(x − centre).
Row make_row(const Function& f, const Fifty& a, const Fifty& b)
{
  const std::vector<Fifty> nodes = generate::tchebychef_points(11, a, b);
  std::vector<Fifty> values;
  for(const Fifty& x : nodes)
    values.push_back(f(x));
  const Fifty middle = (a + b) / Fifty(2);
  std::vector<Fifty> shifted;
  for(const Fifty& x : nodes)
    shifted.push_back(x - middle);
  const std::vector<Fifty> fine = generate::through(shifted, values);

  const Fifty step = (b - a) / Fifty(4096);
  Fifty best_offset = 0;
  double best = 1;
  for(int i = 0; i < 300 && best > 1.0 / 128; ++i)
  {
    const Fifty offset = step * Fifty(i % 2 == 0 ? i / 2 : -(i + 1) / 2);
    const Fifty exact_value = generate::value(fine, offset);
    const double miss = exact::ulps(static_cast<double>(exact_value), exact_value);
    if(miss < best)
    {
      best = miss;
      best_offset = offset;
    }
  }

  Row row;
  row.centre = static_cast<double>(middle + best_offset);
  const double value_at_centre = static_cast<double>(generate::value(fine, best_offset));
  std::vector<Fifty> t;
  std::vector<Fifty> slopes;
  for(const Fifty& x : generate::tchebychef_points(degree, a, b))
  {
    t.push_back(x - middle - best_offset);
    slopes.push_back((generate::value(fine, x - middle) - generate::value(fine, best_offset)) / t.back());
  }
  row.c = rounded(generate::through(t, slopes));
  row.c.insert(row.c.begin(), value_at_centre);

  row.error = 0;
  std::vector<Fifty> c(row.c.begin(), row.c.end());
  for(const Fifty& x : generate::tchebychef_points(9, a, b))
  {
    const Fifty exact_value = generate::value(fine, x - middle);
    const Fifty error = generate::value(c, x - middle - best_offset) - exact_value;
    row.error =
        std::fmax(row.error, static_cast<double>(abs(error) / std::max(Fifty(1), abs(exact_value))));
  }
  return row;
}

// Sixty-four rows for each doubling of x from 2^lowest on, until `last` is in a row.
void write_table(const std::string& name, const std::string& what, int lowest, double last,
                 const Function& f)
{
  std::string rows;
  double error = 0;
  int count = 0;
  for(Fifty b = 0; b <= Fifty(last); ++count)
  {
    const Fifty octave = ldexp(Fifty(1), lowest + count / 64);
    const Fifty a = octave * (Fifty(1) + Fifty(count % 64) / Fifty(64));
    b = octave * (Fifty(1) + Fifty(count % 64 + 1) / Fifty(64));
    const Row row = make_row(f, a, b);
    error = std::fmax(error, row.error);
    rows += "    " + hex(row.centre) + ",";
    for(double c : row.c)
      rows += " " + hex(c) + ",";
    rows += "\n";
  }
  std::fprintf(out,
               "\n// %s; from 2^%d to %g, 64 rows for each doubling, interpolated to degree %d about\n"
               "// a centre where the value is a double to 1/128 ulp; largest error, relative where the\n"
               "// function exceeds 1, %s\n"
               "inline constexpr double %s_start = 0x1p%d;\n"
               "alignas(64) inline constexpr double %s[] = {\n%s};\n",
               what.c_str(), lowest, last, degree, bits(Fifty(error)).c_str(), name.c_str(), lowest,
               name.c_str(), rows.c_str());
}

// K by y = 1 − k, which is a double, down to the last k below 1. By kc and by η the rows end where, to 2⁻⁵⁵,
// K(½kc) = K(kc) + ln 2.
void write_tables()
{
  std::fprintf(out,
               "\n// The tables have rows of %d numbers: f(x) = c[1] + c[2] t + … with t = x − c[0].\n"
               "inline constexpr unsigned row_length = %d;\n",
               degree + 2, degree + 2);
  write_table("K_by_modulus", "K by 1 − k", -53, 1,
              [](const Fifty& y) { return oracle::K_from_complement(sqrt(y * (Fifty(2) - y))); });
  write_table("K_by_complement", "K by kc", -30, 1, oracle::K_from_complement);
  write_table("ratio_by_eta", "T/Θ by η", -29, 3.1415926535897931, oracle::ratio_from_top);
}

// A constant as a double of few digits, so that its product with a small integer is exact, and the rest.
void write_constant(const std::string& name, const Fifty& x, int kept_bits)
{
  const int shift = kept_bits - static_cast<int>(std::ceil(std::log2(std::fabs(static_cast<double>(x)))));
  const double head = kept_bits >= 53
                          ? static_cast<double>(x)
                          : std::ldexp(std::nearbyint(std::ldexp(static_cast<double>(x), shift)), -shift);
  const double rest = static_cast<double>(x - Fifty(head));
  const char* const format = "inline constexpr double %s_hi = %s;\ninline constexpr double %s_lo = %s;\n";
  std::fprintf(out, format, name.c_str(), hex(head).c_str(), name.c_str(), hex(rest).c_str());
}

}  // namespace

int main(int argc, char** argv)
{
  if(argc != 2 || (out = std::fopen(argv[1], "w")) == nullptr)
  {
    std::fprintf(stderr, "usage: swing-tables FILE\n");
    return 2;
  }
  std::fprintf(out, "// Made by src/swing/generate/tables.cpp with fifty digits; not to be edited.\n"
                    "#pragma once\n\nnamespace swing::tables\n{\n\n");
  write_constant("ln2", exact::ln2(), 40);
  write_constant("two_over_pi", Fifty(2) / exact::pi(), 53);
  write_constant("ratio_ln2", Fifty(2) / exact::pi() * exact::ln2(), 40);
  write_constant("one_over_pi", Fifty(1) / exact::pi(), 53);
  write_elementary();
  write_exponential();
  write_excess();
  write_tables();
  std::fprintf(out, "\n} // namespace swing::tables\n");
  return std::fclose(out) == 0 ? 0 : 1;
}
