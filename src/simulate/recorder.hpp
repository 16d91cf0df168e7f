// Recorder: what is kept of a run: rows, and the drifts of what should stay.
#pragma once

#include "simulate/drift_meter.hpp"
#include "simulate/steps/system.hpp"

namespace elgen {

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

  /// What was kept, in `trajectory`.
  void finish(Trajectory& trajectory) &&;

 private:
  [[nodiscard]] std::vector<double> row(const TrajectorySample& sample, double energy) const;
  void add_momenta(const TrajectorySample& sample, double part);

  System& system_;
  const SimulationOptions& options_;
  double energy_at_start_ = 0;
  Numbers momenta_at_start_;
  Numbers momenta_;
  DriftMeter energy_ = {};
  std::vector<DriftMeter> of_momenta_;
  std::vector<std::vector<double>> rows_ = {};
  TrajectorySample last_;
};

}  // namespace elgen
