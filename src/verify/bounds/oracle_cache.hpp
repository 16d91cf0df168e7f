// OracleCache: the oracle's values at one state, each output computed once. agrees() decides if an
// exact value of the program equals the oracle's.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/running_errors.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

class OracleCache {
 public:
  OracleCache(const SystemUnderTest& subject, State state)
      : subject_(subject), state_(std::move(state)) {}

  [[nodiscard]] const State& state() const { return state_; }

  [[nodiscard]] const OracleValues& values(const OutputRequest& request);

  /// oracle_contraction() at the state. The fields of an output share entries that it computes.
  [[nodiscard]] std::optional<cln::cl_R> contraction(const OutputRequest& request,
                                                     const Contraction& by);

  /// M from a function of the program or from an unrequested function, at less cost than M from the
  /// energies: from the mass matrix or from inverse dynamics. None without these functions, if w.M
  /// y differs from the oracle's, or if is_solved_by_oracle().
  [[nodiscard]] const OracleValues& mass_of_program();

  /// The diagonal of M, in double if a function gives M; 0 for an undefined entry. Only weights of
  /// losses use it.
  [[nodiscard]] const std::vector<cln::cl_R>& diagonal_of_mass();

  /// |E| plus the magnitudes of the terms of V; 0 if E is undefined. If an entry is 0 in exact
  /// arithmetic, the oracle's rounding error of this entry is usually below 1e-60 of this sum.
  [[nodiscard]] const cln::cl_R& energy_magnitude();

  /// The scale of the rounding errors of any value that is 0 in exact arithmetic:
  /// energy_magnitude() plus the following terms, each 0 if it is undefined:
  ///
  ///     |force| of the motion    differences of forces (drift), if larger than |E|
  ///     |M| (|v| + |a|)          derivatives of inertial forces if M does not depend on q
  ///     |v|^2 + |a|              accelerations of points and frames, also without energies
  [[nodiscard]] const cln::cl_R& rounding_scale();

  /// The largest of these scales that was needed; 0 if none was needed.
  [[nodiscard]] cln::cl_R used_scale() const;

 private:
  const SystemUnderTest& subject_;
  State state_;
  std::map<std::pair<OutputKind, std::uint32_t>, OracleValues> known_ = {};
  std::optional<OracleValues> mass_of_program_ = {};
  std::optional<std::vector<cln::cl_R>> diagonal_ = {};
  std::optional<cln::cl_R> energy_ = {};
  std::optional<cln::cl_R> rounding_scale_ = {};

  [[nodiscard]] cln::cl_R largest_force();
  [[nodiscard]] cln::cl_R largest_inertial_force();
};

/// True if the oracle's own solutions serve as reference: up to four velocities, or with
/// constraints.
[[nodiscard]] bool is_solved_by_oracle(const Model& model);

/// sum over i, j of w_i x_ij y_j, i below the size of w, j below the size of y; `entries`: x,
/// row-major. An empty y stands for y = 1.
[[nodiscard]] RunningValue<Real> contract(std::span<const RunningValue<Real>> entries,
                                          const Contraction& by);

/// True if |value - truth| <= 1e-50 (E + |truth|) + 1e-52 `scale`, E = number.error. `scale` is the
/// scale of rounding errors of values that are exactly 0; E of such a value is too small. False if
/// the number is undefined.
[[nodiscard]] bool agrees(const RunningValue<Real>& number, const Real& truth, const Real& scale);

/// True if agrees() is true for one of three scales: 0, energy_magnitude() or rounding_scale().
[[nodiscard]] bool agrees_with_oracle(const RunningValue<Real>& number, const cln::cl_R& truth,
                                      OracleCache& oracle);

/// A difference between two exact numbers, in words; the text is empty if they agree.
struct Mismatch {
  std::string text = {};
  Real value = {};  ///< of the program
  Real truth = {};
};

/// True if a run with more digits changed each of both numbers by at most 1e-50 of the sum of their
/// magnitudes.
[[nodiscard]] bool is_stable_mismatch(const Mismatch& before, const Mismatch& now);

/// "1.5", or "undefined".
[[nodiscard]] std::string short_text(const Real& value);

}  // namespace elgen
