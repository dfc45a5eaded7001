#include "tautochrone/member.hpp"

#include "elementary/circular.hpp"
#include "tautochrone/euler.hpp"
#include "tautochrone/kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

namespace tautochrone
{
namespace
{

using std::size_t;

constexpr size_t few = 16, order = 24, most = kernels::last_power;
/// Two numbers that go through the same sums, on every processor in the same order.
typedef double Two __attribute__((vector_size(16)));

void require_body(double k, double least)
{
  if(!(k >= least && k < 1))
    throw std::domain_error("a tautochrone that can be wound needs k/a below 1 and not below "
                            + std::to_string(least) + "; this is " + std::to_string(k));
}

// The length of a step need not be known to many digits, but everywhere as the same.

// The exponent of a positive normal number.
int exponent_of(double x)
{
  return static_cast<int>(elementary::bits_of(x) >> 52) - 1023;
}

// log₂ x to 1e-5 of itself, for positive normal x.
double binary_logarithm(double x)
{
  const int exponent = exponent_of(x * std::numbers::sqrt2);
  const double part = x * elementary::from_bits<double>(static_cast<std::uint64_t>(1023 - exponent) << 52),
               s = (part - 1) / (part + 1), ss = s * s;
  return exponent + 2 * std::numbers::log2e * s * (1 + ss * (1. / 3 + ss * (1. / 5)));
}

// 2 to the power x, to 1e-4 of itself.
double power_of_two(double x)
{
  const int whole = static_cast<int>(std::clamp(x, -1000.0, 1000.0));
  const double g = (x - whole) * std::numbers::ln2;
  return elementary::from_bits<double>(static_cast<std::uint64_t>(1023 + whole) << 52)
         * ((1 + g) + g * g * ((1. / 2 + g * (1. / 6)) + g * g * (1. / 24 + g * (1. / 120))));
}

// An angle that is looked for.
struct Aim
{
  double phi, chord, H, cosine, sine;  ///< the chord is 2 sin ½φ, H is 1 − cos φ
};

Aim aim_at(double phi)
{
  // Of the angle itself nothing is taken away below ½π, or at once: then the swift sine errs by an ulp of itself.
  const auto half = elementary::circular::swift_sincos(phi / 2);
  const double chord = phi < 1e-9 ? phi : 2 * half.sine,
               H = chord * chord / 2;  // half of 5e-324 is nothing
  return {phi, chord, H, H < 0.4 ? 1 - H : elementary::circular::swift_sincos(phi).cosine,
          chord * half.cosine};
}

// A place from which the flow begins: the sine and cosine of its angle, r, and s = 1 − r.
struct Start
{
  double sine, cosine, r, s;
};

// The place at an angle with this sine where dr = 0, that with the larger radius.
Start turning(double k, double sine, double cosine)
{
  const double half = (1 + k * k) * cosine / 2,
               r = half + std::sqrt(std::max((half - k) * (half + k), 0.0));
  return {sine, cosine, r, 1 - r};
}

// Where the curve ends, in closed form.
Start last_place(Member member, double k)
{
  if(member == Member::widest)
    return {(1 - k) * (1 + k) / (1 + k * k), 2 * k / (1 + k * k), k, 1 - k};
  const double below = std::sqrt(1 - k + k * k), root = std::sqrt(k), r = root * below;
  return {(1 - k) / below, root / below, r, (1 - k) * (1 + k * k) / (1 + r)};
}

/*
 The flow downwards, cc + YY + ZZ = 1 and ε dc + Z dY = 0 with ε = k/(1 + kk), by the number Y: it is not the time of
 the flow, but then one equation is left, and a series has but two sums of squares in each of its terms. About a place
 with the number Y₀ let

   Y = Y₀ (1 + t),  Z = Y₀ z,  z = k (1 + t) + u,  H = 1 − c = H₀ + Y₀Y₀ w/ε,  dw = z dt.

 u, which is nothing where r = 1, is kept instead of z, that 1 − r = u/z may lose nothing near the lowest point. The
 unit of Y is a power of two that keeps it near one.
*/
class Flow
{
public:
  Flow(double k, const Start& from)
      : k_(k), kk_(k * k), eps_(k / (1 + k * k)), slow_(1 / (1 + k * k)),
        unit_(from.sine > 0x1p-20 ? 1 : std::ldexp(1, std::max(std::ilogb(from.sine) + 1, -1000))),
        Y_(from.sine / unit_ * from.r / std::sqrt(kk_ + from.r * from.r)), u_(k * from.s / from.r),
        cosine_(from.cosine), lifted_(height())
  {
  }

  // The series of the next step, which may go down to t = −length(). It is as good as is wanted at a lower place, where
  // sin φ is `sine`; 0: good everywhere. If no other angle than `only` is looked for, and it is near, the series is short.
  void expand(double sine = 0, const Aim* only = nullptr)
  {
    const double z0 = k_ + u_, per_z = 1 / z0, Q = unit_ * Y_ / eps_, QQ = Q * Q;
    const double c = cosine_ / eps_, H0 = gain() * lifted_;
    const bool wide = cosine_ < 0.5;  // then it is the cosine that must keep its digits, else H
    const double u1 = wide ? c - per_z - k_ : u_ / k_ * per_z - H0 / eps_, z1 = k_ + u1;
    const double u2 =
        ((wide ? z1 * per_z - 1 : u1 * (c - 2 * k_ - u1) - H0 * (1 + kk_)) - QQ * z0 * z0) * (per_z / 2);
    terms_[0] = Two{0, u_};
    terms_[1] = Two{z0, u1};
    terms_[2] = Two{z1 / 2, u2};
    const Factors factors{c * per_z,  z1 * per_z,          QQ,
                          u2 * per_z, QQ * per_z * z1 / 2, Two{QQ * per_z, per_z}};
    terms<3, few>(factors, u2, u1, 0);
    per_Y_ = 1 / Y_;
    end_.reset();
    found_ = {0, 0, u_};
    // Not longer than the series is good for, than it is stable for, and than Y keeps two fifths of itself.
    const double r = k_ * per_z;
    rate_ = kk_ * slow_ / r;
    // Neighbouring curves approach each other downwards, in the time of the flow at a rate that grows: 4r/(1 + kk) − (1 +
    // 2rr/(kk + rr)) cos φ; less 2kk/((1 + kk) r), as 1 − r falls with φφ.
    const double rate = 4 * r * slow_ - (1 + 2 * r * r / (kk_ + r * r)) * cosine_,
                 relative = rate - 2 * rate_;
    length_ = std::min(0.6, 7 * rate_ / std::max(rate, 0.001));
    double bits = 55;
    if(sine > 0 && relative > 0)
    {
      const double down = std::min(unit_ * Y_ / sine, 0x1p500);
      // What a step errs by is made where it ends. And what the cosine errs by, where it is not made anew of Y and Z, does
      // not die: the integral of the last terms.
      const double dies =
          relative / rate_ * (0.5 * binary_logarithm(down * down / slow_) - std::numbers::log2e * length_);
      const double stays = wide ? -binary_logarithm(gain() * u_ * length_ / (order * eps_ * cosine_)) : 42;
      bits -= std::clamp(dies, 0.0, std::clamp(stays, 0.0, 42.0));
    }
    if(only != nullptr)
    {
      const double least = -goal(*only) * per_z;  // z falls on the way down
      order_ = few;
      if(8 * least < length_ && 2 * least < good_for(bits))
      {
        length_ = 2 * least;
        return;
      }
    }
    order_ = order;
    terms<few + 1, order>(factors, terms_[few][1], terms_[few - 1][1], terms_[few - 2][1]);
    const double stable = length_;
    length_ = std::min(stable, good_for(bits));
    // Some terms more cost less than one step more.
    if(length_ < stable && (only == nullptr || -goal(*only) * per_z > 0.9 * length_))
    {
      order_ = most;
      terms<order + 1, most>(factors, terms_[order][1], terms_[order - 1][1], terms_[order - 2][1]);
      length_ = std::min(stable, good_for(bits));
    }
  }

  double length() const { return length_; }
  double sine() const { return unit_ * Y_ * std::sqrt(1 + (k_ + u_) * (k_ + u_)); }

  // Down to the end of the step, unless this angle is above it.
  bool go_above(const Aim& aim)
  {
    if(end()[0] <= goal(aim))
      return false;
    go();
    return true;
  }

  // Down to the end of the step.
  void go() { go(-length_, end()); }

  // Where in the present step this angle is, which must lie in it.
  Position place_of(const Aim& aim) const
  {
    const double wanted = goal(aim);
    double lower = -length_, upper = 0, t = 0;
    for(int i = 0; i < 60; ++i)
    {
      const Two here = value(t);
      const double above = here[0] - wanted;
      (above > 0 ? upper : lower) = t;
      const double newton = t - above / z_of(t, here[1]);
      const double next = newton > lower && newton < upper ? newton : (lower + upper) / 2;
      if(std::abs(next - t) <= 1e-16 * length_)
        break;
      t = next;
    }
    return position(aim.phi, t, value(t)[1]);
  }

  // The place with this angle, if the present step has it and Chebyshev's method in the chord finds it, from the place
  // that was found before.
  std::optional<Position> landed(const Aim& aim)
  {
    const double wanted = goal(aim), chord = chord_of(aim), small = 1e-5 * rate_;
    const double per_k = 1 / k_, per_eps = 1 / eps_, lift = gain() * per_eps * per_eps;
    auto [t, w, u] = found_;
    for(int step = 0; step < 5; ++step)
    {
      const double z = z_of(t, u), per_z = 1 / z, raised = 2 * (eps_ * lifted_ + w);  // ε chord²
      const double du = u * per_k * per_z - lift * raised / 2, dz = k_ + du, newton = (wanted - w) * per_z;
      if(std::abs(newton) < small)
      {
        found_ = {t, w, u};
        const double ddu = (du - u * per_z * dz) * per_k * per_z - lift * z;
        const double change = newton * (1 - dz * per_z * newton / 2);
        return position(aim.phi, t + change, u + change * (du + ddu * change / 2));
      }
      if(t == 0 && std::abs(newton) < 0.1)
        t = reverted(newton, per_z);
      else
      {
        const double at = std::sqrt(raised * per_eps), by = (chord - at) * at * (eps_ * per_z);
        t += by * (1 - (dz * per_z - z / raised) * by / 2);
      }
      if(!(t >= -length_ && t <= 0))
        break;
      const Two here = value(t);
      w = here[0];
      u = here[1];
    }
    return std::nullopt;
  }

  // The place with this angle, which must lie in the present step.
  Position place(const Aim& aim)
  {
    const std::optional<Position> here = landed(aim);
    return here ? *here : place_of(aim);
  }

  // The present step for the loops that look for many places in it.
  kernels::Step step()
  {
    kernels::Step it{};
    std::memcpy(it.terms, terms_, (order_ + 1) * sizeof *it.terms);
    it.k = k_;
    it.kk = kk_;
    it.eps = eps_;
    it.unit = unit_;
    it.Y = Y_;
    it.cosine = cosine_;
    it.lifted = lifted_;
    it.length = length_;
    it.small = 1e-5 * rate_;
    // The polynomial of the seventh degree whose value and first three slopes are right at both ends.
    const double q0 = std::sqrt(2 * lifted_), q1 = std::sqrt(2 * (lifted_ + end()[0] / eps_)), D = q1 - q0,
                 DD = D * D, per_D = 1 / D, per_DD = per_D * per_D;
    const Slopes upper = slopes(q0, 0, terms_[0]), lower = slopes(q1, -length_, end());
    const double a = upper.first, b = upper.second / 2, c = upper.third / 6;
    const double left = -length_ - D * (a + D * (b + D * c)),
                 first = D * (lower.first - a - D * (2 * b + 3 * D * c)),
                 second = DD * (lower.second - 2 * b - 6 * D * c) / 2,
                 third = D * DD * (lower.third / 6 - c);
    const double powers[] = {a,
                             b,
                             c,
                             (35 * left - 15 * first + 5 * second - third) * per_DD * per_DD,
                             (-84 * left + 39 * first - 14 * second + 3 * third) * per_DD * per_DD * per_D,
                             (70 * left - 34 * first + 13 * second - 3 * third) * per_DD * per_DD * per_DD,
                             (-20 * left + 10 * first - 4 * second + third) * per_DD * per_DD * per_DD
                                 * per_D};
    std::copy(std::begin(powers), std::end(powers), it.guess);
    return it;
  }

  // The chords where the step begins and where it ends.
  double upper_chord() const { return unit_ * (Y_ * std::sqrt(2 * lifted_)); }
  double lower_chord() { return unit_ * (Y_ * std::sqrt(2 * (lifted_ + end()[0] / eps_))); }

private:
  // What does not change from term to term.
  struct Factors
  {
    double a, b, by_second, by_second_too, by_third;
    Two weights;
  };

  // Σ of weighed_[j] terms_[n − j] over j from i down to 3.
  template <size_t n, size_t i>
  [[gnu::always_inline]] Two products(Two sum) const
  {
    if constexpr(i < 3)
      return sum;
    else
      return products<n, i - 1>(sum + weighed_[i] * terms_[n - i]);
  }

  // The terms from the nth to the last. What is known last is multiplied last, and by itself; the sums over the others go from
  // the middle outwards.
  template <size_t n, size_t last>
  [[gnu::always_inline]] void terms(const Factors& f, double before, double second, double third)
  {
    if constexpr(n <= last)
    {
      constexpr double part = 1. / n, part_before = 1. / (n - 1), part_second = 1. / (n - 2);
      double rest = 0;
      if constexpr(n == 3)
        rest = f.by_second * terms_[2][0];
      else if constexpr(n == 4)
        rest = second * (f.by_second * part_before)
               + 0.5 * (f.by_third * terms_[2][0] + f.by_second_too * second);
      else
      {
        rest = third * (f.by_third * part_second);
        if constexpr(n >= 6)
        {
          const Two sum = n % 2 == 0 ? products<n, n / 2 - 1>(0.5 * (weighed_[n / 2] * terms_[n / 2]))
                                     : products<n, n / 2>(Two{});
          rest += sum[0] + sum[1];
        }
        rest += second * (f.by_second * part_before + f.by_second_too);
      }
      const double next = before * (f.a * part - f.b) - rest;
      terms_[n] = Two{before * part, next};
      if constexpr(n <= most / 2)
        weighed_[n] = terms_[n] * f.weights;
      terms<n + 1, last>(f, next, before, second);
    }
  }

  // How far the series errs by so many bits at most.
  double good_for(double bits) const
  {
    const double last = std::max(std::abs(terms_[order_][1]), std::abs(terms_[order_ - 1][1])),
                 first = std::max(std::abs(terms_[0][1]), length_ * std::abs(terms_[1][1]));
    return last > 0x1p-900 * first ? power_of_two((exponent_of(first) - exponent_of(last) - 1 - bits)
                                                  / static_cast<double>(order_))
                                   : 1;
  }

  // t by w/z₀, to the fifth power.
  double reverted(double x, double per_z) const
  {
    const double a = terms_[2][0] * per_z, b = terms_[3][0] * per_z, c = terms_[4][0] * per_z,
                 d = terms_[5][0] * per_z, aa = a * a;
    return x
           * (1
              - x
                    * (a
                       + x
                             * ((b - 2 * aa)
                                + x
                                      * ((c + 5 * a * (aa - b))
                                         + x * (d - 6 * a * c - 3 * b * b + 7 * aa * (3 * b - 2 * aa))))));
  }

  // w and u at t: four sums, which can be made at the same time.
  template <size_t last>
  Two sum(double t) const
  {
    static_assert(last % 4 == 0);
    const double tt = t * t, fourth = tt * tt;
    Two a = terms_[last], b{}, c{}, d{};
    for(size_t n = last; n > 0;)
    {
      n -= 4;
      a = a * fourth + terms_[n];
      b = b * fourth + terms_[n + 1];
      c = c * fourth + terms_[n + 2];
      d = d * fourth + terms_[n + 3];
    }
    return (a + tt * c) + t * (b + tt * d);
  }
  Two value(double t) const
  {
    return order_ == few ? sum<few>(t) : order_ == order ? sum<order>(t) : sum<most>(t);
  }

  double chord_of(const Aim& aim) const { return aim.chord * (1 / unit_) * per_Y_; }
  double gain() const { return (unit_ * Y_) * (unit_ * Y_); }
  double z_of(double t, double u) const { return k_ * (1 + t) + u; }
  // w and u at the end of the step.
  const Two& end()
  {
    if(!end_)
      end_ = value(-length_);
    return *end_;
  }

  // The slopes of t at such a w and u by q, which is the root of 2 (lifted + w/ε): z dt = ε q dq.
  struct Slopes
  {
    double first, second, third;
  };
  Slopes slopes(double q, double t, const Two& there) const
  {
    const double per_z = 1 / z_of(t, there[1]), per_k = 1 / k_, u = there[1];
    const double lift = gain() / (eps_ * eps_), du = u * per_k * per_z - lift * (eps_ * lifted_ + there[0]),
                 dz = k_ + du, ddz = (du - u * per_z * dz) * per_k * per_z - lift * z_of(t, u);
    const double first = eps_ * q * per_z, second = (eps_ - first * first * dz) * per_z;
    return {first, second, -first * (3 * second * dz + first * first * ddz) * per_z};
  }

  // H/YY at the beginning of the step.
  double height() const { return (1 + (k_ + u_) * (k_ + u_)) / (1 + cosine_); }

  // The w of an angle, from what can be subtracted.
  double goal(const Aim& aim) const
  {
    if(cosine_ < 0.5)
      return eps_ * (cosine_ - aim.cosine) / gain();
    const double chord = chord_of(aim);
    return eps_ * (chord * chord / 2 - lifted_);
  }

  void go(double t, const Two& there)
  {
    const double lower = cosine_ - gain() / eps_ * there[0];
    Y_ *= 1 + t;
    u_ = there[1] / (1 + t);
    const double z = k_ + u_, sine2 = gain() * (1 + z * z);
    cosine_ = lower < 0.5 ? lower : std::sqrt(1 - sine2);
    lifted_ = height();
    if(Y_ < 0x1p-20 && unit_ > 0x1p-1000)
    {
      Y_ *= 0x1p20;
      unit_ *= 0x1p-20;
    }
  }

  Position position(double phi, double t, double u) const
  {
    const double z = z_of(t, u), Y = unit_ * (Y_ * (1 + t));
    return {phi, k_ * (1 + t) / z, (1 + kk_) / 2 * Y * Y,
            std::max(u / z, 0.0)};  // it is not negative, but for roundings of what is nearly nothing
  }

  struct Found
  {
    double t, w, u;
  };

  double k_, kk_, eps_, slow_, unit_, Y_, u_, cosine_, lifted_;
  double rate_ = 0;  // Y falls so in the time of the flow
  double length_ = 0, per_Y_ = 1;
  size_t order_ = order;
  std::optional<Two> end_;
  Found found_{};
  Two terms_[most + 1], weighed_[most / 2 + 1];
};

// From a place down to the angle.
Position followed(double k, const Start& from, const Aim& aim)
{
  Flow flow(k, from);
  for(;;)
  {
    flow.expand(aim.sine, &aim);
    if(const auto here = flow.landed(aim))
      return *here;
    if(!flow.go_above(aim))
      return flow.place_of(aim);
  }
}

// A place so far above the angle that all tautochrones that are there agree below to e^-46, in r and in 1 − r; none
// where there is no such place below the angle whose cosine has the square `least`. By A(φ) − A(φ₁) = 46 kk/(1 − 3kk), with A = −½ −
// ln sin φ + ½ sin²φ, see falling(): near the lowest point their difference is as φ^(1/kk − 1), while 1 − r is as φφ;
// for kk > ⅓ it is as their difference.
std::optional<Start> far_above(double k, const Aim& aim, double least)
{
  const double kk = k * k;
  if(kk > 0.33)
    return std::nullopt;
  const double wanted = 46 * kk / (1 - 3 * kk), sine2 = 2 * aim.H * (1 - aim.H / 2),
               cosine2 = aim.cosine * aim.cosine;
  if((cosine2 - least) * cosine2 < 2 * wanted * sine2)
    return std::nullopt;
  // m = ln(sin φ₁ : sin φ) by Newton's method, which comes from below: m less half of what sin² grows by is `wanted`.
  double m = wanted;
  for(int i = 0; i < 60; ++i)
  {
    const bool little = m < 0.05;
    const double sine = aim.sine * (little ? 1 + m * (1 + m / 2) : power_of_two(m * std::numbers::log2e)),
                 more = little ? sine2 * 2 * m * (1 + m * (1 + m * (2. / 3 + m / 3))) : sine * sine - sine2,
                 rest = cosine2 - more, change = (wanted + more / 2 - m) / rest;
    if(!(rest > least))
      return std::nullopt;
    if(change < 0.01 * wanted)
      return rest < 0.5 ? turning(k, std::sqrt(1 - rest), std::sqrt(rest))
                        : turning(k, sine, std::sqrt((1 - sine) * (1 + sine)));
    m += change;
  }
  return std::nullopt;
}

// Where the steps down to the angle begin.
Start begin_for(Member member, double k, const Start& last, const Aim& aim)
{
  // The widest curve parts from the others high up, where it is not at the larger turning radius.
  constexpr double cosine2 = 0.8824210936422444;  // of 0.35
  const double least = member == Member::highest ? last.cosine * last.cosine : k <= 0.1 ? cosine2 : 1;
  return far_above(k, aim, least).value_or(last);
}

// The end, if this angle is not below it but is its angle. @throws as at()
std::optional<Position> known_end(Member member, double k, const Start& last, const Aim& aim)
{
  const double phi = aim.phi;
  if(!(phi >= 0 && phi < 2 && aim.H * (1 + last.cosine) < last.sine * last.sine * (1 - 1e-14)))
  {
    const Position there = end(member, k);
    if(!(phi >= 0 && phi <= there.phi))
      throw std::domain_error("this tautochrone ends at " + std::to_string(there.phi) + " rad");
    if(phi == there.phi)
      return there;
  }
  return std::nullopt;
}

// What need not be followed of what is below the end; none where it must.
std::optional<Position> known(Member member, double k, const Aim& aim)
{
  const double phi = aim.phi;
  if(phi == 0)
    return Position{};
  // Where kk is so small against cos⁴φ, what Euler's two corrections leave out is below 1e-16, and the curves differ
  // by less than e^−250000.
  const double cosine2 = aim.cosine * aim.cosine;
  if(member == Member::highest && k * k <= 1e-6 * cosine2 * cosine2)
    return Position{phi, euler_r(1.0, k, phi), euler_x(1.0, k, phi), euler_s(1.0, k, phi)};
  return std::nullopt;
}

}  // namespace

Position end(Member member, double k)
{
  require_body(k, 0x1p-1022);
  if(member == Member::widest)
  {
    const double cosine = 2 * k / (1 + k * k), sine = (1 - k) * (1 + k) / (1 + k * k);
    return {elementary::atan2(sine, cosine), k, (1 + k * k) / 4 * sine * sine, 1 - k};
  }
  const double r = std::sqrt(k * (1 - k + k * k));
  return {elementary::atan((1 - k) / std::sqrt(k)), r, (1 - k) * (1 - k) / 2,
          (1 - k) * (1 + k * k) / (1 + r)};
}

Position at(Member member, double k, double phi)
{
  require_body(k, 1e-9);
  const Aim aim = aim_at(phi);
  const Start last = last_place(member, k);
  if(const auto here = known_end(member, k, last, aim))
    return *here;
  if(const auto here = known(member, k, aim))
    return *here;
  return followed(k, begin_for(member, k, last, aim), aim);
}

std::vector<Position> along(Member member, double k, const std::vector<double>& angles)
{
  const kernels::Variants& variants = kernels::variants();
  return along(member, k, angles, variants.find[variants.count - 1]);
}

std::vector<Position> along(Member member, double k, const std::vector<double>& angles, kernels::Find find)
{
  require_body(k, 1e-9);
  if(std::adjacent_find(angles.begin(), angles.end(),
                        [](double lower, double upper) { return !(lower < upper); })
     != angles.end())
    throw std::domain_error("the angles must grow");
  std::vector<Position> result(angles.size());
  const Start last = last_place(member, k);
  size_t i = angles.size();
  if(i > 0)
    if(const auto here = known_end(member, k, last, aim_at(angles.back())))
      result[--i] = *here;
  if(i > 0 && !(angles.front() >= 0))
    throw std::domain_error("the angles must not be negative");
  std::optional<Flow> flow;
  while(i > 0)
  {
    const Aim aim = aim_at(angles[i - 1]);
    if(const auto here = known(member, k, aim))
    {
      result[--i] = *here;
      continue;
    }
    const Start from = begin_for(member, k, last, aim);
    if(!flow || from.sine < 0.99 * flow->sine())
      flow.emplace(k, from);
    else
      flow->go();
    flow->expand(aim.sine);
    const double lowest = flow->lower_chord();
    if(aim.chord < lowest)
      continue;
    const kernels::Step step = flow->step();
    for(bool more = true; more;)
    {
      // As many as go through the loops at once; where fewer are left, the last of them repeated.
      double some[kernels::lanes];
      kernels::Places places;
      const size_t n = std::min(i, size_t{kernels::lanes});
      for(size_t j = 0; j < kernels::lanes; ++j)
        some[j] = angles[i - std::min(j + 1, n)];
      find(step, some, places);
      size_t j = 0;
      for(; j < n && places.found[j] != 0; ++j)
        result[--i] = {some[j], places.r[j], places.x[j], places.s[j]};
      more = i > 0;
      if(j < n)
      {
        const Aim next = aim_at(some[j]);
        more = next.chord >= lowest;
        if(more)
          result[--i] = flow->place(next);
      }
    }
  }
  return result;
}

Position at_through(double k, double phi1, double r1, double phi)
{
  require_body(k, 1e-9);
  const double slack = 1e-15 * r1;
  const auto [sine, cosine] = elementary::sincos(phi1);
  const bool inside = phi1 > 0 && phi1 < std::numbers::pi / 2 && r1 > 0
                      && (1 + k * k) * r1 * cosine - k * k - r1 * r1 >= -slack;
  if(!inside)
    throw std::domain_error("no cheek leads through this point: dr would be positive there");
  if(!(phi >= 0 && phi <= phi1))
    throw std::domain_error("the curve is followed downwards only, from " + std::to_string(phi1) + " rad");
  if(phi == 0)
    return {};
  return followed(k, {sine, cosine, r1, 1 - r1}, aim_at(phi));
}

std::vector<Drawn> drawn(Member member, double k, const std::vector<double>& angles)
{
  require_body(k, 0.005);
  const Position last = end(member, k);
  const double lowest = 1e-14 * last.phi;
  for(size_t i = 0; i < angles.size(); ++i)
    if(!(angles[i] >= (i == 0 ? 0 : angles[i - 1]) && angles[i] <= last.phi)
       || (angles[i] > 0 && angles[i] < lowest))
      throw std::domain_error("the angles must grow from 0 to the end, " + std::to_string(last.phi)
                              + " rad");
  // Gauss's eight nodes and weights on (-1, 1), the positive half.
  constexpr std::array<double, 4> node = {0.96028985649753623, 0.79666647741362674, 0.52553240991632899,
                                          0.18343464249564980};
  constexpr std::array<double, 4> weight = {0.10122853629037626, 0.22238103445337447, 0.31370664587788729,
                                            0.36268378337836198};
  struct Sums
  {
    double z = 0, y = 0, x = 0;
  };
  Flow flow(k, last_place(member, k));
  const auto piece = [&](double from, double to, Sums& into) {  // by the chord, downwards
    const double middle = (from + to) / 2, half = (from - to) / 2;
    for(size_t i = 0; i < 8; ++i)
    {
      const double chord = middle + half * (i < 4 ? node[i] : -node[7 - i]), H = chord * chord / 2;
      const double half_cosine = std::sqrt(1 - H / 2),
                   r = flow.place({0, chord, H, 1 - H, chord * half_cosine}).r;
      const double w = half * (i < 4 ? weight[i] : weight[7 - i]), dz = w * r / half_cosine;
      into.z += dz;
      into.y += dz * (1 - H);
      into.x += w * r * chord;
    }
  };
  std::vector<Drawn> result(angles.size());
  std::vector<Sums> above(angles.size());  // from the next angle (or the end) down to each
  Sums sums;
  size_t left = angles.size();
  for(bool done = false; !done;)
  {
    flow.expand();
    double from = flow.upper_chord();
    const double lower = flow.lower_chord();
    const auto advance = [&](double to) {  // in two pieces
      piece(from, (from + to) / 2, sums);
      piece((from + to) / 2, to, sums);
      from = to;
    };
    while(left > 0 && angles[left - 1] > 0 && aim_at(angles[left - 1]).chord >= lower)
    {
      --left;
      const Aim aim = aim_at(angles[left]);
      advance(aim.chord);
      result[left].at = flow.place(aim);
      above[left] = sums;
      sums = {};
    }
    done = lowest >= lower;
    advance(done ? lowest : lower);
    if(done)
    {
      const Position floor = flow.place(aim_at(lowest));
      sums.z += floor.r * lowest;
      sums.y += floor.r * lowest;
      sums.x += floor.x;
    }
    else
      flow.go();
  }
  for(size_t i = left; i < angles.size(); ++i)
  {
    Drawn& d = result[i];
    d.z = sums.z;
    d.y = sums.y;
    d.by_arc = sums.x;
    sums.z += above[i].z;
    sums.y += above[i].y;
    sums.x += above[i].x;
    const double half = elementary::sin(d.at.phi / 2);
    d.p = d.at.s * elementary::cos(d.at.phi) + 2 * half * half - d.at.x;  // 1 − x − r cos φ
    d.q = d.y - d.at.r * elementary::sin(d.at.phi);
  }
  return result;
}

}  // namespace tautochrone
