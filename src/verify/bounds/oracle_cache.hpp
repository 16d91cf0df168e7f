// OracleCache: the oracle's values at one state, each output computed once, and the rule by which
// an exact number of the program agrees with the oracle's.
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

  /// |E| and the magnitudes of V's terms: most zeros of the oracle are rounding errors of this
  /// size. 0 if E is undefined.
  [[nodiscard]] const cln::cl_R& energy();

  /// The size whose rounding errors hide any zero of the oracle: energy() plus these, each 0 if it
  /// has no value:
  ///
  ///     |force| of the motion    differences of forces (drift), if larger than |E|
  ///     |M| (|v| + |a|)          derivatives of inertial forces if M does not depend on q
  ///     |v|^2 + |a|              accelerations of points and frames, also without energies
  [[nodiscard]] const cln::cl_R& rounding_scale();

 private:
  const Subject& subject_;
  State state_;
  std::map<std::pair<OutputKind, std::uint32_t>, OracleValues> known_ = {};
  std::optional<std::vector<cln::cl_R>> diagonal_ = {};
  std::optional<cln::cl_R> energy_ = {};
  std::optional<cln::cl_R> rounding_scale_ = {};

  [[nodiscard]] cln::cl_R force();
  [[nodiscard]] cln::cl_R inertia();
};

/// |value - truth| <= 1e-50 (E + |truth|) + 1e-52 drowning. The last term serves numbers that are
/// exactly zero, whose E is too small. An undefined number never agrees.
[[nodiscard]] bool agrees(const Running<Real>& number, const Real& truth, const Real& drowning);

/// agrees() with 0, the oracle's energy() or its rounding_scale() as `rounding_scale`.
[[nodiscard]] bool agrees_with_oracle(const Running<Real>& number, const cln::cl_R& truth,
                                      OracleCache& oracle);

/// Two exact numbers that should be equal, described by a text; the text is empty if they agree.
struct Mismatch {
  std::string text = {};
  Real value = {};  ///< of the program
  Real truth = {};
};

/// True if more digits changed neither number by more than 1e-50 of the sum of both magnitudes.
[[nodiscard]] bool is_stable(const Mismatch& before, const Mismatch& now);

/// "1.5", or "undefined".
[[nodiscard]] std::string short_text(const Real& value);

}  // namespace elgen
