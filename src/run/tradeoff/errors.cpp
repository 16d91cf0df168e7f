// state_errors: the error of a design at each state. combine_errors: the errors of a design from
// several samples of states.
#include "run/tradeoff/errors.hpp"

#include <algorithm>
#include <cmath>

namespace elgen {

FieldScales::FieldScales(const TradeoffStates& states) : field_sizes_(states.field_sizes) {
  for (std::size_t i = 0; i < states.exact.size(); ++i) {
    std::vector<double>& scales = scales_[states.states[i].parameters];
    scales.resize(field_sizes_.size());
    std::size_t k = 0;
    for (std::size_t f = 0; f < scales.size(); ++f) {
      for (const std::size_t end = k + field_sizes_[f]; k < end; ++k) {
        scales[f] = std::max(scales[f], magnitude(states.exact[i][k]));
      }
    }
  }
}

std::vector<double> state_errors(const std::vector<double>& results, const TradeoffStates& states) {
  const FieldScales scales(states);
  const std::size_t count = states.states.size();
  std::vector<double> errors;
  for (std::size_t i = 0; i < count; ++i) {
    errors.push_back(scales.error(states.states[i], results.data() + i, count, states.exact[i]));
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
