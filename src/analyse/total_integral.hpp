// Total integral: the function of coordinates and time with a given rate.
#pragma once

#include <optional>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// F(q, t) whose total derivative, sum dF/dq dq/dt + dF/dt at fixed q, is proved to be `rate`.
/// `rates` is dq/dt of all coordinates, or empty if dq/dt = v. Terms x^n and x^n e^(c x) are
/// integrated, with x a coordinate or t. None for other terms, or if `rate` is not a total
/// derivative.
[[nodiscard]] std::optional<Fraction> integrate_total_derivative(ClosedForms& forms,
                                                                 const Model& model,
                                                                 const std::vector<Fraction>& rates,
                                                                 const OpenValueRates& open_values,
                                                                 const Fraction& rate);

}  // namespace elgen
