// PackTrigonometry: sines and cosines as the batch header computes them, operation by operation.
//
// With k the integer nearest to 2/pi x, r = (x - k high) - k low, and the polynomials of
// sine_polynomials.hpp in r^2:
//
//     sin r = r + (r^3 s(r^2) + rest)     cos r = (1 - r^2/2) + (r^4 c(r^2) + what rounding took)
//
// The last two bits of k say which of them is the sine of x, and with which sign. NaN beyond the
// domain.
#pragma once

#include <vector>

#include "evaluate/sine_polynomials.hpp"

namespace elgen {

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
