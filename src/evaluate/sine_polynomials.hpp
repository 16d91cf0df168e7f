// sine_polynomials: which polynomials give sine and cosine to a wanted accuracy, and how an angle
// is brought to where they hold: x = k pi/2 + r, |r| <= pi/4.
#pragma once

#include <cln/rational.h>

#include <vector>

#include "elgen/scene.hpp"

namespace elgen {

/// One polynomial: of the sine from x^3 on, of the cosine from x^4 on.
struct SinePolynomial {
  int degree = 0;
  double error = 0;  ///< at most, for angles up to pi/4, apart from rounding
  std::vector<double> coefficients = {};
};

[[nodiscard]] const std::vector<SinePolynomial>& sine_polynomials();
[[nodiscard]] const std::vector<SinePolynomial>& cosine_polynomials();

/// How a scalar takes multiples of pi/2 off an angle: k times `high` is exact for all k that occur.
struct AngleReduction {
  ScalarKind scalar = ScalarKind::double_precision;
  double domain = 0;    ///< the largest angle
  double high = 0;      ///< the leading bits of pi/2
  double low = 0;       ///< the rest, rounded
  double inverse = 0;   ///< 2/pi, rounded
  double shift = 0;     ///< 1.5/epsilon: x + shift - shift is the integer nearest to x
  double rounding = 0;  ///< what rounding adds to the error of either polynomial, at most
};

/// Of float or double.
[[nodiscard]] const AngleReduction& angle_reduction(ScalarKind scalar);

/// The polynomial of least degree whose error is at most `max_error` with what rounding in `scalar`
/// adds; that of the largest degree where none is.
[[nodiscard]] const SinePolynomial& cheapest(const std::vector<SinePolynomial>& all,
                                             const cln::cl_RA& max_error, ScalarKind scalar);

}  // namespace elgen
