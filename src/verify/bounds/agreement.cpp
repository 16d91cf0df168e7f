// The one rule, and the two numbers in it.
#include "verify/bounds/agreement.hpp"

namespace elgen {
namespace {

/// Values have 64 digits, bounds are of first order in 53 bits: what is left out of B, and what the
/// rounding of many operations adds to it, is far below the other 14 digits.
constexpr int digits_of_bound = 50;
/// The oracle promises 60 digits. Eight are left for sums of many terms: the entries of a
/// projection, and the oracle's own derivatives.
constexpr int digits_of_scale = 52;

}  // namespace

bool agrees(const Measured& number, const Real& truth, const Real& scale) {
  static const Real of_bound(power_of_ten(-digits_of_bound));
  static const Real of_scale(power_of_ten(-digits_of_scale));
  const Real allowed = number.bound * of_bound + scale * of_scale;
  const Real difference = abs(number.value - truth);
  return difference.is_defined() && allowed.is_defined() && difference.value() <= allowed.value();
}

bool agrees_with_oracle(const Measured& number, const cln::cl_R& truth, const Real& scale,
                        OracleCache& oracle) {
  if (agrees(number, Real(truth), scale)) return true;
  const Real own = scale + Real(oracle.energy());
  return agrees(number, Real(truth), own) ||
         agrees(number, Real(truth), own + Real(oracle.force())) ||
         agrees(number, Real(truth), own + Real(oracle.inertia())) ||
         agrees(number, Real(truth), own + Real(oracle.motion()));
}

std::string short_text(const Real& value) {
  return value.is_defined() ? short_text(value.value()) : "undefined";
}

}  // namespace elgen
