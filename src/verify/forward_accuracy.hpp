// Accuracy of accelerations by the condition of the mass matrix, where bounds run along an
// elimination say little.
#pragma once

#include <optional>
#include <vector>

#include "elgen/certificate.hpp"
#include "states.hpp"

namespace elgen {

/// With D = diag(M), S = D^-1/2 M D^-1/2, n coordinates, B_M and B_r the own bounds of M and of B u
/// - bias:
///
///     |D^1/2 (a - a*)| <= u cond(S) ((64 n + 8 |D^-1/2 B_M D^-1/2|_F) |D^1/2 a*| + 8 |D^-1/2 B_r|)
///
/// None unless the program has forward_dynamics, mass_matrix and bias, and input_matrix where the
/// model has inputs.
template <class Scalar>
[[nodiscard]] std::optional<CertificateRow> check_forward_accuracy(
    const Subject& subject, const std::vector<SampledState<Scalar>>& states);

}  // namespace elgen
