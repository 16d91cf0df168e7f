// PackTrigonometry: sines and cosines as the batch header computes them, operation by operation.
//
// With k the integer nearest to 2/pi x, r = (x - k high) - k low, |r| <= pi/4, and polynomials in
// r^2 that give the wanted accuracy there:
//
//     sin r = r + (r^3 s(r^2) + rest)     cos r = (1 - r^2/2) + (r^4 c(r^2) + what rounding took)
//
// The last two bits of k say which of them is the sine of x, and with which sign. NaN beyond the
// domain.
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
  double rounding = 0;  ///< the most that rounding adds to the error of either polynomial
};

/// The row of float or double.
[[nodiscard]] const AngleReduction& angle_reduction(ScalarKind scalar);

/// The polynomial of least degree whose error is at most `max_error` with what rounding in `scalar`
/// adds; that of the largest degree where none is.
[[nodiscard]] const SinePolynomial& cheapest(const std::vector<SinePolynomial>& all,
                                             const cln::cl_RA& max_error, ScalarKind scalar);

/// Scalar: float or double.
template <class Scalar>
class PackTrigonometry {
 public:
  /// The polynomials that a scene's `trigonometry` asks for.
  explicit PackTrigonometry(const Numerics& numerics);

  struct Values {
    Scalar sine;
    Scalar cosine;
  };
  [[nodiscard]] Values of(Scalar angle) const;

 private:
  const AngleReduction& reduction_;
  std::vector<Scalar> sine_;
  std::vector<Scalar> cosine_;
};

}  // namespace elgen
