// Compiled once for each instruction set, with SWING_VARIANT naming it; see kernels.hpp. Everything but the
// last function has internal linkage and nothing inline is taken from a library, so that no code made for one
// processor can be picked by the linker for another. Each function is free of branches: the compiler works on
// many numbers at once.
#include "swing/kernels.hpp"

#include <cstdint>
#include <limits>

#include "swing/time.hpp"
#include "swing_tables.hpp"

#define SWING_TEXT(x) #x
#define SWING_NAME(x) SWING_TEXT(x)
#define SWING_INLINE [[gnu::always_inline]] inline

namespace swing::kernels
{
namespace
{

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t sign_bit = 0x8000000000000000;

SWING_INLINE std::uint64_t bits_of(double x)
{
  return __builtin_bit_cast(std::uint64_t, x);
}
SWING_INLINE double from_bits(std::uint64_t b)
{
  return __builtin_bit_cast(double, b);
}
SWING_INLINE double magnitude(double x)
{
  return from_bits(bits_of(x) & ~sign_bit);
}
SWING_INLINE double with_sign(double x, std::uint64_t sign)
{
  return from_bits(bits_of(x) ^ sign);
}

// c[first] + c[first + step] x + …, unrolled.
template <unsigned first, unsigned step, unsigned n>
SWING_INLINE double horner(const double (&c)[n], double x)
{
  if constexpr (first + step < n)
    return c[first] + x * horner<first + step, step>(c, x);
  else
    return c[first];
}

// c[0] + c[1] x + …, the even and the odd powers apart: half the wait for one multiplication more.
template <unsigned n>
SWING_INLINE double polynomial(const double (&c)[n], double x)
{
  return horner<0, 2>(c, x * x) + x * horner<1, 2>(c, x * x);
}

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

// sin ½a for 0 ≤ a ≤ π.
SWING_INLINE double sine_of_half(double a)
{
  const double x = a * a;
  return a * (0.5 + x * polynomial(tables::sine_of_half, x));
}

// ln x = e ln 2 + rest, |rest| ≤ ½ ln 2; x a normal positive number.
struct Log
{
  double e;
  double rest;
};

SWING_INLINE Log log_of(double x)
{
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;
  constexpr std::uint64_t one = 0x3ff0000000000000;
  const std::uint64_t shifted = bits_of(x) + (one - root_half);
  const double e = from_bits((shifted >> 52) | 0x4330000000000000) - (0x1p52 + 1023);
  const double z = from_bits((shifted & 0x000fffffffffffff) + root_half);
  const double s = (z - 1) / (z + 1);
  const double x2 = s * s;
  return {e, s * (2 + x2 * polynomial(tables::log_of_quotient, x2))};
}

// What K, or K·2/π, is made of besides a sum of small terms: ln 4 and ln 2 in that unit, the leading parts
// with so few digits that ln 4 − e ln 2 is free of error.
struct Unit
{
  double one;
  double ln4_hi;
  double ln4_lo;
  double ln2_hi;
  double ln2_lo;
};

constexpr Unit plain{1, tables::ln4_hi, tables::ln4_lo, tables::ln2_hi, tables::ln2_lo};
constexpr Unit quarter_turns{tables::two_over_pi_hi, tables::ratio_ln4_hi, tables::ratio_ln4_lo,
                             tables::ratio_ln2_hi, tables::ratio_ln2_lo};

// With ln m = power·ln kc, the logarithm being the one of kc or of m as `power` is 2 or 1: m = kc² in either
// case.
SWING_INLINE double K_formula(const Unit& unit, double m, Log log, double power)
{
  const double to_kc = power / 2;
  const double e = to_kc * log.e;
  const double ln_m = power * (log.e * (tables::ln2_hi + tables::ln2_lo) + log.rest);
  const double correction = m * (polynomial(tables::K_plain, m) - ln_m * polynomial(tables::K_with_log, m));
  return (unit.ln4_hi - e * unit.ln2_hi) +
         ((unit.ln4_lo - e * unit.ln2_lo) + unit.one * (correction - to_kc * log.rest));
}

SWING_INLINE double K_of_modulus(double k)
{
  const double m = (1 - k) * (1 + k);
  const double K = K_formula(plain, m, log_of(m), 1);
  return m > 0 ? K : m == 0 ? inf : nan;
}

// Subnormal numbers are made normal before their logarithm is taken.
constexpr double tiny = 0x1p-1000;

SWING_INLINE double K_of_sine(const Unit& unit, double kc, double lift)
{
  Log log = log_of(kc);
  log.e -= lift;
  return K_formula(unit, lift > 0 ? 0 : kc * kc, log, 2);
}

SWING_INLINE double K_of_complement(double kc)
{
  const bool lifted = kc < tiny;
  const double K = K_of_sine(plain, lifted ? kc * 0x1p60 : kc, lifted ? 60 : 0);
  return kc > 0 && kc <= 1 ? K : kc == 0 ? inf : nan;
}

SWING_INLINE double ratio_of_eta(double eta)
{
  const bool lifted = eta < tiny;
  const double ratio = K_of_sine(quarter_turns, sine_of_half(lifted ? eta * 0x1p60 : eta), lifted ? 60 : 0);
  return eta > 0 && eta <= pi_hi ? ratio : eta == 0 ? inf : nan;
}

SWING_INLINE double ratio_of_zeta(double zeta)
{
  return zeta >= 0 && zeta <= pi_hi ? ratio_of_eta((pi_hi - zeta) + pi_lo) : nan;
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

// 2 arctan (y/x) for x, y ≥ 0, not both zero.
SWING_INLINE double twice_arc_tangent(double y, double x)
{
  constexpr double tangent_of_eighth = 0.41421356237309503;
  const bool steep = y > x;
  const double lesser = steep ? x : y;
  const double greater = steep ? y : x;
  const bool middle = lesser > tangent_of_eighth * greater;
  const double s = (middle ? lesser - greater : lesser) / (middle ? lesser + greater : greater);
  const double x2 = s * s;
  const double rest = 2 * (s + s * x2 * polynomial(tables::arc_tangent, x2));
  const double hi = middle ? pi_hi / 2 : steep ? pi_hi : 0;
  const double lo = middle ? pi_lo / 2 : steep ? pi_lo : 0;
  return hi + (lo + (steep ? -rest : rest));
}

// Where in its half swing the pendulum is: the time is n half swings and r of one, |r| ≤ ½.
struct Phase
{
  Part from_bottom;   // |r|
  Part to_rest;       // ½ − |r|
  std::uint64_t sign; // of r
  double n;
  std::uint64_t parity; // the sign that an odd n gives
};

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

// The product t·f is formed exactly; n is taken off before the rest is added.
SWING_INLINE Phase phase_of(const Prepared& p, double t)
{
  const Part product = product_of(t, p.f_hi, p.f_head, p.f_tail);
  const double lost = product.lost + t * p.f_lo;
  const double shifted = product.value + 0x1.8p52;
  const double n = shifted - 0x1.8p52;
  const double whole = product.value - n;
  const double r = whole + lost;
  const std::uint64_t sign = bits_of(r) & sign_bit;
  const Part from_bottom{with_sign(r, sign), with_sign((whole - r) + lost, sign)};
  const double left = 0.5 - from_bottom.value;
  const double to_rest = left - from_bottom.lost;
  return {from_bottom, {to_rest, (left - to_rest) - from_bottom.lost}, sign, n, bits_of(shifted) << 63};
}

// A positive quotient, its tangent or its value being what is asked.
struct Quotient
{
  double above;
  double below;
};

// Below 90°: tan ½Φ = C θ₁(z)/θ₃(z) with z = πr.
struct Low
{
  SWING_INLINE static Quotient tangent(const Prepared& p, Part r, Part)
  {
    const double s = sine_of_turns(r);
    const double x = s * s;
    const double main = p.angle_scale * s;
    return {main + main * (p.angle_scale_lost + x * horner<0, 1>(p.n, x)), 1 + x * horner<0, 1>(p.d, x)};
  }
  // Φ'(r) = 2kc tan ½Φ(½ − r). The quotient is 1 + y, and y is so small that what it is rounded by hardly
  // counts.
  SWING_INLINE static double speed(const Prepared& p, Part, Part to_rest)
  {
    const double s = sine_of_turns(to_rest);
    const double x = s * s;
    const double main = p.velocity_scale * s;
    const double y = x * horner<0, 1>(p.p, x) / (1 + x * horner<0, 1>(p.d, x));
    return main + main * (p.velocity_scale_lost + y);
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

SWING_INLINE Theta theta_of(const Prepared& p, Part r, Part to_rest)
{
  const bool upper = to_rest.value < r.value;
  const double nearer = upper ? to_rest.value : r.value;
  const double nearer_lost = upper ? to_rest.lost : r.lost;
  const Part v = product_of(nearer, p.log_q, p.log_q_head, p.log_q_tail);
  const bool far_down = v.value > 700;
  const Exponential e =
      exponential_of_minus({far_down ? 700 : v.value, far_down ? 0 : v.lost + nearer_lost * p.log_q});
  const double other = p.root_q / e.value;
  const double near = -e.minus_one * (2 + e.minus_one);
  const double far = (1 - other) * (1 + other);
  return {upper ? other : e.value, upper ? e.value : other, upper ? far : near, upper ? near : far};
}

// What remains of a theta function when its first factor, 1 ± G or 1 ± H, is taken out, is 1 and this:
// y (1 + x + x²) + q² y² (1 + x + … + x⁴) + q⁶ y³ (1 + x + … + x⁶).
SWING_INLINE double beyond_one(const Prepared& p, double x, double y)
{
  const double three = 1 + x * (1 + x);
  const double five = 1 + x * (1 + x * three);
  const double seven = 1 + x * (1 + x * five);
  const double q2 = p.q * p.q;
  return y * (three + (y * q2) * (five + (y * q2 * q2) * seven));
}

// The cofactors of θ₁ … θ₄, less 1; their first factors are 1 − G, 1 + G, 1 + H and 1 − H.
SWING_INLINE double cofactor_1(const Prepared& p, const Theta& t)
{
  return beyond_one(p, t.g * t.g, -p.q * (t.h * t.h));
}
SWING_INLINE double cofactor_2(const Prepared& p, const Theta& t)
{
  return beyond_one(p, -(t.g * t.g), p.q * (t.h * t.h));
}
SWING_INLINE double cofactor_3(const Prepared& p, const Theta& t)
{
  return beyond_one(p, -(t.h * t.h), p.q * (t.g * t.g));
}
SWING_INLINE double cofactor_4(const Prepared& p, const Theta& t)
{
  return beyond_one(p, t.h * t.h, -p.q * (t.g * t.g));
}

// main·(1 + a)/(1 + b) and what the factor in it was rounded by, where a and b are small.
SWING_INLINE double nearly(const Prepared& p, double main, double a, double b)
{
  return main + main * (p.velocity_scale_lost + (a - b) / (1 + b));
}

// Above 90°: the same quotient in the dual nome, where it is one of hyperbolic functions.
struct High
{
  SWING_INLINE static Quotient tangent(const Prepared& p, Part r, Part to_rest)
  {
    const Theta t = theta_of(p, r, to_rest);
    return {p.angle_scale * (t.one_minus_G * (1 + cofactor_1(p, t))),
            t.g * ((1 + t.h * t.h) * (1 + cofactor_3(p, t)))};
  }
  SWING_INLINE static double speed(const Prepared& p, Part r, Part to_rest)
  {
    const Theta t = theta_of(p, r, to_rest);
    const double main = p.velocity_scale * (t.g * t.one_minus_H / (1 + t.g * t.g));
    return nearly(p, main, cofactor_4(p, t), cofactor_2(p, t));
  }
};

// Revolving: Φ = 2 am, tan ½Φ = C θ₁(z)/θ₂(z), and Φ' goes as θ₃/θ₄.
struct Fast
{
  SWING_INLINE static Quotient tangent(const Prepared& p, Part r, Part to_top)
  {
    const double s = sine_of_turns(r);
    const double c = sine_of_turns(to_top);
    const double above = s * (1 + (s * s) * horner<0, 1>(p.n, s * s));
    return {p.angle_scale * above, c * (1 + (c * c) * horner<0, 1>(p.n, c * c))};
  }
  SWING_INLINE static double speed(const Prepared& p, Part r, Part to_top)
  {
    const double s = sine_of_turns(r);
    const double c = sine_of_turns(to_top);
    const double above = 1 + (s * s) * horner<0, 1>(p.d, s * s);
    return p.velocity_scale * (above / (1 + (c * c) * horner<0, 1>(p.d, c * c)));
  }
};

// The same in the dual nome.
struct Barely
{
  SWING_INLINE static Quotient tangent(const Prepared& p, Part r, Part to_top)
  {
    const Theta t = theta_of(p, r, to_top);
    return {p.angle_scale * (t.one_minus_G * (1 + cofactor_1(p, t))),
            t.g * (t.one_minus_H * (1 + cofactor_4(p, t)))};
  }
  SWING_INLINE static double speed(const Prepared& p, Part r, Part to_top)
  {
    const Theta t = theta_of(p, r, to_top);
    const double main = p.velocity_scale * (t.g * (1 + t.h * t.h) / (1 + t.g * t.g));
    return nearly(p, main, cofactor_3(p, t), cofactor_2(p, t));
  }
};

// Swinging, the clock started at the bottom or at rest: there Φ is even and what is left to the bottom takes
// r's place.
template <class Form, bool from_rest>
struct Swing
{
  SWING_INLINE static double angle(const Prepared& p, double t)
  {
    const Phase s = phase_of(p, t);
    const Quotient q =
        from_rest ? Form::tangent(p, s.to_rest, s.from_bottom) : Form::tangent(p, s.from_bottom, s.to_rest);
    return with_sign(twice_arc_tangent(q.above, q.below), from_rest ? s.parity : s.parity ^ s.sign);
  }
  SWING_INLINE static double velocity(const Prepared& p, double t)
  {
    const Phase s = phase_of(p, t);
    const double speed =
        from_rest ? Form::speed(p, s.to_rest, s.from_bottom) : Form::speed(p, s.from_bottom, s.to_rest);
    return with_sign(speed, from_rest ? s.parity ^ s.sign ^ sign_bit : s.parity);
  }
  SWING_INLINE static double from_top(const Prepared& p, double t)
  {
    const Phase s = phase_of(p, t);
    const Quotient q =
        from_rest ? Form::tangent(p, s.to_rest, s.from_bottom) : Form::tangent(p, s.from_bottom, s.to_rest);
    return twice_arc_tangent(q.below, q.above);
  }
};

// Going round: a half swing is now a whole turn.
template <class Form>
struct Turn
{
  SWING_INLINE static double angle(const Prepared& p, double t)
  {
    const Phase s = phase_of(p, t);
    const Quotient q = Form::tangent(p, s.from_bottom, s.to_rest);
    return s.n * (2 * pi_hi) + (s.n * (2 * pi_lo) + with_sign(twice_arc_tangent(q.above, q.below), s.sign));
  }
  SWING_INLINE static double velocity(const Prepared& p, double t)
  {
    const Phase s = phase_of(p, t);
    return Form::speed(p, s.from_bottom, s.to_rest);
  }
  SWING_INLINE static double from_top(const Prepared& p, double t)
  {
    const Phase s = phase_of(p, t);
    const Quotient q = Form::tangent(p, s.from_bottom, s.to_rest);
    return twice_arc_tangent(q.below, q.above);
  }
};

// Out of reach the fraction of a half swing is no longer known.
template <double (*f)(const Prepared&, double)>
void motion_loop(const Prepared& prepared, const double* t, double* out, std::size_t n)
{
  const Prepared p = prepared;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double value = f(p, t[i]);
    out[i] = magnitude(t[i] * p.f_hi) <= p.reach ? value : nan;
  }
}

template <double (*f)(double)>
void loop(const double* in, double* out, std::size_t n)
{
  for (std::size_t i = 0; i < n; ++i)
    out[i] = f(in[i]);
}

template <class Course>
constexpr Table::Questions questions{motion_loop<Course::angle>, motion_loop<Course::velocity>,
                                     motion_loop<Course::from_top>};

} // namespace

extern const Table SWING_VARIANT;
const Table SWING_VARIANT = {SWING_NAME(SWING_VARIANT),
                             loop<K_of_modulus>,
                             loop<K_of_complement>,
                             loop<ratio_of_zeta>,
                             loop<ratio_of_eta>,
                             {questions<Swing<Low, false>>, questions<Swing<Low, true>>,
                              questions<Swing<High, false>>, questions<Swing<High, true>>,
                              questions<Turn<Fast>>, questions<Turn<Barely>>}};

} // namespace swing::kernels
