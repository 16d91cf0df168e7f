// Reads the equations that elgen shows, and evaluates them in 80 digits.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "random/truth.hpp"

namespace elgen::test::random {

/// A value and the sum of the magnitudes of its terms, which scales the rounding error.
struct ScaledValue {
  Number value;
  Number size;
};

using Names = std::map<std::string, ScaledValue>;

/// The value of `text`. Throws std::runtime_error for a syntax error or an unknown name.
[[nodiscard]] ScaledValue read_expression(const std::string& text, const Names& names);

/// The values of the names in shown equations: the numbers of `state` and of `parameters`.
[[nodiscard]] Names names_of(const System& system, const Layout& layout, const State& state,
                             const ParameterValues& parameters);

/// A shown output or one of its fields; entries row by row.
struct ShownOutput {
  std::vector<ScaledValue> entries;
  std::size_t columns = 1;
};
using Shown = std::map<std::string, ShownOutput>;

/// The entries of every output in a NAME.equations.json, by "output" or "output.field". Throws
/// std::domain_error if an entry has no value at this state, such as the root of a negative number.
[[nodiscard]] Shown read_equations(const std::string& json, const Names& names);

}  // namespace elgen::test::random
