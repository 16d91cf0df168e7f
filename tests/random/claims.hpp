// Closed forms that are true of a model by its own energies, and false ones that differ in a
// constant.
#pragma once

#include <optional>
#include <vector>

#include "random/draw.hpp"
#include "random/model.hpp"

namespace elgen::random {

/// dE/dx of an expression, by the rules of calculus alone; x is a coordinate, or its rate as
/// dot(x).
[[nodiscard]] Expression derivative(const Expression& expression, const Expression& by);

/// Mass matrix, gravity and kinetic energy of a model that is all in [energy] T and V; else none.
[[nodiscard]] std::vector<Claim> true_claims(const Model& model);

/// One of the claims with a sign between constants turned, or a constant a thousandth off.
[[nodiscard]] std::vector<Claim> falsified(std::vector<Claim> claims, Draw& draw);

}  // namespace elgen::random
