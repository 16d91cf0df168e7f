// Traits: the ingredients (leaves and functions) of each expression, and its degree in the rates
// and inputs, found from its structure.
#pragma once

#include <cstdint>
#include <vector>

#include "check/names/context.hpp"

namespace elgen {

/// Degrees saturate at `not_polynomial`, which also covers every degree above 2.
inline constexpr std::uint8_t not_polynomial = 3;

struct ExpressionTraits {
  Ingredients ingredients = 0;
  std::uint8_t rate_degree = 0;
  std::uint8_t lowest_rate_degree = 0;  ///< the smallest degree of all terms
  std::uint8_t input_degree = 0;
  bool input_times_rate = false;  ///< the coefficient of an input depends on rates
};

/// Traits of every expression of a model without cycles.
///
///     m*dot(x)^2 + u*cos(x)   ->   parameter, rate, input, coordinate;
///                                  rate degree 2, input degree 1
[[nodiscard]] std::vector<ExpressionTraits> find_traits(const Model& model);

}  // namespace elgen
