// OracleCache: the oracle's values at one state, each output computed once, and when an exact
// number of the program is the oracle's.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "program/evaluate/subject.hpp"

namespace elgen {

class OracleCache {
 public:
  OracleCache(const Subject& subject, State state) : subject_(subject), state_(std::move(state)) {}

  [[nodiscard]] const State& state() const { return state_; }

  [[nodiscard]] const OracleValues& values(const OutputRequest& request);

  /// |E| and the magnitudes of V's terms, in whose rounding entries that are zero on paper drown; 0
  /// where E is undefined.
  [[nodiscard]] const cln::cl_R& energy();

  /// The largest generalized force of the motion, in whose rounding the oracle's differences of
  /// forces (drift) drown where that is larger than |E|.
  [[nodiscard]] cln::cl_R force();

  /// |M| (|v| + |a|) of the largest entries: what derivatives of inertial forces are rounding of
  /// where M does not depend on q, however slow the motion is.
  [[nodiscard]] cln::cl_R inertia();

  /// |v|^2 + |a| of the largest entries: what accelerations of points and frames are rounding of,
  /// also where energies and forces have no value.
  [[nodiscard]] cln::cl_R motion() const;

  /// Whether the oracle's solution of M a = b is known to 50 digits. It is solved in 95, entry i of
  /// a with an error of 1e-95 F/(d_i M_ii), where F is the largest force and d_i the relative
  /// pivot: near a singular chart, where constraints almost depend on each other, and where large
  /// forces cancel to almost nothing, less is left.
  [[nodiscard]] bool solves();

 private:
  const Subject& subject_;
  State state_;
  std::map<std::pair<OutputKind, std::uint32_t>, OracleValues> known_ = {};
  std::optional<cln::cl_R> energy_ = {};
  std::optional<bool> solves_ = {};

  [[nodiscard]] bool solution_is_known();
};

/// A number in 64 digits with the B of its error bound.
struct Measured {
  Real value = {};
  Real bound = {};
};

/// To 50 digits of the bound. A number that is zero on paper has no bound worth the name: it is
/// rounding of `scale`, the largest magnitude met on the way. An undefined number agrees with none.
[[nodiscard]] bool agrees(const Measured& number, const Real& truth, const Real& scale);

/// The scale grows by what the oracle's own rounding is of: where the entry's does not do, by the
/// energy, and where that is not enough, by the forces, by the inertia, or by the motion.
[[nodiscard]] bool agrees_with_oracle(const Measured& number, const cln::cl_R& truth,
                                      const Real& scale, OracleCache& oracle);

/// Two exact numbers that should be one, in words; no words where they agree.
struct Mismatch {
  std::string text = {};
  Real value = {};  ///< of the program
  Real truth = {};
};

/// Whether more digits changed neither number by more than 1e-50 of the larger one.
[[nodiscard]] bool is_settled(const Mismatch& before, const Mismatch& now);

/// "1.5", or "undefined".
[[nodiscard]] std::string short_text(const Real& value);

}  // namespace elgen
