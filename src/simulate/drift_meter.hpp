// DriftMeter: how far a number goes that should stay, in one pass over a run.
#pragma once

#include <string>

#include "elgen/simulate.hpp"

namespace elgen {

/// A mean of numbers with weights.
class WeightedMean {
 public:
  void add(double value, double weight) {
    sum_ += value * weight;
    weight_ += weight;
  }
  [[nodiscard]] double value() const { return weight_ > 0 ? sum_ / weight_ : 0; }

 private:
  double sum_ = 0;
  double weight_ = 0;
};

class DriftMeter {
 public:
  /// `deviation` at `part` of the run (0 to 1), for the time `weight`; `magnitude` is that of what
  /// deviates.
  void add(double part, double weight, double deviation, double magnitude);

  /// Relative to the largest magnitude, or absolute where that is 0.
  [[nodiscard]] Drift drift(std::string name, std::string measure) const;

 private:
  double worst_ = 0;
  double scale_ = 0;
  WeightedMean first_tenth_ = {};
  WeightedMean last_tenth_ = {};
};

}  // namespace elgen
