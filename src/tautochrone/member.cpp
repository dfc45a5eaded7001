#include "tautochrone/member.hpp"

#include "tautochrone/euler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tautochrone
{
namespace
{

using std::size_t;

constexpr size_t order = 24;
using Taylor = std::array<double, order + 1>;

double value(const Taylor& c, double tau)
{
  double sum = c[order];
  for(size_t n = order; n-- > 0;)
    sum = sum * tau + c[n];
  return sum;
}

void require_body(double k, double least)
{
  if(!(k >= least && k < 1))
    throw std::domain_error("a tautochrone that can be wound needs k/a below 1 and not below "
                            + std::to_string(least) + "; this is " + std::to_string(k));
}

// The larger radius at which dr = 0 for the angle φ.
double turning_radius(double k, double phi)
{
  const double half = (1 + k * k) * std::cos(phi) / 2;
  return half + std::sqrt(std::max((half - k) * (half + k), 0.0));
}

/*
 The flow downwards. Carried are H/qq, Y/q and E/q, where E = Z − kY = Z (1 − r) and q is a power of two
 that keeps them near one, however near the lowest point is:

   dH = ZZ,  dY = εZ,  dE = E/(1 + kk) − HZ,  ε = k/(1 + kk).
*/
class Flow
{
public:
  Flow(double k, double phi, double r, double s)
      : k_(k), kk_(k * k), eps_(k / (1 + k * k)), q_(std::exp2(std::ilogb(phi) + 1))
  {
    const double length = std::hypot(k, r), sine = std::sin(phi) / q_, half = half_sine(phi);
    H_[0] = 2 * half * half;
    Y_[0] = sine * r / length;
    Z_[0] = sine * k / length;
    E_[0] = Z_[0] * s;
  }

  // The series of the next step, which may go down to τ = −length().
  void expand()
  {
    // [flow]
    const double gain = q_ * q_;
    for(size_t n = 0; n < order; ++n)
    {
      double ZZ = 0, HZ = 0;
      for(size_t i = 0; i <= n; ++i)
      {
        ZZ += Z_[i] * Z_[n - i];
        HZ += H_[i] * Z_[n - i];
      }
      const double next = 1 / static_cast<double>(n + 1);
      H_[n + 1] = ZZ * next;
      Y_[n + 1] = eps_ * Z_[n] * next;
      E_[n + 1] = (E_[n] / (1 + kk_) - gain * HZ) * next;
      Z_[n + 1] = E_[n + 1] + k_ * Y_[n + 1];
    }
    // [flow]
    // Not longer than the series is good for, than it is stable for, and than Y keeps a half of itself.
    length_ = std::min(7.0, 0.7 * (1 + kk_) / kk_);
    for(const size_t n : {order - 1, order})
    {
      const double last = std::max(std::abs(Z_[n] / Z_[0]), std::abs(H_[n] / H_[0]));
      if(last > 0)
        length_ = std::min(length_, std::pow(4e-18 / last, 1 / static_cast<double>(n)));
    }
  }

  double length() const { return length_; }
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
    Y_[0] = Y;
    E_[0] = E;
    Z_[0] = Z;
    if(H_[0] < 0x1p-40)
    {
      H_[0] *= 0x1p40;
      Y_[0] *= 0x1p20;
      E_[0] *= 0x1p20;
      Z_[0] *= 0x1p20;
      q_ *= 0x1p-20;
    }
  }

  // Where in the present step the angle is φ, which must lie in it.
  double time_of(double phi) const
  {
    const double half = half_sine(phi), target = 2 * half * half;
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

  bool reaches(double phi) const
  {
    const double half = half_sine(phi);
    return value(H_, -length_) <= 2 * half * half;
  }

  Position position(double phi, double tau) const
  {
    const double Y = value(Y_, tau), E = value(E_, tau), Z = E + k_ * Y;
    return {phi, k_ * Y / Z, (1 + kk_) / 2 * (q_ * Y) * (q_ * Y), E / Z};
  }

private:
  // sin ½φ over q, of subnormal angles too
  double half_sine(double phi) const { return phi < 1e-9 ? phi / q_ / 2 : std::sin(phi / 2) / q_; }

  double k_, kk_, eps_, q_;
  double length_ = 0;
  Taylor H_{}, Y_{}, E_{}, Z_{};
};

// From a place down to the angle φ.
Position followed(double k, const Position& from, double phi)
{
  if(phi == 0)
    return {};
  Flow flow(k, from.phi, from.r, from.s);
  for(flow.expand(); !flow.reaches(phi); flow.expand())
    flow.go(-flow.length());
  return flow.position(phi, flow.time_of(phi));
}

// An angle so far above φ that all tautochrones that are there agree at φ to e^-46, in r and in 1 − r;
// infinity where there is none. By A(φ) − A(φ₁) = 46 kk/(1 − 3kk), with A = −½ − ln sin φ + ½ sin²φ, see
// falling(): near the lowest point their difference is as φ^(1/kk − 1), while 1 − r is as φφ; for kk > ⅓
// it is as their difference.
double far_above(double k, double phi)
{
  const double kk = k * k, sine = std::sin(phi);
  const double wanted = std::log(sine) - sine * sine / 2 + 46 * kk / (1 - 3 * kk);
  if(kk > 0.33 || wanted >= -0.5)
    return std::numeric_limits<double>::infinity();
  double log_sine = wanted;
  for(int i = 0; i < 30; ++i)
  {
    const double sine2 = std::exp(2 * log_sine);
    log_sine -= (log_sine - sine2 / 2 - wanted) / (1 - sine2);
  }
  return std::asin(std::exp(log_sine));
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
  require_body(k, 1e-9);
  const Position last = end(member, k);
  if(!(phi >= 0 && phi <= last.phi))
    throw std::domain_error("this tautochrone ends at " + std::to_string(last.phi) + " rad");
  if(phi == last.phi)
    return last;
  // Where kk is so small against cos⁴φ, what Euler's two corrections leave out is below 1e-16, and the curves differ
  // by less than e^−250000.
  if(member == Member::highest && k * k <= 1e-6 * std::pow(std::cos(phi), 4))
    return {phi, euler_r(1.0, k, phi), euler_x(1.0, k, phi), euler_s(1.0, k, phi)};
  const double start = phi == 0 ? 0 : far_above(k, phi);
  // The widest curve parts from the others high up, where it is not at the larger turning radius.
  const double limit = member == Member::highest ? last.phi : k <= 0.1 ? 0.35 : 0.0;
  if(start > 0 && start < limit)
  {
    const double r = turning_radius(k, start);
    return followed(k, {start, r, 0, 1 - r}, phi);
  }
  return followed(k, last, phi);
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
  return followed(k, {phi1, r1, 0, 1 - r1}, phi);
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
  Flow flow(k, last.phi, last.r, last.s);
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
    while(left > 0 && angles[left - 1] > 0 && flow.reaches(angles[left - 1]))
    {
      --left;
      const double tau = flow.time_of(angles[left]);
      advance(tau);
      result[left].at = flow.position(angles[left], tau);
      above[left] = sums;
      sums = {};
    }
    done = flow.reaches(lowest);
    const double to = done ? flow.time_of(lowest) : -flow.length();
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
