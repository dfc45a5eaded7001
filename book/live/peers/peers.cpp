// What the peers are set beside: the edition's K and the pendulum's motion, one number at a time and in
// arrays, and the judge of fifty digits.

#include <cstddef>

#include "exact/fifty.hpp"
#include "swing/motion.hpp"
#include "swing/oracle.hpp"
#include "swing/time.hpp"

namespace
{

using exact::Fifty;

swing::Motion& motion()
{
  static swing::Motion prepared(swing::Amplitude::from_zeta(1));
  return prepared;
}

}  // namespace

extern "C"
{
  /// What a call into the module takes by itself.
  double peers_given(double x)
  {
    return x;
  }
  double peers_K(double k)
  {
    return swing::K(k);
  }
  void peers_K_array(const double* k, double* out, std::size_t n)
  {
    swing::K({k, n}, {out, n});
  }
  void peers_prepare(double zeta)
  {
    motion() = swing::Motion(swing::Amplitude::from_zeta(zeta));
  }
  double peers_angle(double t)
  {
    return motion().angle(t);
  }
  void peers_angle_array(const double* t, double* out, std::size_t n)
  {
    motion().angle({t, n}, {out, n});
  }
  /// The error of `x` as K(k), in ulps.
  double peers_error_K(double k, double x)
  {
    return exact::ulps(x, swing::oracle::K(Fifty(k)));
  }
  /// The same as K(√m).
  double peers_error_K_of_m(double m, double x)
  {
    return exact::ulps(x, swing::oracle::K(sqrt(Fifty(m))));
  }
  /// The error of `x` as the angle at the time `t` of a swing of the amplitude `zeta`, in parts of the
  /// amplitude.
  double peers_error_angle(double zeta, double t, double x)
  {
    const Fifty exact = swing::oracle::Motion::from_zeta(Fifty(zeta)).angle(Fifty(t));
    return static_cast<double>(abs(Fifty(x) - exact)) / zeta;
  }
}
