// Accuracy: a program's values in double and float against the 60-digit oracle, at all states.
// Wrong values fail; the digits lost to rounding are a figure.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/certificate.hpp"
#include "verify/bounds/visit.hpp"

namespace elgen {

/// Options of the visits to all states.
struct AccuracyOptions {
  VisitOptions visit = {};
  /// Called with a text at each step: "accuracy in double, state 3 of 36".
  std::function<void(const std::string&)> on_step = {};
  std::size_t jobs = 1;  ///< processes
};

/// Findings at one state, in the order of field_places; none for a field that skips this state.
using Findings = std::vector<std::optional<Finding>>;

/// Receives the index of a state and its findings.
using FindingsHandler = std::function<void(std::size_t at, const Findings& findings)>;

/// Visits all states in this process, or shared by several processes. Findings and their order are
/// the same. Each process visits the next free state. If a process fails, this process visits all
/// states alone. If a process exceeds its processor time, this process raises SIGXCPU. Scalar:
/// double or float.
template <class Scalar>
void visit_all(const Subject& subject, const std::vector<SampledState<Scalar>>& states,
               const AccuracyOptions& options, const FindingsHandler& take);

/// One row per output and field. One row for the code as users compile it, if given. One row per
/// output for its lost digits, if options.visit.losing asks for it. A state fails in four cases:
/// the program's exact value is not the oracle's (to 50 digits of E + |x*|); at a nominal state it
/// is undefined although the oracle has a value; the rounded value is not finite; the code of users
/// differs from the program by more than most_of_users.
template <class Scalar>
[[nodiscard]] std::vector<CertificateRow> check_accuracy(
    const Subject& subject, const std::vector<SampledState<Scalar>>& states,
    const AccuracyOptions& options = {});

}  // namespace elgen
