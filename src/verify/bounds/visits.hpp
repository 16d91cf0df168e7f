// Visits to all states, by this process or shared out among several: the findings are the same, in
// the order of the states.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// Each process takes the next state that none has taken. Where one of them fails, this process
/// visits all states alone; where one uses up its processor time, this process gets SIGXCPU.
/// Scalar: double or float.
template <class Scalar>
void visit_all(const Subject& subject, const std::vector<SampledState<Scalar>>& states,
               const AccuracyOptions& options, const TakeFindings& take);

}  // namespace elgen
