// Frequencies: M and K at a point of rest in closed form, and w^2 of M x'' + K x = 0 for blocks of
// one or two coordinates.
//
//     one       K/M
//     two       (b -+ sqrt(b^2 - 4 a c))/(2 a),   det(K - x M) = a x^2 - b x + c
#pragma once

#include <optional>
#include <vector>

#include "elgen/analyse.hpp"

namespace elgen {

/// n x n, row-major; empty if an entry has no closed form.
struct FormsAtRest {
  std::vector<Fraction> mass = {};
  std::vector<Fraction> stiffness = {};
};

/// The forms over the algebra of `forms`, those of equilibria, which grows.
[[nodiscard]] FormsAtRest forms_at_rest(const Model& model, ClosedForms& forms,
                                        const RestPoint& point);

/// w^2 = middle, or factor (middle -+ root)/divisor.
struct SquaredFrequency {
  Fraction middle = {};
  std::optional<Fraction> root = {};
  Fraction factor = {};
  Fraction divisor = {};
};

/// One for each block of one or two of `size` coordinates, two if the radicand is a square; empty
/// if M or K is unknown.
[[nodiscard]] std::vector<SquaredFrequency> squared_frequencies(ClosedForms& forms,
                                                                const FormsAtRest& at_rest,
                                                                std::size_t size);

}  // namespace elgen
