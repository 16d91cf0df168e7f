// SPDX-License-Identifier: GPL-3.0-or-later
// Recorder: what is kept of a run: rows, and the drifts of what should stay.
#pragma once

#include <string>

#include "elgen/simulate.hpp"
#include "simulate/steps/system.hpp"

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

/// How far a number goes that should stay, in one pass over a run: the worst deviation, and the
/// means of the first and the last tenth.
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

/// A state that was reached, q, v and work, and the inputs there.
struct TrajectorySample {
  double t = 0;
  double after = 0;  ///< time since the sample before
  bool is_row = false;
  Numbers state = {};
  Numbers inputs = {};
};

class Recorder {
 public:
  Recorder(System& system, const SimulationOptions& options, const TrajectorySample& start);

  /// E624 where a number is not finite, with the last state that was.
  [[nodiscard]] Diagnostics add(const TrajectorySample& sample);

  /// Why the run ends at the last sample.
  [[nodiscard]] Diagnostic ended(std::string_view why) const;

  /// Puts the rows that were kept into `trajectory`.
  void finish(Trajectory& trajectory) &&;

 private:
  [[nodiscard]] std::vector<double> row(const TrajectorySample& sample, double energy) const;
  void add_momenta(const TrajectorySample& sample, double part);
  void add_conserved(const TrajectorySample& sample);
  void add_offset(const TrajectorySample& sample);

  System& system_;
  const SimulationOptions& options_;
  double energy_at_start_ = 0;
  Numbers momenta_at_start_;
  Numbers momenta_;
  std::vector<ConservedDrift> conserved_;
  ConstraintOffset offset_ = {};
  DriftMeter energy_ = {};
  std::vector<DriftMeter> of_momenta_;
  std::vector<std::vector<double>> rows_ = {};
  std::vector<double> work_ = {};  ///< until each
  TrajectorySample last_;
};

}  // namespace elgen
