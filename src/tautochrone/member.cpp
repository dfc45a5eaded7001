#include "tautochrone/member.hpp"

#include "tautochrone/euler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

constexpr size_t order = 24;
using Taylor = std::array<double, order + 1>;

// Even and odd powers apart, which can be summed at the same time.
double value(const Taylor& c, double tau)
{
  static_assert(order % 2 == 0);
  const double square = tau * tau;
  double even = c[order], odd = c[order - 1];
  for(size_t n = order - 2; n >= 2; n -= 2)
  {
    even = even * square + c[n];
    odd = odd * square + c[n - 1];
  }
  return even * square + c[0] + odd * tau;
}

void require_body(double k, double least)
{
  if(!(k >= least && k < 1))
    throw std::domain_error("a tautochrone that can be wound needs k/a below 1 and not below "
                            + std::to_string(least) + "; this is " + std::to_string(k));
}

// 2 sin ½φ, of subnormal angles too
double chord_of(double phi)
{
  return phi < 1e-9 ? phi : 2 * std::sin(phi / 2);
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
 The flow downwards. Carried are H/qq, Y/q and E/q, where E = Z − kY = Z (1 − r) and q is a power of two
 that keeps them near one, however near the lowest point is:

   dH = ZZ,  dY = εZ,  dE = E/(1 + kk) − HZ,  ε = k/(1 + kk).
*/
class Flow
{
public:
  Flow(double k, const Start& from)
      : k_(k), kk_(k * k), eps_(k / (1 + k * k)), slow_(1 / (1 + k * k)),
        q_(from.sine > 0x1p-20 ? 1 : std::exp2(std::ilogb(from.sine) + 1))
  {
    const double length = std::sqrt(kk_ + from.r * from.r), sine = from.sine / q_;
    H_[0] = sine * sine / (1 + from.cosine);
    Y_[0] = sine * from.r / length;
    Z_[0] = sine * k / length;
    E_[0] = Z_[0] * from.s;
  }

  // The series of the next step, which may go down to τ = −length(). It is as good as is wanted at a lower place, where
  // sin φ is `sine`; 0: good everywhere.
  void expand(double sine = 0)
  {
    constexpr auto reciprocals = [] {
      Taylor of{};
      for(size_t n = 1; n <= order; ++n)
        of[n] = 1 / static_cast<double>(n);
      return of;
    }();
    found_ = {0, H_[0], Y_[0], E_[0]};
    // [flow]
    const double gain = q_ * q_, cosine = 1 - gain * H_[0];
    for(size_t n = 0; n < order; ++n)
    {
      // From the middle outwards: what is known last is added last, and nothing waits for it.
      double ZZ = 0, HZ = 0;  // the latter without H₀Zₙ
      for(size_t i = (n + 1) / 2; i-- > 1;)
      {
        const size_t j = n - i;
        ZZ += Z_[i] * Z_[j];
        HZ += H_[i] * Z_[j] + H_[j] * Z_[i];
      }
      if(n > 0)
      {
        ZZ += Z_[0] * Z_[n];
        HZ += H_[n] * Z_[0];
      }
      ZZ *= 2;
      if(n % 2 == 0)
      {
        ZZ += Z_[n / 2] * Z_[n / 2];
        if(n > 0)
          HZ += H_[n / 2] * Z_[n / 2];
      }
      const double next = reciprocals[n + 1];
      H_[n + 1] = ZZ * next;
      Y_[n + 1] = eps_ * Z_[n] * next;
      E_[n + 1] = (E_[n] * slow_ - gain * (HZ + H_[0] * Z_[n])) * next;
      Z_[n + 1] = (Z_[n] * cosine - (eps_ * Y_[n] + gain * HZ)) * next;
    }
    // [flow]
    // Not longer than the series is good for, than it is stable for, and than Y keeps a half of itself.
    length_ = std::min(7.0, 0.7 * (1 + kk_) / kk_);
    // Neighbouring curves approach each other downwards, in τ at a rate that grows: 4r/(1 + kk) − (1 + 2rr/(kk + rr))
    // cos φ; less 2kk/((1 + kk) r), as 1 − r falls with φφ. And Y falls at the rate kk/((1 + kk) r), which is less
    // further down.
    double bits = 56;
    if(sine > 0)
    {
      const double r = k_ * Y_[0] / Z_[0], YY = Y_[0] * Y_[0], ratio = q_ / sine;
      const double rate = (4 * r - 2 * kk_ / r) * slow_ - (1 + 2 * YY / (YY + Z_[0] * Z_[0])) * cosine;
      if(rate > 0)
        bits -=
            std::clamp(0.72 * rate * r / (kk_ * slow_) * std::log(YY * ratio * ratio / slow_), 0.0, 43.0);
    }
    double last = 0;
    for(const size_t n : {order - 1, order})
      last = std::max({last, std::abs(Z_[n] / Z_[0]), std::abs(H_[n] / H_[0])});
    if(last > 0)
      length_ = std::min(length_, std::exp2((-bits - std::logb(last)) / static_cast<double>(order)));
  }

  double length() const { return length_; }
  double sine() const { return q_ * std::hypot(Y_[0], Z_[0]); }
  double height(double tau) const { return value(H_, tau); }  // H/qq
  double unit() const { return q_; }
  double Y(double tau) const { return value(Y_, tau); }
  double E(double tau) const { return value(E_, tau); }

  // Down to τ, with H from the other two again, and in a new unit where it has become small.
  void go(double tau)
  {
    const double Y = value(Y_, tau), E = value(E_, tau), Z = E + k_ * Y, sine2 = Y * Y + Z * Z;
    const double rest = 1 - q_ * q_ * sine2;
    H_[0] = rest > 0.25 ? sine2 / (1 + std::sqrt(rest)) : value(H_, tau);
    const double onto = rest > 0.25 ? 1 : std::sqrt(H_[0] * (2 - H_[0]) / sine2);
    Y_[0] = Y * onto;
    E_[0] = E * onto;
    Z_[0] = Z * onto;
    if(H_[0] < 0x1p-40)
    {
      H_[0] *= 0x1p40;
      Y_[0] *= 0x1p20;
      E_[0] *= 0x1p20;
      Z_[0] *= 0x1p20;
      q_ *= 0x1p-20;
    }
  }

  // Where in the present step 2 sin ½φ is `chord`, which must lie in it.
  double time_of(double chord) const
  {
    const double target = (chord / q_) * (chord / q_) / 2;
    double lower = -length_, upper = 0, tau = 0;
    for(int i = 0; i < 60; ++i)
    {
      const double above = value(H_, tau) - target, Z = value(E_, tau) + k_ * value(Y_, tau);
      (above > 0 ? upper : lower) = tau;
      const double newton = tau - above / (Z * Z);
      const double next = newton > lower && newton < upper ? newton : (lower + upper) / 2;
      if(std::abs(next - tau) <= 1e-16 * length_)
        break;
      tau = next;
    }
    return tau;
  }

  bool reaches(double chord) const { return value(H_, -length_) <= (chord / q_) * (chord / q_) / 2; }

  Position position(double phi, double tau) const
  {
    return position_of(phi, value(Y_, tau), value(E_, tau));
  }

  // The place with the angle φ, if the present step has it and Chebyshev's method in ln H finds it, from the place that
  // was found before.
  std::optional<Position> landed(double phi, double chord)
  {
    const double target = (chord / q_) * (chord / q_) / 2;
    auto [tau, H, Y, E] = found_;
    for(int step = 0; step < 4; ++step)
    {
      const double Z = E + k_ * Y, dE = E * slow_ - q_ * q_ * H * Z, dZ = dE + k_ * eps_ * Z;
      const double rest = (target - H) / (Z * Z), change = rest * (1 - dZ / Z * rest);
      if(std::abs(change) < 1e-5)
      {
        found_ = {tau, H, Y, E};
        return position_of(phi, Y + eps_ * change * (Z + dZ * change / 2),
                           E + change * (dE + (dE * slow_ - q_ * q_ * (Z * Z * Z + H * dZ)) * change / 2));
      }
      const double slope = Z * Z / H, bend = 2 * dZ / Z - slope, newton = std::log(target / H) / slope;
      tau += newton * (1 - bend * newton / 2);
      if(!(tau >= -length_ && tau <= 0))
        break;
      H = value(H_, tau);
      Y = value(Y_, tau);
      E = value(E_, tau);
    }
    return std::nullopt;
  }

private:
  Position position_of(double phi, double Y, double E) const
  {
    const double Z = E + k_ * Y;
    return {phi, k_ * Y / Z, (1 + kk_) / 2 * (q_ * Y) * (q_ * Y),
            std::max(E / Z, 0.0)};  // it is not negative, but for roundings of what is nearly nothing
  }

  struct Found
  {
    double tau, H, Y, E;
  };

  double k_, kk_, eps_, slow_, q_;
  double length_ = 0;
  Found found_{};
  Taylor H_{}, Y_{}, E_{}, Z_{};
};

// From a place down to the angle φ, 2 sin ½φ being `chord`.
Position followed(double k, const Start& from, double phi, double chord)
{
  const double sine = chord * std::sqrt(1 - chord * chord / 4);
  Flow flow(k, from);
  for(;;)
  {
    flow.expand(sine);
    if(const auto here = flow.landed(phi, chord))
      return *here;
    if(flow.reaches(chord))
      return flow.position(phi, flow.time_of(chord));
    flow.go(-flow.length());
  }
}

// A place so far above the angle with this sine that all tautochrones that are there agree below to e^-46, in r and
// in 1 − r; none where there is no such place below the angle with the sine `most`. By A(φ) − A(φ₁) = 46 kk/(1 − 3kk),
// with A = −½ − ln sin φ + ½ sin²φ, see falling(): near the lowest point their difference is as φ^(1/kk − 1), while
// 1 − r is as φφ; for kk > ⅓ it is as their difference.
std::optional<Start> far_above(double k, double sine, double most)
{
  const double kk = k * k;
  if(kk > 0.33)
    return std::nullopt;
  const double wanted = std::log(sine) - sine * sine / 2 + 46 * kk / (1 - 3 * kk);
  if(wanted >= std::log(most) - most * most / 2)
    return std::nullopt;
  double log_sine = wanted, above = 0;
  for(int i = 0; i < 60; ++i)
  {
    above = std::exp(log_sine);
    const double cosine2 = (1 - above) * (1 + above),
                 change = (log_sine - above * above / 2 - wanted) / cosine2;
    log_sine -= change;
    if(std::abs(change) < 1e-6 * cosine2)
      break;
  }
  above = std::exp(log_sine);
  return turning(k, above, std::sqrt((1 - above) * (1 + above)));
}

// Where the steps down to φ begin.
Start begin_for(Member member, double k, double phi)
{
  // The widest curve parts from the others high up, where it is not at the larger turning radius.
  const Start last = last_place(member, k);
  const double most = member == Member::highest ? last.sine : k <= 0.1 ? std::sin(0.35) : 0;
  return far_above(k, std::sin(phi), most).value_or(last);
}

// What need not be followed; none where it must. @throws as at()
std::optional<Position> known(Member member, double k, double phi, double chord)
{
  require_body(k, 1e-9);
  const Start last = last_place(member, k);
  const double H = chord * chord / 2;
  if(!(phi >= 0 && phi < 2 && H < last.sine * last.sine / (1 + last.cosine) * (1 - 1e-14)))
  {
    const Position there = end(member, k);
    if(!(phi >= 0 && phi <= there.phi))
      throw std::domain_error("this tautochrone ends at " + std::to_string(there.phi) + " rad");
    if(phi == there.phi)
      return there;
  }
  if(phi == 0)
    return Position{};
  // Where kk is so small against cos⁴φ, what Euler's two corrections leave out is below 1e-16, and the curves differ
  // by less than e^−250000.
  const double cosine2 = (1 - H) * (1 - H);
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
    return {std::atan2(sine, cosine), k, (1 + k * k) / 4 * sine * sine, 1 - k};
  }
  const double r = std::sqrt(k * (1 - k + k * k));
  return {std::atan((1 - k) / std::sqrt(k)), r, (1 - k) * (1 - k) / 2, (1 - k) * (1 + k * k) / (1 + r)};
}

Position at(Member member, double k, double phi)
{
  const double chord = chord_of(phi);
  if(const auto here = known(member, k, phi, chord))
    return *here;
  return followed(k, begin_for(member, k, phi), phi, chord);
}

std::vector<Position> along(Member member, double k, const std::vector<double>& angles)
{
  std::vector<Position> result(angles.size());
  std::optional<Flow> flow;
  for(size_t i = angles.size(); i-- > 0;)
  {
    const double phi = angles[i], chord = chord_of(phi);
    if(i > 0 && !(angles[i - 1] < phi))
      throw std::domain_error("the angles must grow");
    std::optional<Position> here = known(member, k, phi, chord);
    while(!here)
    {
      if(flow)
        here = flow->landed(phi, chord);
      if(here)
        break;
      const Start from = begin_for(member, k, phi);
      if(!flow || from.sine < 0.99 * flow->sine())
        flow.emplace(k, from);
      else if(flow->reaches(chord))
      {
        here = flow->position(phi, flow->time_of(chord));
        break;
      }
      else
        flow->go(-flow->length());
      flow->expand(std::sin(phi));
    }
    result[i] = *here;
  }
  return result;
}

Position at_through(double k, double phi1, double r1, double phi)
{
  require_body(k, 1e-9);
  const double slack = 1e-15 * r1;
  const bool inside = phi1 > 0 && phi1 < std::numbers::pi / 2 && r1 > 0
                      && (1 + k * k) * r1 * std::cos(phi1) - k * k - r1 * r1 >= -slack;
  if(!inside)
    throw std::domain_error("no cheek leads through this point: dr would be positive there");
  if(!(phi >= 0 && phi <= phi1))
    throw std::domain_error("the curve is followed downwards only, from " + std::to_string(phi1) + " rad");
  if(phi == 0)
    return {};
  return followed(k, {std::sin(phi1), std::cos(phi1), r1, 1 - r1}, phi, chord_of(phi));
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
  constexpr std::array<double, 4> node = {0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                          0.96028985649753623};
  constexpr std::array<double, 4> weight = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                            0.10122853629037626};
  struct Sums
  {
    double z = 0, y = 0, x = 0;
  };
  Flow flow(k, last_place(member, k));
  const auto piece = [&](double from, double to, Sums& into) {  // downwards from `from`
    const double middle = (from + to) / 2, half = (from - to) / 2;
    for(size_t i = 0; i < 8; ++i)
    {
      const double tau = middle + half * (i < 4 ? node[i] : -node[i - 4]);
      const double Y = flow.Y(tau), Z = flow.E(tau) + k * Y, q = flow.unit(), dx = q * q * k * Y * Z;
      const double sine = std::hypot(Y, Z) * q, dz = dx / sine, w = half * weight[i % 4];
      into.z += w * dz;
      into.y += w * dz * (1 - q * q * flow.height(tau));
      into.x += w * dx;
    }
  };
  std::vector<Drawn> result(angles.size());
  std::vector<Sums> above(angles.size());  // from the next angle (or the end) down to each
  Sums sums;
  size_t left = angles.size();
  for(bool done = false; !done;)
  {
    flow.expand();
    double from = 0;
    const auto advance = [&](double to) {  // in two pieces
      piece(from, (from + to) / 2, sums);
      piece((from + to) / 2, to, sums);
      from = to;
    };
    while(left > 0 && angles[left - 1] > 0 && flow.reaches(chord_of(angles[left - 1])))
    {
      --left;
      const double tau = flow.time_of(chord_of(angles[left]));
      advance(tau);
      result[left].at = flow.position(angles[left], tau);
      above[left] = sums;
      sums = {};
    }
    done = flow.reaches(chord_of(lowest));
    const double to = done ? flow.time_of(chord_of(lowest)) : -flow.length();
    advance(to);
    if(done)
    {
      const Position floor = flow.position(lowest, to);
      sums.z += floor.r * lowest;
      sums.y += floor.r * lowest;
      sums.x += floor.x;
    }
    flow.go(to);
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
    const double half = std::sin(d.at.phi / 2);
    d.p = d.at.s * std::cos(d.at.phi) + 2 * half * half - d.at.x;  // 1 − x − r cos φ
    d.q = d.y - d.at.r * std::sin(d.at.phi);
  }
  return result;
}

}  // namespace tautochrone
