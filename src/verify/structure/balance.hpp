// Balance: sums that have to vanish, one per entry, judged against the size of their terms.
#pragma once

#include <optional>
#include <vector>

#include "elgen/evaluate.hpp"

namespace elgen {

class Balance {
 public:
  explicit Balance(std::size_t entries) : sums_(entries), sizes_(entries) {}

  void add(std::size_t entry, const Real& term) {
    sums_[entry] = sums_[entry] + term;
    sizes_[entry] = sizes_[entry] + abs(term);
  }

  /// max |sum| / (max sum of |terms| + floor); none where a term is undefined. `floor` is the size
  /// below which terms are rounding of something bigger.
  [[nodiscard]] std::optional<double> figure(const Real& floor) const;

 private:
  std::vector<Real> sums_;
  std::vector<Real> sizes_;
};

/// The largest magnitude; undefined where one of them is.
[[nodiscard]] Real largest_magnitude(const std::vector<Real>& values);

}  // namespace elgen
