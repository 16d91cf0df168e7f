// Accuracy: compares a program's values in double and float with the 60-digit oracle, at all
// states. Wrong values fail; digits lost to rounding are only reported.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/certificate.hpp"
#include "verify/bounds/visit.hpp"

namespace elgen {

/// The options of check_states() and check_accuracy().
struct AccuracyOptions {
  StateCheckOptions check_options = {};
  /// Called at each step with a text such as "accuracy in double, state 3 of 36".
  std::function<void(const std::string&)> on_step = {};
  std::size_t jobs = 1;  ///< number of processes
};

/// Findings at one state, in the order of field_places(); none if the field is not compared at this
/// state.
using Findings = std::vector<std::optional<Finding>>;

/// Receives the index of a state and its findings.
using FindingsHandler = std::function<void(std::size_t at, const Findings& findings)>;

/// Visits all states, in the calling process or in `jobs` child processes. The findings and their
/// order do not depend on `jobs`. Each child takes the next state that no child has taken. If a
/// child fails, the calling process visits all states by itself. If a child exceeds its processor
/// time, the calling process raises SIGXCPU. Scalar: double or float.
template <class Scalar>
void check_states(const SystemUnderTest& subject, const std::vector<SampledState<Scalar>>& states,
                  const AccuracyOptions& options, const FindingsHandler& take);

/// One row per field of each output; one row for code as users compile it, and one for code in a
/// wider scalar, if `options.check_options` has such code; one row per output for its lost digits,
/// if they are measured at some state. A row fails at a state in four cases:
///     the exact value differs from the oracle's by more than agrees_with_oracle() permits
///     the state is nominal, and the exact value is undefined although the oracle has a value
///     the rounded value is not finite
///     the error of compiled code exceeds max_user_code_error or max_wide_code_error
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_accuracy(
    const SystemUnderTest& subject, const std::vector<SampledState<Scalar>>& states,
    const AccuracyOptions& options = {});

}  // namespace elgen
