#include "tautochrone/cheeks.hpp"

#include "tautochrone/average.hpp"
#include "tautochrone/series.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tautochrone
{
namespace
{

constexpr double half_pi = std::numbers::pi / 2;

// Huygens's and Euler's curves at t = tan²φ: r = c ρ and 2x = sin²φ ξ, and B with κB the rest of
// ξ(κ + rr) − (1 + κ)rr, what the curve lacks of a tautochrone. The powers of κ that cancel are left out.
struct Form
{
  double rho, xi, rest;
};

// [rest]
Form form(int order, double kappa, double t)
{
  const double A = t * (2 + t), B = 6 * t * (1 + t) * (1 + t) * (1 + t), E = t * (3 + 2 * t);
  if(order == 0)
    return {1, 1, t / (1 + t)};
  if(order == 1)
    return {1 - kappa * A, 1 - kappa * t, kappa * t * (3 + 2 * t - kappa * A * (2 + t))};
  const double second = t * (9 + t * (39 + t * (44 + 15 * t)));
  const double third = 2 * B * t * (1 + t) - E * A * A;
  return {1 - kappa * (A + kappa * B), 1 - kappa * (t + kappa * (1 + t) * E),
          kappa * kappa * (second + kappa * (third - kappa * (B * (B + 2 * E * A) + kappa * E * B * B)))};
}
// [rest]

int order_of(Cheeks cheeks)
{
  return cheeks == Cheeks::cycloids ? 0 : cheeks == Cheeks::euler_kk ? 1 : 2;
}

void require(Cheeks cheeks, double k, double phi)
{
  if(!(k >= 0 && k <= 1e20))
    throw std::domain_error("a swing needs 0 ≤ k/a ≤ 1e20");
  bool reached = phi > 0 && phi < (cheeks == Cheeks::none ? std::numbers::pi : half_pi);
  if(reached && cheeks != Cheeks::none)
  {
    const double tangent = std::tan(phi);
    reached = form(order_of(cheeks), k * k, tangent * tangent).rho > 0;
  }
  if(!reached)
    throw std::domain_error("the curve on such cheeks does not rise to this angle");
}

}  // namespace

double defect(Cheeks cheeks, double k, double phi)
{
  require(cheeks, k, phi);
  const double tangent = std::tan(cheeks == Cheeks::none ? phi / 2 : phi), t = tangent * tangent;
  if(cheeks == Cheeks::none)
    return t;
  const double kappa = k * k;
  const Form at = form(order_of(cheeks), kappa, t);
  return kappa / (1 + kappa) * (1 + t) * at.rest / (at.rho * at.rho);
}

double excess(Cheeks cheeks, double k, double phi0)
{
  require(cheeks, k, phi0);
  const double half_sine = std::sin(phi0 / 2), half_cosine = std::cos(phi0 / 2);
  const double uu = half_sine * half_sine, vv = half_cosine * half_cosine;
  if(cheeks == Cheeks::none)
    return average_over_quarter(
        [&](double sin2, double cos2) {
          const double w = vv + uu * cos2, root = std::sqrt(w);  // cos²½φ, after sin ½φ = sin ½φ₀ sin α
          return uu * sin2 / (w + root);
        },
        vv < 0.03);
  // [excess]
  const int order = order_of(cheeks);
  const double kappa = k * k, share = kappa / (1 + kappa);
  const double c0 = std::cos(phi0), tangent = std::tan(phi0), t0 = tangent * tangent;
  return average_over_quarter(
      [&](double sin2, double cos2) {
        const double h = 2 * uu * sin2, c = c0 + 2 * uu * cos2;  // 1 − cos φ and cos φ
        const double tan2 = h * (1 + c) / (c * c);
        const Form at = form(order, kappa, tan2);
        // (x₀ − x) over ½(sin²φ₀ − sin²φ), and x over ½ sin²φ
        const double products = (1 + tan2) * (1 + t0);
        const double of_k4 = 3 * (t0 + tan2) + 2 * (t0 * t0 + t0 * tan2 + tan2 * tan2);
        double steepness = 1;
        if(order > 0)
          steepness -= kappa * (t0 + tan2 + t0 * tan2);
        if(order > 1)
          steepness -= kappa * kappa * products * of_k4;
        const double over = share * (1 + tan2) * at.rest;  // ρρ times the defect
        const double r_delta = c * over / (at.rho + std::sqrt(at.rho * at.rho + over));
        return 2 * r_delta / std::sqrt((1 + c) * at.xi * (c + c0) * steepness);
      },
      kappa + c0 * c0 < 0.01);
  // [excess]
}

double small_swing(double k)
{
  return std::numbers::pi * std::numbers::sqrt2 * std::hypot(1, k);
}

double swing_time(Cheeks cheeks, double k, double phi0)
{
  const double infinitely_small = small_swing(k);
  return infinitely_small + infinitely_small * excess(cheeks, k, phi0);
}

double largest_amplitude(Cheeks cheeks, double k)
{
  return cheeks == Cheeks::none ? std::numbers::pi : end_of_truncated(order_of(cheeks), k);
}

}  // namespace tautochrone
