// Reads the equations that elgen shows, and evaluates them in 80 digits.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "random/truth.hpp"

namespace elgen::random {

/// A value, and the sum of the absolute terms that make it: what its rounding is measured by.
struct Sized {
  Number value;
  Number size;
};

using Names = std::map<std::string, Sized>;

/// Throws std::runtime_error where the text is no expression or names what is unknown.
[[nodiscard]] Sized read_expression(const std::string& text, const Names& names);

/// The names of the numbers of a state and of the parameters in the shown equations.
[[nodiscard]] Names names_of(const System& system, const Layout& layout, const State& state,
                             const ParameterValues& parameters);

/// An output as shown, or a field of it; entries row by row.
struct ShownOutput {
  std::vector<Sized> entries;
  std::size_t columns = 1;
};
using Shown = std::map<std::string, ShownOutput>;

/// Entries of every output of a NAME.equations.json, by "output" or "output.field". An entry that
/// has no value at this state (a root of what is negative) ends the output with std::domain_error.
[[nodiscard]] Shown read_equations(const std::string& json, const Names& names);

}  // namespace elgen::random
