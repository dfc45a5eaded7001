#include "swing/oracle.hpp"

#include <limits>
#include <vector>

namespace swing::oracle
{
namespace
{

const Fifty& enough()
{
  static const Fifty value("1e-51");
  return value;
}

Fifty cosine_of_half(const Fifty& angle)
{
  return cos(angle / Fifty(2));
}
Fifty sine_of_half(const Fifty& angle)
{
  return sin(angle / Fifty(2));
}

// Carlson's R_F by duplication; the error left is of the eighth order in the relative spread.
Fifty carlson_rf(Fifty x, Fifty y, Fifty z)
{
  Fifty mean = (x + y + z) / Fifty(3);
  while(abs(x - mean) + abs(y - mean) + abs(z - mean) > mean * Fifty(3e-7))
  {
    const Fifty lambda = sqrt(x) * sqrt(y) + sqrt(y) * sqrt(z) + sqrt(z) * sqrt(x);
    x = (x + lambda) / Fifty(4);
    y = (y + lambda) / Fifty(4);
    z = (z + lambda) / Fifty(4);
    mean = (x + y + z) / Fifty(3);
  }
  const Fifty dx = Fifty(1) - x / mean;
  const Fifty dy = Fifty(1) - y / mean;
  const Fifty dz = -dx - dy;
  const Fifty e2 = dx * dy - dz * dz;
  const Fifty e3 = dx * dy * dz;
  const Fifty series = Fifty(1) - e2 / Fifty(10) + e3 / Fifty(14) + e2 * e2 / Fifty(24)
                       - Fifty(3) * e2 * e3 / Fifty(44) - Fifty(5) * e2 * e2 * e2 / Fifty(208)
                       + Fifty(3) * e3 * e3 / Fifty(104) + e2 * e2 * e3 / Fifty(16);
  return series / sqrt(mean);
}

// Σ ± qⁿ⁽ⁿ⁺¹⁾ f((2n+1)z): θ₁ and θ₂ without their factor 2q^¼.
template <class Function>
Fifty odd_series(const Fifty& q, const Fifty& z, bool alternating, Function f)
{
  Fifty sum = 0;
  Fifty power = 1;
  for(int n = 0; n < 14; ++n)
  {
    sum += (alternating && n % 2 == 1 ? -power : power) * f(z * Fifty(2 * n + 1));
    power *= pow(q, 2 * n + 2);
  }
  return sum;
}

// 1 + 2 Σ ± qⁿⁿ f(2nz): θ₃ and θ₄.
template <class Function>
Fifty even_series(const Fifty& q, const Fifty& z, bool alternating, Function f)
{
  Fifty sum = 1;
  Fifty power = q;
  for(int n = 1; n < 14; ++n)
  {
    sum += Fifty(2) * (alternating && n % 2 == 1 ? -power : power) * f(z * Fifty(2 * n));
    power *= pow(q, 2 * n + 1);
  }
  return sum;
}

}  // namespace

Fifty agm(Fifty a, Fifty b)
{
  if(a == Fifty(0) || b == Fifty(0))
    return 0;
  while(abs(a - b) > a * Fifty(1e-30))
  {
    const Fifty mean = (a + b) / Fifty(2);
    b = sqrt(a * b);
    a = mean;
  }
  return (a + b) / Fifty(2);
}

Fifty K_from_complement(const Fifty& kc)
{
  return exact::pi() / (Fifty(2) * agm(Fifty(1), kc));
}

Fifty K(const Fifty& k)
{
  return K_from_complement(sqrt((Fifty(1) - k) * (Fifty(1) + k)));
}

Fifty K_by_series(const Fifty& kc)
{
  const Fifty m = kc * kc;
  const bool direct = m > Fifty(0.5);
  const Fifty x = direct ? (Fifty(1) - kc) * (Fifty(1) + kc) : m;
  const Fifty L = log(Fifty(4) / kc);
  Fifty a = 1;
  Fifty power = 1;
  Fifty r = 0;
  Fifty sum = 0;
  for(int n = 0; power > enough(); ++n)
  {
    sum += direct ? a * a * power : a * a * power * (L - r);
    a *= Fifty(2 * n + 1) / Fifty(2 * n + 2);
    r += Fifty(2) / Fifty((2 * n + 1) * (2 * n + 2));
    power *= x;
  }
  return direct ? exact::pi() / Fifty(2) * sum : sum;
}

Fifty ratio_from_bottom(const Fifty& zeta)
{
  return Fifty(1) / agm(Fifty(1), cosine_of_half(zeta));
}

Fifty ratio_from_top(const Fifty& eta)
{
  return Fifty(1) / agm(Fifty(1), sine_of_half(eta));
}

Fifty ratio_excess(const Fifty& zeta)
{
  const Fifty quarter = sin(zeta / Fifty(4));
  Fifty a = 1;
  Fifty b = cosine_of_half(zeta);
  Fifty next = Fifty(1) - quarter * quarter;
  Fifty c = quarter * quarter;
  Fifty missing = c;
  while(c > missing * enough() && c > Fifty(0))
  {
    b = sqrt(a * b);
    a = next;
    next = (a + b) / Fifty(2);
    c = c * c / (Fifty(4) * next);
    missing += c;
  }
  return missing / next;
}

Fifty time_from_bottom(const Fifty& phi, const Fifty& eta)
{
  const Fifty zeta = exact::pi() - eta;
  const Fifty k = cosine_of_half(eta);
  const Fifty across = cosine_of_half(phi);
  if(eta == Fifty(0) && phi >= zeta)
    return Fifty(std::numeric_limits<double>::infinity());
  const Fifty left = sine_of_half(zeta - phi) * sine_of_half(zeta + phi);
  return sine_of_half(phi) * carlson_rf(left, k * k * across * across, k * k);
}

Fifty time_from_rest_past(const Fifty& past, const Fifty& eta)
{
  const Fifty psi = eta + past;
  const Fifty s = sine_of_half(eta);
  const Fifty c = cosine_of_half(eta);
  const Fifty across = cosine_of_half(psi);
  const Fifty down = sine_of_half(psi);
  return sqrt(sine_of_half(past) * sine_of_half(psi + eta))
         * carlson_rf(s * s * across * across, s * s * c * c, c * c * down * down);
}

// Where in its half period the motion is.
struct Motion::Place
{
  Fifty n;  // half periods gone
  Fifty u;  // what is left, |u| ≤ K, in the argument of the elliptic functions
  bool odd;
};

Motion::Motion(const Fifty& k, const Fifty& kc, const Fifty& rate, bool turns)
    : k_(k), kc_(kc), rate_(rate), turns_(turns), dual_(kc < k), K_(K_from_complement(kc)),
      other_K_(K_from_complement(k)), q_(exp(-exact::pi() * (dual_ ? K_ / other_K_ : other_K_ / K_))),
      quarter_(K_ / rate)
{
}

Motion Motion::from_zeta(const Fifty& zeta)
{
  return Motion(sine_of_half(zeta), cosine_of_half(zeta), Fifty(1), false);
}

Motion Motion::from_eta(const Fifty& eta)
{
  return Motion(cosine_of_half(eta), sine_of_half(eta), Fifty(1), false);
}

Motion Motion::revolving(const Fifty& excess)
{
  const Fifty inverse = sqrt(Fifty(1) + excess);
  return Motion(Fifty(1) / inverse, sqrt(excess) / inverse, inverse, true);
}

Motion::Place Motion::place(const Fifty& t) const
{
  const Fifty half_period = Fifty(2) * K_;
  const Fifty u = t * rate_;
  const Fifty n = round(u / half_period);
  if(!(abs(n) <= Fifty(1e30)))
  {
    const Fifty unknown(std::numeric_limits<double>::quiet_NaN());
    return {unknown, unknown, false};
  }
  const Fifty half = n / Fifty(2);
  return {n, u - n * half_period, half != floor(half)};
}

struct Motion::Quotient
{
  Fifty above;
  Fifty below;
};

// tan ½Φ from |u| ≤ K: swinging it is k sn/dn, revolving sn/cn.
Motion::Quotient Motion::tangent_of_half(const Fifty& u) const
{
  const Fifty z = exact::pi() * u / (Fifty(2) * (dual_ ? other_K_ : K_));
  const auto s = [&](const Fifty& x) { return dual_ ? sinh(x) : sin(x); };
  const auto c = [&](const Fifty& x) { return dual_ ? cosh(x) : cos(x); };
  const Fifty theta1 = odd_series(q_, z, true, s);
  const Fifty theta2_0 = odd_series(q_, Fifty(0), false, c);
  const Fifty theta3_0 = even_series(q_, Fifty(0), false, c);
  const Fifty theta4_0 = even_series(q_, Fifty(0), true, c);
  if(turns_)
    return {theta3_0 * theta1,
            dual_ ? theta2_0 * even_series(q_, z, true, c) : theta4_0 * odd_series(q_, z, false, c)};
  const Fifty scale = dual_ ? theta4_0 : Fifty(4) * sqrt(q_) * theta2_0;
  return {scale * theta1, (dual_ ? theta2_0 : theta4_0) * even_series(q_, z, false, c)};
}

Fifty Motion::angle(const Fifty& t) const
{
  const Place p = place(t);
  const Quotient q = tangent_of_half(p.u);
  const Fifty part = Fifty(2) * atan2(q.above, q.below);
  if(turns_)
    return Fifty(2) * exact::pi() * p.n + part;
  return p.odd ? -part : part;
}

Fifty Motion::angle_from_top(const Fifty& t) const
{
  const Quotient q = tangent_of_half(place(t).u);
  return Fifty(2) * abs(atan2(q.below, abs(q.above)));
}

// Φ' = 2k cn swinging, 2 rate dn revolving.
Fifty Motion::velocity(const Fifty& t) const
{
  const Place p = place(t);
  const Fifty z = exact::pi() * p.u / (Fifty(2) * (dual_ ? other_K_ : K_));
  const auto c = [&](const Fifty& x) { return dual_ ? cosh(x) : cos(x); };
  const Fifty zero = 0;
  const Fifty theta2 = odd_series(q_, z, false, c) / odd_series(q_, zero, false, c);
  const Fifty theta3 = even_series(q_, z, false, c) / even_series(q_, zero, false, c);
  const Fifty theta4 = even_series(q_, z, true, c) / even_series(q_, zero, true, c);
  if(turns_)
    return Fifty(2) * rate_ * (dual_ ? theta3 / theta2 : theta3 / theta4);
  const Fifty speed = Fifty(2) * k_ * (dual_ ? theta4 / theta2 : theta2 / theta4);
  return p.odd ? -speed : speed;
}

// With the means a and half differences c of the arithmetic-geometric mean of 1 and kc: 2ᴺ a u is the
// amplitude in the limit, and each step back is φ ← ½(φ + arcsin(c/a sin φ)).
Fifty Motion::angle_by_landen(const Fifty& t) const
{
  const Place p = place(t);
  std::vector<Fifty> a{Fifty(1)};
  std::vector<Fifty> c{k_};
  Fifty b = kc_;
  while(abs(c.back()) > enough())
  {
    const Fifty mean = (a.back() + b) / Fifty(2);
    c.push_back(c.back() * c.back() / (Fifty(4) * mean));
    b = sqrt(a.back() * b);
    a.push_back(mean);
  }
  Fifty phi = ldexp(a.back() * p.u, static_cast<int>(a.size()) - 1);
  for(std::size_t n = a.size() - 1; n > 0; --n)
    phi = (phi + asin(c[n] / a[n] * sin(phi))) / Fifty(2);
  if(turns_)
    return Fifty(2) * exact::pi() * p.n + Fifty(2) * phi;
  const Fifty sn = sin(phi);
  const Fifty cn = cos(phi);
  const Fifty part = Fifty(2) * atan2(k_ * sn, sqrt(cn * cn + kc_ * kc_ * sn * sn));
  return p.odd ? -part : part;
}

}  // namespace swing::oracle
