// Errors of outputs that solve with a singular matrix: M (E501) or another matrix. The stage
// inspect reports them if the matrix is singular at all samples, derive if a pivot is 0, and lower
// if it finds a division by 0.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

#include "base/reason.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The error if M_ii is 0 for the velocity of this name, so that M is not positive definite.
[[nodiscard]] inline Diagnostic no_kinetic_energy_error(const OutputRequest& request,
                                                        const std::string& velocity) {
  return {Code::E501, request.span,
          fmt::format("`{}` has no value: the rate of `{}` alone has no kinetic energy, whatever "
                      "the state is",
                      request.name, velocity),
          "give it a mass, remove the coordinate, or do not request this output"};
}

/// The error if a pivot of M is 0. `velocity` is the velocity of this pivot; "" if unknown.
[[nodiscard]] inline Diagnostic singular_mass_matrix_error(const OutputRequest& request,
                                                           const std::string& velocity = {}) {
  const std::string at = velocity.empty() ? "" : fmt::format(" (`{}` has no pivot)", velocity);
  return {Code::E501, request.span,
          fmt::format("`{}` has no value: the mass matrix is singular{}, whatever the state is",
                      request.name, at),
          "too many coordinates, or a mass is missing"};
}

/// The error if a pivot of A M^-1 A^T is 0, in the row of this constraint.
[[nodiscard]] inline Diagnostic redundant_constraint_error(const OutputRequest& request,
                                                           const std::string& constraint) {
  return {Code::E537, request.span,
          fmt::format("`{}` has no value: the constraint `{}` follows from earlier constraints, "
                      "whatever the state is",
                      request.name, constraint),
          "remove it: its multiplier is not determined"};
}

/// The error if A_d of `completed` is singular (see SingularFault).
[[nodiscard]] inline Diagnostic undetermined_velocities_error(const OutputRequest& request) {
  return {Reason::independent_velocities, request.span,
          fmt::format("`{}` has no value: the independent velocities do not determine the others",
                      request.name)};
}

/// The error if the pivot of J M^-1 J^T in this row is 0.
[[nodiscard]] inline Diagnostic dependent_task_error(const OutputRequest& request,
                                                     std::size_t row) {
  return {Reason::dependent_task, request.span,
          fmt::format("`{}` has no value: row {} of the Jacobian follows from earlier rows, "
                      "whatever the state is",
                      request.name, row + 1)};
}

/// The error if B^T G B is singular, because the system has fewer degrees of freedom than inputs.
[[nodiscard]] inline Diagnostic redundant_inputs_error(const OutputRequest& request) {
  return {Reason::undetermined_inputs, request.span,
          fmt::format("`{}` has no value: under the constraints some input moves nothing, or "
                      "only what other inputs move",
                      request.name)};
}

/// The error if a pivot of B^T G B is 0, in the row of this input.
[[nodiscard]] inline Diagnostic redundant_input_error(const OutputRequest& request,
                                                      const std::string& input) {
  return {Reason::undetermined_inputs, request.span,
          fmt::format("`{}` has no value: the input `{}` moves only what earlier inputs move, "
                      "whatever the state is",
                      request.name, input)};
}

/// The error for an output that solves with a matrix other than M, if this matrix is singular. The
/// stage derive passes the row of the zero pivot, and always gets an error. The stage lower passes
/// no row; if lower gets no error, the singular matrix is M.
[[nodiscard]] inline std::optional<Diagnostic> singular_system_error(
    const OutputRequest& request, const std::optional<std::size_t>& row, const LeafNames& names) {
  switch (output_row(request.kind).singular_fault) {
    case SingularFault::undetermined_rest:
      return undetermined_velocities_error(request);
    case SingularFault::dependent_task:
      if (row) return dependent_task_error(request, *row);
      break;
    case SingularFault::redundant_inputs:
      if (!row) return redundant_inputs_error(request);
      // If a row is known, the matrix is A M^-1 A^T, which is factorised before B^T G B.
      return redundant_constraint_error(request, names.multipliers[*row]);
    case SingularFault::redundant_constraint:
      if (row) return redundant_constraint_error(request, names.multipliers[*row]);
      break;
  }
  return std::nullopt;
}

}  // namespace elgen
