/// @file
/// Writes swing_tables.hpp: the polynomials and tables on which the swing's fast functions stand.
///
/// The whole of them is made here, with fifty digits, each time the edition is built. Every piece is
/// written with its method, its interval, its degree, and the largest error found. Usage: swing-tables FILE
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
#include "writing.hpp"

namespace
{

using exact::Fifty;
using generate::bits;
using generate::Fit;
using generate::hex;
using generate::rounded;
using generate::Sample;
using generate::write_array;
namespace oracle = swing::oracle;
using Function = std::function<Fifty(const Fifty&)>;

std::FILE* out = nullptr;

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
  write_array(out, name,
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
  write_array(out, "exponential",
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

// The polynomial about a centre where the function is known to have the value given: it interpolates
// (f(x) − value)/(x − centre).
Row make_row(const Function& f, const Fifty& a, const Fifty& b, double centre, double value)
{
  std::vector<Fifty> t;
  std::vector<Fifty> slopes;
  for(const Fifty& x : generate::tchebychef_points(degree, a, b))
  {
    t.push_back(x - Fifty(centre));
    slopes.push_back((f(x) - Fifty(value)) / t.back());
  }
  Row row{centre, rounded(generate::through(t, slopes)), 0};
  row.c.insert(row.c.begin(), value);
  const std::vector<Fifty> c(row.c.begin(), row.c.end());
  for(const Fifty& x : generate::tchebychef_points(9, a, b))
  {
    const Fifty exact_value = f(x);
    const Fifty error = generate::value(c, x - Fifty(centre)) - exact_value;
    row.error =
        std::fmax(row.error, static_cast<double>(abs(error) / std::max(Fifty(1), abs(exact_value))));
  }
  return row;
}

// The centre is moved about the middle of the interval until the function there is very nearly a double:
// then its value needs no second word.
Row make_row(const Function& f, const Fifty& a, const Fifty& b)
{
  const std::vector<Fifty> nodes = generate::tchebychef_points(11, a, b);
  const Fifty middle = (a + b) / Fifty(2);
  std::vector<Fifty> values;
  std::vector<Fifty> shifted;
  for(const Fifty& x : nodes)
  {
    values.push_back(f(x));
    shifted.push_back(x - middle);
  }
  const std::vector<Fifty> fine = generate::through(shifted, values);
  const Fifty step = (b - a) / Fifty(4096);
  double best_centre = 0;
  double best_value = 0;
  double best = 1;
  for(int i = 0; i < 300 && best > 1.0 / 128; ++i)
  {
    const double centre = static_cast<double>(middle + step * Fifty(i % 2 == 0 ? i / 2 : -(i + 1) / 2));
    const Fifty exact_value = generate::value(fine, Fifty(centre) - middle);
    const double value = static_cast<double>(exact_value);
    const double miss = exact::ulps(value, exact_value);
    if(miss < best)
    {
      best = miss;
      best_value = value;
      best_centre = centre;
    }
  }
  return make_row([&](const Fifty& x) { return generate::value(fine, x - middle); }, a, b, best_centre,
                  best_value);
}

// Of scale·ln(1/x): the value is a multiple of 2⁻⁴², so that its sum with a multiple of the doubling's is
// exact, to 2⁻⁶¹. Neighbouring multiples would all be missed alike, for the middle of a row is a short
// fraction.
Row make_logarithm_row(const Fifty& scale, const Fifty& a, const Fifty& b)
{
  const auto f = [&](const Fifty& x) { return -scale * log(x); };
  const double first = std::nearbyint(std::ldexp(static_cast<double>(f((a + b) / Fifty(2))), 42));
  double best_centre = 0;
  double best_value = 0;
  Fifty best = 1;
  for(int i = 0; i < 2000 && best > ldexp(Fifty(1), -61); ++i)
  {
    const double value = std::ldexp(first + 100003.0 * (i % 2 == 0 ? i / 2 : -(i + 1) / 2), -42);
    const double centre = static_cast<double>(exp(Fifty(-value) / scale));
    const Fifty miss = abs(f(centre) - Fifty(value));
    if(miss < best)
    {
      best = miss;
      best_value = value;
      best_centre = centre;
    }
  }
  return make_row(f, a, b, best_centre, best_value);
}

// Rows one after another, and the largest error of them.
struct Rows
{
  std::string text;
  double error = 0;
  int count = 0;

  void add(const Row& row)
  {
    error = std::fmax(error, row.error);
    text += "    " + hex(row.centre) + ",";
    for(double c : row.c)
      text += " " + hex(c) + ",";
    text += "\n";
    ++count;
  }
};

// Sixty-four rows for each doubling of x from 2^lowest on, until `last` is in a row. Writes where they
// begin.
void add_table(Rows& rows, const std::string& name, const std::string& what, int lowest, double last,
               const Function& f)
{
  std::fprintf(out,
               "\n// %s, from 2^%d to %g.\n"
               "inline constexpr unsigned %s_first = %d;\n"
               "inline constexpr double %s_start = 0x1p%d;\n",
               what.c_str(), lowest, last, name.c_str(), rows.count, name.c_str(), lowest);
  Fifty b = 0;
  for(int i = 0; b <= Fifty(last); ++i)
  {
    const Fifty octave = ldexp(Fifty(1), lowest + i / 64);
    const Fifty a = octave * (Fifty(1) + Fifty(i % 64) / Fifty(64));
    b = octave * (Fifty(1) + Fifty(i % 64 + 1) / Fifty(64));
    rows.add(make_row(f, a, b));
  }
}

// The 64 rows of scale·ln(1/x) for x from 1 to 2.
void add_logarithm(Rows& rows, const Fifty& scale)
{
  for(int i = 0; i < 64; ++i)
    rows.add(
        make_logarithm_row(scale, Fifty(1) + Fifty(i) / Fifty(64), Fifty(1) + Fifty(i + 1) / Fifty(64)));
}

void write_rows(const std::string& name, const Rows& rows)
{
  std::fprintf(
      out,
      "\n// All of them, and before them 64 rows of the logarithm of 1/x for x from 1 to 2. They are\n"
      "// interpolated to degree %d about a centre where the value is a double to 1/128 ulp; largest\n"
      "// error, relative where the function exceeds 1, %s\n"
      "alignas(64) [[gnu::visibility(\"hidden\")]] inline constexpr double %s_rows[] = {\n%s};\n",
      degree, bits(Fifty(rows.error)).c_str(), name.c_str(), rows.text.c_str());
}

// Below the table f = λ + z(p₀ + p₁z + … + λ(q₀ + q₁z + …)), where λ is a logarithm and q a power series of
// z whose value is known: it is interpolated, and what is left approximated by p.
void write_below(const std::string& name, const std::string& what, int terms, int log_terms,
                 const Fifty& last, const Function& f, const Function& log_of, const Function& small_of,
                 const Function& factor)
{
  std::vector<Fifty> z;
  std::vector<Fifty> q;
  for(const Fifty& x : generate::tchebychef_points(log_terms, Fifty(0), last))
  {
    z.push_back(small_of(x));
    q.push_back((factor(x) - Fifty(1)) / z.back());
  }
  const std::vector<double> with_log = rounded(generate::through(z, q));
  const std::vector<Fifty> taken(with_log.begin(), with_log.end());
  std::vector<Sample> samples;
  for(const Fifty& x : grid(last * Fifty(1e-6), last))
  {
    const Fifty small = small_of(x);
    const Fifty value = f(x);
    const Fifty logarithm = log_of(x);
    Sample sample;
    Fifty term = small / value;
    for(int j = 0; j < terms; ++j, term *= small)
      sample.basis.push_back(term);
    sample.target = (value - logarithm - logarithm * small * generate::value(taken, small)) / value;
    samples.push_back(std::move(sample));
  }
  const Fit fit = generate::minimax(samples);
  write_array(out, name + "_plain", what + "; largest relative error " + bits(fit.error),
              rounded(fit.coefficients));
  write_array(out, name + "_with_log", "and what is multiplied by λ there too", with_log);
}

// K by y = 1 − k, which is a double, K by kc, and T/Θ by η: eight doublings of each, and below a logarithm.
void write_tables()
{
  std::fprintf(out,
               "\n// The tables have rows of %d numbers: f(x) = c[1] + c[2] t + … with t = x − c[0].\n"
               "inline constexpr unsigned row_length = %d;\n",
               degree + 2, degree + 2);
  const Fifty two_over_pi = Fifty(2) / exact::pi();
  const Function K_by_y = [](const Fifty& y) {
    return oracle::K_from_complement(sqrt(y * (Fifty(2) - y)));
  };
  Rows K;
  add_logarithm(K, Fifty(1));
  add_table(K, "K_by_modulus", "K by 1 − k", -8, 1, K_by_y);
  add_table(K, "K_by_complement", "K by kc", -8, 1, oracle::K_from_complement);
  write_rows("K", K);
  Rows ratio;
  add_logarithm(ratio, two_over_pi);
  add_table(ratio, "ratio_by_eta", "T/Θ by η", -7, 3.1415926535897931, oracle::ratio_from_top);
  write_rows("ratio", ratio);

  // What multiplies the logarithm is (2/π)K of the complementary modulus.
  const Fifty half = Fifty(0.5);
  write_below(
      "K_by_modulus", "2K below the table, λ = ln(8/y), z = y = 1 − k", 5, 4, ldexp(Fifty(1), -8),
      [=](const Fifty& y) { return Fifty(2) * K_by_y(y); },
      [](const Fifty& y) { return log(Fifty(8) / y); }, [](const Fifty& y) { return y; },
      [=](const Fifty& y) { return two_over_pi * oracle::K(sqrt(y * (Fifty(2) - y))); });
  write_below(
      "K_by_complement", "K below the table, λ = ln(4/kc), z = kc²", 3, 2, ldexp(Fifty(1), -8),
      oracle::K_from_complement, [](const Fifty& kc) { return log(Fifty(4) / kc); },
      [](const Fifty& kc) { return kc * kc; },
      [=](const Fifty& kc) { return two_over_pi * oracle::K(kc); });
  write_below(
      "ratio_by_eta", "T/Θ below the table, λ = (2/π) ln(8/η), z = η²", 3, 2, ldexp(Fifty(1), -7),
      oracle::ratio_from_top, [=](const Fifty& eta) { return two_over_pi * log(Fifty(8) / eta); },
      [](const Fifty& eta) { return eta * eta; },
      [=](const Fifty& eta) { return two_over_pi * oracle::K(sin(eta * half)); });
}

// d⁸ and d⁹ for |d| ≤ ½ by polynomials of degree 6 and 7 that vanish at 0. In x = 2d it is the
// interpolation at the zeros of Tchebychef's polynomials: of y = x² that of degree 4, on an interval just
// so long that its lowest zero is at 0; and of x that of degree 9.
void write_powers()
{
  const Fifty pi = exact::pi();
  std::vector<Fifty> y;
  for(int i = 0; i < 4; ++i)
    y.push_back((cos(pi / Fifty(8)) + cos(pi * Fifty(7 - 2 * i) / Fifty(8)))
                / (cos(pi / Fifty(8)) + Fifty(1)));
  std::vector<Fifty> fourth;
  for(const Fifty& value : y)
    fourth.push_back(value * value * value * value);
  const std::vector<Fifty> even = generate::through(y, fourth);
  std::vector<double> eighth;
  for(int j = 1; j < 4; ++j)
    eighth.push_back(static_cast<double>(ldexp(even[static_cast<std::size_t>(j)], 2 * j - 8)));
  write_array(out, "eighth_power", "d⁸ ≈ c₀d² + c₁d⁴ + c₂d⁶ for |d| ≤ ½", eighth);

  const std::vector<Fifty> x = generate::tchebychef_points(9, Fifty(-1), Fifty(1));
  std::vector<Fifty> ninth;
  for(const Fifty& value : x)
    ninth.push_back(value * value * value * value * value * value * value * value * value);
  const std::vector<Fifty> odd = generate::through(x, ninth);
  std::vector<double> c;
  for(int j = 1; j < 9; j += 2)
    c.push_back(static_cast<double>(ldexp(odd[static_cast<std::size_t>(j)], j - 9)));
  write_array(out, "ninth_power", "d⁹ ≈ c₀d + c₁d³ + c₂d⁵ + c₃d⁷ for |d| ≤ ½", c);
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
  write_powers();
  write_tables();
  std::fprintf(out, "\n} // namespace swing::tables\n");
  return std::fclose(out) == 0 ? 0 : 1;
}
