/// @file
/// Writes swing_tables.hpp: the polynomials and tables on which the swing's fast functions stand.
///
/// The whole of them is made here, with fifty digits, each time the edition is built. Every piece is
/// written with its method, its interval, its degree, and the largest error found. Usage: swing-tables FILE
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
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

// A constant as a double of few digits, so that its product with a small integer is exact, and the rest.
std::vector<double> parts_of(const Fifty& x, int kept_bits)
{
  const int shift = kept_bits - static_cast<int>(std::ceil(std::log2(std::fabs(static_cast<double>(x)))));
  const double head = kept_bits >= 53
                          ? static_cast<double>(x)
                          : std::ldexp(std::nearbyint(std::ldexp(static_cast<double>(x), shift)), -shift);
  return {head, static_cast<double>(x - Fifty(head))};
}

void write_constant(const std::string& name, const Fifty& x, int kept_bits)
{
  const std::vector<double> parts = parts_of(x, kept_bits);
  const char* const format = "inline constexpr double %s_hi = %s;\ninline constexpr double %s_lo = %s;\n";
  std::fprintf(out, format, name.c_str(), hex(parts[0]).c_str(), name.c_str(), hex(parts[1]).c_str());
}

// Points from a to b, crowded towards both ends, where the extremes of a best approximation crowd too.
std::vector<Fifty> grid(const Fifty& a, const Fifty& b)
{
  return generate::tchebychef_points(dense, a, b);
}

// f(x) = fixed(x) + scale(x)·(c₀ + c₁x² + …), the error relative to f.
Fit even_fit(int terms, const Fifty& a, const Fifty& b, const Function& f, const Function& fixed,
             const Function& scale)
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
  return generate::minimax(samples);
}

// Writes the c.
void write_even(const std::string& name, const std::string& what, int terms, const Fifty& a, const Fifty& b,
                const Function& f, const Function& fixed, const Function& scale)
{
  const Fit fit = even_fit(terms, a, b, f, fixed, scale);
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

// The highest degree of a row's quotient, above and below, and how many numbers a row has: two lines of the
// cache.
constexpr int degree = 5;
constexpr std::size_t row_length = 16;

// (f − f(at))/(x − at) of a polynomial f, by division.
std::vector<Fifty> slope_of(const std::vector<Fifty>& f, const Fifty& at)
{
  std::vector<Fifty> slope(f.size() - 1);
  Fifty sum = 0;
  for(std::size_t j = f.size() - 1; j > 0; --j)
  {
    sum = sum * at + f[j];
    slope[j - 1] = sum;
  }
  return slope;
}

// Where between a and b a monotonic function has a value.
Fifty place_of(const Function& f, const Fifty& wanted, Fifty a, Fifty b)
{
  const bool rises = f(b) > f(a);
  for(int i = 0; i < 60; ++i)
  {
    const Fifty middle = (a + b) / Fifty(2);
    ((f(middle) < wanted) == rises ? a : b) = middle;
  }
  return a;
}

// A place where a function is known, and what it is there, of both the nearest doubles.
struct Centre
{
  double place;
  double value;
};

// Where the function, of z between a and b, is in the middle between its values at the ends, so that least is to be
// added; moved until it is very nearly a double: then its value needs no second word.
Centre centre_of(const Function& f, const Fifty& a, const Fifty& b)
{
  const Fifty middle = place_of(f, (f(a) + f(b)) / Fifty(2), a, b);
  const Fifty step = (b - a) / Fifty(4096);
  Centre best{};
  double least = 1;
  for(int i = 0; i < 300 && least > 1.0 / 128; ++i)
  {
    const double place = static_cast<double>(middle + step * Fifty(i % 2 == 0 ? i / 2 : -(i + 1) / 2));
    const Fifty exact_value = f(place);
    const double value = static_cast<double>(exact_value);
    const double miss = exact::ulps(value, exact_value);
    if(miss < least)
    {
      least = miss;
      best = {place, value};
    }
  }
  return best;
}

// The quotient that differs from f between a and b by less than `allowed`, of the lowest degree with which
// one does: with a higher one, zeros below and above would meet to no purpose. Below stays positive.
generate::Quotient quotient_of(const Function& f, const Fifty& a, const Fifty& b, const Fifty& centre,
                               const Fifty& allowed)
{
  for(int n = 1; n <= degree; ++n)
  {
    generate::Quotient q = generate::rational(f, n, a, b, centre);
    bool good = true;
    for(int i = 0; i <= 100 && good; ++i)
    {
      const Fifty x = a + (b - a) * Fifty(i) / Fifty(100);
      const Fifty t = x - centre;
      const Fifty below = generate::value(q.below, t);
      good = below > Fifty(0.1) && abs(generate::value(q.above, t) / below - f(x)) < allowed;
    }
    if(good)
      return q;
  }
  throw std::runtime_error("no quotient of so low a degree comes so near");
}

// Rows one after another, and the largest error of them, relative to the function.
struct Rows
{
  bool sloping = false;
  std::string text = {};
  Fifty error = 0;
  int count = 0;

  // The row of f for z from a to b: f(z) = value + t (slope + N(t)/D(t)), where t = z − centre. The coefficients of N
  // and D stand in pairs. Where the rows are sloping N is small; without, the slope is zero. Where the interval is
  // long, of sloping rows, the slope is a power of two, so that its product is exact.
  void add(const Function& f, const Fifty& a, const Fifty& b, bool is_long = false)
  {
    const Fifty middle = (a + b) / Fifty(2);
    std::vector<Fifty> distances;
    std::vector<Fifty> values;
    for(const Fifty& z : generate::tchebychef_points(26, a, b))
    {
      distances.push_back(z - middle);
      values.push_back(f(z));
    }
    const std::vector<Fifty> fine = generate::through(distances, values);
    const Centre centre =
        centre_of([&](const Fifty& z) { return generate::value(fine, z - middle); }, a, b);
    const Fifty at = centre.place;
    const std::vector<Fifty> differences = slope_of(fine, at - middle);
    const generate::Quotient q =
        quotient_of([&](const Fifty& z) { return generate::value(differences, z - middle); }, a, b, at,
                    ldexp(Fifty(centre.value), is_long ? -58 : -59) / std::max(b - at, at - a));
    double slope = sloping ? static_cast<double>(q.above[0]) : 0;
    if(is_long)
      slope = std::exp2(std::round(std::log2(slope)));
    std::vector<double> row{centre.place, centre.value};
    for(std::size_t j = 0; j < q.above.size(); ++j)
      row.insert(row.end(), {static_cast<double>(q.above[j] - Fifty(slope) * q.below[j]),
                             static_cast<double>(q.below[j])});
    row.resize(row_length);
    row[row_length - 2] = slope;
    write(row);
    see_error(row, f, a, b);
  }

  void see_error(const std::vector<double>& row, const Function& f, const Fifty& a, const Fifty& b)
  {
    std::vector<Fifty> above;
    std::vector<Fifty> below;
    for(std::size_t j = 2; j < row_length - 2; j += 2)
    {
      above.push_back(row[j]);
      below.push_back(row[j + 1]);
    }
    for(const Fifty& z : generate::tchebychef_points(40, a, b))
    {
      const Fifty t = z - Fifty(row[0]);
      const Fifty slope =
          Fifty(row[row_length - 2]) + generate::value(above, t) / generate::value(below, t);
      error = std::max(error, abs((Fifty(row[1]) + t * slope) / f(z) - Fifty(1)));
    }
  }

  void write(const std::vector<double>& row)
  {
    text += "     {";
    for(double c : row)
      text.append(hex(c)).append(", ");
    text += "},\n";
    ++count;
  }
};

// So many rows for each doubling of x from 2^lowest on, until `last` is in a row.
void add_octaves(Rows& rows, const Function& f, int per_octave, int lowest, double last)
{
  Fifty b = 0;
  for(int i = 0; b <= Fifty(last); ++i)
  {
    const Fifty octave = ldexp(Fifty(1), lowest + i / per_octave);
    const Fifty a = octave * (Fifty(1) + Fifty(i % per_octave) / Fifty(per_octave));
    b = octave * (Fifty(1) + Fifty(i % per_octave + 1) / Fifty(per_octave));
    rows.add(f, a, b);
  }
}

// The place near the middle of the interval from a to b where scale·ln(1/x) is a multiple of 2⁻⁴², so that
// its sum with a multiple of the doubling's is exact, to 2⁻⁶¹. Neighbouring multiples would all be missed
// alike, for the middle is a short fraction.
Centre logarithm_centre(const Fifty& scale, const Fifty& a, const Fifty& b)
{
  const auto f = [&](const Fifty& x) { return -scale * log(x); };
  const double first = std::nearbyint(std::ldexp(static_cast<double>(f((a + b) / Fifty(2))), 42));
  Centre best{};
  Fifty least = 1;
  for(int i = 0; i < 2000 && least > ldexp(Fifty(1), -61); ++i)
  {
    const double value = std::ldexp(first + 100003.0 * (i % 2 == 0 ? i / 2 : -(i + 1) / 2), -42);
    const double place = static_cast<double>(exp(Fifty(-value) / scale));
    const Fifty miss = abs(f(place) - Fifty(value));
    if(miss < least)
    {
      least = miss;
      best = {place, value};
    }
  }
  return best;
}

// Of scale·ln(1/x) for x from 1 to 2 eight centres, each with its value; of s = (x − centre)/(x + centre)
// what is added, −2 scale artanh s = s(c₀ + c₁s² + …); and what a doubling of x takes off, in two parts.
struct Logarithm
{
  std::vector<double> centres;
  std::vector<double> beyond;
  std::vector<double> halving;
  Fifty error;  // of what is added, relative to it
};

Logarithm logarithm(const Fifty& scale)
{
  constexpr int pieces = 8;
  Logarithm l;
  for(int i = 0; i < pieces; ++i)
  {
    const Centre c = logarithm_centre(scale, Fifty(1) + Fifty(i) / Fifty(pieces),
                                      Fifty(1) + Fifty(i + 1) / Fifty(pieces));
    l.centres.insert(l.centres.end(), {c.place, c.value});
  }
  const Fit fit = even_fit(
      4, Fifty(1e-6), Fifty(1) / Fifty(33),
      [&](const Fifty& s) { return scale * log((Fifty(1) - s) / (Fifty(1) + s)); },
      [](const Fifty&) { return Fifty(0); }, [](const Fifty& s) { return s; });
  l.beyond = rounded(fit.coefficients);
  l.error = fit.error;
  l.halving = parts_of(scale * exact::ln2(), 40);
  return l;
}

// Below the rows f = λ + z(p₀ + p₁z + … + λ(q₀ + q₁z + …)), where λ is a logarithm and q a power series of
// z whose value is known: it is interpolated, and what is left approximated by p.
struct Below
{
  std::vector<double> plain;
  std::vector<double> with_log;
  Fifty error;  // relative to f
};

Below below(int terms, int log_terms, const Fifty& last, const Function& f, const Function& log_of,
            const Function& small_of, const Function& factor)
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
  return {rounded(fit.coefficients), with_log, fit.error};
}

std::string braces(const std::vector<double>& c)
{
  std::string text = "{";
  for(std::size_t i = 0; i < c.size(); ++i)
    text.append(i == 0 ? "" : i % 4 == 0 ? ",\n     " : ", ").append(hex(c[i]));
  return text.append("}");
}

// The logarithm is zero at 2 to the power `zero`.
void write_function(const std::string& name, const std::string& what, const Rows& rows, int zero,
                    const Logarithm& l, const Below& b)
{
  std::fprintf(
      out,
      "\n// %s.\n"
      "// Largest relative errors: of the rows %s, below %s, of what is added to the logarithm %s.\n"
      "[[gnu::visibility(\"hidden\")]] inline constexpr Function<%d, %zu, %zu> %s = {\n"
      "    0x1p52 + %d,\n    %s,\n    %s,\n    %s,\n    %s,\n    %s,\n    {\n%s    }};\n",
      what.c_str(), bits(rows.error).c_str(), bits(b.error).c_str(), bits(l.error).c_str(), rows.count,
      b.plain.size(), b.with_log.size(), name.c_str(), 1023 + zero, braces(l.halving).c_str(),
      braces(l.beyond).c_str(), braces(b.plain).c_str(), braces(b.with_log).c_str(),
      braces(l.centres).c_str(), rows.text.c_str());
}

// What the tables are: all that is read of a function stands together, since whatever lies elsewhere must be
// fetched too where the caches are cold.
void write_form()
{
  std::fprintf(
      out,
      "\n// All that is read of a function f. A row has %zu numbers: f(x) = c[1] + t (c[14] + N(t)/D(t)),\n"
      "// t = x − c[0], with polynomials of degree up to %d whose coefficients are c[2], c[4], … and "
      "c[3],\n"
      "// c[5], … Below the rows f is a logarithm and a short polynomial: see swing/rows.hpp.\n"
      "inline constexpr unsigned row_length = %zu;\n"
      "template <unsigned row_count, unsigned terms, unsigned log_terms>\n"
      "struct alignas(128) Function\n{\n"
      "  double zero;                 // 2^52 and the exponent, as it is stored, of where λ is zero\n"
      "  double halving[2];           // what a halving of x adds to the logarithm λ\n"
      "  double beyond[4];            // what λ adds to its value at a centre\n"
      "  double plain[terms];         // p\n"
      "  double with_log[log_terms];  // q\n"
      "  alignas(64) double centres[16];  // of the logarithm, each with its value\n"
      "  alignas(128) double rows[row_count][row_length];\n};\n",
      row_length, degree, row_length);
}

// K by the modulus, K by kc, and T/Θ by η: eight or nine doublings of each, and below a logarithm. The modulus is
// looked for by y = 1 − k, which is a double from k = ½ on; there the rows have k, and for all smaller k one
// row has k². So has one row ζ² for all η from 25/16 on.
void write_functions()
{
  const Fifty two_over_pi = Fifty(2) / exact::pi();
  const Fifty half = Fifty(0.5);
  const Fifty last = ldexp(Fifty(1), -8);
  const Function K_by_y = [](const Fifty& y) {
    return oracle::K_from_complement(sqrt(y * (Fifty(2) - y)));
  };
  // What multiplies the logarithm is (2/π)K of the complementary modulus.
  Rows modulus{};
  for(int i = 0; i < 32; ++i)
  {
    const Fifty step = ldexp(Fifty(1), i / 4 - 11);
    const Fifty y = Fifty(4 + i % 4) * step;
    modulus.add([&](const Fifty& k) { return K_by_y(Fifty(1) - k); }, Fifty(1) - y - step, Fifty(1) - y);
  }
  modulus.add([](const Fifty& m) { return oracle::K_from_complement(sqrt(Fifty(1) - m)); }, Fifty(0),
              Fifty(0.25));
  write_function(
      "K_by_modulus",
      "K by y = 1 − k: four rows to an octave, one for all k up to ½; below 2^-9 λ = ½ ln(8/y), z = y",
      modulus, 3, logarithm(half),
      below(
          5, 4, half * last, K_by_y, [=](const Fifty& y) { return half * log(Fifty(8) / y); },
          [](const Fifty& y) { return y; },
          [=](const Fifty& y) { return two_over_pi * oracle::K(sqrt(y * (Fifty(2) - y))); }));
  Rows complement{};
  add_octaves(complement, oracle::K_from_complement, 8, -8, 1);
  write_function("K_by_complement", "K by kc: eight rows to an octave; below 2^-8 λ = ln(4/kc), z = kc²",
                 complement, 2, logarithm(Fifty(1)),
                 below(
                     3, 2, last, oracle::K_from_complement,
                     [](const Fifty& kc) { return log(Fifty(4) / kc); },
                     [](const Fifty& kc) { return kc * kc; },
                     [=](const Fifty& kc) { return two_over_pi * oracle::K(kc); }));
  Rows ratio{true};
  const double least_eta = 1.5625;
  add_octaves(ratio, oracle::ratio_from_top, 4, -7, least_eta);
  const Fifty last_zeta = exact::pi() - Fifty(least_eta);
  ratio.add([](const Fifty& z) { return oracle::ratio_from_bottom(sqrt(z)); }, Fifty(0),
            last_zeta * last_zeta, true);
  write_function(
      "ratio_by_eta",
      "T/Θ by η: four rows to an octave, one for all η from 25/16 on; below 2^-7 λ = (2/π) ln(8/η), z = η²",
      ratio, 3, logarithm(two_over_pi),
      below(
          3, 2, Fifty(2) * last, oracle::ratio_from_top,
          [=](const Fifty& eta) { return two_over_pi * log(Fifty(8) / eta); },
          [](const Fifty& eta) { return eta * eta; },
          [=](const Fifty& eta) { return two_over_pi * oracle::K(sin(eta * half)); }));
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
  write_constant("one_over_pi", Fifty(1) / exact::pi(), 53);
  write_elementary();
  write_exponential();
  write_excess();
  write_powers();
  write_form();
  write_functions();
  std::fprintf(out, "\n} // namespace swing::tables\n");
  return std::fclose(out) == 0 ? 0 : 1;
}
