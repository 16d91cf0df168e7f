// cpp_constant: an exact number -> the C++ expression that constructs it in any scalar type.
//
//     1/2     constant<Scalar>(0.5)                                exact in every type
//     9.81    constant<Scalar>(9.81F, 9.81, 9.81L, {981}, {100})   nearest values; 981/100
//     1e-300  constant<Scalar>(detail::OutOfRange{}, 1e-300, 1e-300L, {1}, {1}, -300)
#pragma once

#include <cln/real.h>

#include <string>
#include <string_view>

#include "elgen/program.hpp"

namespace elgen {

/// The expression for |value| in type `scalar`; the sign is an operator of the equation.
[[nodiscard]] std::string cpp_magnitude(const cln::cl_R& value, std::string_view scalar = "Scalar");

/// The expression for the value, with its sign.
[[nodiscard]] std::string cpp_constant(const cln::cl_R& value);

/// True if float holds |value| exactly, so that its expression is short enough for an equation.
[[nodiscard]] bool is_short_constant(const cln::cl_R& value);

/// The name of the function that returns a long constant: "number_9p81", "number_1_3", "number_pi".
/// The name is "number_" and a hash if the text of the constant is longer than 40 characters, or
/// contains a sum or a function other than sqrt.
[[nodiscard]] std::string constant_name(const Constant& constant);

}  // namespace elgen
