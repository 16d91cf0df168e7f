// The error of a design at one state, and the scale to which the error is relative. x is a value of
// the design, x* the exact value.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "elgen/tradeoff.hpp"

namespace elgen {

/// distance(): |value - exact|; magnitude(): |exact|.
[[nodiscard]] inline double distance(double value, const TwoDoubleNumber& exact) {
  return std::abs(value - exact.high - exact.low);
}
[[nodiscard]] inline double distance(double value, long double exact) {
  return static_cast<double>(std::abs(value - exact));
}
[[nodiscard]] inline double magnitude(const TwoDoubleNumber& exact) { return std::abs(exact.high); }
[[nodiscard]] inline double magnitude(long double exact) {
  return std::abs(static_cast<double>(exact));
}

/// Sets leaf `number` of a kind.
inline void set_leaf(Arguments<double>& leaves, Opcode kind, std::uint32_t number, double value) {
  const auto visit = [&](Opcode each, std::uint32_t i, double& x) {
    if (each == kind && i == number) x = value;
  };
  for_each_leaf(visit, leaves);
}

/// The largest |x*| of each field at the states of a trade-off with the same parameters: systems
/// with other parameters have other magnitudes.
class FieldScales {
 public:
  explicit FieldScales(const TradeoffStates& states);

  /// The error at a state with the parameters of a state of the trade-off: the maximum over fields
  /// of (largest |x - x*|) / (largest |x*|). The largest |x*| of the field is over the trade-off's
  /// states with these parameters and this state. Entry k is values[k * stride]. Infinite if x is
  /// NaN, or if x* is always 0 but x is not.
  template <class Exact>
  [[nodiscard]] double error(const Arguments<double>& state, const double* values,
                             std::size_t stride, const std::vector<Exact>& exact) const {
    double worst = 0;
    std::size_t k = 0;
    const std::vector<double>& scales = scales_.at(state.parameters);
    for (std::size_t f = 0; f < scales.size(); ++f) {
      double largest = scales[f];
      double farthest = 0;
      for (const std::size_t end = k + field_sizes_[f]; k < end; ++k) {
        const double here = distance(values[k * stride], exact[k]);
        if (std::isnan(here)) return std::numeric_limits<double>::infinity();
        farthest = std::max(farthest, here);
        largest = std::max(largest, magnitude(exact[k]));
      }
      if (farthest > 0) worst = std::max(worst, farthest / largest);
    }
    return worst;
  }

 private:
  std::vector<std::size_t> field_sizes_;
  std::map<std::vector<double>, std::vector<double>> scales_ = {};  ///< by parameters and field
};

/// The entries of the program's first function in 60 digits. Parameters have their exact values,
/// varied parameters the values in `state`. None if an entry is undefined at the state.
[[nodiscard]] std::optional<std::vector<TwoDoubleNumber>> exact_entries(
    const CheckedModel& checked, const Program& program, const Arguments<double>& state);

}  // namespace elgen
