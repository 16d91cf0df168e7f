// Recorder: collects the rows of a run and the drifts of quantities that should be constant.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/simulate.hpp"
#include "run/steps/system.hpp"

namespace elgen {

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

/// The drift of a number that should be constant, in one pass over a run: the worst deviation, and
/// the means over the first and the last tenth.
class DriftMeter {
 public:
  /// `deviation` at the fraction `part` of the run, with the time `weight` as its weight.
  /// `magnitude` is the size of the quantity that deviates.
  void add(double part, double weight, double deviation, double magnitude);

  /// The largest magnitude so far.
  [[nodiscard]] double scale() const { return scale_; }

  /// Relative to the largest magnitude, or absolute if that is 0.
  [[nodiscard]] Drift drift(std::string name, std::string measure) const;

 private:
  double worst_ = 0;
  double scale_ = 0;
  WeightedMean first_tenth_ = {};
  WeightedMean last_tenth_ = {};
};

/// A state (q, v, work) that the run reached, and the inputs at it.
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

  /// E624 if a number is not finite; it names the last finite state.
  [[nodiscard]] Diagnostics add(const TrajectorySample& sample);

  /// E624 at the last sample, with the reason, a further observation, and the remedy.
  [[nodiscard]] Diagnostic end_diagnostic(std::string_view why, std::string_view besides,
                                          std::string_view remedy) const;

  /// Moves the rows into `trajectory`. E648 if E - E0 - work exceeds the tolerance of the steps.
  /// For steps of one length: if it, or an entry of `conserved`, exceeds 1 % of its scale.
  Diagnostics finish(Trajectory& trajectory) &&;

 private:
  /// Multipliers use the inputs of the sample, because the system may already hold later inputs.
  [[nodiscard]] std::vector<double> row(const TrajectorySample& sample, double energy) const;
  [[nodiscard]] std::string_view energy_name() const;
  void check_energy_step(const TrajectorySample& sample, double energy);
  void add_momenta(const TrajectorySample& sample, double part);
  void add_conserved(const TrajectorySample& sample);
  void add_offset(const TrajectorySample& sample);
  /// max |T| + (max V - min V) so far; max (|v.p| + |L|) if only L is known.
  [[nodiscard]] double energy_scale() const;
  void check_energy_drift(Trajectory& trajectory);
  void check_conserved_drift(const std::vector<ConservedDrift>& conserved);
  [[nodiscard]] Numbers conserved_scales(const TrajectorySample& sample) const;

  System& system_;
  const SimulationOptions& options_;
  double energy_at_start_ = 0;
  Numbers momenta_at_start_;
  Numbers momenta_;
  std::vector<ConservedDrift> conserved_;
  ConstraintOffset offset_ = {};
  DriftMeter energy_ = {};
  double largest_kinetic_ = 0;
  double lowest_potential_ = std::numeric_limits<double>::infinity();
  double highest_potential_ = -std::numeric_limits<double>::infinity();
  double tolerance_ = 0;  ///< of a step; 0 for steps of one length
  double allowed_ = 0;    ///< the largest |E - E0 - work| that the steps so far allow
  Diagnostics warnings_ = {};
  std::vector<DriftMeter> momentum_drifts_;
  std::vector<std::vector<double>> rows_ = {};
  std::vector<double> work_ = {};  ///< up to each row
  TrajectorySample start_;
  TrajectorySample last_;
};

}  // namespace elgen
