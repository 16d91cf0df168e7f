// state_errors: how far a design is off, field by field, relative to the largest value of the
// field.
#include "run/tradeoff/errors.hpp"

#include <algorithm>
#include <cmath>

namespace elgen {

FieldScales::FieldScales(const TradeoffStates& states) {
  const std::size_t count = states.states.size();
  std::size_t next = 0;
  for (const std::size_t entries : states.field_sizes) {
    double largest = 0;
    for (const std::size_t end = next + entries * count; next < end; ++next) {
      largest = std::max(largest, std::abs(states.exact[next].high));
    }
    fields_.push_back({entries, largest});
  }
}

double distance_to(double value, const ExactNumber& exact) {
  return std::abs(value - exact.high - exact.low);
}

std::vector<double> state_errors(const std::vector<double>& results, const TradeoffStates& states) {
  const FieldScales scales(states);
  const std::size_t count = states.states.size();
  std::vector<double> errors;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [i, count](std::size_t k) { return k * count + i; };
    errors.push_back(scales.error(
        [&](std::size_t k) { return distance_to(results[at(k)], states.exact[at(k)]); },
        [&](std::size_t k) { return states.exact[at(k)].high; }));
  }
  return errors;
}

}  // namespace elgen
