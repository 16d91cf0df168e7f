// Substitution: a closed form with values in the place of some leaves.
//
//     m R (g cos(theta) - R W^2 cos(2 theta))   at theta = pi   ->   -m R (g + R W^2)
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "elgen/analyse.hpp"
#include "forms/present/arithmetic.hpp"

namespace elgen {

/// The value that takes the place of a leaf. The cosine and sine of an angle such as acos(c) keep
/// its cosine and sine free of functions of functions.
struct Replacement {
  Fraction value = {};
  std::optional<CosineAndSine> sinusoids = {};
};
/// By kind and number.
using Replacements = std::map<std::pair<Opcode, std::uint32_t>, Replacement>;

/// The form with these values; none of none, where it has no value there (a denominator becomes 0),
/// and beyond the budget.
[[nodiscard]] Value substituted(Algebra& algebra, const Value& form,
                                const Replacements& replacements);

/// x + i y over real x, y.
[[nodiscard]] Value complex_form(Arithmetic& arithmetic, const Value& x, const Value& y);

/// All parameters at their values; none where one of them is no rational number.
[[nodiscard]] std::optional<Replacements> parameter_values(const std::vector<cln::cl_R>& values);

}  // namespace elgen
