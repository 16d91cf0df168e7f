// The worst deviation, and the means of the first and the last tenth.
#include "simulate/drift_meter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace elgen {

void DriftMeter::add(double part, double weight, double deviation, double magnitude) {
  worst_ = std::max(worst_, std::abs(deviation));
  scale_ = std::max(scale_, magnitude);
  if (part <= 0.1) first_tenth_.add(deviation, weight);
  if (part >= 0.9) last_tenth_.add(deviation, weight);
}

Drift DriftMeter::drift(std::string name, std::string measure) const {
  const double scale = scale_ > 0 ? scale_ : 1;
  const double secular = last_tenth_.value() - first_tenth_.value();
  return {std::move(name), std::move(measure), worst_ / scale, secular / scale, scale};
}

}  // namespace elgen
