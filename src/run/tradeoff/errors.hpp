// Errors of one state, and what they are relative to.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "elgen/tradeoff.hpp"

namespace elgen {

/// The largest |x*| of each field at the states of a trade-off.
class FieldScales {
 public:
  explicit FieldScales(const TradeoffStates& states);

  /// Over the fields: the largest apart(k) = |x - x*| / the largest |x*| of the field at the states
  /// and here, of(k) = x*. Where both are 0 everywhere, any distance is infinitely far.
  template <class Apart, class Of>
  [[nodiscard]] double error(const Apart& apart, const Of& of) const {
    double worst = 0;
    std::size_t k = 0;
    for (const Scale& field : fields_) {
      double largest = field.largest;
      double farthest = 0;
      for (const std::size_t end = k + field.entries; k < end; ++k) {
        const double here = apart(k);
        if (std::isnan(here)) return std::numeric_limits<double>::infinity();
        farthest = std::max(farthest, here);
        largest = std::max(largest, std::abs(of(k)));
      }
      if (farthest > 0) worst = std::max(worst, farthest / largest);
    }
    return worst;
  }

 private:
  struct Scale {
    std::size_t entries = 0;
    double largest = 0;
  };
  std::vector<Scale> fields_ = {};
};

/// |value - exact|
[[nodiscard]] double distance_to(double value, const ExactNumber& exact);

/// The entries of the first function at the numbers of a state and the exact parameters, in 60
/// digits; none where one of them has no value.
[[nodiscard]] std::optional<std::vector<ExactNumber>> exact_entries(const CheckedModel& checked,
                                                                    const Program& program,
                                                                    const Arguments<double>& state);

}  // namespace elgen
