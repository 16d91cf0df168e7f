// Closed forms that follow from a model's own energies, and false forms that differ in a constant.
#pragma once

#include <optional>
#include <vector>

#include "random/draw.hpp"
#include "random/model.hpp"

namespace elgen::test::random {

/// The symbolic derivative of `expression` with respect to `by`, a coordinate x or a rate dot(x).
[[nodiscard]] Expression derivative(const Expression& expression, const Expression& by);

/// Mass matrix, gravity and potential energy of a model with only [energy] T and V. Empty for other
/// models.
[[nodiscard]] std::vector<Claim> true_claims(const Model& model);

/// The claims with one entry falsified: a flipped sign between constants, or cos(1)/1000 added.
[[nodiscard]] std::vector<Claim> falsified(std::vector<Claim> claims, Draw& draw);

}  // namespace elgen::test::random
