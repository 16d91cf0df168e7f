// state_errors: the error of a design at each state. combine_errors: the errors of a design from
// several samples of states.
#include "run/tradeoff/errors.hpp"

#include <algorithm>
#include <cmath>

namespace elgen {

FieldScales::FieldScales(const TradeoffStates& states) {
  std::size_t first = 0;
  for (const std::size_t entries : states.field_sizes) {
    Scale& field = fields_.emplace_back(Scale{entries});
    for (const std::vector<TwoDoubleNumber>& exact : states.exact) {
      for (std::size_t k = first; k < first + entries; ++k) {
        field.largest = std::max(field.largest, magnitude(exact[k]));
      }
    }
    first += entries;
  }
}

std::vector<double> state_errors(const std::vector<double>& results, const TradeoffStates& states) {
  const FieldScales scales(states);
  const std::size_t count = states.states.size();
  std::vector<double> errors;
  for (std::size_t i = 0; i < count; ++i) {
    errors.push_back(scales.error(results.data() + i, count, states.exact[i]));
  }
  return errors;
}

DesignErrors combine_errors(std::vector<FoundErrors> samples) {
  std::ranges::sort(samples, {}, &FoundErrors::median);
  DesignErrors errors{.median = samples[samples.size() / 2].median};
  std::ranges::sort(samples, {}, &FoundErrors::worst);
  errors.worst = search_margin * samples.back().worst;
  errors.least = search_margin * samples.front().worst;
  return errors;
}

}  // namespace elgen
