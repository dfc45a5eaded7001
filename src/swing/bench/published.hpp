/// @file
/// Published methods for K and for Jacobi's functions, in our own code and with coefficients of our own
/// finding: the strongest that the edition's functions can be set beside.
///
/// Of each the mathematics is the author's, and the structure: which intervals, which kind of
/// approximation, of which degree. All are compiled with the flags of the edition's own loops.
#pragma once

namespace bench::published
{

/// K by m₁ = 1 − k² after Hastings, Cody and Moshier's Cephes: one polynomial, and one times the logarithm.
double K_in_one_piece(double m1);

/// The same with a logarithm that is given.
double K_in_one_piece(double m1, double logarithm);

/// K by m₁ after Fukushima (2009): polynomials on ten intervals, and near k = 1 the nome.
double K_by_polynomials(double m1);

/// K by m₁ after Fukushima (2015): quotients of polynomials on nine intervals, and near k = 1 the
/// logarithm.
double K_by_quotients(double m1);

/// Φ(t) by sn, cn and dn after Fukushima (2012): the argument is reduced by quarter periods, halved until a
/// short series gives 1 − cn, and doubled again, 1 − cn or cn being carried, whichever loses nothing.
class Doubling
{
public:
  /// k and kc of the same amplitude, and K.
  Doubling(double k, double kc, double K);

  /// As it was published: the argument is halved until three terms of the series suffice, and what depends
  /// on the amplitude, K by K_by_quotients() among it, is computed at each call.
  static Doubling as_published(double k, double kc);

  /// sn, cn and dn.
  struct Functions
  {
    double sn;  ///< the sine of the amplitude
    double cn;  ///< its cosine
    double dn;  ///< its delta
  };
  /// The functions at t.
  Functions operator()(double t) const;

private:
  double kc_;
  double mc_;
  double m_;
  double K_;
  double shortest_;
  double series_[5];  // of 1 − cn in u²
};

}  // namespace bench::published
