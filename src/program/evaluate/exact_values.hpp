// ExactValues: every function of a program at one state in 64 digits, and derivatives along
// directions. Balance: sums of them that have to vanish.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "numbers/dual.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

class ExactValues {
 public:
  ExactValues(const Subject& subject, State state);

  [[nodiscard]] const Subject& subject() const { return subject_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const Arguments<Real>& arguments() const { return arguments_; }
  [[nodiscard]] std::size_t size() const { return state_.v.size(); }

  /// The program's entries, or the oracle's where the program has no such function; undefined
  /// entries where neither has a value.
  [[nodiscard]] const std::vector<Real>& value(OutputKind kind, std::uint32_t user = 0);

  /// The entries of a function of the program at other arguments.
  [[nodiscard]] std::vector<Real> value_at(OutputKind kind, const Arguments<Real>& arguments) const;

  /// Derivatives of the program's entries along a direction; open values move as their arguments
  /// do, those of second derivatives not at all.
  [[nodiscard]] std::vector<Real> slopes(OutputKind kind, const Arguments<Real>& direction,
                                         std::uint32_t user = 0) const;

  /// Second derivatives along a direction.
  [[nodiscard]] std::vector<Real> curvatures(OutputKind kind, const Arguments<Real>& direction,
                                             std::uint32_t user = 0) const;

  /// A direction that moves nothing.
  [[nodiscard]] Arguments<Real> at_rest() const;

  /// dq/dt with these velocities: N(q) v.
  [[nodiscard]] std::vector<Real> coordinate_rates(const std::vector<Real>& v) const;

  /// d2q/dt2 with the state's velocities, where they do not change: 0 but for quaternions.
  [[nodiscard]] std::vector<Real> coasting_accelerations() const;

  /// The bound below which differences are rounding: 1e-20 of the largest intermediate.
  [[nodiscard]] Real floor() const { return floor_; }

 private:
  [[nodiscard]] Arguments<Real> with_open_values(Arguments<Real> direction) const;

  Subject subject_;
  State state_;
  Arguments<Real> arguments_;
  std::map<std::pair<OutputKind, std::uint32_t>, std::vector<Real>> values_ = {};
  Real floor_ = {};
};

/// Sums that have to vanish, one per entry, judged against the size of their terms. One scale for
/// all entries: an entry that is zero on paper has terms of rounding alone.
class Balance {
 public:
  explicit Balance(std::size_t entries) : sums_(entries), sizes_(entries) {}

  void add(std::size_t entry, const Real& term) {
    sums_[entry] = sums_[entry] + term;
    sizes_[entry] = sizes_[entry] + abs(term);
  }

  /// max |sum| / (max sum of |terms| + floor); none where a term is undefined. `floor` is the size
  /// below which terms are rounding of something bigger.
  [[nodiscard]] std::optional<double> figure(const Real& floor) const;

 private:
  std::vector<Real> sums_;
  std::vector<Real> sizes_;
};

}  // namespace elgen
