// Function slopes: the derivatives of function_derivatives.def over any arithmetic.
#pragma once

#include <array>

#include "elgen/functions.hpp"

namespace elgen {

/// The derivatives of a function by its first and its second argument. `f` is its value at (x, y).
/// An Operand has + - * /, products with an int, sqrt(x), and called(FunctionId, x, y).
template <class Operand>
[[nodiscard]] std::array<Operand, 2> function_slopes(FunctionId function, const Operand& x,
                                                     const Operand& y, const Operand& f,
                                                     const Operand& one) {
  const auto sin = [](const Operand& of) { return called(FunctionId::sin, of, of); };
  const auto cos = [](const Operand& of) { return called(FunctionId::cos, of, of); };
  const auto sinh = [](const Operand& of) { return called(FunctionId::sinh, of, of); };
  const auto cosh = [](const Operand& of) { return called(FunctionId::cosh, of, of); };
  const auto exp = [](const Operand& of) { return called(FunctionId::exp, of, of); };
  const auto stumpff = [](const Operand& of, const Operand& k) {
    return called(FunctionId::stumpff, of, k);
  };
  switch (function) {
#define ELGEN_DERIVATIVES(name, arity, first, second) \
  case FunctionId::name:                              \
    return {first, second};
#include "base/function_derivatives.def"
#undef ELGEN_DERIVATIVES
  }
  return {one * 0, one * 0};
}

}  // namespace elgen
