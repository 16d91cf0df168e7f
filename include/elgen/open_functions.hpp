// Open functions: functions f(x_1, ..., x_n) without an expression; a model declares only their
// arguments. The numbers
//
//     f,  df/dx_i,  d2f/dx_i dx_j  (i <= j)      for V(x_1, x_2): V, V_1, V_2, V_11, V_12, V_22
//
// at the current arguments, called open values, are leaves. The caller of emitted code computes
// them and passes them as the argument `f`, in this order, function after function.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/source_text.hpp"
#include "elgen/units.hpp"

namespace elgen {

/// A [[function]] for which the scene has no expression.
struct OpenFunction {
  std::string name;
  std::string identifier;
  std::vector<std::uint32_t> arguments = {};  ///< indices in Model::expressions; at least one
  std::optional<Unit> unit = {};              ///< unit of the values; none: not checked
  std::string unit_text = {};                 ///< unit as written in the file
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

inline constexpr std::size_t max_open_arguments = 4;  ///< most arguments of an open function

/// A value of an open function: the function, or one of its derivatives.
struct OpenValue {
  std::string name;  ///< "V", "V_1", "V_12"
  std::string identifier;
  std::uint32_t function = 0;  ///< index in Model::functions
  /// Indices of the arguments of the derivatives, ascending: {0, 1} for V_12, {} for V.
  std::vector<std::uint32_t> derivative_arguments = {};
  std::optional<Unit> unit = {};  ///< none: the unit is unknown
  std::string unit_text = {};
};

struct Model;

/// The index in model.open_values of the derivative of open value `value` by the argument with
/// index `argument` of the function; none beyond second order.
[[nodiscard]] std::optional<std::uint32_t> find_open_derivative(const Model& model,
                                                                std::uint32_t value,
                                                                std::uint32_t argument);

/// The index in model.open_values of the derivative of `function` by the arguments with the indices
/// `by`, in any order. `by` empty: the function itself. None beyond second order.
[[nodiscard]] std::optional<std::uint32_t> find_open_value(const Model& model,
                                                           std::uint32_t function,
                                                           std::vector<std::uint32_t> by);

}  // namespace elgen
