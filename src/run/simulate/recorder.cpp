// Recorder: adds the samples of a run, one by one, to its rows and drifts.
#include "run/simulate/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "run/simulate/start.hpp"
#include "run/steps/methods.hpp"

namespace elgen {
namespace {

/// dopri5 estimates the error of its embedded method of order 4, so most runs stay far within the
/// tolerance. In long steps the error may exceed the estimate, at most by this factor.
constexpr double energy_margin = 10;

/// Fractions of the energy scale, for steps of one length. A loss of 1 % is visible in a plot; a
/// run that loses 10 % no longer shows the motion of the system.
constexpr double reported_loss = 0.01;
constexpr double refused_loss = 0.1;

/// A fraction of the energy scale: E is a sum of about a thousand rounded terms, each with an error
/// of 2e-16. Near rest, E changes only by rounding errors.
constexpr double rounding_share = 1e-12;

bool is_finite(const Numbers& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace

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

Recorder::Recorder(SimulatedSystem& system, const SimulationOptions& options,
                   const TrajectorySample& start)
    : system_(system),
      options_(options),
      momenta_at_start_(system.velocity_count()),
      momenta_(system.velocity_count()),
      conserved_(system.conserved_quantities()),
      tolerance_(options.step ? 0 : options.tolerance.value_or(default_tolerance)),
      momentum_drifts_(system.cyclic_velocities().size()),
      start_(start),
      last_(start) {
  const double* const q = start.state.data();
  energy_at_start_ = system.energy(q, system.v_of(start.state), start.t);
  system.find_momentum(q, system.v_of(start.state), start.t, momenta_at_start_.data());
  const Numbers& values = system.conserved_values(q, system.v_of(start.state), start.t);
  for (std::size_t i = 0; i < values.size(); ++i) conserved_[i].start = values[i];
}

Diagnostics Recorder::add_sample(const TrajectorySample& sample) {
  const double* const q = sample.state.data();
  const double* const v = system_.v_of(sample.state);
  const double energy = system_.energy(q, v, sample.t);
  if (!is_finite(sample.state) || !std::isfinite(energy)) {
    return {run_end_error("the numbers are no longer finite", "", default_hint)};
  }
  const double part = (sample.t - options_.from) / options_.duration;
  const double deviation = energy - energy_at_start_ - sample.state.back();
  const EnergyParts parts = system_.energy_parts(q, v, sample.t);
  energy_.add(part, sample.time_since_last, deviation, parts.magnitude());
  largest_kinetic_ = std::max(largest_kinetic_, std::abs(parts.kinetic));
  lowest_potential_ = std::min(lowest_potential_, parts.potential);
  highest_potential_ = std::max(highest_potential_, parts.potential);
  if (tolerance_ > 0 && warnings_.empty()) check_energy_step(sample, energy);
  if (!momentum_drifts_.empty()) update_momentum_drifts(sample, part);
  update_conserved_drifts(sample);
  update_constraint_offset(sample);
  if (sample.is_row) {
    rows_.push_back(make_row(sample, energy));
    work_.push_back(sample.state.back());
  }
  last_ = sample;
  return {};
}

Diagnostic Recorder::run_end_error(std::string_view why, std::string_view besides,
                                   std::string_view remedy) const {
  return {Code::E624,
          {},
          fmt::format("{} after t = {:.6g}, where {}{}", why, last_.t,
                      system_.state_text(last_.state), besides),
          std::string(remedy)};
}

Diagnostics Recorder::move_results(Trajectory& trajectory) && {
  const double* const q = last_.state.data();
  trajectory.last = make_row(last_, system_.energy(q, system_.v_of(last_.state), last_.t));
  trajectory.rows = std::move(rows_);
  if (system_.does_work()) trajectory.work = std::move(work_);
  trajectory.energy = energy_.drift(std::string(energy_name()),
                                    system_.has_separate_energies() ? "|T| + |V|" : "|v.p| + |L|");
  for (std::size_t i = 0; i < momentum_drifts_.size(); ++i) {
    const std::string& name = system_.leaves().v[system_.cyclic_velocities()[i]];
    trajectory.momenta.push_back(momentum_drifts_[i].drift(name, "sum |M v|"));
  }
  trajectory.conserved = std::move(conserved_);
  if (!system_.model().constraints.empty()) trajectory.constraints.emplace().largest = offset_;
  if (tolerance_ == 0) {
    check_energy_drift(trajectory);
    check_conserved_drift(trajectory.conserved);
  }
  return std::move(warnings_);
}

double Recorder::energy_scale() const {
  if (!system_.has_separate_energies()) return energy_.scale();
  return largest_kinetic_ + (highest_potential_ - lowest_potential_);
}

/// E648 if the drift exceeds 1 % of the energy scale. With a symmetric method the energy
/// oscillates; then the drift is the mean of the last tenth of the run minus the mean of the first
/// tenth.
void Recorder::check_energy_drift(Trajectory& trajectory) {
  const Drift& drift = trajectory.energy;
  const bool is_symmetric = step_for_run(options_).has_value();
  const double lost = (is_symmetric ? std::abs(drift.secular) : drift.worst) * drift.scale;
  const double scale = energy_scale();
  if (!(lost > reported_loss * scale) || lost <= rounding_share * energy_.scale()) return;
  trajectory.loses_energy = lost > refused_loss * scale;
  const std::string_view measure = system_.has_separate_energies()
                                       ? "the largest |T| plus the range of V"
                                       : "the largest |v.p| + |L|";
  warnings_.push_back({Code::E648,
                       {},
                       fmt::format("{} {} {:.1e}, {:.3g} % of {}, {:.6g}", drift.name,
                                   is_symmetric ? "drifts by" : "deviates by up to", lost,
                                   100 * lost / scale, measure, scale),
                       "check with a shorter `--step`, or with `--method dopri5` and no `--step`"});
}

void Recorder::check_conserved_drift(const std::vector<ConservedDrift>& conserved) {
  Numbers scales = conserved_scales(start_);
  const Numbers last = conserved_scales(last_);
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const ConservedDrift& entry = conserved[i];
    const double scale = std::max(scales[i], last[i]);
    if (!(entry.drift > reported_loss * scale) ||
        !is_visible_change(entry.start, entry.start + entry.drift))
      continue;
    warnings_.push_back(
        {Code::E648,
         {},
         fmt::format("`{}` of `conserved` deviates by up to {:.1e} from its start value, {:.6g}",
                     entry.text, entry.drift, entry.start),
         "check with a shorter `--step`; inputs may change it"});
  }
}

/// sum |dC/dx| |x| over q and v: a scale of C that is not small even if the terms of C cancel.
Numbers Recorder::conserved_scales(const TrajectorySample& sample) const {
  Numbers state = sample.state;
  const auto values = [&] {
    return system_.conserved_values(state.data(), system_.v_of(state), sample.t);
  };
  const Numbers here = values();
  Numbers scales(here.size());
  for (std::size_t i = 0; i + 1 < state.size(); ++i) {
    state[i] *= 1 + reported_loss;
    const Numbers moved = values();
    for (std::size_t k = 0; k < here.size(); ++k) {
      scales[k] += std::abs(moved[k] - here[k]) / reported_loss;
    }
    state[i] = sample.state[i];
  }
  return scales;
}

std::string_view Recorder::energy_name() const {
  return system_.does_work() ? "E - E0 - work" : "E - E0";
}

/// Adds to `allowed_energy_error_` the change of E - work that this step may cause: by the error of
/// each number, and by the rounding error of E. Later steps do not enlarge this change, because the
/// exact motion conserves E - work. E648 if |E - E0 - work| exceeds `allowed_energy_error_`.
void Recorder::check_energy_step(const TrajectorySample& sample, double energy) {
  const std::size_t work = sample.state.size() - 1;
  const auto error = [&](std::size_t i) {
    const double x = sample.state[i];
    return energy_margin * tolerance_ * (1 + std::abs(x) + std::abs(x - last_.state[i]));
  };
  allowed_energy_error_ += energy_margin * std::numeric_limits<double>::epsilon() * energy_.scale();
  if (system_.does_work()) allowed_energy_error_ += error(work);
  Numbers moved = sample.state;
  for (std::size_t i = 0; i < work; ++i) {
    moved[i] += error(i);
    allowed_energy_error_ +=
        std::abs(system_.energy(moved.data(), system_.v_of(moved), sample.t) - energy);
    moved[i] = sample.state[i];
  }
  const double deviation = energy - energy_at_start_ - sample.state[work];
  if (!(std::abs(deviation) > allowed_energy_error_)) return;
  warnings_.push_back(
      {Code::E648,
       {},
       fmt::format("{} is {:.1e} at t = {:.6g}, beyond the {:.1e} that the tolerance of the steps "
                   "allows",
                   energy_name(), deviation, sample.t, allowed_energy_error_),
       "check with a smaller `--tolerance`, or with a short `--step`"});
}

std::vector<double> Recorder::make_row(const TrajectorySample& sample, double energy) const {
  std::vector<double> values{sample.t};
  const double* const q = sample.state.data();
  const double* const v = system_.v_of(sample.state);
  const Numbers& shown = system_.displayed_position(q);
  values.insert(values.end(), shown.begin(), shown.end());
  values.insert(values.end(), v, &sample.state.back());
  const std::vector<InputLaw>& laws = system_.laws();
  for (std::size_t k = 0; k < laws.size(); ++k) {
    if (laws[k].expression) values.push_back(sample.inputs[k]);
  }
  const auto multipliers = system_.multipliers(q, v, sample.t, sample.inputs);
  values.insert(values.end(), multipliers.begin(), multipliers.end());
  for (const Point& point : system_.model().points) {
    if (point.name != options_.path) continue;
    values.push_back(system_.value(point.position[0], q, v, sample.t));
    values.push_back(system_.value(point.position[1], q, v, sample.t));
  }
  values.push_back(energy);
  return values;
}

void Recorder::update_momentum_drifts(const TrajectorySample& sample, double part) {
  const double* const q = sample.state.data();
  const double* const v = system_.v_of(sample.state);
  system_.find_momentum(q, v, sample.t, momenta_.data());
  const Numbers& scales = system_.momentum_scales(q, v, sample.t);
  for (std::size_t i = 0; i < momentum_drifts_.size(); ++i) {
    const std::uint32_t place = system_.cyclic_velocities()[i];
    momentum_drifts_[i].add(part, sample.time_since_last,
                            momenta_[place] - momenta_at_start_[place],
                            std::max(std::abs(momenta_[place]), scales[place]));
  }
}

void Recorder::update_conserved_drifts(const TrajectorySample& sample) {
  const Numbers& values =
      system_.conserved_values(sample.state.data(), system_.v_of(sample.state), sample.t);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ConservedDrift& quantity = conserved_[i];
    quantity.drift = std::max(quantity.drift, std::abs(values[i] - quantity.start));
  }
}

void Recorder::update_constraint_offset(const TrajectorySample& sample) {
  const ConstraintViolation offset =
      system_.constraint_offset(sample.state.data(), system_.v_of(sample.state), sample.t);
  offset_.position = std::max(offset_.position, offset.position);
  offset_.rate = std::max(offset_.rate, offset.rate);
}

}  // namespace elgen
