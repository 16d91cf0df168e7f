// OracleCache: the oracle's values at one state, each output computed once, and when an exact
// number of the program is the oracle's.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/running_errors.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

class OracleCache {
 public:
  OracleCache(const Subject& subject, State state) : subject_(subject), state_(std::move(state)) {}

  [[nodiscard]] const State& state() const { return state_; }

  [[nodiscard]] const OracleValues& values(const OutputRequest& request);

  /// The diagonal of M; an entry without a value is 0.
  [[nodiscard]] const std::vector<cln::cl_R>& diagonal_of_mass();

  /// |E| and the magnitudes of V's terms, in whose rounding most of the oracle's zeros drown; 0
  /// where E is undefined.
  [[nodiscard]] const cln::cl_R& energy();

  /// The energy, and what other zeros of the oracle drown in, each 0 where it has no value:
  ///
  ///     |force| of the motion    differences of forces (drift), where that is larger than |E|
  ///     |M| (|v| + |a|)          derivatives of inertial forces where M does not depend on q
  ///     |v|^2 + |a|              accelerations of points and frames, also without energies
  [[nodiscard]] const cln::cl_R& drowning();

 private:
  const Subject& subject_;
  State state_;
  std::map<std::pair<OutputKind, std::uint32_t>, OracleValues> known_ = {};
  std::optional<std::vector<cln::cl_R>> diagonal_ = {};
  std::optional<cln::cl_R> energy_ = {};
  std::optional<cln::cl_R> drowning_ = {};

  [[nodiscard]] cln::cl_R force();
  [[nodiscard]] cln::cl_R inertia();
};

/// To 50 digits of E + |truth|, or 52 of `drowning`: a number that is zero on paper has no E worth
/// the name. An undefined number agrees with none.
[[nodiscard]] bool agrees(const Running<Real>& number, const Real& truth, const Real& drowning);

/// Likewise, with nothing for `drowning`, the oracle's energy, or all of its own.
[[nodiscard]] bool agrees_with_oracle(const Running<Real>& number, const cln::cl_R& truth,
                                      OracleCache& oracle);

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
