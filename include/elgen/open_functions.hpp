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
  std::vector<std::uint32_t> arguments = {};  ///< in Model::expressions; at least one
  std::optional<Unit> unit = {};              ///< none: not checked
  std::string unit_text = {};                 ///< as in the file
  std::string latex = {};
  std::string doc = {};
  Span span = {};
};

inline constexpr std::size_t max_open_arguments = 4;  ///< largest number of arguments

/// A value of an open function: the function, or one of its derivatives.
struct OpenValue {
  std::string name;  ///< "V", "V_1", "V_12"
  std::string identifier;
  std::uint32_t function = 0;  ///< in Model::functions
  /// Numbers of the arguments by which f is differentiated, ascending; empty: f itself.
  std::vector<std::uint32_t> derivative_arguments = {};
  std::optional<Unit> unit = {};  ///< none: unknown
  std::string unit_text = {};
};

struct Model;

/// The number of the open value that is the derivative of `value` by argument number `argument` of
/// the function; none beyond second order.
[[nodiscard]] std::optional<std::uint32_t> find_open_derivative(const Model& model,
                                                                std::uint32_t value,
                                                                std::uint32_t argument);

/// The number of the open value that is the derivative of `function` by the arguments `by`, in any
/// order; none beyond second order.
[[nodiscard]] std::optional<std::uint32_t> find_open_value(const Model& model,
                                                           std::uint32_t function,
                                                           std::vector<std::uint32_t> by);

}  // namespace elgen
