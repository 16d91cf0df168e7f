// Total integral: the function of coordinates and time with a given rate.
#pragma once

#include <optional>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// F(q, t) with dF/dt = sum dF/dq dq/dt + dF/dt = `rate`, proved; 0 if the rate is 0. `rates` has
/// dq/dt of all coordinates, empty if it is v. Terms x^n and x^n e^(c x) are integrated by each
/// variable. None for other terms, or if `rate` is no total derivative.
[[nodiscard]] std::optional<Fraction> total_integral(ClosedForms& forms, const Model& model,
                                                     const std::vector<Fraction>& rates,
                                                     const OpenTerms& open_values,
                                                     const Fraction& rate);

}  // namespace elgen
