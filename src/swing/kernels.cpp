// Compiled once for each instruction set, with SWING_VARIANT naming it; see kernels.hpp. Everything but the
// last object has internal linkage and nothing inline is taken from a library, so that no code made for one
// processor can be picked by the linker for another. What is computed for one number is free of branches: the
// compiler works on many numbers at once.
#include "swing/kernels.hpp"

#include <cstdint>
#include <limits>
#include <utility>

#include "swing/rows.hpp"

#define SWING_TEXT(x) #x
#define SWING_NAME(x) SWING_TEXT(x)

namespace swing::kernels
{
namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using rows::bits_of;
using rows::from_bits;

constexpr std::uint64_t sign_bit = 0x8000000000000000;

SWING_INLINE double magnitude(double x)
{
  return from_bits(bits_of(x) & ~sign_bit);
}
SWING_INLINE double with_sign(double x, std::uint64_t sign)
{
  return from_bits(bits_of(x) ^ sign);
}

// c[first] + c[first + step] x + … of the first n coefficients, unrolled.
template <unsigned first, unsigned step, unsigned n>
SWING_INLINE double horner(const double* c, double x)
{
  if constexpr(first + step < n)
    return c[first] + x * horner<first + step, step, n>(c, x);
  else
    return c[first];
}

// c[0] + c[1] x + …, the even and the odd powers apart: half the wait for one multiplication more.
template <unsigned n>
SWING_INLINE double polynomial(const double* c, double x)
{
  return horner<0, 2, n>(c, x * x) + x * horner<1, 2, n>(c, x * x);
}
template <unsigned n>
SWING_INLINE double polynomial(const double (&c)[n], double x)
{
  return polynomial<n>(&c[0], x);
}

// Through a long computation the numbers go step by step, so many in one step before the next begins: of a
// short one the processor has several under way, of a long one it waits for each result.
constexpr std::size_t block = 128;

// A number and what it was rounded by, so small that its effect need only be known to a few digits.
struct Part
{
  double value;
  double lost;
};

// sin πr / π for |r| ≤ ½; its slope, cos πr, is not far from 1 − 4r².
SWING_INLINE double sine_of_turns(Part r)
{
  const double x = r.value * r.value;
  return r.value + (r.lost * (1 - 4 * x) + (r.value * x) * polynomial(tables::sine_of_turns, x));
}

// e⁻ˣ − 1 and e⁻ˣ for 0 ≤ x ≤ 700.
struct Exponential
{
  double minus_one;
  double value;
};

SWING_INLINE Exponential exponential_of_minus(Part x)
{
  constexpr double inverse = 1 / (tables::ln2_hi + tables::ln2_lo);
  const double shifted = x.value * inverse + 0x1.8p52;
  const double n = shifted - 0x1.8p52;
  const double r = (n * tables::ln2_hi - x.value) + (n * tables::ln2_lo - x.lost);
  const double p = r + (r * r) * polynomial(tables::exponential, r);
  const double scale = from_bits((1023 - bits_of(shifted)) << 52);
  return {(scale - 1) + scale * p, scale + scale * p};
}

// 2 arctan (y/x) for x, y ≥ 0, not both zero: from 0, ½π or π, whichever is the nearest.
SWING_INLINE double twice_arc_tangent(double y, double x)
{
  constexpr double tangent_of_eighth = 0.41421356237309503;
  const double difference = y - x;
  const double sum = y + x;
  const bool steep = difference > 0;
  const bool middle = magnitude(difference) < tangent_of_eighth * sum;
  const double s = (middle ? difference : steep ? -x : y) / (middle ? sum : steep ? y : x);
  const double x2 = s * s;
  const double from = middle ? pi_hi / 2 : steep ? pi_hi : 0;
  return from + (from * (pi_lo / pi_hi) + 2 * (s + s * x2 * polynomial(tables::arc_tangent, x2)));
}

// The upper 26 bits of x.
SWING_INLINE double head_of(double x)
{
  const double wide = x * 0x1.0000002p27;
  return wide - (wide - x);
}

// x·y with what the product is rounded by, the halves of y being known.
SWING_INLINE Part product_of(double x, double y, double y_head, double y_tail)
{
  const double product = x * y;
  const double head = head_of(x);
  const double tail = x - head;
  return {product, ((head * y_head - product) + head * y_tail + tail * y_head) + tail * y_tail};
}

// As many numbers as a register holds.
#if defined(__AVX512F__)
constexpr unsigned width = 8;
#elif defined(__AVX__)
constexpr unsigned width = 4;
#else
constexpr unsigned width = 2;
#endif
using Wide = double __attribute__((vector_size(width * sizeof(double))));

SWING_INLINE Wide load(const double* x)
{
  Wide wide;
  __builtin_memcpy(&wide, x, sizeof wide);
  return wide;
}

// Of a and b number by number in turn those in even places, and those in odd places.
template <unsigned... i>
SWING_INLINE void exchange_numbers(Wide& a, Wide& b, std::integer_sequence<unsigned, i...>)
{
  const Wide first = a;
  a = __builtin_shufflevector(first, b, (i % 2 == 0 ? i : width + i - 1)...);
  b = __builtin_shufflevector(first, b, (i % 2 == 0 ? i + 1 : width + i)...);
}

// Of a and then b the pairs in even places, and those in odd places.
template <unsigned... i>
SWING_INLINE void exchange_pairs(Wide& a, Wide& b, std::integer_sequence<unsigned, i...>)
{
  const Wide first = a;
  a = __builtin_shufflevector(first, b, (i / 2 * 4 + i % 2)...);
  b = __builtin_shufflevector(first, b, (i / 2 * 4 + i % 2 + 2)...);
}

// Transposes a square: first within the pairs, then the pairs, each time between the rows whose numbers
// differ by `distance`.
template <unsigned distance = 1>
SWING_INLINE void transpose(Wide* row)
{
  constexpr std::make_integer_sequence<unsigned, width> places{};
#pragma GCC unroll 8
  for(unsigned i = 0; i < width; ++i)
    if((i & distance) == 0)
    {
      if constexpr(distance == 1)
        exchange_numbers(row[i], row[i + distance], places);
      else
        exchange_pairs(row[i], row[i + distance], places);
    }
  if constexpr(2 * distance < width)
    transpose<2 * distance>(row);
}

// The numbers j of the next `width` rows as column[j]. This is much faster than to gather them one by one.
SWING_INLINE void read_columns(const double* table, const std::uint64_t* row, Wide* column)
{
#pragma GCC unroll 8
  for(unsigned j = 0; j < tables::row_length; j += width)
  {
#pragma GCC unroll 8
    for(unsigned i = 0; i < width; ++i)
      column[j + i] = load(table + row[i] + j);
    transpose(column + j);
  }
}

// What of a block is known before the table is read.
struct Arguments
{
  alignas(64) double given[block] = {};
  alignas(64) double lost[block] = {};
  alignas(64) double doubled[block] = {};
  alignas(64) double doublings[block] = {};
  alignas(64) std::uint64_t row[block] = {};
};

template <class Table>
SWING_INLINE double in_domain(double x)
{
  return x > 0 && x <= Table::last ? x : 1;
}

// Each argument's row, and whether some arguments lie below the table.
template <class Kernel>
SWING_INLINE bool find_rows(const double* in, Arguments& a, std::size_t size)
{
  using Table = typename Kernel::Table;
  std::uint64_t below = 0;
  for(std::size_t i = 0; i < size; ++i)
  {
    const double x = Kernel::argument(in[i]);
    const double inside = in_domain<Table>(x);
    a.given[i] = x;
    a.row[i] = rows::row_of<Table>(inside);
    if constexpr(Kernel::inexact)
      a.lost[i] = Kernel::lost(in[i]);
    below |= inside < Table::start;
  }
  return below != 0;
}

// Where some do, all are doubled until they do not.
template <class Kernel>
SWING_INLINE void find_rows_doubled(Arguments& a, std::size_t size)
{
  using Table = typename Kernel::Table;
  for(std::size_t i = 0; i < size; ++i)
  {
    const rows::Doubled d = rows::doubled<Table>(in_domain<Table>(a.given[i]), a.lost[i]);
    a.doubled[i] = d.x;
    a.lost[i] = d.lost;
    a.doublings[i] = d.n;
    a.row[i] = rows::row_of<Table>(d.x);
  }
}

// The values by their rows, as many at once as a register holds.
template <class Kernel, bool doubled>
SWING_INLINE void read_rows(const Arguments& a, double* out, std::size_t size)
{
  using Table = typename Kernel::Table;
  for(std::size_t i = 0; i < size; i += width)
  {
    Wide c[tables::row_length];
    read_columns(Table::rows, a.row + i, c);
    const Wide given = load(a.given + i);
    Wide t = (doubled ? load(a.doubled + i) : given) - c[0];
    if constexpr(Kernel::inexact)
      t += load(a.lost + i);
    rows::Sum<Wide> sum{c[1], rows::beyond_centre(c, t)};
    if constexpr(doubled)
      sum = rows::halved<Table>(sum, load(a.doublings + i));
    const Wide outside = given == 0 ? Wide{} + inf : Wide{} + nan;
    const Wide value = ((given > 0) & (given <= Table::last)) ? sum.main + sum.rest : outside;
    if(size - i >= width)
      __builtin_memcpy(out + i, &value, sizeof value);
    else
      for(std::size_t j = i; j < size; ++j)
        out[j] = value[j - i];
  }
}

template <class Kernel>
void table_loop(const double* in, double* out, std::size_t n)
{
  Arguments a;
  for(std::size_t start = 0; start < n; start += block)
  {
    const std::size_t size = n - start < block ? n - start : block;
    const bool below = find_rows<Kernel>(in + start, a, size);
    if constexpr(Kernel::endless)
      if(below)
      {
        find_rows_doubled<Kernel>(a, size);
        read_rows<Kernel, true>(a, out + start, size);
        continue;
      }
    read_rows<Kernel, false>(a, out + start, size);
  }
}

// What a table is asked for, from what is given: `inexact` with what that lacks, `endless` where it may lie
// below the table.
struct By_modulus
{
  using Table = rows::K_by_modulus;
  static constexpr bool inexact = false;
  static constexpr bool endless = false;
  SWING_INLINE static double argument(double k) { return 1 - magnitude(k); }
};

template <class Of>
struct As_given
{
  using Table = Of;
  static constexpr bool inexact = false;
  static constexpr bool endless = true;
  SWING_INLINE static double argument(double x) { return x; }
};

struct By_zeta
{
  using Table = rows::Ratio_by_eta;
  static constexpr bool inexact = true;
  static constexpr bool endless = true;
  SWING_INLINE static double argument(double zeta) { return zeta >= 0 ? (pi_hi - zeta) + pi_lo : nan; }
  SWING_INLINE static double lost(double zeta) { return ((pi_hi - zeta) - argument(zeta)) + pi_lo; }
};

// scale · (sin z / π) (1 + c₀ x + …), z = πr and x = (sin z / π)².
template <unsigned terms>
SWING_INLINE double sine_series(double scale, double scale_lost, const double* c, Part r)
{
  const double s = sine_of_turns(r);
  const double main = scale * s;
  return main + main * (scale_lost + (s * s) * polynomial<terms>(c, s * s));
}

// Up to 90°: Φ is such a series, and Φ' one of the same kind with z counted from rest.
template <unsigned terms>
struct Low
{
  SWING_INLINE static double angle(const Prepared& p, Part r, Part)
  {
    return sine_series<terms>(p.angle_scale, p.angle_scale_lost, p.angle_series, r);
  }
  SWING_INLINE static double from_top(const Prepared& p, Part r, Part to_rest)
  {
    return (pi_hi - angle(p, r, to_rest)) + pi_lo;
  }
  SWING_INLINE static double speed(const Prepared& p, Part, Part to_rest)
  {
    return sine_series<terms>(p.velocity_scale, p.velocity_scale_lost, p.velocity_series, to_rest);
  }
};

// Revolving with much energy: Φ = 2z + sin z cos z · (c₀ + c₁ x + …), and Φ' goes as 1 + c₀ x + …
struct Fast
{
  SWING_INLINE static double beyond_mean(const Prepared& p, Part r, Part to_top)
  {
    const double s = sine_of_turns(r);
    return s * sine_of_turns(to_top) * polynomial(p.angle_series, s * s);
  }
  SWING_INLINE static double angle(const Prepared& p, Part r, Part to_top)
  {
    return r.value * (2 * pi_hi)
           + (r.value * (2 * pi_lo) + r.lost * (2 * pi_hi) + beyond_mean(p, r, to_top));
  }
  SWING_INLINE static double from_top(const Prepared& p, Part r, Part to_top)
  {
    return to_top.value * (2 * pi_hi)
           + (to_top.value * (2 * pi_lo) + to_top.lost * (2 * pi_hi) - beyond_mean(p, r, to_top));
  }
  SWING_INLINE static double speed(const Prepared& p, Part r, Part)
  {
    const double s = sine_of_turns(r);
    return p.velocity_scale
           + p.velocity_scale * (p.velocity_scale_lost + (s * s) * polynomial(p.velocity_series, s * s));
  }
};

// The dual nome: with v = −r ln q', the powers of g = e⁻ᵛ and h = √q'/g are what the theta functions are made
// of. Neither exceeds 1. Their squares are G and H.
struct Theta
{
  double g;
  double h;
  double one_minus_G;
  double one_minus_H;
};

// With all their digits, 1 − G and 1 − H too: from the nearer end of the half swing.
SWING_INLINE Theta theta_of(const Prepared& p, Part r, Part to_rest)
{
  const bool upper = to_rest.value < r.value;
  const double nearer = upper ? to_rest.value : r.value;
  const double lost = upper ? to_rest.lost : r.lost;
  const Part v = product_of(nearer, p.log_q_hi, p.log_q_head, p.log_q_tail);
  const bool far_down = v.value > 700;
  const double v_lost = v.lost + (lost * p.log_q_hi + nearer * p.log_q_lo);
  const Exponential e = exponential_of_minus({far_down ? 700 : v.value, far_down ? 0 : v_lost});
  const double other = p.root_q / e.value;
  const double near = -e.minus_one * (2 + e.minus_one);
  const double far = (1 - other) * (1 + other);
  return {upper ? other : e.value, upper ? e.value : other, upper ? far : near, upper ? near : far};
}

// Fewer digits suffice for Φ: the error of v does not count where g is small. So v may be taken from the
// bottom all the way.
SWING_INLINE Theta theta_from_bottom(const Prepared& p, Part r)
{
  const double v = r.value * p.log_q_hi;
  const bool far_down = v > 700;
  const Exponential e = exponential_of_minus({far_down ? 700 : v, far_down ? 0 : r.lost * p.log_q_hi});
  const double h = p.root_q / e.value;
  return {e.value, h, -e.minus_one * (2 + e.minus_one), (1 - h) * (1 + h)};
}

// What remains of a theta function when its first factor, 1 ± G or 1 ± H, is taken out, is 1 and this:
// y (1 + x + x²) + q² y² (1 + x + … + x⁴) + q⁶ y³ (1 + x + … + x⁶). In the last term, which is less than q⁹,
// x⁵ and x⁶ no longer count; and with q' < 2⁻¹⁴ the first term suffices.
template <int terms>
SWING_INLINE double beyond_one(const Prepared& p, double x, double y)
{
  const double three = 1 + x * (1 + x);
  if constexpr(terms == 1)
    return y * three;
  const double five = 1 + x * (1 + x * three);
  const double q2 = p.q * p.q;
  return y * (three + (y * q2) * (five + (y * q2 * q2) * five));
}

// The cofactors of θ₁ … θ₄, less 1; their first factors are 1 − G, 1 + G, 1 + H and 1 − H.
template <int terms>
struct Cofactors
{
  SWING_INLINE static double of_1(const Prepared& p, const Theta& t)
  {
    return beyond_one<terms>(p, t.g * t.g, -p.q * (t.h * t.h));
  }
  SWING_INLINE static double of_2(const Prepared& p, const Theta& t)
  {
    return beyond_one<terms>(p, -(t.g * t.g), p.q * (t.h * t.h));
  }
  SWING_INLINE static double of_3(const Prepared& p, const Theta& t)
  {
    return beyond_one<terms>(p, -(t.h * t.h), p.q * (t.g * t.g));
  }
  SWING_INLINE static double of_4(const Prepared& p, const Theta& t)
  {
    return beyond_one<terms>(p, t.h * t.h, -p.q * (t.g * t.g));
  }
};

// main·(1 + a)/(1 + b) and what the factor in it was rounded by, where a and b are small.
SWING_INLINE double nearly(const Prepared& p, double main, double a, double b)
{
  return main + main * (p.velocity_scale_lost + (a - b) / (1 + b));
}

// A positive quotient, the tangent of ½Φ.
struct Quotient
{
  double above;
  double below;
};

// Above 90°: C θ₁/θ₃ of the dual nome.
template <int terms>
struct High
{
  SWING_INLINE static Theta theta(const Prepared& p, Part r, Part) { return theta_from_bottom(p, r); }
  SWING_INLINE static Quotient tangent(const Prepared& p, const Theta& t)
  {
    return {p.angle_scale * (t.one_minus_G * (1 + Cofactors<terms>::of_1(p, t))),
            t.g * ((1 + t.h * t.h) * (1 + Cofactors<terms>::of_3(p, t)))};
  }
  SWING_INLINE static double speed(const Prepared& p, const Theta& t)
  {
    const double main = p.velocity_scale * (t.g * t.one_minus_H / (1 + t.g * t.g));
    return nearly(p, main, Cofactors<terms>::of_4(p, t), Cofactors<terms>::of_2(p, t));
  }
};

// Revolving with little energy: C θ₁/θ₄ of the dual nome, and Φ' goes as θ₃/θ₂.
struct Barely
{
  SWING_INLINE static Theta theta(const Prepared& p, Part r, Part to_top) { return theta_of(p, r, to_top); }
  SWING_INLINE static Quotient tangent(const Prepared& p, const Theta& t)
  {
    return {p.angle_scale * (t.one_minus_G * (1 + Cofactors<3>::of_1(p, t))),
            t.g * (t.one_minus_H * (1 + Cofactors<3>::of_4(p, t)))};
  }
  SWING_INLINE static double speed(const Prepared& p, const Theta& t)
  {
    const double main = p.velocity_scale * (t.g * (1 + t.h * t.h) / (1 + t.g * t.g));
    return nearly(p, main, Cofactors<3>::of_3(p, t), Cofactors<3>::of_2(p, t));
  }
};

// What is asked, and where the clock started.
enum class Asked
{
  angle,
  velocity,
  from_top
};
enum class From
{
  bottom,
  rest,
  going_round
};

// Where in its half swing the pendulum is: of the time, n half swings are taken off.
struct Phase
{
  Part behind;         // since the bottom, in half swings
  Part ahead;          // what is left to rest or to the top: the rest of ½
  double n;            // a whole number
  std::uint64_t sign;  // of what is asked
};

// The product t·f is formed exactly; n is taken off before the rest is added. Started at rest, what is left
// and what is gone change their places. Going round, a half swing is a whole turn.
template <From from, Asked asked>
SWING_INLINE Phase phase_of(const Prepared& p, double t)
{
  const Part product = product_of(t, p.f_hi, p.f_head, p.f_tail);
  const double lost = product.lost + t * p.f_lo;
  const double shifted = product.value + 0x1.8p52;
  const double n = shifted - 0x1.8p52;
  const double whole = product.value - n;
  const double r = whole + lost;
  const std::uint64_t sign = bits_of(r) & sign_bit;
  const std::uint64_t parity = bits_of(shifted) << 63;
  const Part near{with_sign(r, sign), with_sign((whole - r) + lost, sign)};
  const double left = 0.5 - near.value;
  const double rounded = left - near.lost;
  const Part far{rounded, (left - rounded) - near.lost};
  if constexpr(from == From::bottom)
    return {near, far, n, asked == Asked::angle ? parity ^ sign : asked == Asked::velocity ? parity : 0};
  else if constexpr(from == From::rest)
    return {far, near, n,
            asked == Asked::angle      ? parity
            : asked == Asked::velocity ? parity ^ sign ^ sign_bit
                                       : 0};
  else
    return {near, far, n, asked == Asked::angle ? sign : 0};
}

// Out of reach the fraction of a half swing is no longer known.
template <From from, Asked asked>
SWING_INLINE double finished(const Prepared& p, double t, double n, std::uint64_t sign, double value)
{
  double result = with_sign(value, sign);
  if constexpr(from == From::going_round && asked == Asked::angle)
    result = n * (2 * pi_hi) + (n * (2 * pi_lo) + result);
  return magnitude(t * p.f_hi) <= p.reach ? result : nan;
}

// By a series, in one step.
template <class Form, From from, Asked asked>
void series_loop(const Prepared& prepared, const double* t, double* out, std::size_t n)
{
  const Prepared p = prepared;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Phase s = phase_of<from, asked>(p, t[i]);
    double value = 0;
    if constexpr(asked == Asked::angle)
      value = Form::angle(p, s.behind, s.ahead);
    else if constexpr(asked == Asked::velocity)
      value = Form::speed(p, s.behind, s.ahead);
    else
      value = Form::from_top(p, s.behind, s.ahead);
    out[i] = finished<from, asked>(p, t[i], s.n, s.sign, value);
  }
}

// By theta functions, in four steps.
template <class Form, Asked asked>
SWING_INLINE Theta theta_for(const Prepared& p, Part behind, Part ahead)
{
  return asked == Asked::angle ? Form::theta(p, behind, ahead) : theta_of(p, behind, ahead);
}

// Of Φ the tangent of its half; of the angle from the top the same turned over; of Φ' itself over 1.
template <class Form, Asked asked>
SWING_INLINE Quotient quotient_for(const Prepared& p, const Theta& t)
{
  if constexpr(asked == Asked::velocity)
    return {Form::speed(p, t), 1};
  const Quotient q = Form::tangent(p, t);
  return asked == Asked::angle ? q : Quotient{q.below, q.above};
}
template <Asked asked>
SWING_INLINE double value_for(Quotient q)
{
  return asked == Asked::velocity ? q.above : twice_arc_tangent(q.above, q.below);
}

// What a block has after each step.
struct Steps
{
  alignas(64) double behind[block];
  alignas(64) double behind_lost[block];
  alignas(64) double ahead[block];
  alignas(64) double ahead_lost[block];
  alignas(64) double n[block];
  alignas(64) std::uint64_t sign[block];
  alignas(64) double g[block];
  alignas(64) double h[block];
  alignas(64) double one_minus_G[block];
  alignas(64) double one_minus_H[block];
  alignas(64) double above[block];
  alignas(64) double below[block];
};

template <class Form, From from, Asked asked>
void theta_loop(const Prepared& prepared, const double* t, double* out, std::size_t n)
{
  const Prepared p = prepared;
  if(n == 1)
  {
    const Phase s = phase_of<from, asked>(p, t[0]);
    const Theta theta = theta_for<Form, asked>(p, s.behind, s.ahead);
    const double value = value_for<asked>(quotient_for<Form, asked>(p, theta));
    out[0] = finished<from, asked>(p, t[0], s.n, s.sign, value);
    return;
  }
  Steps x;
  for(std::size_t start = 0; start < n; start += block)
  {
    const std::size_t size = n - start < block ? n - start : block;
    for(std::size_t i = 0; i < size; ++i)
    {
      const Phase s = phase_of<from, asked>(p, t[start + i]);
      x.behind[i] = s.behind.value;
      x.behind_lost[i] = s.behind.lost;
      x.ahead[i] = s.ahead.value;
      x.ahead_lost[i] = s.ahead.lost;
      x.n[i] = s.n;
      x.sign[i] = s.sign;
    }
    for(std::size_t i = 0; i < size; ++i)
    {
      const Theta theta =
          theta_for<Form, asked>(p, {x.behind[i], x.behind_lost[i]}, {x.ahead[i], x.ahead_lost[i]});
      x.g[i] = theta.g;
      x.h[i] = theta.h;
      x.one_minus_G[i] = theta.one_minus_G;
      x.one_minus_H[i] = theta.one_minus_H;
    }
    for(std::size_t i = 0; i < size; ++i)
    {
      const Quotient q = quotient_for<Form, asked>(p, {x.g[i], x.h[i], x.one_minus_G[i], x.one_minus_H[i]});
      x.above[i] = q.above;
      x.below[i] = q.below;
    }
    for(std::size_t i = 0; i < size; ++i)
    {
      const double value = value_for<asked>({x.above[i], x.below[i]});
      out[start + i] = finished<from, asked>(p, t[start + i], x.n[i], x.sign[i], value);
    }
  }
}

template <class Form, From from>
constexpr Table::Questions by_series{series_loop<Form, from, Asked::angle>,
                                     series_loop<Form, from, Asked::velocity>,
                                     series_loop<Form, from, Asked::from_top>};
template <class Form, From from>
constexpr Table::Questions by_theta{theta_loop<Form, from, Asked::angle>,
                                    theta_loop<Form, from, Asked::velocity>,
                                    theta_loop<Form, from, Asked::from_top>};

}  // namespace

extern const Table SWING_VARIANT;
const Table SWING_VARIANT = {
    SWING_NAME(SWING_VARIANT),
    table_loop<By_modulus>,
    table_loop<As_given<rows::K_by_complement>>,
    table_loop<By_zeta>,
    table_loop<As_given<rows::Ratio_by_eta>>,
    {by_series<Low<few_terms>, From::bottom>, by_series<Low<few_terms>, From::rest>,
     by_series<Low<series_terms>, From::bottom>, by_series<Low<series_terms>, From::rest>,
     by_theta<High<3>, From::bottom>, by_theta<High<3>, From::rest>, by_theta<High<1>, From::bottom>,
     by_theta<High<1>, From::rest>, by_series<Fast, From::going_round>,
     by_theta<Barely, From::going_round>}};

}  // namespace swing::kernels
