// The figure of a balance. One scale for all entries: an entry that is zero on paper has terms of
// rounding alone.
#include "verify/structure/balance.hpp"

namespace elgen {

Real largest_magnitude(const std::vector<Real>& values) {
  Real largest;
  for (const Real& value : values) largest = max(largest, abs(value));
  return largest;
}

std::optional<double> Balance::figure(const Real& floor) const {
  const Real difference = largest_magnitude(sums_);
  const Real scale = largest_magnitude(sizes_) + floor;
  if (!difference.is_defined() || !scale.is_defined()) return std::nullopt;
  if (cln::zerop(difference.value())) return 0.0;
  const Real quotient = difference / scale;
  if (!quotient.is_defined()) return std::nullopt;
  return ScalarTraits<double>::from_real(quotient.value());
}

}  // namespace elgen
