// ExactValues: every function of a program at one state in 64 digits, with directional derivatives.
// ResidualSums: sums that must vanish, relative to the size of their terms.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "numbers/dual.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

class ExactValues {
 public:
  ExactValues(const SystemUnderTest& subject, State state);

  [[nodiscard]] const SystemUnderTest& subject() const { return subject_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const Arguments<Real>& arguments() const { return arguments_; }
  [[nodiscard]] std::size_t size() const { return state_.v.size(); }

  /// The entries of a function of the program, or the oracle's entries if the program does not have
  /// the function. Entries without a value are undefined.
  [[nodiscard]] const std::vector<Real>& entries(OutputKind kind, std::uint32_t user = 0);

  /// The entries of the program's function at other arguments.
  [[nodiscard]] std::vector<Real> entries_at(OutputKind kind,
                                             const Arguments<Real>& arguments) const;

  /// Directional derivatives of the program's entries. Values of functions without expression
  /// change with their arguments, by the chain rule; the second derivatives of these functions are
  /// held constant.
  [[nodiscard]] std::vector<Real> directional_derivatives(OutputKind kind,
                                                          const Arguments<Real>& direction,
                                                          std::uint32_t user = 0) const;

  /// d2/ds2 of the program's entries at (arguments + s `direction`), for s = 0.
  [[nodiscard]] std::vector<Real> second_derivatives(OutputKind kind,
                                                     const Arguments<Real>& direction,
                                                     std::uint32_t user = 0) const;

  /// The direction of differentiation with all components 0.
  [[nodiscard]] Arguments<Real> zero_direction() const;

  /// dq/dt with these velocities: N(q) v.
  [[nodiscard]] std::vector<Real> coordinate_rates(const std::vector<Real>& v) const;

  /// d2q/dt2 if the velocities of the state stay constant: 0 except for quaternions.
  [[nodiscard]] std::vector<Real> coasting_accelerations() const;

  /// 1e-20 times the largest intermediate value; smaller differences are rounding errors.
  [[nodiscard]] Real rounding_floor() const { return rounding_floor_; }

 private:
  [[nodiscard]] Arguments<Real> add_open_value_rates(Arguments<Real> direction) const;

  SystemUnderTest subject_;
  State state_;
  Arguments<Real> arguments_;
  std::map<std::pair<OutputKind, std::uint32_t>, std::vector<Real>> values_ = {};
  Real rounding_floor_ = {};
};

/// Sums that must vanish, one per entry, relative to the size of their terms. All entries share one
/// scale, because the terms of an entry that is exactly zero are mere rounding errors.
class ResidualSums {
 public:
  explicit ResidualSums(std::size_t entries) : sums_(entries), sizes_(entries) {}

  void add(std::size_t entry, const Real& term) {
    sums_[entry] = sums_[entry] + term;
    sizes_[entry] = sizes_[entry] + abs(term);
  }

  /// max |sum| / (max over entries of the sum of |terms| + floor); none if a term is undefined.
  /// Terms below `floor` are rounding errors of larger values.
  [[nodiscard]] std::optional<double> relative_residual(const Real& floor) const;

 private:
  std::vector<Real> sums_;
  std::vector<Real> sizes_;
};

}  // namespace elgen
