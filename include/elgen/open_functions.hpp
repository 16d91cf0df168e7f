// Open functions: f(x_1, ..., x_n) of which a model knows the arguments only. The numbers
//
//     f,  df/dx_i,  d2f/dx_i dx_j  (i <= j)      V, V_1, V_2, V_11, V_12, V_22 of two arguments
//
// at the present arguments are leaves: whoever calls emitted code computes them. This order is that
// of the argument `f`, function after function.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/source_text.hpp"
#include "elgen/units.hpp"

namespace elgen {

/// A [[function]] that nothing closes.
struct OpenFunction {
  std::string name;
  std::string identifier;
  std::vector<std::uint32_t> arguments = {};  ///< in Model::expressions; at least one
  std::optional<Unit> unit = {};              ///< none: not checked
  std::string unit_text = {};                 ///< as written
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

inline constexpr std::size_t most_arguments = 4;  ///< of an open function

/// A derivative of an open function, or its value.
struct OpenValue {
  std::string name;  ///< "V", "V_1", "V_12"
  std::string identifier;
  std::uint32_t function = 0;          ///< in Model::functions
  std::vector<std::uint32_t> by = {};  ///< the arguments it is differentiated by, ascending
  std::optional<Unit> unit = {};       ///< none: not known
  std::string unit_text = {};
};

struct Model;

/// The number of the derivative of an open value by one more argument of its function; none beyond
/// the second order.
[[nodiscard]] std::optional<std::uint32_t> derivative_of(const Model& model, std::uint32_t value,
                                                         std::uint32_t argument);

/// The number of the value of a function that is differentiated by these arguments.
[[nodiscard]] std::optional<std::uint32_t> open_value(const Model& model, std::uint32_t function,
                                                      std::vector<std::uint32_t> by);

}  // namespace elgen
