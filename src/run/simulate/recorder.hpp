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

/// The drift of a quantity that should be constant, computed in one pass over a run: the largest
/// deviation, and the mean deviation in the last tenth minus the mean deviation in the first tenth.
class DriftMeter {
 public:
  /// Adds the `deviation` after the fraction `part` of the run. `weight`: the length of the step in
  /// time; `magnitude`: the size of the quantity.
  void add(double part, double weight, double deviation, double magnitude);

  /// The largest magnitude so far.
  [[nodiscard]] double scale() const { return scale_; }

  /// The drift divided by the largest magnitude; undivided if the largest magnitude is 0.
  [[nodiscard]] Drift drift(std::string name, std::string measure) const;

 private:
  double worst_ = 0;
  double scale_ = 0;
  WeightedMean first_tenth_ = {};
  WeightedMean last_tenth_ = {};
};

/// A state (q, v, work) of a run, and the inputs at this state.
struct TrajectorySample {
  double t = 0;
  double time_since_last = 0;  ///< time since the previous sample
  bool is_row = false;
  Numbers state = {};
  Numbers inputs = {};
};

class Recorder {
 public:
  Recorder(SimulatedSystem& system, const SimulationOptions& options,
           const TrajectorySample& start);

  /// Adds a sample. E624 if a number is not finite; the error names the last finite state.
  [[nodiscard]] Diagnostics add_sample(const TrajectorySample& sample);

  /// E624 at the last sample: `why` the run ends, then the additional observation `besides`; the
  /// hint is `remedy`.
  [[nodiscard]] Diagnostic run_end_error(std::string_view why, std::string_view besides,
                                         std::string_view remedy) const;

  /// Moves the rows and drifts into `trajectory`. Returns the warnings E648: with adapted steps, if
  /// |E - E0 - work| exceeds `allowed_energy_error_`; with steps of one length, if E - E0 - work or
  /// an entry of `conserved` drifts by more than 1 % of its scale.
  Diagnostics move_results(Trajectory& trajectory) &&;

 private:
  /// The numbers of a row. Multipliers are computed for sample.inputs, because `system_` may hold
  /// later inputs.
  [[nodiscard]] std::vector<double> make_row(const TrajectorySample& sample, double energy) const;
  [[nodiscard]] std::string_view energy_name() const;
  void check_energy_step(const TrajectorySample& sample, double energy);
  void update_momentum_drifts(const TrajectorySample& sample, double part);
  void update_conserved_drifts(const TrajectorySample& sample);
  void update_constraint_offset(const TrajectorySample& sample);
  /// max |T| + (max V - min V) so far; if only L is known, max (|v.p| + |L|).
  [[nodiscard]] double energy_scale() const;
  void check_energy_drift(Trajectory& trajectory);
  void check_conserved_drift(const std::vector<ConservedDrift>& conserved);
  [[nodiscard]] Numbers conserved_scales(const TrajectorySample& sample) const;

  SimulatedSystem& system_;
  const SimulationOptions& options_;
  double energy_at_start_ = 0;
  Numbers momenta_at_start_;
  Numbers momenta_;
  std::vector<ConservedDrift> conserved_;
  ConstraintViolation offset_ = {};
  DriftMeter energy_ = {};
  double largest_kinetic_ = 0;
  double lowest_potential_ = std::numeric_limits<double>::infinity();
  double highest_potential_ = -std::numeric_limits<double>::infinity();
  double tolerance_ = 0;             ///< of adapted steps; 0 for steps of one length
  double allowed_energy_error_ = 0;  ///< largest |E - E0 - work| within the tolerance of the steps
  Diagnostics warnings_ = {};
  std::vector<DriftMeter> momentum_drifts_;
  std::vector<std::vector<double>> rows_ = {};
  std::vector<double> work_ = {};  ///< the work up to each row
  TrajectorySample start_;
  TrajectorySample last_;
};

}  // namespace elgen
