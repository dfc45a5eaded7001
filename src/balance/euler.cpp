#include "balance/euler.hpp"

#include "swing/twofold.hpp"

namespace balance
{
namespace
{

/// a sin α and a cos α from the two linear equations for a value and a rate.
struct Solved
{
  double sine, cosine, determinant;
};

Solved solved(double lambda, double mu, double k, double sine, double cosine, double value, double rate)
{
  // k times ℭ/(4μ² − λ²); the differences of the two sidebands, formed in letters
  const double on_sine = 1 + 2 * lambda * k * sine;
  const double on_cosine = 4 * mu * k * cosine;
  const double rate_sine = -(4 * mu * mu - 2 * lambda * lambda) * k * cosine;
  const double rate_cosine = mu * (1 - 2 * lambda * k * sine);
  const double determinant = on_sine * rate_cosine - on_cosine * rate_sine;
  return {(value * rate_cosine - on_cosine * rate) / determinant,
          (on_sine * rate - value * rate_sine) / determinant, determinant};
}

swing::Twofold exactly(double x)
{
  return {x, 0};
}

}  // namespace

Found constants_of(double lambda, double mu, double i, const State<>& start)
{
  const auto& [at, rate] = start;
  const bool possible =
      lambda > 0 && mu > 0 && i >= 0 && lambda != 2 * mu
      && std::isfinite(lambda + mu + i + at.omega + at.eta + at.theta + rate.omega + rate.eta + rate.theta);
  if(!possible)
    throw std::domain_error("no constants: λ and μ must be positive, i not negative, λ not 2μ, all finite");
  const double C = std::hypot(at.omega, rate.omega / lambda);
  const double sine = C == 0 ? 0 : at.omega / C, cosine = C == 0 ? 1 : rate.omega / lambda / C;
  const double k = i * C / ((2 * mu - lambda) * (2 * mu + lambda));
  const Solved P = solved(lambda, mu, k, sine, cosine, at.eta, rate.eta);
  const Solved Q = solved(lambda, mu, -k, sine, cosine, at.theta, rate.theta);
  if(P.determinant == 0 || Q.determinant == 0)
    throw std::domain_error("no constants: K is 1 or −1");
  using elementary::atan2;
  return {{std::hypot(P.sine, P.cosine), std::hypot(Q.sine, Q.cosine), C, atan2(P.sine, P.cosine),
           atan2(Q.sine, Q.cosine), atan2(at.omega, rate.omega / lambda)},
          P.determinant,
          Q.determinant};
}

Factors factors(double lambda, double mu, double a, double g, double m)
{
  if(!(lambda > 0 && mu > 0 && g > 0 && a >= 0 && lambda != 2 * mu
       && std::isfinite(lambda + mu + a + g + m)))
    throw std::domain_error("no K: λ, μ, g must be positive, a not negative, λ not 2μ, all finite");
  using swing::Twofold;
  const Twofold divisor = Twofold(swing::sum_of(2 * mu, -lambda)) * Twofold(swing::sum_of(2 * mu, lambda));
  const Twofold strength = exactly(mu) * exactly(mu) * exactly(a) * exactly(m) / exactly(2 * g);
  const Twofold above = exactly(lambda) * exactly(lambda) * strength;
  return {(above / divisor).hi, ((divisor + above) / divisor).hi, ((divisor - above) / divisor).hi};
}

double lambda_where_K_is_one(double mu, double a, double g, double m)
{
  return 2 * mu / std::sqrt(1 + mu * mu * a * m / (2 * g));
}

std::string Minutes::text() const
{
  const long size = std::abs(all);
  return (all < 0 ? "−" : "") + std::to_string(size / 60) + "°\u202f" + std::to_string(size % 60) + "′";
}

Minutes in_minutes(const exact::Fifty& angle, const exact::Fifty& unit, double degrees)
{
  const exact::Fifty minutes = angle / unit * (60 * exact::Fifty(degrees));
  if(!(unit > 0 && degrees > 0 && abs(minutes) < 1e15))
    throw std::domain_error("no such angle: the unit and its degrees must be positive, all finite");
  return {static_cast<long>(static_cast<double>(round(minutes)))};
}

Row row_of(const ReleaseOf<exact::Fifty>& r, const exact::Fifty& lambda_t, const exact::Fifty& unit,
           double degrees)
{
  const auto [omega, eta, theta] = euler(r, exact::Fifty(lambda_t / r.lambda));
  return {in_minutes(omega, unit, degrees), in_minutes(eta, unit, degrees),
          in_minutes(theta, unit, degrees)};
}

}  // namespace balance
