// Accuracy: a program's values in double and float against the 60-digit oracle, at all states.
// Wrong values fail; the digits that rounding takes are a figure.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/certificate.hpp"
#include "verify/bounds/visit.hpp"

namespace elgen {

/// How all states are visited.
struct AccuracyOptions {
  VisitOptions visit = {};
  /// Told of each step: "accuracy in double, state 3 of 36".
  std::function<void(const std::string&)> on_step = {};
  std::size_t jobs = 1;  ///< processes
};

/// Findings at one state, in the order of field_places; none for fields that are not due there.
using Findings = std::vector<std::optional<Finding>>;

/// Gets the number of a state and what it says.
using TakeFindings = std::function<void(std::size_t at, const Findings& findings)>;

/// Visits all states, by this process or shared out among several: the findings are the same, in
/// the order of the states. Each process takes the next state that none has taken. Where one of
/// them fails, this process visits all states alone; where one uses up its processor time, this
/// process gets SIGXCPU. Scalar: double or float.
template <class Scalar>
void visit_all(const Subject& subject, const std::vector<SampledState<Scalar>>& states,
               const AccuracyOptions& options, const TakeFindings& take);

/// One row per output and field, one of the code as users compile it where there is such code, and
/// one per output of the digits that it loses where options.visit.losing says so. A state fails
/// where the exact value of the program is not the oracle's (to 50 digits of E + |x*|) or, at a
/// nominal state, is undefined where the oracle has one, where the rounded value is no finite
/// number, and where the code of users is further from the program than most_of_users allows.
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_accuracy(
    const Subject& subject, const std::vector<SampledState<Scalar>>& states,
    const AccuracyOptions& options = {});

}  // namespace elgen
