// Frequencies: w^2 of M x'' + K x = 0 by formulas, for coordinates that are coupled at most in
// pairs.
//
//     one       K/M
//     two       (b -+ sqrt(b^2 - 4 a c))/(2 a),   det(K - x M) = a x^2 - b x + c
#pragma once

#include "analyse/page.hpp"

namespace elgen {

/// A line for each block of one or two coordinates; M and K are n x n, row-major, over the algebra
/// of `forms`, which grows.
[[nodiscard]] PagePart frequency_formulas(const Model& model, ClosedForms& forms,
                                          const std::vector<Fraction>& mass,
                                          const std::vector<Fraction>& stiffness);

}  // namespace elgen
