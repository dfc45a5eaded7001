#include "tautochrone/ways.hpp"

#include "tautochrone/curve.hpp"
#include "tautochrone/euler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#define EIGEN_DONT_VECTORIZE  // sums in one order, and to the same bits, on every processor and in the page
#include <Eigen/LU>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace tautochrone
{
namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The derivatives of slope() with respect to r and to φ.
double slope_by_r(double phi, double r, double k)
{
  const double kk = k * k, u = kk + r * r, rc = (1 + kk) * r * std::cos(phi);
  return (2 * r * (2 * u - rc) - u * (1 + kk) * std::cos(phi)) / (kk * (1 + kk) * std::sin(phi));
}

double slope_by_phi(double phi, double r, double k)
{
  const double kk = k * k;
  return (kk + r * r) * r / kk - slope(phi, r, k) / std::tan(phi);
}

int right_side(double at, const double r[], double out[], void* k)
{
  out[0] = slope(at, r[0], *static_cast<double*>(k));
  return std::isfinite(out[0]) ? int{GSL_SUCCESS} : int{GSL_EBADFUNC};
}

int derivatives(double at, const double r[], double by_r[], double by_phi[], void* k)
{
  by_r[0] = slope_by_r(at, r[0], *static_cast<double*>(k));
  by_phi[0] = slope_by_phi(at, r[0], *static_cast<double*>(k));
  return GSL_SUCCESS;
}

}  // namespace

double follow(double k, double from, double r, double to, double tolerance, Stepper stepper)
{
  return follow(k, from, r, std::vector{to}, tolerance, stepper)[0];
}

std::vector<double> follow(double k, double from, double r, const std::vector<double>& to, double tolerance,
                           Stepper stepper)
{
  const auto angle = [](double phi) { return phi > 0 && phi < std::numbers::pi / 2; };
  std::vector<double> result(to.size(), nan);
  if(!(k > 0 && k < 1 && angle(from) && r > 0 && tolerance >= 1e-15 && tolerance <= 0.1)
     || !std::all_of(to.begin(), to.end(), angle) || to.empty())
    return result;
  gsl_odeiv2_system system{right_side, derivatives, 1, &k};
  const gsl_odeiv2_step_type* types[] = {gsl_odeiv2_step_rk8pd, gsl_odeiv2_step_msadams,
                                         gsl_odeiv2_step_msbdf, gsl_odeiv2_step_bsimp};
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, types[static_cast<int>(stepper)],
                                    std::copysign(1e-3 * from, to.front() - from), tolerance, 0),
      gsl_odeiv2_driver_free);
  gsl_odeiv2_driver_set_nmax(driver.get(), 200'000);
  for(std::size_t i = 0; i < to.size(); ++i)
  {
    const int status = gsl_odeiv2_driver_apply(driver.get(), &from, to[i], &r);
    if(status != GSL_SUCCESS || !std::isfinite(r))
      break;
    result[i] = r;
  }
  return result;
}

std::vector<double> collocation(double k, double phi1, std::optional<double> r1, int n,
                                const std::vector<double>& angles)
{
  std::vector<double> result(angles.size(), nan);
  if(!(k > 0 && k < 1 && phi1 > 0 && phi1 < std::numbers::pi / 2 && n >= 2 && n <= 200))
    return result;
  using Eigen::Index;
  const Index points = n + 1;
  // w = (φ/φ₁)² at the points of Chebyshev from 1 down to 0, and the derivatives by w of the polynomial
  // through values there.
  Eigen::VectorXd w(points), weight(points), r(points);
  for(Index i = 0; i < points; ++i)
  {
    const double angle = std::numbers::pi * static_cast<double>(i) / (2 * n);
    w[i] = std::cos(angle) * std::cos(angle);
    weight[i] = (i % 2 == 0 ? 1 : -1) * (i == 0 || i == n ? 0.5 : 1);
  }
  w[n] = 0;
  Eigen::MatrixXd D(points, points);
  for(Index i = 0; i < points; ++i)
  {
    double sum = 0;
    for(Index j = 0; j < points; ++j)
      if(i != j)
      {
        // w_i − w_j by two sines
        const double step = std::numbers::pi / (2 * n);
        const double difference =
            std::sin(static_cast<double>(i + j) * step) * std::sin(static_cast<double>(j - i) * step);
        D(i, j) = weight[j] / weight[i] / difference;
        sum -= D(i, j);
      }
    D(i, i) = sum;
  }
  const double kk = k * k;
  for(Index i = 0; i < points; ++i)
  {
    const double phi = phi1 * std::sqrt(w[i]), eulers = euler_r(1.0, k, phi);
    r[i] = eulers > 0.5 * std::cos(phi) ? eulers : std::cos(phi);
  }
  if(r1)
    r[0] = *r1;
  // kk (1 + kk) sin φ dr/dφ = u(u − (1 + kk) r cos φ), u = kk + rr, with dr/dφ = 2φ/φ₁² dr/dw
  for(int iteration = 0; iteration < 60; ++iteration)
  {
    Eigen::MatrixXd A(points, points);
    Eigen::VectorXd residual(points);
    for(Index i = 0; i < points; ++i)
    {
      const double phi = phi1 * std::sqrt(w[i]), c = std::cos(phi), u = kk + r[i] * r[i];
      const double factor = kk * (1 + kk) * std::sin(phi) * 2 * phi / (phi1 * phi1);
      A.row(i) = factor * D.row(i);
      A(i, i) -= 2 * r[i] * (2 * u - (1 + kk) * r[i] * c) - u * (1 + kk) * c;
      residual[i] = factor * D.row(i).dot(r) - u * (u - (1 + kk) * r[i] * c);
    }
    if(r1)
    {
      A.row(0).setZero();
      A(0, 0) = 1;
      residual[0] = 0;
    }
    const Eigen::VectorXd change = A.partialPivLu().solve(residual);
    if(!change.allFinite())
      return result;
    r -= change;
    if(change.lpNorm<Eigen::Infinity>() < 1e-13 || iteration == 59)
      break;
  }
  for(std::size_t a = 0; a < angles.size(); ++a)
  {
    const double at = (angles[a] / phi1) * (angles[a] / phi1);
    double above = 0, below = 0;
    result[a] = nan;
    for(Index i = 0; i < points; ++i)
    {
      if(at == w[i])
      {
        above = r[i];
        below = 1;
        break;
      }
      const double part = weight[i] / (at - w[i]);
      above += part * r[i];
      below += part;
    }
    result[a] = above / below;
  }
  return result;
}

}  // namespace tautochrone
