/// @file
/// The two plainest ways to follow an equation of the second order step by step: what the exact
/// motion is compared with.
#pragma once

namespace pendulum
{

/// Where the pendulum is, in radians, and how fast it turns, in radians per unit of time.
struct Place
{
  double phi;   ///< where
  double rate;  ///< how fast
};

// [leapfrog]
/// n steps of the leapfrog through the time t for Φ'' = acceleration(Φ). Domain: n ≥ 1. Second
/// order: the error falls like 1/n², and the energy keeps within bounds of that size. Source:
/// Störmer and Verlet.
template <class Acceleration>
Place leapfrog(Place at, double t, int n, Acceleration acceleration)
{
  const double dt = t / n;
  for(int i = 0; i < n; ++i)
  {
    at.rate += dt / 2 * acceleration(at.phi);
    at.phi += dt * at.rate;
    at.rate += dt / 2 * acceleration(at.phi);
  }
  return at;
}
// [leapfrog]

/// The same by the classical rule of Runge and Kutta, four accelerations a step. Fourth order: the
/// error falls like 1/n⁴, but the energy drifts with the time.
template <class Acceleration>
Place runge_kutta(Place at, double t, int n, Acceleration acceleration)
{
  const double dt = t / n;
  for(int i = 0; i < n; ++i)
  {
    const double a1 = acceleration(at.phi);
    const double a2 = acceleration(at.phi + dt / 2 * at.rate);
    const double a3 = acceleration(at.phi + dt / 2 * (at.rate + dt / 2 * a1));
    const double a4 = acceleration(at.phi + dt * (at.rate + dt / 2 * a2));
    at.phi += dt * (at.rate + dt / 6 * (a1 + a2 + a3));
    at.rate += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return at;
}

}  // namespace pendulum
