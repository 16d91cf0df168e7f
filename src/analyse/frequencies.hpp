// Frequencies: closed forms of M and K at an equilibrium, and of w^2 of M x'' + K x = 0 for blocks
// of one or two coordinates.
//
//     one       K/M
//     two       (b -+ sqrt(b^2 - 4 a c))/(2 a),   det(K - x M) = a x^2 - b x + c
#pragma once

#include <optional>
#include <vector>

#include "elgen/analyse.hpp"

namespace elgen {

/// M and K, n x n, row-major. A matrix is empty if one of its entries has no closed form.
struct RestMatrices {
  std::vector<Fraction> mass = {};
  std::vector<Fraction> stiffness = {};
};

/// M and K at a point. Adds atoms to the algebra of `forms`, the closed forms of the equilibria.
[[nodiscard]] RestMatrices rest_matrices(const Model& model, ClosedForms& forms,
                                         const RestPoint& point);

/// w^2 = middle, or if `root` is set, two values w^2 = factor (middle -+ root)/divisor.
struct SquaredFrequency {
  Fraction middle = {};
  std::optional<Fraction> root = {};
  Fraction factor = {};
  Fraction divisor = {};
};

/// w^2 of each block with one or two of the `size` coordinates. A block of two coordinates has two
/// entries without a root if b^2 - 4 a c is a non-zero square. Empty if M or K has no closed form.
[[nodiscard]] std::vector<SquaredFrequency> squared_frequencies(ClosedForms& forms,
                                                                const RestMatrices& at_rest,
                                                                std::size_t size);

}  // namespace elgen
