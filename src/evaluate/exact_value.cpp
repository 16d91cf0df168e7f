// Significand times a power of two.
#include "exact_value.hpp"

#include <cln/integer.h>
#include <cln/rational.h>

#include <cmath>

namespace elgen {

cln::cl_R exact_value(double value) {
  if (!std::isfinite(value)) return 0;
  // CLN has no denormals, so the exponent is applied to an integer significand.
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto significand = static_cast<long>(std::ldexp(fraction, 53));
  return cln::cl_RA(significand) * cln::expt(cln::cl_RA(2), exponent - 53);
}

}  // namespace elgen
