// Total integral: the function of coordinates and time of which a form is the rate.
#pragma once

#include <optional>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// F(q, t) with dF/dt = sum dF/dq dq/dt + dF/dt = `rate`, proved; 0 where the rate is. `rates`:
/// dq/dt of every coordinate, empty where it is v. Integrated term by term: x^n and x^n e^(c x) by
/// each of its variables. None of other terms, and where `rate` is no total derivative.
[[nodiscard]] std::optional<Fraction> total_integral(ClosedForms& forms, const Model& model,
                                                     const std::vector<Fraction>& rates,
                                                     const OpenTerms& open_values,
                                                     const Fraction& rate);

}  // namespace elgen
