// Traits: what each expression is made of, and its degree in the rates and inputs, judged by
// structure.
#pragma once

#include <cstdint>
#include <vector>

#include "check/names/context.hpp"

namespace elgen {

/// Degrees count up to `not_polynomial`, which stands for anything above 2 as well.
inline constexpr std::uint8_t not_polynomial = 3;

struct Traits {
  Ingredients ingredients = 0;
  std::uint8_t rate_degree = 0;
  std::uint8_t lowest_rate_degree = 0;  ///< every term has at least this one
  std::uint8_t input_degree = 0;
  bool input_times_rate = false;  ///< an input has a coefficient that depends on rates
};

/// Traits of every expression of a model without cycles.
///
///     m*dot(x)^2 + u*cos(x)   ->   parameter, rate, input, coordinate; rate degree 2, input degree
///     1
[[nodiscard]] std::vector<Traits> find_traits(const Model& model);

}  // namespace elgen
